//! What gates read.

use super::{Baseline, Control};
use crate::measure::{EnergyDrift, Evidence, Flips, OtherWorld, PointRun, Reversal, Symplecticity};
use crate::model::System;
use crate::record::stability::LinearLimit;
use crate::schemes::Card;

/// Everything that was measured on one scheme in one scene.
pub struct Case<'a> {
    /// Name of the scene.
    pub scene: &'a str,
    /// Why the order gate does not apply, if it does not.
    pub not_for_order: Option<&'a str>,
    /// Body, forces and start.
    pub system: &'a System,
    /// What the scheme says of itself.
    pub card: &'a Card,
    /// The ladder of steps.
    pub evidence: &'a Evidence,
    /// Long runs of a free body.
    pub drift: Option<&'a EnergyDrift>,
    /// The note as written, beside the least model.
    pub points: Option<&'a PointRun>,
    /// Flips of a tumbling body.
    pub flips: Option<&'a Flips>,
    /// A run there and back.
    pub reversal: Option<&'a Reversal>,
    /// The derivative of a step.
    pub symplecticity: Option<&'a Symplecticity>,
    /// The same run in other worlds.
    pub other_worlds: &'a [OtherWorld],
    /// Error constants on record.
    pub baseline: &'a Baseline,
    /// The limit of stability on record, and as it was measured.
    pub step_limit: Option<(&'a LinearLimit, &'a LinearLimit)>,
    /// What the scheme shows in a generic scene, where that was asked for.
    pub control: Option<&'a Control>,
    /// Whether the scene is generic: in such a one an order is exactly the claimed one.
    pub generic: bool,
}

impl<'a> Case<'a> {
    /// A ladder and nothing else.
    pub fn of(
        scene: &'a str,
        system: &'a System,
        card: &'a Card,
        evidence: &'a Evidence,
        baseline: &'a Baseline,
    ) -> Case<'a> {
        Case {
            scene,
            not_for_order: None,
            system,
            card,
            evidence,
            drift: None,
            points: None,
            flips: None,
            reversal: None,
            symplecticity: None,
            other_worlds: &[],
            baseline,
            step_limit: None,
            control: None,
            generic: false,
        }
    }
}
