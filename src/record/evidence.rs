//! The evidence: all that was measured on a scheme in a scene and that gates read.
//!
//! A verdict is a pure function of it, of the error constants on record and of nothing else. Numbers that do not come out of a claim are
//! kept to five digits, roundings to two. In files lists of numbers are packed text, runs are columns; false, zero and missing values are left out.

use serde::{Deserialize, Serialize};

use super::numbers::{is_nothing, or_infinite};
use super::stability::LinearLimit;
use super::{DriftClass, columns, packed};
use crate::claim::Claim;
use crate::quantity::{PerQuantity, Quantity};

/// What was measured on one scheme in one scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Evidence {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Model that was run.
    pub model: String,
    /// What the scene is to a claim.
    pub setting: Setting,
    /// What the scheme claims.
    pub claims: Vec<Claim>,
    /// Whether it is a program under test.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub program: bool,
    /// Name that a baseline finds it by: a program's own, where it has one.
    pub known_as: String,
    /// Why the scheme cannot take the scene, if it cannot: then nothing is measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
    /// Runs of halved steps.
    pub ladder: Ladder,
    /// The same in double-double, where f64 leaves an order open.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub precise: Option<Ladder>,
    /// Runs in double-double to the first sample time, where a quantity is promised to be exact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exactness: Option<Ladder>,
    /// Runs over the beginning of the motion, where neither decides an order.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beginning: Option<Ladder>,
    /// Long runs of a free body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drift: Option<EnergyDrift>,
    /// The note as written, beside the least model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<PointRun>,
    /// Flips of a tumbling body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flips: Option<Flips>,
    /// A run there and back.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reversal: Option<Reversal>,
    /// The derivative of a step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub symplecticity: Option<Symplecticity>,
    /// The same run in other worlds.
    #[serde(default, skip_serializing_if = "Vec::is_empty", with = "columns")]
    pub other_worlds: Vec<OtherWorld>,
    /// What the budget of time leaves out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_out: Option<LeftOut>,
    /// The limit of stability on a spring-held body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step_limit: Option<LinearLimit>,
}

/// The runs that may decide an order: those in f64, those in double-double, and those over the beginning of the motion.
pub type Ladders<'a> = (&'a Ladder, Option<&'a Ladder>, Option<&'a Ladder>);

impl Evidence {
    /// The runs that may decide an order.
    pub fn ladders(&self) -> Ladders<'_> {
        (&self.ladder, self.precise.as_ref(), self.beginning.as_ref())
    }

    /// Whether the budget leaves out every run.
    pub fn is_unaffordable(&self) -> bool {
        self.left_out.is_some_and(|left_out| left_out.steps.is_some()) && self.ladder.rungs.is_empty()
    }

    /// The claimed order of convergence in this scene; 0 where none is claimed.
    pub fn order(&self) -> u32 {
        let claimed = |wanted: fn(&Claim) -> Option<u32>| self.claims.iter().find_map(wanted);
        let without_torque = claimed(|claim| match claim {
            Claim::OrderWithoutTorque(order) => Some(*order),
            _ => None,
        });
        let everywhere = claimed(|claim| if let Claim::Order(order) = claim { Some(*order) } else { None });
        without_torque.filter(|_| self.setting.torque_free).or(everywhere).unwrap_or(0)
    }
}

/// What a budget of time leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Steps of the coarsest run of halved steps that is not made; `None` where all are.
    pub steps: Option<u64>,
    /// Whether the long runs of a free body are not made.
    pub drift: bool,
    /// Estimate of the time that all runs of the scheme in the scene take [s].
    pub seconds: f64,
}

/// What a scene is to a claim.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// Fingerprint of body, forces, start and duration.
    pub content: String,
    /// Why no order applies, if none does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub not_for_order: Option<String>,
    /// Whether the scene has the content of the built-in one of its name.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub built_in: bool,
    /// Whether an order is exactly the claimed one here.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub generic: bool,
    /// No torque about the centre of mass, and no pivot.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub torque_free: bool,
    /// No torque, and Ω constant.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub steady_spin: bool,
    /// Two principal moments are equal.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub symmetric: bool,
    /// The force on the centre of mass is constant.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub constant_force: bool,
    /// There is no force on the centre of mass.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub no_force: bool,
    /// The body is a single point, which has no orientation.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub point: bool,
    /// Jumps of its laws within the run: at each a scheme starts anew.
    #[serde(default, skip_serializing_if = "none")]
    pub jumps: u64,
}

fn none(count: &u64) -> bool {
    *count == 0
}

/// Runs of a scheme at halved steps against the truth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ladder {
    /// Sample times [s]: the end, three quarters, half, and a quarter of it, a sixteenth, … down to the first turn.
    #[serde(with = "packed::list")]
    pub times: Vec<f64>,
    /// Size of each quantity over the motion, in its unit.
    #[serde(with = "packed::numbers")]
    pub sizes: PerQuantity<f64>,
    /// Uncertainty of the truth, in the unit of the quantity.
    #[serde(with = "packed::numbers")]
    pub uncertainty: PerQuantity<f64>,
    /// Whether the runs are in double-double.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub double_double: bool,
    /// Unit in the last place of the arithmetic, relative.
    pub arithmetic: f64,
    /// Half a unit in the last place that a program prints, relative; 0 where it prints all digits.
    pub printed: f64,
    /// How far the first state of any run is from the start of the scene.
    #[serde(with = "packed::numbers")]
    pub start: PerQuantity<f64>,
    /// Body axes from the centre of mass to points that stand for the body [m].
    #[serde(with = "packed::vectors")]
    pub arms: Vec<[f64; 3]>,
    /// The runs, each of half the step of the last.
    #[serde(with = "columns")]
    pub rungs: Vec<Rung>,
    /// Runs of an odd number of steps, compared at the end alone.
    #[serde(with = "columns")]
    pub odd: Vec<Rung>,
    /// What explains a program that solves another motion, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cause: Option<String>,
}

/// One run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Rung {
    /// h [s].
    pub step: f64,
    /// Steps of a whole run.
    pub steps: u64,
    /// Why the run broke, if it did.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub broken: Option<String>,
    /// Whether it broke where an implicit equation was not solved: its step is too large for the iteration.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub unsolved: bool,
    /// Evaluations of the forces.
    pub evaluations: u64,
    /// Implicit equations that were solved, …
    #[serde(default, skip_serializing_if = "is_nothing")]
    pub solves: u64,
    /// … and the iterations that they took.
    #[serde(default, skip_serializing_if = "is_nothing")]
    pub iterations: u64,
    /// Error vectors, the components of one sample time together: X, U, Ω and L in world axes; the orientation as the difference of
    /// rotation matrices over √2, or of the directions of a rod. That of body points follows from them, and is empty.
    #[serde(with = "packed::lists")]
    pub errors: PerQuantity<Vec<f64>>,
    /// Largest distance of a copy of the run from it, at each sample time.
    #[serde(with = "packed::lists")]
    pub rounding: PerQuantity<Vec<f64>>,
    /// Largest change of L·g over |L||g|, for a body on a pivot under uniform gravity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertical_momentum: Option<f64>,
}

impl Rung {
    /// The error vector of a quantity over the sample times.
    pub fn error(&self, quantity: Quantity, arms: &[[f64; 3]]) -> Vec<f64> {
        if quantity == Quantity::BodyPoint { self.body_points(arms) } else { self.errors[quantity].clone() }
    }

    /// X + R x for each arm x, of the differences of X and R.
    fn body_points(&self, arms: &[[f64; 3]]) -> Vec<f64> {
        let (positions, turns) = (&self.errors[Quantity::Position], &self.errors[Quantity::Orientation]);
        let samples = positions.len() / 3;
        let components = turns.len() / samples.max(1);
        let mut points = Vec::with_capacity(3 * samples * arms.len().max(1));
        for (sample, shift) in positions.chunks(3).enumerate() {
            let turn = &turns[sample * components..(sample + 1) * components];
            // Columns of the matrix, or the direction of a rod, whose only arm lies along it.
            let moved = |arm: &[f64; 3], row: usize| match components {
                9 => {
                    (0..3).map(|column| std::f64::consts::SQRT_2 * turn[3 * column + row] * arm[column]).sum()
                }
                3 => turn[row] * length(arm),
                _ => 0.0,
            };
            if arms.is_empty() {
                points.extend_from_slice(shift);
            }
            for arm in arms {
                points.extend((0..3).map(|row| shift[row] + moved(arm, row)));
            }
        }
        points
    }
}

/// Euclidean length of a vector of any scale.
pub fn length(vector: &[f64]) -> f64 {
    let largest = vector.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
    if vector.iter().any(|x| x.is_nan()) {
        return f64::NAN;
    }
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * vector.iter().map(|x| (x / largest) * (x / largest)).sum::<f64>().sqrt()
}

/// One long run of a free body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyRung {
    /// h [s].
    pub step: f64,
    /// Steps taken.
    pub steps: u64,
    /// Secular rate of (E − E₀)/E₀ [1/s].
    #[serde(with = "or_infinite")]
    pub rate: f64,
    /// What the rate may be wrong by: the difference of the rates over the first and last two thirds.
    #[serde(with = "or_infinite")]
    pub uncertainty: f64,
    /// Largest |E − E₀|/E₀.
    #[serde(with = "or_infinite")]
    pub level: f64,
    /// Largest (E − E₀)/E₀.
    #[serde(with = "or_infinite")]
    pub gain: f64,
    /// Largest E over L²/(2 I_min), the most that L allows.
    #[serde(with = "or_infinite")]
    pub of_largest: f64,
    /// Rounding of E after this many steps, relative.
    pub rounding: f64,
    /// Evaluations of the forces.
    pub evaluations: u64,
}

/// The drift of the energy over a ladder of steps.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyDrift {
    /// Long runs, step falling.
    #[serde(with = "columns")]
    pub rungs: Vec<EnergyRung>,
    /// Whether they are in double-double: rounding of f64 hides the rate.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub double_double: bool,
    /// Kind of drift.
    pub class: DriftClass,
    /// Run that stands for the ladder: the finest with a clear rate.
    pub shown: usize,
}

/// A run of the point form and what it shows.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PointRun {
    /// h [s].
    pub step: f64,
    /// Steps taken.
    pub steps: u64,
    /// Unit in the last place of the arithmetic that the runs are in, relative.
    pub unit: f64,
    /// Largest difference from the least model over the run, each quantity over its own scale.
    #[serde(with = "or_infinite")]
    pub difference: f64,
    /// Largest change of a distance between points over the run, over the extent.
    #[serde(with = "or_infinite")]
    pub stretch: f64,
    /// Largest change of L over |L|, for a body that no torque turns.
    pub momentum_change: Option<f64>,
    /// What the roundings of Σ X̃_k × F_k in every step may add to L by the end, over |L|: they have one sign for as long as the body
    /// hardly turns.
    #[serde(with = "or_infinite")]
    pub torque_rounding: f64,
    /// What rounding does: the largest differences of either form from copies of it, each quantity over its own scale.
    #[serde(with = "or_infinite")]
    pub rounding: f64,
}

/// Flips of a scheme beside those of the truth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Flips {
    /// Those of the truth.
    pub truth: TrueFlips,
    /// Duration of a run [s].
    pub duration: f64,
    /// Runs of halved steps, step falling.
    pub rungs: Vec<FlipRung>,
}

/// Flips of the truth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TrueFlips {
    /// Times [s].
    pub times: Vec<f64>,
    /// What they may be off by [s]: interpolation, and the solver's angle over the rate below.
    #[serde(with = "or_infinite")]
    pub uncertainty: f64,
    /// Slowest rate at which L goes through the plane across the axis, over |L| [rad/s]: an angle over it is a time.
    #[serde(with = "or_infinite")]
    pub slowest: f64,
}

/// Flip times of one run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlipRung {
    /// h [s].
    pub step: f64,
    /// Steps of the run.
    pub steps: u64,
    /// Flip times [s].
    pub times: Vec<f64>,
    /// What interpolation leaves open of them [s].
    #[serde(with = "or_infinite")]
    pub uncertainty: f64,
    /// Largest distance of a flip of a copy of the run from it [s]; infinite for a flip that not all of them have.
    #[serde(default, with = "packed::list")]
    pub rounding: Vec<f64>,
}

/// A run there and back.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reversal {
    /// Steps of one way.
    pub steps: u64,
    /// h [s].
    pub step: f64,
    /// Largest distance from the start over its rounding, of all quantities; `None` where a run broke.
    pub of_rounding: Option<f64>,
    /// The quantity that it belongs to, and the distance in its unit.
    pub worst: Option<(Quantity, f64)>,
    /// Whether a run broke since an implicit equation was not solved.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub unsolved: bool,
    /// Implicit equations that were solved on the way there.
    #[serde(default, skip_serializing_if = "is_nothing")]
    pub solves: u64,
    /// Angle that roundings leave open [rad]; 0 where no copies were run, since the distance is explained without them.
    pub open: f64,
    /// Whether the way was in double-double.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub double_double: bool,
}

/// What a step does to the two-form.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Symplecticity {
    /// h [s].
    pub step: f64,
    /// Largest change of the form, over the action that one radian of the motion carries.
    #[serde(with = "or_infinite")]
    pub defect: f64,
    /// Size of the directions in which it was differentiated, of a radian and of |L|: below one where the moments differ much.
    pub unit: f64,
    /// How far the change is from that of copies of the step, in the same measure.
    #[serde(with = "or_infinite")]
    pub rounding: f64,
    /// Whether the step was differentiated in double-double.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub double_double: bool,
}

/// A run in another world beside the run in the scene's own.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OtherWorld {
    /// Name of the change.
    pub name: String,
    /// Whether the arithmetic allows no difference at all.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub to_the_bit: bool,
    /// Largest difference at the end over its rounding, of all quantities; `None` where the run broke.
    pub of_rounding: Option<f64>,
    /// The quantity that it belongs to, and the difference in its unit.
    pub worst: Option<(Quantity, f64)>,
    /// Whether the run broke since an implicit equation was not solved.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub unsolved: bool,
    /// Steps of the run.
    pub steps: u64,
    /// Implicit equations that were solved in the scene's own world.
    #[serde(default, skip_serializing_if = "is_nothing")]
    pub solves: u64,
    /// Whether the runs are in double-double; in f64 otherwise.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub double_double: bool,
}

/// The reference of a scene, as the gate of references reads it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ReferenceEvidence {
    /// Scene.
    pub scene: String,
    /// Its sources.
    pub sources: Vec<String>,
    /// The quantity of the largest uncertainty over the run, and that over the size of the quantity; `None` where it is not finite.
    pub worst: Option<(Quantity, f64)>,
    /// Why there is no reference, if there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub missing: Option<String>,
}
