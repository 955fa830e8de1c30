//! One scene on either side: the rows of a comparison.

use super::ladder::Ladder;
use super::row::{Row, Standing};
use super::side::Side;
use crate::record::{Drift, DriftClass, Measurement, Order, OrderStatus, RunStatus};

/// A larger constant than this, relative, is worse.
const SAME_CONSTANT: f64 = 1.05;
/// A larger drift than this is worse: rates are steady to 4 % on either side. The same for errors between two runs.
const SAME_DRIFT: f64 = 1.1;

/// A scene with a scheme on either side.
pub(super) struct Cell<'a> {
    scene: &'a str,
    schemes: [&'a str; 2],
    sides: [&'a Side; 2],
    runs: [Vec<&'a Measurement>; 2],
    /// Both are the same scheme at different times, so that what is missing was lost.
    before_and_after: bool,
}

impl<'a> Cell<'a> {
    /// The scenes that both sides have, in the order of the first; of records files, those of `scenes` where any is named.
    pub(super) fn pairs(a: &'a Side, b: &'a Side, scenes: &[String]) -> Vec<Cell<'a>> {
        let files = a.scheme.is_none();
        let chosen = |scene: &str| !files || scenes.is_empty() || scenes.iter().any(|name| name == scene);
        let others = b.places();
        let mut cells = Vec::new();
        for (scene, scheme) in a.places() {
            let other = others.iter().find(|(own, name)| *own == scene && (!files || *name == scheme));
            if let Some((_, other)) = other.filter(|_| chosen(scene)) {
                let schemes = [scheme, *other];
                let runs = [a.runs(scene, scheme), b.runs(scene, other)];
                cells.push(Cell { scene, schemes, sides: [a, b], runs, before_and_after: files });
            }
        }
        cells
    }

    /// Orders and constants, drifts, cost; or why there are none.
    pub(super) fn rows(&self) -> Vec<Row> {
        if let Some(row) = self.refusal() {
            return vec![row];
        }
        let mut rows = self.orders();
        rows.extend(self.drifts());
        rows.extend(self.cost(&rows));
        rows
    }

    fn row(&self, quantity: &str, standing: Standing) -> Row {
        let dash = || ["–".to_owned(), "–".to_owned()];
        Row {
            scene: self.scene.to_owned(),
            scheme: self.schemes[0].to_owned(),
            quantity: quantity.to_owned(),
            kinds: dash(),
            sizes: dash(),
            ratio: None,
            at_equal_work: None,
            standing,
            why: None,
        }
    }

    /// The reason of a side that does not take the scene.
    fn refusal(&self) -> Option<Row> {
        let reason = |side: usize| {
            let refused = self.runs[side].iter().find(|run| run.status == RunStatus::NotApplicable)?;
            Some(refused.why.clone().unwrap_or_else(|| "not applicable".to_owned()))
        };
        let (first, second) = (reason(0), reason(1));
        let lost = self.before_and_after && first.is_none();
        if first.is_none() && second.is_none() {
            return None;
        }
        let said = |side: usize, reason: Option<String>| Some(format!("{}: {}", self.schemes[side], reason?));
        let reasons = [said(0, first), said(1, second)];
        let why = reasons.into_iter().flatten().collect::<Vec<_>>().join("; ");
        let standing = if lost { Standing::Worse } else { Standing::NotApplicable };
        Some(Row { why: Some(why), ..self.row("all", standing) })
    }

    fn orders(&self) -> Vec<Row> {
        let [a, b] = [0, 1].map(|side| self.sides[side].orders(self.scene, self.schemes[side]));
        let partner = |before: &Order| b.iter().find(|row| row.quantity == before.quantity).copied();
        let pair = |before: &&Order| match partner(before) {
            Some(after) => Some(self.order(before, after)),
            None if self.before_and_after => {
                let why = Some("not measured any more".to_owned());
                Some(Row { why, ..self.row(&before.quantity, Standing::Worse) })
            }
            None => None,
        };
        a.iter().filter_map(pair).collect()
    }

    fn order(&self, before: &Order, after: &Order) -> Row {
        let kind = |row: &Order| match (row.order, row.low, row.high) {
            (Some(order), Some(low), Some(high)) => format!("{order:.3} ± {:.3}", (high - low) / 2.0),
            _ => row.status.to_string(),
        };
        let size = |row: &Order| row.constant.map_or("–".to_owned(), |c| format!("{c:.3e}"));
        let same_claim = {
            let [a, b] = [0, 1].map(|side| self.sides[side].claimed_order(self.schemes[side]));
            a == b || a.is_none() || b.is_none()
        };
        let orders = before.order.zip(after.order);
        // Constants of different orders have different units.
        let same_order = orders.is_none_or(|(a, b)| a.round() == b.round());
        let constants = before.constant.zip(after.constant).filter(|_| same_claim && same_order);
        let ratio = constants.map(|(a, b)| b / a);
        let at_equal_work = match (ratio, orders) {
            (Some(ratio), Some((order, _))) => Some(ratio * self.work_ratio().powf(order)),
            _ if before.status == OrderStatus::Exact && after.status == OrderStatus::Exact => None,
            _ => self.errors_at_equal_work(&format!("{}-end", before.quantity)),
        };
        let lost = self.before_and_after && before.order.is_some() && after.order.is_none();
        let broke = after.status == OrderStatus::Broken && before.status != OrderStatus::Broken;
        let standing = match orders {
            Some((a, b)) if b.round() < a.round() => Standing::Worse,
            Some((a, b)) if b.round() > a.round() => Standing::Better,
            Some(_) if ratio.is_some() => {
                at_equal_work.map_or(Standing::Undecided, |r| Standing::of_ratio(r, SAME_CONSTANT))
            }
            _ if before.status == OrderStatus::Exact && after.status == OrderStatus::Exact => Standing::Same,
            _ if broke || (lost && after.status != OrderStatus::Exact) => Standing::Worse,
            _ => at_equal_work.map_or(Standing::Undecided, |r| Standing::of_ratio(r, SAME_DRIFT)),
        };
        let kinds = [kind(before), kind(after)];
        let sizes = [size(before), size(after)];
        Row { kinds, sizes, ratio, at_equal_work, ..self.row(&before.quantity, standing) }
    }

    /// Error of the second over that of the first for as many force evaluations, from the runs themselves.
    fn errors_at_equal_work(&self, metric: &str) -> Option<f64> {
        let [a, b] = [0, 1].map(|side| Ladder::of(&self.runs[side], metric));
        if a.is_empty() || b.is_empty() {
            return None;
        }
        a.ratio(&b)
    }

    fn drifts(&self) -> Vec<Row> {
        let [a, b] = [0, 1].map(|side| self.sides[side].drifts(self.scene, self.schemes[side]));
        let pair = |before: &&Drift| {
            let after = b.iter().find(|row| row.quantity == before.quantity)?;
            Some(self.drift(before, after))
        };
        a.iter().filter_map(pair).collect()
    }

    /// By class; secular drifts by the order of their rate, and at the same order by the rate itself; bounded ones by how far
    /// they go.
    fn drift(&self, before: &Drift, after: &Drift) -> Row {
        let kind = |row: &Drift| match row.rate_order {
            Some(order) => format!("{}, h^{order:.2}", row.class),
            None => row.class.to_string(),
        };
        let size = |row: &Drift| match (row.class, row.rate) {
            (DriftClass::Secular | DriftClass::Growing, Some(rate)) => format!("{rate:.2e} 1/s"),
            _ => row.level.map_or("–".to_owned(), |level| format!("at most {level:.1e}")),
        };
        // What the rate would be at h = 1 s.
        let scaled = |row: &Drift| Some(row.rate?.abs() / row.step_s?.powf(before.rate_order?));
        let rates = before.rate_order.zip(after.rate_order);
        let ratio = rates.and_then(|_| Some(scaled(after)? / scaled(before)?));
        let at_equal_work = match rates {
            Some((order, _)) => ratio.map(|ratio| ratio * self.work_ratio().powf(order)),
            None => self.errors_at_equal_work("rotational-energy-drift-level"),
        };
        let standing = match (rank(before.class), rank(after.class), rates) {
            (None, _, _) | (_, None, _) => Standing::Undecided,
            (Some(a), Some(b), _) if b > a => Standing::Worse,
            (Some(a), Some(b), _) if b < a => Standing::Better,
            (_, _, Some((a, b))) if b.round() < a.round() => Standing::Worse,
            (_, _, Some((a, b))) if b.round() > a.round() => Standing::Better,
            _ if before.class == DriftClass::Exact => Standing::Same,
            _ => at_equal_work.map_or(Standing::Undecided, |r| Standing::of_ratio(r, SAME_DRIFT)),
        };
        let quantity = format!("drift: {}", before.quantity);
        let (kinds, sizes) = ([kind(before), kind(after)], [size(before), size(after)]);
        Row { kinds, sizes, ratio, at_equal_work, ..self.row(&quantity, standing) }
    }

    /// Force evaluations and time of a step; more evaluations are worse where nothing in the scene is better for them.
    fn cost(&self, others: &[Row]) -> Vec<Row> {
        let mut rows = Vec::new();
        if let (Some(a), Some(b)) = (self.evaluations(0), self.evaluations(1)) {
            let ratio = b / a;
            let bought = |row: &Row| {
                row.standing == Standing::Better || row.ratio.is_some_and(|ratio| ratio * SAME_CONSTANT < 1.0)
            };
            let standing = match Standing::of_ratio(ratio, SAME_CONSTANT) {
                Standing::Worse if others.iter().any(bought) => Standing::Dearer,
                standing => standing,
            };
            let sizes = [a, b].map(|count| format!("{count:.2}"));
            rows.push(Row { sizes, ratio: Some(ratio), ..self.row("cost: evaluations a step", standing) });
        }
        if let (Some(a), Some(b)) = (self.time(0), self.time(1)) {
            let sizes = [a, b].map(|time| format!("{time:.0} ns"));
            rows.push(Row { sizes, ratio: Some(b / a), ..self.row("cost: time of a step", Standing::Shown) });
        }
        rows
    }

    /// Evaluations a step of the second over those of the first; 1 where the records do not say.
    fn work_ratio(&self) -> f64 {
        self.evaluations(0).zip(self.evaluations(1)).map_or(1.0, |(a, b)| b / a)
    }

    /// Force evaluations a step in the longest whole run.
    fn evaluations(&self, side: usize) -> Option<f64> {
        let whole = self.runs[side].iter().filter(|run| run.status == RunStatus::Ok && run.steps > 0);
        let longest = whole.max_by_key(|run| run.steps)?;
        (longest.force_evaluations > 0).then(|| longest.force_evaluations as f64 / longest.steps as f64)
    }

    /// Median time of a step over the runs [ns].
    fn time(&self, side: usize) -> Option<f64> {
        let mut times: Vec<f64> = self.runs[side].iter().filter_map(|run| run.nanoseconds_per_step).collect();
        times.sort_by(f64::total_cmp);
        times.get(times.len() / 2).copied()
    }
}

/// Kinds of drift from the best to the worst; `None` where none could be told.
fn rank(class: DriftClass) -> Option<u8> {
    match class {
        DriftClass::Exact => Some(0),
        DriftClass::Bounded => Some(1),
        DriftClass::Secular => Some(2),
        DriftClass::Growing => Some(3),
        DriftClass::Undecided => None,
    }
}
