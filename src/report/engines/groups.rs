//! Who makes the same motion: twins, and twins of twins, as one group.

use serde::Serialize;

use crate::record::{Records, Twin};

use super::label;
use crate::report::number;

/// Programs and schemes with one rule.
#[derive(Serialize)]
pub(super) struct Group {
    members: Vec<String>,
    digits: String,
    step: String,
    apart: String,
    error: String,
}

/// The groups of a scene at a step, those of the largest error first.
pub(super) fn groups(records: &Records, scene: &str, step: f64) -> Vec<Group> {
    let twins: Vec<&Twin> =
        records.twins.iter().filter(|twin| twin.scene == scene && twin.step_s == step).collect();
    let mut groups: Vec<Vec<&Twin>> = Vec::new();
    for twin in twins {
        let (joined, others): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|group| group.iter().any(|other| shares_one(twin, other)));
        groups = others;
        groups.push(joined.into_iter().flatten().chain([twin]).collect());
    }
    groups.sort_by(|a, b| largest(b, |twin| twin.error_rad).total_cmp(&largest(a, |twin| twin.error_rad)));
    groups.iter().map(|twins| group(records, twins, step)).collect()
}

fn shares_one(a: &Twin, b: &Twin) -> bool {
    [&a.one, &a.other].into_iter().any(|name| *name == b.one || *name == b.other)
}

fn largest(twins: &[&Twin], of: fn(&Twin) -> f64) -> f64 {
    twins.iter().map(|twin| of(twin)).fold(0.0, f64::max)
}

fn group(records: &Records, twins: &[&Twin], step: f64) -> Group {
    let names = twins.iter().flat_map(|twin| [twin.one.as_str(), twin.other.as_str()]);
    let digits = twins.iter().map(|twin| twin.digits).fold(f64::INFINITY, f64::min);
    Group {
        members: super::survey::distinct(names).into_iter().map(|name| label(records, name)).collect(),
        digits: match twins.iter().all(|twin| twin.to_rounding) {
            true => "to rounding".to_owned(),
            false => format!("to {}", number::counted(digits.floor() as usize, "digit")),
        },
        step: number::setting(step),
        apart: number::quantity(Some(largest(twins, |twin| twin.apart_rad)), None, "rad"),
        error: number::quantity(Some(largest(twins, |twin| twin.error_rad)), None, "rad"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twins_of_twins_are_one_group_and_others_another() {
        let twin = |one: &str, other: &str, digits, error| Twin {
            scene: "s".to_owned(),
            step_s: 0.1,
            one: one.to_owned(),
            other: other.to_owned(),
            apart_rad: error / 10f64.powf(digits),
            error_rad: error,
            digits,
            to_rounding: digits > 9.0,
        };
        let twins = vec![
            twin("a", "b", 4.5, 0.1),
            twin("c", "d", 12.0, 0.2),
            twin("e", "f", 3.5, 0.1),
            twin("b", "f", 5.0, 0.1),
        ];
        let records = Records { twins, ..Records::default() };
        let found = groups(&records, "s", 0.1);
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].members.join(" "), found[0].digits.as_str()), ("c d".to_owned(), "to rounding"));
        let mut second = found[1].members.clone();
        second.sort();
        assert_eq!((second.join(" "), found[1].digits.as_str()), ("a b e f".to_owned(), "to 3 digits"));
        assert!(groups(&records, "s", 0.2).is_empty() && groups(&records, "t", 0.1).is_empty());
    }
}
