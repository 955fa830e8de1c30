//! Energy and angular momentum against time. What the motion conserves is a change from the start; what a torque changes by itself is an error
//! against the reference, and its name ends in `-error`.

use super::rows::Names;
use crate::model::{Snapshot, System};
use crate::record::{Series, TIME_DIGITS, to_digits};
use crate::reference::Reference;
use crate::rotation;

/// Digits of a value: it is drawn, and a curve of 1,000 pixels shows no more.
const DIGITS: usize = 3;
/// Part of the duration by which the times of a state and of the reference may differ.
const SAME_TIME: f64 = 1e-9;

/// A run beside the reference.
pub(super) struct Run<'a> {
    pub(super) system: &'a System,
    pub(super) reference: &'a Reference,
    pub(super) step: f64,
    pub(super) states: &'a [Snapshot],
}

impl Run<'_> {
    /// The series of a run.
    pub(super) fn series(&self, names: &Names) -> Vec<Series> {
        let twins = self.twins();
        let free = self.system.torque_free();
        let quantities = [
            (self.rotational_energy(&twins, free), "rotational-energy", free, "1"),
            (self.total_energy(), "total-energy", true, "1"),
            (self.momentum(&twins, free), "angular-momentum-magnitude", free, "1"),
            (self.direction(&twins, free), "angular-momentum-direction", free, "rad"),
        ];
        let named = quantities.into_iter().filter_map(|(values, name, conserved, unit)| {
            let values =
                values.filter(|values| !values.is_empty() && values.iter().all(|v| v.is_finite()))?;
            Some((values, format!("{name}{}", if conserved { "" } else { "-error" }), unit))
        });
        named.map(|(values, quantity, unit)| self.row(names, quantity, unit, values)).collect()
    }

    fn row(&self, names: &Names, quantity: String, unit: &str, values: Vec<f64>) -> Series {
        Series {
            scene: names.scene.to_owned(),
            scheme: names.scheme.to_owned(),
            step_s: self.step,
            quantity,
            unit: unit.to_owned(),
            time_s: self.states.iter().map(|s| to_digits(s.time, TIME_DIGITS)).collect(),
            value: values.into_iter().map(|value| to_digits(value, DIGITS)).collect(),
        }
    }

    /// The states of the reference at the times of the run; none where it has no such time.
    fn twins(&self) -> Option<Vec<&Snapshot>> {
        let times = &self.reference.times;
        let (end, intervals) = (*times.last()?, times.len() - 1);
        let twin = |state: &Snapshot| {
            let index = (state.time / end * intervals as f64).round() as usize;
            let same = (times.get(index)? - state.time).abs() <= SAME_TIME * end;
            self.reference.states.get(index).filter(|_| same)
        };
        self.states.iter().map(twin).collect()
    }

    /// A quantity less its start, or less that of the reference, over its largest size in the reference.
    fn relative(
        &self,
        twins: &Option<Vec<&Snapshot>>,
        conserved: bool,
        of: impl Fn(&Snapshot) -> f64,
    ) -> Option<Vec<f64>> {
        if conserved {
            let first = of(self.states.first()?);
            return (first > 0.0).then(|| self.states.iter().map(|s| of(s) / first - 1.0).collect());
        }
        let scale = self.reference.states.iter().map(&of).fold(0.0, f64::max);
        let errors = self.states.iter().zip(twins.as_ref()?).map(|(s, twin)| (of(s) - of(twin)) / scale);
        (scale > 0.0).then(|| errors.collect())
    }

    fn rotational_energy(&self, twins: &Option<Vec<&Snapshot>>, free: bool) -> Option<Vec<f64>> {
        self.relative(twins, free, |s| self.system.rotational_energy(s))
    }

    fn momentum(&self, twins: &Option<Vec<&Snapshot>>, free: bool) -> Option<Vec<f64>> {
        self.relative(twins, free, |s| rotation::length(&s.angular_momentum))
    }

    fn direction(&self, twins: &Option<Vec<&Snapshot>>, free: bool) -> Option<Vec<f64>> {
        let first = self.states.first()?;
        if rotation::length(&first.angular_momentum) == 0.0 {
            return None;
        }
        let angle = |s: &Snapshot, other: &Snapshot| {
            rotation::angle_between_directions(&s.angular_momentum, &other.angular_momentum)
        };
        if free {
            return Some(self.states.iter().map(|s| angle(s, first)).collect());
        }
        Some(self.states.iter().zip(twins.as_ref()?).map(|(s, twin)| angle(s, twin)).collect())
    }

    /// Of conservative forces; over the largest kinetic energy.
    fn total_energy(&self) -> Option<Vec<f64>> {
        let forces = &self.system.forces;
        if !forces.conservative() || forces.laws().is_empty() {
            return None;
        }
        let total = |s: &Snapshot| Some(self.system.kinetic_energy(s) + self.system.potential_energy(s)?);
        let first = total(self.states.first()?)?;
        let scale = self.states.iter().map(|s| self.system.kinetic_energy(s)).fold(0.0, f64::max);
        let changes = self.states.iter().map(|s| Some((total(s)? - first) / scale));
        changes.collect::<Option<_>>().filter(|_| scale > 0.0)
    }
}
