//! A table of a scene file: the keys that it may have, and their values.

use std::ops::Range;

use nalgebra::Vector3;
use toml::de::{DeTable, DeValue};

use super::document::Document;
use super::value::Value;
use super::wording;
use crate::fault::Fault;

/// A table and the keys that it may have.
pub(super) struct Table<'t> {
    document: &'t Document<'t>,
    path: String,
    span: Range<usize>,
    entries: &'t DeTable<'t>,
    /// Keys that were meant, each with the one that was written.
    mistyped: Vec<(String, &'t str)>,
}

impl<'t> Table<'t> {
    /// Opens a table, and notes every key that is not among `keys`. A mistyped key has the value of the one that was meant.
    pub fn open(
        document: &'t Document<'t>,
        path: String,
        span: Range<usize>,
        entries: &'t DeTable<'t>,
        keys: &[&str],
    ) -> Table<'t> {
        let mut table = Table { document, path, span, entries, mistyped: Vec::new() };
        for (key, value) in entries.iter().filter(|(key, _)| !keys.contains(&key.get_ref().as_ref())) {
            let absent = keys.iter().copied().filter(|known| table.get(known).is_none());
            let near = wording::nearest(key.get_ref(), absent).first().copied();
            let meant = near.map_or(String::new(), |near| format!("did you mean {near}? "));
            let message = format!("no such key: {meant}the keys here are {}", keys.join(", "));
            let fault = document.fault(key.span(), &table.path_of(key.get_ref()), message);
            let fault = match near {
                Some(near) => {
                    table.mistyped.push((near.to_owned(), key.get_ref().as_ref()));
                    fault.replaced(near)
                }
                None if matches!(value.get_ref(), DeValue::Table(_)) => fault,
                None => fault.mended(document.removal(key.span(), value.span())),
            };
            document.note(fault);
        }
        table
    }

    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    /// The document that it is in.
    pub fn document(&self) -> &'t Document<'t> {
        self.document
    }

    /// Says what is wrong with a key that is not there.
    pub fn refuse(&self, key: &str, message: impl Into<String>) -> Fault {
        self.document.fault(self.span.clone(), &self.path_of(key), message)
    }

    /// A value, where the key is there.
    pub fn get(&self, key: &str) -> Option<Value<'t>> {
        let meant = || self.mistyped.iter().find(|(meant, _)| meant == key);
        let value = self.entries.get(key).or_else(|| self.entries.get(meant()?.1));
        value.map(|value| Value::new(self.document, self.path_of(key), value))
    }

    /// A value that must be there.
    pub fn required(&self, key: &str) -> Result<Value<'t>, Fault> {
        self.get(key).ok_or_else(|| {
            let path = self.path_of(key);
            self.missing(key, &wording::line(&path)).advised(format!("write {}", wording::example(&path)))
        })
    }

    /// Says that a key is missing, and the line to write.
    pub fn missing(&self, key: &str, line: &str) -> Fault {
        let (at_top, is_empty) = (self.path.is_empty(), self.entries.is_empty());
        let mend = self.document.addition(self.span.start, at_top, is_empty, line);
        self.refuse(key, "is missing").advised(format!("write {line}")).mended(mend)
    }

    /// Three numbers that must be there.
    pub fn vector(&self, key: &str) -> Result<Vector3<f64>, Fault> {
        self.required(key)?.vector()
    }

    /// Three numbers, where the key is there.
    pub fn optional_vector(&self, key: &str) -> Result<Option<Vector3<f64>>, Fault> {
        self.get(key).map(|value| value.vector()).transpose()
    }

    /// A text, where the key is there.
    pub fn optional_text(&self, key: &str) -> Result<Option<&'t str>, Fault> {
        self.get(key).map(|value| value.text()).transpose()
    }

    /// Refuses an entry that should not be there.
    pub fn unwanted(&self, key: &str, message: impl Into<String>) -> Option<Fault> {
        let (key, value) = self.entries.iter().find(|(known, _)| known.get_ref().as_ref() == key)?;
        let fault = self.document.fault(value.span(), &self.path_of(key.get_ref()), message);
        Some(fault.mended(self.document.removal(key.span(), value.span())))
    }

    /// Refuses two of some keys that say the same thing.
    pub fn one_of(&self, keys: &[&str]) -> Result<(), Fault> {
        let mut pairs = keys.iter().enumerate().flat_map(|(i, a)| keys[..i].iter().map(move |b| (a, b)));
        pairs.try_for_each(|(a, b)| self.not_both(a, b))
    }

    /// Refuses two keys that say the same thing; the second one in the file is named.
    pub fn not_both(&self, a: &str, b: &str) -> Result<(), Fault> {
        let start = |key: &str| self.entries.get(key).map(|value| value.span().start);
        let (Some(start_a), Some(start_b)) = (start(a), start(b)) else { return Ok(()) };
        let (first, second) = if start_a < start_b { (a, b) } else { (b, a) };
        let message = format!("stands beside {first}, and only one of the two may be given: remove one");
        self.unwanted(second, message).map_or(Ok(()), Err)
    }
}
