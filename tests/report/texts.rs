//! What build servers and the terminal are told.

use polhode::internals::report;
use polhode::record::{ClaimName, Ruling, Verdict};

use super::synthetic::few;

#[test]
fn junit_tells_the_six_outcomes_apart() {
    let xml = report::junit(&few(&[3, 8, 9]));
    assert!(xml.contains("<testsuite name=\"scene-09\""));
    assert!(xml.contains("name=\"peskin-rk2: order: orientation\""));
    assert!(xml.contains("<failure message=\"order 2.00 ± 0.01 outside 1 ± 0.15"));
    assert!(xml.contains("<skipped message=\"inconclusive: slopes"));
    assert!(xml.contains("<skipped message=\"not applicable: exact"));
    assert!(xml.contains("<skipped message=\"known deviation: known since 2021"));
    let mut broken = few(&[3]);
    broken.verdicts[0].verdict = Ruling::Broken;
    broken.verdicts[0].detail = "a < b & \"c\"\u{0}".into();
    let xml = report::junit(&broken);
    assert!(xml.contains("<error message=\"a &lt; b &amp; &quot;c&quot;\""), "{xml}");
}

#[test]
fn annotations_cannot_be_broken_by_their_text() {
    let mut records = few(&[8, 9]);
    records.scenes[1].file = "scenes/a,b:c.toml".into();
    let text = report::annotations(&records);
    let of = |level: &str| text.lines().filter(|line| line.starts_with(&format!("::{level} "))).count();
    // One for each scheme in each scene.
    let mut places: Vec<(&str, &str)> = records
        .verdicts
        .iter()
        .filter(|v| !matches!(v.verdict, Ruling::Pass | Ruling::NotApplicable))
        .map(|v| (v.scene.as_str(), v.scheme.as_str()))
        .collect();
    places.sort_unstable();
    places.dedup();
    assert_eq!(text.lines().count(), places.len(), "{text}");
    assert_eq!(of("error") + of("warning") + of("notice"), places.len());
    assert!(of("error") > 0);
    assert!(text.contains(" file=scenes/a%2Cb%3Ac.toml,line=1,title=fail%3A "), "{text}");
}

#[test]
fn a_junit_failure_has_a_body() {
    let xml = report::junit(&few(&[3, 8, 9]));
    let body = xml.split("<failure ").nth(1).expect("a failure").split("</failure>").next().expect("an end");
    assert!(body.contains("rule: order") && body.contains("quantity: "), "{body}");
}

#[test]
fn a_summary_has_what_got_worse_first() {
    let mut records = few(&[3, 8, 9]);
    let markdown = report::step_summary(&records);
    assert!(!markdown.contains("### Worse than on record") && markdown.contains("### Fails"));
    let fail = records.verdicts.iter().position(|v| v.verdict == Ruling::Fail).expect("a failure");
    records.verdicts[fail].claim = ClaimName::OrderOnRecord;
    let markdown = report::step_summary(&records);
    let titles: Vec<&str> = markdown.lines().filter(|line| line.starts_with("### ")).collect();
    assert_eq!(titles[0], "### Worse than on record", "{markdown}");
    let columns = |line: &str| line.replace("\\|", "").matches('|').count();
    let rows = markdown.lines().filter(|line| line.starts_with('|'));
    assert!(
        rows.clone().count() > 3 && rows.into_iter().all(|row| [3, 4].contains(&columns(row))),
        "{markdown}"
    );
}

#[test]
fn a_green_gate_is_a_line_a_scheme_and_a_summary() {
    let mut records = few(&[3, 8, 9]);
    records.verdicts.retain(|verdict| verdict.verdict == Ruling::Pass || verdict.known_deviation.is_some());
    let text = report::verdict_table(&records, false);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 4, "{text}");
    assert!(lines[0].starts_with("peskin-rk2  pass") && lines[1].starts_with("euler       pass"), "{text}");
    assert!(lines[0].contains(" 2 scenes: ") && lines[3].contains(" verdicts: "), "{text}");
    assert!(lines.iter().all(|line| line.chars().count() <= 100), "{text}");
}

#[test]
fn what_is_red_is_one_line_a_scheme_and_scene_with_the_size_first() {
    let records = few(&[3, 8, 9]);
    let text = report::verdict_table(&records, false);
    let red: Vec<&str> = text.lines().filter(|line| line.contains(" in scene-")).collect();
    let mut places: Vec<(&str, &str)> = records
        .verdicts
        .iter()
        .filter(|v| !matches!(v.verdict, Ruling::Pass | Ruling::NotApplicable) && v.known_deviation.is_none())
        .map(|v| (v.scene.as_str(), v.scheme.as_str()))
        .collect();
    places.sort_unstable();
    places.dedup();
    assert_eq!(red.len(), places.len(), "{text}");
    for (scene, scheme) in places {
        let place = format!("{scheme} in {scene}: ");
        let own: Vec<&&str> = red.iter().filter(|line| line.contains(&place)).collect();
        assert_eq!(own.len(), 1, "{text}");
    }
    let order = red.iter().find(|line| line.starts_with("fail: ")).expect("a failure");
    let (size, rule) = (order.find(" off by ").expect("a size"), order.find("order, ").expect("a rule"));
    assert!(size < rule && order.contains(" at h = "), "{order}");
    assert!(text.trim_end().ends_with("not applicable"), "{text}");
    assert!(!text.contains("known since 2021"), "{text}");
}

#[test]
fn verbose_gives_a_scheme_in_a_scene_at_most_ten_lines() {
    let mut records = few(&[3, 8, 9]);
    assert!(report::verdict_table(&records, true).contains("(known: known since 2021"));
    let pattern = records.verdicts[0].clone();
    for claim in ClaimName::ALL {
        records.verdicts.push(Verdict { claim, ..pattern.clone() });
    }
    let text = report::verdict_table(&records, true);
    let place = format!("{} in {}: ", pattern.scheme, pattern.scene);
    let block = text.split("\n\n").find(|block| block.starts_with(&place)).expect("a block");
    assert_eq!(block.lines().count(), 10, "{block}");
    assert!(text.split("\n\n").all(|block| !block.contains("\n  ") || block.lines().count() <= 10), "{text}");
}
