//! The pictures of a study: its maps as heat maps, and its curves.

use super::super::plot::heat_map::{Class, Curve, HeatMap, Hue, Map as Panel, Range, Scale};
use crate::record::stability::{Map, MapAxis};

/// A map as a picture.
pub(super) fn heat_map(map: &Map) -> HeatMap {
    let used = used_classes(map);
    HeatMap {
        title: map.title.clone(),
        subtitle: format!("{} · {}", map.scheme, map.what),
        description: format!("{} ({}): {}", map.title, map.scheme, map.what),
        scale: if map.classes.is_empty() { numbers(map) } else { classes(map, &used) },
        panels: vec![panel(map, &used)],
    }
}

/// Maps of one name as a picture with a panel a scheme, all under one scale; `None` where there is no map.
pub(in crate::report) fn side_by_side(maps: &[Map]) -> Option<HeatMap> {
    let first = maps.first()?;
    let one = |map: &Map| Panel { title: map.scheme.clone(), ..panel(map, &[]) };
    Some(HeatMap {
        title: first.title.clone(),
        subtitle: format!("{}; blue dies away, orange grows", first.what),
        description: format!("{}: {}", first.title, first.what),
        scale: numbers(first),
        panels: maps.iter().map(one).collect(),
    })
}

fn panel(map: &Map, used: &[usize]) -> Panel {
    let cell = |value: &Option<f64>| {
        let value = (*value)?;
        if map.classes.is_empty() {
            return Some(value);
        }
        used.iter().position(|class| *class == value as usize).map(|index| index as f64)
    };
    Panel {
        title: String::new(),
        across: range(&map.x),
        up: range(&map.y),
        columns: map.cells,
        cells: map.values.iter().flatten().map(cell).collect(),
        curves: map.curves.iter().map(curve).collect(),
    }
}

fn curve(curve: &crate::record::stability::MapCurve) -> Curve {
    Curve {
        words: if curve.name == MEASURED { "measured limit".to_owned() } else { curve.name.clone() },
        places: curve.x.iter().copied().zip(curve.y.iter().copied()).collect(),
        dashed: curve.name == MEASURED,
    }
}

/// The curve of a map that runs found; the others are theory.
const MEASURED: &str = "measured";

fn range(axis: &MapAxis) -> Range {
    let title = if axis.unit == "1" { axis.name.clone() } else { format!("{} [{}]", axis.name, axis.unit) };
    Range { title, low: axis.low, high: axis.high, logarithmic: axis.logarithmic }
}

/// What the numbers of a map are, and over which range they are told apart.
fn numbers(map: &Map) -> Scale {
    let (title, logarithmic, range) = match map.name.as_str() {
        "spring-stiffness" | "spring-damping" | "stiff-drag" => ("growth a step", false, Some((-0.25, 0.25))),
        "free-shapes" => ("largest |Ω|h [rad]", true, None),
        "sleeping-top" => ("log₁₀ of the growth of the tilt", false, Some((0.0, 3.0))),
        "middle-axis" => ("log₁₀ |rate/λ − 1|", false, Some((-5.0, 0.0))),
        "thin-bodies" => ("log₁₀ of the change of energy", false, Some((-8.0, 0.0))),
        "bounce" => ("order", false, Some((0.0, 4.0))),
        _ => ("value", false, None),
    };
    Scale::Numbers { title: title.to_owned(), logarithmic, range }
}

/// The classes that occur, the first of the list always.
fn used_classes(map: &Map) -> Vec<usize> {
    let mut used: Vec<usize> = map.values.iter().flatten().flatten().map(|value| *value as usize).collect();
    used.push(0);
    used.sort_unstable();
    used.dedup();
    used
}

fn classes(map: &Map, used: &[usize]) -> Scale {
    let one = |index: &usize| Class {
        words: match map.classes.get(*index).map(String::as_str) {
            Some("none") | None => "usable".to_owned(),
            Some(class) => class.to_owned(),
        },
        hue: HUES[*index % HUES.len()],
    };
    Scale::Classes(used.iter().map(one).collect())
}

/// A colour for each class of failure, in their order.
const HUES: [Hue; 12] = [
    Hue::White,
    Hue::Grey,
    Hue::Orange,
    Hue::Sky,
    Hue::Vermilion,
    Hue::Yellow,
    Hue::Blue,
    Hue::Purple,
    Hue::Green,
    Hue::Purple,
    Hue::Green,
    Hue::Black,
];
