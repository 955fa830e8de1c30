//! What names of columns and cells below them say by themselves: words, units, times, rates about body axes.

use super::columns::{Kind, TIMES, meaning};
use super::units::{factor, take_units};

/// Words of times that are no times of a motion: a step, or what a program takes for it.
const NO_TIMES: [&str; 7] = ["delta", "step", "cpu", "wall", "solver", "exec", "d"];

/// The axis of a rate p, q or r about body axes, and SI units in the unit that the name states.
pub(super) fn rate(name: &str) -> Option<(usize, Option<f64>)> {
    let (bare, bracket) = without_bracket(name);
    let mut words = words_of(bare);
    let mut units: Vec<String> = bracket.map(words_of).unwrap_or_default();
    take_units(&mut words, &mut units);
    let axis = ["p", "q", "r"].iter().position(|rate| words == [*rate])?;
    Some((axis, factor(Kind::Spin, &units)))
}

/// Seconds in the unit of times that a name states.
pub(super) fn time_unit(name: &str) -> Option<f64> {
    let (bare, bracket) = without_bracket(name);
    let mut units: Vec<String> = bracket.map(words_of).unwrap_or_default();
    take_units(&mut words_of(bare), &mut units);
    factor(Kind::Time, &units)
}

/// SI units in the unit that stands below the name of a column.
pub(super) fn unit_below(name: &str, unit: &str) -> Option<f64> {
    let bare = without_bracket(name).0;
    let named = format!("{bare} [{}]", unit.trim_matches(['[', ']', '(', ')', ' ']));
    meaning(&named).and_then(|meaning| meaning.unit).or_else(|| rate(&named)?.1)
}

/// Whether a cell is a unit, or the sign that there is none.
pub(super) fn is_unit(cell: &str) -> bool {
    let words = words_of(cell);
    let known = |kind| factor(kind, &words).is_some();
    known(Kind::Time) || known(Kind::Position) || known(Kind::Spin)
}

/// Whether a name says a time and nothing else, or a time of something.
pub(super) fn is_time(name: &str, of_something: bool) -> bool {
    let mut words = words_of(without_bracket(name).0);
    take_units(&mut words, &mut Vec::new());
    let last = words.last().is_some_and(|word| TIMES.contains(&word.as_str()));
    let span = words.iter().any(|word| NO_TIMES.contains(&word.as_str()));
    last && !span && (of_something || words.len() == 1)
}

/// A unit in brackets at the end of a name, taken off; brackets around a number are an index.
pub(super) fn without_bracket(name: &str) -> (&str, Option<&str>) {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some(inside) = name.trim_end().strip_suffix(close)
            && let Some((bare, unit)) = inside.rsplit_once(open)
            && unit.trim().parse::<u32>().is_err()
            && !bare.trim().is_empty()
            && !matches!(unit.trim(), "x" | "y" | "z" | "w")
        {
            return (bare, Some(unit));
        }
    }
    (name, None)
}

/// The words of a name, in small letters.
pub(super) fn words_of(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut before = ' ';
    for letter in name.chars() {
        if !letter.is_alphanumeric() && letter != '°' {
            words.push(String::new());
        } else {
            if letter.is_uppercase() && before.is_lowercase() {
                words.push(String::new());
            }
            if let Some(word) = words.last_mut() {
                word.extend(letter.to_lowercase());
            }
        }
        before = letter;
    }
    words.retain(|word| !word.is_empty());
    words
}
