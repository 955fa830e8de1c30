//! The published report: a page that a repository shows, of the main schemes, whose verdicts are green.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::gates;
use polhode::record::Verdict;
use polhode::schemes;
use serde_json::Value;

const HOW: &str =
    "make it anew with `polhode report --from reports/latest/records.json --brief --out reports/published`";

fn published(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/published").join(name)
}

#[test]
fn the_published_verdicts_are_of_the_main_schemes_and_green() {
    let text = fs::read_to_string(published("verdicts.json")).expect("verdicts");
    let whole: Value = serde_json::from_str(&text).expect("JSON");
    let verdicts: Vec<Verdict> = serde_json::from_value(whole["verdicts"].clone()).expect("verdicts");
    assert_eq!(gates::exit_code(&verdicts), 0, "{HOW}");
    for scheme in schemes::MAIN {
        assert!(verdicts.iter().filter(|verdict| verdict.scheme == scheme).count() > 100, "{scheme}: {HOW}");
    }
    let built_in = polhode::scenes::built_in();
    // Where every verdict is "not applicable" the published file has none.
    for scene in built_in.iter().filter(|scene| scene.only_for_stability.is_none()) {
        assert!(verdicts.iter().any(|verdict| verdict.scene == scene.name), "{}: {HOW}", scene.name);
    }
}

#[test]
fn the_published_page_is_short_and_its_links_exist() {
    let text = fs::read_to_string(published("report.md")).expect("a page");
    assert!(text.len() <= 200_000 && text.lines().count() <= 250, "{} lines: {HOW}", text.lines().count());
    let links: Vec<&str> = text.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert!(links.iter().all(|link| published(link).is_file()), "{links:?}: {HOW}");
    assert!(
        links.iter().any(|link| link.ends_with(".png")) && links.iter().any(|link| link.ends_with(".csv"))
    );
}

#[test]
fn the_published_report_is_smaller_than_4_megabytes() {
    fn size(path: &Path) -> u64 {
        std::fs::read_dir(path)
            .expect("a folder")
            .map(|entry| entry.expect("an entry"))
            .map(|entry| {
                if entry.path().is_dir() {
                    size(&entry.path())
                } else {
                    entry.metadata().expect("size").len()
                }
            })
            .sum()
    }
    assert!(size(&published("")) < 4_000_000);
}
