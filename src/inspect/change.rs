//! Single changes of the six numbers that make a tensor possible: what a slip of a hand or of a program does.

use super::link::{MOMENTS, PRODUCTS, SIX, tensor_of};
use super::verdict::is_possible;

/// Powers of ten that are tried on one number: units of length, mass and both, down to g mm² (1e-9).
const POWERS: std::ops::RangeInclusive<i32> = -9..=9;

/// A changed tensor.
#[derive(Clone, Debug)]
pub(super) struct Change {
    /// Kind of the repair.
    pub kind: &'static str,
    /// What changes.
    pub label: String,
    /// Which number is scaled, and by which power of ten.
    pub scaled: Option<(usize, i32)>,
    /// The six after it.
    pub six: [f64; 6],
}

/// Every single change of six numbers, in the order in which it is tried.
pub(super) fn all(six: &[f64; 6], format: &str) -> Vec<Change> {
    let mut changes = Vec::new();
    let mut add = |kind, label: String, scaled, changed: [f64; 6]| {
        if changed != *six {
            changes.push(Change { kind, label, scaled, six: changed });
        }
    };
    if PRODUCTS.iter().any(|place| six[*place] != 0.0) {
        for (names, changed) in flips(six, PRODUCTS) {
            add("flip-products", names, None, changed);
        }
        let bare = std::array::from_fn(|i| if PRODUCTS.contains(&i) { 0.0 } else { six[i] });
        add("zero-products", "ixy = ixz = iyz = 0".to_owned(), None, bare);
        let (label, changed) = reordered(six, format);
        add("reorder", label.to_owned(), None, changed);
    }
    for (names, changed) in flips(six, MOMENTS) {
        add("flip-diagonal", names, None, changed);
    }
    for (place, name) in SIX.into_iter().enumerate() {
        for power in POWERS {
            let mut changed = *six;
            changed[place] *= 10f64.powi(power);
            add("scale-one", format!("{name} by 10^{power}"), Some((place, power)), changed);
        }
    }
    changes
}

/// Those that make the body possible.
pub(super) fn possible(six: &[f64; 6], format: &str) -> Vec<Change> {
    let mut changes = all(six, format);
    changes.retain(|change| is_possible(&tensor_of(&change.six)));
    changes
}

/// Signs of some of three numbers turned: one number first, then two, then three.
fn flips(six: &[f64; 6], places: [usize; 3]) -> Vec<(String, [f64; 6])> {
    [1usize, 2, 4, 3, 5, 6, 7]
        .into_iter()
        .map(|pattern| {
            let chosen: Vec<usize> = (0..3).filter(|i| pattern >> i & 1 == 1).map(|i| places[i]).collect();
            let mut changed = *six;
            chosen.iter().for_each(|place| changed[*place] = -changed[*place]);
            (chosen.iter().map(|place| SIX[*place]).collect::<Vec<_>>().join(" "), changed)
        })
        // A zero has no sign.
        .filter(|(names, _)| {
            names.split(' ').all(|name| SIX.iter().zip(six).any(|(own, x)| *own == name && *x != 0.0))
        })
        .collect()
}

/// The six read in the order of the other format.
fn reordered(six: &[f64; 6], format: &str) -> (&'static str, [f64; 6]) {
    let places = |order: [usize; 6]| order.map(|place| six[place]);
    if format == "mjcf" {
        ("fullinertia slots hold ixx ixy ixz iyy iyz izz (URDF order)", places([0, 3, 5, 1, 2, 4]))
    } else {
        ("slots hold ixx iyy izz ixy ixz iyz (MuJoCo order)", places([0, 3, 4, 1, 5, 2]))
    }
}

/// One line a kind and number: "scale-one: ixy by 10^-3,-2,-1".
pub(super) fn listed(changes: &[Change]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut last = None;
    for change in changes {
        match (change.scaled, lines.last_mut()) {
            (Some((place, power)), Some(line)) if last == Some(place) => *line += &format!(",{power}"),
            _ => lines.push(format!("{}: {}", change.kind, change.label)),
        }
        last = change.scaled.map(|(place, _)| place);
    }
    lines
}
