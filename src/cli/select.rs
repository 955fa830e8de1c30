//! From names on the command line to scenes, schemes and quantities.

use clap::Args;

use super::Failure;
use crate::engine::{self, Engine};
use crate::model::Quantity;
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

    /// Whether schemes were named.
    pub(super) fn names_schemes(&self) -> bool {
        !self.schemes.is_empty()
    }

    /// The schemes that were named, all where `full`, or the main ones.
    pub(super) fn contestants(&self, full: bool) -> Result<Vec<Contestant>, Failure> {
        if self.schemes.is_empty() && !full {
            return Ok(Contestant::main());
        }
        if full || self.schemes.iter().any(|name| name == "all") {
            return Ok(Contestant::everyone());
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

/// ", did you mean …?" where a known name is near a mistyped one, or nothing.
pub(super) fn meant<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let near = known.map(|one| (strsim::damerau_levenshtein(name, one), one)).min();
    match near {
        Some((distance, one)) if distance <= 1 + name.len() / 3 => format!(", did you mean {one}?"),
        _ => String::new(),
    }
}

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
    let known = names.join(", ");
    if let Some(command) = name.strip_prefix(engine::PREFIX) {
        return Ok(Engine::open(command)?.contestant(name));
    }
    match all.iter().find(|contestant| contestant.card.name == name) {
        Some(contestant) => Ok(contestant.clone()),
        None if name.contains([' ', '/']) || name == "engine" => Err(Failure::Usage(format!(
            "no scheme '{name}'; a program of your own is --scheme 'engine:python3 my_engine.py'"
        ))),
        None => Err(Failure::Usage(format!("no scheme '{name}'; schemes: {known}; {SUBSTEPS}"))),
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
