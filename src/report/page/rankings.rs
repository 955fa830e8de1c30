//! The tables that rank schemes by their error for equal work.

use serde::Serialize;

use crate::record::Records;
use crate::report::{number, ranking, survey};

/// The ranking of a scene.
#[derive(Serialize)]
pub(super) struct Ranking {
    quantity: String,
    yardstick: String,
    step: String,
    evaluations: String,
    nanoseconds: Option<String>,
    rows: Vec<Row>,
}

/// A place in it.
#[derive(Serialize)]
struct Row {
    place: String,
    scheme: String,
    family: String,
    error: String,
    ratio: String,
    error_at_time: String,
    ratio_at_time: String,
}

impl Ranking {
    /// `None` where fewer than two schemes have errors.
    pub(super) fn new(records: &Records, scene: &str) -> Option<Ranking> {
        let ranking = ranking::rank(records, scene).filter(|ranking| ranking.places.len() > 1)?;
        let unit = if ranking::quantity(records, scene) == "orientation-end" { "rad" } else { "m" };
        let error = |error: Option<f64>| number::quantity(error, None, unit);
        let ratio = |error: Option<f64>| {
            error.map_or(number::NONE.into(), |error| number::significant(error / ranking.error, 3))
        };
        let row = |(index, place): (usize, &ranking::Place)| Row {
            place: place.error.map_or(String::new(), |_| (index + 1).to_string()),
            scheme: place.scheme.into(),
            family: place.family.into(),
            error: error(place.error),
            ratio: ratio(place.error),
            error_at_time: error(place.error_at_time),
            ratio_at_time: ratio(place.error_at_time),
        };
        Some(Ranking {
            quantity: survey::quantity_words(ranking::quantity(records, scene)),
            yardstick: ranking.yardstick.into(),
            step: format!("{} s", number::setting(ranking.step)),
            evaluations: number::significant(ranking.evaluations * ranking.step, 3),
            nanoseconds: ranking.nanoseconds.map(|cost| number::significant(cost * ranking.step, 3)),
            rows: ranking.places.iter().enumerate().map(row).collect(),
        })
    }
}

/// A scheme over the scenes that all ranked ones share.
#[derive(Serialize)]
pub(super) struct Overall {
    place: usize,
    kind: &'static str,
    yardstick: String,
    scheme: String,
    family: String,
    scenes: usize,
    mean: String,
    best: String,
    worst: String,
}

/// The rankings without torque and with it, one after the other.
pub(super) fn overall(records: &Records) -> Vec<Overall> {
    let words = |(ratio, scene): (f64, &str)| format!("{} ({scene})", number::significant(ratio, 2));
    let rows = |group: ranking::Overall| {
        let row = |(index, place): (usize, &ranking::OverallPlace)| Overall {
            place: index + 1,
            kind: if group.torque_free { "torque-free" } else { "under a torque" },
            yardstick: group.yardstick.into(),
            scheme: place.scheme.into(),
            family: place.family.into(),
            scenes: group.scenes.len(),
            mean: number::significant(place.mean, 3),
            best: words(place.best),
            worst: words(place.worst),
        };
        group.places.iter().enumerate().map(row).collect::<Vec<_>>()
    };
    ranking::overall(records).into_iter().flat_map(rows).collect()
}
