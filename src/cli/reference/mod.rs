//! `polhode reference`: the motion of a scene to many digits.

mod printed;

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::output::{Force, print};
use super::progress::with_word;
use super::{Failure, exit, select};
use crate::ode::SolverError;
use crate::record;
use crate::reference::Stored;
use crate::reference::precise::{self, MOST_DIGITS};
use crate::scenes::Scene;

/// Options of `polhode reference`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    scene: select::OneScene,
    /// Significant digits, at most 30
    #[arg(long, value_name = "N", default_value_t = 25, value_parser = digits)]
    digits: usize,
    /// Times [s] [default: a quarter, half, three quarters and all of the duration]
    #[arg(long, value_name = "T,T,…", value_delimiter = ',', conflicts_with = "out")]
    times: Vec<f64>,
    /// Every H seconds to the end of the duration
    #[arg(long, value_name = "H", conflicts_with_all = ["times", "out"])]
    every: Option<f64>,
    /// Form of the solution
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write the solution as a file for references/solutions too
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Text,
    Json,
    Csv,
}

const EXAMPLES: &str = "\
Examples:
  polhode reference kovalevskaya
  polhode reference my-body.toml --digits 20
  polhode reference kovalevskaya --every 0.1 --format csv
  polhode reference dipole-in-field --digits 30 --out references/solutions/dipole-in-field.json

Prints X_cm, U_cm, R row by row, its quaternion, Omega and L, each with a bound of its error, rounding of the
digits included, from a Taylor series in double-double arithmetic and a second one of another order and other steps.

Exit code: 0 every digit that was asked for is certain, 2 fewer are (then only those are given).";

/// Most times of a solution.
const MOST_TIMES: usize = 100_000;

/// Work of a run that a user waits for: minutes. Ctrl-C ends it.
const PATIENCE: f64 = 1e12;

fn digits(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(digits) if (1..=MOST_DIGITS).contains(&digits) => Ok(digits),
        _ => Err(format!("expected a number of digits from 1 to {MOST_DIGITS}")),
    }
}

pub(super) fn reference(options: &Options, quiet: bool) -> Result<u8, Failure> {
    options.force.try_json(options.out.as_ref())?;
    let scene = Scene::find(options.scene.name())?;
    let times = times(options, scene.duration)?;
    let solved = with_word(quiet, "solving", || precise::solve(&scene.system, &times, PATIENCE));
    let motion = match solved {
        Ok(motion) => motion,
        Err(SolverError::Interrupted) => return Ok(exit::INTERRUPTED),
        Err(error) => return Err(Failure::Model(format!("{}: {error}", scene.name))),
    };
    let certain = motion.certain_digits(&scene.system);
    let digits = options.digits.min(certain);
    if digits == 0 {
        return Err(Failure::Model(format!("{}: no digit of the solution is certain", scene.name)));
    }
    print(&printed::solution(options.format, &scene, &motion, digits))?;
    if let Some(path) = &options.out {
        let stored = Stored::of(&scene.name, &scene.system, &motion, digits);
        let text = stored.text().map_err(|error| Failure::Model(format!("{}: {error}", scene.name)))?;
        record::write_whole(path, text.as_bytes())?;
    }
    if digits < options.digits && !quiet {
        eprintln!("polhode: {} digits were asked for, {certain} are certain", options.digits);
    }
    Ok(if digits < options.digits { exit::UNDECIDED } else { 0 })
}

/// Increasing times.
fn times(options: &Options, duration: f64) -> Result<Vec<f64>, Failure> {
    if let Some(every) = options.every {
        let count = (duration / every * (1.0 + 1e-12)).floor();
        if !(every > 0.0 && (1.0..=MOST_TIMES as f64).contains(&count)) {
            let least = duration / MOST_TIMES as f64;
            let expected = format!("expected {least:e} to {duration} s, the duration");
            return Err(Failure::Usage(format!("--every {every}: {expected}")));
        }
        return Ok((1..=count as u64).map(|index| index as f64 * every).collect());
    }
    let mut times = options.times.clone();
    if let Some(wrong) = times.iter().find(|time| !(**time > 0.0 && time.is_finite())) {
        return Err(Failure::Usage(format!("--times {wrong}: expected times above 0 s")));
    }
    if times.is_empty() {
        times = [0.25, 0.5, 0.75, 1.0].map(|part| part * duration).to_vec();
    }
    times.sort_by(f64::total_cmp);
    times.dedup();
    Ok(times)
}
