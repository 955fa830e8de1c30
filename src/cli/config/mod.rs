//! `polhode.toml`: what a folder measures and allows. The command line comes first, then this file, then the defaults.

mod keys;
mod read;
mod schema;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use serde::Deserialize;

pub(super) use keys::commented;
pub(super) use schema::schema;

use super::Failure;
use crate::bounded;
use crate::fault::Fault;
use crate::gates::Tolerance;
use crate::measure::Bounds;

/// The file, where the user names no other.
pub(super) const NAME: &str = "polhode.toml";

static CURRENT: OnceLock<Config> = OnceLock::new();

/// What stands in the file; nothing without one.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Config {
    /// Schemes where the command line names none.
    pub(super) schemes: Vec<String>,
    /// Scenes where the command line names none.
    pub(super) scenes: Vec<String>,
    /// Command lines of programs under test, by name.
    pub(super) engines: BTreeMap<String, String>,
    /// Options of the gate.
    pub(super) gate: Gate,
    /// What may change against a baseline.
    pub(super) tolerances: Vec<Tolerance>,
    /// Runs of halved steps.
    pub(super) ladders: Vec<Ladder>,
}

/// Options of the gate.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Gate {
    /// Records that are compared with.
    pub(super) baseline: Option<PathBuf>,
    /// Order that every scheme is held to.
    pub(super) order: Option<u32>,
}

/// The runs of halved steps in a scene.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Ladder {
    /// Its name; every scene without it.
    pub(super) scene: Option<String>,
    coarsest: Option<u64>,
    finest: Option<u64>,
}

impl Config {
    /// The file that was read at the beginning.
    pub(super) fn current() -> &'static Config {
        CURRENT.get_or_init(Config::default)
    }

    /// Reads the file that the user named, or that of this folder where there is one.
    pub(super) fn load(named: Option<&Path>) -> Result<(), Failure> {
        let own = Path::new(NAME);
        if let Some(path) = named.or_else(|| own.exists().then_some(own)) {
            let text = bounded::text(path, bounded::MOST_OF_A_SCENE)?;
            // Set once, before any command reads it.
            let _ = CURRENT.set(Config::parse(&text, &path.display().to_string())?);
        }
        Ok(())
    }

    fn parse(text: &str, file: &str) -> Result<Config, Failure> {
        let fail = |faults| Failure::Config { file: file.to_owned(), text: text.to_owned(), faults };
        let mut faults = read::Faults::of(text);
        faults.check();
        let faults = faults.finish();
        if !faults.is_empty() {
            return Err(fail(faults));
        }
        let whole = |error: toml::de::Error| {
            fail(vec![Fault::at(text, error.span().unwrap_or(0..0), "", error.message())])
        };
        toml::from_str(text).map_err(whole)
    }

    /// The bounds of the runs in a scene.
    pub(super) fn bounds(&self, scene: &str) -> Bounds {
        let fits = |ladder: &&Ladder| ladder.scene.as_deref().is_none_or(|name| name == scene);
        let ladder = self.ladders.iter().rfind(fits);
        ladder.map_or_else(Bounds::default, |ladder| Bounds {
            coarsest: ladder.coarsest,
            finest: ladder.finest,
            afforded: None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The commented file with every comment sign of a setting removed.
    fn uncommented() -> String {
        let setting = |line: &&str| line.contains(" = ") || line.starts_with("# [");
        commented().lines().filter(setting).map(|line| format!("{}\n", &line[2..])).collect()
    }

    #[test]
    fn every_setting_of_the_commented_file_is_read_and_the_file_as_written_sets_nothing() {
        let config = Config::parse(&uncommented(), "x.toml").expect("sound");
        assert_eq!(config.schemes.len() + config.scenes.len(), 4);
        assert_eq!(config.engines["mine"], "python3 my_engine.py");
        assert_eq!((config.gate.order, config.gate.baseline.is_some()), (Some(2), true));
        let tolerance = &config.tolerances[0];
        assert_eq!((tolerance.constant, tolerance.error), (Some(0.01), Some(0.5)));
        assert!(tolerance.scene.is_some() && tolerance.quantity.is_some());
        assert_eq!(
            config.bounds("kovalevskaya"),
            Bounds { coarsest: Some(16), finest: Some(4096), afforded: None }
        );
        assert_eq!(config.bounds("free-rod"), Bounds::default());
        assert_eq!(Config::parse(&commented(), "x.toml").expect("sound"), Config::default());
    }

    #[test]
    fn every_fault_is_found_with_its_line_and_the_word_that_is_wrong() {
        let text = "shemes = [\"euler\"]\nscenes = 3\n[gate]\norder = 0\n[[tolerances]]\nquantity = \"spin\"\n\
                    [[ladders]]\nfinest = 100\nrungs = 2\n[engines]\na = 1\n";
        let Err(Failure::Config { faults, .. }) = Config::parse(text, "x.toml") else { panic!("accepted") };
        let found: Vec<(usize, &str)> =
            faults.iter().map(|fault| (fault.line, &text[fault.span.clone()])).collect();
        let expected =
            [(1, "shemes"), (2, "3"), (4, "0"), (6, "\"spin\""), (8, "100"), (9, "rungs"), (11, "1")];
        assert_eq!(found, expected);
    }
}
