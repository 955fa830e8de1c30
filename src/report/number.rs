//! How the report prints numbers: three or four significant digits, powers of ten as superscripts, and the
//! uncertainty with the value.

/// Printed in place of a number that does not exist.
pub(super) const NONE: &str = "–";

/// An integer in superscript digits.
pub(super) fn superscript(power: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raise = |letter: char| match letter.to_digit(10) {
        Some(digit) => DIGITS[digit as usize],
        None => '⁻',
    };
    power.to_string().chars().map(raise).collect()
}

/// The power of ten of a number's first digit, after rounding to `digits` significant ones.
fn exponent(value: f64, digits: usize) -> i32 {
    let text = format!("{:.*e}", digits.saturating_sub(1), value.abs());
    text.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

/// True where a number reads well without a power of ten.
fn is_plain(power: i32) -> bool {
    (-3..5).contains(&power)
}

/// A number with so many significant digits: `0.1235`, `1.235×10⁻⁸`, `0`.
pub(super) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return NONE.into();
    }
    if value == 0.0 {
        return "0".into();
    }
    let power = exponent(value, digits);
    if is_plain(power) {
        let decimals = (digits as i32 - 1 - power).max(0) as usize;
        return minus(&format!("{value:.decimals$}"));
    }
    let scaled = value / 10f64.powi(power);
    format!("{}×10{}", minus(&format!("{scaled:.*}", digits.saturating_sub(1))), superscript(power))
}

/// A setting, such as a time step: five significant digits without the zeros that say nothing.
pub(super) fn setting(value: f64) -> String {
    let text = significant(value, 5);
    let (digits, power) = text.split_at(text.find('×').unwrap_or(text.len()));
    let short =
        if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
    format!("{short}{power}")
}

/// A value with its uncertainty: `0.1235 ± 0.0002`, `(1.23 ± 0.02)×10⁻⁸`, `1.23×10⁻⁸`.
pub(super) fn with_uncertainty(value: f64, uncertainty: Option<f64>) -> String {
    let spread = match uncertainty {
        Some(spread) if spread > 0.0 && spread.is_finite() && value.is_finite() => spread,
        _ => return significant(value, 4),
    };
    let (of_value, of_spread) = (exponent(value, 4), exponent(spread, 1));
    if value == 0.0 || of_spread > of_value || of_value - of_spread > 4 {
        return format!("{} ± {}", significant(value, 4), significant(spread, 1));
    }
    if is_plain(of_value) && of_spread >= -5 {
        let decimals = (-of_spread).max(0) as usize;
        return minus(&format!("{value:.decimals$} ± {spread:.decimals$}"));
    }
    let scale = 10f64.powi(of_value);
    let decimals = (of_value - of_spread) as usize;
    let pair = minus(&format!("({:.decimals$} ± {:.decimals$})", value / scale, spread / scale));
    format!("{pair}×10{}", superscript(of_value))
}

/// A value with its uncertainty and its unit; `1` is the unit of pure numbers and is not printed.
pub(super) fn quantity(value: Option<f64>, uncertainty: Option<f64>, unit: &str) -> String {
    match value {
        Some(value) => joined(&with_uncertainty(value, uncertainty), unit),
        None => NONE.into(),
    }
}

/// A printed number and its unit.
pub(super) fn joined(number: &str, unit: &str) -> String {
    if unit.is_empty() || unit == "1" || number == NONE { number.into() } else { format!("{number} {unit}") }
}

/// A measured order with its confidence interval: `2.00 ± 0.01`, or `2.00 [1.98, 2.05]` where it is lopsided.
pub(super) fn order(value: Option<f64>, low: Option<f64>, high: Option<f64>) -> String {
    let Some(value) = value else { return NONE.into() };
    let (Some(low), Some(high)) = (low, high) else { return minus(&format!("{value:.2}")) };
    let half = (high - low) / 2.0;
    let decimals = if half < 0.0095 { 3 } else { 2 };
    if ((high + low) / 2.0 - value).abs() > 0.1 * half + 5e-4 {
        return minus(&format!("{value:.decimals$} [{low:.decimals$}, {high:.decimals$}]"));
    }
    if half < 5e-4 {
        return minus(&format!("{value:.3} ± <0.001"));
    }
    minus(&format!("{value:.decimals$} ± {half:.decimals$}"))
}

/// An order with the larger of its two bounds in brackets, in units of the last digit: `2.002(7)`.
pub(super) fn brief_order(value: Option<f64>, low: Option<f64>, high: Option<f64>) -> String {
    let Some(value) = value else { return NONE.into() };
    let (Some(low), Some(high)) = (low, high) else { return minus(&format!("{value:.2}")) };
    let decimals: i32 = if (high - value).max(value - low) < 0.0085 { 3 } else { 2 };
    let [scaled, low, high] = [value, low, high].map(|number| number * 10f64.powi(decimals));
    // From the number in print on; a billionth of a digit is rounding.
    let off = (high - scaled.round()).max(scaled.round() - low);
    let last = (off - 1e-9).ceil().max(1.0);
    minus(&format!("{value:.0$}({last:.0})", decimals as usize))
}

/// A count with its noun, in the plural where it needs one.
pub(super) fn counted(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

/// Hyphens before digits become minus signs.
fn minus(text: &str) -> String {
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_brackets_of_an_order_hold_its_bounds() {
        let brief = |value, low, high| brief_order(Some(value), Some(low), Some(high));
        assert_eq!(brief(2.0021, 1.9955, 2.0049), "2.002(7)");
        assert_eq!(brief(2.0, 1.99999, 2.00001), "2.000(1)");
        assert_eq!(brief(3.22, 2.8, 3.22), "3.22(42)");
        assert_eq!(brief(2.0024, 1.9980, 2.0094), "2.002(8)");
        assert_eq!(brief_order(Some(1.5), None, None), "1.50");
        assert_eq!(brief_order(None, None, None), NONE);
    }

    #[test]
    fn small_numbers_are_printed_with_a_power_of_ten() {
        assert_eq!(significant(1.2345e-8, 3), "1.23×10⁻⁸");
        assert_eq!(significant(-2.5e7, 3), "−2.50×10⁷");
        assert_eq!(significant(0.0, 3), "0");
        assert_eq!(significant(9.9999, 3), "10.0");
        assert_eq!(significant(f64::NAN, 3), NONE);
    }

    #[test]
    fn settings_are_printed_without_idle_zeros() {
        assert_eq!(setting(0.0078125), "0.0078125");
        assert_eq!(setting(8.0), "8");
        assert_eq!(setting(100.0), "100");
        assert_eq!(setting(1e-4), "1×10⁻⁴");
    }

    #[test]
    fn the_uncertainty_sets_the_digits_of_its_value() {
        assert_eq!(with_uncertainty(0.123456, Some(2e-4)), "0.1235 ± 0.0002");
        assert_eq!(with_uncertainty(1.2345e-8, Some(2e-10)), "(1.23 ± 0.02)×10⁻⁸");
        assert_eq!(with_uncertainty(1.0, Some(1e-13)), "1.000 ± 1×10⁻¹³");
        assert_eq!(with_uncertainty(0.0, Some(1e-13)), "0 ± 1×10⁻¹³");
        assert_eq!(quantity(Some(0.5), None, "rad"), "0.5000 rad");
        assert_eq!(quantity(None, Some(1.0), "rad"), NONE);
    }

    #[test]
    fn an_order_is_printed_with_its_interval() {
        assert_eq!(order(Some(2.0), Some(1.99), Some(2.01)), "2.00 ± 0.01");
        assert_eq!(order(Some(2.0), Some(1.998), Some(2.002)), "2.000 ± 0.002");
        assert_eq!(order(Some(2.0), Some(1.99), Some(2.08)), "2.00 [1.99, 2.08]");
        assert_eq!(order(Some(2.0), Some(2.0), Some(2.0)), "2.000 ± <0.001");
        assert_eq!(order(None, None, None), NONE);
    }
}
