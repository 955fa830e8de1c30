//! `polhode inspect`: bodies of a URDF, MJCF or SDF file, or of a scene: can they exist?

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde_json::{Value, json};

use super::Failure;
use super::exit::UNDECIDED;
use super::output::{print, try_parent};
use crate::inspect::{self, Inspection, Stepping, Summary, Verdict, Written};
use crate::model::Quantity;
use crate::record;
use crate::simulate::Contestant;
use crate::study::advice::{Advice, Question};

/// Options of `polhode inspect`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// URDF, MJCF, SDF, or a scene that ends in .toml
    file: PathBuf,
    /// Write a scene of each body that can exist, and of each after its one repair
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Show every body, also where nothing was found
    #[arg(long)]
    verbose: bool,
    /// Form of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Format {
    Text,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  polhode inspect robot.urdf
  polhode inspect model.xml --out scenes        then: polhode run scenes/model-torso.toml
  polhode inspect world.sdf --format json

impossible  no distribution of mass has these numbers      limit    a point, a rod or a lamina
suspect     the outline of primitives excludes them        frame    mass and tensor are zero
rounding    within what the printed digits can hide        no-data  the file has no mass for it

A repair needs a second witness in the file: the outline, the mirrored twin, a repeated number, the
digits. Joints are left alone. A missing included file is named and left out; no xacro, no mesh files.

Exit code: 0 every body can exist, 1 some cannot, or a fault has a witness, 2 no body has numbers,
65 the file is no robot and no scene, 74 it cannot be read or a scene cannot be written.";

pub(super) fn inspect(options: &Options) -> Result<u8, Failure> {
    try_parent(options.out.as_ref())?;
    let inspection = inspect::inspect(&options.file)?;
    let scenes = inspection.scenes();
    if let Some(folder) = &options.out {
        write(folder, &scenes)?;
    }
    match options.format {
        Format::Json => print(&in_json(&inspection, &scenes))?,
        Format::Text => print(&in_words(&inspection, &scenes, options))?,
    }
    Ok(match () {
        () if inspection.is_empty() => UNDECIDED,
        () => u8::from(inspection.has_faults()),
    })
}

/// Writes the scenes; a file that is there and differs is kept.
fn write(folder: &Path, scenes: &[Written]) -> Result<(), Failure> {
    let failed = |path: &Path, source| Failure::Write { name: path.display().to_string(), source };
    std::fs::create_dir_all(folder).map_err(|source| failed(folder, source))?;
    for written in scenes {
        let path = folder.join(format!("{}.toml", written.name));
        if std::fs::read_to_string(&path).is_ok_and(|text| text == written.text) {
            continue;
        }
        if path.symlink_metadata().is_ok() {
            return Err(failed(&path, std::io::ErrorKind::AlreadyExists.into()));
        }
        record::write_whole(&path, written.text.as_bytes())?;
    }
    Ok(())
}

fn in_words(inspection: &Inspection, scenes: &[Written], options: &Options) -> String {
    let counts = inspection.counts();
    let listed: Vec<String> =
        counts.iter().map(|(verdict, count)| format!("{count} {}", verdict.word())).collect();
    let bodies: usize = counts.iter().map(|(_, count)| count).sum();
    let mut text =
        format!("{}: {}, {bodies} bodies: {}\n", inspection.file, inspection.format, listed.join(", "));
    inspection.notes.iter().for_each(|note| text += &format!("note: {note}\n"));
    let mut summaries = inspection.summaries();
    summaries.sort_by_key(|summary| summary.verdict);
    let plain = |summary: &&Summary| {
        let quiet = summary.verdict >= Verdict::Limit && summary.repair.is_empty();
        options.verbose || !(quiet && summary.seen.is_empty() && summary.remarks.is_empty())
    };
    summaries.iter().filter(plain).for_each(|summary| text += &body(summary));
    if let Some(stepping) = &inspection.stepping {
        text += &stepping_in_words(stepping, scenes);
    }
    match &options.out {
        Some(folder) => text += &format!("\n{} scenes written to {}\n", scenes.len(), folder.display()),
        None if !scenes.is_empty() => {
            text += &format!("\n--out DIR writes {} scenes, one a body\n", scenes.len())
        }
        None => {}
    }
    text
}

fn body(summary: &Summary) -> String {
    let numbers = summary.numbers.map_or_else(String::new, |(mass, [a, b, c])| {
        format!(": mass {} kg, moments {a:.6e} {b:.6e} {c:.6e} kg m²", short(mass))
    });
    let mut text =
        format!("\n{:10} {} (line {}){numbers}\n", summary.verdict.word(), summary.name, summary.line);
    for line in summary.seen.iter().chain(&summary.repair).chain(&summary.remarks) {
        text += &format!("    {line}\n");
    }
    text
}

/// Six digits or so, without an exponent where that is readable.
fn short(value: f64) -> String {
    if (1e-3..1e6).contains(&value.abs()) {
        let text = format!("{value:.6}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.6e}")
    }
}

fn stepping_in_words(stepping: &Stepping, scenes: &[Written]) -> String {
    let given = if stepping.step_given { "" } else { ", the default of the format" };
    let text = format!("\nintegrator: {}; step {} s{given}\n", stepping.integrator, stepping.step);
    text + &match advice(stepping, scenes) {
        None => String::new(),
        Some(Ok(advised)) => format!("  {}\n", advised.in_words()),
        Some(Err((body, why))) => format!("  advise: no answer for {body}: {why}\n"),
    }
}

/// The inspection as JSON, with what `advise` measures for the stepping of the file.
fn in_json(inspection: &Inspection, scenes: &[Written]) -> String {
    let mut found = inspection.to_json();
    if let Some(advice) = inspection.stepping.as_ref().and_then(|stepping| advice(stepping, scenes)) {
        found["stepping"]["advice"] = match advice {
            Ok(advised) => advised.in_json(),
            Err((body, why)) => json!({ "body": body, "why": why }),
        };
    }
    format!("{found:#}\n")
}

/// The body whose free motion changes fastest: the largest (I₃ − I₁)/I₂ of those with three moments above zero.
fn fastest(scenes: &[Written]) -> Option<&Written> {
    let spread = |written: &Written| {
        let mut moments: [f64; 3] = written.scene.system.body.moments.into();
        moments.sort_by(f64::total_cmp);
        if moments[0] > 0.0 { (moments[2] - moments[0]) / moments[1] } else { 0.0 }
    };
    scenes
        .iter()
        .filter(|written| !written.repaired && spread(written) > 0.0)
        .max_by(|a, b| spread(a).total_cmp(&spread(b)))
}

/// What the study `advice` measures for the nearest scheme, for one body that moves freely.
struct Advised<'a> {
    body: &'a str,
    scheme: &'a str,
    /// Duration of the run [s].
    duration: f64,
    /// At the step of the file, or the nearest that divides the duration.
    at: Advice,
    /// The largest step whose orientation stays within [`TOLERANCE`] [s].
    largest: Option<f64>,
}

/// That of the body whose free motion changes fastest, at the step of the file; `None` where no body or no scheme is known, and the body with
/// the reason where there is no answer.
fn advice<'a>(
    stepping: &'a Stepping,
    scenes: &'a [Written],
) -> Option<Result<Advised<'a>, (&'a str, String)>> {
    let (written, scheme) = fastest(scenes).zip(stepping.scheme)?;
    Some(advised(written, scheme, stepping.step).map_err(|why| (written.body.as_str(), why)))
}

fn advised<'a>(written: &'a Written, scheme: &'a str, step: f64) -> Result<Advised<'a>, String> {
    let contestant = Contestant::everyone()
        .into_iter()
        .find(|contestant| contestant.card.name == scheme)
        .ok_or_else(|| format!("no scheme {scheme}"))?;
    let scene = &written.scene;
    let question = Question::new(scene, scene.duration, Quantity::Orientation, TOLERANCE)
        .map_err(|error| error.to_string())?;
    let at = question.at_step(&contestant, step).map_err(|error| error.to_string())?;
    let answers = question.ask(&[contestant], &|_, _| ()).answers;
    let largest = answers.first().and_then(|answer| Some(answer.found.as_ref().ok()?.step));
    Ok(Advised { body: &written.body, scheme, duration: scene.duration, at, largest })
}

impl Advised<'_> {
    fn in_words(&self) -> String {
        let Advised { body, scheme, duration, at, largest } = self;
        let within = match largest {
            Some(step) => format!("{step:.1e} s is the largest step within {TOLERANCE:e} rad"),
            None => format!("no step was found that stays within {TOLERANCE:e} rad"),
        };
        format!(
            "advise: {body} alone, free at 3.7 rad/s for {duration} s, by {scheme} (the nearest scheme of the list)\n  \
             at {:.4e} s: off by up to {:.1e} rad, energy {:+.1e}{}; {within}",
            at.step,
            at.error,
            at.energy,
            if at.stable { "" } else { ", not stable" },
        )
    }

    fn in_json(&self) -> Value {
        json!({
            "body": self.body,
            "scheme": self.scheme,
            "duration_s": self.duration,
            "step_s": self.at.step,
            "orientation_error_max_rad": self.at.error,
            "energy_error": self.at.energy,
            "stable": self.at.stable,
            "tolerance_rad": TOLERANCE,
            "largest_step_s": self.largest,
        })
    }
}

/// Largest error of the orientation that is asked for [rad].
const TOLERANCE: f64 = 1e-3;
