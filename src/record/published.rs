//! Figures that others published, each beside what Polhode gives for it.

use serde::{Deserialize, Serialize};

/// A published figure, number by number, and what Polhode gives.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PublishedRow {
    /// The problem.
    pub problem: String,
    /// Scene that it is run in.
    pub scene: String,
    /// Where the figure was published.
    pub source: String,
    /// What is measured, with the time and the components.
    pub quantity: String,
    /// `truth`, or the scheme and its steps.
    pub by: String,
    /// Unit of the numbers; `1` for pure numbers.
    pub unit: String,
    /// The numbers as they are printed.
    pub published: Vec<String>,
    /// The numbers as Polhode gives them, in the digits that must hold.
    pub ours: Vec<String>,
    /// The numbers as they were computed now.
    pub computed: Vec<f64>,
    /// Published minus ours.
    pub difference: Vec<f64>,
    /// Largest difference that agrees.
    pub held_to: Vec<f64>,
    /// Where that limit comes from.
    pub limit: String,
    /// What the comparison says.
    pub agreement: Agreement,
    /// How sure the published figure is.
    pub sureness: Sureness,
    /// Whether a number that is off is the run of a scheme, and so carries its truncation error.
    #[serde(default)]
    pub truncated: bool,
    /// A remark, or empty.
    pub note: String,
}

/// What the comparison of a published figure says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Agreement {
    /// Every number agrees within its limit.
    #[default]
    Agrees,
    /// The published number is farther from the truth than its digits or its source say.
    PublishedIsOff,
    /// The published number comes from another algorithm than ours.
    OtherAlgorithm,
    /// The published number was read off a figure, and agrees within the reading.
    ReadOffAFigure,
}

/// How sure a published figure is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Sureness {
    /// The number itself stands in the file or data set.
    #[default]
    A,
    /// It was read off a figure of the source: two digits.
    B,
    /// It follows from text of the source by a formula.
    C,
}

impl PublishedRow {
    /// Whether the numbers bear the agreement out: all within their limits, or not all.
    pub fn holds(&self) -> bool {
        let within = self.difference.iter().zip(&self.held_to).all(|(d, limit)| d.abs() <= *limit);
        match self.agreement {
            Agreement::Agrees | Agreement::ReadOffAFigure => within,
            Agreement::PublishedIsOff | Agreement::OtherAlgorithm => !within,
        }
    }

    /// Indices of numbers that moved: computed and stored differ by more than a unit of the last digit.
    pub fn moved(&self) -> Vec<usize> {
        let still = |i: usize| {
            let stored = self.ours.get(i)?;
            let apart = (self.computed[i] - stored.parse::<f64>().ok()?).abs();
            (apart <= last_digit(stored)).then_some(())
        };
        (0..self.computed.len()).filter(|i| still(*i).is_none()).collect()
    }
}

/// One unit of the last digit of a printed number: 0.01 of `1.25`, 1e-9 of `3.45e-7`.
pub fn last_digit(text: &str) -> f64 {
    let (digits, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let power = power.parse::<i32>().unwrap_or(0) - decimals as i32;
    format!("1e{power}").parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_digit_is_that_of_the_print() {
        let cases = [("1.25", 0.01), ("3.45e-7", 1e-9), ("-40", 1.0), ("0.0005", 1e-4), ("2.50E+02", 1.0)];
        for (text, unit) in cases {
            assert_eq!(last_digit(text), unit, "{text}");
        }
    }
}
