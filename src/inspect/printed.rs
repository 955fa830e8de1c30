//! A number as it is printed: its value, and what its digits can hide.

/// A number of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Printed {
    /// The value; NaN where the file says so.
    pub value: f64,
    /// Half a unit of the last printed digit, in the unit of the value; 0 for a printed zero and for a computed number.
    pub half_unit: f64,
    /// The text; empty for a computed number.
    pub text: String,
}

impl Printed {
    /// Reads a number; `None` where the text is none.
    pub fn parse(text: &str) -> Option<Printed> {
        let value: f64 = text.parse().ok()?;
        let half_unit = if value == 0.0 || !value.is_finite() { 0.0 } else { half_unit_of(text) };
        Some(Printed { value, half_unit, text: text.to_owned() })
    }

    /// A number that no file prints.
    pub fn computed(value: f64) -> Printed {
        Printed { value, half_unit: 0.0, text: String::new() }
    }

    /// The mantissa and the exponent as printed.
    pub fn parts(&self) -> (&str, &str) {
        self.text.split_once(['e', 'E']).unwrap_or((&self.text, "0"))
    }

    /// Digits from the first that is not zero on.
    pub fn significant_digits(&self) -> usize {
        let digits: String = self.parts().0.chars().filter(char::is_ascii_digit).collect();
        digits.trim_start_matches('0').len()
    }
}

fn half_unit_of(text: &str) -> f64 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent: i64 = exponent.parse().unwrap_or(0);
    let decimals = i64::try_from(decimals).unwrap_or(i64::MAX);
    // Read as text, a power of ten is exact to half a unit of f64.
    format!("0.5e{}", exponent.saturating_sub(decimals)).parse().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_unit_of_the_last_digit() {
        for (text, half) in [
            ("3", 0.5),
            ("0.05", 5e-3),
            ("1676359E-6", 5e-7),
            ("1.28e8", 5e5),
            ("0", 0.0),
            ("-31.0e-6", 5e-8),
        ] {
            assert_eq!(Printed::parse(text).expect(text).half_unit, half, "{text}");
        }
        assert!(Printed::parse("nan").expect("NaN").value.is_nan());
        assert_eq!(Printed::parse("1e-6").expect("a number").significant_digits(), 1);
        assert!(Printed::parse("${mass}").is_none());
    }
}
