//! What an engine is asked in the conformance run: a free body, and one under every law.

use crate::model::System;
use crate::scenes::Scene;

/// A free asymmetric body, turned, off the origin, spinning off every axis: no frame can be mistaken for another.
const FREE: &str = "name = \"check\"\nduration = 1.0\n[body]\nmass = 2.0\n\
    inertia = [[1.0, 0.1, 0.0], [0.1, 2.0, 0.2], [0.0, 0.2, 2.5]]\nPIVOT\n[initial]\nposition = [1.0, -2.0, 0.5]\n\
    orientation = [0.5, 0.5, -0.5, 0.5]\nvelocity = [0.3, 0.2, -0.1]\nangular_velocity = [1.0, -0.7, 2.0]\n";

/// A law of every name, as in a scene file.
pub(super) const LAWS: [(&str, &str); 9] = [
    ("gravity", "acceleration = [0.0, 0.0, -9.81]"),
    ("spring", "point = 0\nanchor = [0.0, 0.0, 1.0]\nstiffness = 1.0"),
    ("drag", "coefficient = 0.1"),
    ("central-gravity", "mu = 1.0"),
    ("lorentz", "charge = 1.0\nmagnetic = [0.0, 0.0, 1.0]"),
    ("torque", "axes = \"body\"\nconstant = [0.0, 0.0, 0.1]"),
    ("dipole", "moment = [0.0, 0.0, 1.0]\nfield = [0.0, 0.1, 0.0]"),
    ("gravity-gradient", "mu_over_r3 = 0.1\ndirection = [1.0, 0.0, 0.0]"),
    ("ground", "stiffness = 100.0"),
];

/// The entry of a law in a scene file; empty for a name that is none.
pub(super) fn law(name: &str) -> String {
    let entry = LAWS.iter().find(|(law, _)| *law == name);
    entry.map_or_else(String::new, |(law, lines)| format!("[[forces]]\nlaw = \"{law}\"\n{lines}\n"))
}

/// The body under forces, or on a pivot.
///
/// # Panics
/// The scene of this file is not a scene, which a test rules out.
pub(super) fn scene(forces: &str, pivot: &str) -> System {
    let text = FREE.replace("PIVOT", pivot) + forces;
    let text = if pivot.is_empty() { text } else { text.replace("velocity = [0.3, 0.2, -0.1]\n", "") };
    Scene::parse(&text, "the scene of the check").expect("the scene of the check is a scene").system
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::hello;
    use crate::model::forces::Law;

    #[test]
    fn the_scenes_of_the_check_cover_every_law() {
        for (law, _) in Law::NAMES {
            let (_, lines) = LAWS.iter().find(|(name, _)| *name == law).expect("a line for every law");
            let system = scene(&format!("[[forces]]\nlaw = \"{law}\"\n{lines}\n"), "");
            assert_eq!(system.forces.laws()[0].name(), law);
        }
        assert!(scene("", "pivot = [0.1, 0.2, -0.3]").body.pivoted);
        assert_eq!(hello::refusal(Some(&[]), &scene("", "")), None);
    }
}
