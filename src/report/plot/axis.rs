//! Axes: a range of numbers, where each falls, and which are labelled.

use crate::report::number::superscript;

/// A range and its labels. A logarithmic axis holds log₁₀ of its quantity.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Left or lower end.
    pub low: f64,
    /// Right or upper end.
    pub high: f64,
    /// Labelled places.
    pub labels: Vec<(f64, String)>,
    /// Places with a tick and no label.
    pub ticks: Vec<f64>,
}

impl Axis {
    /// How far along the axis a number falls: 0 at the low end, 1 at the high end.
    pub(super) fn part(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// A logarithmic axis between two log₁₀ values, with at most so many labels.
    pub(super) fn logarithmic(low: f64, high: f64, most: usize) -> Axis {
        let (low, high) = opened(low, high, 0.4);
        let first = (low - 1e-9).ceil() as i32;
        let last = (high + 1e-9).floor() as i32;
        let decades = (last - first + 1).max(0) as usize;
        let stride = decades.div_ceil(most.max(1)).max(1) as i32;
        let round = |power: &i32| power.rem_euclid(stride) == 0;
        let labels: Vec<_> = (first..=last)
            .filter(round)
            .map(|power| (f64::from(power), format!("10{}", superscript(power))))
            .collect();
        if labels.len() < 2 {
            return Axis { low, high, labels: digit_labels(low, high, most), ticks: digit_ticks(low, high) };
        }
        let ticks = if stride > 1 { (first..=last).map(f64::from).collect() } else { digit_ticks(low, high) };
        Axis { low, high, labels, ticks }
    }

    /// A linear axis with about so many labels at round numbers.
    pub(super) fn linear(low: f64, high: f64, most: usize) -> Axis {
        let (low, high) = opened(low, high, 1e-9);
        let rough = (high - low) / most.max(1) as f64;
        let power = 10f64.powf(rough.log10().floor());
        let stride =
            [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough).unwrap_or(rough);
        let decimals = (-stride.log10().floor()).clamp(0.0, 12.0) as usize;
        let first = (low / stride - 1e-9).ceil() as i64;
        let last = (high / stride + 1e-9).floor() as i64;
        let label = |value: f64| format!("{value:.decimals$}").replace('-', "−");
        let labels = (first..=last).map(|n| n as f64 * stride).map(|value| (value, label(value))).collect();
        Axis { low, high, labels, ticks: Vec::new() }
    }
}

/// A range that is not empty and not upside down.
fn opened(low: f64, high: f64, least: f64) -> (f64, f64) {
    if !(low.is_finite() && high.is_finite()) {
        return (0.0, 1.0);
    }
    let lack = (least - (high - low)).max(0.0);
    (low - lack / 2.0, high + lack / 2.0)
}

fn digit_ticks(low: f64, high: f64) -> Vec<f64> {
    digits(low, high, &[2, 3, 4, 5, 6, 7, 8, 9]).into_iter().map(|(place, ..)| place).collect()
}

/// Labels at 1, 2 and 5 times the powers of ten, where a range is too short for powers of ten alone.
fn digit_labels(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
    let label = |(place, digit, power): (f64, i32, i32)| match digit {
        // A short range of counts reads best as it is counted.
        _ if (0..4).contains(&power) => (place, (digit * 10i32.pow(power as u32)).to_string()),
        1 => (place, format!("10{}", superscript(power))),
        _ => (place, format!("{digit}×10{}", superscript(power))),
    };
    let some = digits(low, high, &[1, 2, 5]);
    let chosen = if some.len() > most { digits(low, high, &[1, 3]) } else { some };
    chosen.into_iter().map(label).collect()
}

fn digits(low: f64, high: f64, wanted: &[i32]) -> Vec<(f64, i32, i32)> {
    let decades = low.floor() as i32..=high.ceil() as i32;
    let all = decades.flat_map(|power| {
        wanted.iter().map(move |digit| (f64::from(power) + f64::from(*digit).log10(), *digit, power))
    });
    all.filter(|(place, ..)| (low - 1e-9..=high + 1e-9).contains(place)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(axis: &Axis) -> Vec<&str> {
        axis.labels.iter().map(|(_, label)| label.as_str()).collect()
    }

    #[test]
    fn logarithmic_labels_are_powers_of_ten() {
        assert_eq!(words(&Axis::logarithmic(-3.2, 0.1, 7)), ["10⁻³", "10⁻²", "10⁻¹", "10⁰"]);
        assert_eq!(words(&Axis::logarithmic(-8.5, 0.0, 5)), ["10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"]);
        assert_eq!(words(&Axis::logarithmic(-2.9, -2.1, 5)), ["2×10⁻³", "5×10⁻³"]);
        assert_eq!(words(&Axis::logarithmic(0.25, 0.95, 5)), ["2", "5"]);
    }

    #[test]
    fn linear_labels_are_round() {
        assert_eq!(words(&Axis::linear(0.0, 8.0, 4)), ["0", "2", "4", "6", "8"]);
        assert_eq!(words(&Axis::linear(0.5, 2.5, 4)), ["0.5", "1.0", "1.5", "2.0", "2.5"]);
    }

    #[test]
    fn empty_ranges_become_open_ones() {
        let axis = Axis::logarithmic(-3.0, -3.0, 5);
        assert!(axis.high > axis.low && axis.part(-3.0).is_finite());
        assert!(Axis::linear(f64::NAN, 1.0, 5).part(0.5).is_finite());
    }
}
