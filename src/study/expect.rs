//! What the error of a scheme will be at a step: C hᵖ with a constant on record, checked by two runs.
//!
//! The runs have N and 2N steps, N a power of two, and their steps lie on both sides of the step h. The shape of the error, its size at the end and
//! its largest over the run, each over its root mean square over the sample times, is that of the finer run:
//!
//! ```text
//! (1)  e(h) = s C hᵖ,   s = e_fine / rms_fine
//! ```
//!
//! The band is what (1) misses the two runs by, and the hundredth to which constants are held. Without a constant on record, C is
//! rms_fine / h_fineᵖ, and the coarser run alone checks it.

use crate::measure::{self, Asked, Bounds, Climbed, Reading};
use crate::model::{PerQuantity, Quantity, larger};
use crate::reference::Reference;
use crate::scenes::Scene;
use crate::simulate::Contestant;

/// Constants on record are held to this, relative.
const HELD: f64 = 0.01;
/// A prediction that misses a run by more explains nothing: a wrong order misses a halving by this.
const WIDEST: f64 = 0.5;
/// Fewest steps of the coarser run, and most: minutes of the costliest scheme.
const STEPS: std::ops::RangeInclusive<u64> = 4..=1 << 20;

/// The error of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expected {
    /// p.
    pub order: u32,
    /// C of the root mean square over the run, in the unit of the quantity over sᵖ.
    pub constant: f64,
    /// Whether C is on record.
    pub on_record: bool,
    /// s C hᵖ, at the end and the largest over the run.
    pub error: Reading,
    /// How far the prediction may be off, relative.
    pub band: Reading,
}

/// Why nothing is expected of a quantity.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Unexpected {
    /// The errors of the runs do not stand clear of rounding.
    #[error("the error is at its rounding")]
    Rounding,
    /// C hᵖ does not explain the runs.
    #[error("C h^p misses the runs by {:.0} %: take a smaller step", 100.0 * .0)]
    Unexplained(f64),
    /// A run broke.
    #[error("a run broke: {0}")]
    Broken(String),
}

/// Runs on both sides of a step.
pub struct Bracket {
    climbed: Climbed,
}

impl Bracket {
    /// Runs the scheme. `None` where the step is too large or too small for two runs.
    pub fn of(scene: &Scene, reference: &Reference, contestant: &Contestant, step: f64) -> Option<Bracket> {
        let steps = scene.duration / step;
        if !(steps.is_finite() && steps >= 1.0) {
            return None;
        }
        let above = (steps.ceil() as u64).checked_next_power_of_two()?.max(2 * STEPS.start());
        if !STEPS.contains(&above) {
            return None;
        }
        let bounds = Bounds { coarsest: Some(above / 2), finest: Some(above), ..Bounds::default() };
        Some(Bracket { climbed: measure::climb_within(contestant, &scene.system, reference, None, bounds) })
    }

    /// Why the scheme cannot take the scene.
    pub fn refusal(&self) -> Option<&str> {
        self.climbed.refusal()
    }

    /// The steps of the two runs [s].
    pub fn steps(&self) -> (f64, f64) {
        let step = |rung: Option<&measure::Rung>| rung.map_or(f64::NAN, |rung| rung.step);
        (step(self.climbed.rungs.first()), step(self.climbed.rungs.last()))
    }

    /// What to expect at a step, with the constant on record where there is one.
    pub fn expect(
        &self,
        step: f64,
        stored: impl Fn(Quantity) -> Option<f64>,
    ) -> PerQuantity<Result<Expected, Unexpected>> {
        // A constant on record may be that of the beginning of the run alone: then the runs give their own.
        let known = |quantity| stored(quantity).and_then(|known| self.one(step, quantity, Some(known)).ok());
        PerQuantity::of(|quantity| match known(quantity) {
            Some(expected) => Ok(expected),
            None => self.one(step, quantity, None),
        })
    }

    fn one(&self, step: f64, quantity: Quantity, stored: Option<f64>) -> Result<Expected, Unexpected> {
        let ladder = &self.climbed.ladder;
        if let Some(why) = ladder.rungs.iter().find_map(|rung| rung.broken.clone()) {
            return Err(Unexpected::Broken(why));
        }
        let asked = Asked::of(ladder, quantity);
        let runs = asked.runs.first().zip(asked.runs.last());
        let shown = self.climbed.rungs.first().zip(self.climbed.rungs.last());
        let (Some((coarse, fine)), Some((coarse_shown, fine_shown))) = (runs, shown) else {
            return Err(Unexpected::Broken("no run".to_owned()));
        };
        let (rms_coarse, rms_fine) = (asked.error(coarse), asked.error(fine));
        if rms_fine <= asked.floor_of(fine) || rms_coarse <= asked.floor_of(coarse) {
            return Err(Unexpected::Rounding);
        }
        let slope = (rms_coarse / rms_fine).ln() / (coarse.step / fine.step).ln();
        let order = slope.round().max(0.0) as u32;
        let power = |h: f64| h.powi(order as i32);
        let constant = stored.unwrap_or(rms_fine / power(fine.step));
        let at = |of: fn(&Reading) -> f64| {
            let (end_coarse, end_fine) =
                (of(&coarse_shown.errors[quantity]), of(&fine_shown.errors[quantity]));
            let shape = end_fine / rms_fine;
            let miss = |h: f64, error: f64| (error / (shape * constant * power(h)) - 1.0).abs();
            let missed = larger(miss(coarse.step, end_coarse), miss(fine.step, end_fine));
            (shape * constant * power(step), HELD + missed)
        };
        let ((end, end_band), (max, max_band)) = (at(|reading| reading.end), at(|reading| reading.max));
        // The error at the end may pass through zero: then only the largest is expected.
        let widest = if end_band <= WIDEST { end_band.max(max_band) } else { max_band };
        if order == 0 || widest.is_nan() || widest > WIDEST {
            return Err(Unexpected::Unexplained(widest));
        }
        Ok(Expected {
            order,
            constant,
            on_record: stored.is_some(),
            error: Reading { end, max },
            band: Reading { end: end_band, max: max_band },
        })
    }
}
