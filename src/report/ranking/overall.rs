//! Schemes over several scenes: the geometric mean of the ratios of their errors to the yardstick's, and its range.

use super::{Ranking, rank};
use crate::record::{Records, SceneRow};
use crate::report::survey;

/// Schemes ranked over the scenes that all of them were ranked on.
pub(in crate::report) struct Overall<'a> {
    /// Whether the scenes are without torque.
    pub torque_free: bool,
    /// The scheme that the ratios are of.
    pub yardstick: &'a str,
    /// The scenes, two at least.
    pub scenes: Vec<&'a str>,
    /// The schemes, the smallest mean first.
    pub places: Vec<OverallPlace<'a>>,
    /// Schemes that were run on too few of these scenes.
    pub left_out: Vec<&'a str>,
}

/// A scheme in it.
pub(in crate::report) struct OverallPlace<'a> {
    /// Name.
    pub scheme: &'a str,
    /// Family.
    pub family: &'a str,
    /// Geometric mean of the ratios of its error to the yardstick's.
    pub mean: f64,
    /// The smallest ratio and its scene.
    pub best: (f64, &'a str),
    /// The largest ratio and its scene.
    pub worst: (f64, &'a str),
}

/// The rankings without torque and with it, over common scenes that carry an order; none from fewer than two scenes or schemes.
pub(in crate::report) fn overall(records: &Records) -> Vec<Overall<'_>> {
    let ranked: Vec<(&str, Ranking)> = survey::scenes(records)
        .into_iter()
        .filter_map(|scene| Some((scene, rank(records, scene)?)))
        .collect();
    let yardstick = ranked.first().map_or("", |(_, ranking)| ranking.yardstick);
    let of_kind = |torque_free: bool| {
        let here = |(scene, ranking): &&(&str, Ranking)| {
            let row = survey::scene(records, scene);
            let kind =
                row.is_some_and(|row| row.not_for_order.is_none() && is_torque_free(row) == torque_free);
            kind && ranking.yardstick == yardstick
        };
        common(ranked.iter().filter(here).collect(), torque_free)
    };
    [true, false].into_iter().filter_map(of_kind).collect()
}

/// Whether no torque acts in a scene, by the least model that gives its motion.
fn is_torque_free(row: &SceneRow) -> bool {
    matches!(row.model.as_str(), "free" | "falling")
}

/// Ranks on the scenes that all schemes share. While these are fewer than half of the scenes, the scheme that was run on the fewest is left out.
fn common<'a>(ranked: Vec<&(&'a str, Ranking<'a>)>, torque_free: bool) -> Option<Overall<'a>> {
    let ratio = |(_, ranking): &(&str, Ranking), scheme: &str| {
        let place = ranking.places.iter().find(|place| place.scheme == scheme)?;
        Some(place.error? / ranking.error)
    };
    let mut schemes = survey::distinct(ranked.iter().flat_map(|(_, r)| r.places.iter().map(|p| p.scheme)));
    let count = |scheme: &str| ranked.iter().filter(|one| ratio(one, scheme).is_some()).count();
    let mut left_out = Vec::new();
    let shared = loop {
        let all = |one: &&&(&'a str, Ranking<'a>)| schemes.iter().all(|scheme| ratio(one, scheme).is_some());
        let shared: Vec<&(&'a str, Ranking<'a>)> = ranked.iter().filter(all).copied().collect();
        if schemes.len() < 2 || (shared.len() >= 2 && 2 * shared.len() >= ranked.len()) {
            break shared;
        }
        // Of those on equally few scenes the last of the list goes: the yardstick is the first.
        let fewest = (0..schemes.len()).rev().min_by_key(|index| count(schemes[*index]))?;
        left_out.push(schemes.remove(fewest));
    };
    if shared.len() < 2 || schemes.len() < 2 {
        return None;
    }
    let place = |scheme: &&'a str| {
        let ratios: Vec<(f64, &'a str)> =
            shared.iter().filter_map(|one| Some((ratio(one, scheme)?, one.0))).collect();
        let mean = ratios.iter().map(|(ratio, _)| ratio.ln()).sum::<f64>() / ratios.len() as f64;
        let of =
            |ranking: &Ranking<'a>| ranking.places.iter().find(|p| p.scheme == *scheme).map(|p| p.family);
        Some(OverallPlace {
            scheme,
            family: of(&shared[0].1)?,
            mean: mean.exp(),
            best: ratios.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0))?,
            worst: ratios.iter().copied().max_by(|a, b| a.0.total_cmp(&b.0))?,
        })
    };
    let mut places: Vec<OverallPlace> = schemes.iter().filter_map(place).collect();
    places.sort_by(|a, b| a.mean.total_cmp(&b.mean));
    let scenes = shared.iter().map(|one| one.0).collect();
    Some(Overall { torque_free, yardstick: shared[0].1.yardstick, scenes, places, left_out })
}

#[cfg(test)]
mod tests {
    use super::super::Place;
    use super::*;

    #[test]
    fn schemes_are_ranked_on_the_scenes_that_all_of_them_share_and_never_on_one() {
        let place = |scheme, error| Place { scheme, family: "f", error, error_at_time: None };
        let ranking = |places| Ranking {
            yardstick: "a",
            step: 0.1,
            evaluations: 1.0,
            nanoseconds: None,
            error: 1.0,
            places,
        };
        let whole = |b: f64| vec![place("a", Some(1.0)), place("b", Some(b))];
        let with_c = [whole(0.25), vec![place("c", Some(1e-9))]].concat();
        let ranked = [("one", ranking(whole(4.0))), ("two", ranking(with_c)), ("three", ranking(whole(1.0)))];
        let found = common(ranked.iter().collect(), true).expect("three scenes");
        assert_eq!(found.scenes, ["one", "two", "three"]);
        assert_eq!(found.left_out, ["c"]);
        let b = found.places.iter().find(|place| place.scheme == "b").expect("ranked");
        assert_eq!((b.mean, b.best, b.worst), (1.0, (0.25, "two"), (4.0, "one")));
        assert!(common(ranked[..1].iter().collect(), true).is_none());
    }
}
