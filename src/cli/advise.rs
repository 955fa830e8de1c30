//! `polhode advise`: which scheme and which step for a tolerance.

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use comfy_table::{ColumnConstraint, ContentArrangement, Table, presets};
use serde_json::{Value, json};

use super::output::print;
use super::progress::{with_bar, with_word};
use super::{Failure, select};
use crate::scenes::Scene;
use crate::simulate::Precision;
use crate::study::advice::{Advice, Answer, Answers, Question, QuestionError, SAMPLES};

/// Options of `polhode advise`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    scene: select::OneScene,
    /// Largest error that is allowed anywhere in the run, in the unit of the quantity
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    tolerance: f64,
    /// What must be right: position, velocity, orientation, angular-velocity, angular-momentum or body-point
    #[arg(long, value_name = "Q", default_value = "body-point")]
    quantity: String,
    /// Duration [s] instead of the scene's own
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    duration: Option<f64>,
    /// Scheme to ask, or `all`; may be given several times [default: all]
    #[arg(long = "scheme", value_name = "S")]
    schemes: Vec<String>,
    /// Arithmetic of the runs
    #[arg(long, value_name = "A", default_value = Precision::F64.name(),
        value_parser = PossibleValuesParser::new([Precision::F64, Precision::F32].map(Precision::name)))]
    precision: String,
    /// Rows of the table, the cheapest first
    #[arg(long, value_name = "N", default_value_t = 10)]
    top: usize,
    /// Form of the answer
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Table,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  polhode advise heavy-asymmetric-top --tolerance 1e-4
  polhode advise free-asymmetric --tolerance 1e-6 --quantity orientation --duration 60
  polhode advise my-body.toml --tolerance 1e-3 --scheme peskin-rk2 --scheme rk4-quaternion
  polhode advise free-asymmetric --tolerance 1e-4 --quantity orientation --precision f32

body-point, the default, is the largest error of any point of the body [m]: it exists for every body and counts both where the
body is and how it is turned. The error of a run is its largest at sixteen equal distances; a step is given only if its error
is below 0.8 of the tolerance and so is that of the steps below it, down to half of it. Every step divides the duration.

With --precision f32 the runs are in single precision. Below some step its rounding makes errors worse; where no step meets the
tolerance, the smallest error, its scheme and its step are printed.

Exit code: 0 some scheme meets the tolerance, 1 none does, 2 the motion itself is not known well enough to say.";

pub(super) fn advise(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let quantity = select::quantity(&options.quantity)?;
    if !(options.tolerance > 0.0 && options.tolerance.is_finite()) {
        return Err(Failure::Usage(format!(
            "--tolerance {}: expected a number above 0, in {}",
            options.tolerance,
            quantity.unit()
        )));
    }
    let scene = Scene::find(options.scene.name())?;
    let duration = options.duration.unwrap_or(scene.duration);
    if !(duration > 0.0 && duration.is_finite()) {
        return Err(Failure::Usage(format!("--duration {duration}: expected a positive number of seconds")));
    }
    let contestants = select::named(&options.schemes)?;
    let solved = with_word(quiet, "solving", || Question::new(&scene, duration, quantity, options.tolerance));
    let question = match solved {
        Ok(question) => question.at(Precision::named(&options.precision).unwrap_or_default()),
        Err(error @ QuestionError::TooFine { .. }) => {
            eprintln!("polhode: {error}");
            return Ok(2);
        }
        Err(error) => return Err(Failure::Model(error.to_string())),
    };
    let answers = with_bar(quiet, "asking schemes", |progress| question.ask(&contestants, progress));
    let text = match options.format {
        Format::Table => in_words(&scene, &question, &answers, options.top),
        Format::Json => in_json(&scene, &question, &answers),
    };
    print(&text)?;
    Ok(u8::from(answers.answers.iter().all(|answer| answer.found.is_err())))
}

fn in_words(scene: &Scene, question: &Question, answers: &Answers, top: usize) -> String {
    let unit = question.quantity.unit();
    let quantity = question.quantity.name().replace('-', " ");
    let found: Vec<(&str, &Advice)> = answers
        .answers
        .iter()
        .filter_map(|answer| Some((answer.scheme, answer.found.as_ref().ok()?)))
        .collect();
    let mut text = match found.iter().find(|(_, advice)| advice.stable) {
        Some((scheme, advice)) => format!(
            "Take {scheme} with a step of {} s, in {}.\nOver {} s of {} {quantity} is off by at most {} {unit}, asked for {}.\n\n",
            plain(advice.step),
            question.precision.name(),
            question.duration,
            scene.name,
            short(advice.error),
            plain(question.tolerance)
        ),
        None => format!(
            "{}: {quantity} within {} {unit} for {} s, in {}\n\n",
            scene.name,
            plain(question.tolerance),
            question.duration,
            question.precision.name()
        ),
    };
    if found.is_empty() {
        text += "No scheme that was asked meets this tolerance.\n";
        text += &nearest(question, answers);
    } else {
        let (stable, unstable): (Vec<_>, Vec<_>) =
            found.iter().copied().partition(|(_, advice)| advice.stable);
        for (rows, title) in [(&stable, ""), (&unstable, "\nAccurate for this long, and not stable:\n")] {
            if !rows.is_empty() {
                text += &format!("{title}{}\n", table(unit, &rows[..rows.len().min(top)]));
            }
            if rows.len() > top {
                text += &format!("{} more: --top {}\n", rows.len() - top, rows.len());
            }
        }
        if found.iter().any(|(_, advice)| advice.own_steps) {
            text += "* chooses its own steps; the step given here stands for a tolerance of its own\n";
        }
        if found.iter().any(|(_, advice)| advice.steps == SAMPLES as u64) {
            text += &format!("{SAMPLES} steps are the fewest that are tried: a larger step may do as well\n");
        }
        if let Some(noise) = answers.noise {
            let percent = 100.0 * noise;
            text += &format!(
                "cost on this machine, one thread; the same scheme timed twice differs by {percent:.1} %\n"
            );
        }
    }
    let unmet: Vec<String> = answers
        .answers
        .iter()
        .filter_map(|answer| Some(format!("  {}: {}", answer.scheme, answer.found.as_ref().err()?)))
        .collect();
    if !unmet.is_empty() {
        text += &format!("\nWithout an answer:\n{}\n", unmet.join("\n"));
    }
    text
}

/// The smallest error that was found, with its scheme and step.
fn nearest(question: &Question, answers: &Answers) -> String {
    let unmet = |answer: &Answer| Some((answer.scheme, answer.found.as_ref().err()?.nearest()?));
    answers.answers.iter().find_map(unmet).map_or(String::new(), |(scheme, nearest)| {
        format!(
            "The smallest error in {}: {:.1e} {} by {scheme} at h = {:.3e} s ({} steps).\n",
            question.precision.name(),
            nearest.error,
            question.quantity.unit(),
            nearest.step,
            nearest.steps
        )
    })
}

fn table(unit: &str, found: &[(&str, &Advice)]) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_BORDERS_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(120);
    }
    table.set_header([
        "",
        "scheme",
        "step [s]",
        "steps",
        &format!("error [{unit}]"),
        "turned a step [rad]",
        "forces a second",
        "cost of a second [µs]",
        "energy drift",
    ]);
    // Names stand whole, to be copied.
    if let Some(column) = table.column_mut(1) {
        column.set_constraint(ColumnConstraint::ContentWidth);
    }
    for (place, (scheme, advice)) in found.iter().enumerate() {
        let name = if advice.own_steps { format!("{scheme}*") } else { (*scheme).to_owned() };
        table.add_row([
            (place + 1).to_string(),
            name,
            plain(advice.step),
            advice.steps.to_string(),
            format!("{:.1e}", advice.error),
            short(advice.turned),
            short(advice.evaluations),
            advice.nanoseconds.map_or("–".to_owned(), |cost| short(cost / 1e3)),
            format!("{:+.1e}", advice.energy),
        ]);
    }
    table
}

/// A number with six digits, without a power of ten where it reads well so.
fn plain(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-5..1e7).contains(&size) {
        return format!("{value:e}");
    }
    let decimals = (5.0 - size.max(1e-5).log10().floor()).clamp(0.0, 10.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A number with about three digits, however large or small.
fn short(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if size >= 1e6 => format!("{value:.2e}"),
        size if size >= 100.0 => format!("{value:.0}"),
        size if size >= 1.0 => format!("{value:.1}"),
        size if size >= 1e-2 => format!("{value:.3}"),
        _ => format!("{value:.1e}"),
    }
}

fn in_json(scene: &Scene, question: &Question, answers: &Answers) -> String {
    let one = |answer: &Answer| -> Value {
        match &answer.found {
            Ok(advice) => json!({
                "scheme": answer.scheme,
                "step_s": advice.step,
                "steps": advice.steps,
                "error": advice.error,
                "radians_per_step": advice.turned,
                "force_evaluations_per_s": advice.evaluations,
                "nanoseconds_per_s": advice.nanoseconds,
                "energy_drift": advice.energy,
                "stable": advice.stable,
                "own_steps": advice.own_steps,
                "why": null,
            }),
            Err(why) => json!({
                "scheme": answer.scheme,
                "step_s": null,
                "smallest_error": why.nearest().map(|nearest| nearest.error),
                "smallest_error_step_s": why.nearest().map(|nearest| nearest.step),
                "why": why.to_string(),
            }),
        }
    };
    let answer = json!({
        "schema": "polhode/advice/1",
        "scene": scene.name,
        "duration_s": question.duration,
        "quantity": question.quantity.name(),
        "unit": question.quantity.unit(),
        "tolerance": question.tolerance,
        "precision": question.precision.name(),
        "noise": answers.noise,
        "answers": answers.answers.iter().map(one).collect::<Vec<_>>(),
    });
    format!("{answer:#}\n")
}
