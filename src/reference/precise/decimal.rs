//! Double-double numbers as decimal digits, and back.
//!
//! Rust writes every digit of an f64 that is asked for, exactly. The two parts are written to the same number of
//! places and added as digits, so that nothing is lost but the last rounding. Reading takes the nearest f64 first,
//! and then the nearest to what is left.

use super::double_double::DoubleDouble;

/// Digits kept beyond those that are wanted.
const GUARD: usize = 8;
/// Decimal places in which numbers are read: more than any number of 40 digits above 1e-30 needs.
const PLACES: usize = 80;

/// A signed decimal number: digits, most significant first, of which the last `places` stand behind the point.
struct Digits {
    negative: bool,
    digits: Vec<i8>,
    places: usize,
}

impl Digits {
    /// Of a number written without an exponent.
    fn read(text: &str) -> Option<Digits> {
        let (negative, text) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
        let digit = |c: char| c.to_digit(10).map(|digit| digit as i8);
        let digits = whole.chars().chain(fraction.chars()).map(digit).collect::<Option<Vec<_>>>()?;
        Some(Digits { negative, digits, places: fraction.len() })
    }

    fn of(x: f64, places: usize) -> Option<Digits> {
        Digits::read(&format!("{x:.places$}"))
    }

    /// The same number with so many places, cut where it has more, and at least so many digits.
    fn padded(mut self, places: usize, length: usize) -> Digits {
        let whole = self.digits.len() - self.places;
        self.digits.resize(whole + places, 0);
        let missing = length.saturating_sub(self.digits.len());
        self.digits.splice(0..0, std::iter::repeat_n(0, missing));
        Digits { places, ..self }
    }

    /// self + other, both with the same places.
    fn plus(self, other: Digits) -> Digits {
        let length = self.digits.len().max(other.digits.len()) + 1;
        let places = self.places;
        let (a, b) = (self.padded(places, length), other.padded(places, length));
        let sign = |negative: bool| if negative { -1 } else { 1 };
        let signed = a.digits.iter().zip(&b.digits).map(|(x, y)| sign(a.negative) * x + sign(b.negative) * y);
        let mut digits: Vec<i8> = signed.collect();
        let negative = digits.iter().find(|digit| **digit != 0).is_some_and(|digit| *digit < 0);
        let mut carry = 0;
        for digit in digits.iter_mut().rev() {
            let value = if negative { -*digit } else { *digit } + carry;
            carry = value.div_euclid(10);
            *digit = value.rem_euclid(10);
        }
        Digits { negative, digits, places }
    }

    fn negated(self) -> Digits {
        Digits { negative: !self.negative, ..self }
    }

    /// Rounded to so many significant digits, half up.
    fn rounded(mut self, significant: usize) -> Digits {
        let Some(first) = self.digits.iter().position(|digit| *digit != 0) else { return self };
        let end = first + significant;
        if end >= self.digits.len() {
            return self;
        }
        let mut carry = i8::from(self.digits[end] >= 5);
        self.digits[end..].fill(0);
        for digit in self.digits[..end].iter_mut().rev() {
            let value = *digit + carry;
            *digit = value % 10;
            carry = value / 10;
        }
        if carry > 0 {
            self.digits.insert(0, carry);
        }
        self
    }

    fn write(&self) -> String {
        let whole = self.digits.len() - self.places;
        let text =
            |digits: &[i8]| digits.iter().map(|digit| (b'0' + *digit as u8) as char).collect::<String>();
        let (before, after) = (text(&self.digits[..whole]), text(&self.digits[whole..]));
        let (before, after) = (before.trim_start_matches('0'), after.trim_end_matches('0'));
        let sign = if self.negative && !(before.is_empty() && after.is_empty()) { "-" } else { "" };
        let before = if before.is_empty() { "0" } else { before };
        if after.is_empty() { format!("{sign}{before}") } else { format!("{sign}{before}.{after}") }
    }
}

/// `number` to so many significant digits, without an exponent.
pub fn write(number: DoubleDouble, significant: usize) -> String {
    if !number.is_finite() || number.high == 0.0 {
        return number.high.to_string();
    }
    let exponent = number.high.abs().log10().floor() as i64;
    let places = (significant as i64 - exponent).max(0) as usize + GUARD;
    match (Digits::of(number.high, places), Digits::of(number.low, places)) {
        (Some(high), Some(low)) => high.plus(low).rounded(significant).write(),
        _ => number.high.to_string(),
    }
}

/// A vector to so many significant digits, or as many as `bound` leaves of its largest entry: of one that is no larger than
/// its bound nothing but zeros.
pub fn write_vector(vector: &[DoubleDouble; 3], bound: f64, significant: usize) -> [String; 3] {
    let certain = certain(vector, bound);
    if certain < 1.0 {
        return [0, 1, 2].map(|_| "0".to_owned());
    }
    let digits = if certain < significant as f64 { certain as usize } else { significant };
    vector.map(|x| write(x, digits))
}

/// The significant digits that `bound` leaves of the largest entry of a vector.
pub fn certain(vector: &[DoubleDouble; 3], bound: f64) -> f64 {
    let largest = vector.iter().map(|x| x.high.abs()).fold(0.0, f64::max);
    (largest / (2.0 * bound)).log10().floor()
}

/// The number of a decimal text, with or without an exponent; what has an exponent is read as an f64.
pub fn read(text: &str) -> Option<DoubleDouble> {
    let high: f64 = text.parse().ok().filter(|x: &f64| x.is_finite())?;
    let Some(exact) = Digits::read(text) else { return Some(DoubleDouble::from(high)) };
    let length = exact.digits.len() + PLACES;
    let rest = exact.padded(PLACES, length).plus(Digits::of(high, PLACES)?.negated());
    Some(DoubleDouble::of_sum(high, rest.write().parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_digits_come_back_as_they_were_written() {
        for text in [
            "0.1",
            "-3.14159265358979323846264338328",
            "1234567.89012345678901234567891",
            "0.0000000271828182845904523536028747135",
            "-0.999999999999999999999999999999",
            "17",
        ] {
            assert_eq!(write(read(text).expect("a number"), 30), text);
        }
        assert_eq!(write(read("-0.99999999999999999").expect("a number"), 5), "-1");
        assert_eq!(write(DoubleDouble::ZERO, 30), "0");
        assert_eq!(read("one"), None);
        assert_eq!(read("-2.5e-3").expect("a number").high, -2.5e-3);
    }

    #[test]
    fn a_vector_is_written_to_the_digits_that_its_bound_leaves() {
        let third = DoubleDouble::ONE / DoubleDouble::from(3.0);
        let vector = [third, third.scaled(0.5), DoubleDouble::ZERO];
        assert_eq!(write_vector(&vector, 1e-30, 5), ["0.33333", "0.16667", "0"]);
        assert_eq!(write_vector(&vector, 1e-4, 5), ["0.333", "0.167", "0"]);
        assert_eq!(write_vector(&vector, 0.2, 5), ["0", "0", "0"]);
        assert_eq!(write_vector(&vector, 0.0, 2), ["0.33", "0.17", "0"]);
        assert_eq!(write_vector(&[DoubleDouble::ZERO; 3], 0.0, 2), ["0", "0", "0"]);
    }

    #[test]
    fn a_third_is_written_to_the_last_digit_that_it_has() {
        let third = DoubleDouble::ONE / DoubleDouble::from(3.0);
        assert_eq!(write(third, 30), "0.333333333333333333333333333333");
        assert_eq!(write(-third.scaled(2.0), 31), "-0.6666666666666666666666666666667");
    }
}
