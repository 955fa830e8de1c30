//! `polhode run`: one scheme, one scene, its states.

mod written;

use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use serde_json::json;

use self::written::Written;
use super::output::Force;
use super::progress::with_bar;
use super::{Failure, select};
use crate::arithmetic::{DoubleDouble, Real, Single};
use crate::campaign;
use crate::model::{Snapshot, System, SystemError};
use crate::record::{self, Motion, RunStatus, WholeFile, is_own_json};
use crate::report;
use crate::scenes::Scene;
use crate::simulate::{Arithmetic, Contestant, Form, Outcome, Plan, Precision};

/// Options of `polhode run`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    scene: select::OneScene,
    /// Scheme, or substepped-N-S for the scheme S in N equal parts of every step
    #[arg(long, value_name = "S", default_value = "peskin-rk2")]
    scheme: String,
    /// Time step [s]; the nearest that divides the duration is taken [default: a turn of 0.05 rad]
    #[arg(long, value_name = "H", conflicts_with = "steps", allow_negative_numbers = true)]
    step: Option<f64>,
    /// Number of equal steps
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    steps: Option<u64>,
    /// Duration [s] instead of the scene's own
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    duration: Option<f64>,
    /// Write every K-th state, besides the first and the last
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    every: u64,
    /// The least model of the motion, or every mass point
    #[arg(long, value_enum, default_value_t = ModelChoice::Least)]
    model: ModelChoice,
    /// Arithmetic
    #[arg(long, value_name = "A", default_value = f64::NAME, value_parser = PossibleValuesParser::new(Precision::ALL.map(Precision::name)))]
    precision: String,
    /// Format of the states
    #[arg(long, value_enum, default_value_t = Format::Json)]
    format: Format,
    /// File to write instead of stdout
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Draw the motion: polhode, path of an axis, Ω and energy against time
    #[arg(long, value_name = "FILE.png")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
}

const EXAMPLES: &str = "\
Examples:
  polhode run dzhanibekov --format csv
  polhode run dzhanibekov --scheme peskin-rk2 --step 0.01 --every 10
  polhode run dzhanibekov --every 10 --plot dzhanibekov.png --out states.json
  polhode run my-body.toml --scheme euler --steps 1000 --format csv --out run.csv
  polhode run kovalevskaya --scheme peskin-rk2 --steps 600 --model points
  polhode run kovalevskaya --scheme rkmk4 --steps 600 --every 600 --precision double-double";

#[derive(Clone, Copy, Debug, ValueEnum)]
enum ModelChoice {
    Least,
    Points,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Json,
    Csv,
}

pub(super) fn run(options: &Options, quiet: bool) -> Result<u8, Failure> {
    match Precision::named(&options.precision).unwrap_or_default() {
        Precision::F64 => run_in::<f64>(options, quiet),
        Precision::F32 => run_in::<Single>(options, quiet),
        Precision::DoubleDouble => run_in::<DoubleDouble>(options, quiet),
    }
}

fn run_in<T: Written>(options: &Options, quiet: bool) -> Result<u8, Failure> {
    options.force.try_place(options.out.as_ref(), is_own)?;
    options.force.try_picture(options.plot.as_ref())?;
    let contestant = select::contestant(&options.scheme)?;
    let scene = Scene::find(options.scene.name())?;
    let plan = plan(options, &scene)?;
    // A step that divides the duration to rounding is the one asked for.
    let as_asked = options.step.is_some_and(|step| (plan.step / step - 1.0).abs() <= 1e-9);
    if !quiet && options.steps.is_none() && !as_asked {
        eprintln!("polhode: {} with a step of {} s, {} steps", options.scheme, plan.step, plan.steps);
    }
    let cannot = |reason: &str| {
        Failure::Model(format!("{} cannot take {}: {reason}", contestant.card.name, scene.name))
    };
    if let Some(reason) = contestant.refusal(&scene.system) {
        return Err(cannot(&reason));
    }
    let form = form(options, &contestant)?;
    let unfit = |error: SystemError| Failure::Model(format!("{}: {error}", scene.name));
    let given = form.model(&scene.system).map_err(unfit)?;
    let system = System::<T>::of(&scene.system).map_err(unfit)?;
    let model = if form == Form::Least { contestant.model(&scene.system) } else { given.name() };
    let mut file = options.out.as_deref().map(WholeFile::begin).transpose()?;
    let mut stdout = BufWriter::new(io::stdout().lock());
    let sink: &mut dyn Write = match &mut file {
        Some(file) => file,
        None => &mut stdout,
    };
    let name = options.out.as_ref().map_or("stdout".to_owned(), |path| path.display().to_string());
    let to_stdout = options.out.is_none();
    let fail = |source: io::Error| match source.kind() {
        io::ErrorKind::BrokenPipe if to_stdout => Failure::ReaderGone,
        _ => Failure::Write { name, source },
    };
    let heading = heading::<T>(options.format, &scene.name, contestant.card.name, model, &plan);
    let mut writer = StateWriter::new(sink, &system, plan, options.format, heading);
    // On a terminal the states themselves show how far the run is.
    let shown = !quiet && (options.out.is_some() || !io::stdout().is_terminal());
    let outcome = stream((&contestant, form), &mut writer, shown);
    if let Some(reason) = outcome.refusal() {
        return Err(cannot(reason));
    }
    writer.close(&outcome).map_err(fail)?;
    if let Some(warning) = coarse(&plan, writer.fastest).filter(|_| !quiet) {
        eprintln!("polhode: warning: {warning}");
    }
    if let Some(file) = file {
        file.finish()?;
    }
    if let Some(path) = &options.plot {
        draw(path, &scene, (&contestant, form), &system, &plan)?;
    }
    if let Some(broken) = &outcome.broken {
        eprintln!("polhode: {} in {}: {broken}", contestant.card.name, scene.name);
    }
    Ok(u8::from(outcome.broken.is_some()))
}

/// Runs, and hands over every state as it comes.
fn stream<T: Written>(
    (contestant, form): (&Contestant, Form),
    writer: &mut StateWriter<T>,
    shown: bool,
) -> Outcome {
    let (system, plan) = (writer.system, writer.plan);
    with_bar(!shown, "running", |progress| {
        contestant.stream_in(system, form, &plan, &mut |snapshot| {
            writer.push(snapshot);
            progress(writer.step as usize, plan.steps as usize);
        })
    })
}

/// States that a picture is drawn from, about: a pixel of a path needs no more.
const DRAWN: u64 = 4096;

/// Writes the picture of a run, which is run once more: what is written may be fewer states than a path needs.
fn draw<T: Arithmetic>(
    path: &Path,
    scene: &Scene,
    (contestant, form): (&Contestant, Form),
    system: &System<T>,
    plan: &Plan,
) -> Result<(), Failure> {
    let plan = Plan { every: (plan.steps / DRAWN).max(1), ..*plan };
    let states: Vec<Snapshot> =
        contestant.run_in(system, form, &plan).0.iter().map(Snapshot::nearest).collect();
    let motion = campaign::motion(&scene.system, &states);
    let (scene, scheme) = (scene.name.clone(), contestant.card.name.to_owned());
    let png = report::motion_picture(&Motion { scene, scheme, step_s: plan.step, ..motion });
    Ok(record::write_whole(path, &png.map_err(|error| Failure::Usage(error.to_string()))?)?)
}

/// Angle of a step above which `run` warns [rad]: an order is seen below it, where a step is a small part of a turn.
const COARSE: f64 = 1.0;

/// What is to be said of steps in which the body turns far, by the fastest spin of the states written.
fn coarse(plan: &Plan, fastest: f64) -> Option<String> {
    let angle = fastest * plan.step;
    (angle > COARSE).then(|| {
        format!(
            "a step of {} s turns the body by up to {angle:.3} rad; --step {} keeps it below {COARSE} rad",
            plan.step,
            format_step(COARSE / fastest)
        )
    })
}

/// A step in four digits.
fn format_step(step: f64) -> String {
    if (1e-3..1e4).contains(&step) { format!("{step:.4}") } else { format!("{step:.3e}") }
}

/// Whether a file begins like one of this command.
fn is_own(head: &str) -> bool {
    is_own_json(head) || head.starts_with(CSV_HEADER)
}

fn form(options: &Options, contestant: &Contestant) -> Result<Form, Failure> {
    match options.model {
        ModelChoice::Points if !contestant.takes_points() => Err(Failure::Usage(format!(
            "{} brings its own body and does not run on mass points",
            contestant.card.name
        ))),
        ModelChoice::Points => Ok(Form::Points),
        ModelChoice::Least => Ok(Form::Least),
    }
}

/// The steps of a run.
fn plan(options: &Options, scene: &Scene) -> Result<Plan, Failure> {
    let duration = options.duration.unwrap_or(scene.duration);
    if !(duration > 0.0 && duration.is_finite()) {
        return Err(Failure::Usage(format!("--duration {duration}: expected a positive number of seconds")));
    }
    let steps = match options.steps {
        Some(steps) => steps,
        None => steps_of(options.step.unwrap_or_else(|| campaign::typical_step(scene)), duration)?,
    };
    Ok(Plan { step: duration / steps as f64, steps, every: options.every })
}

/// The number of steps that makes them nearest to the one asked for.
fn steps_of(step: f64, duration: f64) -> Result<u64, Failure> {
    if !(step > 0.0 && step.is_finite()) {
        return Err(Failure::Usage(format!("--step {step}: expected a positive number of seconds")));
    }
    let ratio = duration / step;
    if ratio > 1e15 {
        return Err(Failure::Usage(format!("--step {step}: {ratio:e} steps are too many")));
    }
    let off = |steps: f64| (duration / steps - step).abs();
    let (fewer, more) = (ratio.floor().max(1.0), ratio.ceil().max(1.0));
    Ok(if off(fewer) < off(more) { fewer } else { more } as u64)
}

/// Writes states as they come.
struct StateWriter<'a, T: Written> {
    sink: &'a mut dyn Write,
    system: &'a System<T>,
    plan: Plan,
    count: u64,
    /// Step of the last state.
    step: u64,
    /// Largest |Ω| of the states [rad/s].
    fastest: f64,
    failed: Option<io::Error>,
    format: Format,
    /// What stands before the first state, until it is written.
    heading: String,
}

const CSV_HEADER: &str =
    "step,t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,lx,ly,lz,kinetic_energy_j,potential_energy_j";

fn heading<T: Written>(format: Format, scene: &str, scheme: &str, model: &str, plan: &Plan) -> String {
    match format {
        Format::Csv => format!("{CSV_HEADER}\n"),
        Format::Json => format!(
            "{{\n  \"schema\": \"polhode/run/1\",\n  \"precision\": {},\n  \"scene\": {},\n  \"scheme\": {},\n  \"model\": {},\n  \"step_s\": {},\n  \"states\": [",
            json!(T::NAME),
            json!(scene),
            json!(scheme),
            json!(model),
            json!(plan.step)
        ),
    }
}

impl<'a, T: Written> StateWriter<'a, T> {
    fn new(
        sink: &'a mut dyn Write,
        system: &'a System<T>,
        plan: Plan,
        format: Format,
        heading: String,
    ) -> StateWriter<'a, T> {
        StateWriter { sink, system, plan, count: 0, step: 0, fastest: 0.0, failed: None, format, heading }
    }

    fn open(&mut self) -> io::Result<()> {
        write!(self.sink, "{}", std::mem::take(&mut self.heading))
    }

    /// Takes a state; the failure of a sink is reported at the end.
    fn push(&mut self, snapshot: &Snapshot<T>) {
        self.step = (snapshot.time.to_f64() / self.plan.step).round() as u64;
        if self.failed.is_none()
            && let Err(error) = self.write(snapshot)
        {
            self.failed = Some(error);
            crate::interrupt::request();
        }
        self.count += 1;
        self.fastest = self.fastest.max(snapshot.angular_velocity.norm().to_f64());
    }

    fn write(&mut self, s: &Snapshot<T>) -> io::Result<()> {
        self.open()?;
        let step = self.step;
        let q = s.orientation.quaternion();
        let attitude = [q.w, q.i, q.j, q.k];
        let (kinetic, potential) = (self.system.kinetic_energy(s), self.system.potential_energy(s));
        match self.format {
            Format::Csv => {
                write!(self.sink, "{step},{}", s.time.text())?;
                let vectors = [&s.velocity, &s.angular_velocity, &s.angular_momentum];
                let numbers = s.position.iter().chain(&attitude).chain(vectors.into_iter().flatten());
                for number in numbers {
                    write!(self.sink, ",{}", number.text())?;
                }
                writeln!(self.sink, ",{},{}", kinetic.text(), potential.map_or(String::new(), T::text))
            }
            Format::Json => {
                let list = |numbers: &[T]| {
                    format!("[{}]", numbers.iter().map(|x| x.json()).collect::<Vec<_>>().join(","))
                };
                let potential = potential.map_or("null".to_owned(), T::json);
                let rows = [
                    ("angular_momentum_kg_m2_s", list(s.angular_momentum.as_slice())),
                    ("angular_velocity_rad_s", list(s.angular_velocity.as_slice())),
                    ("kinetic_energy_j", kinetic.json()),
                    ("orientation_wxyz", list(&attitude)),
                    ("position_m", list(s.position.as_slice())),
                    ("potential_energy_j", potential),
                    ("step", step.to_string()),
                    ("time_s", s.time.json()),
                    ("velocity_m_s", list(s.velocity.as_slice())),
                ];
                let rows = rows.map(|(key, value)| format!("\"{key}\":{value}")).join(",");
                write!(self.sink, "{}\n    {{{rows}}}", if self.count == 0 { "" } else { "," })
            }
        }
    }

    fn close(&mut self, outcome: &Outcome) -> io::Result<()> {
        if let Some(error) = self.failed.take() {
            return Err(error);
        }
        self.open()?;
        if let Format::Json = self.format {
            let status = if outcome.broken.is_some() { RunStatus::Broken } else { RunStatus::Ok };
            let why = outcome.broken.as_ref().map(ToString::to_string);
            writeln!(
                self.sink,
                "\n  ],\n  \"steps\": {},\n  \"status\": {},\n  \"why\": {},\n  \"force_evaluations\": {}\n}}",
                outcome.steps,
                json!(status),
                json!(why),
                outcome.evaluations
            )?;
        }
        self.sink.flush()
    }
}
