//! `polhode bless` and `polhode gate --baseline`.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::common::program::{code, polhode_in, scratch, stderr, stdout};

const SCENE: &str = "free-asymmetric";

fn bless(folder: &Path, scheme: &str, more: &[&str]) -> i32 {
    let words = ["bless", "--quiet", "--scheme", scheme, SCENE, "--reason", "a test", "--by", "me"];
    code(&polhode_in(folder, &[&words, more].concat()))
}

fn read(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect("written")).expect("JSON")
}

#[test]
fn a_baseline_says_who_made_it_and_why_and_replaces_only_its_like() {
    let folder = scratch();
    let path = folder.path().join("polhode-baseline.json");
    assert_eq!(bless(folder.path(), "peskin-rk2", &[]), 0);
    assert_eq!(bless(folder.path(), "peskin-rk2", &["--reason", "again"]), 64, "given twice");
    assert_eq!(bless(folder.path(), "peskin-rk2", &[]), 0);
    let baseline = read(&path);
    let provenance = baseline["provenance"].as_array().expect("two");
    assert_eq!(provenance.len(), 2);
    assert_eq!((&provenance[0]["who"], &provenance[0]["reason"]), (&"me".into(), &"a test".into()));
    assert_eq!(provenance[0]["version"], env!("CARGO_PKG_VERSION"));
    assert!(provenance[0]["when"].as_str().expect("a time").ends_with('Z'));
    // Records of a gate are no baseline.
    let gate = ["gate", "--quiet", "--scheme", "euler", SCENE, "--json", "now.json"];
    assert_eq!(code(&polhode_in(folder.path(), &gate)), 0);
    assert_eq!(bless(folder.path(), "euler", &["--baseline", "now.json"]), 74);
    assert!(read(&folder.path().join("now.json"))["provenance"].is_null());
    assert_eq!(bless(folder.path(), "euler", &["--baseline", "now.json", "--force"]), 0);
}

#[test]
fn a_gate_against_its_own_baseline_compares_everything() {
    let folder = scratch();
    assert_eq!(bless(folder.path(), "peskin-rk2", &[]), 0);
    let gate = ["gate", "--quiet", "--scheme", "peskin-rk2", SCENE, "--json", "now.json", "--baseline"];
    let output = polhode_in(folder.path(), &[&gate[..], &["polhode-baseline.json"]].concat());
    assert_eq!(code(&output), 0, "{}", stdout(&output));
    let verdicts = read(&folder.path().join("now.json"))["verdicts"].as_array().expect("rows").clone();
    let on_record = [
        "order-on-record",
        "constant",
        "error-on-record",
        "drift-on-record",
        "work-on-record",
        "claims-on-record",
    ];
    for claim in on_record {
        let own: Vec<&Value> = verdicts.iter().filter(|verdict| verdict["claim"] == claim).collect();
        assert!(
            !own.is_empty() && own.iter().all(|verdict| verdict["verdict"] == "pass"),
            "{claim}: {own:?}"
        );
    }
    let orders = verdicts.iter().filter(|verdict| verdict["claim"] == "constant").count();
    assert!(
        stderr(&output).contains(&format!("{orders} of {orders} constants compared")),
        "{}",
        stderr(&output)
    );
}

/// A baseline that euler's rows are found in, and that another scheme made.
fn of_another(folder: &Path, scheme: &str) {
    assert_eq!(bless(folder, scheme, &[]), 0);
    let path = folder.join("polhode-baseline.json");
    let text = fs::read_to_string(&path).expect("written").replace(&format!("\"{scheme}\""), "\"euler\"");
    fs::write(path, text).expect("written");
}

#[test]
fn a_lower_order_than_on_record_comes_first_and_no_constant_is_judged() {
    let folder = scratch();
    of_another(folder.path(), "rk4-quaternion");
    let gate = ["gate", "--quiet", "--scheme", "euler", SCENE, "--json", "now.json", "--baseline"];
    let output = polhode_in(folder.path(), &[&gate[..], &["polhode-baseline.json"]].concat());
    assert_eq!(code(&output), 1);
    let text = stdout(&output);
    let red: Vec<&str> = text.lines().filter(|line| line.starts_with("fail: ")).collect();
    assert_eq!(red.len(), 1, "{text}");
    assert!(red[0].contains(": order was 4, now 1; "), "{text}");
    let verdicts = read(&folder.path().join("now.json"))["verdicts"].as_array().expect("rows").clone();
    let of = |claim: &str| verdicts.iter().filter(|v| v["claim"] == claim).collect::<Vec<_>>();
    let fails = of("order-on-record").into_iter().filter(|verdict| verdict["verdict"] == "fail");
    for fail in fails {
        let constant = of("constant").into_iter().find(|verdict| verdict["quantity"] == fail["quantity"]);
        assert_eq!(constant.expect("a row")["verdict"], "not-applicable");
    }
    // Four evaluations a step are on record and one is measured: less work is no fault.
    assert!(of("work-on-record").iter().all(|verdict| verdict["verdict"] == "pass"));
}

#[test]
fn more_work_and_larger_errors_than_on_record_fail_and_a_tolerance_allows_them() {
    let folder = scratch();
    let path = folder.path().join("polhode-baseline.json");
    assert_eq!(bless(folder.path(), "peskin-rk2", &[]), 0);
    let mut baseline = read(&path);
    for row in baseline["orders"].as_array_mut().expect("rows") {
        if let Some(constant) = row["constant"].as_f64() {
            row["constant"] = (1.05 * constant).into();
        }
    }
    for count in baseline["evidence"][0]["ladder"]["rungs"]["evaluations"].as_array_mut().expect("runs") {
        *count = (count.as_u64().expect("a count") / 2).into();
    }
    fs::write(&path, baseline.to_string()).expect("written");
    let fails = || {
        let gate = ["gate", "--quiet", "--scheme", "peskin-rk2", SCENE, "--json", "now.json", "--baseline"];
        let output = polhode_in(folder.path(), &[&gate[..], &["polhode-baseline.json"]].concat());
        assert_eq!(code(&output), 1);
        let verdicts = read(&folder.path().join("now.json"))["verdicts"].as_array().expect("rows").clone();
        let red = verdicts.into_iter().filter(|verdict| verdict["verdict"] == "fail");
        let mut red: Vec<String> = red.map(|v| v["claim"].as_str().expect("a name").to_owned()).collect();
        red.dedup();
        red
    };
    assert!(fails().contains(&"constant".to_owned()) && fails().contains(&"work-on-record".to_owned()));
    let settings = "[[tolerances]]\nconstant = 0.1\n[[tolerances]]\nscene = \"free-rod\"\nconstant = 1e-9\n";
    fs::write(folder.path().join("polhode.toml"), settings).expect("written");
    assert_eq!(fails(), ["work-on-record"]);
}
