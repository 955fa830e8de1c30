//! Malformed scenes: every fault is found in one reading, and the proposed texts mend the file.

use polhode::scenes::{Fault, Scene, SceneError};

const GOOD: &str = r#"name = "good-scene"
title = "A scene"
duration = 5.0

[body]
points = [
  { mass = 1.0, position = [1.0, 0.0, 0.5] },
  { mass = 2.0, position = [0.0, 1.0, 0.0] },
  { mass = 0.5, position = [-1.0, 0.25, 1.0] },
]

[initial]
position = [0.0, 0.0, 1.0]
orientation = [1.0, 0.0, 0.0, 0.0]
velocity = [0.5, 0.0, 0.0]
angular_velocity = [0.0, 0.0, 2.0]

[[forces]]
law = "gravity"
acceleration = [0.0, 0.0, -9.81]

[[forces]]
law = "spring"
point = 1
anchor = [0.0, 0.0, 3.0]
stiffness = 100.0

[[forces]]
law = "torque"
axes = "body"
constant = [0.0, 0.0, 0.375]

[[forces]]
law = "drag"
coefficient = 0.1
"#;

/// A piece of the good scene, what stands in its place, and the key that is then wrong. One list for each line or table: a
/// scene has one of each list at most.
const KINDS: &[&[(&str, &str, &str)]] = &[
    &[
        ("name = \"good-scene\"\n", "name = \"Good Scene\"\n", "name"),
        ("name = \"good-scene\"\n", "name = \"_\"\n", "name"),
        ("name = \"good-scene\"\n", "", "name"),
        ("name = \"good-scene\"\n", "nme = \"good-scene\"\n", "nme"),
    ],
    &[("title = \"A scene\"", "title = 7", "title"), ("title =", "titel =", "titel")],
    &[
        ("duration = 5.0", "duration = -5.0", "duration"),
        ("duration = 5.0", "duration = \"five\"", "duration"),
        ("duration = 5.0\n", "", "duration"),
    ],
    &[
        ("{ mass = 2.0, position", "{ mass = -2.0, position", "body.points[1].mass"),
        ("{ mass = 2.0, position", "{ position", "body.points[1].mass"),
        ("{ mass = 2.0, position", "{ mass = nan, position", "body.points[1].mass"),
        ("{ mass = 2.0, position", "{ mas = 2.0, position", "body.points[1].mas"),
    ],
    &[
        ("[-1.0, 0.25, 1.0]", "[-1.0, 0.25]", "body.points[2].position"),
        ("[-1.0, 0.25, 1.0]", "[-1.0, \"a\", 1.0]", "body.points[2].position[1]"),
        ("[-1.0, 0.25, 1.0]", "3", "body.points[2].position"),
    ],
    &[("]\n\n[initial]", "]\nmass = 3.5\n\n[initial]", "body.mass")],
    &[("orientation = [1.0, 0.0, 0.0, 0.0]", "orientation = [1.0, 0.0, 0.0, 1.0]", "initial.orientation")],
    &[
        ("velocity = [0.5, 0.0, 0.0]", "velocity = [0.5, nan, 0.0]", "initial.velocity[1]"),
        ("velocity = [0.5, 0.0, 0.0]", "velocity = 0.5", "initial.velocity"),
    ],
    &[
        ("angular_velocity =", "angular_velocty =", "initial.angular_velocty"),
        (
            "angular_velocity = [0.0, 0.0, 2.0]",
            "angular_velocity = [0.0, 0.0, 2.0]\nangular_momentum = [0.0, 0.0, 2.0]",
            "initial.angular_momentum",
        ),
    ],
    &[
        ("law = \"gravity\"", "law = \"gravitty\"", "forces[0].law"),
        ("acceleration = [0.0, 0.0, -9.81]\n", "", "forces[0].acceleration"),
        ("acceleration = [0.0", "acceleration = [true", "forces[0].acceleration[0]"),
    ],
    &[("point = 1\n", "point = -1\n", "forces[1].point"), ("point = 1\n", "", "forces[1].point")],
    &[("anchor = [0.0, 0.0, 3.0]", "anchor = [0.0, 0.0, \"3\"]", "forces[1].anchor[2]")],
    &[
        ("stiffness = 100.0", "stifness = 100.0", "forces[1].stifness"),
        ("stiffness = 100.0", "stiffness = \"100 N/m\"", "forces[1].stiffness"),
    ],
    &[
        ("axes = \"body\"", "axes = \"bdy\"", "forces[2].axes"),
        ("axes = \"body\"\n", "", "forces[2].axes"),
        ("axes = \"body\"", "axes = 3", "forces[2].axes"),
    ],
    &[("constant = [0.0, 0.0, 0.375]", "constant = 0.375", "forces[2].constant")],
    &[
        ("coefficient = 0.1", "coefficient = \"low\"", "forces[3].coefficient"),
        ("coefficient = 0.1", "coefficient = 0.1\ncolour = \"red\"", "forces[3].colour"),
        ("coefficient = 0.1", "coefficient = [0.1, 0.2, inf]", "forces[3].coefficient[2]"),
    ],
];

/// The malformed scene of this number, with the keys that are wrong, in the order of the file: one to six faults.
fn malformed(number: usize) -> (String, Vec<&'static str>) {
    let (mut text, mut keys) = (GOOD.to_owned(), Vec::new());
    // Steps without a common divisor with the number of lists come to different ones.
    let chosen: Vec<usize> = (0..1 + number % 6).map(|k| (number + k * 5) % KINDS.len()).collect();
    for (place, kinds) in KINDS.iter().enumerate().filter(|(place, _)| chosen.contains(place)) {
        let (good, bad, key) = kinds[(number / KINDS.len() + place) % kinds.len()];
        assert!(text.contains(good), "{good}");
        text = text.replacen(good, bad, 1);
        keys.push(key);
    }
    (text, keys)
}

fn faults_of(text: &str) -> Vec<Fault> {
    match Scene::parse(text, "bad.toml") {
        Err(SceneError::Content { faults, .. }) => faults,
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("read:\n{text}"),
    }
}

/// The text with every proposal in it, the last first.
fn mended(text: &str, faults: &[Fault]) -> String {
    let mut mends: Vec<_> =
        faults.iter().map(|f| f.mend.as_ref().unwrap_or_else(|| panic!("{f:#?}"))).collect();
    mends.sort_by_key(|mend| mend.span.start);
    mends.iter().rev().fold(text.to_owned(), |text, mend| mend.apply(&text))
}

#[test]
fn every_fault_of_a_hundred_malformed_scenes_is_found_at_once_and_its_proposal_mends_it() {
    assert!(Scene::parse(GOOD, "good.toml").is_ok());
    let mut several = 0;
    for number in 0..100 {
        let (text, mut expected) = malformed(number);
        let faults = faults_of(&text);
        let mut found: Vec<&str> = faults.iter().map(|fault| fault.key.as_str()).collect();
        found.sort_unstable();
        expected.sort_unstable();
        assert_eq!(found, expected, "{text}\n{faults:#?}");
        several += usize::from(faults.len() > 1);
        let right = mended(&text, &faults);
        assert!(
            Scene::parse(&right, "mended.toml").is_ok(),
            "{text}\nmended:\n{right}\n{:?}",
            faults_of(&right)
        );
        for fault in &faults {
            assert!(fault.line >= 1 && text.get(fault.span.clone()).is_some(), "{fault:?}");
        }
    }
    assert!(several > 50, "{several}");
}

#[test]
fn every_kind_of_fault_marks_its_line_and_quotes_what_was_written() {
    for (good, bad, key) in KINDS.iter().flat_map(|kinds| kinds.iter()) {
        let text = GOOD.replacen(good, bad, 1);
        let faults = faults_of(&text);
        let [fault] = &faults[..] else { panic!("{text}\n{faults:#?}") };
        assert_eq!(&fault.key, key);
        let line = text.lines().nth(fault.line - 1).unwrap_or_default();
        let last = key.rsplit('.').next().unwrap_or(key).split('[').next().unwrap_or(key);
        let missing = fault.message == "is missing";
        assert!(missing || line.contains(last), "{key}: line {} is {line}", fault.line);
    }
}

#[test]
fn what_contradicts_the_body_is_found_for_every_law_and_mended() {
    let text = GOOD
        .replace("point = 1", "point = 9")
        .replace("coefficient = 0.1", "coefficient = [0.1, 0.2]")
        .replace("law = \"torque\"", "law = \"torque\" # kept");
    let faults = faults_of(&text);
    let keys: Vec<&str> = faults.iter().map(|fault| fault.key.as_str()).collect();
    assert_eq!(keys, ["forces[1].point", "forces[3].coefficient"]);
    assert!(Scene::parse(&mended(&text, &faults), "mended.toml").is_ok());
    let rod = "name = \"rod\"\nduration = 1.0\n[body]\npoints = [{ mass = 1, position = [-1, 0, 0] }, { mass = 1, position = [1, 0, 0] }]\n[initial]\n";
    for start in [
        "angular_velocity = [0.5, 0, 1]",
        "orientation = [0.6, 0, 0, 0.8]\nangular_velocity_body = [0.5, 0, 1]",
    ] {
        let text = format!("{rod}{start}\n");
        assert!(Scene::parse(&mended(&text, &faults_of(&text)), "mended.toml").is_ok(), "{text}");
    }
    let lopsided = "name = \"a\"\nduration = 1.0\n[body]\nmass = 1.0\ninertia = [[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1.5]]\n";
    assert!(Scene::parse(&mended(lopsided, &faults_of(lopsided)), "mended.toml").is_ok());
}

#[test]
fn every_error_of_the_syntax_is_found() {
    let faults = faults_of("name = good\nduration = = 3\n[body]\nmass = 1.0\n");
    assert!(faults.len() >= 2, "{faults:?}");
    assert_eq!(faults[0].line, 1);
    let unquoted = GOOD.replace("\"good-scene\"", "good-scene");
    let faults = faults_of(&unquoted);
    assert_eq!(mended(&unquoted, &faults), GOOD);
}
