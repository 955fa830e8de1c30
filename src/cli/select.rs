//! From names on the command line to scenes, schemes and quantities.

use std::path::{Path, PathBuf};

use clap::Args;

use super::Failure;
use super::config::Config;
use crate::engine::{self, Engine};
use crate::model::Quantity;
use crate::record::SceneText;
use crate::scenes::{self, Scene};
use crate::schemes::Card;
use crate::simulate::Contestant;

/// Which schemes and scenes.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct Selection {
    /// Scheme to measure, `all`, or substepped-N-S for S in N parts a step; may be given several times [default: the main
    /// ones]
    #[arg(long = "scheme", value_name = "S")]
    schemes: Vec<String>,
    #[command(flatten)]
    scenes: Scenes,
}

/// Scenes, by position or by `--scene`.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct Scenes {
    /// Scenes: built-in names or TOML files [default: all built-in]
    #[arg(value_name = "SCENE")]
    places: Vec<String>,
    /// The same; may be given several times
    #[arg(long = "scene", value_name = "X")]
    named: Vec<String>,
}

impl Scenes {
    /// The names, those by position first; those of the settings where none is given.
    pub(super) fn names(&self) -> Vec<String> {
        match self.places.is_empty() && self.named.is_empty() {
            true => Config::current().scenes.clone(),
            false => self.places.iter().chain(&self.named).cloned().collect(),
        }
    }

    /// The scenes; every built-in one where none is named.
    pub(super) fn open(&self) -> Result<Vec<Scene>, Failure> {
        let names = self.names();
        if names.is_empty() {
            return Ok(scenes::built_in());
        }
        let scenes: Vec<Scene> = names.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>()?;
        for (index, scene) in scenes.iter().enumerate() {
            // Rows of records are found by the name of the scene.
            if let Some(other) = scenes[..index].iter().position(|other| other.name == scene.name) {
                let (first, second) = (&names[other], &names[index]);
                return Err(Failure::Model(format!(
                    "two scenes are called '{}': {first} and {second}",
                    scene.name
                )));
            }
        }
        Ok(scenes)
    }
}

/// One scene, by position or by `--scene`.
#[derive(Args, Clone, Debug)]
#[group(required = true, multiple = false)]
pub(super) struct OneScene {
    /// Built-in name or TOML file
    #[arg(value_name = "SCENE")]
    place: Option<String>,
    /// The same
    #[arg(long = "scene", value_name = "X")]
    named: Option<String>,
}

impl OneScene {
    /// The name or path.
    pub(super) fn name(&self) -> &str {
        self.place.as_deref().or(self.named.as_deref()).unwrap_or_default()
    }
}

impl Selection {
    /// The names of the schemes; those of the settings where none is given.
    fn schemes(&self) -> &[String] {
        if self.schemes.is_empty() { &Config::current().schemes } else { &self.schemes }
    }

    /// Whether nothing was named.
    pub(super) fn is_default(&self) -> bool {
        self.schemes().is_empty() && self.scenes.names().is_empty()
    }

    /// The folder of a report where none is named: `whole` for the default scenes and schemes, else by what was named.
    pub(super) fn folder(&self, whole: &str) -> PathBuf {
        Path::new("reports").join(if self.is_default() { whole.to_owned() } else { self.subject() })
    }

    /// What was named, as the name of a folder.
    fn subject(&self) -> String {
        let names: Vec<String> =
            self.scenes.names().into_iter().chain(self.schemes().iter().cloned()).collect();
        let whole = names.join("_");
        let safe =
            |letter: char| if letter.is_ascii_alphanumeric() || "-_".contains(letter) { letter } else { '-' };
        let mut subject: String = whole.trim_end_matches(".toml").chars().map(safe).collect();
        let taken = ["latest", "full", "brief", "published", "engines"].contains(&subject.as_str());
        if taken || subject.len() > MOST_OF_A_SUBJECT {
            // A folder by number: two long lists that begin alike are two subjects.
            let number =
                whole.bytes().fold(0u32, |number, byte| number.wrapping_mul(31).wrapping_add(byte.into()));
            subject.truncate(MOST_OF_A_SUBJECT);
            subject += &format!("-{number:08x}");
        }
        subject.trim_start_matches('-').to_owned()
    }

    /// Whether schemes were named.
    pub(super) fn names_schemes(&self) -> bool {
        !self.schemes().is_empty()
    }

    /// The schemes that were named, all where `full`, or the main ones.
    pub(super) fn contestants(&self, full: bool) -> Result<Vec<Contestant>, Failure> {
        if self.schemes().is_empty() && !full {
            return Ok(Contestant::main());
        }
        if full || self.schemes().iter().any(|name| name == "all") {
            return Ok(Contestant::everyone());
        }
        self.schemes().iter().map(|name| contestant(name)).collect()
    }

    pub(super) fn scenes(&self) -> Result<Vec<Scene>, Failure> {
        self.scenes.open()
    }

    /// The texts of the scenes.
    pub(super) fn texts(&self) -> Result<Vec<SceneText>, Failure> {
        let names = self.scenes.names();
        let all = || scenes::FILES.iter().map(|(name, _)| (*name).to_owned()).collect();
        let names: Vec<String> = if names.is_empty() { all() } else { names };
        let text = |name: String| Ok(SceneText { toml: Scene::text(&name)?, name });
        names.into_iter().map(text).collect()
    }
}

/// The schemes of these names; everyone where none is named, or `all`.
pub(super) fn named(names: &[String]) -> Result<Vec<Contestant>, Failure> {
    if names.is_empty() || names.iter().any(|name| name == "all") {
        return Ok(Contestant::everyone());
    }
    names.iter().map(|name| contestant(name)).collect()
}

/// The quantity of a name.
pub(super) fn quantity(name: &str) -> Result<Quantity, Failure> {
    let names = Quantity::ALL.map(Quantity::name);
    Quantity::ALL.into_iter().find(|quantity| quantity.name() == name).ok_or_else(|| {
        let meant = meant(name, names.into_iter());
        Failure::Usage(format!("no quantity '{name}'{meant}; quantities: {}", names.join(", ")))
    })
}

/// ", did you mean …?" with the three nearest of the known names.
pub(super) fn meant<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    match scenes::one_of(&scenes::three_nearest(name, known)) {
        near if near.is_empty() => String::new(),
        near => format!(", did you mean {near}?"),
    }
}

/// Letters of a folder's name that say what it is about.
const MOST_OF_A_SUBJECT: usize = 80;

/// Most parts of a step that a name may ask for.
const MOST_PARTS: u32 = 64;

/// What `substepped-N-S` means, for help and lists.
pub(super) const SUBSTEPS: &str =
    "substepped-N-S is any scheme S in N equal parts of every step, N from 2 to 64: substepped-4-peskin-rk2";

/// The scheme of a name.
pub(super) fn contestant(name: &str) -> Result<Contestant, Failure> {
    let all = Contestant::everyone();
    let listed = all.iter().any(|contestant| contestant.card.name == name);
    if let Some((parts, base)) = Card::parts(name)
        && !listed
    {
        return substepped(name, parts, base);
    }
    let names: Vec<&str> = all.iter().map(|contestant| contestant.card.name).collect();
    let of_settings = Config::current().engines.get(name).map(String::as_str);
    if let Some(command) = name.strip_prefix(engine::PREFIX).or(of_settings.filter(|_| !listed)) {
        return Ok(Engine::open(command)?.contestant(name));
    }
    match all.iter().find(|contestant| contestant.card.name == name) {
        Some(contestant) => Ok(contestant.clone()),
        None if name.contains([' ', '/']) || name == "engine" => Err(Failure::Usage(format!(
            "no scheme '{name}'; a program of your own is --scheme 'engine:python3 my_engine.py'"
        ))),
        None => {
            let meant = meant(name, names.into_iter());
            Err(Failure::Usage(format!(
                "no scheme '{name}'{meant} `polhode list schemes` shows all; {SUBSTEPS}"
            )))
        }
    }
}

fn substepped(name: &str, parts: u32, base: &str) -> Result<Contestant, Failure> {
    if !(2..=MOST_PARTS).contains(&parts) {
        return Err(Failure::Usage(format!("'{name}': {parts} parts of a step, expected 2 to {MOST_PARTS}")));
    }
    let chosen_by_itself =
        || Failure::Usage(format!("'{name}': {base} chooses its own steps, which have no parts"));
    contestant(base)?.substepped(parts).ok_or_else(chosen_by_itself)
}
