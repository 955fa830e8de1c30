//! Lists of numbers whose exponents are near one another: three characters a number of five digits and two a number of three, where
//! [`packed`](super::packed) alone takes one more.
//!
//! Before the first number of a list that is not 0 stands the letter of its largest exponent e. A number ± m · 10^(e − d) with d below 4 is
//!
//! ```text
//! (1)  place = (d · M + m − M/9) · 2 + sign,   M = 9 · 10^(digits − 1),   4 · 2 M < 90³ or 90²,
//! ```
//!
//! in base 90. Any other has an exclamation mark before its characters in the other code. The digits are the printable characters of ASCII
//! without `"`, `\`, `,`, `.` and `!`.

/// Exponents below the largest.
const EXPONENTS: u64 = 4;
const BASE: u64 = 90;
const FAR: u8 = b'!';

/// The code of numbers of so many digits.
#[derive(Clone, Copy)]
pub(super) struct Near {
    /// Numbers of a mantissa.
    pub(super) mantissas: u64,
    /// Characters of a near number.
    pub(super) width: usize,
    /// Characters of any other after its mark.
    pub(super) far: usize,
}

/// A digit in base 90.
fn digit(value: u64) -> Option<u8> {
    (b' '..=b'~').filter(|letter| !br#""\,.!"#.contains(letter)).nth(value as usize)
}

/// Value of a digit.
fn value(letter: u8) -> Option<u64> {
    let skipped = br#""\,.!"#;
    if !(b' '..=b'~').contains(&letter) || skipped.contains(&letter) {
        return None;
    }
    Some(u64::from(letter - b' ') - skipped.iter().filter(|one| **one < letter).count() as u64)
}

impl Near {
    /// Above the smallest exponent, and (m − M/9) · 2 + sign, of a place of the other code.
    fn parts(self, place: u64) -> (u64, u64) {
        (place / (2 * self.mantissas), place % (2 * self.mantissas))
    }

    /// A list of places, none for a zero; `far` writes a place in the other code. `None` where an exponent has no letter.
    pub(super) fn write(
        self,
        text: &mut Vec<u8>,
        places: &[Option<u64>],
        far: impl Fn(&mut Vec<u8>, u64),
    ) -> Option<()> {
        let largest = places.iter().flatten().map(|place| self.parts(*place).0).max().unwrap_or_default();
        let mut begun = false;
        for place in places {
            let Some(place) = place else {
                text.push(b'.');
                continue;
            };
            if !begun {
                text.push(digit(largest)?);
                begun = true;
            }
            let (above, rest) = self.parts(*place);
            let below = largest - above;
            if below < EXPONENTS {
                let near = below * 2 * self.mantissas + rest;
                let digits = (0..self.width).rev().map(|power| near / BASE.pow(power as u32) % BASE);
                text.extend(digits.filter_map(digit));
            } else {
                text.push(FAR);
                far(text, *place);
            }
        }
        Some(())
    }

    /// The places of a list; `far` reads the other code. `None` where the text is none.
    pub(super) fn read(
        self,
        mut text: &[u8],
        far: impl Fn(&[u8]) -> Option<u64>,
    ) -> Option<Vec<Option<u64>>> {
        let mut places = Vec::new();
        let mut largest = None;
        while let Some((first, rest)) = text.split_first() {
            let Some(largest) = largest.filter(|_| *first != b'.') else {
                match first {
                    b'.' => places.push(None),
                    letter => largest = Some(value(*letter)?),
                }
                text = rest;
                continue;
            };
            let is_far = *first == FAR;
            let (letters, width) = if is_far { (rest, self.far) } else { (text, self.width) };
            let (letters, rest) = letters.split_at_checked(width)?;
            text = rest;
            places.push(Some(if is_far { far(letters)? } else { self.near(letters, largest)? }));
        }
        Some(places)
    }

    /// The place of a near number under the largest exponent.
    fn near(self, letters: &[u8], largest: u64) -> Option<u64> {
        let near = letters.iter().try_fold(0, |sum, letter| Some(sum * BASE + value(*letter)?))?;
        let (below, rest) = self.parts(near);
        Some(largest.checked_sub(below)? * 2 * self.mantissas + rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_digit_has_its_value() {
        for number in 0..BASE {
            assert_eq!(value(digit(number).expect("a digit")), Some(number));
        }
        assert_eq!(digit(BASE), None);
        for Near { mantissas, width, .. } in [FIVE, THREE] {
            assert!(EXPONENTS * 2 * mantissas <= BASE.pow(width as u32));
        }
    }

    const FIVE: Near = Near { mantissas: 90_000, width: 3, far: 4 };
    const THREE: Near = Near { mantissas: 900, width: 2, far: 3 };

    #[test]
    fn places_come_back_near_and_far() {
        for near in [FIVE, THREE] {
            let place = |above: u64, rest: u64| Some(above * 2 * near.mantissas + rest);
            let last = 2 * near.mantissas - 1;
            let places = [None, place(60, 0), place(57, last), None, place(56, 5), place(60, 777)];
            let mut text = Vec::new();
            let far = |text: &mut Vec<u8>, _: u64| text.extend(std::iter::repeat_n(b'x', near.far));
            near.write(&mut text, &places, far).expect("letters for all exponents");
            assert_eq!(text.len(), 1 + 1 + 2 * near.width + 1 + 1 + near.far + near.width);
            let read = near.read(&text, |_| place(56, 5)).expect("a list");
            assert_eq!(read, places);
        }
    }
}
