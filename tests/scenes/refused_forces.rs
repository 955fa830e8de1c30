//! Bad starts and laws, each with the line and key that it is refused with.

use crate::given::{INERTIA, ROD, SINGLE, assert_refused, body, initial, law};
use polhode::scenes::Scene;

#[test]
fn a_bad_start_is_refused_with_line_and_key() {
    assert_refused(&[
        initial("speed = [0, 0, 0]", 10, "initial.speed", "the keys here are position"),
        initial(
            "angular-velocity = [0, 0, 1]",
            10,
            "initial.angular-velocity",
            "did you mean angular_velocity?",
        ),
        initial("velocity = 3.0", 10, "initial.velocity", "three numbers"),
        initial("position = [0, 0, 0, 0]", 10, "initial.position", "found a list of 4"),
        initial("velocity = [0, nan, 0]", 10, "initial.velocity[1]", "finite"),
        initial("orientation = [1, 0, 0]", 10, "initial.orientation", "four numbers"),
        initial(
            "orientation = [1, 0, 0, 1]",
            10,
            "initial.orientation",
            "write orientation = [0.70710678118654",
        ),
        initial("orientation = [1.00000001, 0, 0, 0]", 10, "initial.orientation", "length 1 to 1e-9"),
        initial(
            "orientation = [0, 0, 0, 0]",
            10,
            "initial.orientation",
            "write orientation = [1.0, 0.0, 0.0, 0.0]",
        ),
        initial(
            "angular_momentum = [0, 0, 1]\nangular_velocity = [0, 0, 1]",
            11,
            "initial.angular_velocity",
            "only one of the two",
        ),
        initial(
            "angular_velocity = [1e300, 1e300, 1e300]\nposition = [0, 0, 0]\n[[forces]]",
            12,
            "forces[0].law",
            "is missing",
        ),
        body(
            &format!("{ROD}[initial]\nangular_momentum = [0.5, 0, 1]"),
            6,
            "initial.angular_momentum",
            "along it",
        ),
        body(
            &format!("{ROD}[initial]\nangular_velocity = [0.5, 0, 1]"),
            6,
            "initial.angular_velocity",
            "write angular_velocity = [0.0, 0.0, 1.0]",
        ),
        body(
            &format!("{SINGLE}[initial]\nangular_momentum = [0, 0, 1]"),
            6,
            "initial.angular_momentum",
            "single point",
        ),
        body(
            &format!("{SINGLE}[initial]\nangular_velocity = [0, 0, 1]"),
            6,
            "initial.angular_velocity",
            "cannot spin",
        ),
        body(
            &format!("{INERTIA}pivot = [0, 0, -1]\n[initial]\nvelocity = [1, 0, 0]"),
            8,
            "initial.velocity",
            "the pivot and the spin give",
        ),
        body(
            "[body]\nmass = 1\ninertia = [1e200, 1e200, 1e200]\n[initial]\nangular_velocity = [1e200, 0, 0]",
            7,
            "initial.angular_velocity",
            "out of the range of f64",
        ),
    ]);
}

#[test]
fn a_bad_law_is_refused_with_line_and_key() {
    assert_refused(&[
        law("stiffness = 1.0", 12, "forces[1].law", "is missing"),
        law("law = 3", 13, "forces[1].law", "a text in quotes"),
        law("law = \"gravty\"\nacceleration = [0, 0, 1]", 13, "forces[1].law", "did you mean gravity?"),
        law("law = \"magic\"", 13, "forces[1].law", "the laws are gravity, spring"),
        law("law = \"gravity\"", 12, "forces[1].acceleration", "write acceleration = [0.0, 0.0, -9.81]"),
        law("law = \"gravity\"\nacceleration = -9.81", 14, "forces[1].acceleration", "three numbers"),
        law(
            "law = \"gravity\"\ng = [0, 0, 1]\nacceleration = [0, 0, 1]",
            14,
            "forces[1].g",
            "the keys here are law, acceleration",
        ),
        law("law = \"spring\"\nstiffness = 1.0", 12, "forces[1].point", "or at = [x, y, z]"),
        law("law = \"spring\"\npoint = 0", 12, "forces[1].stiffness", "is missing"),
        law(
            "law = \"spring\"\npoint = 0\nat = [0, 0, 0]\nstiffness = 1.0",
            15,
            "forces[1].at",
            "only one of the two",
        ),
        law("law = \"spring\"\npoint = 3\nstiffness = 1.0", 14, "forces[1].point", "write point = 0 to 2"),
        law("law = \"spring\"\npoint = -1\nstiffness = 1.0", 14, "forces[1].point", "counted from 0"),
        law("law = \"spring\"\npoint = 1.0\nstiffness = 1.0", 14, "forces[1].point", "counted from 0"),
        law(
            "law = \"spring\"\npoint = 0\nstiffness = \"stiff\"",
            15,
            "forces[1].stiffness",
            "expected a number, found the text \"stiff\": write stiffness = 100.0",
        ),
        law(
            "law = \"spring\"\npoint = 0\nstifness = 1.0",
            15,
            "forces[1].stifness",
            "did you mean stiffness?",
        ),
        law("law = \"drag\"", 12, "forces[1].coefficient", "is missing"),
        law("law = \"drag\"\ncoefficient = [1.0, 2.0]", 14, "forces[1].coefficient", "write 3 values"),
        law("law = \"drag\"\ncoefficient = [1.0, nan, 2.0]", 14, "forces[1].coefficient[1]", "finite"),
        law("law = \"drag\"\ncoefficient = \"some\"", 14, "forces[1].coefficient", "a number"),
        law("law = \"central-gravity\"", 12, "forces[1].mu", "is missing"),
        law("law = \"lorentz\"\ncharge = [1.0]", 14, "forces[1].charge", "write 3 values"),
        law("law = \"lorentz\"\nelectric = [1, 0, 0]", 12, "forces[1].charge", "is missing"),
        law("law = \"torque\"\nconstant = [0, 0, 1]", 12, "forces[1].axes", "is missing"),
        law("law = \"torque\"\naxes = \"bodies\"", 14, "forces[1].axes", "\"world\" or \"body\""),
        law("law = \"dipole\"\nmoment = [0, 0, 1]", 12, "forces[1].field", "is missing"),
        law(
            "law = \"gravity-gradient\"\nmu_over_r3 = 1.0\ndirection = [0, 0, 0]",
            15,
            "forces[1].direction",
            "zero vector",
        ),
        law("law = \"ground\"\nstiffness = 1.0\nnormal = [0, 0, 0.0]", 15, "forces[1].normal", "zero vector"),
        law(
            "law = \"ground\"\nstiffness = 1.0\nfriction = 0.5\nslip_velocity = 0",
            16,
            "forces[1].slip_velocity",
            "above zero where there is friction",
        ),
        body(
            "[body]\nmass = 1\ninertia = [0.5, 2, 3]\nunphysical_inertia = true\n[[forces]]\nlaw = \"drag\"\ncoefficient = 1",
            8,
            "forces[0].law",
            "no positive masses",
        ),
        body(
            "[body]\nmass = 1\ninertia = [0.5, 2, 3]\nunphysical_inertia = true\n[[forces]]\nlaw = \"spring\"\npoint = 0\nstiffness = 1",
            9,
            "forces[0].point",
            "write at = [x, y, z]",
        ),
        body(
            "[body]\nmass = 1\ninertia = [1, 2, 2.5]\n[forces]\nlaw = \"gravity\"",
            6,
            "forces",
            "[[forces]]",
        ),
        body("forces = [1]\n[body]\nmass = 1\ninertia = [1, 2, 2.5]", 3, "forces[0]", "a table"),
    ]);
}

#[test]
fn a_spring_off_the_line_of_a_rod_is_refused_and_one_on_it_is_not() {
    let spring = |at: &str| {
        format!("{ROD}[[forces]]\nlaw = \"spring\"\nat = {at}\nanchor = [0, 0, 2]\nstiffness = 1.0")
    };
    assert_refused(&[body(&spring("[0.5, 0.1, 0.0]"), 7, "forces[0].at", "fastened on its line")]);
    Scene::parse(&body(&spring("[0.5, 0.0, 0.0]"), 0, "", "").text, "scene.toml")
        .expect("a spring on the rod");
}

#[test]
fn an_error_reads_as_one_sentence_with_file_line_and_key() {
    let bad = law("law = \"spring\"\npoint = 0\nstiffness = true", 15, "forces[1].stiffness", "");
    let error = Scene::parse(&bad.text, "scene.toml").expect_err("no number");
    assert_eq!(
        error.to_string(),
        "scene.toml:15: forces[1].stiffness: expected a number, found true: write stiffness = 100.0"
    );
}
