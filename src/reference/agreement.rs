//! A reference and its uncertainty: what its sources disagree by.
//!
//! The best estimate is that of [`super::best`], replaced by the stored solution at the times that it has. The
//! uncertainty at a time is the largest of
//!
//! 1. that of the best estimate;
//! 2. the difference of the best estimate from the stored solution at the next time that it has;
//! 3. the rounding of the numbers themselves;
//!
//! and at a stored time the third alone.

use nalgebra::Vector3;

use super::ReferenceError;
#[cfg(feature = "solvers")]
use super::best::by_solvers;
use super::best::{Best, gather};
use super::precise::Moment;
use super::sources::{Role, Source};
use super::stored::{Solution, Stored};
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::rotation;

/// Rounding of a result, over its size: a few operations.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Difference from a stored solution, over the size of the quantity, that no solver's error explains.
const OTHER_SYSTEM: f64 = 1e-6;

/// A motion known as well as f64 allows, and how well that is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reference {
    /// j T / samples for j = 0 … samples [s].
    pub times: Vec<f64>,
    /// Best estimate at each time.
    pub states: Vec<Snapshot>,
    /// Uncertainty at each time.
    pub uncertainty: Vec<PerQuantity<f64>>,
    /// What it rests on.
    pub sources: Vec<Source>,
    /// The same to 31 digits, where the series is the best estimate and f64 holds the fraction of the duration.
    pub(crate) moments: Vec<Moment>,
}

impl Reference {
    /// The motion of `system` over `duration` [s] at `samples` + 1 times; `samples` is a multiple of 4, so that the
    /// quarters are among them. `stored` is the stored solution of the same scene.
    ///
    /// # Errors
    /// [`ReferenceError`]: a grid that cannot be, no solver that converges, a stored solution of another system.
    pub fn of(
        system: &System,
        duration: f64,
        samples: usize,
        stored: Option<&Stored>,
    ) -> Result<Reference, ReferenceError> {
        let times = grid(duration, samples)?;
        let best = gather(system, &times, &|state| rounding(system, state))?;
        let mut reference = Reference::of_best(system, times, best);
        if let Some(stored) = stored {
            reference.hold_against(system, stored)?;
        }
        Ok(reference)
    }

    /// The motion as dop853 and tsit45 alone tell it: what is left where no series and no closed form is to be had.
    ///
    /// # Errors
    /// [`ReferenceError`]: a grid that cannot be, no solver that converges.
    #[cfg(feature = "solvers")]
    pub fn of_solvers(system: &System, duration: f64, samples: usize) -> Result<Reference, ReferenceError> {
        let times = grid(duration, samples)?;
        let best = by_solvers(system, &times, &|state| rounding(system, state))?;
        Ok(Reference::of_best(system, times, best))
    }

    fn of_best(system: &System, times: Vec<f64>, best: Best) -> Reference {
        let Best { states, mut uncertainty, sources, moments } = best;
        for (uncertainty, state) in uncertainty.iter_mut().zip(&states) {
            *uncertainty = uncertainty.max(rounding(system, state));
        }
        let samples = times.len() - 1;
        let moments = moments.into_iter().enumerate();
        let moments = moments.filter(|(j, moment)| is_part(moment.time, *j, samples, times[samples]));
        let moments = moments.map(|(_, moment)| moment).collect();
        Reference { times, states, uncertainty, sources, moments }
    }

    /// The same motion at every `every`-th time, for runs of fewer steps than there are times.
    pub fn thinned(&self, every: usize) -> Reference {
        Reference {
            times: self.times.iter().copied().step_by(every).collect(),
            states: self.states.iter().copied().step_by(every).collect(),
            uncertainty: self.uncertainty.iter().copied().step_by(every).collect(),
            sources: self.sources.clone(),
            moments: self.moments.clone(),
        }
    }

    /// The motion at a time, to 31 digits.
    pub(crate) fn moment(&self, time: f64) -> Option<&Moment> {
        self.moments.iter().find(|moment| moment.time == time)
    }

    /// Largest uncertainty over the run.
    pub fn largest_uncertainty(&self) -> PerQuantity<f64> {
        largest(self.uncertainty.iter().copied())
    }

    fn hold_against(&mut self, system: &System, stored: &Stored) -> Result<(), ReferenceError> {
        let (role, differences) = match stored.solution(system)? {
            Solution::Motion(states) => (Role::Exact, self.replace(system, stored, &states)?),
            Solution::Spin(spins) => (Role::Check, self.check_spins(system, stored, &spins)?),
        };
        let mut next = 1;
        for (index, apart) in &differences {
            let end = if role == Role::Exact { *index } else { index + 1 };
            self.widen(next..end, apart);
            next = index + 1;
        }
        if let Some((_, apart)) = differences.last() {
            self.widen(next..self.times.len(), apart);
        }
        let largest = largest(differences.iter().map(|(_, apart)| *apart));
        self.sources.push(Source {
            name: "stored".to_owned(),
            detail: format!(
                "{}, {} digits, agreement {}, {} of {} times used",
                stored.origin,
                stored.digits,
                stored.agreement,
                differences.len(),
                stored.len()
            ),
            role,
            disagreement: (!differences.is_empty()).then_some(largest),
        });
        Ok(())
    }

    fn widen(&mut self, range: std::ops::Range<usize>, apart: &PerQuantity<f64>) {
        for uncertainty in self.uncertainty.get_mut(range).unwrap_or_default() {
            *uncertainty = uncertainty.max(*apart);
        }
    }

    /// Puts the stored states in; returns where, and how far they were from the best estimate.
    fn replace(
        &mut self,
        system: &System,
        stored: &Stored,
        states: &[Snapshot],
    ) -> Result<Vec<(usize, PerQuantity<f64>)>, ReferenceError> {
        let mut differences = Vec::new();
        for state in states {
            let Some(index) = self.index_of(state.time) else { continue };
            let apart = difference(&system.body, &self.states[index], state);
            let rounding = rounding(system, state);
            self.same_system(stored, index, &apart, &rounding)?;
            self.states[index] = Snapshot { time: self.times[index], ..*state };
            self.uncertainty[index] = rounding;
            differences.push((index, apart));
        }
        Ok(differences)
    }

    fn check_spins(
        &self,
        system: &System,
        stored: &Stored,
        spins: &[(f64, Vector3<f64>)],
    ) -> Result<Vec<(usize, PerQuantity<f64>)>, ReferenceError> {
        let mut differences = Vec::new();
        for (time, spin) in spins {
            let Some(index) = self.index_of(*time) else { continue };
            let state = &self.states[index];
            let body_spin = state.orientation.inverse_transform_vector(&state.angular_velocity);
            let mut apart = PerQuantity::all(0.0);
            apart[Quantity::AngularVelocity] = rotation::length(&(body_spin - spin));
            self.same_system(stored, index, &apart, &rounding(system, state))?;
            differences.push((index, apart));
        }
        Ok(differences)
    }

    /// Index of a time, up to its rounding.
    fn index_of(&self, time: f64) -> Option<usize> {
        self.times.iter().position(|t| (t - time).abs() <= ROUNDING * time.abs())
    }

    fn same_system(
        &self,
        stored: &Stored,
        index: usize,
        apart: &PerQuantity<f64>,
        rounding: &PerQuantity<f64>,
    ) -> Result<(), ReferenceError> {
        for (quantity, apart) in *apart {
            let known = 1e3 * self.uncertainty[index][quantity];
            let bound = (rounding[quantity] * (OTHER_SYSTEM / ROUNDING)).max(known);
            if apart > bound {
                return Err(ReferenceError::OtherSystem {
                    scene: stored.scene.clone(),
                    time: self.times[index],
                    quantity: quantity.name(),
                    unit: quantity.unit(),
                    difference: apart,
                    bound,
                });
            }
        }
        Ok(())
    }
}

fn grid(duration: f64, samples: usize) -> Result<Vec<f64>, ReferenceError> {
    if !(duration > 0.0 && duration.is_finite()) || samples == 0 || !samples.is_multiple_of(4) {
        return Err(ReferenceError::Grid { duration, samples });
    }
    Ok((0..=samples).map(|j| j as f64 * duration / samples as f64).collect())
}

/// Whether a time is j/n of the duration to the last bit.
fn is_part(time: f64, j: usize, n: usize, duration: f64) -> bool {
    let part = j as f64 * duration;
    (j as f64).mul_add(duration, -part) == 0.0 && time.mul_add(n as f64, -part) == 0.0
}

/// The largest of each quantity.
fn largest(values: impl Iterator<Item = PerQuantity<f64>>) -> PerQuantity<f64> {
    values.fold(PerQuantity::all(0.0), PerQuantity::max)
}

/// What the rounding of a state makes of each quantity.
fn rounding(system: &System, state: &Snapshot) -> PerQuantity<f64> {
    let spin = rotation::length(&state.angular_velocity);
    let position = rotation::length(&state.position);
    let arm = rotation::length(&system.body.center);
    let sizes = PerQuantity::of(|quantity| match quantity {
        Quantity::Position => position + arm,
        // With a pivot it is Ω × arm, which may be small where both are not.
        Quantity::Velocity => rotation::length(&state.velocity) + spin * arm,
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => spin,
        Quantity::AngularMomentum => rotation::length(&state.angular_momentum),
        Quantity::BodyPoint => position + system.body.extent(),
    });
    sizes.map(|size| ROUNDING * size)
}
