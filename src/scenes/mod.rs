//! The list of scenes and their file format: a TOML file, read into a checked [`System`].
//!
//! Every value keeps the place it was read at, so that whatever is wrong, here or in the model, is told with
//! file, line and full key, and with what to write instead. The built-in scenes are files in the same format,
//! in `references/scenes`.

mod body;
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

pub use error::SceneError;
pub use laws::block;
pub use list::FILES;
pub use schema::schema;
pub(crate) use schema::to_json;
#[cfg(feature = "cli")]
pub(crate) use wording::{one_of, three_nearest};

use crate::bounded::{self, FileError};
use crate::model::System;
use table::Table;
use value::{Document, Value};

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
    /// The body under its forces, ready to be stepped.
    pub system: System,
}

impl Scene {
    /// Reads the text of a scene file; `file` is its name in error messages.
    ///
    /// # Errors
    /// [`SceneError::Content`].
    pub fn parse(text: &str, file: &str) -> Result<Scene, SceneError> {
        let document = Document { file, text };
        let root = DeTable::parse(text).map_err(|error| not_toml(&document, &error))?;
        if root.get_ref().is_empty() {
            let message = "the scene is empty: write at least name = \"my-scene\", duration = 10.0 and a table \
                           [body]";
            return Err(document.refuse(0, "", message));
        }
        let whole = Table::open(&document, String::new(), 0, root.get_ref(), KEYS)?;
        let name = read_name(&whole)?;
        Ok(Scene {
            title: whole.optional_text("title")?.unwrap_or(&name).to_string(),
            why: whole.optional_text("why")?.unwrap_or_default().to_string(),
            duration: whole.required("duration")?.positive()?,
            not_for_order: read_reason(&whole, "not_for_order")?,
            only_for_stability: read_reason(&whole, "only_for_stability")?,
            built_in: false,
            file: file.to_string(),
            system: read_system(&whole)?,
            name,
        })
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
                SceneError::Content { file, line, key: String::new(), message: why }
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

fn not_toml(document: &Document, error: &toml::de::Error) -> SceneError {
    let start = error.span().map_or(0, |span| span.start);
    let message = format!("not TOML: {}; write key = value lines and [table] headers", error.message());
    document.refuse(start, "", message)
}

fn read_name(whole: &Table) -> Result<String, SceneError> {
    let value = whole.required("name")?;
    let name = value.text()?;
    let word = |part: &str| {
        !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
    };
    // The name becomes part of file names.
    if name.len() <= 100 && name.split('-').all(word) {
        return Ok(name.to_string());
    }
    Err(value
        .expected("a name in kebab-case, lower-case words and digits joined by '-', 100 letters at most"))
}

fn read_reason(whole: &Table, key: &'static str) -> Result<Option<String>, SceneError> {
    let Some(value) = whole.get(key) else { return Ok(None) };
    match value.text()?.trim() {
        "" => Err(value.expected("the reason in words")),
        reason => Ok(Some(reason.to_string())),
    }
}

fn read_system(whole: &Table) -> Result<System, SceneError> {
    let given = body::read(&whole.required("body")?)?;
    let entries = match whole.get("forces") {
        Some(forces) => forces.list("a list of laws")?,
        None => Vec::new(),
    };
    let laws = entries.iter().map(|entry| laws::read(entry, &given.origin)).collect::<Result<_, _>>()?;
    let initial = whole.get("initial").map(|value: Value| value.table(start::KEYS)).transpose()?;
    start::system(given, initial.as_ref(), laws, &entries, whole)
}
