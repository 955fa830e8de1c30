//! Error constants and errors on record. A row belongs to the content of a scene, not to its name.

use std::collections::{BTreeMap, HashMap};

use serde::{Deserialize, Serialize};

use crate::measure::Asked;
use crate::quantity::{PerQuantity, Quantity};
use crate::record::Records;

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
    /// C of C hᵖ, in the unit of the quantity over sᵖ, where an order was decided.
    pub constant: Option<f64>,
    /// (h, error, what that must exceed to count) of every run, per sample time.
    pub errors: Vec<(f64, f64, f64)>,
}

/// What is on record, by content of the scene, scheme and quantity.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    rows: HashMap<(String, String, String), Recorded>,
}

impl Baseline {
    /// The constants of a records file, and the errors of every run.
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
                baseline.rows.entry(key).or_default().constant = order.constant;
            }
        }
        for evidence in &records.evidence {
            for quantity in Quantity::ALL {
                let asked = Asked::of(&evidence.ladder, quantity);
                let whole = asked.runs.iter().filter(|run| !run.errors.is_empty());
                let errors = whole.map(|run| (run.step, asked.error(run), asked.floor_of(run))).collect();
                let key =
                    (evidence.setting.content.clone(), evidence.known_as.clone(), quantity.name().to_owned());
                baseline.rows.entry(key).or_default().errors = errors;
            }
        }
        baseline
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
                    baseline.rows.insert(key, Recorded { constant, errors: Vec::new() });
                }
            }
        }
        baseline
    }

    /// What is on record of a quantity of a scheme, or of a program by its own name, in a scene of this content.
    pub fn find(&self, content: &str, scheme: &str, quantity: &str) -> Option<&Recorded> {
        self.rows.get(&(content.to_owned(), scheme.to_owned(), quantity.to_owned()))
    }

    /// The scenes, by content, and schemes on record, each pair once.
    pub fn pairs(&self) -> std::collections::BTreeSet<(&str, &str)> {
        self.rows.keys().map(|(content, scheme, _)| (content.as_str(), scheme.as_str())).collect()
    }
}
