//! A table of a scene file: the keys that it may have, and their values.

use nalgebra::Vector3;
use toml::de::DeTable;

use super::SceneError;
use super::value::{Document, Value};
use super::wording;

/// A table all of whose keys are known.
pub(super) struct Table<'t> {
    document: &'t Document<'t>,
    path: String,
    start: usize,
    entries: &'t DeTable<'t>,
}

impl<'t> Table<'t> {
    /// Opens a table and refuses a key that is not among `keys`, the first in the file.
    pub fn open(
        document: &'t Document<'t>,
        path: String,
        start: usize,
        entries: &'t DeTable<'t>,
        keys: &[&str],
    ) -> Result<Table<'t>, SceneError> {
        let table = Table { document, path, start, entries };
        let unknown = entries
            .iter()
            .map(|(key, _)| key)
            .filter(|key| !keys.contains(&key.get_ref().as_ref()))
            .min_by_key(|key| key.span().start);
        let Some(key) = unknown else { return Ok(table) };
        let meant = wording::nearest(key.get_ref(), keys.iter().copied());
        let meant = meant.first().map_or(String::new(), |near| format!("did you mean {near}? "));
        let message = format!("no such key: {meant}the keys here are {}", keys.join(", "));
        Err(document.refuse(key.span().start, &table.path_of(key.get_ref()), message))
    }

    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_string() } else { format!("{}.{key}", self.path) }
    }

    /// Says what is wrong with a key that is not there.
    pub fn refuse(&self, key: &str, message: impl Into<String>) -> SceneError {
        self.document.refuse(self.start, &self.path_of(key), message)
    }

    /// A value, where the key is there.
    pub fn get(&self, key: &str) -> Option<Value<'t>> {
        self.entries.get(key).map(|value| Value::new(self.document, self.path_of(key), value))
    }

    /// A value that must be there.
    pub fn required(&self, key: &str) -> Result<Value<'t>, SceneError> {
        self.get(key).ok_or_else(|| self.missing(key))
    }

    /// Says that a key is missing, and what to write.
    pub fn missing(&self, key: &str) -> SceneError {
        self.refuse(key, format!("is missing: write {}", wording::example(key)))
    }

    /// Three numbers that must be there.
    pub fn vector(&self, key: &str) -> Result<Vector3<f64>, SceneError> {
        self.required(key)?.vector()
    }

    /// Three numbers, where the key is there.
    pub fn optional_vector(&self, key: &str) -> Result<Option<Vector3<f64>>, SceneError> {
        self.get(key).map(|value| value.vector()).transpose()
    }

    /// A text, where the key is there.
    pub fn optional_text(&self, key: &str) -> Result<Option<&'t str>, SceneError> {
        self.get(key).map(|value| value.text()).transpose()
    }

    /// Refuses two of some keys that say the same thing.
    pub fn one_of(&self, keys: &[&str]) -> Result<(), SceneError> {
        let mut pairs = keys.iter().enumerate().flat_map(|(i, a)| keys[..i].iter().map(move |b| (a, b)));
        pairs.try_for_each(|(a, b)| self.not_both(a, b))
    }

    /// Refuses two keys that say the same thing; the second one in the file is named.
    pub fn not_both(&self, a: &str, b: &str) -> Result<(), SceneError> {
        let start = |key: &str| self.entries.get(key).map(|value| value.span().start);
        let (Some(start_a), Some(start_b)) = (start(a), start(b)) else { return Ok(()) };
        let (first, second) = if start_a < start_b { (a, b) } else { (b, a) };
        let message = format!("stands beside {first}, and only one of the two may be given: remove one");
        Err(self.document.refuse(start_a.max(start_b), &self.path_of(second), message))
    }
}
