//! Lists of numbers of five digits whose exponents are near one another: three characters a number, where [`packed`](super::packed) alone takes four.
//!
//! Before the first number of a list that is not 0 stands the letter of its largest exponent e. A number ± m · 10^(e − d) with d below 4 is
//!
//! ```text
//! (1)  place = (d · 90000 + m − 10000) · 2 + sign,   below 90³,
//! ```
//!
//! in base 90. Any other has an exclamation mark before its four characters. The digits are the printable characters of ASCII without
//! `"`, `\`, `,`, `.` and `!`.

/// Numbers of a mantissa, and exponents below the largest.
const MANTISSAS: u64 = 90_000;
const EXPONENTS: u64 = 4;
const BASE: u64 = 90;
const FAR: u8 = b'!';

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

/// Above the smallest exponent, and (m − 10000) · 2 + sign, of a place of the code of five digits.
fn parts(place: u64) -> (u64, u64) {
    (place / (2 * MANTISSAS), place % (2 * MANTISSAS))
}

/// A list of places, none for a zero; `far` writes a place in four characters. `None` where an exponent has no letter.
pub(super) fn write(
    text: &mut Vec<u8>,
    places: &[Option<u64>],
    far: impl Fn(&mut Vec<u8>, u64),
) -> Option<()> {
    let largest = places.iter().flatten().map(|place| parts(*place).0).max().unwrap_or_default();
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
        let (above, rest) = parts(*place);
        let below = largest - above;
        if below < EXPONENTS {
            let near = below * 2 * MANTISSAS + rest;
            text.extend(
                [near / BASE / BASE, near / BASE % BASE, near % BASE].map(digit).into_iter().flatten(),
            );
        } else {
            text.push(FAR);
            far(text, *place);
        }
    }
    Some(())
}

/// The places of a list; `far` reads four characters. `None` where the text is none.
pub(super) fn read(mut text: &[u8], far: impl Fn(&[u8]) -> Option<u64>) -> Option<Vec<Option<u64>>> {
    let mut places = Vec::new();
    let mut largest = None;
    while let Some((first, rest)) = text.split_first() {
        text = rest;
        let Some(largest) = largest.filter(|_| *first != b'.') else {
            match first {
                b'.' => places.push(None),
                letter => largest = Some(value(*letter)?),
            }
            continue;
        };
        let place = if *first == FAR {
            let (four, rest) = text.split_at_checked(4)?;
            text = rest;
            far(four)?
        } else {
            let (two, rest) = text.split_at_checked(2)?;
            text = rest;
            let near = (value(*first)? * BASE + value(two[0])?) * BASE + value(two[1])?;
            let above = u64::checked_sub(largest, near / (2 * MANTISSAS))?;
            above * 2 * MANTISSAS + near % (2 * MANTISSAS)
        };
        places.push(Some(place));
    }
    Some(places)
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
        assert!(EXPONENTS * 2 * MANTISSAS <= BASE.pow(3));
    }

    #[test]
    fn places_come_back_near_and_far() {
        let place = |above: u64, rest: u64| Some(above * 2 * MANTISSAS + rest);
        let places = [None, place(60, 0), place(57, 179_999), None, place(56, 5), place(60, 77_777)];
        let mut text = Vec::new();
        let far = |text: &mut Vec<u8>, place: u64| text.extend(format!("{:04}", place % 10_000).bytes());
        write(&mut text, &places, far).expect("letters for all exponents");
        assert_eq!(text.len(), 1 + 1 + 3 + 3 + 1 + 5 + 3);
        let read = read(&text, |_| place(56, 5)).expect("a list");
        assert_eq!(read, places);
    }
}
