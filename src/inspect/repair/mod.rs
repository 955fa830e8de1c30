//! The one repair that makes a body possible.
//!
//! A repair needs two witnesses: it makes the body possible, **and** something else in the file says the same: the outline, the mirrored
//! twin, a repeated number, how the number is printed. Without the second it is a candidate, and is called one. Where two different
//! repairs have witnesses, there are several and none is chosen.

mod digits;
mod outline;
mod twin;

use nalgebra::{Matrix3, Vector3};

pub(super) use twin::Sides;

use super::change;
use super::link::{Inertial, Link};
use super::verdict::{Judged, Verdict};

/// A repaired body.
#[derive(Clone, Debug)]
pub(super) struct Repair {
    /// Stable name of its kind.
    pub kind: &'static str,
    /// What to change.
    pub what: String,
    /// The second witness.
    pub how_known: String,
    /// Whether no other values would do as well.
    pub unique: bool,
    /// [kg].
    pub mass: f64,
    /// Centre of mass [m], axes of the link.
    pub center: Vector3<f64>,
    /// About the centre of mass, axes of the link [kg m²].
    pub tensor: Matrix3<f64>,
}

/// What can be said of a repair.
#[derive(Clone, Debug, Default)]
pub(super) struct Advice {
    /// The repair, where there is one.
    pub repair: Option<Repair>,
    /// Repairs with witnesses of their own, where there are several.
    pub several: Vec<Repair>,
    /// Single changes that make the numbers possible, witnessed or not.
    pub candidates: Option<Vec<String>>,
    /// What is odd about the digits, where that does not lead to a repair by itself.
    pub oddities: Vec<String>,
}

/// A link to repair, with its neighbours.
pub(super) struct Case<'a> {
    pub link: &'a Link,
    pub judged: &'a Judged,
    pub inertial: &'a Inertial,
    pub format: &'static str,
    /// All links with their verdicts.
    pub all: &'a [(Link, Judged)],
    pub sides: &'a Sides,
}

impl Case<'_> {
    fn mass(&self) -> f64 {
        self.inertial.mass.value
    }

    fn repair(&self, kind: &'static str, what: String, how_known: String, tensor: Matrix3<f64>) -> Repair {
        let center = self.inertial.pose.position;
        Repair { kind, what, how_known, unique: true, mass: self.mass(), center, tensor }
    }
}

/// Findings that the six numbers alone make.
const BY_NUMBERS: [&str; 2] = ["triangle", "negative-moment"];

/// Looks for the repair of a link.
pub(super) fn find(case: &Case) -> Advice {
    let mut advice = Advice::default();
    let has = |finding: &str| case.judged.findings.contains(&finding);
    let by_numbers = case.judged.verdict == Verdict::Impossible && BY_NUMBERS.into_iter().any(has);
    let changes =
        if by_numbers { change::possible(&case.inertial.values(), case.format) } else { Vec::new() };
    if by_numbers {
        advice.candidates = Some(change::listed(&changes));
        advice.oddities = digits::oddities(case);
    }
    let tries: [&dyn Fn() -> Vec<Repair>; 5] = [
        &|| twin::repairs(case, &changes),
        &|| outline::repairs(case, &changes),
        &|| digits::repairs(case, &changes),
        &|| outline::slips_of_unit(case),
        &|| outline::placeholders(case),
    ];
    for look in tries {
        let mut found = distinct(look());
        match found.len() {
            0 => {}
            1 => {
                advice.repair = found.pop();
                return advice;
            }
            _ => {
                advice.several = found;
                return advice;
            }
        }
    }
    advice
}

/// Repairs that end in the same body count once; the first is kept.
fn distinct(found: Vec<Repair>) -> Vec<Repair> {
    let mut kept: Vec<Repair> = Vec::new();
    for repair in found {
        let same = |other: &Repair| {
            (other.mass - repair.mass).abs() <= 1e-6 * other.mass.abs()
                && close(&other.tensor, &repair.tensor, CLOSE)
        };
        if !kept.iter().any(same) {
            kept.push(repair);
        }
    }
    kept
}

/// Two tensors agree to three digits: six numbers that do so by chance are one in 1e15.
const CLOSE: f64 = 1e-3;

/// Whether no number of two tensors differs by more than a share of their trace.
fn close(a: &Matrix3<f64>, b: &Matrix3<f64>, share: f64) -> bool {
    (a - b).amax() <= share * a.trace().abs().max(b.trace().abs())
}
