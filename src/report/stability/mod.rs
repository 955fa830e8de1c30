//! A study of stability for the terminal and as a page: its records, drawn and written out.

mod page;
mod table;

use std::path::Path;

use crate::record::stability::{Map, Stability};
use crate::record::write_whole;

use super::ReportError;

pub use table::table;

/// Writes `stability.json`, `stability.md` and the pictures into a folder.
///
/// # Errors
/// A file cannot be written, or a picture cannot be made.
pub fn write(study: &Stability, out: &Path) -> Result<(), ReportError> {
    write_whole(&out.join("stability.json"), study.to_json().as_bytes())?;
    write_whole(&out.join("stability.md"), page::compose(study).as_bytes())?;
    Ok(())
}

/// Name of the picture of a map, without its ending.
fn map_file(map: &Map) -> String {
    format!("{}-{}", map.name, map.scheme)
}
