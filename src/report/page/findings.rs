//! The answer in five sentences, generated from the records: order, constant, drift, failures, what is cheapest.

use crate::record::{Drift, DriftClass, Order, OrderStatus, Records};
use crate::report::html::largest_spin;
use crate::report::number;
use crate::report::ranking::{self, Work};
use crate::report::survey::{self, Outcome};

use super::reasons::listed;

/// Errors that a user may want, log₁₀.
const ERRORS: [i32; 3] = [-3, -6, -9];

/// What the sentences are about: the first scheme, which rankings measure the others by.
struct Subject<'a> {
    records: &'a Records,
    scheme: &'a str,
    /// Its decided orders of the quantity that a scene is ranked by.
    orders: Vec<&'a Order>,
    /// Scenes in which every error is rounding, and those in which an order stays open.
    exact: usize,
    open: usize,
}

/// A sentence each; those that the records say nothing about are left out. `main` has no schemes that stand apart.
pub(super) fn findings(records: &Records, main: &Records) -> Vec<String> {
    let Some(scheme) = survey::measured_schemes(main).into_iter().next() else { return Vec::new() };
    let quantity = |row: &Order| survey::base(ranking::quantity(main, &row.scene)) == row.quantity;
    let sought: Vec<&Order> =
        main.orders.iter().filter(|row| row.scheme == scheme && quantity(row)).collect();
    let decided = |row: &&Order| row.status == OrderStatus::Decided && row.order.is_some();
    let orders: Vec<&Order> = sought.iter().copied().filter(decided).collect();
    let exact = sought.iter().filter(|row| row.status == OrderStatus::Exact).count();
    let open = sought.len() - orders.len() - exact;
    let subject = Subject { records: main, scheme, orders, exact, open };
    let sentences =
        [subject.order(), subject.constant(), subject.drift(), subject.failures(records), subject.cheapest()];
    sentences.into_iter().flatten().collect()
}

/// The least and the greatest, with their names.
fn extremes<'a>(values: impl Iterator<Item = (f64, &'a str)> + Clone) -> Option<[(f64, &'a str); 2]> {
    let least = values.clone().min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some([least, values.max_by(|a, b| a.0.total_cmp(&b.0))?])
}

impl Subject<'_> {
    fn order(&self) -> Option<String> {
        let mut values: Vec<(f64, &str)> =
            self.orders.iter().filter_map(|row| Some((row.order?, row.scene.as_str()))).collect();
        values.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [(low, at_low), (high, at_high)] = extremes(values.iter().copied())?;
        let claimed = survey::claimed_order(self.records, self.scheme);
        let claim = claimed.map_or(String::new(), |order| format!(" (claimed: {order})"));
        let scenes = |count: usize| number::counted(count, "scene");
        let others =
            [(self.exact, "its errors are rounding at every step"), (self.open, "no order is decided")];
        let others = others.into_iter().filter(|(count, _)| *count > 0);
        let others: String = others.map(|(count, words)| format!("; in {} {words}", scenes(count))).collect();
        Some(format!(
            "{} is of order {:.2}{claim}, the median of {}, from {low:.2} ({at_low}) to {high:.2} ({at_high}){others}.",
            self.scheme,
            values[values.len() / 2].0,
            scenes(values.len()),
        ))
    }

    /// C of C (h Ω)ᵖ, which scenes of all time scales share.
    fn constant(&self) -> Option<String> {
        let claimed = survey::claimed_order(self.records, self.scheme)?;
        let angle =
            |row: &&&Order| row.unit == "rad" && row.order.is_some_and(|p| p.round() == f64::from(claimed));
        let constants = self.orders.iter().filter(angle).filter_map(|row| {
            let spin = largest_spin(self.records, &row.scene)?;
            Some((row.constant? / spin.powi(claimed as i32), row.scene.as_str()))
        });
        let mut values: Vec<(f64, &str)> = constants.collect();
        values.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [(low, at_low), (high, at_high)] = extremes(values.iter().copied())?;
        let median = values[values.len() / 2].0;
        let power = number::superscript(claimed as i32);
        let three = |value: f64| number::significant(value, 2);
        Some(format!(
            "At 0.1 rad per step a run ends {} rad off in the median scene: the orientation error is C (hΩ){power}, with Ω the largest spin and C from {} rad ({at_low}) to {} rad ({at_high}).",
            three(median * 0.1f64.powi(claimed as i32)),
            three(low),
            three(high),
        ))
    }

    fn drift(&self) -> Option<String> {
        let own: Vec<&Drift> = self.records.drifts.iter().filter(|row| row.scheme == self.scheme).collect();
        let first = own.first()?;
        let steady = || own.iter().filter(|row| row.class == DriftClass::Secular);
        let quantity = survey::quantity_words(&first.quantity);
        let rates = steady().filter_map(|row| Some((row.rate_order?, row.scene.as_str())));
        let rate = extremes(rates).map_or(String::new(), |[(low, _), (high, _)]| {
            format!(" at a rate of order {low:.2} to {high:.2} in h")
        });
        let keeps = |scheme: &&str| {
            let mut rows = self.records.drifts.iter().filter(|row| row.scheme == **scheme).peekable();
            rows.peek().is_some()
                && rows.all(|row| matches!(row.class, DriftClass::Exact | DriftClass::Bounded))
        };
        let keepers: Vec<&str> = survey::measured_schemes(self.records).into_iter().filter(keeps).collect();
        let others = if keepers.is_empty() {
            "No scheme bounds it in every scene".to_owned()
        } else {
            format!("{} bound it in every scene", listed(&keepers, "schemes"))
        };
        Some(format!(
            "Without torque its {quantity} drifts steadily in {} of {} scenes{rate}. {others}.",
            steady().count(),
            own.len()
        ))
    }

    /// Where the scheme fails, and how many of all verdicts do not hold.
    fn failures(&self, records: &Records) -> Option<String> {
        let card = self.records.schemes.iter().find(|row| row.name == self.scheme);
        let line = card.and_then(|row| row.fails_where.as_deref());
        let line = line.map(|line| format!("{} fails where: {}. ", self.scheme, line.trim_end_matches('.')));
        let judged: Vec<(Outcome, usize)> = survey::tally(records.verdicts.iter())
            .into_iter()
            .filter(|(outcome, _)| *outcome != Outcome::NotApplicable)
            .collect();
        let all: usize = judged.iter().map(|(_, count)| count).sum();
        let holding =
            judged.iter().find(|(outcome, _)| *outcome == Outcome::Pass).map_or(0, |(_, count)| *count);
        let others: Vec<(Outcome, usize)> =
            judged.into_iter().filter(|(outcome, _)| outcome.needs_attention()).collect();
        let rest = if holding == all {
            "all of them hold".to_owned()
        } else {
            format!("{holding} hold; the others: {}", survey::tally_words(&others))
        };
        (all > 0)
            .then(|| format!("{}{all} claims of all schemes were judged: {rest}.", line.unwrap_or_default()))
    }

    /// By wins: which scheme needs the fewest evaluations in most scenes. Without forces the exact motion is known, and nothing beats it.
    fn cheapest(&self) -> Option<String> {
        let scenes = survey::scenes(self.records);
        let carries = |scene: &&&str| {
            let no_order = survey::scene(self.records, scene).is_some_and(|row| row.not_for_order.is_some());
            let forced = survey::scene(self.records, scene).is_some_and(|row| !row.laws.is_empty());
            !no_order && forced && ranking::quantity(self.records, scene) == "orientation-end"
        };
        let ladders: Vec<_> = scenes
            .iter()
            .filter(carries)
            .map(|scene| ranking::ladders(self.records, scene, "orientation-end", Work::Evaluations))
            .filter(|ladders| ladders.len() > 1)
            .collect();
        let clause = |error: i32| {
            let winner = |ladders: &Vec<ranking::Ladder<'_>>| {
                let costs =
                    ladders.iter().filter_map(|one| Some((one.work_for(f64::from(error))?.0, one.scheme)));
                costs.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, scheme)| scheme.to_owned())
            };
            let winners: Vec<String> = ladders.iter().filter_map(winner).collect();
            let wins = |name: &str| winners.iter().filter(|other| *other == name).count();
            let best = winners.iter().max_by_key(|name| wins(name))?;
            let power = number::superscript(error);
            Some((best.clone(), format!("10{power} rad (in {} of {} scenes)", wins(best), winners.len())))
        };
        let clauses: Vec<(String, String)> = ERRORS.into_iter().filter_map(clause).collect();
        let best = survey::distinct(clauses.iter().map(|(best, _)| best.as_str()));
        let of = |name: &&str| {
            let own = clauses.iter().filter(|(best, _)| best == name).map(|(_, words)| words.as_str());
            format!("{name} for {}", own.collect::<Vec<_>>().join(", "))
        };
        let words: Vec<String> = best.iter().map(of).collect();
        (!words.is_empty()).then(|| {
            format!(
                "Under forces the fewest evaluations for an orientation error, in most scenes: {}.",
                words.join("; ")
            )
        })
    }
}
