//! What error messages suggest: an example for every key of the format, and the word that was meant.

use crate::model::forces::{Kind, Law, Parameter, TorqueAxes};

/// Keys of a scene file, and values that would be right. Those of the laws stand in their tables.
const EXAMPLES: &[(&str, &str)] = &[
    ("name", "\"my-scene\""),
    ("title", "\"One line for the report\""),
    ("why", "\"what this scene shows that others do not\""),
    ("duration", "10.0"),
    ("not_for_order", "\"the reason\""),
    ("only_for_stability", "\"the reason\""),
    ("body", "{ mass = 1.0, inertia = [1.0, 2.0, 2.5] }"),
    ("initial", "{ angular_velocity = [0.0, 0.0, 1.0] }"),
    ("forces", "[ { law = \"gravity\", acceleration = [0.0, 0.0, -9.81] } ]"),
    ("points", "[ { mass = 1.0, position = [0.5, 0.0, 0.0] } ]"),
    ("massless", "[ [0.0, 0.0, 1.0] ]"),
    ("mass", "1.0"),
    ("inertia", "[1.0, 2.0, 2.5]"),
    ("unphysical_inertia", "true"),
    ("pivot", "[0.0, 0.0, 0.0]"),
    ("position", "[0.0, 0.0, 0.0]"),
    ("orientation", "[1.0, 0.0, 0.0, 0.0]"),
    ("velocity", "[0.0, 0.0, 0.0]"),
    ("angular_velocity", "[0.0, 0.0, 1.0]"),
    ("angular_velocity_body", "[0.0, 0.0, 1.0]"),
    ("angular_momentum", "[0.0, 0.0, 1.0]"),
    ("euler", "[30.0, 20.0, 10.0]"),
    ("sequence", "\"zyx\""),
    ("unit", "\"deg\""),
    ("law", "\"gravity\""),
    ("point", "0"),
    ("at", "[0.0, 0.0, 0.5]"),
];

/// The last key of a path, without its indices: `stiffness` of `forces[1].stiffness`.
pub(super) fn last_key(path: &str) -> &str {
    let last = path.rsplit('.').next().unwrap_or(path);
    last.split('[').next().unwrap_or(last)
}

/// The parameter of a law with this key.
fn parameter(key: &str) -> Option<&'static Parameter> {
    Law::ALL.iter().flat_map(|law| law.parameters).find(|parameter| parameter.key == key)
}

/// A value that would be right at `path`; `None` where none is known.
pub(super) fn value(path: &str) -> Option<String> {
    let key = last_key(path);
    if path.ends_with(']') {
        return Some(item(path, key).to_owned());
    }
    let known = EXAMPLES.iter().find(|(known, _)| *known == key).map(|(_, value)| (*value).to_owned());
    known.or_else(|| parameter(key).map(|parameter| parameter.example.to_string()))
}

/// An item of a list that would be right: a mass point, a law, a place, else a number.
fn item(path: &str, key: &str) -> &'static str {
    match key {
        "points" => "{ mass = 1.0, position = [0.5, 0.0, 0.0] }",
        "forces" => "{ law = \"gravity\", acceleration = [0.0, 0.0, -9.81] }",
        "massless" if !path.contains("][") => "[0.0, 0.0, 1.0]",
        _ => "1.0",
    }
}

/// A whole line that would be right for the key at `path`.
pub(super) fn line(path: &str) -> String {
    let key = last_key(path);
    value(path).map_or_else(|| format!("{key} = 1.0"), |value| format!("{key} = {value}"))
}

/// A line that would be right in place of the value at `path`, in words where there is a choice.
pub(super) fn example(path: &str) -> String {
    let (key, line) = (last_key(path), line(path));
    if path.ends_with(']') {
        return value(path).unwrap_or_default();
    }
    match (key, parameter(key).map(|parameter| parameter.kind)) {
        ("body", _) => "a table [body] with points, or with mass and inertia".to_owned(),
        ("initial", _) => "a table [initial]".to_owned(),
        ("forces", _) => "a table [[forces]] for each law".to_owned(),
        ("inertia", _) | (_, Some(Kind::Matrix)) => format!("{line}, or three rows of three numbers"),
        (_, Some(Kind::PerPoint)) => format!("{line}, or a list of one for each point"),
        (_, Some(Kind::Axes)) => {
            TorqueAxes::ALL.map(|axes| format!("{key} = \"{}\"", axes.word())).join(" or ")
        }
        _ => line,
    }
}

/// The name nearest to a text that is a name of a scene.
pub(super) fn kebab(text: &str) -> String {
    let lower = text.to_lowercase();
    let words = lower.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let mut name = String::new();
    for word in words {
        if name.len() + 1 + word.len() > 100 {
            break;
        }
        name += if name.is_empty() { "" } else { "-" };
        name += word;
    }
    if name.is_empty() { "my-scene".to_owned() } else { name }
}

/// A text short enough for a message, on one line.
pub(super) fn shortened(text: &str) -> String {
    let mut shown: String = text.chars().take(40).flat_map(char::escape_debug).collect();
    if text.chars().nth(40).is_some() {
        shown.push('…');
    }
    shown
}

/// The candidates that a mistyped word may stand for, the closest first.
pub(super) fn nearest<'c>(word: &str, candidates: impl Iterator<Item = &'c str>) -> Vec<&'c str> {
    #[cfg(not(feature = "cli"))]
    let distance = |_: &str| usize::MAX;
    #[cfg(feature = "cli")]
    let distance = |candidate: &str| strsim::damerau_levenshtein(word, candidate);
    // One slip in a short word, one in four letters of a long one: more is another word.
    let allowed = 1 + word.chars().count() / 4;
    let mut close: Vec<_> = candidates
        .map(|candidate| (distance(candidate), candidate))
        .filter(|(distance, _)| *distance <= allowed)
        .collect();
    close.sort();
    close.into_iter().map(|(_, candidate)| candidate).take(3).collect()
}

/// The three names that a mistyped one most likely stands for, the likeliest first: the fewest slips, then the longest common part.
pub(crate) fn three_nearest<'c>(word: &str, names: impl Iterator<Item = &'c str>) -> Vec<&'c str> {
    let names: Vec<&str> = names.collect();
    let mut near = nearest(word, names.iter().copied());
    #[cfg(not(feature = "cli"))]
    let likeness = |_: &str| 0.0f64;
    #[cfg(feature = "cli")]
    let likeness = |name: &str| strsim::jaro_winkler(word, name);
    let mut others: Vec<&str> = names.into_iter().filter(|name| !near.contains(name)).collect();
    others.sort_by(|a, b| {
        let has = |name: &str| !word.is_empty() && name.contains(word);
        has(b).cmp(&has(a)).then(likeness(b).total_cmp(&likeness(a)))
    });
    near.extend(others);
    near.truncate(3);
    near
}

/// "a, b or c".
pub(crate) fn one_of(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [others @ .., last] => format!("{} or {last}", others.join(", ")),
    }
}

/// Numbers as TOML writes them.
pub(super) fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|x| format!("{x:?}")).collect();
    format!("[{}]", numbers.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_key_of_a_path_has_no_index() {
        assert_eq!(last_key("forces[1].stiffness"), "stiffness");
        assert_eq!(last_key("body.inertia[0][2]"), "inertia");
        assert_eq!(last_key("name"), "name");
    }

    #[test]
    fn a_slip_is_recognised_and_another_word_is_not() {
        let known = || ["stiffness", "damping", "anchor"].into_iter();
        assert_eq!(nearest("stifness", known()), ["stiffness"]);
        assert!(nearest("colour", known()).is_empty());
    }

    #[cfg(feature = "cli")]
    #[test]
    fn three_names_are_given_whatever_was_typed() {
        let known = || ["euler", "peskin-rk2", "peskin-rk3", "peskin-heun", "rk4-quaternion"].into_iter();
        assert_eq!(three_nearest("peskin", known()).len(), 3);
        assert!(three_nearest("peskin", known()).iter().all(|name| name.starts_with("peskin")));
        assert_eq!(three_nearest("eulr", known())[0], "euler");
        assert_eq!(three_nearest("", known()).len(), 3);
        assert_eq!(one_of(&["a", "b", "c"]), "a, b or c");
    }
}
