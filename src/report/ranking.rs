//! All schemes of a scene side by side: the error that each makes for the same work.
//!
//! Equal steps compare nothing: a scheme of four evaluations a step gets four times the work. The work here is a second
//! of simulated time, counted in force evaluations, or timed in nanoseconds. Errors between two rungs are read off the straight
//! line through them on logarithmic axes; outside the ladder there is none.

mod overall;

use std::sync::Arc;

use crate::record::{Measurement, Records, RunStatus};
use crate::report::survey;

pub(super) use overall::{Overall, OverallPlace, overall};

/// What errors are held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Work {
    /// Force evaluations a second of simulated time.
    Evaluations,
    /// Nanoseconds a second of simulated time.
    Nanoseconds,
}

impl Work {
    fn of(self, row: &Measurement) -> Option<f64> {
        self.at(row, row)
    }

    /// The work of a run at the step of `row` if a step costs what one of `like` does.
    fn at(self, row: &Measurement, like: &Measurement) -> Option<f64> {
        let per_step = match self {
            Work::Evaluations => like.force_evaluations as f64 / like.steps.max(1) as f64,
            Work::Nanoseconds => like.nanoseconds_per_step?,
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
    /// log₁₀ of the work of the rungs that broke, had they been whole.
    pub broken: Vec<f64>,
}

impl Ladder<'_> {
    /// log₁₀ of the work from which on the error stays below a bound, log₁₀, and whether less may do as well: where all rungs
    /// are below it is that of the first. `None` where the last rung is not below.
    pub(super) fn work_for(&self, error: f64) -> Option<(f64, bool)> {
        let Some(above) = self.points.iter().rposition(|point| point.error > error) else {
            return self.points.first().map(|point| (point.work, true));
        };
        let (before, after) = (self.points.get(above)?, self.points.get(above + 1)?);
        let part = (before.error - error) / (before.error - after.error);
        Some((before.work + part * (after.work - before.work), false))
    }

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
    if records.measurements.iter().map(Arc::as_ref).any(turns) { "orientation-end" } else { "body-point-end" }
}

/// The ladders of every scheme that was run on a scene, for an error; those without any are left out.
pub(super) fn ladders<'a>(records: &'a Records, scene: &str, metric: &str, work: Work) -> Vec<Ladder<'a>> {
    let rows: Vec<&Measurement> = records
        .measurements
        .iter()
        .map(Arc::as_ref)
        .filter(|row| row.scene == scene && row.metric == metric)
        .collect();
    let family = |name: &str| {
        records.schemes.iter().find(|row| row.name == name).map_or("", |row| row.family.as_str())
    };
    let one = |scheme: &'a str| {
        let own: Vec<&Measurement> = rows.iter().filter(|row| row.scheme == scheme).copied().collect();
        let (points, broken) = rungs(&own, work);
        Ladder { scheme, family: family(scheme), points, broken }
    };
    survey::schemes(records)
        .into_iter()
        .map(one)
        .filter(|ladder: &Ladder| !ladder.points.is_empty())
        .collect()
}

/// The rungs of one scheme, work rising, and the work of those that broke.
fn rungs(own: &[&Measurement], work: Work) -> (Vec<Point>, Vec<f64>) {
    let whole = || own.iter().filter(|row| row.status == RunStatus::Ok);
    let mut points: Vec<Point> = whole()
        .filter_map(|row| {
            // No error at all is one below what the reference decides.
            let floor = row.uncertainty.unwrap_or(0.0);
            let error = row.value.map(|value| if value == 0.0 { floor } else { value });
            let error = error.filter(|value| *value > 0.0 && value.is_finite())?;
            let lost = error <= 10.0 * floor;
            Some(Point { work: work.of(row)?.log10(), error: error.log10(), lost })
        })
        .collect();
    points.sort_by(|a, b| a.work.total_cmp(&b.work));
    // A run that broke has counted a part of its work only.
    let like = whole().next();
    let broken = own.iter().filter(|row| row.status == RunStatus::Broken);
    let broken = broken.filter_map(|row| work.at(row, like?)).map(f64::log10).collect();
    (points, broken)
}

/// What the reference leaves undecided in an error, log₁₀: no run is held against anything better.
pub(super) fn floor(records: &Records, scene: &str, metric: &str) -> Option<f64> {
    let rows = records.measurements.iter().filter(|row| row.scene == scene && row.metric == metric);
    let known = rows.filter_map(|row| row.uncertainty).filter(|floor| *floor > 0.0 && floor.is_finite());
    known.reduce(f64::min).map(f64::log10)
}

/// The points that no other beats in work and error both, work rising: scheme, log₁₀ work, log₁₀ error. The front stops at the first point
/// whose error is that of rounding or of the reference: no other can be distinguished from it.
pub(super) fn front<'a>(ladders: &[Ladder<'a>]) -> Vec<(&'a str, f64, f64)> {
    let of_ladder = |ladder: &Ladder<'a>| {
        let scheme = ladder.scheme;
        ladder.points.iter().map(move |point| (scheme, *point)).collect::<Vec<_>>()
    };
    let mut points: Vec<(&str, Point)> = ladders.iter().flat_map(of_ladder).collect();
    points.sort_by(|(_, a), (_, b)| a.work.total_cmp(&b.work).then(a.error.total_cmp(&b.error)));
    let (mut least, mut ended) = (f64::INFINITY, false);
    points.retain(|(_, point)| {
        let better = point.error < least && !ended;
        least = least.min(point.error);
        ended |= better && point.lost;
        better
    });
    points.into_iter().map(|(scheme, point)| (scheme, point.work, point.error)).collect()
}

/// A scheme in the ranking of a scene.
#[derive(Clone)]
pub(super) struct Place<'a> {
    /// Name.
    pub scheme: &'a str,
    /// Family.
    pub family: &'a str,
    /// Error for the evaluations of the yardstick; `None` where its ladder has no such work.
    pub error: Option<f64>,
    /// Error for the time of the yardstick.
    pub error_at_time: Option<f64>,
}

/// Schemes by their error for equal work, the best first; those whose ladder has no such work at the end.
pub(super) struct Ranking<'a> {
    /// The scheme whose step is the unit of work.
    pub yardstick: &'a str,
    /// Its step [s].
    pub step: f64,
    /// Its evaluations a simulated second.
    pub evaluations: f64,
    /// Its nanoseconds a simulated second, where it was timed.
    pub nanoseconds: Option<f64>,
    /// Its error.
    pub error: f64,
    /// The places.
    pub places: Vec<Place<'a>>,
}

/// Rung of the yardstick's ladder whose work is compared, from the coarsest.
const RUNG: usize = 2;

/// Ranks the schemes of a scene; `None` where no scheme has errors. The yardstick is the first scheme of the records.
pub(super) fn rank<'a>(records: &'a Records, scene: &str) -> Option<Ranking<'a>> {
    let metric = quantity(records, scene);
    let [counted, timed] =
        [Work::Evaluations, Work::Nanoseconds].map(|work| ladders(records, scene, metric, work));
    let yardstick = counted.first()?;
    let at = yardstick.points.get(RUNG).or(yardstick.points.last())?;
    let its = |ladder: &&Ladder| ladder.scheme == yardstick.scheme;
    let time = timed
        .iter()
        .find(its)
        .and_then(|ladder| ladder.points.get(RUNG).or(ladder.points.last()))
        .map(|point| point.work);
    let of_time = |scheme: &str| {
        let ladder = timed.iter().find(|ladder| ladder.scheme == scheme)?;
        ladder.error_at(time?)
    };
    let row = records.measurements.iter().find(|row| {
        let same = row.scene == scene && row.scheme == yardstick.scheme && row.metric == metric;
        same && row.value.is_some_and(|value| value.log10() == at.error)
    });
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
        step: row.map_or(0.0, |row| row.step_s),
        evaluations: 10f64.powf(at.work),
        nanoseconds: time.map(|time| 10f64.powf(time)),
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
        let ladder = Ladder { scheme: "a", family: "b", points, broken: Vec::new() };
        assert_eq!(ladder.error_at(1.5), Some(-3.0));
        assert_eq!(ladder.error_at(2.75), Some(-7.0));
        assert_eq!(ladder.error_at(0.9), None);
        assert_eq!(ladder.error_at(3.1), None);
    }

    #[test]
    fn the_work_for_an_error_is_that_from_which_on_it_stays_below() {
        let point = |work, error| Point { work, error, lost: false };
        // The second rung is lucky.
        let points = vec![point(1.0, -2.0), point(2.0, -6.0), point(3.0, -4.0), point(4.0, -8.0)];
        let ladder = Ladder { scheme: "a", family: "b", points, broken: Vec::new() };
        assert_eq!(ladder.work_for(-5.0), Some((3.25, false)));
        assert_eq!(ladder.work_for(-1.0), Some((1.0, true)));
        assert_eq!(ladder.work_for(-9.0), None);
    }

    #[test]
    fn a_run_that_broke_stands_at_the_work_that_it_would_have_cost() {
        let row = |steps, value, status| Measurement {
            step_s: 1.0 / steps as f64,
            steps,
            value,
            status,
            force_evaluations: if value.is_some() { 2 * steps } else { 1 },
            ..Measurement::default()
        };
        let rows = [
            row(1, None, RunStatus::Broken),
            row(10, Some(1e-3), RunStatus::Ok),
            row(100, Some(1e-5), RunStatus::Ok),
        ];
        let (points, broken) = rungs(&rows.iter().collect::<Vec<_>>(), Work::Evaluations);
        assert_eq!(points.len(), 2);
        assert!((broken[0] - 2f64.log10()).abs() < 1e-12, "{broken:?}");
        assert_eq!(rungs(&rows.iter().collect::<Vec<_>>(), Work::Nanoseconds), (vec![], vec![]));
    }

    #[test]
    fn the_front_holds_what_nothing_beats() {
        let point = |work, error, lost| Point { work, error, lost };
        let ladder = |scheme, points| Ladder { scheme, family: "", points, broken: Vec::new() };
        let a = ladder("a", vec![point(1.0, -1.0, false), point(3.0, -3.0, false)]);
        let b = ladder("b", vec![point(2.0, -2.0, false), point(4.0, -2.5, false), point(5.0, -9.0, true)]);
        assert_eq!(front(&[a, b]), [("a", 1.0, -1.0), ("b", 2.0, -2.0), ("a", 3.0, -3.0), ("b", 5.0, -9.0)]);
    }

    #[test]
    fn the_front_stops_at_the_floor_and_keeps_what_is_exact_there() {
        let point = |work, error, lost| Point { work, error, lost };
        let ladder = |scheme, points| Ladder { scheme, family: "", points, broken: Vec::new() };
        let exact = ladder("exact", vec![point(2.0, -14.0, true), point(4.0, -15.0, true)]);
        let other = ladder("other", vec![point(1.0, -2.0, false), point(3.0, -14.5, true)]);
        assert_eq!(front(&[exact, other]), [("other", 1.0, -2.0), ("exact", 2.0, -14.0)]);
    }
}
