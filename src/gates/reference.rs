//! Whether the sources of a reference agree well enough to judge by.

use crate::model::{PerQuantity, Quantity, System};
use crate::record::{ClaimName, Ruling, Verdict};
use crate::reference::Reference;
use crate::rotation;

/// Uncertainty over the scale of a quantity from which a reference no longer decides anything.
const TOO_UNCERTAIN: f64 = 1e-6;

/// Judges the reference of a scene.
pub fn judge_reference(scene: &str, system: &System, reference: &Reference) -> Verdict {
    let largest = |quantity: Quantity| {
        let over_the_run = reference.uncertainty.iter().map(|u| u[quantity]);
        over_the_run.fold(0.0, |a: f64, b| if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) })
    };
    let extent = system.body.extent();
    let span =
        |value: fn(&crate::model::Snapshot) -> f64| reference.states.iter().map(value).fold(0.0, f64::max);
    let spin = span(|s| rotation::length(&s.angular_velocity));
    let scales = PerQuantity::of(|quantity| match quantity {
        Quantity::Position | Quantity::BodyPoint => span(|s| rotation::length(&s.position)).max(extent),
        Quantity::Velocity => span(|s| rotation::length(&s.velocity)).max(spin * extent),
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => spin,
        Quantity::AngularMomentum => span(|s| rotation::length(&s.angular_momentum)),
    });
    let of_scale = |(quantity, scale): (Quantity, f64)| {
        (quantity, if scale > 0.0 { largest(quantity) / scale } else { 0.0 })
    };
    let worst = scales
        .into_iter()
        .map(of_scale)
        .fold((Quantity::Position, 0.0), |a, b| if b.1 > a.1 || b.1.is_nan() { b } else { a });
    let verdict = if worst.1 <= TOO_UNCERTAIN { Ruling::Pass } else { Ruling::Inconclusive };
    let sources: Vec<&str> = reference.sources.iter().map(|source| source.name.as_str()).collect();
    Verdict {
        scene: scene.to_owned(),
        scheme: "reference".to_owned(),
        claim: ClaimName::ReferencesAgree,
        quantity: worst.0.name().to_owned(),
        verdict,
        measured: worst.1.is_finite().then_some(worst.1),
        low: Some(0.0),
        high: Some(TOO_UNCERTAIN),
        detail: format!(
            "sources {}: largest uncertainty over the run {:.1e} of the scale of {}",
            sources.join(", "),
            worst.1,
            worst.0.name()
        ),
        known_deviation: None,
    }
}
