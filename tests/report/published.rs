//! The verdicts of the published report follow from its evidence.

use std::path::Path;

use polhode::gates::{self, Baseline};
use polhode::record::Records;

#[test]
fn the_verdicts_of_the_published_report_are_those_of_its_evidence() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/published/records.json");
    let published = Records::read(&path).expect("a records file");
    let now = gates::judge_all(&published, &Baseline::built_in());
    assert_eq!(gates::exit_code(&now), 0);
    let how = "make it anew with `polhode report --brief --scheme peskin-rk2 --scheme euler --out reports/published`";
    let differs = now.iter().find(|verdict| !published.verdicts.contains(verdict));
    assert_eq!(differs, None, "{how}");
    assert_eq!(now.len(), published.verdicts.len(), "{how}");
    assert!(now.len() > 1000);
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
    assert!(size(&Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/published")) < 4_000_000);
}
