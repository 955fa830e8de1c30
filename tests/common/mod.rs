//! What the tests share: things of the library by their name, and the program as a user runs it.

#![allow(dead_code, reason = "each binary uses its own part")]

pub mod pieces;
pub mod program;

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::Matrix3;
use polhode::internals::reference::{Stored, stored};
use polhode::model::Snapshot;
use polhode::scenes::Scene;
use polhode::simulate::Contestant;

/// A scheme of the list.
pub fn contestant(name: &str) -> Contestant {
    Contestant::all().into_iter().find(|c| c.card.name == name).expect("a scheme of the list")
}

/// A built-in scene.
pub fn scene(name: &str) -> Scene {
    Scene::find(name).expect("a built-in scene")
}

/// The stored solution of a scene that has one.
pub fn stored_of(name: &str) -> Stored {
    stored::find(name).expect("sound").expect("stored")
}

/// R, body to world.
pub fn matrix(snapshot: &Snapshot) -> Matrix3<f64> {
    snapshot.orientation.to_rotation_matrix().into_inner()
}

/// The pictures of a report, by name.
pub fn plots(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.join("plots")).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    paths
}
