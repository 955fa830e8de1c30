//! A study of stability for the terminal and as a page: its records, drawn and written out.

mod page;
mod pictures;
mod table;

use std::path::Path;

use rayon::prelude::*;

use crate::record::stability::{Map, Stability};
use crate::record::{write_json, write_whole};

use super::folder::Folder;
use super::{ReportError, plot};

pub(super) use pictures::side_by_side;
pub use table::table;

/// Writes `stability.json`, `stability.md` and, where they are wanted, the pictures into a folder.
///
/// # Errors
/// A file cannot be written, or a picture cannot be made.
pub fn write(study: &Stability, out: &Path, pictures: bool) -> Result<(), ReportError> {
    let fault = |path: &Path, why: String| ReportError::Picture { path: path.into(), why };
    let maps: &[Map] = if pictures { &study.maps } else { &[] };
    let curves = match pictures {
        true => plot::stability::pictures(study).map_err(|plot::Fault(why)| fault(out, why))?,
        false => Vec::new(),
    };
    let names = maps.iter().map(|map| format!("maps/{}.png", map_file(map)));
    let files = ["stability.json", "stability.md"].map(str::to_owned).into_iter();
    let files = files.chain(curves.iter().map(|(name, _)| (*name).to_owned())).chain(names).collect();
    let folder = Folder::open(out, "stability.json")?;
    folder.begin(&files)?;
    write_json(&out.join("stability.json"), study)?;
    write_whole(&out.join("stability.md"), page::compose(study).as_bytes())?;
    for (name, png) in curves {
        write_whole(&out.join(name), &png)?;
    }
    maps.par_iter().try_for_each(|map| {
        let path = out.join("maps").join(format!("{}.png", map_file(map)));
        let png = pictures::heat_map(map).png().map_err(|error| fault(&path, error.to_string()))?;
        write_whole(&path, &png).map_err(ReportError::File)
    })?;
    Ok(folder.finish(&files)?)
}

/// Name of the picture of a map, without its ending.
fn map_file(map: &Map) -> String {
    format!("{}-{}", map.name, map.scheme)
}
