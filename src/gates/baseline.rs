//! What is on record: orders, error constants, the errors of every run, the drift of the energy and the work. A row belongs to the content of a
//! scene, not to its name.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::claim::Claim;
use crate::measure::{Asked, Decision, decide};
use crate::quantity::{PerQuantity, Quantity};
use crate::record::{EnergyDrift, Evidence, Records};

/// The constants of the built-in scenes, by name.
pub type Constants = BTreeMap<String, OfScene>;

/// The constants of a scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OfScene {
    /// Its content.
    pub content: String,
    /// By scheme, in the unit of each quantity over sᵖ.
    pub schemes: BTreeMap<String, PerQuantity<Option<f64>>>,
}

/// The record of one quantity of a scheme in a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recorded {
    /// The order, where one was decided.
    pub order: Option<u32>,
    /// C of C hᵖ, in the unit of the quantity over sᵖ, where an order was decided.
    pub constant: Option<f64>,
    /// (h, error, what that must exceed to count) of every run, per sample time.
    pub errors: Vec<(f64, f64, f64)>,
}

/// The record of a scheme in a scene beside its errors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedCell {
    /// What the scheme claimed.
    pub claims: Vec<Claim>,
    /// (h, evaluations of the forces) of every run.
    pub work: Vec<(f64, u64)>,
    /// The drift of the energy, where it was measured.
    pub drift: Option<EnergyDrift>,
}

/// What may change against the record: relative changes, in a scene and a quantity or in all of them.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Tolerance {
    /// Name of the scene; every scene without it.
    pub scene: Option<String>,
    /// Name of the quantity; every quantity without it.
    pub quantity: Option<String>,
    /// Largest change of an error constant.
    pub constant: Option<f64>,
    /// Largest change of the error of a run.
    pub error: Option<f64>,
}

/// What is on record, by content of the scene and scheme, and by quantity.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    rows: HashMap<(String, String, String), Recorded>,
    cells: HashMap<(String, String), RecordedCell>,
    tolerances: Vec<Tolerance>,
}

impl Baseline {
    /// The orders and constants of a records file, the errors of every run, the drift and the work.
    pub fn from_records(records: &Records) -> Baseline {
        let contents: HashMap<&str, &str> =
            records.scenes.iter().map(|scene| (scene.name.as_str(), scene.content.as_str())).collect();
        let named: HashMap<&str, &str> =
            records.engines.iter().map(|engine| (engine.scheme.as_str(), engine.name.as_str())).collect();
        let mut baseline = Baseline::default();
        let key = |scene: &str, scheme: &str, quantity: &str| {
            let content = contents.get(scene).filter(|content| !content.is_empty())?;
            let scheme = named.get(scheme).copied().unwrap_or(scheme);
            Some(((*content).to_owned(), scheme.to_owned(), quantity.to_owned()))
        };
        for order in &records.orders {
            if let Some(key) = key(&order.scene, &order.scheme, &order.quantity) {
                let row = baseline.rows.entry(key).or_default();
                row.constant = order.constant;
                row.order = order.order.map(|order| order.round() as u32);
            }
        }
        records.evidence.iter().for_each(|evidence| baseline.add(evidence));
        baseline
    }

    fn add(&mut self, evidence: &Arc<Evidence>) {
        let cell = (evidence.setting.content.clone(), evidence.known_as.clone());
        for quantity in Quantity::ALL {
            let asked = Asked::of(&evidence.ladder, quantity);
            let whole = asked.runs.iter().filter(|run| !run.errors.is_empty());
            let errors = whole.map(|run| (run.step, asked.error(run), asked.floor_of(run))).collect();
            let key = (cell.0.clone(), cell.1.clone(), quantity.name().to_owned());
            let row = self.rows.entry(key).or_default();
            row.errors = errors;
            if let Decision::Order(found) = decide(&asked) {
                row.order = Some(found.order);
            }
        }
        let whole = evidence.ladder.rungs.iter().filter(|rung| rung.broken.is_none());
        let work = whole.map(|rung| (rung.step, rung.evaluations)).collect();
        let (claims, drift) = (evidence.claims.clone(), evidence.drift.clone());
        self.cells.insert(cell, RecordedCell { claims, work, drift });
    }

    /// The constants of this version, for the built-in scenes: references/constants.json.
    ///
    /// # Panics
    /// The file in the program is not such a file, which a test rules out.
    pub fn built_in() -> Baseline {
        let constants: Constants = serde_json::from_str(include_str!("../../references/constants.json"))
            .expect("references/constants.json holds constants");
        let mut baseline = Baseline::default();
        for scene in constants.into_values() {
            for (scheme, constants) in scene.schemes {
                for (quantity, constant) in constants {
                    let key = (scene.content.clone(), scheme.clone(), quantity.name().to_owned());
                    baseline.rows.insert(key, Recorded { constant, ..Recorded::default() });
                }
            }
        }
        baseline
    }

    /// With what may change. The last that fits a scene and a quantity counts.
    #[must_use]
    pub fn with_tolerances(self, tolerances: Vec<Tolerance>) -> Baseline {
        Baseline { tolerances, ..self }
    }

    /// What is on record of a quantity of a scheme, or of a program by its own name, in a scene of this content.
    pub fn find(&self, content: &str, scheme: &str, quantity: &str) -> Option<&Recorded> {
        self.rows.get(&(content.to_owned(), scheme.to_owned(), quantity.to_owned()))
    }

    /// What is on record of a scheme in a scene beside its errors.
    pub fn cell(&self, content: &str, scheme: &str) -> Option<&RecordedCell> {
        self.cells.get(&(content.to_owned(), scheme.to_owned()))
    }

    /// What `of` reads from the last tolerance that has it for a quantity in a scene.
    pub fn tolerance(
        &self,
        (scene, quantity): (&str, &str),
        of: impl Fn(&Tolerance) -> Option<f64>,
    ) -> Option<f64> {
        let fits = |one: &&Tolerance| {
            one.scene.as_deref().is_none_or(|name| name == scene)
                && one.quantity.as_deref().is_none_or(|name| name == quantity)
        };
        self.tolerances.iter().rev().filter(fits).find_map(of)
    }

    /// The scenes, by content, and schemes on record, each pair once.
    pub fn pairs(&self) -> BTreeSet<(&str, &str)> {
        self.rows.keys().map(|(content, scheme, _)| (content.as_str(), scheme.as_str())).collect()
    }
}
