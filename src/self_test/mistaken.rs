//! References that are another motion than that of the scene.

use nalgebra::Vector3;

use super::planted::{FREE, Plant, Row};
use crate::model::Snapshot;
use crate::reference::Reference;

/// References that are another motion.
pub(super) const REFERENCES: &[Row] = &[
    (
        "reference with its rotations transposed",
        Plant::Reference(|r| states(r, |s| s.orientation = s.orientation.inverse())),
        FREE,
    ),
    ("reference of another end time", Plant::Reference(shifted_samples), FREE),
    (
        "reference with angular velocities in body axes",
        Plant::Reference(|r| {
            states(r, |s| s.angular_velocity = s.orientation.inverse_transform_vector(&s.angular_velocity))
        }),
        FREE,
    ),
    (
        "reference good to six digits, told as exact",
        Plant::Reference(|r| states(r, |s| s.angular_momentum *= 1.0 + 1e-6)),
        FREE,
    ),
    (
        "reference without its motion of the centre",
        Plant::Reference(|r| states(r, |s| s.position = Vector3::zeros())),
        &["tether-springs"],
    ),
    ("last sample of the reference left out", Plant::Reference(last_twice), FREE),
];

fn states(reference: &mut Reference, change: fn(&mut Snapshot)) {
    reference.states.iter_mut().for_each(change);
}

/// Every sample is the next one's.
fn shifted_samples(reference: &mut Reference) {
    let times: Vec<f64> = reference.times.clone();
    reference.states.rotate_left(1);
    for (state, time) in reference.states.iter_mut().zip(times) {
        state.time = time;
    }
}

fn last_twice(reference: &mut Reference) {
    if let [.., before, last] = &mut reference.states[..] {
        *last = Snapshot { time: last.time, ..*before };
    }
}
