//! The rule of orders on ladders made up of numbers: the right verdict on each is known.

use super::noise::Noise;
use crate::measure::{Asked, Decision, Run, decide};
use crate::record::Ruling;

/// (h, error, rounding), each h half of the one before. An error has a sign.
pub type Rungs = Vec<(f64, f64, f64)>;

/// A made-up ladder, the order claimed of it in a generic scene, and what is right to say.
pub struct Row {
    /// What it is, in words.
    pub name: &'static str,
    /// Claimed order.
    pub order: u32,
    /// The right verdict.
    pub right: Ruling,
    rungs: fn() -> Rungs,
}

impl Row {
    /// The ladder.
    pub fn rungs(&self) -> Rungs {
        (self.rungs)()
    }
}

/// What the rule of orders says of a ladder.
pub fn judge(rungs: &[(f64, f64, f64)], order: u32) -> Ruling {
    if rungs.last().is_none_or(|(_, error, _)| !error.is_finite()) {
        return Ruling::Broken;
    }
    let run = |(step, error, rounding): &(f64, f64, f64)| Run {
        step: *step,
        steps: (1.0 / step).round() as u64,
        errors: vec![*error],
        rounding: vec![*rounding],
    };
    let runs = rungs.iter().map(run).collect();
    match decide(&Asked::in_f64(runs, &[1.0], 0.0)) {
        Decision::Exact => Ruling::NotApplicable,
        Decision::Order(found) if found.order == order => Ruling::Pass,
        Decision::Order(_) | Decision::Elsewhere { .. } => Ruling::Fail,
        Decision::Undecided(_) => Ruling::Inconclusive,
    }
}

/// `count` rungs of halved steps.
fn ladder(count: i32, rounding: f64, error: impl Fn(f64) -> f64) -> Rungs {
    (0..count).map(|k| 0.5f64.powi(k)).map(|h| (h, error(h), rounding)).collect()
}

fn halved(error: impl Fn(f64) -> f64) -> Rungs {
    ladder(10, 0.0, error)
}

/// A pure power with log-normal noise of this deviation.
fn noisy(seed: u64, count: i32, deviation: f64, error: impl Fn(f64) -> f64) -> Rungs {
    let mut noise = Noise::of(seed);
    ladder(count, 0.0, error)
        .into_iter()
        .map(|(h, e, f)| (h, e * (deviation * noise.normal()).exp(), f))
        .collect()
}

macro_rules! rows {
    ($($name:literal, $order:literal, $right:ident, $rungs:expr;)*) => {
        /// The ladders.
        pub const TABLE: &[Row] = &[$(Row { name: $name, order: $order, right: Ruling::$right, rungs: || $rungs }),*];
    };
}

rows! {
    "second order", 2, Pass, halved(|h| 3.0 * h * h);
    "second order of the other sign", 2, Pass, halved(|h| -3.0 * h * h);
    "first order, claimed second", 2, Fail, halved(|h| h);
    "fourth order with a fifth", 4, Pass, halved(|h| h.powi(4) + h.powi(5));
    "second order, claimed first", 1, Fail, halved(|h| h * h);
    "second order, claimed third", 3, Fail, halved(|h| h * h);
    "order 1.8, which is none", 2, Inconclusive, halved(|h| h.powf(1.8));
    "order 2.2, which is none", 2, Inconclusive, halved(|h| h.powf(2.2));
    "order 1.7, which is none", 2, Inconclusive, halved(|h| h.powf(1.7));
    "errors that do not fall", 1, Fail, halved(|_| 1e-3);
    "errors that come to another limit", 2, Fail, halved(|h| 0.3 + h * h);
    "errors that come to a small one", 2, Fail, ladder(16, 0.0, |h| 1e-4 + h * h);
    "errors that grow as h falls", 1, Inconclusive, halved(|h| 1e-6 / h);
    "errors that grow as the square", 2, Inconclusive, halved(|h| 1e-9 / (h * h));
    "first order hidden under second, seen", 2, Fail, ladder(18, 0.0, |h| h * h + 0.01 * h);
    "first order hidden under second, on its way", 2, Inconclusive, ladder(9, 0.0, |h| h * h + 0.01 * h);
    "second order under a larger third", 2, Inconclusive, ladder(7, 0.0, |h| 0.005 * h * h + h.powi(3));
    "second order under a larger third, seen", 2, Pass, ladder(16, 0.0, |h| 0.005 * h * h + h.powi(3));
    "third order, claimed second, with a fourth", 2, Fail, halved(|h| h.powi(3) + 0.2 * h.powi(4));
    "two terms that cancel at a fine step", 2, Inconclusive, ladder(7, 0.0, |h| h * h * (1.0 - h / 0.02));
    "two terms that cancel at a coarse step", 2, Pass, ladder(14, 0.0, |h| h * h * (1.0 - h / 0.02));
    "fourth order down to rounding", 4, Pass, ladder(10, 1e-10, |h| h.powi(4) + 1e-10);
    "second order at rounding after three rungs", 2, Inconclusive, ladder(10, 3e-3, |h| h * h + 3e-3);
    "rounding that grows as the step falls", 4, Pass, (0..14).map(|k| 0.5f64.powi(k)).map(|h| (h, h.powi(4) + 1e-13 / h, 1e-13 / h)).collect();
    "a limit that is not known for rounding", 4, Fail, ladder(14, 0.0, |h| h.powi(4) + 1e-9);
    "all at rounding", 2, NotApplicable, ladder(10, 1e-15, |_| 1e-15);
    "no error at any step", 2, NotApplicable, ladder(10, 1e-15, |_| 0.0);
    "a hump before the asymptotic range", 2, Pass, ladder(14, 0.0, |h| h * h / (1.0 + (h / 0.05).powi(3)));
    "a plateau before the asymptotic range", 2, Pass, ladder(14, 0.0, |h| h * h / (h * h + 1e-3));
    "third order at first, then first", 3, Fail, ladder(20, 0.0, |h| h.powi(3) + 1e-4 * h);
    "NaN at the finest steps", 2, Broken, halved(|h| if h < 0.01 { f64::NAN } else { h * h });
    "infinite at the finest step", 2, Broken, halved(|h| if h < 0.002 { f64::INFINITY } else { h * h });
    "NaN in the middle", 2, Pass, halved(|h| if h == 0.125 { f64::NAN } else { h * h });
    "NaN at every step", 2, Broken, halved(|_| f64::NAN);
    "infinite at the coarse steps", 2, Pass, halved(|h| if h > 0.2 { f64::INFINITY } else { h * h });
    "noise of a hundredth", 2, Pass, noisy(1, 10, 0.01, |h| h * h);
    "noise of a third", 2, Inconclusive, noisy(3, 10, 0.33, |h| h * h);
    "first order with noise of a hundredth", 2, Fail, noisy(4, 10, 0.01, |h| h);
    "every other error doubled", 1, Inconclusive, halved(|h| if (h.log2() as i64) % 2 == 0 { h } else { 2.0 * h });
    "every other error of the other sign", 1, Inconclusive, halved(|h| if (h.log2() as i64) % 2 == 0 { h } else { -h });
    "every other pair of errors of the other sign", 2, Inconclusive, halved(|h| if (h.log2() as i64) / 2 % 2 == 0 { h * h } else { -h * h });
    "the coarsest rung alone is good", 2, Fail, halved(|h| if h == 1.0 { 4.0 } else { h });
    "four rungs of second order", 2, Pass, ladder(4, 0.0, |h| h * h);
    "three rungs of second order", 2, Inconclusive, ladder(3, 0.0, |h| h * h);
    "no rungs", 2, Broken, Vec::new();
    "small second order", 2, Pass, halved(|h| 1e-9 * h * h);
    "small first order, claimed second", 2, Fail, halved(|h| 1e-9 * h);
    "constant error below 1e-6, claimed second", 2, Fail, halved(|_| 1e-8);
}
