//! A capsule: all that a survey was made from, and what came of it, so that another machine can run it again and compare every row.

use std::path::Path;

use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;
use sha2::{Digest, Sha256};

use super::{Machine, RecordError, Records, faults, read_text};

/// The schema that [`Capsule`] follows.
pub(super) const SCHEMA: &str = "polhode/capsule/1";

/// Sections of records that a second run gives again to the bit; the others hold times of the machine.
const SECTIONS: [&str; 10] = [
    "measurements",
    "orders",
    "drifts",
    "evidence",
    "references",
    "verdicts",
    "series",
    "published",
    "precision",
    "maps",
];
/// Fields of rows that are times.
const TIMES: [&str; 1] = ["nanoseconds_per_step"];

/// What was asked for.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// Schemes by name.
    pub schemes: Vec<String>,
    /// Whether every scheme of the list was measured in three scenes.
    pub every_scheme: bool,
    /// Whether published numbers were computed again.
    pub published: bool,
    /// Whether precision was studied.
    pub precision: bool,
    /// Whether growth was mapped.
    #[serde(default)]
    pub growth: bool,
}

/// A scene as it was given.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SceneText {
    /// Name, or the path of its file.
    pub name: String,
    /// The text of the file.
    pub toml: String,
}

/// A section of the records and its hash.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Section {
    name: String,
    rows: usize,
    /// Of the rows as JSON, a row a line.
    sha256: String,
}

/// Scenes, request, version, and what came of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Capsule {
    schema: String,
    /// Version of Polhode that wrote it.
    pub polhode: String,
    machine: Machine,
    made_at: String,
    /// The request.
    pub request: Request,
    /// Seeds of random numbers: a survey draws none, its perturbed copies follow from the start of the scene.
    seeds: Vec<u64>,
    /// The scenes.
    pub scenes: Vec<SceneText>,
    /// SHA-256 of the scenes, in hexadecimal digits.
    scenes_sha256: String,
    sections: Vec<Section>,
    #[serde(serialize_with = "without_times")]
    records: Records,
}

/// A row that differs.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Section of the records.
    pub section: &'static str,
    /// Row of the section, from 0.
    pub row: usize,
    /// The row in the capsule, if it has one.
    pub stored: Option<Value>,
    /// The row of now, if there is one.
    pub now: Option<Value>,
}

impl Capsule {
    /// The capsule of a survey.
    pub fn new(scenes: Vec<SceneText>, request: Request, records: &Records) -> Capsule {
        let rows = rows(records);
        let section = |(name, rows): (&&str, &Vec<Value>)| Section {
            name: (*name).to_owned(),
            rows: rows.len(),
            sha256: hash(rows.iter().map(Value::to_string)),
        };
        Capsule {
            schema: SCHEMA.to_owned(),
            polhode: records.polhode.clone(),
            machine: records.machine.clone(),
            made_at: records.made_at.clone(),
            request,
            seeds: Vec::new(),
            scenes_sha256: hash(scenes.iter().map(|scene| format!("{}\n{}", scene.name, scene.toml))),
            scenes,
            sections: SECTIONS.iter().zip(&rows).map(section).collect(),
            records: records.clone(),
        }
    }

    /// Reads a capsule.
    ///
    /// # Errors
    /// The file cannot be read, is no capsule, or its content does not have the hashes that it states.
    pub fn read(path: &Path) -> Result<Capsule, RecordError> {
        let format = |why| RecordError::Format { path: path.into(), why };
        let text = read_text(path)?;
        let capsule = match serde_json::from_str::<Capsule>(&text) {
            Ok(capsule) if capsule.schema == SCHEMA => capsule,
            other => {
                let (file, faults) = (path.display().to_string(), faults::of_capsule(&text, other.err()));
                return Err(RecordError::Content { file, text, faults });
            }
        };
        let again = Capsule::new(capsule.scenes.clone(), capsule.request.clone(), &capsule.records);
        if again.scenes_sha256 != capsule.scenes_sha256 {
            return Err(format("the scenes do not have the hash that the capsule states".to_owned()));
        }
        match again.sections.iter().zip(&capsule.sections).find(|(now, stated)| now != stated) {
            Some((section, _)) => Err(format(format!(
                "section {} does not have the hash that the capsule states",
                section.name
            ))),
            None => Ok(capsule),
        }
    }

    /// The number of rows that are compared.
    pub fn rows(&self) -> usize {
        self.sections.iter().map(|section| section.rows).sum()
    }

    /// The rows that differ, in any bit but those of times.
    pub fn differences(&self, now: &Records) -> Vec<Difference> {
        let (stored, now) = (rows(&self.records), rows(now));
        let mut all = Vec::new();
        for ((section, stored), now) in SECTIONS.iter().zip(stored).zip(now) {
            for row in 0..stored.len().max(now.len()) {
                let (stored, now) = (stored.get(row).cloned(), now.get(row).cloned());
                if stored != now {
                    all.push(Difference { section, row, stored, now });
                }
            }
        }
        all
    }
}

impl Difference {
    /// Scene, scheme and quantity or metric of the row, as far as it has them.
    pub fn subject(&self) -> String {
        let row = self.stored.as_ref().or(self.now.as_ref());
        let word = |key: &&str| row.and_then(|row| row.get(key)?.as_str()).map(str::to_owned);
        let words: Vec<String> =
            ["scene", "scheme", "quantity", "metric", "claim"].iter().filter_map(word).collect();
        words.join(", ")
    }

    /// The fields that differ: name, stored, now.
    pub fn fields(&self) -> Vec<(String, String, String)> {
        let (Some(Value::Object(stored)), Some(Value::Object(now))) = (&self.stored, &self.now) else {
            return Vec::new();
        };
        let word = |value: Option<&Value>| value.map_or("nothing".to_owned(), Value::to_string);
        let mut names: Vec<&String> = stored.keys().chain(now.keys()).collect();
        names.sort_unstable();
        names.dedup();
        let differs = names.into_iter().filter(|name| stored.get(*name) != now.get(*name));
        differs.map(|name| (name.clone(), word(stored.get(name)), word(now.get(name)))).collect()
    }
}

/// The rows of each of [`SECTIONS`], without times.
fn rows(records: &Records) -> Vec<Vec<Value>> {
    let mut whole = serde_json::to_value(records).unwrap_or_default();
    let section = |name: &&str| {
        let mut rows = match whole.get_mut(name).map(Value::take) {
            Some(Value::Array(rows)) => rows,
            _ => Vec::new(),
        };
        for row in rows.iter_mut().filter_map(Value::as_object_mut) {
            TIMES.iter().for_each(|time| drop(row.remove(*time)));
        }
        rows
    };
    SECTIONS.iter().map(section).collect()
}

/// Records of what a second run gives again.
fn without_times<S: Serializer>(records: &Records, serializer: S) -> Result<S::Ok, S::Error> {
    let mut kept = records.clone();
    (kept.costs, kept.scaling, kept.peers, kept.twins) = Default::default();
    kept.serialize(serializer)
}

fn hash(lines: impl Iterator<Item = String>) -> String {
    let mut digest = Sha256::new();
    for line in lines {
        digest.update(line.as_bytes());
        digest.update(b"\n");
    }
    digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Order, write_json};

    fn records(order: f64) -> Records {
        let row = |scene: &str, order| Order { scene: scene.into(), order: Some(order), ..Order::default() };
        Records { orders: vec![row("a", 2.0), row("b", order)], ..Records::default() }
    }

    #[test]
    fn a_row_that_differs_in_the_last_bit_is_named_with_its_field() {
        let capsule = Capsule::new(Vec::new(), Request::default(), &records(1.0));
        assert!(capsule.differences(&records(1.0)).is_empty());
        let found = capsule.differences(&records(1.0 + f64::EPSILON));
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].section, found[0].row, found[0].subject()), ("orders", 1, "b, , ".into()));
        let expected = ("order".to_owned(), "1.0".to_owned(), "1.0000000000000002".to_owned());
        assert_eq!(found[0].fields(), [expected]);
        let fewer = Records::default();
        assert!(capsule.differences(&fewer).iter().all(|one| one.now.is_none()));
        assert_eq!(capsule.differences(&fewer).len(), capsule.rows());
    }

    #[test]
    fn a_capsule_is_read_back_and_one_that_was_edited_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("capsule.json");
        let scene = SceneText { name: "a".into(), toml: "x = 1".into() };
        write_json(&path, &Capsule::new(vec![scene], Request::default(), &records(1.5))).expect("written");
        assert!(Capsule::read(&path).expect("a capsule").differences(&records(1.5)).is_empty());
        let text = std::fs::read_to_string(&path).expect("text");
        for (from, to) in [("1.5", "1.25"), ("x = 1", "x = 2")] {
            assert!(text.contains(from));
            std::fs::write(&path, text.replace(from, to)).expect("written");
            assert!(matches!(Capsule::read(&path), Err(RecordError::Format { .. })), "{from}");
        }
    }
}
