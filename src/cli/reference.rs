//! `polhode reference`: the motion of a scene to many digits.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;

use super::output::{Force, print};
use super::{Failure, exit, select};
use crate::model::Quantity;
use crate::ode::SolverError;
use crate::record;
use crate::reference::Stored;
use crate::reference::precise::{self, DoubleDouble, MOST_DIGITS, Moment, Motion, decimal};
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
    /// Write the solution as a file for references/solutions too
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
}

const EXAMPLES: &str = "\
Examples:
  polhode reference kovalevskaya
  polhode reference my-body.toml --digits 20
  polhode reference dipole-in-field --digits 30 --out references/solutions/dipole-in-field.json

Prints X_cm, U_cm, R row by row, Omega and L at T/4, T/2, 3T/4 and T, each with a bound of its error, from a Taylor
series in double-double arithmetic and a second one of another order and other steps.

Exit code: 0 every digit that was asked for is certain, 2 fewer are (then only those are given).";

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
    let times = [0.25, 0.5, 0.75, 1.0].map(|part| part * scene.duration);
    let motion = match precise::solve(&scene.system, &times, PATIENCE) {
        Ok(motion) => motion,
        Err(SolverError::Interrupted) => return Ok(exit::INTERRUPTED),
        Err(error) => return Err(Failure::Model(format!("{}: {error}", scene.name))),
    };
    let certain = motion.certain_digits(&scene.system);
    let digits = options.digits.min(certain);
    if digits == 0 {
        return Err(Failure::Model(format!("{}: no digit of the solution is certain", scene.name)));
    }
    print(&text(&scene, &motion, digits))?;
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

/// Every quantity at every time, with its bound.
fn text(scene: &Scene, motion: &Motion, digits: usize) -> String {
    let [(order, steps), (other, other_steps)] = motion.runs;
    let mut text = format!(
        "{}: {digits} digits; Taylor series of order {order}, {steps} steps; error bounds from a second one of order \
         {other}, {other_steps} steps\n",
        scene.name
    );
    if motion.switches > 0 {
        let _ = writeln!(text, "Contacts with the ground made or lost on the way: {}", motion.switches);
    }
    for moment in &motion.moments {
        text += &format!("\nt = {} s\n", moment.time);
        for (name, vectors, quantity) in rows(moment) {
            let bound = moment.bound(quantity);
            let _ = writeln!(text, "  {name}, within {bound:.1e} {}", quantity.unit());
            for vector in vectors {
                let numbers = decimal::write_vector(&vector, bound, digits);
                let numbers = numbers.map(|x| format!("{x:>width$}", width = digits + 4));
                let _ = writeln!(text, "    {}", numbers.join("  "));
            }
        }
    }
    text
}

type Row = (&'static str, Vec<[DoubleDouble; 3]>, Quantity);

fn rows(moment: &Moment) -> [Row; 5] {
    let axes = (0..3).map(|row| [0, 1, 2].map(|column: usize| moment.axes[column][row])).collect();
    [
        ("X_cm [m]", vec![moment.position], Quantity::Position),
        ("U_cm [m/s]", vec![moment.velocity], Quantity::Velocity),
        ("R, body to world axes", axes, Quantity::Orientation),
        ("Omega [rad/s]", vec![moment.angular_velocity], Quantity::AngularVelocity),
        ("L [kg m²/s]", vec![moment.angular_momentum], Quantity::AngularMomentum),
    ]
}
