//! What error messages suggest: an example for every key of the format, and the word that was meant.

/// Every key of a scene file, and a line that would be right.
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
    ("angular_momentum", "angular_momentum = [0.0, 0.0, 1.0]"),
    ("law", "law = \"gravity\""),
    ("acceleration", "acceleration = [0.0, 0.0, -9.81]"),
    ("point", "point = 0"),
    ("at", "at = [0.0, 0.0, 0.5]"),
    ("anchor", "anchor = [0.0, 0.0, 0.0]"),
    ("stiffness", "stiffness = 100.0"),
    ("damping", "damping = 0.0"),
    ("rest_length", "rest_length = 0.0"),
    ("coefficient", "coefficient = 0.1, or a list of one for each point"),
    ("mu", "mu = 8.0"),
    ("center", "center = [0.0, 0.0, 0.0]"),
    ("charge", "charge = 1.0, or a list of one for each point"),
    ("electric", "electric = [0.0, 0.0, 1.0]"),
    ("electric_cosine", "electric_cosine = [0.0, 0.0, 1.0]"),
    ("electric_sine", "electric_sine = [0.0, 0.0, 1.0]"),
    ("frequency", "frequency = 2.0"),
    ("magnetic", "magnetic = [0.0, 0.0, 1.0]"),
    ("axes", "axes = \"body\" or axes = \"world\""),
    ("constant", "constant = [0.0, 0.0, 1.0]"),
    ("cosine", "cosine = [0.0, 0.0, 1.0]"),
    ("sine", "sine = [0.0, 0.0, 1.0]"),
    ("moment", "moment = [0.0, 0.0, 1.0]"),
    ("field", "field = [0.0, 0.1, 0.0]"),
    ("mu_over_r3", "mu_over_r3 = 1.0"),
    ("direction", "direction = [1.0, 0.0, 0.0]"),
    ("normal", "normal = [0.0, 0.0, 1.0]"),
    ("rate", "rate = 0.0"),
    ("height", "height = 0.0"),
    ("friction", "friction = 0.3"),
    ("slip_velocity", "slip_velocity = 1.0e-3"),
];

/// The last key of a path, without its indices: `stiffness` of `forces[1].stiffness`.
pub(super) fn last_key(path: &str) -> &str {
    let last = path.rsplit('.').next().unwrap_or(path);
    last.split('[').next().unwrap_or(last)
}

/// A line that would be right in place of the value at `path`.
pub(super) fn example(path: &str) -> &'static str {
    let key = last_key(path);
    EXAMPLES.iter().find(|(known, _)| *known == key).map_or("a value that fits", |(_, line)| *line)
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
}
