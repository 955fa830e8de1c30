//! In which precision a program computes, seen from its numbers: an f32 that travels as an f64 ends in 29 zeros.

/// Numbers that are needed to say anything.
const FEWEST: u64 = 100;
/// Last bits of an f32, whose being zero makes a number too round to tell: 0, 1, 0.75.
const ROUND: u32 = 0xFFF;

/// What kinds of numbers were seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Precision {
    /// Exactly an f32, and not a round one.
    single: u64,
    /// No f32.
    double: u64,
    /// Most significant digits of a number.
    digits: usize,
}

impl Precision {
    pub fn add(&mut self, other: &Precision) {
        self.single += other.single;
        self.double += other.double;
        self.digits = self.digits.max(other.digits);
    }

    /// Most significant digits of a number that was seen.
    pub fn digits(&self) -> usize {
        self.digits
    }

    /// A unit in the last place of its numbers, relative. Numbers that an f32 holds are taken for those of one.
    pub fn unit(&self) -> f64 {
        let single = if self.double == 0 { f64::from(f32::EPSILON) } else { f64::EPSILON };
        let last_digit = if self.digits < ALL_DIGITS - 1 { 10f64.powi(1 - self.digits as i32) } else { 0.0 };
        single.max(last_digit)
    }

    /// Whether all numbers were single ones: by chance an f64 is one in 2²⁹.
    pub fn is_single(&self) -> bool {
        self.double == 0 && self.single >= FEWEST
    }
}

impl FromIterator<f64> for Precision {
    fn from_iter<I: IntoIterator<Item = f64>>(numbers: I) -> Precision {
        let mut seen = Precision::default();
        for number in numbers {
            if seen.digits < ALL_DIGITS {
                seen.digits = seen.digits.max(digits(number));
            }
            let single = number as f32;
            if f64::from(single) != number {
                seen.double += 1;
            } else if single.to_bits() & ROUND != 0 {
                seen.single += 1;
            }
        }
        seen
    }
}

/// Digits that a double may need: more need not be counted.
const ALL_DIGITS: usize = 17;

/// Significant digits of the shortest decimal number that reads as this one.
fn digits(number: f64) -> usize {
    let text = format!("{number:e}");
    text.split('e').next().map_or(0, |mantissa| mantissa.bytes().filter(u8::is_ascii_digit).count())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_those_of_the_longest_number() {
        let seen = |numbers: &[f64]| numbers.iter().copied().collect::<Precision>().digits();
        assert_eq!([seen(&[]), seen(&[0.5, -2.0e-7]), seen(&[1.23456789, 12.0])], [0, 1, 9]);
        assert!(seen(&[0.1 + 0.2, 1.0]) > 15);
    }

    #[test]
    fn single_numbers_are_told_from_double_and_from_round_ones() {
        let thirds = |count: u32| (1..=count).map(|n| f64::from(n) / 3.1);
        let single: Precision = thirds(200).map(|x| f64::from(x as f32)).collect();
        assert!(single.is_single());
        assert!(!thirds(200).collect::<Precision>().is_single());
        assert!(!(0..1000).map(f64::from).collect::<Precision>().is_single());
        let mut both = single;
        both.add(&thirds(3).collect());
        assert!(!both.is_single());
    }
}
