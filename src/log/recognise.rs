//! What the names of a file's columns say together: numbers count from the least of a quantity, and a body lends its name to a place.

use super::columns::{self, Component, Kind, Meaning};
use super::layout::{ANGLES, ROLL, SIGMA, Slot};

/// How Drake begins the names of positions of a floating body. Its angular velocities are in world axes.
const DRAKE: &str = "$world";

/// Fills in what the names say; returns whether they say that angular velocities are in body axes.
pub(super) fn recognise(names: &[&str], slots: &mut [Option<Slot>]) -> bool {
    let lower: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    let rates = ["p", "q", "r"];
    if rates.iter().all(|rate| lower.iter().any(|name| name == rate)) {
        for (name, slot) in lower.iter().zip(slots.iter_mut()) {
            let rate = rates.iter().position(|rate| rate == name);
            *slot = rate.map(|k| Slot { field: 11 + k, unit: None });
        }
    }
    let mut in_body_axes = slots.iter().any(Option::is_some);
    let meanings: Vec<Option<Meaning>> = names.iter().map(|name| columns::meaning(name)).collect();
    for (slot, meaning) in slots.iter_mut().zip(&meanings) {
        let Some(meaning) = meaning else { continue };
        if slot.is_none()
            && let Some(field) = field(meaning, &meanings)
        {
            in_body_axes |= meaning.in_body_axes;
            *slot = Some(Slot { field, unit: meaning.unit });
        }
    }
    for (name, slot) in names.iter().zip(slots.iter_mut()).filter(|(_, slot)| slot.is_none()) {
        *slot = beside_quaternion(name, names).map(|axis| Slot { field: 1 + axis, unit: None });
    }
    in_body_axes && !names.iter().any(|name| name.starts_with(DRAKE))
}

/// The axis of `NAME_x`, of a body of any name, beside `NAME_qw`.
fn beside_quaternion(name: &str, names: &[&str]) -> Option<usize> {
    let (body, axis) = name.rsplit_once('_')?;
    let axis = ["x", "y", "z"].iter().position(|own| *own == axis)?;
    names.iter().any(|other| other.strip_prefix(body) == Some("_qw")).then_some(axis)
}

/// The field of a meaning; numbers count from the least that a quantity of the file has.
fn field(meaning: &Meaning, all: &[Option<Meaning>]) -> Option<usize> {
    let digits = || {
        let same = all.iter().flatten().filter(|other| other.kind == meaning.kind);
        same.filter_map(
            |other| if let Component::Digit(digit) = other.component { Some(digit) } else { None },
        )
    };
    let base = usize::from(digits().min() != Some(0));
    let from_base = |digit: usize| digit.checked_sub(base);
    let axis = match meaning.component {
        Component::Axis(axis) => Some(axis),
        Component::Digit(digit) => from_base(digit),
        Component::Only | Component::Scalar => None,
    };
    let of_three = |first: usize| axis.filter(|axis| *axis < 3).map(|axis| first + axis);
    match (meaning.kind, meaning.component) {
        (Kind::Time, _) => Some(0),
        (Kind::Position, _) => of_three(1),
        (Kind::Velocity, _) => of_three(8),
        (Kind::Spin, _) => of_three(11),
        (Kind::Angles, _) => of_three(ANGLES),
        (Kind::Roll, _) => of_three(ROLL),
        (Kind::Sigma, _) => of_three(SIGMA),
        (Kind::Quaternion, Component::Scalar) => Some(4),
        (Kind::Quaternion, Component::Axis(axis)) => Some(5 + axis),
        // q1 … q4 have the scalar last, q0 … q3 first.
        (Kind::Quaternion, Component::Digit(digit)) if base == 1 || meaning.scalar_last => {
            match digit.checked_sub(base)? {
                axis @ 0..3 => Some(5 + axis),
                3 => Some(4),
                _ => None,
            }
        }
        (Kind::Quaternion, Component::Digit(digit)) => (digit < 4).then_some(4 + digit),
        (Kind::Quaternion, Component::Only) => None,
        (Kind::Qpos, _) => from_base(digits_of(meaning)?).filter(|k| *k < 7).map(|k| 1 + k),
        (Kind::Qvel, _) => from_base(digits_of(meaning)?).filter(|k| *k < 6).map(|k| 8 + k),
    }
}

fn digits_of(meaning: &Meaning) -> Option<usize> {
    if let Component::Digit(digit) = meaning.component { Some(digit) } else { None }
}
