//! What error messages suggest: an example for every key of the format, and the word that was meant.

use crate::model::forces::{Kind, Law, TorqueAxes};

/// Keys of a scene file, and a line that would be right. Those of the laws stand in their tables.
const EXAMPLES: &[(&str, &str)] = &[
    ("name", "name = \"my-scene\""),
    ("title", "title = \"One line for the report\""),
    ("why", "why = \"what this scene shows that others do not\""),
    ("duration", "duration = 10.0"),
    ("not_for_order", "not_for_order = \"the reason\""),
    ("only_for_stability", "only_for_stability = \"the reason\""),
    ("body", "a table [body] with points, or with mass and inertia"),
    ("initial", "a table [initial]"),
    ("forces", "a table [[forces]] for each law"),
    ("points", "points = [ { mass = 1.0, position = [0.5, 0.0, 0.0] }, … ]"),
    ("mass", "mass = 1.0"),
    ("inertia", "inertia = [1.0, 2.0, 2.5], or three rows of three numbers"),
    ("unphysical_inertia", "unphysical_inertia = true"),
    ("pivot", "pivot = [0.0, 0.0, 0.0]"),
    ("position", "position = [0.0, 0.0, 0.0]"),
    ("orientation", "orientation = [1.0, 0.0, 0.0, 0.0]"),
    ("velocity", "velocity = [0.0, 0.0, 0.0]"),
    ("angular_velocity", "angular_velocity = [0.0, 0.0, 1.0]"),
    ("angular_velocity_body", "angular_velocity_body = [0.0, 0.0, 1.0]"),
    ("angular_momentum", "angular_momentum = [0.0, 0.0, 1.0]"),
    ("euler", "euler = [30.0, 20.0, 10.0]"),
    ("sequence", "sequence = \"zyx\""),
    ("unit", "unit = \"deg\""),
    ("law", "law = \"gravity\""),
    ("point", "point = 0"),
    ("at", "at = [0.0, 0.0, 0.5]"),
];

/// The last key of a path, without its indices: `stiffness` of `forces[1].stiffness`.
pub(super) fn last_key(path: &str) -> &str {
    let last = path.rsplit('.').next().unwrap_or(path);
    last.split('[').next().unwrap_or(last)
}

/// A line that would be right in place of the value at `path`.
pub(super) fn example(path: &str) -> String {
    let key = last_key(path);
    if let Some((_, line)) = EXAMPLES.iter().find(|(known, _)| *known == key) {
        return (*line).to_owned();
    }
    let Some(parameter) = Law::ALL.iter().flat_map(|law| law.parameters).find(|p| p.key == key) else {
        return "a value that fits".to_owned();
    };
    let line = format!("{key} = {}", parameter.example);
    match parameter.kind {
        Kind::PerPoint => format!("{line}, or a list of one for each point"),
        Kind::Axes => TorqueAxes::ALL.map(|axes| format!("{key} = \"{}\"", axes.word())).join(" or "),
        _ => line,
    }
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
