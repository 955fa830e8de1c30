//! The list of scenes and their file format: a TOML file, read into a checked [`System`].
//!
//! Every value keeps the place it was read at, so that whatever is wrong, here or in the model, is said with
//! file, line and full key, and with what to write instead. All faults of a file are found in one reading. The built-in scenes are files in the same format,
//! in `references/scenes`.

#[cfg(feature = "cli")]
mod begun;
mod body;
mod document;
mod error;
mod laws;
mod list;
#[cfg(feature = "cli")]
pub(crate) mod random;
mod schema;
mod start;
mod table;
mod value;
mod wording;

use std::path::Path;

use toml::de::DeTable;

pub use crate::fault::Fault;
#[cfg(feature = "cli")]
pub use crate::fault::Mend;
#[cfg(feature = "cli")]
pub(crate) use begun::begun;
pub use error::SceneError;
pub use laws::block;
pub use list::FILES;
#[cfg(feature = "cli")]
pub(crate) use schema::SCHEMA_TITLE;
pub use schema::schema;
pub(crate) use schema::to_json;
#[cfg(feature = "cli")]
pub(crate) use wording::{one_of, three_nearest};

use crate::bounded::{self, FileError};
use crate::model::System;
use document::Document;
use nalgebra::Vector3;
use table::Table;

/// The keys at the top of a scene file.
const KEYS: &[&str] =
    &["name", "title", "why", "duration", "not_for_order", "only_for_stability", "body", "initial", "forces"];

/// A body, the forces on it and its start, with what the report says of them.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Name, kebab-case.
    pub name: String,
    /// One line; the name where the file has none.
    pub title: String,
    /// What the scene shows that others do not; empty where the file does not say.
    pub why: String,
    /// Length of the run [s].
    pub duration: f64,
    /// Why the order gate does not apply, where it does not.
    pub not_for_order: Option<String>,
    /// Why no claim is judged here and only `polhode stability` speaks of the scene, where that is so.
    pub only_for_stability: Option<String>,
    /// Whether it is one of [`FILES`].
    pub built_in: bool,
    /// File that it was read from, as the user named it.
    pub file: String,
    /// What the file says.
    pub text: String,
    /// The body under its forces, ready to be stepped.
    pub system: System,
}

impl Scene {
    /// Reads the text of a scene file; `file` is its name in error messages.
    ///
    /// # Errors
    /// [`SceneError::Content`].
    pub fn parse(text: &str, file: &str) -> Result<Scene, SceneError> {
        let document = Document::of(text);
        let scene = read(&document, file);
        let faults = document.into_faults();
        match scene {
            Some(scene) if faults.is_empty() => Ok(scene),
            _ => Err(SceneError::Content { file: file.to_owned(), text: text.to_owned(), faults }),
        }
    }

    /// A fingerprint of all that determines the motion: body, forces, start and duration. A copy under another name has the same one.
    pub fn content(&self) -> String {
        let text = format!("{:?} {:?}", self.system, self.duration);
        // FNV-1a: Fowler, Noll, Vo.
        let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
        format!("{hash:016x}")
    }

    /// The built-in scene of this name, or the scene in the file at this path: a path has a '/', ends in .toml
    /// or is an existing file.
    ///
    /// # Errors
    /// [`SceneError`].
    pub fn find(name_or_path: &str) -> Result<Scene, SceneError> {
        match FILES.iter().find(|(name, _)| *name == name_or_path) {
            Some((name, text)) => parse_built_in(name, text),
            None => Scene::parse(&Scene::text(name_or_path)?, name_or_path),
        }
    }

    /// The text of a built-in scene, or of the file at a path.
    ///
    /// # Errors
    /// [`SceneError`].
    pub fn text(name_or_path: &str) -> Result<String, SceneError> {
        if let Some((_, text)) = FILES.iter().find(|(name, _)| *name == name_or_path) {
            return Ok((*text).to_owned());
        }
        let path = Path::new(name_or_path);
        let is_path = name_or_path.contains(['/', std::path::MAIN_SEPARATOR])
            || name_or_path.ends_with(".toml")
            || path.is_file();
        if !is_path {
            let near = wording::three_nearest(name_or_path, FILES.iter().map(|(name, _)| *name));
            return Err(SceneError::Unknown { name: name_or_path.to_string(), near });
        }
        bounded::text(path, bounded::MOST_OF_A_SCENE).map_err(|error| match error {
            FileError::Unreadable { file, source } => SceneError::Unreadable { file, source },
            FileError::Content { file, line, why } => {
                let fault = Fault { line, ..Document::of("").fault(0..0, "", why) };
                SceneError::Content { file, text: String::new(), faults: vec![fault] }
            }
        })
    }
}

/// All built-in scenes, in the order of [`FILES`].
///
/// # Panics
/// A built-in file is not a scene, which a test rules out.
pub fn built_in() -> Vec<Scene> {
    FILES
        .iter()
        .map(|(name, text)| parse_built_in(name, text).unwrap_or_else(|error| panic!("built in: {error}")))
        .collect()
}

fn parse_built_in(name: &str, text: &str) -> Result<Scene, SceneError> {
    Scene::parse(text, &format!("references/scenes/{name}.toml"))
        .map(|scene| Scene { built_in: true, ..scene })
}

/// Reads all that can be read, and notes all that is wrong.
fn read(document: &Document, file: &str) -> Option<Scene> {
    let (root, errors) = DeTable::parse_recoverable(document.text);
    errors.iter().for_each(|error| document.note(not_toml(document, error)));
    if root.get_ref().is_empty() && errors.is_empty() {
        let message = "the scene is empty";
        let advice = "write at least name = \"my-scene\", duration = 10.0 and a table [body], or see `polhode scene new`";
        document.note(document.fault(0..document.text.len(), "", message).advised(advice));
    }
    if !document.is_sound() {
        return None;
    }
    let whole = Table::open(document, String::new(), 0..0, root.get_ref(), KEYS);
    let name = document.keep(read_name(&whole));
    let title = document.keep(whole.optional_text("title"));
    let why = document.keep(whole.optional_text("why"));
    let duration = document.keep(whole.required("duration").and_then(|value| value.positive()));
    let not_for_order = document.keep(read_reason(&whole, "not_for_order"));
    let only_for_stability = document.keep(read_reason(&whole, "only_for_stability"));
    let system = read_system(&whole);
    let name = name?;
    Some(Scene {
        title: title?.unwrap_or(&name).to_owned(),
        why: why?.unwrap_or_default().to_owned(),
        duration: duration?,
        not_for_order: not_for_order?,
        only_for_stability: only_for_stability?,
        built_in: false,
        file: file.to_owned(),
        text: document.text.to_owned(),
        system: system?,
        name,
    })
}

fn not_toml(document: &Document, error: &toml::de::Error) -> Fault {
    let span = error.span().unwrap_or(0..0);
    let quoted = document.quoted(span.clone());
    let fault = document.fault(span, "", format!("not TOML: {}", error.message()));
    match quoted {
        Some(text) => fault.advised(format!("write {text}")).replaced(text),
        None => fault.advised("write key = value lines and [table] headers, and texts in quotes"),
    }
}

fn read_name(whole: &Table) -> Result<String, Fault> {
    let value = whole.required("name")?;
    let name = value.text()?;
    let word = |part: &str| {
        !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
    };
    // The name becomes part of file names.
    if name.len() <= 100 && name.split('-').all(word) {
        return Ok(name.to_owned());
    }
    let what = "a name in kebab-case, lower-case words and digits joined by '-', 100 letters at most";
    let instead = format!("\"{}\"", wording::kebab(name));
    Err(value.expected(what).advised(format!("write name = {instead}")).replaced(instead))
}

fn read_reason(whole: &Table, key: &'static str) -> Result<Option<String>, Fault> {
    let Some(value) = whole.get(key) else { return Ok(None) };
    match value.text()?.trim() {
        "" => Err(value.expected("the reason in words")),
        reason => Ok(Some(reason.to_owned())),
    }
}

fn read_system(whole: &Table) -> Option<System> {
    let document = whole.document();
    let given = document.keep(whole.required("body")).and_then(|entry| body::read(&entry));
    let entries = match whole.get("forces") {
        Some(forces) => document.keep(forces.list("a list of laws"))?,
        None => Vec::new(),
    };
    let origin = given.as_ref().map_or_else(Vector3::zeros, |given| given.origin);
    let laws: Vec<_> = entries.iter().map(|entry| laws::read(entry, &origin)).collect();
    let stated = match whole.get("initial") {
        Some(value) => document.keep(value.table(start::KEYS)).and_then(|table| start::read(Some(table))),
        None => start::read(None),
    };
    let laws = laws.into_iter().collect::<Option<Vec<_>>>()?;
    start::system(given?, &stated?, laws, &entries, whole)
}
