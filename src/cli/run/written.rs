//! Numbers of every arithmetic with all their digits.

use serde_json::json;

use crate::arithmetic::{DoubleDouble, Real, Single};
use crate::reference::precise::{self, decimal};
use crate::simulate::Arithmetic;

/// An arithmetic whose numbers are written with all their digits.
pub(super) trait Written: Arithmetic {
    /// The number as CSV has it.
    fn text(self) -> String;

    /// The number as JSON has it.
    fn json(self) -> String {
        if self.is_finite() { self.text() } else { "null".to_owned() }
    }
}

impl Written for f64 {
    fn text(self) -> String {
        self.to_string()
    }

    fn json(self) -> String {
        json!(self).to_string()
    }
}

impl Written for Single {
    fn text(self) -> String {
        (self.to_f64() as f32).to_string()
    }
}

impl Written for DoubleDouble {
    fn text(self) -> String {
        let (high, low) = self.parts();
        decimal::write(precise::DoubleDouble::of_sum(high, low), DIGITS)
    }
}

/// Digits of a double-double number.
const DIGITS: usize = 32;
