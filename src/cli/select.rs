//! From names on the command line to scenes and schemes.

use clap::Args;

use super::Failure;
use crate::adaptive;
use crate::engine::{self, Engine};
use crate::scenes::{self, Scene};
use crate::simulate::Contestant;

/// Which schemes and scenes.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct Selection {
    /// Scheme to measure, or `all`; may be given several times [default: the main ones]
    #[arg(long = "scheme", value_name = "S")]
    schemes: Vec<String>,
    /// Scene to measure in: a built-in name or a TOML file; may be given several times [default: all built-in]
    #[arg(long = "scene", value_name = "X")]
    scenes: Vec<String>,
}

impl Selection {
    /// Scenes of these names, and the main schemes.
    pub(super) fn of_scenes(scenes: Vec<String>) -> Selection {
        Selection { schemes: Vec::new(), scenes }
    }

    /// Whether nothing was named.
    pub(super) fn is_default(&self) -> bool {
        self.schemes.is_empty() && self.scenes.is_empty()
    }

    /// The schemes that were named, all where `full`, or the main ones.
    pub(super) fn contestants(&self, full: bool) -> Result<Vec<Contestant>, Failure> {
        if self.schemes.is_empty() && !full {
            return Ok(Contestant::main());
        }
        if full || self.schemes.iter().any(|name| name == "all") {
            return Ok(everyone());
        }
        self.schemes.iter().map(|name| contestant(name)).collect()
    }

    pub(super) fn scenes(&self) -> Result<Vec<Scene>, Failure> {
        if self.scenes.is_empty() {
            return Ok(scenes::built_in());
        }
        Ok(self.scenes.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>()?)
    }
}

/// The schemes of the list, and the solvers that choose their own steps.
pub(super) fn everyone() -> Vec<Contestant> {
    Contestant::all().into_iter().chain(adaptive::contestants()).collect()
}

/// The scheme of a name.
pub(super) fn contestant(name: &str) -> Result<Contestant, Failure> {
    let all = everyone();
    let names: Vec<&str> = all.iter().map(|contestant| contestant.card.name).collect();
    let known = names.join(", ");
    if let Some(command) = name.strip_prefix(engine::PREFIX) {
        return Ok(Engine::open(command)?.contestant(name));
    }
    match all.iter().find(|contestant| contestant.card.name == name) {
        Some(contestant) => Ok(contestant.clone()),
        None if name.contains([' ', '/']) || name == "engine" => Err(Failure::Usage(format!(
            "no scheme '{name}'; a program of your own is --scheme 'engine:python3 my_engine.py'"
        ))),
        None => Err(Failure::Usage(format!("no scheme '{name}'; schemes: {known}"))),
    }
}
