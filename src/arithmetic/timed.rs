//! Numbers that know when they would be ready: the longest chain of a formula, in a machine that waits for nothing but results.
//!
//! Every result is ready one latency after the last of its operands. What a step's result waits for since the result of the step
//! before is a lower bound of its time, whatever else the machine does at once. Operations are counted too: so many over the rate
//! of the machine is the other bound. A comparison, a change of sign and a constant cost nothing: branches are predicted.

use std::cell::Cell;
use std::cmp::Ordering;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

use super::field::field;
use super::{Number, Real, Registers, Row, Work, series};

/// Latencies of a machine [ns].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Latencies {
    /// A sum or a difference.
    pub sum: f64,
    /// A product.
    pub product: f64,
    /// A quotient.
    pub quotient: f64,
    /// A square root.
    pub root: f64,
    /// Sine and cosine together, an inverse tangent, an exponential or a logarithm.
    pub function: f64,
}

thread_local! {
    static LATENCIES: Cell<Latencies> = const { Cell::new(Latencies {
        sum: 1.0, product: 1.0, quotient: 1.0, root: 1.0, function: 1.0,
    }) };
    static OPERATIONS: Cell<u64> = const { Cell::new(0) };
}

impl Latencies {
    /// Makes them those of this thread.
    pub fn apply(self) {
        LATENCIES.set(self);
    }
}

/// Sums and products on this thread so far.
pub fn operations() -> u64 {
    OPERATIONS.get()
}

/// An f64 and the time at which it is ready [ns].
#[derive(Clone, Copy, Debug, Default)]
pub struct Timed {
    value: f64,
    ready: f64,
}

impl PartialEq for Timed {
    fn eq(&self, other: &Timed) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Timed {
    fn partial_cmp(&self, other: &Timed) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl Timed {
    const ZERO: Timed = Timed::constant(0.0);
    const ONE: Timed = Timed::constant(1.0);
    const PI: Timed = Timed::constant(std::f64::consts::PI);
    const LN_2: Timed = Timed::constant(std::f64::consts::LN_2);

    /// Ready from the start.
    pub const fn constant(value: f64) -> Timed {
        Timed { value, ready: 0.0 }
    }

    /// When it is ready [ns].
    pub fn ready(self) -> f64 {
        self.ready
    }

    fn after(self, other: Timed, value: f64, latency: fn(Latencies) -> f64) -> Timed {
        OPERATIONS.set(OPERATIONS.get() + 1);
        Timed { value, ready: self.ready.max(other.ready) + latency(LATENCIES.get()) }
    }

    fn plus(self, other: Timed) -> Timed {
        self.after(other, self.value + other.value, |l| l.sum)
    }

    fn negative(self) -> Timed {
        Timed { value: -self.value, ..self }
    }

    fn times(self, other: Timed) -> Timed {
        self.after(other, self.value * other.value, |l| l.product)
    }

    fn times_f64(self, other: f64) -> Timed {
        self.times(Timed::constant(other))
    }

    fn over(self, other: Timed) -> Timed {
        self.after(other, self.value / other.value, |l| l.quotient)
    }

    fn root(self) -> Timed {
        self.after(self, self.value.sqrt(), |l| l.root)
    }

    fn nearest(self) -> Timed {
        Timed { value: self.value.round(), ..self }
    }

    fn down(self) -> Timed {
        Timed { value: self.value.floor(), ..self }
    }

    fn function(self, value: f64) -> Timed {
        self.after(self, value, |l| l.function)
    }

    fn sine_and_cosine(self) -> (Timed, Timed) {
        (self.function(self.value.sin()), self.function(self.value.cos()))
    }

    fn exponential_less_one(self) -> Timed {
        self.function(self.value.exp_m1())
    }

    fn logarithm(self) -> Timed {
        self.function(self.value.ln())
    }

    fn angle(self, other: Timed) -> Timed {
        self.after(other, self.value.atan2(other.value), |l| l.function)
    }
}

impl Real for Timed {
    const NAME: &'static str = "timed";
    const UNIT: f64 = f64::UNIT;
    const LARGEST_EXCESS: f64 = f64::LARGEST_EXCESS;
    const PLAIN_SQUARES: [f64; 2] = f64::PLAIN_SQUARES;

    fn of(value: f64) -> Timed {
        Timed::constant(value)
    }

    fn to_f64(self) -> f64 {
        self.value
    }

    fn turn_coefficients(y: Timed) -> (Timed, Timed) {
        series::coefficients(y)
    }

    fn by_eight<W: Work<Timed>>(_: Registers, work: W) -> W::Output {
        work.with_rows::<Timed>(())
    }
}

field!(Timed);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_is_ready_one_latency_after_the_last_of_its_operands() {
        Latencies { sum: 3.0, product: 4.0, quotient: 13.0, root: 20.0, function: 50.0 }.apply();
        let before = operations();
        let (a, b) = (Timed::of(2.0), Timed::of(3.0));
        let product = a * b;
        let sum = product + a;
        assert_eq!((product.ready(), sum.ready(), sum.to_f64()), (4.0, 7.0, 8.0));
        assert_eq!((sum / b).root().ready(), 7.0 + 13.0 + 20.0);
        assert_eq!((-sum).ready(), 7.0);
        assert_eq!(operations() - before, 4);
    }
}
