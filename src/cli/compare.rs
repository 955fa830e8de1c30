//! `polhode compare`: two schemes, or two records files, side by side.

use std::path::Path;

use clap::Args;
use comfy_table::{ContentArrangement, Table, presets};

use super::Failure;
use super::gate::measure_with;
use super::report::SECONDS_A_COST;
use super::select::{self, Selection};
use crate::campaign;
use crate::gates::Baseline;
use crate::record::{Drift, Order, Records};

/// Options of `polhode compare`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// A scheme, or a records file
    a: String,
    /// Another scheme, or another records file
    b: String,
    /// Scene to compare in: a built-in name or a TOML file; may be given several times [default: all built-in]
    #[arg(long = "scene", value_name = "X")]
    scenes: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  polhode compare peskin-rk2 peskin-heun
  polhode compare peskin-rk2 rk4-quaternion --scene kovalevskaya
  polhode compare before.json after.json

Exit code: 0 the second is nowhere worse, 1 it is somewhere: an order lower by more than 0.15, an order that can no longer
be read, or at the same order an error constant larger by more than 5 %.";

/// Orders that differ by no more than this are the same.
const SAME_ORDER: f64 = 0.15;
/// A larger constant than this, relative, is worse.
const SAME_CONSTANT: f64 = 1.05;

/// The rows of one side.
struct Side {
    name: String,
    records: Records,
    /// The one scheme that is compared; any of a records file, by its own name.
    scheme: Option<String>,
}

pub(super) fn compare(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let (a, b) = sides(options, quiet)?;
    let chosen = |scene: &str| options.scenes.is_empty() || options.scenes.iter().any(|name| name == scene);
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(120);
    }
    table.set_header(["scene", "quantity", "order", "order", "constant", "constant", "ratio", ""]);
    let mut worse = 0;
    let mut compared = 0;
    for before in a.orders() {
        let Some(after) = b.partner(before) else { continue };
        if a.scheme.is_none() && !chosen(&before.scene) {
            continue;
        }
        compared += 1;
        let verdict = judge(before, after);
        worse += usize::from(verdict == "worse");
        table.add_row(row(before, after, verdict));
    }
    for before in a.drifts() {
        if let Some(after) = b.drift(before) {
            table.add_row(drift_row(before, after));
        }
    }
    if compared == 0 {
        return Err(Failure::Usage(format!("{} and {} have no scene and scheme in common", a.name, b.name)));
    }
    super::run::print(&format!(
        "{table}\n\n{} → {}: {}{compared} quantities compared, {worse} worse\n",
        a.name,
        b.name,
        costs(&a, &b)
    ))?;
    Ok(u8::from(worse > 0))
}

/// Two files, or two schemes measured in one campaign.
fn sides(options: &Options, quiet: bool) -> Result<(Side, Side), Failure> {
    let is_file = |name: &str| name.ends_with(".json") || Path::new(name).is_file();
    let file = |name: &str| {
        Records::read(Path::new(name)).map(|records| Side { name: name.to_owned(), records, scheme: None })
    };
    match (is_file(&options.a), is_file(&options.b)) {
        (true, true) => Ok((file(&options.a)?, file(&options.b)?)),
        (false, false) => {
            let contestants = vec![select::contestant(&options.a)?, select::contestant(&options.b)?];
            let scenes = Selection::of_scenes(options.scenes.clone()).scenes()?;
            let mut records =
                measure_with(scenes.clone(), contestants.clone(), Baseline::built_in(), false, quiet);
            campaign::add_costs(&mut records, &scenes, &contestants, SECONDS_A_COST);
            let side = |name: &String| Side {
                name: name.clone(),
                records: records.clone(),
                scheme: Some(name.clone()),
            };
            Ok((side(&options.a), side(&options.b)))
        }
        _ => Err(Failure::Usage("compare two schemes or two records files, not one of each".to_owned())),
    }
}

impl Side {
    fn is_mine(&self, scheme: &str) -> bool {
        self.scheme.as_deref().is_none_or(|own| own == scheme)
    }

    fn orders(&self) -> impl Iterator<Item = &Order> {
        self.records.orders.iter().filter(|row| self.is_mine(&row.scheme))
    }

    fn drifts(&self) -> impl Iterator<Item = &Drift> {
        self.records.drifts.iter().filter(|row| self.is_mine(&row.scheme))
    }

    /// The row of this side that stands for the same thing.
    fn partner(&self, other: &Order) -> Option<&Order> {
        self.orders().find(|row| {
            row.scene == other.scene
                && row.quantity == other.quantity
                && self.same_scheme(&row.scheme, &other.scheme)
        })
    }

    fn drift(&self, other: &Drift) -> Option<&Drift> {
        self.drifts().find(|row| {
            row.scene == other.scene
                && row.quantity == other.quantity
                && self.same_scheme(&row.scheme, &other.scheme)
        })
    }

    fn same_scheme(&self, own: &str, other: &str) -> bool {
        self.scheme.is_some() || own == other
    }

    /// Median cost of a step over the runs [ns]; `None` where none was measured.
    fn cost(&self) -> Option<f64> {
        let rows = self.records.measurements.iter().filter(|row| self.is_mine(&row.scheme));
        let mut costs: Vec<f64> = rows.filter_map(|row| row.nanoseconds_per_step).collect();
        costs.sort_by(f64::total_cmp);
        costs.get(costs.len() / 2).copied()
    }
}

/// The second beside the first.
fn judge(before: &Order, after: &Order) -> &'static str {
    match (before.order, after.order) {
        (Some(a), Some(b)) if b < a - SAME_ORDER => "worse",
        (Some(a), Some(b)) if b > a + SAME_ORDER => "better",
        (Some(_), Some(_)) => match (before.constant, after.constant) {
            (Some(a), Some(b)) if b > a * SAME_CONSTANT => "worse",
            (Some(a), Some(b)) if b * SAME_CONSTANT < a => "better",
            _ => "same",
        },
        (Some(_), None) if after.status == "exact" => "better",
        (None, Some(_)) if before.status == "exact" => "worse",
        (Some(_), None) => "worse",
        (None, Some(_)) => "better",
        (None, None) => "same",
    }
}

fn row(before: &Order, after: &Order, verdict: &str) -> Vec<String> {
    let order = |row: &Order| match (row.order, row.low, row.high) {
        (Some(order), Some(low), Some(high)) => format!("{order:.3} [{low:.3}, {high:.3}]"),
        _ => row.status.clone(),
    };
    let constant = |row: &Order| row.constant.map_or("–".to_owned(), |c| format!("{c:.3e}"));
    let ratio =
        before.constant.zip(after.constant).map_or("–".to_owned(), |(a, b)| format!("{:.3}", b / a));
    vec![
        before.scene.clone(),
        before.quantity.clone(),
        order(before),
        order(after),
        constant(before),
        constant(after),
        ratio,
        verdict.to_owned(),
    ]
}

fn drift_row(before: &Drift, after: &Drift) -> Vec<String> {
    let order = |row: &Drift| {
        row.rate_order.map_or(row.class.clone(), |order| format!("{}, rate ∝ h^{order:.2}", row.class))
    };
    let rate = |row: &Drift| row.rate.map_or("–".to_owned(), |rate| format!("{rate:.2e} 1/s"));
    vec![
        before.scene.clone(),
        format!("drift of {}", before.quantity),
        order(before),
        order(after),
        rate(before),
        rate(after),
        "–".to_owned(),
        String::new(),
    ]
}

/// Cost of a step on either side, from the same campaign; a wall-clock time decides nothing.
fn costs(a: &Side, b: &Side) -> String {
    match (a.cost(), b.cost()) {
        (Some(a), Some(b)) => format!("median cost of a step {a:.0} ns and {b:.0} ns, ratio {:.2}; ", b / a),
        _ => String::new(),
    }
}
