//! A scheme's ladder of steps on a scene, and what it says of each quantity's order.

use super::{ByRule, FOLLOWS, Reading};
use crate::measure::regression::{self, Fit, Ladder};
use crate::model::{PerQuantity, Quantity, System};
use crate::rotation;
use crate::simulate::Outcome;

/// Change by the last halving over the error, below which a run may have come to another motion.
pub const APART: f64 = 0.2;
/// Misfit without a term over that with it, from which on the term is seen.
const FAR_BETTER: f64 = 5.0;
/// Misfit that errors may leave which rounding bends by up to a floor at the fine end of a window.
const ROUNDING_EXPLAINS: f64 = 0.5;
/// Angle left open by roundings [rad], or part of the spin, from which on nothing is exact.
const OPEN_ANGLE: f64 = 1e-3;
/// Error over its floor from which on it stands clear.
const CLEAR: f64 = 10.0;
/// The same, of the rung that a window must reach and that a constant is taken from.
const SURE: f64 = 100.0;
/// Half-width of the band about the claimed order.
pub const BAND: f64 = 0.15;

/// Where along a run an error is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// At the end.
    End,
    /// The largest over the run.
    Max,
}

impl Place {
    /// Both.
    pub const ALL: [Place; 2] = [Place::End, Place::Max];

    /// Suffix in records.
    pub fn suffix(self) -> &'static str {
        match self {
            Place::End => "end",
            Place::Max => "max",
        }
    }

    /// The value of a reading at this place.
    pub fn of(self, reading: &Reading) -> f64 {
        match self {
            Place::End => reading.end,
            Place::Max => reading.max,
        }
    }
}

/// One run of the ladder.
#[derive(Clone, Debug)]
pub struct Rung {
    /// h [s].
    pub step: f64,
    /// Steps of a whole run.
    pub steps: u64,
    /// Errors; NaN where the run broke.
    pub errors: PerQuantity<Reading>,
    /// Floors of the errors.
    pub floors: PerQuantity<Reading>,
    /// How far the run is from the one before it; NaN for the first.
    pub moved: PerQuantity<Reading>,
    /// The other metrics, in the order of [`ALL`].
    pub readings: Vec<Option<Reading>>,
    /// Cost and end.
    pub outcome: Outcome,
}

impl Rung {
    /// Whether rounding and the reference leave so much open of the rotation that nothing can be called exact.
    pub fn is_open(&self, system: &System) -> bool {
        let momentum = system.start.orientation.inverse_transform_vector(&system.start.angular_momentum);
        let spin = rotation::length(&(system.body.inverse_inertia() * momentum));
        let open = |quantity| self.floors[quantity].max;
        open(Quantity::Orientation) > OPEN_ANGLE
            || spin > 0.0 && open(Quantity::AngularVelocity) > OPEN_ANGLE * spin
    }

    /// Whether rounding and the reference leave more of a body point open than a tenth of the body's size: nobody knows the motion then.
    pub fn is_lost(&self, system: &System) -> bool {
        self.floors[Quantity::BodyPoint].max > FOLLOWS * system.body.extent()
    }

    /// Whether the run follows the truth, to a tenth of the body's size.
    pub(super) fn follows(&self, system: &System) -> bool {
        self.errors[Quantity::BodyPoint].max <= FOLLOWS * system.body.extent()
    }

    /// Whether an error stands clear of the floor that `unlike` roundings make and not of its own, or a hundred times clear.
    pub(super) fn is_clear_by_one_law(&self, unlike: &PerQuantity<Reading>) -> bool {
        let between = |error: f64, low: f64, high: f64| {
            [CLEAR, SURE].iter().any(|clear| error > clear * low && error <= clear * high)
        };
        self.outcome.broken.is_none()
            && self.errors.iter().any(|(quantity, error)| {
                let (low, high) = (&unlike[quantity], &self.floors[quantity]);
                between(error.end, low.end, high.end) || between(error.max, low.max, high.max)
            })
    }
}

/// A quantity's ladder, judged by nothing but its numbers.
#[derive(Clone, Debug)]
pub struct QuantityLadder {
    /// The quantity.
    pub quantity: Quantity,
    /// Where it is taken.
    pub place: Place,
    /// (h, error, floor), h falling.
    pub rungs: Vec<(f64, f64, f64)>,
    /// What they say.
    pub ladder: Ladder,
    /// C = e/hᵖ at the claimed order, at the finest rung of the window that stands 100 times clear of its floor.
    pub constant: Option<f64>,
}

impl QuantityLadder {
    /// A ladder of (h, error, floor), h falling, with what it says; the constant is that of `order`.
    pub fn of(quantity: Quantity, place: Place, rungs: Vec<(f64, f64, f64)>, order: u32) -> QuantityLadder {
        let ladder = regression::find_window(&rungs);
        let constant = leading_constant(&rungs, &ladder, order);
        QuantityLadder { quantity, place, rungs, ladder, constant }
    }

    /// The fit, where there is a window.
    pub fn fit(&self) -> Option<Fit> {
        if let Ladder::Window { fit, .. } = &self.ladder { Some(*fit) } else { None }
    }

    /// Whether the window shows a term of `order` that the next one still hides: with it two terms explain the window, far
    /// better than two terms without it, and better than any single power. Slopes outside the band then say nothing against that
    /// order.
    pub fn is_on_its_way(&self, order: u32) -> bool {
        let Ladder::Window { rungs, .. } = &self.ladder else { return false };
        let window: Vec<_> =
            self.rungs[rungs.clone()].iter().map(|(h, e, floor)| (*h, *e, floor / e)).collect();
        let without = regression::misfit(&window, order + 1).unwrap_or(f64::INFINITY);
        let power = regression::misfit_of_a_power(&window).unwrap_or(0.0);
        regression::misfit(&window, order).is_some_and(|with| {
            with <= 1.0 && without > ROUNDING_EXPLAINS && FAR_BETTER * with < without && with < power
        })
    }

    /// Whether the interval lies inside the band about `order`.
    pub fn holds(&self, order: u32) -> bool {
        self.fit()
            .is_some_and(|fit| fit.low >= f64::from(order) - BAND && fit.high <= f64::from(order) + BAND)
    }
}

/// What a scheme did on the ladder of a scene.
#[derive(Clone, Debug)]
pub struct Evidence {
    /// Name of the model that was run.
    pub model: &'static str,
    /// The runs, step falling.
    pub rungs: Vec<Rung>,
    /// Ladders of every quantity at every place.
    pub ladders: Vec<QuantityLadder>,
    /// Runs at steps that turn the body by any angle, for a body in steady spin: exact is exact at every step.
    pub giant_steps: Vec<Rung>,
    /// A smaller step that the finest run would have gone on in from where it broke [s].
    pub goes_on_in: Option<f64>,
    /// What the rule of orders says of a program under test, whose runs it reads as vectors.
    pub by_rule: Option<ByRule>,
}

impl Evidence {
    /// Why the scheme cannot take the scene, where that was known only when it was asked.
    pub fn refusal(&self) -> Option<&str> {
        self.rungs.iter().find_map(|rung| rung.outcome.refusal())
    }
}

fn leading_constant(points: &[(f64, f64, f64)], ladder: &Ladder, order: u32) -> Option<f64> {
    let Ladder::Window { rungs, .. } = ladder else { return None };
    let window = &points[rungs.clone()];
    let clearest = window.iter().rev().find(|(_, e, floor)| *e >= 100.0 * floor).or(window.first())?;
    Some(clearest.1 / clearest.0.powi(order as i32))
}
