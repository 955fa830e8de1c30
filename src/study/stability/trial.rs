//! One run at one step, held against the truth: whether it stays bounded, keeps its energy and its orientation, and how it fails.

use nalgebra::Vector3;

use super::failure::Failure;
use super::truth::{self, Truth};
use crate::measure::FlipFinder;
use crate::model::Snapshot;
use crate::model::body::Shape;
use crate::record::stability::Meaning;
use crate::rotation;
use crate::simulate::{Contestant, Form, Outcome, Plan};

/// Change of the energy, over its scale, up to which it is kept.
pub const ENERGY_KEPT: f64 = 0.01;
/// Angle from the truth up to which the orientation is kept [rad].
pub const ORIENTATION_KEPT: f64 = 0.1;
/// Energy over its scale up to which a run is bounded.
pub const BOUNDED: f64 = 10.0;
/// Change of a length, relative, up to which a body is rigid.
const RIGID: f64 = 1e-6;
/// Steps that a run has at least, so that an unstable mode shows: runs go on past the scene's end for them.
const FEWEST_STEPS: u64 = 400;
/// States looked at in a run.
const SAMPLES: u64 = 128;
/// Part of the time between flips by which a flip may be off.
const FLIP_OFF: f64 = 0.25;

/// What came of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Whether the run is usable, in the order of [`Meaning::ALL`].
    pub usable: [bool; 3],
    /// How it fails; `None` where all three hold.
    pub failure: Option<Failure>,
    /// Why the scheme cannot take the scene, where that showed only now.
    pub refusal: Option<String>,
}

impl Trial {
    /// Whether the run is usable in this sense.
    pub fn is_usable(&self, meaning: Meaning) -> bool {
        self.usable[meaning as usize]
    }
}

/// Looks at the states of a run as they come.
struct Watch<'a> {
    truth: &'a Truth,
    /// Largest |E − E_true| over the scale, within the scene.
    energy_off: f64,
    /// Largest (E − E₀) over the scale, over the whole run.
    energy_above: f64,
    /// Last energy change over the scale, against the truth within the scene and against the start after it.
    last_change: f64,
    angle_off: f64,
    last_angle: f64,
    stretch: f64,
    flips: Option<FlipFinder>,
    /// Smallest parts of L along the principal axes in the last quarter.
    settled: Vector3<f64>,
    last_speed: f64,
    largest_speed: f64,
    end: f64,
    finite: bool,
}

impl<'a> Watch<'a> {
    fn new(truth: &'a Truth, end: f64) -> Watch<'a> {
        Watch {
            truth,
            energy_off: 0.0,
            energy_above: 0.0,
            last_change: 0.0,
            angle_off: 0.0,
            last_angle: 0.0,
            stretch: 0.0,
            flips: truth.tumbling.map(FlipFinder::new),
            settled: Vector3::repeat(1.0),
            last_speed: 0.0,
            largest_speed: 0.0,
            end,
            finite: true,
        }
    }

    fn see(&mut self, state: &Snapshot) {
        let truth = self.truth;
        let energy = truth.energy(state);
        self.finite &= energy.is_finite() && state.stretch.is_finite();
        let change = (energy - truth.first_energy()) / truth.scale;
        self.energy_above = self.energy_above.max(change);
        self.stretch = self.stretch.max(state.stretch);
        self.last_change = change;
        let speed =
            state.velocity.norm() + rotation::length(&state.angular_velocity) * truth.system.body.extent();
        self.last_speed = speed;
        self.largest_speed = self.largest_speed.max(speed);
        if state.time >= 0.75 * self.end {
            self.settled = self.settled.inf(&truth::axis_parts(&truth.system, state));
        }
        if state.time <= truth.duration * (1.0 + 1e-9) {
            let (orientation, true_energy) = truth.at(state.time);
            let off = (energy - true_energy) / truth.scale;
            self.last_change = off;
            self.energy_off = self.energy_off.max(off.abs());
            self.last_angle = angle(truth, &state.orientation, &orientation);
            self.angle_off = self.angle_off.max(self.last_angle);
            if let Some(flips) = &mut self.flips {
                flips.push(state);
            }
        }
    }

    fn verdict(self, outcome: &Outcome) -> Trial {
        let broken = outcome.broken.as_ref().map(|broken| Failure::of_break(broken.step, &broken.why));
        let broken = broken.or((!self.finite).then_some(Failure::NotFinite { step: outcome.steps }));
        let whole = broken.is_none();
        let rigid = self.stretch <= RIGID;
        // A run may be bounded by its energy and still lose its rigidity: then it is no rigid body that stays bounded.
        let bounded = whole && self.energy_above <= BOUNDED && self.stretch <= 1.0;
        let energy = bounded && rigid && self.energy_off <= ENERGY_KEPT;
        let orientation = bounded && rigid && self.angle_off <= ORIENTATION_KEPT;
        let usable = [bounded, energy, orientation];
        let failure = if usable == [true; 3] {
            None
        } else {
            Some(broken.unwrap_or_else(|| self.classed(outcome, rigid)))
        };
        Trial { usable, failure, refusal: outcome.refusal().map(str::to_owned) }
    }

    /// The first class that applies, the most telling first.
    fn classed(&self, outcome: &Outcome, rigid: bool) -> Failure {
        let truth = self.truth;
        if !rigid {
            return Failure::LosesRigidity { stretch: self.stretch };
        }
        if self.energy_above > BOUNDED {
            return Failure::EnergyGrows { per_step: self.energy_above.ln() / outcome.steps.max(1) as f64 };
        }
        if let Some(axis) = truth::axis_of(&truth.system, &self.settled)
            && truth.settled != Some(axis)
        {
            return Failure::WrongAxis { axis };
        }
        if let Some(failure) = self.flips_off() {
            return failure;
        }
        if truth.at_rest && (self.last_speed > 0.1 * self.largest_speed || self.last_angle > ORIENTATION_KEPT)
        {
            return Failure::WrongEquilibrium { angle: self.last_angle };
        }
        if self.last_change.abs() > ENERGY_KEPT {
            let per_step = self.last_change / outcome.steps.max(1) as f64;
            return if per_step > 0.0 {
                Failure::EnergyGrows { per_step }
            } else {
                Failure::EnergyDecays { per_step: -per_step }
            };
        }
        Failure::OutOfPhase { angle: self.angle_off }
    }

    fn flips_off(&self) -> Option<Failure> {
        let (run, truth) = (&self.flips.as_ref()?.times, &self.truth.flips);
        if run.len() != truth.len() {
            return Some(Failure::WrongFlips { run: run.len(), truth: truth.len(), late: 0.0 });
        }
        let between = self.truth.duration / (truth.len() + 1) as f64;
        let late = run.iter().zip(truth).map(|(a, b)| (a - b).abs() / between).fold(0.0, f64::max);
        (late > FLIP_OFF).then_some(Failure::WrongFlips { run: run.len(), truth: truth.len(), late })
    }
}

/// Angle of the relative rotation [rad]; of the axis for a rod.
fn angle(truth: &Truth, a: &rotation::Rotation, b: &rotation::Rotation) -> f64 {
    match truth.system.body.shape {
        Shape::Point => 0.0,
        Shape::Rod { direction } => rotation::angle_between_directions(&(a * direction), &(b * direction)),
        Shape::Extended => rotation::angle_between(a, b),
    }
}

/// Runs a scheme through a scene in so many steps.
pub fn attempt(contestant: &Contestant, truth: &Truth, steps: u64) -> Trial {
    let step = truth.duration / steps as f64;
    let all = if truth.driven { steps } else { steps.max(FEWEST_STEPS) };
    let plan = Plan { step, steps: all, every: (all / SAMPLES).max(1) };
    let mut watch = Watch::new(truth, all as f64 * step);
    let outcome = contestant.stream(&truth.system, Form::Least, &plan, &mut |state| watch.see(state));
    watch.verdict(&outcome)
}
