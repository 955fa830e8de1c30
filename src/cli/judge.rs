//! `polhode judge`: a trajectory that another program wrote.

use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args, ValueEnum};
use comfy_table::{ContentArrangement, Table, presets};

use super::Failure;
use super::output::{Force, print};
use crate::log::{self, Convention, Judgement};
use crate::model::Quantity;
use crate::record::{self, Records, SCHEMA};
use crate::scenes::Scene;

/// Options of `polhode judge`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// CSV with a header t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz; columns may be missing, more are ignored
    #[arg(value_name = "LOG.csv")]
    log: PathBuf,
    /// Scene that it is a run of: a built-in name or a TOML file
    #[arg(long, value_name = "X")]
    scene: String,
    /// Axes of wx, wy, wz
    #[arg(long, value_enum, value_name = "AXES", default_value_t = Axes::World)]
    angular_velocity: Axes,
    /// What the quaternion takes to what
    #[arg(long, value_enum, value_name = "SENSE", default_value_t = Sense::BodyToWorld)]
    quaternion: Sense,
    /// Largest error of --quantity over the run that passes
    #[arg(long, value_name = "E", value_parser = above_zero)]
    tolerance: Option<f64>,
    /// Quantity that --tolerance is about, in its SI unit
    #[arg(long, value_name = "Q", default_value = "body-point", requires = "tolerance", value_parser = quantity)]
    quantity: Quantity,
    /// Write the records
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
}

const EXAMPLES: &str = "\
Examples:
  polhode judge log.csv --scene dzhanibekov
  polhode judge log.csv --scene my-body.toml --angular-velocity body --quaternion world-to-body
  polhode judge log.csv --scene dzhanibekov --tolerance 1e-3 --quantity orientation

Exit code: 0 the log was judged; with --tolerance 0 only where the largest error is within it, 1 where it is
not, and 2 where that cannot be told: columns are missing, there is no reference, or the frame check says that
the log follows another convention than the options. 65 the file is no trajectory, 74 it cannot be read.";

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

pub(super) fn judge(options: &Options) -> Result<u8, Failure> {
    options.force.try_json(options.json.as_ref())?;
    let scene = Scene::find(&options.scene)?;
    let declared = Convention {
        spin_in_body_axes: options.angular_velocity == Axes::Body,
        world_to_body: options.quaternion == Sense::WorldToBody,
    };
    let judgement = log::judge(&options.log, &scene, declared)?;
    let name = options.log.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    if let Some(path) = &options.json {
        let records = Records {
            schema: SCHEMA.to_owned(),
            polhode: env!("CARGO_PKG_VERSION").to_owned(),
            complete: true,
            measurements: judgement.measurements(&scene, &name).into_iter().map(Arc::new).collect(),
            verdicts: vec![judgement.verdict(&scene, &name)],
            ..Records::default()
        };
        record::write_json(path, &records)?;
    }
    print(&in_words(&judgement, &scene, &name))?;
    Ok(options.tolerance.map_or(0, |tolerance| ruling(&judgement, options.quantity, tolerance)))
}

/// 0 within the tolerance, 1 outside, 2 where it cannot be told.
fn ruling(judgement: &Judgement, quantity: Quantity, tolerance: f64) -> u8 {
    let finding = judgement.findings.iter().find(|finding| finding.name == quantity.name());
    match finding.map(|finding| &finding.value) {
        Some(Ok(_)) if judgement.contradicted().is_some() => 2,
        Some(Ok(value)) if value.max <= tolerance => 0,
        Some(Ok(value)) if value.max > tolerance => 1,
        _ => 2,
    }
}

fn in_words(judgement: &Judgement, scene: &Scene, name: &str) -> String {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(120);
    }
    table.set_header(["quantity", "unit", "at the end", "largest", "uncertainty"]);
    for finding in &judgement.findings {
        let cells = match &finding.value {
            Ok(v) => [v.end, v.max, v.uncertainty].map(|number| format!("{number:.4e}")),
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
        "{name} as a run of {}: {} rows, t = {from} … {to} s, {} s apart\n{reference}\n{}\n\n{table}\n",
        scene.name,
        judgement.rows,
        judgement.spacing,
        judgement.frames_in_words(),
    );
    for (word, lines) in [("hint", &judgement.hints), ("note", &judgement.notes)] {
        lines.iter().for_each(|line| text += &format!("{word}: {line}\n"));
    }
    text
}
