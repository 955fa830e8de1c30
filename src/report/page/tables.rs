//! The tables of the report: schemes, orders, drifts.

use std::sync::Arc;

use serde::Serialize;

use crate::record::{Drift, Measurement, Order, OrderStatus, Records, RunStatus, SchemeRow};
use crate::report::{number, paper, survey};

use super::VerdictRow;

/// A scheme's card.
#[derive(Serialize)]
pub(super) struct Scheme {
    name: String,
    title: String,
    family: String,
    order: u32,
    evaluations: u32,
    claims: Vec<String>,
    source: String,
    cost: String,
    fails_where: String,
    apart: bool,
    anchor: String,
    tally: String,
    orders: Vec<OrderRow>,
    drifts: Vec<DriftRow>,
    attention: Vec<VerdictRow>,
}

impl Scheme {
    pub(super) fn new(records: &Records, row: &SchemeRow) -> Scheme {
        let verdicts = || records.verdicts.iter().filter(|verdict| verdict.scheme == row.name);
        Scheme {
            apart: row.apart,
            anchor: survey::file_stem(&row.name),
            tally: survey::tally_words(&survey::tally(verdicts().collect::<Vec<_>>().into_iter())),
            orders: records.orders.iter().filter(|one| one.scheme == row.name).map(OrderRow::new).collect(),
            drifts: records.drifts.iter().filter(|one| one.scheme == row.name).map(DriftRow::new).collect(),
            attention: super::attention(verdicts()),
            name: row.name.clone(),
            title: row.title.clone(),
            family: row.family.clone(),
            order: row.order,
            evaluations: row.evaluations,
            claims: row.claims.clone(),
            source: row.source.clone(),
            cost: cost(records, |measured| measured.scheme == row.name),
            fails_where: row.fails_where.clone().unwrap_or_else(|| number::NONE.into()),
        }
    }
}

/// The range of the cost of a step over the rows that are asked for.
pub(super) fn cost(records: &Records, wanted: impl Fn(&Measurement) -> bool) -> String {
    let costs =
        records.measurements.iter().filter(|row| wanted(row)).filter_map(|row| row.nanoseconds_per_step);
    let costs: Vec<f64> = costs.filter(|cost| cost.is_finite()).collect();
    let (Some(low), Some(high)) =
        (costs.iter().copied().reduce(f64::min), costs.iter().copied().reduce(f64::max))
    else {
        return number::NONE.into();
    };
    let [low, high] = [low, high].map(|cost| number::significant(cost, 3));
    if low == high { format!("{low} ns") } else { format!("{low} to {high} ns") }
}

/// A row of the table of orders: a scene, and a cell a scheme.
#[derive(Serialize)]
pub(super) struct SceneOrders {
    scene: String,
    anchor: String,
    cells: Vec<String>,
}

/// The schemes that head the columns, and the rows under them.
pub(super) fn scene_orders(records: &Records) -> (Vec<String>, Vec<SceneOrders>) {
    let words = |order: &Order| match order.status {
        OrderStatus::Decided => number::brief_order(order.order, order.low, order.high),
        status => status.word().replace('-', " "),
    };
    let (mut head, rows) = paper::order_grid(records, words);
    let row = |mut cells: Vec<String>| {
        let scene = cells.remove(0);
        SceneOrders { anchor: survey::file_stem(&scene), scene, cells }
    };
    (head.split_off(1), rows.into_iter().map(row).collect())
}

/// An order with its interval, or why there is none.
pub(super) fn order_words(order: &Order) -> String {
    match order.status {
        OrderStatus::Decided => number::order(order.order, order.low, order.high),
        status => status.word().replace('-', " "),
    }
}

/// One order with everything known about it.
#[derive(Serialize)]
pub(super) struct OrderRow {
    scene: String,
    anchor: String,
    quantity: String,
    scheme: String,
    order: String,
    constant: String,
    rungs: String,
    floor: String,
    why: String,
}

impl OrderRow {
    pub(super) fn new(order: &Order) -> OrderRow {
        OrderRow {
            scene: order.scene.clone(),
            anchor: survey::file_stem(&order.scene),
            quantity: survey::quantity_words(&order.quantity),
            scheme: order.scheme.clone(),
            order: order_words(order),
            constant: constant(order),
            rungs: format!("{} of {}", order.rungs_used, order.rungs_used + order.rungs_dropped),
            floor: number::joined(
                &order.floor.map_or(number::NONE.into(), |f| number::significant(f, 2)),
                &order.unit,
            ),
            why: order.why.clone().unwrap_or_default(),
        }
    }
}

/// C of C hᵖ with its uncertainty.
fn constant(order: &Order) -> String {
    let (Some(constant), Some(slope), Some(part)) =
        (order.constant, order.order, order.constant_uncertainty())
    else {
        return number::quantity(order.constant, None, &order.unit);
    };
    let power = slope.round() as u32;
    let unit = match order.unit.as_str() {
        "" => "1".to_string(),
        ratio if ratio.contains('/') => format!("({ratio})"),
        plain => plain.to_string(),
    };
    let per = if power == 1 { "/s".to_string() } else { format!("/s{}", number::superscript(power as i32)) };
    number::quantity(Some(constant), Some(constant * part), &format!("{unit}{per}"))
}

/// A conserved quantity's drift.
#[derive(Serialize)]
pub(super) struct DriftRow {
    pub(super) scene: String,
    anchor: String,
    scheme: String,
    quantity: String,
    class: &'static str,
    rate_order: String,
    rate: String,
    level: String,
    step: String,
}

impl DriftRow {
    pub(super) fn new(drift: &Drift) -> DriftRow {
        let rate_unit = format!("{}/s", if drift.unit.is_empty() { "1" } else { &drift.unit });
        DriftRow {
            scene: drift.scene.clone(),
            anchor: survey::file_stem(&drift.scene),
            scheme: drift.scheme.clone(),
            quantity: survey::quantity_words(&drift.quantity),
            class: drift.class.word(),
            rate_order: number::order(drift.rate_order, drift.low, drift.high),
            rate: number::quantity(drift.rate, None, &rate_unit),
            level: number::quantity(drift.level, None, &drift.unit),
            step: drift.step_s.map_or(number::NONE.into(), |step| format!("{} s", number::setting(step))),
        }
    }
}

/// A run that did not reach its end.
#[derive(Serialize)]
pub(super) struct BrokenRun {
    scene: String,
    anchor: String,
    scheme: String,
    step: String,
    why: String,
}

/// The runs that broke, each once however many metrics it left without a value.
pub(super) fn broken_runs(records: &Records) -> Vec<BrokenRun> {
    let broken = records.measurements.iter().filter(|row| row.status == RunStatus::Broken);
    let mut seen = std::collections::HashSet::new();
    let first = broken.filter(|row| seen.insert((&row.scene, &row.scheme, row.step_s.to_bits(), &row.why)));
    let run = |row: &Arc<Measurement>| BrokenRun {
        scene: row.scene.clone(),
        anchor: survey::file_stem(&row.scene),
        scheme: row.scheme.clone(),
        step: format!("{} s", number::setting(row.step_s)),
        why: row.why.clone().unwrap_or_else(|| "no reason recorded".into()),
    };
    first.map(run).collect()
}
