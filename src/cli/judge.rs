//! `polhode judge`: a trajectory that another program wrote.

mod json;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Args, ValueEnum};
use comfy_table::{ContentArrangement, Table, presets};

use super::Failure;
use super::exit::UNDECIDED;
use super::output::{Force, Format, print};
use super::progress::with_word;
use crate::log::{
    self, AngleUnit, Columns, Deviation, FileError, Judgement, Request, Said, Sequence, Series, TimeUnit,
    Verdict,
};
use crate::model::Quantity;
use crate::record::{self, Records, Ruling, SCHEMA};
use crate::report::line_chart::{Line, LineChart, LinePanel};
use crate::scenes::Scene;

/// Options of `polhode judge`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// Table with a header, as t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz; columns may be missing
    #[arg(value_name = "LOG", required = true)]
    logs: Vec<PathBuf>,
    /// Scene that it is a run of: a built-in name or a TOML file
    #[arg(long, value_name = "X")]
    scene: String,
    /// Which column is what, as t=stamp,qw=q_w or t,x,y,z,-,qw
    #[arg(long, value_name = "LIST")]
    columns: Option<Columns>,
    /// Unit of times [default: what the header says, else s]
    #[arg(long, value_name = "U", value_parser = time_unit)]
    time_unit: Option<TimeUnit>,
    /// Unit of angles where the header says none: rad or deg
    #[arg(long, hide_short_help = true, value_name = "U", value_parser = angle_unit)]
    angle_unit: Option<AngleUnit>,
    /// Euler angles: ZYX about moving axes, zyx about fixed ones
    #[arg(long, hide_short_help = true, value_name = "AXES")]
    euler: Option<Sequence>,
    /// Axes of wx, wy, wz: world or body [default: as named, else world]
    #[arg(long, value_enum, hide_possible_values = true, value_name = "AXES")]
    angular_velocity: Option<Axes>,
    /// body-to-world (default) or world-to-body
    #[arg(long, value_enum, hide_possible_values = true, value_name = "SENSE")]
    quaternion: Option<Sense>,
    /// Read the log by the convention that the frame check finds
    #[arg(long)]
    as_found: bool,
    /// Start the reference at a row of the log
    #[arg(long, value_name = "ROW", num_args = 0..=1, default_missing_value = "1", require_equals = true)]
    from_log: Option<usize>,
    /// Largest error of --quantity over the run that passes
    #[arg(long, value_name = "E", value_parser = above_zero)]
    tolerance: Option<f64>,
    /// Quantity that --tolerance is about
    #[arg(long, value_name = "Q", default_value = "body-point", requires = "tolerance", value_parser = quantity)]
    quantity: Quantity,
    /// Write the errors of every row as CSV (one log)
    #[arg(long, value_name = "FILE.csv")]
    errors: Option<PathBuf>,
    /// Draw the errors against time (one log)
    #[arg(long, value_name = "FILE.png")]
    plot: Option<PathBuf>,
    /// Write the records
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Form of the findings
    #[arg(long, value_enum, default_value_t, hide_possible_values = true, value_name = "text|json")]
    format: Format,
    #[command(flatten)]
    force: Force,
}

/// Points of a line in a picture.
const DRAWN: usize = 150;

const EXAMPLES: &str = "\
Examples:
  polhode judge log.csv --scene dzhanibekov
  polhode judge log.csv --scene my-body.toml --angular-velocity body --quaternion world-to-body
  polhode judge log.txt --scene my-body.toml --columns t=stamp,qw=q_w,qx=q_x,qy=q_y,qz=q_z --time-unit ms
  polhode judge log.csv --scene dzhanibekov --tolerance 1e-3 --quantity orientation
  polhode judge log.csv --scene dzhanibekov --errors errors.csv --plot errors.png
  polhode judge first.csv second.csv third.csv --scene dzhanibekov

Exit code: 0 the log was judged; with --tolerance 0 only where the largest error is within it, 1 where it is
not, and 2 where that cannot be decided: columns are missing, the last row has no such quantity, there is no
reference, or the frame check says that the log follows another convention than it was read by. 65 the file is
no trajectory, 74 it cannot be read.";

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Axes {
    World,
    Body,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Sense {
    BodyToWorld,
    WorldToBody,
}

fn time_unit(text: &str) -> Result<TimeUnit, String> {
    word(text, &TimeUnit::ALL, TimeUnit::word)
}

fn angle_unit(text: &str) -> Result<AngleUnit, String> {
    word(text, &AngleUnit::ALL, AngleUnit::word)
}

fn word<T: Copy>(text: &str, all: &[T], word: fn(T) -> &'static str) -> Result<T, String> {
    let words: Vec<&str> = all.iter().map(|value| word(*value)).collect();
    let found = all.iter().copied().find(|value| word(*value) == text);
    found.ok_or(format!("expected one of {}", words.join(", ")))
}

fn above_zero(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value > 0.0 => Ok(value),
        _ => Err("expected a number above 0".to_owned()),
    }
}

fn quantity(text: &str) -> Result<Quantity, String> {
    let names = Quantity::ALL.map(Quantity::name).join(", ");
    Quantity::ALL.into_iter().find(|q| q.name() == text).ok_or(format!("expected one of {names}"))
}

pub(super) fn judge(options: &Options, quiet: bool) -> Result<u8, Failure> {
    options.force.try_json(options.json.as_ref())?;
    options.force.try_place(options.errors.as_ref(), |head| head.starts_with(Series::header().trim_end()))?;
    options.force.try_picture(options.plot.as_ref())?;
    if options.logs.len() > 1 && (options.errors.is_some() || options.plot.is_some()) {
        return Err(Failure::Usage("--errors and --plot take one log".to_owned()));
    }
    let scene = Scene::find(&options.scene)?;
    let judge = |path: &PathBuf| Ok((name_of(path), log::judge(path, &scene, &request(options))?));
    let judged: Vec<(String, Judgement)> =
        with_word(quiet, "judging", || options.logs.iter().map(judge).collect::<Result<_, FileError>>())?;
    if let Some(path) = &options.json {
        record::write_json(path, &records(&judged, &scene))?;
    }
    for (name, judgement) in &judged {
        write_series(options, name, judgement)?;
    }
    let against = |limit| judged.iter().map(|(_, one)| one.against(options.quantity, limit)).collect();
    let verdicts: Vec<Verdict> = options.tolerance.map_or_else(Vec::new, against);
    print(&match options.format {
        Format::Text => text(&judged, &verdicts, &scene),
        Format::Json => json::findings(&judged, &verdicts, &scene),
    })?;
    Ok(verdicts.iter().fold(0, |code, verdict| match (code, verdict.ruling) {
        (1, _) | (_, Ruling::Fail) => 1,
        (code, Ruling::Pass) => code,
        _ => UNDECIDED,
    }))
}

/// Each log, what separates them, and the verdicts at the end.
fn text(judged: &[(String, Judgement)], verdicts: &[Verdict], scene: &Scene) -> String {
    let mut text: String = judged.iter().map(|(name, judgement)| in_words(judgement, scene, name)).collect();
    if judged.len() > 1 {
        text += &deviations(judged, scene);
    }
    for (verdict, (name, _)) in verdicts.iter().zip(judged) {
        let of = if judged.len() > 1 { format!(" in {name}") } else { String::new() };
        text += &format!("{}{of}\n", verdict.in_words());
    }
    text
}

fn name_of(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

fn records(judged: &[(String, Judgement)], scene: &Scene) -> Records {
    let rows = |(name, judgement): &(String, Judgement)| judgement.measurements(scene, name);
    Records {
        schema: SCHEMA.to_owned(),
        polhode: env!("CARGO_PKG_VERSION").to_owned(),
        complete: true,
        measurements: judged.iter().flat_map(rows).map(Arc::new).collect(),
        verdicts: judged.iter().map(|(name, judgement)| judgement.frame_verdict(scene, name)).collect(),
        ..Records::default()
    }
}

/// The errors against time, as a table and as a picture.
fn write_series(options: &Options, name: &str, judgement: &Judgement) -> Result<(), Failure> {
    if let Some(path) = &options.errors {
        record::write_whole(path, judgement.series.csv().as_bytes())?;
    }
    let Some(path) = &options.plot else { return Ok(()) };
    let line = |quantity: Quantity| {
        let points = judgement.series.largest(quantity, DRAWN);
        let points: Vec<_> = points.into_iter().filter(|(_, error)| *error > 0.0).collect();
        let points = points.into_iter().map(|(time, error)| (time, Some(error))).collect::<Vec<_>>();
        let words = format!("{} [{}]", quantity.name().replace('-', " "), quantity.unit());
        (!points.is_empty()).then_some(Line { words, points })
    };
    let lines: Vec<Line> = Quantity::ALL.into_iter().filter_map(line).collect();
    let panel = LinePanel {
        across: "t [s]".to_owned(),
        across_logarithmic: false,
        up: "error, each in its unit".to_owned(),
        lines,
    };
    let chart = LineChart {
        title: format!("Errors of {name}"),
        subtitle: format!("against the reference; the largest in each of {DRAWN} parts of the run"),
        description: format!("errors of {name} against time"),
        panels: vec![panel],
    };
    let png = chart.png().map_err(|error| Failure::Usage(error.to_string()))?;
    Ok(record::write_whole(path, &png)?)
}

/// Pairwise deviations of several logs: the largest, what grows along a line, and what stays bounded.
fn deviations(judged: &[(String, Judgement)], scene: &Scene) -> String {
    let mut table = new_table();
    table.set_header([
        "log",
        "other log",
        "quantity",
        "unit",
        "largest",
        "secular",
        "bounded",
        "common times",
    ]);
    for Pair { log, other, quantity, apart } in pairs(judged, scene) {
        let numbers = [apart.largest, apart.secular, apart.bounded].map(|number| format!("{number:.4e}"));
        let head = [log, other, quantity.name(), quantity.unit()].map(str::to_owned);
        table.add_row(head.into_iter().chain(numbers).chain([apart.times.to_string()]));
    }
    format!("pairwise deviations at common times\n{table}\n")
}

/// What separates two logs in a quantity.
struct Pair<'a> {
    log: &'a str,
    other: &'a str,
    quantity: Quantity,
    apart: Deviation,
}

/// Every pair of logs in every quantity that both have at common times.
fn pairs<'a>(judged: &'a [(String, Judgement)], scene: &Scene) -> Vec<Pair<'a>> {
    let mut pairs = Vec::new();
    for (index, (log, judgement)) in judged.iter().enumerate() {
        for (other, others) in &judged[index + 1..] {
            let of = |quantity| {
                let apart = judgement.series.deviation(&others.series, &scene.system, quantity)?;
                Some(Pair { log, other, quantity, apart })
            };
            pairs.extend(Quantity::ALL.into_iter().filter_map(of));
        }
    }
    pairs
}

fn request(options: &Options) -> Request {
    Request {
        said: Said {
            columns: options.columns.clone(),
            time_unit: options.time_unit,
            angle_unit: options.angle_unit,
            sequence: options.euler,
        },
        spin_in_body_axes: options.angular_velocity.map(|axes| axes == Axes::Body),
        world_to_body: options.quaternion.map(|sense| sense == Sense::WorldToBody),
        as_found: options.as_found,
        series: options.errors.is_some() || options.plot.is_some() || options.logs.len() > 1,
        from_log: options.from_log,
    }
}

fn new_table() -> Table {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(120);
    }
    table
}

fn in_words(judgement: &Judgement, scene: &Scene, name: &str) -> String {
    let mut table = new_table();
    table.set_header(["quantity", "unit", "at the end", "largest", "uncertainty"]);
    for finding in &judgement.findings {
        let cells = match &finding.value {
            Ok(v) => {
                let end = v.end.map_or("not in the last row".to_owned(), |end| format!("{end:.4e}"));
                [end, format!("{:.4e}", v.max), format!("{:.4e}", v.uncertainty)]
            }
            Err(why) => [format!("not applicable: {why}"), String::new(), String::new()],
        };
        table.add_row([finding.name.to_owned(), finding.unit.to_owned()].into_iter().chain(cells));
    }
    let reference = match &judgement.reference {
        Ok(told) => format!("reference: {told}"),
        Err(why) => format!("no reference: {why}"),
    };
    let (from, to) = judgement.span;
    let mut text = format!(
        "{name} as a run of {}: {} rows, t = {from} … {to} s, {} s apart\n{}\n{reference}\n{}\n\n{table}\n",
        scene.name,
        judgement.rows,
        judgement.spacing,
        judgement.reading,
        judgement.frames_in_words(),
    );
    for explanation in &judgement.explanations {
        let word = if explanation.is_remark() { "remark" } else { "hint" };
        let (words, left, before) = (&explanation.words, explanation.left, explanation.before);
        text += &format!("{word}: {words} (it leaves {left:.1e} of {before:.1e}, relative)\n");
    }
    judgement.notes.iter().for_each(|line| text += &format!("note: {line}\n"));
    text
}
