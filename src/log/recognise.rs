//! What the names of a file's columns say together: numbers count from the least of a quantity, and a body lends its name to a place.

use super::columns::{self, Component, Kind, Meaning};
use super::layout::{ANGLES, ROLL, SIGMA, Slot};
use super::names;

/// A name of bodies that is a name of axes, too.
const BODY: &str = "body";
/// How Drake begins the names of positions of a floating body. Its angular velocities are in world axes.
const DRAKE: &str = "$world";

/// Fills in what the names say; returns whether they say that angular velocities are in body axes.
pub(super) fn recognise(names: &[&str], slots: &mut [Option<Slot>]) -> bool {
    let rates: Vec<_> = names.iter().map(|name| names::rate(name)).collect();
    if (0..3).all(|axis| rates.iter().flatten().any(|rate| rate.0 == axis)) {
        for (rate, slot) in rates.into_iter().zip(slots.iter_mut()) {
            *slot = rate.map(|(axis, unit)| Slot { field: 11 + axis, unit });
        }
    }
    let mut in_body_axes = slots.iter().any(Option::is_some);
    let meanings = meanings(names);
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
    let is_time = |slot: &Option<Slot>| slot.is_some_and(|slot| slot.field == 0);
    if !slots.iter().any(is_time)
        && let Some(place) = names.iter().position(|name| names::is_time(name, true))
        && slots[place].is_none()
    {
        slots[place] = Some(Slot { field: 0, unit: names::time_unit(names[place]) });
    }
    in_body_axes && !names.iter().any(|name| name.starts_with(DRAKE))
}

/// What each name says. A body whose name is `body` lends it to every column: then the word does not say axes.
fn meanings(names: &[&str]) -> Vec<Option<Meaning>> {
    let bare = |name: &str| {
        let (first, rest) = name.split_at_checked(BODY.len())?;
        let (sign, rest) = rest.split_at_checked(1)?;
        (first.eq_ignore_ascii_case(BODY) && "_.:".contains(sign)).then(|| rest.to_owned())
    };
    let all: Vec<Option<Meaning>> = names.iter().map(|name| columns::meaning(name)).collect();
    let states = || names.iter().zip(&all).filter_map(|(name, one)| Some((name, one.as_ref()?)));
    let of_body = |(name, one): (&&str, &Meaning)| one.kind == Kind::Time || bare(name).is_some();
    let is_place = |kind: Kind| matches!(kind, Kind::Position | Kind::Quaternion);
    if !(states().all(of_body) && states().any(|(_, one)| is_place(one.kind))) {
        return all;
    }
    names.iter().map(|name| columns::meaning(&bare(name).unwrap_or((*name).to_owned()))).collect()
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
