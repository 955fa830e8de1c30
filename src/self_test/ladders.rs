//! The judge on ladders made up of numbers: what a right judge says of each is known.

use super::noise::Noise;
use crate::gates;
use crate::measure::{Place, QuantityLadder};
use crate::model::Quantity;
use crate::record::Ruling;

/// (h, error, floor), h falling.
pub type Rungs = Vec<(f64, f64, f64)>;

/// A made-up ladder, the order claimed of it, and what is right to say.
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

/// What the gate of the order says of a ladder.
pub fn judge(rungs: &[(f64, f64, f64)], order: u32) -> Ruling {
    gates::rule(&QuantityLadder::of(Quantity::BodyPoint, Place::End, rungs.to_vec(), order), order).0
}

/// `count` rungs of steps that fall by `ratio`.
fn ladder(count: i32, ratio: f64, floor: f64, error: impl Fn(f64) -> f64) -> Rungs {
    (0..count).map(|k| ratio.powi(-k)).map(|h| (h, error(h), floor)).collect()
}

fn halved(error: impl Fn(f64) -> f64) -> Rungs {
    ladder(10, 2.0, 0.0, error)
}

/// A pure power with log-normal noise of this deviation.
fn noisy(seed: u64, count: i32, deviation: f64, error: impl Fn(f64) -> f64) -> Rungs {
    let mut noise = Noise::of(seed);
    ladder(count, 2.0, 0.0, error)
        .into_iter()
        .map(|(h, e, f)| (h, e * (deviation * noise.normal()).exp(), f))
        .collect()
}

/// Four rungs of a pure power, off by up to 1 %.
fn off_by_a_hundredth(power: f64) -> Rungs {
    let off = [1.0, 1.01, 0.99, 1.003];
    ladder(4, 2.0, 0.0, |h| h.powf(power)).iter().zip(off).map(|((h, e, f), off)| (*h, e * off, *f)).collect()
}

/// Two vectors that nearly cancel at h = 0.02: a hᵖ − b hᵖ⁺¹.
fn cancelling(h: f64) -> f64 {
    h.powi(2) * ((1.0 - h / 0.02).powi(2) + 1e-6).sqrt()
}

macro_rules! rows {
    ($($name:literal, $order:literal, $right:ident, $rungs:expr;)*) => {
        /// The ladders.
        pub const TABLE: &[Row] = &[$(Row { name: $name, order: $order, right: Ruling::$right, rungs: || $rungs }),*];
    };
}

rows! {
    "second order", 2, Pass, halved(|h| 3.0 * h * h);
    "second order, steps by 1.1", 2, Pass, ladder(6, 1.1, 0.0, |h| h * h);
    "second order, steps by the root of two", 2, Pass, ladder(8, std::f64::consts::SQRT_2, 0.0, |h| h * h);
    "second order, steps by 10", 2, Pass, ladder(5, 10.0, 0.0, |h| h * h);
    "first order, steps by 4", 2, Fail, ladder(6, 4.0, 0.0, |h| h);
    "fourth order, steps by 1.5", 4, Pass, ladder(8, 1.5, 0.0, |h| h.powi(4));
    "second order, claimed first", 1, Fail, halved(|h| h * h);
    "second order, claimed third", 3, Fail, halved(|h| h * h);
    "order 1.8, claimed second", 2, Fail, halved(|h| h.powf(1.8));
    "order 2.2, claimed second", 2, Fail, halved(|h| h.powf(2.2));
    "order 1.7, claimed second", 2, Fail, halved(|h| h.powf(1.7));
    "errors that do not fall", 1, Fail, halved(|_| 1e-3);
    "errors that grow as h falls", 1, Fail, halved(|h| 1e-6 / h);
    "errors that grow as the square", 2, Fail, halved(|h| 1e-9 / (h * h));
    "first order hidden under second, seen", 2, Fail, ladder(18, 2.0, 0.0, |h| h * h + 0.01 * h);
    "first order hidden under second, on its way", 2, Inconclusive, ladder(9, 2.0, 0.0, |h| h * h + 0.01 * h);
    "second order under a larger third", 2, Inconclusive, ladder(8, 2.0, 0.0, |h| 0.005 * h * h + h.powi(3));
    "second order under a larger third, flat enough for a window", 2, Inconclusive, ladder(7, std::f64::consts::SQRT_2, 0.0, |h| 0.05 * h * h + h.powi(3));
    "third order, claimed second, over a short range", 2, Fail, ladder(7, std::f64::consts::SQRT_2, 0.0, |h| h.powi(3) + 0.05 * h.powi(4));
    "second order under a larger third, seen", 2, Pass, ladder(16, 2.0, 0.0, |h| 0.005 * h * h + h.powi(3));
    "third order, claimed second, with a fourth", 2, Fail, halved(|h| h.powi(3) + 0.2 * h.powi(4));
    "two terms that cancel at a fine step", 2, Inconclusive, ladder(7, 2.0, 0.0, cancelling);
    "two terms that cancel at a coarse step", 2, Pass, ladder(14, 2.0, 0.0, cancelling);
    "fourth order down to a floor", 4, Pass, ladder(10, 2.0, 1e-9, |h| h.powi(4) + 1e-9);
    "second order at the floor after three rungs", 2, Inconclusive, ladder(10, 2.0, 3e-3, |h| h * h + 3e-3);
    "rounding that grows as the step falls", 4, Pass, (0..14).map(|k| 0.5f64.powi(k)).map(|h| (h, h.powi(4) + 1e-12 / h, 1e-12 / h)).collect();
    "a floor that was not told", 4, Fail, ladder(14, 2.0, 0.0, |h| h.powi(4) + 1e-9);
    "all at the floor", 2, NotApplicable, ladder(10, 2.0, 1e-15, |_| 0.0);
    "a hump before the asymptotic range", 2, Pass, ladder(14, 2.0, 0.0, |h| h * h / (1.0 + (h / 0.05).powi(3)));
    "a plateau before the asymptotic range", 2, Pass, ladder(14, 2.0, 0.0, |h| h * h / (h * h + 1e-3));
    "third order at first, then first", 3, Fail, ladder(20, 2.0, 0.0, |h| h.powi(3) + 1e-4 * h);
    "NaN at the finest steps", 2, Broken, halved(|h| if h < 0.01 { f64::NAN } else { h * h });
    "NaN at every step", 2, Broken, halved(|_| f64::NAN);
    "infinite at the coarse steps", 2, Pass, halved(|h| if h > 0.2 { f64::INFINITY } else { h * h });
    "noise of a hundredth", 2, Pass, noisy(1, 10, 0.01, |h| h * h);
    "noise of a twentieth", 2, Inconclusive, noisy(11, 4, 0.05, |h| h * h);
    "order 2.12 with errors of 1 %", 2, Inconclusive, off_by_a_hundredth(2.12);
    "order 1.88 with errors of 1 %", 2, Inconclusive, off_by_a_hundredth(1.88);
    "four rungs after an infinite one", 2, Pass, ladder(5, 2.0, 0.0, |h| if h == 1.0 { f64::INFINITY } else { h * h });
    "an error that dips under its floor near the end", 2, Pass, ladder(10, 2.0, 1e-9, |h| if h == 0.5f64.powi(7) { 0.0 } else { h * h });
    "noise of a third", 2, Inconclusive, noisy(3, 10, 0.33, |h| h * h);
    "first order with noise of a hundredth", 2, Fail, noisy(4, 10, 0.01, |h| h);
    "every other error doubled", 1, Inconclusive, halved(|h| if (h.log2() as i64) % 2 == 0 { h } else { 2.0 * h });
    "the coarsest rung alone is good", 2, Fail, halved(|h| if h == 1.0 { 4.0 } else { h });
    "four rungs of second order", 2, Pass, ladder(4, 2.0, 0.0, |h| h * h);
    "three rungs of second order", 2, Inconclusive, ladder(3, 2.0, 0.0, |h| h * h);
    "no rungs", 2, Broken, Vec::new();
    "small second order", 2, Pass, halved(|h| 1e-9 * h * h);
    "small first order, claimed second", 2, Fail, halved(|h| 1e-9 * h);
    "constant error below 1e-6, claimed second", 2, Fail, halved(|_| 1e-8);
}
