//! Where a polynomial changes its sign.
//!
//! An interval of half-width r about m is
//!
//! ```text
//! (1) without a root        where |p(m)| > |p'(m)| r + B r²/2,  B ≥ |p''|
//! (2) with one at most      where |p'(m)| > B r: p is monotonic, and its signs at the ends tell
//! (3) below all rounding    where |p(m)| + |p'(m)| r + B r²/2 is negligible
//! ```
//!
//! and halved until it is one of them: no pair of roots goes unseen but one between which p stays below (3). A root
//! is found by Newton's method within the halves of its interval.

use super::double_double::DoubleDouble;

/// Steps of Newton's method or halvings to the last bit of a root.
const MOST_STEPS: usize = 220;

/// A polynomial on an interval from 0.
pub(super) struct Polynomial {
    /// From that of s⁰ on.
    coefficients: Vec<DoubleDouble>,
    end: f64,
    /// B of (1) to (3).
    curvature: f64,
    /// What is no more than rounding.
    negligible: f64,
}

impl Polynomial {
    /// Without the factors s that it has, of which a `zero_at_start` no larger than that may hide the first: what is left
    /// is not zero at 0. Nothing where all is zero.
    pub(super) fn reduced(
        coefficients: &[DoubleDouble],
        zero_at_start: f64,
        end: f64,
        negligible: f64,
    ) -> Option<Polynomial> {
        let skipped = usize::from(coefficients[0].high.abs() <= zero_at_start);
        let first = skipped + coefficients[skipped..].iter().position(|c| c.high != 0.0)?;
        let negligible = negligible / end.max(1.0).powi(first as i32);
        let coefficients = coefficients[first..].to_vec();
        let bend =
            |(k, c): (usize, &DoubleDouble)| (k * (k - 1)) as f64 * c.high.abs() * end.powi(k as i32 - 2);
        let curvature = coefficients.iter().enumerate().skip(2).map(bend).sum();
        Some(Polynomial { coefficients, end, curvature, negligible })
    }

    /// Whether its terms are numbers of f64: (1) to (3) decide nothing where they overflow.
    pub(super) fn is_finite(&self) -> bool {
        let coefficients = self.coefficients.iter().all(|c| c.is_finite());
        coefficients && self.curvature.is_finite() && self.negligible.is_finite()
    }

    /// Whether it is above zero just after 0.
    pub(super) fn starts_positive(&self) -> bool {
        self.coefficients[0].high > 0.0
    }

    /// Σ |cₖ| sᵏ: what it is a sum of.
    pub(super) fn size(coefficients: &[DoubleDouble], s: f64) -> f64 {
        coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c.high.abs())
    }

    /// Where it changes its sign, in order.
    pub(super) fn crossings(&self) -> Vec<DoubleDouble> {
        let mut found = Vec::new();
        self.look(DoubleDouble::ZERO, self.end.into(), &mut found);
        found
    }

    fn at(&self, s: DoubleDouble) -> DoubleDouble {
        self.coefficients.iter().rev().fold(DoubleDouble::ZERO, |sum, c| sum * s + *c)
    }

    fn slope(&self, s: f64) -> f64 {
        let terms = self.coefficients.iter().enumerate().skip(1).rev();
        terms.fold(0.0, |sum, (k, c)| sum * s + k as f64 * c.high)
    }

    fn look(&self, start: DoubleDouble, end: DoubleDouble, found: &mut Vec<DoubleDouble>) {
        let middle = (start + end).scaled(0.5);
        let half = 0.5 * (end - start).high;
        let (value, slope) = (self.at(middle).high.abs(), self.slope(middle.high).abs());
        let bend = 0.5 * self.curvature * half * half;
        let tiny = half <= DoubleDouble::ROUNDING * self.end;
        if value > slope * half + bend || value + slope * half + bend <= self.negligible || tiny {
            return; // (1), (3)
        }
        if slope > self.curvature * half {
            if self.is_positive(start) != self.is_positive(end) {
                found.push(self.root(start, end)); // (2)
            }
            return;
        }
        self.look(start, middle, found);
        self.look(middle, end, found);
    }

    fn is_positive(&self, s: DoubleDouble) -> bool {
        self.at(s).high >= 0.0
    }

    /// The root between two places of which p has different signs.
    fn root(&self, mut start: DoubleDouble, mut end: DoubleDouble) -> DoubleDouble {
        let rising = self.is_positive(end);
        let mut s = (start + end).scaled(0.5);
        for _ in 0..MOST_STEPS {
            let value = self.at(s);
            if value.high == 0.0 {
                return s;
            }
            if (value.high > 0.0) == rising {
                end = s
            } else {
                start = s
            }
            let next = s - value / DoubleDouble::from(self.slope(s.high));
            let next = if next > start && next < end { next } else { (start + end).scaled(0.5) };
            let change = (next - s).high.abs();
            s = next;
            if change <= DoubleDouble::ROUNDING * s.high {
                return s;
            }
        }
        s
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Π (s − root), by multiplying out.
    fn with_roots(roots: &[f64]) -> Vec<DoubleDouble> {
        let mut product = vec![DoubleDouble::ONE];
        for root in roots {
            let mut next = vec![DoubleDouble::ZERO; product.len() + 1];
            for (k, c) in product.iter().enumerate() {
                next[k + 1] += *c;
                next[k] += -(*c * DoubleDouble::from(*root));
            }
            product = next;
        }
        product
    }

    #[test]
    fn every_change_of_sign_is_found_to_the_last_bits_and_no_other() {
        let roots = [0.125, 0.3, 0.300_001, 0.75, 1.5, -0.5];
        let polynomial = Polynomial::reduced(&with_roots(&roots), 0.0, 1.0, 1e-29).expect("a polynomial");
        let found = polynomial.crossings();
        assert_eq!(found.len(), 4, "{found:?}");
        for (found, root) in found.iter().zip(roots) {
            let error = (*found - root.into()).high.abs();
            // A root is off by the rounding of p over its slope: 1e-32 / 2e-7 for the close pair.
            assert!(error < 1e-24, "{root}: {error:e}");
        }
        assert!(!polynomial.starts_positive());
    }

    #[test]
    fn a_touch_is_no_crossing_and_roots_at_the_start_are_left_out() {
        let touch = Polynomial::reduced(&with_roots(&[0.5, 0.5]), 0.0, 1.0, 1e-29).expect("a polynomial");
        assert!(touch.crossings().len().is_multiple_of(2) && touch.starts_positive());
        // s (s − ½), its lowest coefficient off by a rounding.
        let mut coefficients = with_roots(&[0.0, 0.5]);
        coefficients[0] = DoubleDouble::from(3e-32);
        let polynomial = Polynomial::reduced(&coefficients, 1e-31, 1.0, 1e-29).expect("a polynomial");
        assert_eq!(polynomial.crossings(), [DoubleDouble::from(0.5)]);
        assert!(!polynomial.starts_positive());
        let flat = Polynomial::reduced(&with_roots(&[0.0, 0.0, 0.0, 0.25]), 0.0, 1.0, 1e-29);
        assert_eq!(flat.expect("a polynomial").crossings(), [DoubleDouble::from(0.25)]);
        assert!(Polynomial::reduced(&[DoubleDouble::ZERO; 5], 0.0, 1.0, 1e-29).is_none());
    }

    #[test]
    fn terms_that_overflow_are_no_polynomial_and_terms_that_underflow_are_rounding() {
        let of = |cubic: f64, end| {
            let coefficients = [1.0, -1.0, 0.5, cubic].map(DoubleDouble::from);
            Polynomial::reduced(&coefficients, 0.0, end, 1e-29).expect("a polynomial")
        };
        assert!(of(1.0, 1.0).is_finite() && !of(f64::NAN, 1.0).is_finite() && !of(1e200, 1e150).is_finite());
        let smallest = [f64::from_bits(1); 5].map(DoubleDouble::from);
        let tiny = Polynomial::reduced(&smallest, 0.0, 0.25, 0.0).expect("a polynomial");
        assert_eq!(tiny.crossings(), []);
    }
}
