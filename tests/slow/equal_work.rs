//! The table of equal work in references/METHODOLOGY.md is what the schemes do.
//!
//! With `POLHODE_WRITE_METHODOLOGY` set it is written anew.

use std::fs;
use std::path::Path;

use polhode::campaign::Campaign;
use polhode::record::{Records, RunStatus};
use polhode::scenes;
use polhode::simulate::Contestant;

const BEGIN: &str = "<!-- equal work: written by tests/slow/equal_work.rs -->\n";
const END: &str = "<!-- end -->";

/// Steps of Peskin's run, at least.
const STEPS: u64 = 256;
/// Peskin's scheme, then those that it is compared with.
const SCHEMES: [&str; 13] = [
    "peskin-rk2",
    "rkmk4",
    "rk4-quaternion",
    "cf4",
    "exact-rotor",
    "strang-symmetric",
    "moser-veselov-4",
    "strang-rotations",
    "buss-augmented",
    "adams-bashforth-2",
    "simo-wong",
    "implicit-midpoint",
    "euler",
];

/// (evaluations, error of a body point at the end) of a scheme in a scene, where the error is more than rounding.
fn ladder(records: &Records, scene: &str, scheme: &str) -> Vec<(f64, f64)> {
    let own = records.measurements.iter().filter(|row| row.scene == scene && row.scheme == scheme);
    own.filter(|row| row.metric == "body-point-end" && row.status == RunStatus::Ok)
        .filter_map(|row| {
            let error = row.value.filter(|error| *error > 10.0 * row.uncertainty.unwrap_or(0.0))?;
            Some((row.force_evaluations as f64, error))
        })
        .collect()
}

/// The error at so many evaluations, between two runs.
fn at(ladder: &[(f64, f64)], evaluations: f64) -> Option<f64> {
    let pair = ladder.windows(2).find(|pair| pair[0].0 <= evaluations && evaluations <= pair[1].0)?;
    let part = (evaluations / pair[0].0).ln() / (pair[1].0 / pair[0].0).ln();
    Some((pair[0].1.ln() * (1.0 - part) + pair[1].1.ln() * part).exp())
}

/// Peskin's error over the other's in every scene that has both, the largest last.
fn ratios(records: &Records, scheme: &str) -> Vec<(f64, String)> {
    let of_scene = |scene: &str| {
        let own = ladder(records, scene, SCHEMES[0]);
        let steps = records.measurements.iter().filter(|row| row.scene == scene && row.scheme == SCHEMES[0]);
        let evaluations =
            steps.filter(|row| row.steps >= STEPS).map(|row| row.force_evaluations).min()? as f64;
        Some(at(&own, evaluations)? / at(&ladder(records, scene, scheme), evaluations)?)
    };
    let mut ratios: Vec<(f64, String)> = records
        .scenes
        .iter()
        .filter_map(|scene| Some((of_scene(&scene.name)?, scene.name.clone())))
        .collect();
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    ratios
}

/// To two digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.1e}").parse().expect("a number");
    if (1e-2..1e4).contains(&rounded) { format!("{rounded}") } else { format!("{rounded:e}") }
}

fn table(records: &Records) -> String {
    let mut rows: Vec<(f64, String)> = SCHEMES[1..]
        .iter()
        .map(|scheme| {
            let ratios = ratios(records, scheme);
            let count = ratios.len();
            let larger = ratios.iter().filter(|(ratio, _)| *ratio > 1.0).count();
            let median = ratios.get(count / 2).map_or(f64::NAN, |(ratio, _)| *ratio);
            let largest = ratios
                .last()
                .map_or(String::new(), |(ratio, scene)| format!("{} (`{scene}`)", short(*ratio)));
            (median, format!("| {scheme} | {count} | {larger} | {} | {largest} |", short(median)))
        })
        .collect();
    rows.sort_by(|a, b| b.0.total_cmp(&a.0));
    let rows: Vec<String> = rows.into_iter().map(|(_, row)| row).collect();
    format!(
        "| scheme | scenes | Peskin's error is larger in | ratio, median | largest |\n|---|---|---|---|---|\n{}\n",
        rows.join("\n")
    )
}

#[test]
fn the_table_of_equal_work_is_what_the_schemes_do() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("references/METHODOLOGY.md");
    let text = fs::read_to_string(&path).expect("references/METHODOLOGY.md");
    let all = Contestant::all();
    let named = |name: &&str| all.iter().find(|one| one.card.name == *name).expect("a scheme").clone();
    let records = Campaign::of(scenes::built_in(), SCHEMES.iter().map(named).collect()).run();
    let (before, rest) = text.split_once(BEGIN).expect("the table begins");
    let (found, after) = rest.split_once(END).expect("the table ends");
    let table = table(&records);
    if std::env::var_os("POLHODE_WRITE_METHODOLOGY").is_some() {
        fs::write(&path, format!("{before}{BEGIN}{table}{END}{after}")).expect("written");
    } else {
        assert_eq!(found, table);
    }
}
