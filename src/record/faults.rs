//! All that is wrong with a file of records: the first fault of each key of each row, with its place.
//!
//! A row that cannot be read is read again key by key, each in a row that is sound otherwise.

use std::ops::Range;

use serde::Serialize;
use serde::de::{DeserializeOwned, IgnoredAny};
use serde_json::{Deserializer, Error, Map, Value};

use super::{
    CostRow, Drift, EngineRow, Evidence, Measurement, Motion, Order, PeerRow, PrecisionRow, Provenance,
    PublishedRow, Records, ReferenceEvidence, ScalingRow, SceneRow, SchemeRow, Series, Twin, Verdict, ditto,
    stability,
};
use crate::fault::Fault;

/// What to do with a file that no change of a line mends.
const ANEW: &str = "make it anew by polhode report, or by polhode gate --json FILE";
/// The same of a capsule.
#[cfg(feature = "cli")]
const CAPSULE_ANEW: &str = "make it anew by polhode report --capsule FILE";

/// The faults of `records.json`; `error` is what the reader of the whole file met.
pub(super) fn of_records(text: &str, error: Option<Error>) -> Vec<Fault> {
    let mut sheet = Sheet { text, faults: Vec::new(), anew: ANEW };
    sheet.file(super::SCHEMA, &|sheet, start| sheet.records(start, ""));
    sheet.finish(error)
}

/// The faults of a capsule.
#[cfg(feature = "cli")]
pub(super) fn of_capsule(text: &str, error: Option<Error>) -> Vec<Fault> {
    use super::capsule::{Capsule, SCHEMA};
    let mut sheet = Sheet { text, faults: Vec::new(), anew: CAPSULE_ANEW };
    sheet.file(SCHEMA, &|sheet, start| {
        sheet.object::<Capsule>(start, "", &|sheet, entry| {
            let is_records = entry.name == "records";
            if is_records {
                sheet.records(entry.value.start, "records.");
            }
            is_records
        });
    });
    sheet.finish(error)
}

/// How rows of a list are looked at.
type Look = fn(&mut Sheet, &Entry, &str);

/// The lists of [`Records`].
const LISTS: [(&str, Look); 19] = [
    ("provenance", rows::<Provenance>),
    ("scenes", rows::<SceneRow>),
    ("schemes", rows::<SchemeRow>),
    ("measurements", rows::<Measurement>),
    ("orders", rows::<Order>),
    ("drifts", rows::<Drift>),
    ("evidence", rows::<Evidence>),
    ("references", rows::<ReferenceEvidence>),
    ("verdicts", rows::<Verdict>),
    ("costs", rows::<CostRow>),
    ("scaling", rows::<ScalingRow>),
    ("series", rows::<Series>),
    ("motions", rows::<Motion>),
    ("engines", rows::<EngineRow>),
    ("peers", rows::<PeerRow>),
    ("twins", rows::<Twin>),
    ("published", rows::<PublishedRow>),
    ("precision", rows::<PrecisionRow>),
    ("maps", rows::<stability::Map>),
];

/// A key and its value in a text.
struct Entry {
    name: String,
    value: Range<usize>,
}

/// A text, and what has been found wrong with it so far.
struct Sheet<'t> {
    text: &'t str,
    faults: Vec<Fault>,
    /// What to do with a file that no change of a line mends.
    anew: &'static str,
}

impl Sheet<'_> {
    fn note(&mut self, span: Range<usize>, key: &str, message: impl Into<String>) {
        self.faults.push(Fault::at(self.text, span, key, message));
    }

    /// In the order of the file. Where the reader met what was not found here, its own words.
    fn finish(mut self, error: Option<Error>) -> Vec<Fault> {
        if let Some(error) = error.filter(|_| self.faults.is_empty()) {
            self.refused(0, &error);
        }
        self.faults.sort_by_key(|fault| fault.span.start);
        self.faults
    }

    /// What a reader that began at a byte says.
    fn refused(&mut self, start: usize, error: &Error) {
        let after = &self.text[start..];
        let lines = after.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len);
        let mut end = (start + lines.sum::<usize>() + error.column()).min(self.text.len());
        while !self.text.is_char_boundary(end) {
            end -= 1;
        }
        let first = self.text[..end].char_indices().next_back().map_or(0, |(place, _)| place);
        if error.is_eof() {
            let fault = Fault::at(self.text, first..end, "", "the file is cut off here");
            self.faults.push(Fault { advice: self.anew.to_owned(), ..fault });
        } else {
            self.note(first..end, "", said(error));
        }
    }

    /// A whole file: JSON, its schema, and its content where that is the one that is expected.
    fn file(&mut self, schema: &str, content: &dyn Fn(&mut Self, usize)) {
        match end_of_value(self.text, 0) {
            Ok(end) if self.text[end..].trim().is_empty() => {}
            Ok(end) => self.note(end..self.text.len(), "", "text after the end of the object"),
            Err(error) => self.refused(0, &error),
        }
        let Some(start) = self.text.find(|letter: char| !letter.is_whitespace()) else { return };
        let is_schema = |entry: &Entry| entry.name == "schema";
        let named = entries(self.text, start).into_iter().find(is_schema).map(|entry| entry.value);
        match named {
            Some(place)
                if serde_json::from_str::<String>(&self.text[place.clone()]).ok().as_deref()
                    == Some(schema) =>
            {
                content(self, start);
            }
            Some(place) => {
                let fault = Fault::at(self.text, place, "schema", format!("this version reads \"{schema}\""));
                self.faults.push(Fault { advice: self.anew.to_owned(), ..fault });
            }
            None if self.faults.is_empty() => {
                let message = format!("no file of Polhode: it names no schema, expected is \"{schema}\"");
                self.note(start..start + 1, "", message);
            }
            None => {}
        }
    }

    fn records(&mut self, start: usize, path: &str) {
        self.object::<Records>(start, path, &|sheet, entry| {
            let list = LISTS.iter().find(|(name, _)| *name == entry.name);
            if let Some((_, look)) = list {
                look(sheet, entry, path);
            }
            list.is_some()
        });
    }

    /// A row that cannot be read; its keys are marked in the text, and `value` is what it means.
    fn row<T: DeserializeOwned + Serialize + Default>(&mut self, start: usize, path: &str, value: &Value) {
        let Value::Object(object) = value else {
            return self.note(start..start + 1, path.trim_end_matches('.'), "expected a row in braces");
        };
        let sound = sound::<T>();
        for entry in entries(self.text, start) {
            if let Some(why) =
                object.get(&entry.name).and_then(|value| wrong::<T>(&sound, &entry.name, value))
            {
                self.note(entry.value, &format!("{path}{}", entry.name), why);
            }
        }
        self.missing::<T>(start, path, sound, |key| object.contains_key(key));
    }

    /// An object of the file; `known` looks at an entry itself where it returns true.
    fn object<T: DeserializeOwned + Serialize + Default>(
        &mut self,
        start: usize,
        path: &str,
        known: &dyn Fn(&mut Self, &Entry) -> bool,
    ) {
        let (entries, sound) = (entries(self.text, start), sound::<T>());
        for entry in &entries {
            if known(self, entry) {
                continue;
            }
            let value = serde_json::from_str::<Value>(&self.text[entry.value.clone()]);
            let why = match value {
                Ok(value) => wrong::<T>(&sound, &entry.name, &value),
                Err(error) => (!error.is_eof()).then(|| said(&error)),
            };
            if let Some(why) = why {
                self.note(entry.value.clone(), &format!("{path}{}", entry.name), why);
            }
        }
        // What stands after a cut is not missing.
        if !self.faults.iter().any(|fault| fault.key.is_empty()) {
            self.missing::<T>(start, path, sound, |key| entries.iter().any(|entry| entry.name == key));
        }
    }

    /// The keys that an object must have and has not.
    fn missing<T: DeserializeOwned>(
        &mut self,
        start: usize,
        path: &str,
        sound: Map<String, Value>,
        has: impl Fn(&str) -> bool,
    ) {
        for key in sound.keys().filter(|key| !has(key)) {
            let mut without = sound.clone();
            without.remove(key);
            if serde_json::from_value::<T>(without.into()).is_err() {
                self.note(start..start + 1, &format!("{path}{key}"), "this key is missing");
            }
        }
    }
}

/// A list of rows of one type.
fn rows<T: DeserializeOwned + Serialize + Default>(sheet: &mut Sheet, list: &Entry, path: &str) {
    let name = format!("{path}{}", list.name);
    if !sheet.text[list.value.clone()].starts_with('[') {
        return sheet.note(list.value.clone(), &name, "expected a list of rows");
    }
    let mut seen = ditto::Seen::new();
    for (index, row) in elements(sheet.text, list.value.start).into_iter().enumerate() {
        let Ok(mut value) = serde_json::from_str::<Value>(&sheet.text[row.clone()]) else { continue };
        if list.name == "evidence" {
            ditto::restore(&mut value, &mut seen);
        }
        if serde_json::from_value::<T>(value.clone()).is_err() {
            sheet.row::<T>(row.start, &format!("{name}[{index}]."), &value);
        }
    }
}

/// A row with which nothing is wrong.
fn sound<T: Serialize + Default>() -> Map<String, Value> {
    match serde_json::to_value(T::default()) {
        Ok(Value::Object(map)) => map,
        _ => Map::new(),
    }
}

/// Why a value cannot stand in a row that is sound otherwise.
fn wrong<T: DeserializeOwned>(sound: &Map<String, Value>, key: &str, value: &Value) -> Option<String> {
    let mut row = sound.clone();
    row.insert(key.to_owned(), value.clone());
    serde_json::from_value::<T>(row.into()).err().map(|error| said(&error))
}

/// An error without its place, which a reader of a part counts from there.
fn said(error: &Error) -> String {
    let text = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    text.strip_suffix(&place).unwrap_or(&text).to_owned()
}

/// Where the value that begins at a byte, or after it, ends.
fn end_of_value(text: &str, start: usize) -> Result<usize, Error> {
    let mut values = Deserializer::from_str(&text[start..]).into_iter::<IgnoredAny>();
    match values.next() {
        Some(Err(error)) => Err(error),
        Some(Ok(_)) => Ok(start + values.byte_offset()),
        None => serde_json::from_str::<IgnoredAny>("").map(|_| start),
    }
}

/// Where the next value of a list or an object begins: signs between values are passed over.
fn beginning(text: &str, start: usize) -> usize {
    let rest = text.get(start..).unwrap_or_default();
    text.len() - rest.trim_start_matches(|letter: char| letter.is_whitespace() || ",:".contains(letter)).len()
}

/// The next value of a list or an object.
fn next(text: &str, start: usize) -> Option<Range<usize>> {
    let start = beginning(text, start);
    Some(start..end_of_value(text, start).ok()?)
}

/// The elements of the list that begins at a byte, as far as they can be read.
fn elements(text: &str, start: usize) -> Vec<Range<usize>> {
    std::iter::successors(next(text, start + 1), |before| next(text, before.end)).collect()
}

/// The entries of the object that begins at a byte, as far as they can be read. A value that does not end goes on to the end of the text.
fn entries(text: &str, start: usize) -> Vec<Entry> {
    let mut found = Vec::new();
    let mut after = if text[start..].starts_with('{') { start + 1 } else { text.len() };
    while let Some(name) = next(text, after) {
        let start = beginning(text, name.end);
        after = end_of_value(text, start).unwrap_or(text.len());
        match serde_json::from_str(&text[name]) {
            Ok(name) => found.push(Entry { name, value: start..after }),
            Err(_) => break,
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::SCHEMA;

    /// A file with a list of rows.
    fn file(list: &str, rows: &str) -> String {
        let head =
            format!("{{\n\"schema\": \"{SCHEMA}\",\n\"polhode\": \"0\",\n\"made_at\": \"\",\n\"machine\": ");
        let machine = "{\"os\":\"\",\"architecture\":\"\",\"processor\":\"\",\"threads\":1}";
        let empty = ["measurements", "orders", "verdicts"].iter().filter(|name| **name != list);
        let empty: String = empty.map(|name| format!("\"{name}\": [],\n")).collect();
        format!("{head}{machine},\n{empty}\"{list}\": [\n{rows}\n]\n}}\n")
    }

    /// Line, key and marked text of each fault.
    fn found(text: &str) -> Vec<(usize, String, String)> {
        let error = serde_json::from_str::<Records>(text).err();
        let faults = of_records(text, error);
        faults.into_iter().map(|fault| (fault.line, fault.key, text[fault.span].to_owned())).collect()
    }

    const VERDICT: &str = "{\"scene\":\"a\",\"scheme\":\"b\",\"claim\":\"order\",\"quantity\":\"\",\"verdict\":\"pass\",\"measured\":null,\"low\":null,\"high\":null,\"detail\":\"\"}";

    #[test]
    fn each_key_of_each_row_has_its_first_fault() {
        assert_eq!(found(&file("verdicts", VERDICT)), []);
        let unknown = VERDICT.replace("\"pass\"", "\"perhaps\"").replace("\"low\":null", "\"low\":\"1\"");
        let missing = VERDICT.replace("\"scene\":\"a\",", "").replace("\"detail\":\"\"", "\"detail\":7");
        let text = file("verdicts", &[VERDICT, &unknown, &missing, "[]"].join(",\n"));
        let expected = [
            (10, "verdicts[1].verdict", "\"perhaps\""),
            (10, "verdicts[1].low", "\"1\""),
            (11, "verdicts[2].scene", "{"),
            (11, "verdicts[2].detail", "7"),
            (12, "verdicts[3]", "["),
        ];
        assert_eq!(found(&text), expected.map(|(line, key, word)| (line, key.to_owned(), word.to_owned())));
    }

    #[test]
    fn keys_of_the_file_itself_are_looked_at_too() {
        let text = file("verdicts", VERDICT)
            .replace("\"threads\":1", "\"threads\":-1")
            .replace("\"polhode\"", "\"pohlode\"");
        let keys: Vec<(usize, String)> = found(&text).into_iter().map(|(line, key, _)| (line, key)).collect();
        assert_eq!(keys, [(1, "polhode".to_owned()), (5, "machine".to_owned())]);
        let text = file("verdicts", VERDICT).replace("\"orders\": []", "\"orders\": 3");
        assert_eq!(found(&text), [(7, "orders".to_owned(), "3".to_owned())]);
    }

    #[test]
    fn a_file_that_is_cut_is_read_up_to_the_cut() {
        let wrong = VERDICT.replace("\"pass\"", "\"perhaps\"");
        let text = file("verdicts", &[VERDICT, &wrong, VERDICT].join(",\n"));
        let cut = &text[..text.rfind("\"claim\"").expect("the last row")];
        let lines: Vec<(usize, String)> = found(cut).into_iter().map(|(line, key, _)| (line, key)).collect();
        assert_eq!(lines, [(10, "verdicts[1].verdict".to_owned()), (11, String::new())]);
        for text in
            ["", "{", "[]", "nonsense", "{}", "{} more", "{\"schema\": 1}", "{\"schema\": \"polhode/run/1\"}"]
        {
            assert_eq!(found(text).len(), 1, "{text}: {:?}", found(text));
        }
    }

    #[test]
    fn a_key_that_stands_twice_is_a_fault() {
        let twice = VERDICT.replacen("\"scene\":\"a\"", "\"scene\":\"a\",\"scene\":\"b\"", 1);
        assert_eq!(found(&file("verdicts", &twice)).len(), 1);
    }
}
