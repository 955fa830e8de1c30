//! The tables that rank schemes by their error for equal work.

use std::collections::BTreeMap;

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

/// A scheme over all scenes that it was ranked on.
#[derive(Serialize)]
pub(super) struct Overall {
    place: usize,
    yardstick: String,
    scheme: String,
    family: String,
    scenes: usize,
    mean: String,
    best: String,
    worst: String,
}

/// The family of a scheme, and the ratio of its error to the yardstick's in each scene.
type Scored<'a> = (&'a str, Vec<(f64, &'a str)>);

/// Schemes by the geometric mean of the ratios of their errors to the yardstick's, over the scenes that carry an order. Empty
/// where there are fewer than two.
pub(super) fn overall(records: &Records) -> Vec<Overall> {
    let mut ratios: BTreeMap<&str, Scored> = BTreeMap::new();
    let mut yardstick = "";
    for scene in survey::scenes(records) {
        let Some(ranking) = ranking::rank(records, scene) else { continue };
        if survey::scene(records, scene).is_some_and(|row| row.not_for_order.is_some()) {
            continue;
        }
        yardstick = ranking.yardstick;
        for place in &ranking.places {
            if let Some(error) = place.error {
                let entry = ratios.entry(place.scheme).or_insert((place.family, Vec::new()));
                entry.1.push((error / ranking.error, scene));
            }
        }
    }
    let mean = |ratios: &[(f64, &str)]| {
        (ratios.iter().map(|(ratio, _)| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp()
    };
    let mut all: Vec<_> = ratios.into_iter().collect();
    all.sort_by(|a, b| mean(&a.1.1).total_cmp(&mean(&b.1.1)));
    if all.len() < 2 {
        return Vec::new();
    }
    let words = |extreme: Option<&(f64, &str)>| {
        extreme
            .map_or(String::new(), |(ratio, scene)| format!("{} ({scene})", number::significant(*ratio, 2)))
    };
    all.iter()
        .enumerate()
        .map(|(index, (scheme, (family, ratios)))| Overall {
            place: index + 1,
            yardstick: yardstick.into(),
            scheme: (*scheme).into(),
            family: (*family).into(),
            scenes: ratios.len(),
            mean: number::significant(mean(ratios), 3),
            best: words(ratios.iter().min_by(|a, b| a.0.total_cmp(&b.0))),
            worst: words(ratios.iter().max_by(|a, b| a.0.total_cmp(&b.0))),
        })
        .collect()
}
