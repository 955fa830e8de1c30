//! The files of `references/published`.

use crate::scenes::{Scene, SceneError};

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        /// Name and text of every scene that figures are published for and that is not built in.
        pub const SCENES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../../references/published/", $name, ".toml")))),*];
    };
}

files! {
    "bruls-cardona-heavy-top",
    "exudyn-heavy-top-02",
    "kynema-heavy-top-08",
    "nesc-case-2-rates",
    "detest-b5-euler",
    "toutatis-principia",
    "basilisk-sc-rotation",
    "basilisk-sc-rotation-2",
    "jeod-run-10a",
    "jeod-run-10a-orbit",
    "jeod-pitch-libration",
    "gazebo-boxes",
    "orekit-torque-free",
    "solfec-krysl-top",
    "modelica-free-body",
    "chrono-adams-spherical",
    "desolve-rigid-body",
    "poinsot-flip",
}

/// The figures.
pub(super) const FIGURES: &str = include_str!("../../../references/published/figures.toml");

/// A scene of this list, or a built-in one.
pub(super) fn scene(name: &str) -> Result<Scene, SceneError> {
    match SCENES.iter().find(|(known, _)| *known == name) {
        Some((_, text)) => Scene::parse(text, &format!("references/published/{name}.toml")),
        None => Scene::find(name),
    }
}
