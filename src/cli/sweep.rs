//! `polhode sweep`: one scene with its numbers varied, as a tidy table and as a picture.

mod table;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::output::{Force, print};
use super::progress::with_bar;
use super::resume::with_journal;
use super::{Failure, select};
use crate::campaign;
use crate::interrupt;
use crate::record;
use crate::report::heat_map::{HeatMap, Map, Range, Scale};
use crate::report::line_chart::{Line, LineChart, LinePanel};
use crate::scenes::{FILES, Scene};
use crate::study::sweep::{Axis, Row, STEP, SceneText, Sweep};

/// Options of `polhode sweep`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    scene: select::OneScene,
    /// What to vary: key=from:to:n, or key=from:to:n:log for equal ratios; once or several times
    #[arg(long, value_name = "KEY=FROM:TO:N", required = true, allow_hyphen_values = true)]
    vary: Vec<String>,
    /// Scheme, or `all`; may be given several times
    #[arg(long = "scheme", value_name = "S", default_value = "peskin-rk2")]
    schemes: Vec<String>,
    /// Time step [s] where it is not varied [default: a turn of 0.05 rad]
    #[arg(long, value_name = "H", allow_negative_numbers = true)]
    step: Option<f64>,
    /// Quantity whose error at the end is measured
    #[arg(long, value_name = "Q", default_value = "body-point")]
    quantity: String,
    /// Whether errors are measured, against a reference of every scene of the sweep
    #[arg(long, value_enum, default_value_t = Errors::Auto)]
    errors: Errors,
    /// What the picture shows
    #[arg(long, value_enum, default_value_t = Shown::Error)]
    show: Shown,
    /// Form of the table
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// File for the table instead of stdout; the picture goes beside it
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// File for the picture
    #[arg(long, value_name = "FILE.png")]
    plot: Option<PathBuf>,
    /// Go on where a killed run with the same --out stopped
    #[arg(long, requires = "out")]
    resume: bool,
    #[command(flatten)]
    force: Force,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, ValueEnum)]
enum Format {
    /// A line a row
    #[default]
    Csv,
    /// An object a row
    Json,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Errors {
    /// Up to 400 scenes
    Auto,
    Always,
    Never,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Shown {
    Error,
    Energy,
}

const EXAMPLES: &str = "\
Examples:
  polhode sweep tether-springs --vary step=1e-3:1e-1:20:log --scheme peskin-rk2 --scheme rk4-quaternion --out steps.csv
  polhode sweep tether-springs --vary forces.0.stiffness=1:1e4:40:log --vary step=1e-3:0.1:40:log --plot map.png
  polhode sweep my-body.toml --vary initial.angular_velocity.2=0:20:41 --vary body.scale=0.5:2:3

Keys: step, and every number of the scene file by its path; lists are counted from 0, and * stands for every item. body.scale
is a factor of all lengths of the body. The step is the nearest to the one asked for that divides the duration.

Exit code: 0 the table was written; a run that breaks or a scene that cannot be is a row of it.";

/// Scenes whose references are worth waiting for without being asked.
const AFFORDABLE: usize = 400;
/// Most runs of a sweep.
const MOST_RUNS: usize = 1_000_000;

pub(super) fn sweep(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let scene = Scene::find(options.scene.name())?;
    let contestants = select::named(&options.schemes)?;
    let sweep = plan(options, &scene)?;
    let runs = sweep.len().saturating_mul(contestants.len());
    if runs > MOST_RUNS {
        return Err(Failure::Usage(format!("{runs} runs are too many: {MOST_RUNS} at most")));
    }
    let picture = options.plot.clone().or(options.out.as_ref().map(|path| path.with_extension("png")));
    let own_csv = |head: &str| head.starts_with("scheme,") && head.contains(",step_s,steps,status,why,");
    let own_table = |head: &str| own_csv(head) || record::is_own_json(head);
    options.force.try_place(options.out.as_ref(), own_table)?;
    options.force.try_picture(picture.as_ref())?;
    if !quiet {
        eprintln!("polhode: {runs} runs of {} under {}", scene.name, options.schemes.join(", "));
    }
    with_journal(options.out.as_deref(), (options.resume, options.force, quiet), |journal| {
        let rows = with_bar(quiet, "running", |progress| sweep.run(&contestants, journal, progress));
        let text = match options.format {
            Format::Csv => table::csv(&sweep, &rows),
            Format::Json => table::json(&scene.name, &sweep, &rows),
        };
        match &options.out {
            Some(path) => record::write_whole(path, text.as_bytes())?,
            None => print(&text)?,
        }
        if !quiet {
            say(options, &sweep, &rows);
        }
        // The picture of half a sweep is not drawn.
        if let Some(path) = picture.filter(|_| !interrupt::requested()) {
            let names = contestants.iter().map(|contestant| contestant.card.name).collect();
            draw(&Drawn { options, scene: &scene, sweep: &sweep, names, rows: &rows }, &path, quiet)?;
        }
        Ok(0)
    })
}

/// Which steps were taken, why a column is empty, and where the table is.
fn say(options: &Options, sweep: &Sweep, rows: &[Row]) {
    if sweep.axes.iter().all(|axis| axis.key != STEP) {
        let taken = rows.iter().map(|row| row.step).find(|step| *step > 0.0);
        let taken = taken.filter(|taken| options.step.is_none_or(|asked| (taken / asked - 1.0).abs() > 1e-9));
        if let Some(step) = taken {
            eprintln!("polhode: a step of {step} s, which divides the duration");
        }
    }
    if !sweep.with_errors && options.errors == Errors::Auto {
        let scenes = sweep.scenes();
        eprintln!(
            "polhode: no errors: {scenes} scenes need a reference each, more than {AFFORDABLE}; --errors always"
        );
    } else if sweep.with_errors && rows.iter().all(|row| row.error.is_none()) {
        eprintln!("polhode: no errors: no scene of the sweep has a reference that is certain enough");
    }
    if rows.iter().all(|row| row.energy.is_none()) {
        eprintln!("polhode: no energy: a torque acts, and not every law has a potential");
    }
    if let Some(path) = &options.out {
        eprintln!("polhode: the table is {}", path.display());
    }
}

fn plan(options: &Options, scene: &Scene) -> Result<Sweep, Failure> {
    let axes = options
        .vary
        .iter()
        .map(|text| Axis::parse(text).map_err(|why| Failure::Usage(format!("--vary {text}: {why}"))))
        .collect::<Result<Vec<Axis>, Failure>>()?;
    let text = SceneText::open(&text_of(options.scene.name())?)
        .ok_or_else(|| Failure::Usage(format!("{}: not TOML", options.scene.name())))?;
    for (index, axis) in axes.iter().enumerate() {
        check(axis, &text)?;
        if axes[..index].iter().any(|other| other.key == axis.key) {
            return Err(Failure::Usage(format!("--vary: {} stands there twice", axis.key)));
        }
    }
    let step = options.step.unwrap_or_else(|| campaign::typical_step(scene));
    if !(step > 0.0 && step.is_finite()) {
        return Err(Failure::Usage(format!("--step {step}: expected a positive number of seconds")));
    }
    let mut sweep = Sweep {
        file: scene.file.clone(),
        text,
        axes,
        step,
        quantity: select::quantity(&options.quantity)?,
        with_errors: options.errors != Errors::Never,
    };
    sweep.with_errors &= options.errors == Errors::Always || sweep.scenes() <= AFFORDABLE;
    Ok(sweep)
}

/// Refuses a key that there is not, and names those that there are.
fn check(axis: &Axis, text: &SceneText) -> Result<(), Failure> {
    if axis.key == STEP || text.has(&axis.key) {
        return Ok(());
    }
    let mut known = text.keys();
    known.insert(0, STEP.to_owned());
    let meant = select::meant(&axis.key, known.iter().map(String::as_str));
    Err(Failure::Usage(format!("--vary: no key '{}'{meant}; keys: {}", axis.key, known.join(", "))))
}

/// The text of a scene file.
fn text_of(name: &str) -> Result<String, Failure> {
    if let Some((_, text)) = FILES.iter().find(|(known, _)| *known == name) {
        return Ok((*text).to_owned());
    }
    std::fs::read_to_string(name).map_err(|source| Failure::Write { name: name.to_owned(), source })
}

/// The number of a row that is drawn.
fn shown(options: &Options, sweep: &Sweep, row: &Row) -> Option<f64> {
    if options.show == Shown::Error && sweep.with_errors { row.error } else { row.energy.map(f64::abs) }
}

/// What a picture is drawn from.
struct Drawn<'a> {
    options: &'a Options,
    scene: &'a Scene,
    sweep: &'a Sweep,
    names: Vec<&'a str>,
    rows: &'a [Row],
}

impl Drawn<'_> {
    /// The numbers of a scheme that are drawn, in the order of the grid.
    fn values(&self, scheme: &str) -> Vec<Option<f64>> {
        let own = self.rows.iter().filter(|row| row.scheme == scheme);
        own.map(|row| shown(self.options, self.sweep, row)).collect()
    }

    /// What the numbers are.
    fn words(&self) -> String {
        if self.options.show == Shown::Error && self.sweep.with_errors {
            let quantity = self.sweep.quantity;
            format!("error of the {} at the end [{}]", quantity.name().replace('-', " "), quantity.unit())
        } else {
            "change of the energy, relative".to_owned()
        }
    }

    fn lines(&self, axis: &Axis) -> LineChart {
        let line = |scheme: &&str| Line {
            words: (*scheme).to_owned(),
            points: axis.values.iter().copied().zip(self.values(scheme)).collect(),
        };
        LineChart {
            title: self.scene.title.clone(),
            subtitle: subtitle(self.scene, self.sweep),
            description: format!("{}: {}", self.scene.title, self.words()),
            panels: vec![LinePanel {
                across: axis_title(axis),
                across_logarithmic: axis.logarithmic,
                up: self.words(),
                lines: self.names.iter().map(line).collect(),
            }],
        }
    }

    fn map(&self, up: &Axis, across: &Axis) -> HeatMap {
        let map = |scheme: &&str| Map {
            title: if self.names.len() > 1 { (*scheme).to_owned() } else { String::new() },
            across: range(across),
            up: range(up),
            columns: across.values.len(),
            cells: ordered(up, across, self.values(scheme)),
            curves: Vec::new(),
        };
        let all: Vec<f64> = self.names.iter().flat_map(|name| self.values(name)).flatten().collect();
        HeatMap {
            title: self.scene.title.clone(),
            subtitle: format!("{} · {}", self.names.join(", "), subtitle(self.scene, self.sweep)),
            description: format!("{}: {}", self.scene.title, self.words()),
            scale: Scale::Numbers { title: self.words(), logarithmic: true, range: shown_range(&all) },
            panels: self.names.iter().map(map).collect(),
        }
    }
}

fn draw(drawn: &Drawn, path: &Path, quiet: bool) -> Result<(), Failure> {
    let png = match &drawn.sweep.axes[..] {
        [axis] => drawn.lines(axis).png(),
        [up, across] => drawn.map(up, across).png(),
        axes => {
            eprintln!("polhode: no picture of {} keys: one or two can be drawn", axes.len());
            return Ok(());
        }
    };
    let png = png.map_err(|error| Failure::Usage(error.to_string()))?;
    record::write_whole(path, &png)?;
    if !quiet {
        eprintln!("polhode: the picture is {}", path.display());
    }
    Ok(())
}

/// The range of the colours: from the least number to the largest, but not where runs have left the motion for good.
fn shown_range(values: &[f64]) -> Option<(f64, f64)> {
    const LEFT_FOR_GOOD: f64 = 10.0;
    let least = values.iter().copied().filter(|value| *value > 0.0).reduce(f64::min)?.max(1e-17);
    let most = values.iter().copied().reduce(f64::max)?.min(LEFT_FOR_GOOD);
    (least < most).then_some((least, most))
}

fn subtitle(scene: &Scene, sweep: &Sweep) -> String {
    let step = format!(" · h = {} s", sweep.step);
    let varied = sweep.axes.iter().any(|axis| axis.key == STEP);
    format!("{}{}", scene.name, if varied { String::new() } else { step })
}

fn axis_title(axis: &Axis) -> String {
    if axis.key == STEP { "step h [s]".to_owned() } else { axis.key.clone() }
}

fn range(axis: &Axis) -> Range {
    let (first, last) = (axis.values[0], axis.values[axis.values.len() - 1]);
    Range::centred(&axis_title(axis), first.min(last), first.max(last), axis.values.len(), axis.logarithmic)
}

/// Cells with both axes rising.
fn ordered(up: &Axis, across: &Axis, cells: Vec<Option<f64>>) -> Vec<Option<f64>> {
    let falls = |axis: &Axis| axis.values[0] > axis.values[axis.values.len() - 1];
    let (rows, columns) = (up.values.len(), across.values.len());
    let turned = |index: usize, count: usize, falls: bool| if falls { count - 1 - index } else { index };
    let place = |row: usize, column: usize| {
        turned(row, rows, falls(up)) * columns + turned(column, columns, falls(across))
    };
    (0..rows * columns).map(|index| cells[place(index / columns, index % columns)]).collect()
}
