//! Bad heads and bodies, each with the line and key that it is refused with.

use crate::given::{Bad, POINTS, assert_refused, body, head};

#[test]
fn a_bad_head_is_refused_with_line_and_key() {
    assert_refused(&[
        Bad { text: String::new(), line: 1, key: "", says: "the scene is empty" },
        Bad { text: "# nothing\n".into(), line: 1, key: "", says: "the scene is empty" },
        Bad { text: "name = \"a\"\nthis is no TOML\n".into(), line: 2, key: "", says: "not TOML" },
        Bad {
            text: "name = \"a\"\nduration = 1.0\nduration = 2.0\n".into(),
            line: 3,
            key: "",
            says: "duplicate",
        },
        Bad {
            text: "name = \"a\"\nduration = 5.0\n".into(),
            line: 1,
            key: "body",
            says: "write a table [body]",
        },
        head("duration = 5.0", 1, "name", "write name = \"my-scene\""),
        head("name = \"a\"", 1, "duration", "write duration = 10.0"),
        head("name = 7\nduration = 5.0", 1, "name", "a text in quotes, found 7"),
        head("name = \"My Scene\"\nduration = 5.0", 1, "name", "kebab-case"),
        head("name = \"../up\"\nduration = 5.0", 1, "name", "kebab-case"),
        head("name = \"a--b\"\nduration = 5.0", 1, "name", "kebab-case"),
        head("name = \"\"\nduration = 5.0", 1, "name", "kebab-case"),
        head("name = \"a\"\nduration = 0", 2, "duration", "above zero, found 0"),
        head("name = \"a\"\nduration = -1.5", 2, "duration", "above zero, found -1.5"),
        head("name = \"a\"\nduration = nan", 2, "duration", "a finite number, found nan"),
        head("name = \"a\"\nduration = inf", 2, "duration", "a finite number, found inf"),
        head("name = \"a\"\nduration = 1e999", 2, "duration", "a finite number, found 1e999"),
        head(
            "name = \"a\"\nduration = \"5 s\"",
            2,
            "duration",
            "found the text \"5 s\": write duration = 10.0",
        ),
        head("name = \"a\"\nduraton = 5.0", 2, "duraton", "did you mean duration?"),
        head("name = \"a\"\nduration = 5.0\ncolour = 1", 3, "colour", "the keys here are name, title"),
        head("name = \"a\"\nduration = 5.0\nnot_for_order = true", 3, "not_for_order", "a text in quotes"),
        head(
            "name = \"a\"\nduration = 5.0\nnot_for_order = \" \"",
            3,
            "not_for_order",
            "the reason in words",
        ),
        head("name = \"a\"\nduration = 5.0\ntitle = 1", 3, "title", "a text in quotes"),
        head("name = \"a\"\nduration = 5.0\nforces = 3", 3, "forces", "[[forces]]"),
    ]);
}

#[test]
fn a_bad_body_is_refused_with_line_and_key() {
    assert_refused(&[
        body("body = 1", 3, "body", "a table"),
        body("[[body]]\nmass = 1.0", 3, "body", "write a table [body]"),
        body("[body]", 3, "body.points", "is missing"),
        body("[body]\nmass = 1.0", 3, "body.points", "is missing"),
        body("[body]\npoints = []", 4, "body.points", "at least one mass point"),
        body("[body]\npoints = 1", 4, "body.points", "a list of mass points"),
        body("[body]\npoints = [1.0]", 4, "body.points[0]", "a table"),
        body("[body]\npoints = [ { mass = 1.0 } ]", 4, "body.points[0].position", "is missing"),
        body("[body]\npoints = [ { position = [0, 0, 0] } ]", 4, "body.points[0].mass", "is missing"),
        body(
            "[body]\npoints = [\n  { mass = 1.0, position = [0, 0, 0] },\n  { mass = 0.0, position = [1, 0, 0] },\n]",
            6,
            "body.points[1].mass",
            "above zero, found 0.0: write mass = 1.0",
        ),
        body(
            "[body]\npoints = [ { mass = -1, position = [0, 0, 0] } ]",
            4,
            "body.points[0].mass",
            "above zero",
        ),
        body("[body]\npoints = [ { mass = nan, position = [0, 0, 0] } ]", 4, "body.points[0].mass", "finite"),
        body(
            "[body]\npoints = [\n  { mass = 1.0, position = [0, 0] },\n]",
            5,
            "body.points[0].position",
            "three numbers, found a list of 2",
        ),
        body(
            "[body]\npoints = [ { mass = 1, position = [0, inf, 0] } ]",
            4,
            "body.points[0].position[1]",
            "finite",
        ),
        body(
            "[body]\npoints = [ { mass = 1, position = [0, \"x\", 0] } ]",
            4,
            "body.points[0].position[1]",
            "a number",
        ),
        body(
            "[body]\npoints = [ { mass = 1, positon = [0, 0, 0] } ]",
            4,
            "body.points[0].positon",
            "mean position?",
        ),
        body(&format!("{POINTS}mass = 3.5"), 9, "body.mass", "remove it"),
        body(&format!("{POINTS}unphysical_inertia = true"), 9, "body.unphysical_inertia", "remove it"),
        body(&format!("{POINTS}inertia = [1, 2, 2.5]"), 9, "body.inertia", "only one of the two"),
        body(&format!("{POINTS}pivot = [0, 0]"), 9, "body.pivot", "three numbers"),
        body("[body]\ninertia = [1, 2, 2.5]", 3, "body.mass", "is missing"),
        body("[body]\nmass = 0\ninertia = [1, 2, 2.5]", 4, "body.mass", "above zero"),
        body("[body]\nmass = 1\ninertia = [1, 2]", 5, "body.inertia", "found a list of 2"),
        body("[body]\nmass = 1\ninertia = 2.0", 5, "body.inertia", "three principal moments"),
        body("[body]\nmass = 1\ninertia = [[1, 0, 0], [0, 2, 0]]", 5, "body.inertia", "three rows"),
        body(
            "[body]\nmass = 1\ninertia = [\n  [1, 0, 0],\n  [0, 2],\n  [0, 0, 2],\n]",
            7,
            "body.inertia[1]",
            "found a list of 2",
        ),
        body("[body]\nmass = 1\ninertia = [1.0, [0, 2, 0], 2.0]", 5, "body.inertia[0]", "three numbers"),
        body(
            "[body]\nmass = 1\ninertia = [\n  [1, 0.1, 0],\n  [0, 2, 0],\n  [0, 0, 2],\n]",
            6,
            "body.inertia[0][1]",
            "not symmetric",
        ),
        body("[body]\nmass = 1\ninertia = [0.5, 2, 3]", 5, "body.inertia", "unphysical_inertia = true"),
        body(
            "[body]\nmass = 1\ninertia = [-1, 2, 3]\nunphysical_inertia = true",
            5,
            "body.inertia",
            "negative",
        ),
        body("[body]\nmass = 1\ninertia = [nan, 2, 3]", 5, "body.inertia[0]", "finite"),
        body("[body]\nmass = 1\ninertia = [1e-13, 1, 1]", 5, "body.inertia", "differ by more than 1e12"),
        body(
            "[body]\nmass = 1\ninertia = [1, 2, 2.5]\nunphysical_inertia = 1",
            6,
            "body.unphysical_inertia",
            "true or false",
        ),
        body(
            "[body]\npoints = [ { mass = 1, position = [1e200, 0, 0] }, { mass = 1, position = [0, 1e200, 0] } ]",
            4,
            "body.points",
            "outside the range of f64",
        ),
        body(
            "[body]\npoints = [ { mass = 1, position = [1e-170, 0, 0] }, { mass = 1, position = [0, 1e-170, 0] } ]",
            4,
            "body.points",
            "outside the range of f64",
        ),
    ]);
}
