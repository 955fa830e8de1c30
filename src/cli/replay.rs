//! `polhode replay`: a capsule run again, every row compared to the bit.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::Failure;
use super::output::{Format, print};
use super::progress::with_tasks;
use super::select;
use crate::campaign::Survey;
use crate::record::{Capsule, Difference, SceneText};
use crate::scenes::{self, Scene, SceneError};

/// Rows that are printed where many differ.
const SHOWN: usize = 20;

/// Options of `polhode replay`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// A file that `polhode report --capsule` wrote
    capsule: PathBuf,
    /// Form of the rows that differ
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLES: &str = "\
Examples:
  polhode report kovalevskaya --capsule kovalevskaya.capsule.json
  polhode replay kovalevskaya.capsule.json

Times of the machine are not compared.

Exit code: 0 every row is equal to the bit, 1 one differs, 65 the file is no capsule or was changed.";

pub(super) fn replay(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let capsule = Capsule::read(&options.capsule)?;
    let scenes = capsule.scenes.iter().map(scene).collect::<Result<Vec<Scene>, _>>()?;
    let request = &capsule.request;
    let contestants =
        request.schemes.iter().map(|name| select::contestant(name)).collect::<Result<_, _>>()?;
    let survey = Survey {
        every_scheme: request.every_scheme,
        published: request.published,
        precision: request.precision,
        growth: request.growth,
        timed: false,
        ..Survey::of(scenes, contestants)
    };
    let now = with_tasks(quiet, |progress| Survey { progress, ..survey }.run());
    let differences = capsule.differences(&now);
    print(&match options.format {
        Format::Text => in_words(&capsule, &now.polhode, &differences),
        Format::Json => in_json(&capsule, &now.polhode, &differences),
    })?;
    Ok(u8::from(!differences.is_empty()))
}

fn in_words(capsule: &Capsule, version: &str, differences: &[Difference]) -> String {
    if differences.is_empty() {
        return format!("equal to the bit: {} rows\n", capsule.rows());
    }
    let mut text = String::new();
    if capsule.polhode != version {
        text += &format!("the capsule is of version {}, this is {version}\n", capsule.polhode);
    }
    differences.iter().take(SHOWN).for_each(|one| text += &line(one));
    match differences.len().saturating_sub(SHOWN) {
        0 => {}
        count => text += &format!("and {count} more\n"),
    }
    text + &format!("{} of {} rows differ\n", differences.len(), capsule.rows())
}

/// As JSON, schema polhode/replay/1, with every row that differs as it was and as it is.
fn in_json(capsule: &Capsule, version: &str, differences: &[Difference]) -> String {
    let difference = |one: &Difference| json!({ "section": one.section, "row": one.row, "stored": one.stored, "now": one.now });
    let answer = json!({
        "schema": "polhode/replay/1",
        "polhode_of_the_capsule": capsule.polhode,
        "polhode": version,
        "rows": capsule.rows(),
        "differences": differences.iter().map(difference).collect::<Vec<_>>(),
    });
    format!("{answer:#}\n")
}

/// The scene as it was: a built-in one has stored solutions, too.
fn scene(one: &SceneText) -> Result<Scene, SceneError> {
    let built_in = scenes::FILES.iter().any(|(name, text)| *name == one.name && *text == one.toml);
    if built_in { Scene::find(&one.name) } else { Scene::parse(&one.toml, &one.name) }
}

fn line(one: &Difference) -> String {
    let what = match (&one.stored, &one.now) {
        (Some(_), None) => "this run has no such row".to_owned(),
        (None, _) => "the capsule has no such row".to_owned(),
        _ => {
            let field = |(name, stored, now): &(String, String, String)| format!("{name}: {stored} → {now}");
            one.fields().iter().take(3).map(field).collect::<Vec<_>>().join("; ")
        }
    };
    format!("{} row {} ({}): {what}\n", one.section, one.row + 1, one.subject())
}
