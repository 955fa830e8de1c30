//! One rule for an order.
//!
//! The global error of a smooth scheme is e(t; h) = c_p(t) hᵖ + c_{p+1}(t) hᵖ⁺¹ + …, with **vector** coefficients (Gragg 1965; Hairer,
//! Nørsett, Wanner, Solving ODEs I, II.8). For runs of the steps h₀, h₀/2, h₀/4, … and an order q
//!
//! ```text
//! (1)  r_k(q) = ‖e_k − 2^q e_{k+1}‖ / ‖e_k‖
//! ```
//!
//! falls like h where q is the order, and tends to |1 − 2^(q − p)| ≥ ½ where it is not. (Steps in another ratio ρ have ρ^q in the place of 2^q.) A term of lower order that a leading one hides makes
//! r rise again. The order is the q whose r falls over two halvings to below [`BELOW`], where every finer r stays below it or is
//! explained by rounding.
//!
//! Runs that converge to one another by the same rule, and not to the truth, have converged elsewhere: they solve another motion.
//!
//! Over a long run errors saturate at steps that anybody takes. The rule is asked at the end first, then at a quarter of the time, and so
//! on: what counts is the latest time at which it decides.

use crate::arithmetic::{DoubleDouble, Real};
use crate::model::Quantity;
use crate::model::copies::CLEAR;
use crate::record::{Ladder, Rung, length};

/// r of the right order falls below this; that of a wrong one tends to ½ or more, five times as much.
pub const BELOW: f64 = 0.1;
/// Falls of r over the last two halvings, at least: half of what h does, on a logarithmic scale, and less for the earlier one.
const FALLS: [f64; 2] = [1.3, 1.2];
/// Fewest runs: two falls of r are seen in three pairs of them.
pub const FEWEST: usize = 4;
/// Fewest runs that are alike.
const FEWEST_ALIKE: usize = 2;
/// A step of at least so many times another is a halving away.
const HALF: f64 = 1.99;
/// Relative difference of two times that are one.
pub const SAME_TIME: f64 = 1e-9;
/// Highest order that is asked for.
pub const HIGHEST: u32 = 12;

/// One run, as the rule reads it.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// h [s].
    pub step: f64,
    /// Steps of the run.
    pub steps: u64,
    /// Error at each sample time, the earliest first: the components of one time together; empty where the run broke.
    pub errors: Vec<f64>,
    /// Largest distance of a copy from the run at each sample time.
    pub rounding: Vec<f64>,
}

impl Run {
    /// A quantity of a rung.
    pub fn of(rung: &Rung, quantity: Quantity, arms: &[[f64; 3]]) -> Run {
        Run {
            step: rung.step,
            steps: rung.steps,
            errors: rung.error(quantity, arms),
            rounding: rung.rounding[quantity].clone(),
        }
    }
}

/// A quantity over runs of halved steps, the coarsest first.
#[derive(Clone, Debug)]
pub struct Asked<'a> {
    /// The runs.
    pub runs: Vec<Run>,
    /// Sample times [s], from a power of a quarter of the last to the last.
    pub times: &'a [f64],
    /// Size of the quantity over the motion, in its unit.
    pub scale: f64,
    /// Half a unit in the last digit that the run prints, relative.
    pub unit: f64,
    /// Uncertainty of the truth, in the unit of the quantity.
    pub uncertainty: f64,
    /// What a step rounds, relative.
    pub of_step: f64,
    /// A larger error per sample time is no term of a series.
    pub largest: f64,
}

impl<'a> Asked<'a> {
    /// Runs in f64 against an exact truth.
    pub fn in_f64(runs: Vec<Run>, times: &'a [f64], scale: f64) -> Asked<'a> {
        Asked {
            runs,
            times,
            scale,
            unit: 0.0,
            uncertainty: 0.0,
            of_step: f64::EPSILON,
            largest: f64::INFINITY,
        }
    }

    /// A quantity of a ladder.
    pub fn of(ladder: &'a Ladder, quantity: Quantity) -> Asked<'a> {
        let runs = ladder.rungs.iter().map(|rung| Run::of(rung, quantity, &ladder.arms)).collect();
        Asked {
            unit: ladder.printed,
            uncertainty: ladder.uncertainty[quantity],
            of_step: if ladder.double_double { DoubleDouble::UNIT } else { f64::EPSILON },
            ..Asked::in_f64(runs, &ladder.times, ladder.sizes[quantity])
        }
    }

    /// What the error of a run must exceed to count, over the root of the number of its first so many sample times: its distance from copies
    /// [`CLEAR`] times, a rounding of the quantity's size for each step, and what is known of digits and truth.
    pub fn floor(&self, run: &Run, samples: usize) -> f64 {
        let of_all = (samples as f64).sqrt();
        let copies = length(&run.rounding[..samples.min(run.rounding.len())]);
        let steps = self.of_step * run.steps as f64 * self.scale;
        (CLEAR * copies).max((steps + self.known()) * of_all)
    }

    /// What an error must exceed for what is known of digits and truth. Half a unit of the last digit is a bound, no estimate: r is to resolve a
    /// tenth of the error.
    pub fn known(&self) -> f64 {
        (self.unit * self.scale + self.uncertainty) / BELOW
    }

    /// The error of a run per sample time: its root mean square over them.
    pub fn error(&self, run: &Run) -> f64 {
        length(&run.errors) / (self.times.len() as f64).sqrt()
    }

    /// The floor of a run per sample time.
    pub fn floor_of(&self, run: &Run) -> f64 {
        let samples = self.times.len();
        self.floor(run, samples) / (samples as f64).sqrt()
    }
}

/// What the rule says of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Decision {
    /// Every error is at its rounding.
    Exact,
    /// The errors fall with this order.
    Order(Order),
    /// The runs converge to another motion than the truth.
    Elsewhere {
        /// Length of the error of the finest run at the time of its largest, in the unit of the quantity.
        error: f64,
        /// The same of the difference of the two finest runs.
        apart: f64,
        /// Step of the finest run [s].
        step: f64,
        /// The latest time that is decided [s].
        until: f64,
    },
    /// Neither.
    Undecided(Doubt),
}

/// An order that is decided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// The order.
    pub order: u32,
    /// log(‖e_k‖ / ‖e_{k+1}‖) over log(h_k / h_{k+1}) of the two runs that decide it.
    pub slope: f64,
    /// r of these runs.
    pub r: f64,
    /// h of the coarser one over that of the finer.
    pub ratio: f64,
    /// Runs up to the finer of the two.
    pub rungs: usize,
    /// Step of the finer one [s].
    pub step: f64,
    /// Error over hᵖ, extrapolated to h → 0: ‖ρ^(p+1) e_{k+1} − e_k‖ / ((ρ − 1) h_kᵖ), ρ = h_k/h_{k+1}, over the square root of the number of
    /// sample times.
    pub constant: f64,
    /// The latest time that is decided [s].
    pub until: f64,
}

impl Order {
    /// Bounds of the slope: the logarithms of 1 ± r to the base of the ratio about it.
    pub fn bounds(&self) -> (f64, f64) {
        let off = |r: f64| f64::from(self.order) - (1.0 + r).ln() / self.ratio.ln();
        (off(self.r), off(-self.r))
    }
}

/// Why nothing is decided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Doubt {
    /// Fewer than four runs of halved steps came to their end.
    FewRuns {
        /// Those that did.
        whole: usize,
    },
    /// Fewer than four errors stand clear of rounding.
    Rounding {
        /// Those that do.
        clear: usize,
    },
    /// r falls for no order; `least` is the smallest at the finest runs, and `order` the one that it belongs to.
    NotAsymptotic {
        /// Its order.
        order: u32,
        /// Its r.
        least: f64,
    },
    /// Rounding leaves more than a tenth of the quantity open.
    Open {
        /// What it leaves, over the size of the quantity.
        rounding: f64,
    },
}

/// Asks the rule at the end, then at a quarter of the time, and so on.
pub fn decide(asked: &Asked) -> Decision {
    let mut at_end = None;
    let mut samples = asked.times.len();
    while samples > 0 {
        match decide_until(asked, samples) {
            found @ (Decision::Order(_) | Decision::Elsewhere { .. }) => return found,
            // An error that is still zero early in the run is no evidence about the end.
            Decision::Exact if at_end.is_none() => return Decision::Exact,
            other => at_end = at_end.or(Some(other)),
        }
        let quarter = 0.25 * asked.times[samples - 1];
        samples = asked.times.partition_point(|time| *time <= quarter * (1.0 + SAME_TIME));
    }
    at_end.unwrap_or(Decision::Undecided(Doubt::FewRuns { whole: 0 }))
}

/// Asks at the first so many sample times.
fn decide_until(asked: &Asked, samples: usize) -> Decision {
    let vectors = Vectors::of(asked, samples);
    if vectors.errors.len() < FEWEST_ALIKE {
        return Decision::Undecided(Doubt::FewRuns { whole: vectors.errors.len() });
    }
    let open = vectors.floors[vectors.floors.len() - 1] / (samples as f64).sqrt() / asked.scale;
    if asked.scale > 0.0 && open > BELOW {
        return Decision::Undecided(Doubt::Open { rounding: open });
    }
    if vectors.errors.iter().zip(&vectors.floors).all(|(error, floor)| length(error) <= *floor) {
        return Decision::Exact;
    }
    if vectors.errors.len() < FEWEST {
        return Decision::Undecided(Doubt::FewRuns { whole: vectors.errors.len() });
    }
    let until = asked.times[samples - 1];
    if let Some(order) = vectors.order(samples, until) {
        return Decision::Order(order);
    }
    vectors.elsewhere(samples, until).unwrap_or_else(|| Decision::Undecided(vectors.doubt()))
}

/// Error vectors of successive runs, each of half the step of the last, and what each must exceed to count.
struct Vectors {
    /// Runs that are left out before the first.
    first: usize,
    steps: Vec<f64>,
    errors: Vec<Vec<f64>>,
    floors: Vec<f64>,
    /// An error of a larger length is no term of a series.
    most: f64,
}

impl Vectors {
    /// Of the runs after the last one that broke.
    fn of(asked: &Asked, samples: usize) -> Vectors {
        let broken =
            |run: &Run| run.errors.len() < asked.times.len() || run.errors.iter().any(|x| !x.is_finite());
        let first = asked.runs.iter().rposition(broken).map_or(0, |last| last + 1);
        let runs = &asked.runs[first..];
        let until = |run: &Run| run.errors[..samples * (run.errors.len() / asked.times.len())].to_vec();
        Vectors {
            first,
            steps: runs.iter().map(|run| run.step).collect(),
            errors: runs.iter().map(until).collect(),
            floors: runs.iter().map(|run| asked.floor(run, samples)).collect(),
            most: asked.largest * (samples as f64).sqrt(),
        }
    }

    /// The same of the differences of successive runs.
    fn differences(&self) -> Vectors {
        let pairs = self.errors.windows(2).map(|pair| combined(&pair[0], -1.0, &pair[1]));
        let floors = self.floors.windows(2).map(|pair| pair[0] + pair[1]);
        Vectors {
            first: 0,
            steps: self.steps[1..].to_vec(),
            errors: pairs.collect(),
            floors: floors.collect(),
            most: self.most,
        }
    }

    /// h of a run over that of the next.
    fn ratio(&self, k: usize) -> f64 {
        self.steps[k] / self.steps[k + 1]
    }

    /// (1) of successive runs for an order, and what rounding makes of it.
    fn ratios(&self, order: u32) -> Vec<(f64, f64)> {
        (0..self.errors.len() - 1)
            .map(|k| {
                let (e, z) = (&self.errors[k..], &self.floors[k..]);
                let (size, power) = (length(&e[0]), self.ratio(k).powi(order as i32));
                (length(&combined(&e[0], -power, &e[1])) / size, (z[0] + power * z[1]) / size)
            })
            .collect()
    }

    /// The order whose r has fallen the lowest.
    fn order(&self, samples: usize, until: f64) -> Option<Order> {
        let of = |order| self.fallen(order).map(|(k, r)| (order, k, r));
        let (order, k, r) = (1..=HIGHEST).filter_map(of).min_by(|a, b| a.2.total_cmp(&b.2))?;
        let (coarse, fine) = (&self.errors[k], &self.errors[k + 1]);
        let ratio = self.ratio(k);
        let next = ratio.powi(order as i32 + 1);
        let limit = length(&combined(coarse, -next, fine)) / (ratio - 1.0) / (samples as f64).sqrt();
        Some(Order {
            order,
            slope: (length(coarse) / length(fine)).ln() / ratio.ln(),
            r,
            ratio,
            rungs: self.first + k + 2,
            step: self.steps[k + 1],
            constant: limit / self.steps[k].powi(order as i32),
            until,
        })
    }

    /// The pair of runs at which r of an order is the least of those that have fallen and stay, and that r.
    fn fallen(&self, order: u32) -> Option<(usize, f64)> {
        let ratios = self.ratios(order);
        // Below a tenth on either side it need not fall any more.
        let falls = |from: usize, to: usize, by: f64| {
            let (before, now) = (ratios[from].0, ratios[to].0);
            now * by < before || now.max(before) < BELOW
        };
        let fell = |k: usize| {
            let halved = |k: usize| (0..k).rfind(|before| self.steps[*before] >= HALF * self.steps[k]);
            let Some((first, middle)) = halved(k).and_then(|middle| Some((halved(middle)?, middle))) else {
                return false;
            };
            ratios[k].0 < BELOW && falls(middle, k, FALLS[0]) && falls(first, middle, FALLS[1])
        };
        let stays = |k: usize| ratios[k + 1..].iter().all(|(r, rounding)| *r < BELOW || r <= rounding);
        let clear = |k: usize| {
            let error = length(&self.errors[k]);
            error > self.floors[k] && error < self.most
        };
        (2..ratios.len())
            .filter(|k| fell(*k) && stays(*k) && clear(*k))
            .map(|k| (k, ratios[k].0))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Runs that converge to one another and not to the truth.
    fn elsewhere(&self, samples: usize, until: f64) -> Option<Decision> {
        let differences = self.differences();
        let (error, apart) = (self.errors.last()?, differences.errors.last()?);
        let together = differences.order(samples, until).is_some()
            || differences.errors.iter().zip(&differences.floors).all(|(d, z)| length(d) <= *z);
        // Below its floor an error may be one of the last bit, the same in every run.
        let clear = length(error) > *self.floors.last()?;
        if !(together && clear && length(apart) < BELOW * length(error)) {
            return None;
        }
        let largest = |vector: &[f64]| vector.chunks(vector.len() / samples).map(length).fold(0.0, f64::max);
        let step = *self.steps.last()?;
        Some(Decision::Elsewhere { error: largest(error), apart: largest(apart), step, until })
    }

    fn doubt(&self) -> Doubt {
        let clear = self.errors.iter().zip(&self.floors).filter(|(e, z)| length(e) > **z).count();
        if clear < FEWEST {
            return Doubt::Rounding { clear };
        }
        let last = |order| self.ratios(order)[..clear - 1].last().map(|(r, _)| (order, *r));
        let (order, least) =
            (1..=HIGHEST).filter_map(last).min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::NAN));
        Doubt::NotAsymptotic { order, least }
    }
}

/// a + factor b.
fn combined(a: &[f64], factor: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + factor * b).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIMES: [f64; 16] =
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0];

    /// Runs of halved steps whose error of one component at time t is that of `error(h, t)`.
    fn runs(error: impl Fn(f64, f64) -> f64) -> Vec<Run> {
        let run = |k: i32| {
            let step = 0.25 * 0.5f64.powi(k);
            let errors = TIMES.iter().map(|t| error(step, *t)).collect();
            Run { step, steps: (16.0 / step) as u64, errors, rounding: vec![1e-15; 16] }
        };
        (0..8).map(run).collect()
    }

    fn decided(runs: &[Run]) -> Decision {
        decide(&Asked::in_f64(runs.to_vec(), &TIMES, 1.0))
    }

    fn order(runs: &[Run]) -> Option<Order> {
        if let Decision::Order(order) = decided(runs) { Some(order) } else { None }
    }

    #[test]
    fn the_leading_power_is_the_order_and_its_coefficient_the_constant() {
        for p in 1..=6 {
            let found = order(&runs(|h, t| 3.0 * h.powi(p) + t * h.powi(p + 1))).expect("an order");
            assert_eq!((found.order, found.until), (p as u32, 16.0));
            let (low, high) = found.bounds();
            assert!(low <= found.slope && found.slope <= high, "{found:?}");
            // The fit has removed the next term and no other is there: the rounding of 8 runs remains.
            assert!((found.constant / 3.0 - 1.0).abs() < 1e-9, "{found:?}");
        }
    }

    #[test]
    fn coefficients_that_cancel_at_one_time_do_not_hide_the_order() {
        // The second-order coefficient changes its sign near t = 8, where the third-order term leads.
        let found = order(&runs(|h, t| (t - 8.01) * h * h + 20.0 * h.powi(3))).expect("an order");
        assert_eq!(found.order, 2);
    }

    #[test]
    fn a_lower_order_that_the_leading_one_hides_is_not_passed_over() {
        // 1e-3 of a first-order term: r of order 2 falls at first, then rises; no order is decided at these steps.
        let found = decided(&runs(|h, _| h * h + 1e-3 * h));
        assert!(matches!(found, Decision::Undecided(Doubt::NotAsymptotic { .. })), "{found:?}");
        assert_eq!(order(&runs(|h, _| h * h + 30.0 * h)).map(|found| found.order), Some(1));
    }

    #[test]
    fn an_error_that_saturates_is_decided_at_an_earlier_time() {
        let saturated = |h: f64, t: f64| if t > 5.0 { (t / h).sin() } else { h * h * (1.0 + h) };
        let found = order(&runs(saturated)).expect("an order");
        assert_eq!((found.order, found.until), (2, 4.0));
    }

    #[test]
    fn runs_that_agree_with_one_another_and_not_with_the_truth_have_converged_elsewhere() {
        for off in [2.0, 1e-4] {
            let found = decided(&runs(|h, _| off + 1e-2 * off * (h * h + h.powi(3))));
            let near = |error: f64| (error / off - 1.0).abs() < 1e-2;
            assert!(matches!(found, Decision::Elsewhere { error, .. } if near(error)), "{found:?}");
        }
        // Exactly the same other motion at every step.
        assert!(matches!(decided(&runs(|_, _| 0.19)), Decision::Elsewhere { .. }));
    }

    #[test]
    fn what_is_at_its_rounding_is_exact_and_what_is_not_finite_is_no_run() {
        assert_eq!(decided(&runs(|h, _| 1e-14 * h)), Decision::Exact);
        assert_eq!(decided(&runs(|_, _| 1e-15)), Decision::Exact);
        // Runs count after the last that broke: here the two finest, and none.
        let coarse = decided(&runs(|h, _| if h > 0.005 { f64::NAN } else { h }));
        assert_eq!(coarse, Decision::Undecided(Doubt::FewRuns { whole: 2 }));
        let fine = decided(&runs(|h, _| if h < 0.1 { f64::NAN } else { h }));
        assert_eq!(fine, Decision::Undecided(Doubt::FewRuns { whole: 0 }));
        assert!(matches!(decided(&[]), Decision::Undecided(Doubt::FewRuns { whole: 0 })));
    }
}
