//! Taylor coefficients of a right-hand side: a tape of its operations, run once an order.
//!
//! With aₖ the coefficient of sᵏ in a:
//!
//! ```text
//! (1) c = a b       cₖ = Σ_{j=0..k} aⱼ bₖ₋ⱼ
//! (2) c = a/b       cₖ = (aₖ − Σ_{j=1..k} bⱼ cₖ₋ⱼ) / b₀
//! (3) c = √a        cₖ = (aₖ − Σ_{j=1..k−1} cⱼ cₖ₋ⱼ) / (2 c₀)
//! (4) y' = f        yₖ₊₁ = fₖ / (k + 1)
//! ```
//!
//! Source: jorba2005, section 2; (1) is summed as in ogita2005.

use super::double_double::{DoubleDouble, split, two_sum};
use super::sheet::Operation;

/// A coefficient, its first part split for exact products.
#[derive(Clone, Copy, Debug, Default)]
struct Coefficient {
    high: f64,
    low: f64,
    upper: f64,
    lower: f64,
}

impl Coefficient {
    #[inline]
    fn of(value: DoubleDouble) -> Coefficient {
        let (upper, lower) = split(value.high);
        Coefficient { high: value.high, low: value.low, upper, lower }
    }

    #[inline]
    fn value(&self) -> DoubleDouble {
        DoubleDouble { high: self.high, low: self.low }
    }
}

/// Σ aⱼ b₋ⱼ: exact products, their sum and its errors kept apart (ogita2005).
fn convolution(a: &[Coefficient], b: &[Coefficient]) -> DoubleDouble {
    let (mut sum, mut rest) = (0.0, 0.0);
    for (a, b) in a.iter().zip(b.iter().rev()) {
        let product = a.high * b.high;
        let error =
            ((a.upper * b.upper - product) + a.upper * b.lower + a.lower * b.upper) + a.lower * b.lower;
        let (total, lost) = two_sum(sum, product);
        sum = total;
        rest += (error + lost) + (a.high * b.low + a.low * b.high);
    }
    DoubleDouble::of_sum(sum, rest)
}

/// A right-hand side, ready to be developed.
#[derive(Clone, Debug)]
pub(super) struct Tape {
    pub operations: Vec<Operation>,
    /// Places that are worked out, in order.
    pub steps: Vec<usize>,
    /// Places of the variables.
    pub variables: Vec<usize>,
    /// Places of their rates, or of what is shown.
    pub values: Vec<usize>,
}

impl Tape {
    /// Operations that cost a sum over all orders.
    pub(super) fn products(&self) -> usize {
        let is_product = |index: &&usize| {
            let operation = self.operations[**index];
            matches!(operation, Operation::Product(..) | Operation::Quotient(..) | Operation::Root(_))
        };
        self.steps.iter().filter(is_product).count()
    }

    /// Room for coefficients up to `order`.
    pub(super) fn series(&self, order: usize) -> Series {
        let length = order + 1;
        let coefficients = vec![Coefficient::default(); self.operations.len() * length];
        Series { tape: self.clone(), length, coefficients }
    }

    /// The values of the tape in a state.
    pub(super) fn values(&self, state: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut series = self.series(0);
        series.develop(state);
        self.values.iter().map(|index| series.at(*index, 0)).collect()
    }
}

/// Taylor coefficients of everything on a tape.
pub(super) struct Series {
    tape: Tape,
    /// Coefficients of each operation: the order, and one.
    length: usize,
    coefficients: Vec<Coefficient>,
}

impl Series {
    /// Develops the solution that passes through `state`.
    pub(super) fn develop(&mut self, state: &[DoubleDouble]) {
        for (place, value) in state.iter().enumerate().take(self.tape.variables.len()) {
            self.set(self.tape.variables[place], 0, *value);
        }
        for k in 0..self.length {
            for step in 0..self.tape.steps.len() {
                let index = self.tape.steps[step];
                let operation = self.tape.operations[index];
                if operation != Operation::Variable {
                    let value = self.coefficient(index, &operation, k);
                    self.set(index, k, value);
                }
            }
            if k + 1 < self.length {
                self.raise(k);
            }
        }
    }

    /// (4)
    fn raise(&mut self, k: usize) {
        let divisor = DoubleDouble::from((k + 1) as f64);
        for variable in 0..self.tape.variables.len().min(self.tape.values.len()) {
            let value = self.at(self.tape.values[variable], k) / divisor;
            self.set(self.tape.variables[variable], k + 1, value);
        }
    }

    /// All coefficients of a place on the tape.
    pub(super) fn coefficients(&self, index: usize) -> Vec<DoubleDouble> {
        (0..self.length).map(|k| self.at(index, k)).collect()
    }

    #[inline]
    fn set(&mut self, index: usize, k: usize, value: DoubleDouble) {
        self.coefficients[index * self.length + k] = Coefficient::of(value);
    }

    #[inline]
    fn at(&self, index: usize, k: usize) -> DoubleDouble {
        self.coefficients[index * self.length + k].value()
    }

    /// Coefficients from `first` to `last` of a place on the tape.
    #[inline]
    fn part(&self, index: usize, first: usize, last: usize) -> &[Coefficient] {
        &self.coefficients[index * self.length + first..=index * self.length + last]
    }

    fn coefficient(&self, index: usize, operation: &Operation, k: usize) -> DoubleDouble {
        match *operation {
            Operation::Constant(value) if k == 0 => value,
            Operation::Constant(_) => DoubleDouble::ZERO,
            Operation::Variable => self.at(index, k),
            Operation::Sum(a, b) => self.at(a, k) + self.at(b, k),
            Operation::Difference(a, b) => self.at(a, k) - self.at(b, k),
            Operation::Scaled(a, factor) => self.at(a, k) * factor,
            Operation::Product(a, b) => convolution(self.part(a, 0, k), self.part(b, 0, k)), // (1)
            Operation::Quotient(a, b) if k == 0 => self.at(a, 0) / self.at(b, 0),
            Operation::Quotient(a, b) => {
                let before = convolution(self.part(b, 1, k), self.part(index, 0, k - 1));
                (self.at(a, k) - before) / self.at(b, 0) // (2)
            }
            Operation::Root(a) if k == 0 => self.at(a, 0).sqrt(),
            Operation::Root(a) => {
                let before = if k == 1 {
                    DoubleDouble::ZERO
                } else {
                    convolution(self.part(index, 1, k - 1), self.part(index, 1, k - 1))
                };
                (self.at(a, k) - before) / self.at(index, 0).scaled(2.0) // (3)
            }
        }
    }

    /// The variables at `s`, by Horner's rule.
    pub(super) fn state(&self, s: DoubleDouble) -> Vec<DoubleDouble> {
        let value = |index: &usize| {
            (0..self.length).rev().fold(DoubleDouble::ZERO, |sum, k| sum * s + self.at(*index, k))
        };
        self.tape.variables.iter().map(value).collect()
    }

    /// Largest coefficient `k` of a variable, each over its size.
    pub(super) fn largest(&self, k: usize, sizes: &[f64]) -> f64 {
        let over_size = |(index, size): (&usize, &f64)| self.at(*index, k).high.abs() / size;
        self.tape.variables.iter().zip(sizes).map(over_size).fold(0.0, f64::max)
    }
}
