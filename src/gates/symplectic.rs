//! The symplecticity gate: the canonical two-form after a step is the one before, to the error of the differences that
//! the step's derivative is taken by.

use super::{at_most, ruled};
use crate::arithmetic::{DoubleDouble, Real};
use crate::measure::CLEAR;
use crate::record::{ClaimName, Evidence, Ruling, Verdict};

/// Five-point differences at ε leave ε⁴/30 of the fifth derivative and 1.5 u/ε of rounding: in f64, at ε = 1e-3, 3e-14 and 3e-13 times what a
/// radian of the motion amplifies, which is 2⁵ for steps of half a radian, and a hundred for the forces of a scene. Directions
/// that are shorter than a radian make a rounding as many times larger. Far from the origin and for thin bodies copies show more.
const DEFECT: f64 = 1e-9;

/// The same in an arithmetic of this unit, where ε falls as the fifth root of the unit and both errors as its fourth power.
fn defect(unit: f64) -> f64 {
    DEFECT * (unit / f64::EPSILON).powf(0.8)
}

pub(super) fn judge(evidence: &Evidence) -> Verdict {
    let Some(symplecticity) = evidence.symplecticity else {
        let detail = "no canonical form: a rod or a point, a body at rest, a force without potential or with a velocity in it";
        return ruled(evidence, ClaimName::Symplectic, "two-form", Ruling::NotApplicable, detail);
    };
    let unit = if symplecticity.double_double { DoubleDouble::UNIT } else { f64::EPSILON };
    let bound = defect(unit) / symplecticity.unit + CLEAR * symplecticity.rounding;
    let detail = format!(
        "the two-form changes by {:.2e} of |L| in a step of {:.3e} s; at most {bound:.1e}",
        symplecticity.defect, symplecticity.step
    );
    at_most(evidence, ClaimName::Symplectic, "two-form", symplecticity.defect, bound, detail)
}
