//! The runs of one scheme in one scene, as error against work.

use crate::record::{Measurement, RunStatus};

/// An error this many times its floor is no rounding.
const CLEAR: f64 = 10.0;

/// A run: work, error and floor.
#[derive(Clone, Copy, Debug)]
struct Point {
    work: f64,
    error: f64,
    floor: f64,
}

/// Runs with work rising.
pub(super) struct Ladder {
    points: Vec<Point>,
}

impl Ladder {
    /// The whole runs of a metric.
    pub(super) fn of(runs: &[&Measurement], metric: &str) -> Ladder {
        let mut points: Vec<Point> = runs
            .iter()
            .filter(|run| run.metric == metric && run.status == RunStatus::Ok && run.force_evaluations > 0)
            .filter_map(|run| {
                let floor = run.uncertainty.unwrap_or(0.0);
                Some(Point { work: run.force_evaluations as f64, error: run.value?.abs(), floor })
            })
            .collect();
        points.sort_by(|a, b| a.work.total_cmp(&b.work));
        Ladder { points }
    }

    /// Error at some work, between the runs next to it on logarithmic scales, its floor at least, and whether it stands clear
    /// of that.
    fn at(&self, work: f64) -> Option<(f64, bool)> {
        let above = self.points.iter().position(|point| point.work >= work)?;
        let upper = self.points[above];
        let clear = |point: Point| point.error > CLEAR * point.floor;
        let size = |point: Point| point.error.max(point.floor).max(f64::MIN_POSITIVE);
        if upper.work == work {
            return Some((size(upper), clear(upper)));
        }
        let lower = self.points[above.checked_sub(1)?];
        let part = (work / lower.work).ln() / (upper.work / lower.work).ln();
        Some((size(lower).powf(1.0 - part) * size(upper).powf(part), clear(lower) && clear(upper)))
    }

    /// Error of `other` over that of this one at the largest common work at which one of them stands clear of rounding; 1 where
    /// none does, `None` where they have no work in common.
    pub(super) fn ratio(&self, other: &Ladder) -> Option<f64> {
        let mut works: Vec<f64> = self.points.iter().chain(&other.points).map(|point| point.work).collect();
        works.sort_by(|a, b| b.total_cmp(a));
        let pairs: Vec<_> =
            works.into_iter().filter_map(|work| Some((self.at(work)?, other.at(work)?))).collect();
        let clear = pairs.iter().find(|((_, one), (_, other))| *one || *other);
        match clear {
            Some(((own, _), (others, _))) => Some(others / own),
            None => (!pairs.is_empty()).then_some(1.0),
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.points.is_empty()
    }
}
