//! What an engine is asked in the conformance run: a free body, and one under every law.

use crate::model::System;
use crate::model::forces::Law;
use crate::scenes::{Scene, block};

/// A free asymmetric body, turned, off the origin, spinning off every axis: no frame can be mistaken for another.
const FREE: &str = "name = \"check\"\nduration = 1.0\n[body]\nmass = 2.0\n\
    inertia = [[1.0, 0.1, 0.0], [0.1, 2.0, 0.2], [0.0, 0.2, 2.5]]\nPIVOT\n[initial]\nposition = [1.0, -2.0, 0.5]\n\
    orientation = [0.5, 0.5, -0.5, 0.5]\nvelocity = [0.3, 0.2, -0.1]\nangular_velocity = [1.0, -0.7, 2.0]\n";

/// The entry of a law in a scene file; empty for a name that is none.
pub(super) fn law(name: &str) -> String {
    Law::ALL.iter().find(|law| law.name == name).map_or_else(String::new, block)
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

    #[test]
    fn the_scenes_of_the_check_cover_every_law() {
        for described in &Law::ALL {
            let system = scene(&law(described.name), "");
            assert_eq!(system.forces.laws(), [described.example()]);
        }
        assert!(scene("", "pivot = [0.1, 0.2, -0.3]").body.pivoted);
        assert_eq!(hello::refusal(Some(&[]), &scene("", "")), None);
    }
}
