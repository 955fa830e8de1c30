//! All schemes of a scene side by side: the error that each makes for the same work.
//!
//! Equal steps compare nothing: a scheme of four evaluations a step gets four times the work. The work here is a second
//! of simulated time, counted in force evaluations, or timed in nanoseconds. Errors between two rungs are read off the straight
//! line through them on logarithmic axes; outside the ladder there is none.

use crate::record::{Measurement, Records};
use crate::report::survey;

/// Which work is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Work {
    /// Force evaluations a second of simulated time.
    Evaluations,
    /// Nanoseconds a second of simulated time.
    Nanoseconds,
}

impl Work {
    /// Both.
    pub(super) const ALL: [Work; 2] = [Work::Evaluations, Work::Nanoseconds];

    fn of(self, row: &Measurement) -> Option<f64> {
        let per_step = match self {
            Work::Evaluations => row.force_evaluations as f64 / row.steps.max(1) as f64,
            Work::Nanoseconds => row.nanoseconds_per_step?,
        };
        (per_step > 0.0 && row.step_s > 0.0).then(|| per_step / row.step_s)
    }
}

/// A rung: the logarithms, to base 10, of work and error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    /// log₁₀ of the work.
    pub work: f64,
    /// log₁₀ of the error.
    pub error: f64,
    /// Whether the error is that of rounding or of the reference.
    pub lost: bool,
}

/// A scheme's rungs in a scene, work rising.
pub(super) struct Ladder<'a> {
    /// Name.
    pub scheme: &'a str,
    /// Family, or nothing where the records hold no card.
    pub family: &'a str,
    /// The rungs.
    pub points: Vec<Point>,
}

impl Ladder<'_> {
    /// log₁₀ of the error for so much work, log₁₀; `None` outside the ladder.
    pub(super) fn error_at(&self, work: f64) -> Option<f64> {
        let pair = self.points.windows(2).find(|pair| pair[0].work <= work && work <= pair[1].work)?;
        let part = (work - pair[0].work) / (pair[1].work - pair[0].work);
        Some(pair[0].error + part * (pair[1].error - pair[0].error))
    }
}

/// The quantity that a scene is ranked by: the orientation where a body turns, or else a body point.
pub(super) fn quantity(records: &Records, scene: &str) -> &'static str {
    let turns = |row: &Measurement| {
        row.scene == scene && row.metric == "orientation-end" && row.value.is_some_and(|value| value > 0.0)
    };
    if records.measurements.iter().any(turns) { "orientation-end" } else { "body-point-end" }
}

/// The ladders of every scheme that was run on a scene; those without an error are left out.
pub(super) fn ladders<'a>(records: &'a Records, scene: &str, work: Work) -> Vec<Ladder<'a>> {
    let metric = quantity(records, scene);
    let rows: Vec<&Measurement> = records
        .measurements
        .iter()
        .filter(|row| row.scene == scene && row.metric == metric && row.status == "ok")
        .collect();
    let family = |name: &str| {
        records.schemes.iter().find(|row| row.name == name).map_or("", |row| row.family.as_str())
    };
    let one = |scheme: &'a str| {
        let mut points: Vec<Point> = rows
            .iter()
            .filter(|row| row.scheme == scheme)
            .filter_map(|row| {
                let error = row.value.filter(|value| *value > 0.0 && value.is_finite())?;
                let lost = error <= 10.0 * row.uncertainty.unwrap_or(0.0);
                Some(Point { work: work.of(row)?.log10(), error: error.log10(), lost })
            })
            .collect();
        points.sort_by(|a, b| a.work.total_cmp(&b.work));
        Ladder { scheme, family: family(scheme), points }
    };
    survey::schemes(records)
        .into_iter()
        .map(one)
        .filter(|ladder: &Ladder| !ladder.points.is_empty())
        .collect()
}

/// A scheme in the ranking of a scene.
pub(super) struct Place<'a> {
    /// Name.
    pub scheme: &'a str,
    /// Family.
    pub family: &'a str,
    /// Error for the work of the yardstick; `None` where its ladder has no such work.
    pub error: Option<f64>,
    /// Error for the time of the yardstick.
    pub error_at_time: Option<f64>,
}

/// Schemes by their error for equal work, the best first; those whose ladder has no such work at the end.
pub(super) struct Ranking<'a> {
    /// The scheme whose step is the unit of work.
    pub yardstick: &'a str,
    /// Its evaluations a simulated second.
    pub evaluations: f64,
    /// Its error.
    pub error: f64,
    /// The places.
    pub places: Vec<Place<'a>>,
}

/// Rung of the yardstick's ladder whose work is compared, from the coarsest.
const RUNG: usize = 2;

/// Ranks the schemes of a scene; `None` where no scheme has errors. The yardstick is the first scheme of the records.
pub(super) fn rank<'a>(records: &'a Records, scene: &str) -> Option<Ranking<'a>> {
    let [counted, timed] = Work::ALL.map(|work| ladders(records, scene, work));
    let yardstick = counted.first()?;
    let at = yardstick.points.get(RUNG).or(yardstick.points.last())?;
    let time = timed
        .iter()
        .find(|ladder| ladder.scheme == yardstick.scheme)
        .and_then(|ladder| ladder.points.get(RUNG).or(ladder.points.last()))
        .map(|point| point.work);
    let of_time = |scheme: &str| {
        let ladder = timed.iter().find(|ladder| ladder.scheme == scheme)?;
        ladder.error_at(time?)
    };
    let mut places: Vec<Place> = counted
        .iter()
        .map(|ladder| Place {
            scheme: ladder.scheme,
            family: ladder.family,
            error: ladder.error_at(at.work).map(|error| 10f64.powf(error)),
            error_at_time: of_time(ladder.scheme).map(|error| 10f64.powf(error)),
        })
        .collect();
    let key = |place: &Place| place.error.unwrap_or(f64::INFINITY);
    places.sort_by(|a, b| key(a).total_cmp(&key(b)));
    Some(Ranking {
        yardstick: yardstick.scheme,
        evaluations: 10f64.powf(at.work),
        error: 10f64.powf(at.error),
        places,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_between_rungs_lie_on_a_straight_line_and_outside_there_is_none() {
        let point = |work, error| Point { work, error, lost: false };
        let points = vec![point(1.0, -2.0), point(2.0, -4.0), point(3.0, -8.0)];
        let ladder = Ladder { scheme: "a", family: "b", points };
        assert_eq!(ladder.error_at(1.5), Some(-3.0));
        assert_eq!(ladder.error_at(2.75), Some(-7.0));
        assert_eq!(ladder.error_at(0.9), None);
        assert_eq!(ladder.error_at(3.1), None);
    }
}
