//! A whole report of thirty scenes, made from records that no campaign wrote.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use polhode::internals::report;
use polhode::record::Records;

use super::synthetic::{SCENES, synthetic};
use crate::common::plots;

/// Width and height from the header of a PNG.
fn png_size(path: &Path) -> (u32, u32) {
    let bytes = fs::read(path).expect("a file of the test itself");
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n", "{}", path.display());
    assert_eq!(&bytes[bytes.len() - 8..bytes.len() - 4], b"IEND", "{}", path.display());
    let number =
        |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("a file of the test itself"));
    (number(16), number(20))
}

#[test]
fn a_whole_report_has_every_file_and_every_picture_is_large() {
    let records = synthetic();
    // A folder that stays, for those who want to look at the pictures.
    let folder = match std::env::var_os("POLHODE_REPORT_OUT") {
        Some(path) => PathBuf::from(path),
        None => tempfile::tempdir().expect("a file of the test itself").keep(),
    };
    let calls = AtomicUsize::new(0);
    let count = |_, _| {
        calls.fetch_add(1, Ordering::Relaxed);
    };
    report::write(&records, &folder, &count).expect("a file of the test itself");
    for name in ["records.json", "records.csv", "report.md", "index.html"] {
        assert!(fs::metadata(folder.join(name)).expect("a file of the test itself").len() > 1000, "{name}");
    }
    let read = Records::read(&folder.join("records.json")).expect("a file of the test itself");
    assert_eq!(read.measurements.len(), records.measurements.len());
    assert!(read.verdicts.iter().map(|row| &row.detail).eq(records.verdicts.iter().map(|row| &row.detail)));
    let plots = plots(&folder);
    // Convergence, invariants and up to two of work and precision a scene, and six of all of them, one of them in two widths.
    assert!((3 * SCENES..=4 * SCENES + 6).contains(&plots.len()), "{}", plots.len());
    assert_eq!(calls.load(Ordering::Relaxed), 4 * SCENES + 8);
    for path in plots {
        let (width, height) = png_size(&path);
        // One picture is for the screens of telephones.
        let least = if path.ends_with("overview-narrow.png") { 480 } else { 1100 };
        assert!(width >= least && height >= 480, "{}: {width} × {height}", path.display());
    }
    if std::env::var_os("POLHODE_REPORT_OUT").is_none() {
        fs::remove_dir_all(folder).expect("a file of the test itself");
    }
}
