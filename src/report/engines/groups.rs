//! Who makes the same motion. Twins to rounding, and twins of twins, have one rule and are a group. Those that share
//! digits and no more have rules of the same leading error: they come together as the step falls.

use serde::Serialize;

use super::label;
use crate::record::{Records, Twin};
use crate::report::{number, survey};

/// Programs and schemes with one rule.
#[derive(Serialize)]
pub(super) struct Group {
    members: Vec<String>,
    apart: String,
    error: String,
}

/// Two, or two groups, that share digits of their errors.
#[derive(Serialize)]
pub(super) struct Alike {
    one: String,
    other: String,
    digits: String,
}

/// The twins of a scene at one step.
pub(super) struct Kin<'a> {
    records: &'a Records,
    twins: Vec<&'a Twin>,
    groups: Vec<Vec<&'a str>>,
}

impl<'a> Kin<'a> {
    pub(super) fn new(records: &'a Records, scene: &str, step: f64) -> Kin<'a> {
        let here = |twin: &&Twin| twin.scene == scene && twin.step_s == step;
        let twins: Vec<&Twin> = records.twins.iter().filter(here).collect();
        let mut groups: Vec<Vec<&str>> = Vec::new();
        for twin in twins.iter().filter(|twin| twin.to_rounding) {
            let pair = [twin.one.as_str(), twin.other.as_str()];
            let (joined, others): (Vec<_>, Vec<_>) =
                groups.into_iter().partition(|group| group.iter().any(|name| pair.contains(name)));
            groups = others;
            groups.push(survey::distinct(joined.into_iter().flatten().chain(pair)));
        }
        Kin { records, twins, groups }
    }

    /// The groups of one rule, those of the largest error first.
    pub(super) fn groups(&self) -> Vec<Group> {
        let mut groups: Vec<(f64, Group)> = self.groups.iter().map(|group| self.group(group)).collect();
        groups.sort_by(|a, b| b.0.total_cmp(&a.0));
        groups.into_iter().map(|(_, group)| group).collect()
    }

    fn group(&self, group: &[&str]) -> (f64, Group) {
        let within = |twin: &&&Twin| twin.to_rounding && group.contains(&twin.one.as_str());
        let largest =
            |of: fn(&Twin) -> f64| self.twins.iter().filter(within).map(|twin| of(twin)).fold(0.0, f64::max);
        let (apart, error) = (largest(|twin| twin.apart_rad), largest(|twin| twin.error_rad));
        let told = |angle| number::joined(&number::significant(angle, 2), "rad");
        let members = group.iter().map(|name| label(self.records, name)).collect();
        let error_told = number::quantity(Some(error), None, "rad");
        (error, Group { members, apart: told(apart), error: error_told })
    }

    /// Pairs that share digits and have not one rule; a group is told of by its first member.
    pub(super) fn alike(&self) -> Vec<Alike> {
        let first =
            |name: &'a str| self.groups.iter().find(|group| group.contains(&name)).map_or(name, |g| g[0]);
        let mut pairs: Vec<(&str, &str, f64)> = Vec::new();
        for twin in self.twins.iter().filter(|twin| !twin.to_rounding) {
            let (one, other) = (first(&twin.one), first(&twin.other));
            let same =
                |pair: &&mut (&str, &str, f64)| [(one, other), (other, one)].contains(&(pair.0, pair.1));
            match pairs.iter_mut().find(same) {
                Some(pair) => pair.2 = pair.2.min(twin.digits),
                None => pairs.push((one, other, twin.digits)),
            }
        }
        let told = |(one, other, digits): (&str, &str, f64)| Alike {
            one: label(self.records, one),
            other: label(self.records, other),
            digits: number::counted(digits.floor() as usize, "digit"),
        };
        pairs.into_iter().map(told).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twins_to_rounding_are_groups_and_others_are_alike() {
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
            twin("a", "b", 12.0, 0.1),
            twin("c", "d", 12.0, 0.2),
            twin("e", "f", 13.0, 0.1),
            twin("b", "f", 11.0, 0.1),
            twin("c", "a", 3.5, 0.2),
            twin("e", "d", 3.2, 0.2),
            twin("x", "y", 4.9, 0.2),
        ];
        let records = Records { twins, ..Records::default() };
        let kin = Kin::new(&records, "s", 0.1);
        let members: Vec<String> = kin
            .groups()
            .into_iter()
            .map(|mut group| {
                group.members.sort();
                group.members.join(" ")
            })
            .collect();
        assert_eq!(members, ["c d", "a b e f"]);
        let alike: Vec<(String, String)> = kin
            .alike()
            .into_iter()
            .map(|pair| (format!("{} {}", pair.one, pair.other), pair.digits))
            .collect();
        assert_eq!(alike.len(), 2, "{alike:?}");
        assert!(alike[0].0.contains('c') && alike[0].1 == "3 digits", "{alike:?}");
        assert_eq!(alike[1], ("x y".to_owned(), "4 digits".to_owned()));
        for other in [Kin::new(&records, "s", 0.2), Kin::new(&records, "t", 0.1)] {
            assert!(other.groups().is_empty() && other.alike().is_empty());
        }
    }
}
