//! Maps over two parameters, each with the theory that there is drawn over it.
//!
//! A row of cells is one [`crate::study::ensemble::Ensemble`]. A cell whose run breaks is a cell like any other.

mod bounce;
mod drag;
mod free;
mod grid;
mod middle_axis;
mod sleeping;
mod spring;
mod thin;

use std::time::Instant;

use crate::record::stability::{Map, MapAxis};
use crate::simulate::Contestant;

use grid::Grid;

/// The maps, by name.
pub const NAMES: [&str; 9] = [
    "spring-stiffness",
    "spring-damping",
    "free-shapes",
    "free-spin-step",
    "sleeping-top",
    "middle-axis",
    "thin-bodies",
    "stiff-drag",
    "bounce",
];

/// Draws a map with so many cells along either axis; `None` where the scheme cannot take it, or the name is none of [`NAMES`].
pub fn map(name: &str, contestant: &Contestant, cells: usize) -> Option<Map> {
    let before = Instant::now();
    let drawn = match name {
        "spring-stiffness" => spring::stiffness(contestant, cells),
        "spring-damping" => spring::damping(contestant, cells),
        "free-shapes" => free::shapes(contestant, cells),
        "free-spin-step" => free::spin_step(contestant, cells),
        "sleeping-top" => sleeping::map(contestant, cells),
        "middle-axis" => middle_axis::map(contestant, cells),
        "thin-bodies" => thin::map(contestant, cells),
        "stiff-drag" => drag::map(contestant, cells),
        "bounce" => bounce::map(contestant, cells),
        _ => None,
    }?;
    Some(Map {
        name: name.to_owned(),
        scheme: contestant.card.name.to_owned(),
        seconds: before.elapsed().as_secs_f64(),
        ..drawn
    })
}

/// Growth of a small displacement of the spring-held body over step and damping, measured; `None` where the scheme cannot take it.
pub fn growth(contestant: &Contestant, cells: usize) -> Option<Map> {
    let map = spring::measured_damping(contestant, cells)?;
    Some(Map { name: "spring-damping".to_owned(), scheme: contestant.card.name.to_owned(), ..map })
}

/// A linear axis.
fn linear(name: &str, unit: &str, low: f64, high: f64) -> MapAxis {
    MapAxis { name: name.to_owned(), unit: unit.to_owned(), logarithmic: false, low, high }
}

/// A logarithmic axis.
fn logarithmic(name: &str, unit: &str, low: f64, high: f64) -> MapAxis {
    MapAxis { logarithmic: true, ..linear(name, unit, low, high) }
}
