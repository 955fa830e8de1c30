//! The published report says what the code now gives.

use std::collections::BTreeMap;
use std::path::Path;

use polhode::campaign::Campaign;
use polhode::gates;
use polhode::record::{ClaimName, Records, Ruling};
use polhode::scenes;
use polhode::simulate::Contestant;

type Rulings = BTreeMap<(String, String, ClaimName, String), (Ruling, bool)>;

fn rulings(records: &Records) -> Rulings {
    let key = |v: &polhode::record::Verdict| (v.scene.clone(), v.scheme.clone(), v.claim, v.quantity.clone());
    records.verdicts.iter().map(|v| (key(v), (v.verdict, v.known_deviation.is_some()))).collect()
}

#[test]
fn the_verdicts_of_the_published_report_are_those_that_the_code_gives() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/published/records.json");
    let published = Records::read(&path).expect("a records file");
    let reported = |c: &Contestant| published.schemes.iter().any(|row| row.name == c.card.name);
    let contestants: Vec<Contestant> = Contestant::all().into_iter().filter(reported).collect();
    assert!(contestants.len() >= 2);
    let now = Campaign::of(scenes::built_in(), contestants).run();
    assert_eq!(gates::exit_code(&now.verdicts), 0);
    let (published, now) = (rulings(&published), rulings(&now));
    let differences: Vec<_> = published
        .iter()
        .filter(|(key, ruling)| now.get(key) != Some(ruling))
        .chain(now.iter().filter(|(key, _)| !published.contains_key(key)))
        .collect();
    let how = "make it anew with `polhode report --brief --scheme peskin-rk2 --scheme euler --out reports/published`";
    assert!(differences.is_empty(), "{differences:#?}\n{how}");
    assert!(published.len() > 1000);
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
