//! What build servers and the terminal are told.

use polhode::internals::report;
use polhode::record::Ruling;

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
    let text = report::annotations(&few(&[8, 9]));
    assert_eq!(text.lines().filter(|line| line.starts_with("::error ")).count(), 3);
    assert_eq!(text.lines().filter(|line| line.starts_with("::warning ")).count(), 2);
    assert_eq!(text.lines().filter(|line| line.starts_with("::notice ")).count(), 3);
    assert!(text.contains("100 %25 wrong,%0Asee"));
    assert!(text.contains("title=fail%3A peskin-rk2 on scene-09%3A order::"));
    assert_eq!(text.lines().count(), 8);
}

#[test]
fn the_terminal_table_fits_100_columns_and_ends_with_a_summary() {
    let records = few(&[3, 8, 9]);
    for verbose in [false, true] {
        let text = report::verdict_table(&records, verbose);
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
        assert!(text.trim_end().ends_with("not applicable"), "{text}");
        assert!(text.contains("known since 2021") && text.contains("slopes do not settle"), "{text}");
    }
    let brief = report::verdict_table(&records, false).lines().count();
    assert!(brief < report::verdict_table(&records, true).lines().count());
}
