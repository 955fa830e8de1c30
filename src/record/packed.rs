//! Lists of numbers as text: four characters a number, where JSON takes eleven. A number is a sign, a mantissa m of d digits and an exponent e:
//!
//! ```text
//! (1)  number = ± m · 10^e,   place = ((e + e₀) · 9 · 10^(d−1) + m − 10^(d−1)) · 2 + sign
//! ```
//!
//! The place is written in base 64, the highest digit first. The first character of the text is d: `5` has four characters a number and
//! e₀ = 70, `3` has three and e₀ = 70, `2` has two, e₀ = 34 and no sign, and `*` has the 64 bits of the double in eleven; `n` and `m` are the codes of
//! `nearby` for five and for three digits. A dot is a zero, whose sign is lost but where bits are written. Lists are
//! separated by commas. A reader gets each number back to the last bit.

use serde::de::{Error, SeqAccess, Visitor, value::SeqAccessDeserializer};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::nearby::Near;
use crate::quantity::{PerQuantity, Quantity};

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// A code: how numbers of so many digits are written.
#[derive(Clone, Copy)]
struct Code {
    /// First character of the text.
    name: u8,
    /// Characters of a number.
    width: u32,
    /// Smallest mantissa, 10^(d − 1); 0 where the bits are written.
    least: u64,
    /// −e₀, the smallest exponent.
    exponent: i32,
    /// Values of the sign.
    signs: u64,
}

/// Five digits.
const FIVE: Code = Code { name: b'5', width: 4, least: 10_000, exponent: -70, signs: 2 };
/// Three digits.
const THREE: Code = Code { name: b'3', width: 3, least: 100, exponent: -70, signs: 2 };
/// Names of the codes of [`nearby`], and the codes of the numbers in them.
const NEARBY: [(u8, Code); 2] = [(b'n', FIVE), (b'm', THREE)];

/// The codes, the shortest first.
const CODES: [Code; 4] = [
    Code { name: b'2', width: 2, least: 10, exponent: -34, signs: 1 },
    THREE,
    FIVE,
    Code { name: b'*', width: 11, least: 0, exponent: 0, signs: 1 },
];

impl Code {
    /// (1), or the bits; `None` where the code does not hold the number.
    fn place(&self, value: f64) -> Option<u64> {
        if self.least == 0 {
            return Some(value.to_bits());
        }
        let digits = self.least.ilog10() as usize;
        let text = format!("{:.digits$e}", value.abs());
        let (mantissa, power) = text.split_once('e')?;
        let mantissa: u64 = mantissa.replace('.', "").parse().ok()?;
        let exponent = power.parse::<i32>().ok()? - digits as i32;
        let above = u64::try_from(exponent - self.exponent).ok()?;
        let place = (above * 9 * self.least + mantissa - self.least) * self.signs;
        let whole = decimal(mantissa, exponent) == value.abs() && place + 1 < 1 << (6 * self.width);
        (whole && (value > 0.0 || self.signs == 2)).then_some(place + u64::from(value < 0.0))
    }

    /// The code of near exponents for such numbers.
    fn near(&self) -> Near {
        Near { mantissas: 9 * self.least, width: self.width as usize - 1, far: self.width as usize }
    }

    fn number(&self, place: u64) -> f64 {
        if self.least == 0 {
            return f64::from_bits(place);
        }
        let (sign, place) = (place % self.signs, place / self.signs);
        let (above, mantissa) = (place / (9 * self.least), place % (9 * self.least) + self.least);
        let size = decimal(mantissa, above as i32 + self.exponent);
        if sign == 1 { -size } else { size }
    }
}

/// m · 10^e, to the nearest double.
fn decimal(mantissa: u64, exponent: i32) -> f64 {
    // Powers of ten to the 22nd are doubles: one product or quotient of doubles is rounded once.
    match exponent {
        0..=22 => mantissa as f64 * 10f64.powi(exponent),
        -22..0 => mantissa as f64 / 10f64.powi(-exponent),
        _ => format!("{mantissa}e{exponent}").parse().unwrap_or(f64::NAN),
    }
}

/// Lists of numbers as text, in the shortest code that holds all of them.
pub(super) fn text_of(lists: &[&[f64]]) -> String {
    let written = |code: &Code| {
        let mut text = vec![code.name];
        for (index, list) in lists.iter().enumerate() {
            text.extend((index > 0).then_some(b','));
            for value in *list {
                if *value == 0.0 && (code.least > 0 || value.is_sign_positive()) {
                    text.push(b'.');
                    continue;
                }
                letters(&mut text, code.place(*value)?, code.width);
            }
        }
        String::from_utf8(text).ok()
    };
    let text = CODES.iter().find_map(written).unwrap_or_default();
    // The exponents of errors are near one another.
    let near = NEARBY.iter().find(|(_, code)| text.as_bytes().first() == Some(&code.name));
    let near = near.and_then(|(name, code)| nearby_text(lists, *name, *code));
    near.filter(|near| near.len() < text.len()).unwrap_or(text)
}

/// A place in base 64, the highest digit first.
fn letters(text: &mut Vec<u8>, place: u64, width: u32) {
    text.extend((0..width).rev().map(|digit| DIGITS[(place >> (6 * digit)) as usize % 64]));
}

/// A number in base 64.
fn number_of(letters: &[u8]) -> Option<u64> {
    letters.iter().try_fold(0, |place, digit| Some(place << 6 | value_of(*digit)?))
}

/// The lists in a code of near exponents; `None` where it does not hold them.
fn nearby_text(lists: &[&[f64]], name: u8, code: Code) -> Option<String> {
    let mut text = vec![name];
    for (index, list) in lists.iter().enumerate() {
        text.extend((index > 0).then_some(b','));
        let place = |value: &f64| if *value == 0.0 { Some(None) } else { code.place(*value).map(Some) };
        let places: Vec<Option<u64>> = list.iter().map(place).collect::<Option<_>>()?;
        code.near().write(&mut text, &places, |text, place| letters(text, place, code.width))?;
    }
    String::from_utf8(text).ok()
}

/// The lists of such a text; `None` where it is none.
pub(super) fn lists_of(text: &str) -> Option<Vec<Vec<f64>>> {
    let (name, mut rest) = text.as_bytes().split_first()?;
    if let Some((_, code)) = NEARBY.iter().find(|(near, _)| near == name) {
        let number = |place: Option<u64>| place.map_or(0.0, |place| code.number(place));
        let list = |part: &[u8]| Some(code.near().read(part, number_of)?.into_iter().map(number).collect());
        return rest.split(|letter| *letter == b',').map(list).collect();
    }
    let code = CODES.iter().find(|code| code.name == *name)?;
    let mut lists = vec![Vec::new()];
    while let Some((first, after)) = rest.split_first() {
        let list = lists.last_mut()?;
        match first {
            b',' => lists.push(Vec::new()),
            b'.' => list.push(0.0),
            _ => {
                let (number, after) = rest.split_at_checked(code.width as usize)?;
                list.push(code.number(number_of(number)?));
                rest = after;
                continue;
            }
        }
        rest = after;
    }
    Some(lists)
}

/// Value of a digit in base 64.
fn value_of(digit: u8) -> Option<u64> {
    Some(u64::from(match digit {
        b'A'..=b'Z' => digit - b'A',
        b'a'..=b'z' => digit - b'a' + 26,
        b'0'..=b'9' => digit - b'0' + 52,
        b'-' => 62,
        b'_' => 63,
        _ => return None,
    }))
}

/// Packed numbers, or the list that files of former versions have.
struct Packed<const LISTS: usize>;

impl<'de, const LISTS: usize> Visitor<'de> for Packed<LISTS> {
    type Value = [Vec<f64>; LISTS];

    fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "a list of numbers, or {LISTS} lists of them as packed text")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        let lists = lists_of(text).and_then(|lists| lists.try_into().ok());
        lists.ok_or_else(|| E::invalid_value(serde::de::Unexpected::Str(text), &self))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, lists: A) -> Result<Self::Value, A::Error> {
        let lists = SeqAccessDeserializer::new(lists);
        if LISTS == 1 {
            return Ok(std::array::from_fn({
                let mut list = Some(Vec::deserialize(lists)?);
                move |_| list.take().unwrap_or_default()
            }));
        }
        let lists = Vec::deserialize(lists)?;
        let found = lists.len();
        lists.try_into().map_err(|_| A::Error::invalid_length(found, &"a list for each quantity"))
    }
}

/// A list.
pub(super) mod list {
    use super::*;

    pub fn serialize<S: Serializer>(list: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
        text_of(&[list]).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
        let [list] = deserializer.deserialize_any(Packed::<1>)?;
        Ok(list)
    }
}

/// A number for each quantity.
pub(super) mod numbers {
    use super::*;

    pub fn serialize<S: Serializer>(numbers: &PerQuantity<f64>, serializer: S) -> Result<S::Ok, S::Error> {
        text_of(&[&Quantity::ALL.map(|quantity| numbers[quantity])]).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<PerQuantity<f64>, D::Error> {
        let [list] = deserializer.deserialize_any(Packed::<1>)?;
        let found = list.len();
        let numbers: Result<[f64; Quantity::ALL.len()], _> = list.try_into();
        numbers
            .map(PerQuantity::from)
            .map_err(|_| Error::invalid_length(found, &"a number for each quantity"))
    }
}

/// Vectors.
pub(super) mod vectors {
    use super::*;

    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Either {
        Packed(String),
        Rows(Vec<[f64; 3]>),
    }

    pub fn serialize<S: Serializer>(vectors: &[[f64; 3]], serializer: S) -> Result<S::Ok, S::Error> {
        text_of(&[vectors.as_flattened()]).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<[f64; 3]>, D::Error> {
        let text = match Either::deserialize(deserializer)? {
            Either::Rows(rows) => return Ok(rows),
            Either::Packed(text) => text,
        };
        let lists = lists_of(&text).filter(|lists| lists.len() == 1 && lists[0].len() % 3 == 0);
        let list = lists.ok_or_else(|| Error::custom("packed text of no vectors"))?.concat();
        Ok(list.chunks_exact(3).map(|vector| [vector[0], vector[1], vector[2]]).collect())
    }
}

/// A list for each quantity.
pub(super) mod lists {
    use super::*;

    pub fn serialize<S: Serializer>(lists: &PerQuantity<Vec<f64>>, serializer: S) -> Result<S::Ok, S::Error> {
        text_of(&Quantity::ALL.map(|quantity| lists[quantity].as_slice())).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<PerQuantity<Vec<f64>>, D::Error> {
        deserializer.deserialize_any(Packed::<{ Quantity::ALL.len() }>).map(PerQuantity::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_to_the_last_bit_in_the_shortest_code_that_holds_them() {
        let two = [1e-33, 9.9e-5, 0.5, 30.0, 9.9e10, 0.0];
        let three = [-1e-66, 9.99e-9, -0.25, 123.0, -9.99e25, 0.0, 3e-24];
        let close = [-1.23e-9, 9.99e-8, 0.0, 1e-6, -5e-9, 1.5e-9];
        let five = [-1e-66, 9.9999e-9, -0.25, 123.45, -9.9999e25, 0.0, 3e-24];
        let near = [-1.2345e-9, 9.9999e-8, 0.0, 1.0001e-6, -5e-9, 1.5e-9];
        let all = [std::f64::consts::PI, -0.1 - 0.2, 1e-300, f64::MAX, f64::NAN, f64::NEG_INFINITY, 0.0];
        for (numbers, sign, length) in [
            (&two[..], '2', 12),
            (&three, '3', 20),
            (&close, 'm', 13),
            (&five, '5', 26),
            (&near, 'n', 18),
            (&all, '*', 68),
        ] {
            let text = text_of(&[numbers]);
            assert!(text.starts_with(sign) && text.len() == length, "{text}");
            let bits = |list: &[f64]| list.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&lists_of(&text).expect("lists")[0]), bits(numbers));
        }
        assert!(text_of(&[&[1e-69]]).starts_with('*') && text_of(&[&[-1.5]]).starts_with('3'));
    }

    #[test]
    fn a_decimal_number_is_the_one_that_is_parsed() {
        for exponent in -75..30 {
            for mantissa in [10, 10_000, 12_345, 31_906, 99_999] {
                assert_eq!(Ok(decimal(mantissa, exponent)), format!("{mantissa}e{exponent}").parse());
            }
        }
    }

    #[test]
    fn lists_of_former_files_and_texts_are_read_and_others_are_not() {
        #[derive(Debug, PartialEq, Serialize, Deserialize)]
        struct Row {
            #[serde(with = "list")]
            one: Vec<f64>,
            #[serde(with = "lists")]
            each: PerQuantity<Vec<f64>>,
        }
        let each = PerQuantity::from([vec![0.5, 0.0], vec![], vec![-3.25], vec![], vec![1e-9], vec![]]);
        let row = Row { one: vec![1.0, 0.0], each };
        let former = r#"{"one":[1.0,0.0],"each":[[0.5,0.0],[],[-3.25],[],[1e-9],[]]}"#;
        assert_eq!(serde_json::from_str::<Row>(former).expect("lists"), row);
        let text = serde_json::to_string(&row).expect("JSON");
        assert_eq!(serde_json::from_str::<Row>(&text).expect("texts"), row);
        for wrong in ["", "7", "2A", "2,,", "5AAA", "5AA A"] {
            let text = format!(r#"{{"one":"{wrong}","each":"2,,,,,"}}"#);
            assert!(serde_json::from_str::<Row>(&text).is_err(), "{wrong}");
        }
        assert!(serde_json::from_str::<Row>(r#"{"one":[],"each":[[],[]]}"#).is_err());
    }
}
