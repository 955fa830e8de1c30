//! The curves of a convergence picture, gathered from the records.

use std::sync::Arc;

use crate::record::{Measurement, Order, OrderStatus, Records, RunStatus};
use crate::report::survey;

/// Quantities in the order that pictures show them in; others follow.
const USUAL: [&str; 6] =
    ["position", "velocity", "orientation", "angular-velocity", "angular-momentum", "body-point"];

/// One run of a ladder.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rung {
    /// log₁₀ of the step.
    pub step: f64,
    /// log₁₀ of the error; minus infinity where the error is zero.
    pub error: f64,
    /// True where the run belongs to the fit.
    pub used: bool,
    /// True where the error is no larger than its own uncertainty.
    pub lost: bool,
}

/// The ladder of one scheme.
pub(super) struct Curve<'a> {
    /// The scheme.
    pub scheme: &'a str,
    /// The runs that have an error, the finest step first.
    pub rungs: Vec<Rung>,
    /// log₁₀ of the steps at which runs broke.
    pub broken: Vec<f64>,
    /// The fit, if there is one.
    pub order: Option<&'a Order>,
}

impl Curve<'_> {
    /// True where the gate found the error to be rounding at every step; where the gate did not look, where no
    /// error is larger than its uncertainty.
    pub(super) fn is_exact(&self) -> bool {
        match self.order {
            Some(order) => order.status == OrderStatus::Exact,
            None => !self.rungs.is_empty() && self.rungs.iter().all(|rung| rung.lost),
        }
    }

    /// The largest error, log₁₀.
    pub(super) fn largest(&self) -> f64 {
        self.rungs.iter().map(|rung| rung.error).fold(f64::NEG_INFINITY, f64::max)
    }

    fn is_empty(&self) -> bool {
        self.rungs.is_empty() && self.broken.is_empty()
    }
}

/// The ladders of every scheme for one quantity.
pub(super) struct Quantity<'a> {
    /// Name without the place that it is taken at.
    pub name: &'a str,
    /// Unit of its error.
    pub unit: &'a str,
    /// One curve a scheme.
    pub curves: Vec<Curve<'a>>,
}

impl Quantity<'_> {
    /// True where every scheme is exact.
    pub(super) fn is_exact(&self) -> bool {
        self.curves.iter().all(|curve| curve.is_exact() || curve.rungs.is_empty())
    }

    /// True where a curve has two points: a dot says nothing about an order.
    pub(super) fn has_a_line(&self) -> bool {
        self.curves.iter().any(|curve| curve.rungs.len() > 1)
    }

    /// The largest floor of any scheme, log₁₀.
    pub(super) fn floor(&self) -> Option<f64> {
        let floors = self.curves.iter().filter_map(|curve| curve.order?.floor);
        floors.filter(|floor| *floor > 0.0 && floor.is_finite()).map(f64::log10).reduce(f64::max)
    }

    /// The orders that guide lines are drawn for: those measured, as whole numbers.
    pub(super) fn guide_orders(&self) -> Vec<u32> {
        let fitted = self.curves.iter().filter_map(|curve| curve.order?.order);
        let mut orders: Vec<u32> =
            fitted.map(|order| order.round() as u32).filter(|order| *order > 0).collect();
        orders.sort_unstable();
        orders.dedup();
        orders
    }
}

/// The quantities of a scene at the end of the run.
pub(super) fn at_the_end<'a>(records: &'a Records, scene: &str) -> Vec<Quantity<'a>> {
    let here: Vec<&Measurement> =
        records.measurements.iter().map(Arc::as_ref).filter(|row| row.scene == scene).collect();
    let measured = here.iter().map(|row| row.metric.as_str());
    let usual = |name: &&str| USUAL.contains(name);
    let names = measured.filter_map(base).filter(usual);
    let mut names = survey::distinct(names);
    names.sort_by_key(|name| USUAL.iter().position(|usual| usual == name).unwrap_or(USUAL.len()));
    names.into_iter().filter_map(|name| quantity(records, scene, name, &here)).collect()
}

fn base(metric: &str) -> Option<&str> {
    metric.strip_suffix("-end")
}

fn quantity<'a>(
    records: &'a Records,
    scene: &str,
    name: &'a str,
    here: &[&'a Measurement],
) -> Option<Quantity<'a>> {
    let metric = format!("{name}-end");
    let rows: Vec<&Measurement> = here.iter().filter(|row| row.metric == metric).copied().collect();
    let schemes = survey::schemes(records).into_iter();
    let curves: Vec<Curve> = schemes
        .map(|scheme| curve(scheme, &rows, survey::order(records, scene, scheme, &metric)))
        .filter(|curve| !curve.is_empty())
        .collect();
    let unit = rows.first().map_or("", |row| row.unit.as_str());
    (!curves.is_empty()).then_some(Quantity { name, unit, curves })
}

/// The ladder of a scheme from the rows of one scene and metric.
pub(super) fn curve<'a>(scheme: &'a str, rows: &[&Measurement], order: Option<&'a Order>) -> Curve<'a> {
    let mine = || rows.iter().filter(|row| row.scheme == scheme && row.step_s > 0.0);
    let mut rungs: Vec<Rung> = mine()
        .filter_map(|row| {
            let error = row.value.filter(|value| value.is_finite())?.abs().log10();
            let used = order.is_some_and(|order| survey::in_window(order, row.step_s));
            let lost = row.value.map(f64::abs) <= Some(row.uncertainty.unwrap_or(0.0));
            Some(Rung { step: row.step_s.log10(), error, used, lost })
        })
        .collect();
    rungs.sort_by(|a, b| a.step.total_cmp(&b.step));
    let broken = mine().filter(|row| row.status == RunStatus::Broken).map(|row| row.step_s.log10()).collect();
    Curve { scheme, rungs, broken, order }
}
