//! The pages of a report: what each holds, how large it is, and that every link leads somewhere.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use super::synthetic::{few, synthetic};
use miniz_oxide::deflate::compress_to_vec_zlib;
use polhode::internals::report;
use polhode::record::{Motion, Records, SchemeRow, Verdict};

/// Bytes of a page at most, without script and style.
const PAGE: usize = 1_000_000;
/// Bytes of the index at most, compressed.
const PACKED_INDEX: usize = 300_000;
/// Elements of the index at most.
const NODES: usize = 3000;
/// Bytes of a single page with everything in it, at most.
const SINGLE: usize = 8_000_000;
/// Bytes of all pages, script and style at most.
const PAGES: u64 = 8_000_000;

type Pages = BTreeMap<String, String>;

/// The pages of a report, by their paths.
fn pages(records: &Records) -> (tempfile::TempDir, Pages) {
    let folder = tempfile::tempdir().expect("a folder");
    report::write(records, folder.path(), &|_, _| ()).expect("a report");
    let mut pages = Pages::new();
    let inner = fs::read_dir(folder.path().join("pages")).expect("a folder");
    let inner =
        inner.map(|entry| format!("pages/{}", entry.expect("an entry").file_name().to_string_lossy()));
    for name in inner.chain(["index.html".to_owned()]) {
        let text = fs::read_to_string(folder.path().join(&name)).expect("a page");
        pages.insert(name, text);
    }
    (folder, pages)
}

/// Records of the size of the default report: twelve schemes in thirty scenes, and a motion.
fn whole() -> Records {
    let mut records = synthetic();
    let (schemes, rows) = (records.schemes.clone(), records.clone());
    for copy in 1..6 {
        let named = |name: &str| format!("{name}-{copy}");
        records.schemes.extend(schemes.iter().map(|row| SchemeRow { name: named(&row.name), ..row.clone() }));
        for row in &rows.measurements {
            let mut row = (**row).clone();
            row.scheme = named(&row.scheme);
            records.measurements.push(Arc::new(row));
        }
        records
            .verdicts
            .extend(rows.verdicts.iter().map(|row| Verdict { scheme: named(&row.scheme), ..row.clone() }));
        for row in &rows.series {
            let mut row = (**row).clone();
            row.scheme = named(&row.scheme);
            records.series.push(Arc::new(row));
        }
    }
    records.motions = records.scenes.iter().flat_map(|scene| motions(&scene.name)).collect();
    records
}

/// A body that turns about an axis that wanders: a truth, and three schemes at three steps.
fn motions(scene: &str) -> Vec<Arc<Motion>> {
    let row = |scheme: &str, step_s: f64| {
        let turn = (0..=256).flat_map(|n| {
            let (s, c) = (0.1 * f64::from(n) * (1.0 + step_s)).sin_cos();
            [c, 0.6 * s, 0.0, 0.8 * s]
        });
        let spin = (0..=256).flat_map(|n| [0.1, (0.05 * f64::from(n)).sin(), 2.0]);
        Arc::new(Motion {
            scene: scene.into(),
            scheme: scheme.into(),
            step_s,
            moments: [1.0, 2.0, 2.5],
            time_s: (0..=256).map(|n| f64::from(n) / 32.0).collect(),
            turn: turn.collect(),
            spin: spin.collect(),
        })
    };
    let runs = ["peskin-rk2", "euler", "euler-1"]
        .into_iter()
        .flat_map(|scheme| [0.04, 0.01, 0.0025].into_iter().map(move |step| (scheme, step)));
    [("", 0.0)].into_iter().chain(runs).map(|(scheme, step)| row(scheme, step)).collect()
}

/// Elements of a page: tags that open.
fn elements(page: &str) -> usize {
    page.match_indices('<')
        .filter(|(at, _)| page[at + 1..].starts_with(|c: char| c.is_ascii_alphabetic()))
        .count()
}

fn size(path: &Path) -> u64 {
    let entries = fs::read_dir(path).expect("a folder").map(|entry| entry.expect("an entry").path());
    entries
        .map(|path| if path.is_dir() { size(&path) } else { fs::metadata(&path).expect("a file").len() })
        .sum()
}

#[test]
fn pages_keep_their_budgets() {
    let records = whole();
    let (folder, pages) = pages(&records);
    for (name, page) in &pages {
        assert!(page.len() < PAGE, "{name}: {} bytes", page.len());
    }
    let index = &pages["index.html"];
    assert!(elements(index) < NODES, "{} elements", elements(index));
    let packed = compress_to_vec_zlib(index.as_bytes(), 6).len();
    assert!(packed < PACKED_INDEX, "{packed} bytes");
    let beside: u64 = ["index.html", "report.js", "report.css"]
        .iter()
        .map(|name| fs::metadata(folder.path().join(name)).expect("a file").len())
        .sum();
    let all = size(&folder.path().join("pages")) + beside;
    assert!(all < PAGES, "{all} bytes");
    let single = tempfile::tempdir().expect("a folder");
    report::write_single_file(&records, single.path(), &|_, _| ()).expect("a page");
    let page = fs::read_to_string(single.path().join("index.html")).expect("a page");
    assert!(page.len() < SINGLE, "{} bytes", page.len());
    assert!(!single.path().join("report.js").exists());
}

#[test]
fn pages_need_nothing_from_elsewhere_and_escape_what_they_print() {
    let (_folder, pages) = pages(&few(&[4, 9]));
    for (name, page) in &pages {
        for foreign in ["url(", "@import", "src=\"http", "href=\"http", "src=\"//"] {
            assert!(!page.contains(foreign), "{name}: {foreign}");
        }
        assert!(!page.contains("<turned>"), "{name}");
    }
    assert!(pages["pages/scene-scene-09.html"].contains("&lt;turned&gt;"));
    assert!(!pages["index.html"].contains("role=\"alert\""));
}

#[test]
fn every_link_and_picture_of_a_page_is_there() {
    let (folder, pages) = pages(&few(&[1, 9]));
    let mut links = 0;
    for (name, page) in &pages {
        let here = folder.path().join(name);
        let here = here.parent().expect("a folder");
        for part in page.split(" href=\"").skip(1).chain(page.split(" src=\"").skip(1)) {
            let link = part.split('"').next().expect("an end");
            if !link.starts_with(['#']) && !link.starts_with("data:") {
                assert!(here.join(link).exists(), "{name}: {link}");
                links += 1;
            }
        }
    }
    assert!(links > 100, "{links}");
}

#[test]
fn the_index_says_five_findings_and_a_row_a_reason() {
    let mut records = few(&[1, 2, 9]);
    records.verdicts.extend((0..50).map(|n| Verdict {
        scene: "scene-01".into(),
        scheme: "euler".into(),
        verdict: polhode::record::Ruling::Fail,
        detail: format!("error {n}.5 above 0.1"),
        ..Verdict::default()
    }));
    let (_folder, pages) = pages(&records);
    let index = &pages["index.html"];
    let findings = index.split("class=\"findings\"").nth(1).expect("findings");
    let findings = findings.split("</ol>").next().expect("an end").matches("<li>").count();
    // The records hold no evidence, and so no constant in radians.
    assert_eq!(findings, 4);
    let rows =
        index.split("id=\"reasons\"").nth(1).expect("reasons").split("</table>").next().expect("an end");
    assert!(rows.matches("<tr>").count() < 10);
    assert!(rows.contains("<td class=n>50"));
    let folded = &pages["pages/verdicts.html"];
    assert!(folded.matches("above 0.1").count() >= 50 && !folded.contains("<details class=\"reason\" open"));
}
