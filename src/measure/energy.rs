//! Rotational energy by itself, and total energy: under gravity the total is dominated by the error of the
//! translation and hides the rotation.

use super::{Metric, Sight, read, scale};
use crate::model::{Snapshot, System};

/// |½ Ω·L − that of the reference| over the largest of the reference.
pub(super) const ROTATIONAL: Metric = Metric {
    name: "rotational-energy",
    unit: "1",
    what: "error of the rotational energy over the largest of the reference",
    measure: |sight: &Sight| {
        let largest = scale(sight, |s| sight.system.rotational_energy(s))?;
        read(sight, |state, truth| {
            Some((sight.system.rotational_energy(state) - sight.system.rotational_energy(truth)) / largest)
        })
    },
};

/// |E − E_ref| of the sum of kinetic and potential energy, over the span of either in the reference.
pub(super) const TOTAL: Metric = Metric {
    name: "total-energy",
    unit: "1",
    what: "error of the total energy over the largest kinetic energy or span of the potential",
    measure: |sight: &Sight| {
        let first = sight.system.potential_energy(sight.reference.states.first()?)?;
        let largest = scale(sight, |s| {
            let potential = sight.system.potential_energy(s).unwrap_or(first);
            sight.system.kinetic_energy(s).abs().max((potential - first).abs())
        })?;
        read(sight, |state, truth| {
            Some((total(sight.system, state)? - total(sight.system, truth)?) / largest)
        })
    },
};

/// Kinetic and potential energy [J]; `None` where a law has no potential.
fn total(system: &System, snapshot: &Snapshot) -> Option<f64> {
    Some(system.kinetic_energy(snapshot) + system.potential_energy(snapshot)?)
}
