//! `polhode scene`: scene files to read and to begin with.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use super::Failure;
use super::output::{Force, print};
use super::select::OneScene;
use crate::record::WholeFile;
use crate::scenes::{self, Scene};

/// Options of `polhode scene`.
#[derive(Args, Clone, Debug)]
pub(super) struct Options {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// Print the file of a scene, and on stderr what follows from it
    Show {
        #[command(flatten)]
        scene: OneScene,
    },
    /// Write a commented scene file, and beside it the JSON Schema for editors
    #[command(after_help = EXAMPLES)]
    New {
        /// Name of the scene, or the path of its file
        name: String,
        /// Built-in scene to begin with
        #[arg(long, value_name = "SCENE")]
        from: Option<String>,
        #[command(flatten)]
        force: Force,
    },
}

const EXAMPLES: &str = "\
Examples:
  polhode scene new my-body                         my-body.toml
  polhode scene new tests/top.toml --from kovalevskaya";

/// The name of the schema beside a scene.
const SCHEMA: &str = "scene.schema.json";

pub(super) fn scene(options: &Options, quiet: bool) -> Result<u8, Failure> {
    match &options.what {
        What::Show { scene } => show(scene.name(), quiet),
        What::New { name, from, force } => new(name, from.as_deref(), *force, quiet),
    }
}

fn show(name: &str, quiet: bool) -> Result<u8, Failure> {
    let scene = Scene::find(name)?;
    print(&scene.text)?;
    if !quiet {
        eprint!("{}", facts(&scene));
    }
    Ok(0)
}

/// What follows from a scene.
fn facts(scene: &Scene) -> String {
    let system = &scene.system;
    let start = &system.start;
    let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let spin = (system.body.inverse_inertia() * momentum).norm();
    let [a, b, c] = system.body.moments.into();
    let laws: Vec<&str> = system.forces.laws().iter().map(|law| law.name()).collect();
    let laws = if laws.is_empty() { "none".to_owned() } else { laws.join(", ") };
    format!(
        "# model {}; laws: {laws}\n# mass {} kg; principal moments {a}, {b}, {c} kg m²; {} mass points\n\
         # |Ω| = {spin} rad/s and |L| = {} kg m²/s at the start; {} rad in {} s at this rate\n",
        system.least().name(),
        system.body.mass,
        system.body.points.len(),
        start.angular_momentum.norm(),
        spin * scene.duration,
        scene.duration,
    )
}

fn new(name: &str, from: Option<&str>, force: Force, quiet: bool) -> Result<u8, Failure> {
    let path =
        if name.ends_with(".toml") { PathBuf::from(name) } else { PathBuf::from(format!("{name}.toml")) };
    let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    let text = scenes::begun(stem, from)?;
    let schema = path.parent().unwrap_or(Path::new("")).join(SCHEMA);
    force.try_place(Some(&path), |_| false)?;
    let is_schema = |head: &str| head.contains(scenes::SCHEMA_TITLE);
    force.try_place(Some(&schema), is_schema)?;
    write(&schema, &format!("{:#}\n", scenes::schema()))?;
    write(&path, &format!("#:schema ./{SCHEMA}\n{text}"))?;
    if !quiet {
        let shown = path.display();
        eprintln!("polhode: wrote {shown} and {SCHEMA} beside it; try `polhode run {shown} --format csv`");
    }
    Ok(0)
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let mut file = WholeFile::begin(path)?;
    let written = file.write_all(text.as_bytes());
    written.map_err(|source| Failure::Write { name: path.display().to_string(), source })?;
    Ok(file.finish()?)
}
