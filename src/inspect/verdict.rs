//! Whether a body can exist: its numbers alone, then its numbers beside its outline.
//!
//! Positive masses have moments I₁ ≤ I₂ ≤ I₃ above zero with I₁ + I₂ ≥ I₃. Each number is known to half a unit h of its last printed digit.
//! The slack I₁ + I₂ − I₃ = tr I − 2 vᵀ I v, v the axis of I₃, moves by at most Σ h_ij |M_ij| with M = E − 2 v vᵀ; a shortage below that is
//! rounding. No other tolerance is used but 64 units of f64, for sums.

use nalgebra::{Matrix3, Vector3};

use super::link::{Inertial, Link, tensor_of};
use super::outline::Outline;
use super::printed::Printed;
use crate::model::body::principal_axes;

/// Rounding of sums in f64, relative to the largest moment.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// A body with so many times fewer moments than the uniform solid is suspect: dense cores are at 1/40.
const MUCH_SMALLER: f64 = 0.01;

/// The verdict on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// No mass distribution has these numbers.
    Impossible,
    /// The numbers alone are possible, and the outline excludes them.
    Suspect,
    /// The triangle inequality fails by less than the printed digits can hide.
    Rounding,
    /// A point, a rod or a lamina.
    Limit,
    /// Mass, moments and triangle inequality are those of a body.
    Possible,
    /// Mass and tensor are zero.
    Frame,
    /// The file has no mass for it.
    NoData,
}

impl Verdict {
    /// All of them, the worst first.
    pub const ALL: [Verdict; 7] = [
        Verdict::Impossible,
        Verdict::Suspect,
        Verdict::Rounding,
        Verdict::Limit,
        Verdict::Possible,
        Verdict::Frame,
        Verdict::NoData,
    ];

    /// Its word in tables and JSON.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Impossible => "impossible",
            Verdict::Suspect => "suspect",
            Verdict::Rounding => "rounding",
            Verdict::Limit => "limit",
            Verdict::Possible => "possible",
            Verdict::Frame => "frame",
            Verdict::NoData => "no-data",
        }
    }
}

/// A link with its verdict.
#[derive(Clone, Debug)]
pub(super) struct Judged {
    pub verdict: Verdict,
    /// Stable names of what was seen.
    pub findings: Vec<&'static str>,
    /// Principal moments, ascending [kg m²].
    pub moments: Option<[f64; 3]>,
    /// I₁ + I₂ − I₃ [kg m²].
    pub slack: f64,
    /// What the printed digits can hide of it [kg m²].
    pub resolution: f64,
    pub outline: Option<Outline>,
    /// Largest share of what the outline allows; above 1 it is impossible inside the outline.
    pub fill: Option<f64>,
    /// tr I over that of the uniform solid.
    pub uniform_ratio: Option<f64>,
}

/// Principal moments, ascending, and the axis of each as a column.
pub(super) fn principal(tensor: &Matrix3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let (moments, axes) = principal_axes(tensor);
    let axes = axes.to_rotation_matrix().into_inner();
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    let sorted = Vector3::from_fn(|i, _| moments[order[i]]);
    (sorted, Matrix3::from_columns(&order.map(|i| axes.column(i).into_owned())))
}

/// Whether moments above zero obey the triangle inequality, to rounding.
pub(super) fn is_possible(tensor: &Matrix3<f64>) -> bool {
    let (moments, _) = principal(tensor);
    let rounding = ROUNDING * moments[2];
    moments.iter().all(|moment| moment.is_finite())
        && moments[0] > rounding
        && moments[0] + moments[1] - moments[2] >= -rounding
}

impl Judged {
    fn plain(verdict: Verdict, findings: Vec<&'static str>) -> Judged {
        Judged {
            verdict,
            findings,
            moments: None,
            slack: f64::NAN,
            resolution: f64::NAN,
            outline: None,
            fill: None,
            uniform_ratio: None,
        }
    }

    /// Judges a link.
    pub fn of(link: &Link) -> Judged {
        let mut judged = match &link.inertial {
            None => Judged::plain(Verdict::NoData, Vec::new()),
            Some(inertial) => Judged::of_inertial(link, inertial),
        };
        if link.inertials > 1 {
            judged.findings.push("duplicate-inertial");
        }
        judged
    }

    fn of_inertial(link: &Link, inertial: &Inertial) -> Judged {
        let (mass, six) = (inertial.mass.value, inertial.values());
        let has_shape = !link.solids.is_empty() || !link.drawn.is_empty() || link.meshes > 0;
        if !mass.is_finite() || six.iter().any(|number| !number.is_finite()) {
            return Judged::plain(Verdict::Impossible, vec!["not-a-number"]);
        }
        let zero = six.iter().all(|number| *number == 0.0);
        if mass == 0.0 && zero {
            let findings = if has_shape { vec!["zero-mass-with-geometry"] } else { Vec::new() };
            return Judged { moments: Some([0.0; 3]), ..Judged::plain(Verdict::Frame, findings) };
        }
        if mass <= 0.0 {
            let finding = if mass < 0.0 { "negative-mass" } else { "inertia-without-mass" };
            return Judged::plain(Verdict::Impossible, vec![finding]);
        }
        if zero {
            let finding = if has_shape { "zero-inertia-with-geometry" } else { "point-mass" };
            return Judged { moments: Some([0.0; 3]), ..Judged::plain(Verdict::Limit, vec![finding]) };
        }
        let mut judged = Judged::of_moments(&inertial.six);
        judged.beside_outline(link, inertial);
        judged
    }

    fn of_moments(six: &[Printed; 6]) -> Judged {
        let (moments, axes) = principal(&tensor_of(&std::array::from_fn(|i| six[i].value)));
        let hidden = tensor_of(&std::array::from_fn(|i| six[i].half_unit));
        let along = |place: usize| axes.column(place) * axes.column(place).transpose();
        let resolution = (Matrix3::identity() - along(2) * 2.0).abs().component_mul(&hidden).sum();
        let slack = moments[0] + moments[1] - moments[2];
        let rounding = ROUNDING * moments.amax();
        let mut judged = Judged {
            moments: Some(moments.into()),
            slack,
            resolution,
            ..Judged::plain(Verdict::Possible, Vec::new())
        };
        let hidden_in_least = along(0).abs().component_mul(&hidden).sum();
        if moments[0] < -rounding.max(hidden_in_least) {
            judged.add(Verdict::Impossible, "negative-moment");
        } else if moments[0] < -rounding {
            judged.add(Verdict::Rounding, "negative-moment-by-rounding");
        } else if moments[0] <= rounding {
            judged.add(Verdict::Limit, "zero-moment");
        }
        if slack < -rounding.max(resolution) {
            judged.add(Verdict::Impossible, "triangle");
        } else if slack < -rounding {
            judged.add(Verdict::Rounding, "triangle-by-rounding");
        } else if slack <= rounding && moments[0] > rounding {
            judged.add(Verdict::Limit, "flat");
        }
        judged
    }

    fn add(&mut self, verdict: Verdict, finding: &'static str) {
        self.verdict = self.verdict.min(verdict);
        self.findings.push(finding);
    }

    /// An outline of primitives alone can exclude a body; one with meshes proves nothing.
    fn beside_outline(&mut self, link: &Link, inertial: &Inertial) {
        let Some(outline) = Outline::of(link) else { return };
        let (mass, center, tensor) = (inertial.mass.value, inertial.pose.position, inertial.tensor());
        let by_numbers = self.verdict == Verdict::Impossible;
        let worst = if outline.exact && !by_numbers { Verdict::Suspect } else { self.verdict };
        self.fill = outline.fill(mass, &center, &tensor);
        self.uniform_ratio =
            outline.uniform.as_ref().map(|uniform| tensor.trace() / (mass * uniform.tensor.trace()));
        match self.fill {
            None if !by_numbers => self.add(worst, "com-outside-outline"),
            Some(fill) if fill > 1.0 + ROUNDING && !by_numbers => self.add(worst, "larger-than-its-outline"),
            _ => {}
        }
        if self.uniform_ratio.is_some_and(|ratio| ratio < MUCH_SMALLER) && !by_numbers {
            self.add(worst, "much-smaller-than-its-outline");
        }
        self.outline = Some(outline);
    }
}
