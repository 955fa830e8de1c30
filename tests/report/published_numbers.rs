//! The figures that others published, computed again: a digit that moves fails here.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use polhode::internals::report::{self, write_published};
use polhode::internals::study::published::{SCENES, rows_of};
use polhode::record::{PublishedRow, Records, SCHEMA};

/// From the file itself, so that an edit of the figures needs no build.
static ROWS: LazyLock<Vec<PublishedRow>> = LazyLock::new(|| {
    let figures = fs::read_to_string(references().join("published/figures.toml")).expect("the figures");
    rows_of(&figures).expect("figures, scenes and their truth")
});

fn references() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("references")
}

#[test]
fn no_digit_of_a_published_figure_moves() {
    let moved: Vec<String> = ROWS
        .iter()
        .filter(|row| !row.moved().is_empty())
        .map(|row| {
            let PublishedRow { problem, quantity, by, ours, computed, .. } = row;
            format!("{problem} | {quantity} | {by}: {ours:?} is now {computed:?}")
        })
        .collect();
    assert!(moved.is_empty(), "{} figures moved:\n{}", moved.len(), moved.join("\n"));
    assert!(ROWS.len() > 140, "{} figures", ROWS.len());
}

#[test]
fn the_differences_bear_out_every_verdict() {
    let wrong = |row: &&PublishedRow| !row.holds();
    let wrong: Vec<_> = ROWS
        .iter()
        .filter(wrong)
        .map(|row| (&row.quantity, &row.by, &row.agreement, &row.difference, &row.held_to))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_scene_beside_the_figures_is_used_and_has_its_own_name() {
    let used: BTreeSet<&str> = ROWS.iter().map(|row| row.scene.as_str()).collect();
    let files: BTreeSet<String> = fs::read_dir(references().join("published"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("a name"))
        .filter(|name| name != "figures.toml")
        .collect();
    let listed: BTreeSet<String> = SCENES.iter().map(|(name, _)| format!("{name}.toml")).collect();
    assert_eq!(files, listed);
    assert!(SCENES.iter().all(|(name, _)| used.contains(name)));
}

#[test]
fn the_page_of_published_numbers_is_what_the_figures_give() {
    let mut page = Vec::new();
    write_published(&ROWS, &mut page).expect("a page");
    let path = references().join("PUBLISHED.md");
    if std::env::var_os("POLHODE_WRITE_PUBLISHED").is_some() {
        fs::write(&path, &page).expect("written");
    }
    let stored = fs::read(&path).unwrap_or_default();
    assert!(
        stored == page,
        "make it anew: POLHODE_WRITE_PUBLISHED=1 cargo test --release --test report published_numbers"
    );
}

#[test]
fn a_report_of_records_with_published_figures_has_them_all() {
    let records = Records { schema: SCHEMA.to_owned(), published: ROWS.clone(), ..Records::default() };
    let folder = tempfile::tempdir().expect("a folder");
    report::write(&records, folder.path(), &|_, _| ()).expect("a report");
    let read = Records::read(&folder.path().join("records.json")).expect("records");
    assert_eq!(read.published.len(), ROWS.len());
    let page = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a page");
    let text = page("pages/published.html");
    assert!(ROWS.iter().all(|row| text.contains(&row.published.join(", "))));
    assert!(page("report.md").contains("](pages/published.html)"));
}
