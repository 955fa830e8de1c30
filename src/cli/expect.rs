//! `polhode expect`: the error that a scheme will have at a step, and the assertion that says so.

use std::fmt::Write as _;

use clap::{Args, ValueEnum};
use serde_json::json;

use super::exit::UNDECIDED;
use super::output::print;
use super::progress::with_word;
use super::{Failure, select};
use crate::gates::Baseline;
use crate::model::Quantity;
use crate::reference::{Reference, stored};
use crate::scenes::Scene;
use crate::simulate::Contestant;
use crate::study::expect::{Bracket, Expected, Unexpected};

/// Options of `polhode expect`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    scene: select::OneScene,
    /// Scheme
    #[arg(long, value_name = "S")]
    scheme: String,
    /// Time step [s]
    #[arg(long, value_name = "H", allow_negative_numbers = true)]
    step: f64,
    /// Quantity to assert [default: every one that has a prediction]
    #[arg(long, value_name = "Q")]
    quantity: Option<String>,
    /// Form of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Text,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  polhode expect kovalevskaya --scheme peskin-rk2 --step 0.01
  polhode expect my-body.toml --scheme rk4-quaternion --step 0.01 --quantity orientation

The error is C h^p times its shape over the run; C is the constant on record, or that of the runs. Two runs on both
sides of the step check it; the band is what it misses them by, and 1 %.
Exit code: 0 some error is predicted, 2 none is.";

/// Samples of the reference: each ends a step of any power of two from here on.
const SAMPLES: usize = 256;

type Row = (Quantity, Result<Expected, Unexpected>);

pub(super) fn expect(options: &Options, quiet: bool) -> Result<u8, Failure> {
    if !(options.step > 0.0 && options.step.is_finite()) {
        let step = options.step;
        return Err(Failure::Usage(format!("--step {step}: expected a positive number of seconds")));
    }
    let only = options.quantity.as_deref().map(select::quantity).transpose()?;
    let scene = Scene::find(options.scene.name())?;
    let contestant = select::contestant(&options.scheme)?;
    if let Some(reason) = contestant.refusal(&scene.system) {
        let scheme = contestant.card.name;
        return Err(Failure::Model(format!("{scheme} cannot take {}: {reason}", scene.name)));
    }
    let bracket = with_word(quiet, "running", || bracket(&scene, &contestant, options.step))?;
    let rows = rows(&scene, &contestant, &bracket, options.step);
    let rows: Vec<Row> =
        rows.into_iter().filter(|(quantity, _)| only.is_none_or(|one| one == *quantity)).collect();
    print(&match options.format {
        Format::Text => text(options, &scene, &bracket, &rows),
        Format::Json => in_json(options, &scene, &bracket, &rows),
    })?;
    Ok(if rows.iter().any(|(_, row)| row.is_ok()) { 0 } else { UNDECIDED })
}

fn bracket(scene: &Scene, contestant: &Contestant, step: f64) -> Result<Bracket, Failure> {
    let model = |error: &dyn std::fmt::Display| Failure::Model(format!("{}: {error}", scene.name));
    let known = if scene.built_in { stored::find(&scene.name).map_err(|error| model(&error))? } else { None };
    let reference = Reference::of(&scene.system, scene.duration, SAMPLES, known.as_ref());
    let reference = reference.map_err(|error| model(&error))?;
    let bracket = Bracket::of(scene, &reference, contestant, step).ok_or_else(|| {
        let (most, least) = (scene.duration, scene.duration / f64::from(1 << 20));
        Failure::Usage(format!("--step {step}: expected a step from {least:.1e} s to {most} s, the duration"))
    })?;
    match bracket.refusal() {
        Some(reason) => Err(model(&format!("{} cannot take it: {reason}", contestant.card.name))),
        None => Ok(bracket),
    }
}

fn rows(scene: &Scene, contestant: &Contestant, bracket: &Bracket, step: f64) -> Vec<Row> {
    let (baseline, content) = (Baseline::built_in(), scene.content());
    let constant =
        |quantity: Quantity| baseline.find(&content, contestant.card.name, quantity.name())?.constant;
    let mut expected = Vec::new();
    let of_all = bracket.expect(step, constant);
    for (quantity, one) in of_all.iter() {
        expected.push((quantity, one.clone()));
    }
    expected
}

fn text(options: &Options, scene: &Scene, bracket: &Bracket, rows: &[Row]) -> String {
    let (coarse, fine) = bracket.steps();
    let mut text = format!(
        "{} in {} at h = {} s, checked by runs at {coarse:.3e} s and {fine:.3e} s\n\n",
        options.scheme, scene.name, options.step
    );
    let header = ["quantity", "order", "at the end", "largest in the run", "constant"];
    let [quantity, order, end, max, constant] = header;
    let _ = writeln!(text, "{quantity:17} {order:>5}  {end:24} {max:24} {constant}");
    for (quantity, row) in rows {
        let name = quantity.name();
        let _ = match row {
            Err(why) => writeln!(text, "{name:17}     –  {why}"),
            Ok(expected) => {
                let Expected { order, error, band, on_record, .. } = expected;
                let place = |error: f64, band: f64| {
                    format!("{error:.2e} {} ± {:.0} %", quantity.unit(), (100.0 * band).ceil())
                };
                let source = if *on_record { "on record" } else { "of the runs" };
                let (end, max) = (place(error.end, band.end), place(error.max, band.max));
                writeln!(text, "{name:17} {order:>5}  {end:24} {max:24} {source}")
            }
        };
    }
    for (language, assertion) in [("Python", PYTHON), ("C++", CPP), ("Rust", RUST)] {
        let lines: Vec<String> = rows.iter().filter_map(|row| line(assertion, options, scene, row)).collect();
        if !lines.is_empty() {
            let _ = write!(text, "\n{language}\n{}", lines.concat());
        }
    }
    text
}

/// How a language asserts that an error is below a bound and says why.
type Assertion = fn(&str, &str, u32, &str) -> String;

const PYTHON: Assertion =
    |error, bound, order, why| format!("assert {error} <= {bound} * h**{order}  # {why}\n");
const CPP: Assertion =
    |error, bound, order, why| format!("assert({error} <= {bound} * std::pow(h, {order}));  // {why}\n");
const RUST: Assertion =
    |error, bound, order, why| format!("assert!({error} <= {bound} * f64::powi(h, {order}));  // {why}\n");

/// The assertion on the largest error over the run: the upper end of the band, as a constant times a power of h.
fn line(assertion: Assertion, options: &Options, scene: &Scene, (quantity, row): &Row) -> Option<String> {
    let expected = row.as_ref().ok()?;
    let bound = upper(options.step, expected);
    let name = quantity.name().replace('-', "_") + "_error";
    let (unit, scheme) = (quantity.unit(), &options.scheme);
    let why = format!("{unit}, largest in {} under {scheme}", scene.name);
    Some(assertion(&name, &format!("{bound:.3e}"), expected.order, &why))
}

/// The upper end of the band of the largest error over hᵖ.
fn upper(step: f64, expected: &Expected) -> f64 {
    expected.error.max * (1.0 + expected.band.max) / step.powi(expected.order as i32)
}

fn in_json(options: &Options, scene: &Scene, bracket: &Bracket, rows: &[Row]) -> String {
    let row = |(quantity, row): &Row| {
        let (name, unit) = (quantity.name(), quantity.unit());
        match row {
            Err(why) => json!({"quantity": name, "unit": unit, "why": why.to_string()}),
            Ok(expected) => json!({
                "quantity": name, "unit": unit, "order": expected.order, "constant": expected.constant,
                "constant_on_record": expected.on_record,
                "end": expected.error.end, "end_band": expected.band.end,
                "max": expected.error.max, "max_band": expected.band.max,
                "bound_over_step_to_order": upper(options.step, expected),
            }),
        }
    };
    let (coarse, fine) = bracket.steps();
    let answer = json!({
        "schema": "polhode/expect/1", "scene": scene.name, "scheme": options.scheme, "step_s": options.step,
        "checked_at_s": [coarse, fine], "expected": rows.iter().map(row).collect::<Vec<_>>(),
    });
    format!("{answer:#}\n")
}
