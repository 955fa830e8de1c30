//! A slow engine under a budget of time: fewer runs, and what stays undecided for that is named.

use serde_json::Value;

use crate::common::program::{code, polhode, stderr};
use crate::stage::{Stage, example};

/// An engine that takes so many milliseconds a step, and the steps of its runs in `asked`.
fn engine(stage: &Stage, milliseconds: u32) -> String {
    stage.script(&format!(
        r#"while read -r line; do
            case $line in *'"ask":"run"'*)
                steps=${{line##*'"steps":'}}
                steps=${{steps%%[!0-9]*}}
                echo "$steps" >> "$here/asked"
                time=$((steps * {milliseconds}))
                sleep "$((time / 1000)).$(printf %03d $((time % 1000)))"
            esac
            echo "$line"
        done | '{}'"#,
        example()
    ))
}

/// The exit code of a gate in one scene, its verdicts, and the steps that it asks for.
fn gate(milliseconds: u32, more: &[&str]) -> (i32, Vec<Value>, u64) {
    let stage = Stage::new();
    let scheme = engine(&stage, milliseconds);
    let records = stage.path("now.json");
    let records = records.to_string_lossy();
    let gate = ["gate", "free-asymmetric", "--quiet", "--jobs", "1", "--scheme", &scheme, "--json", &records];
    let output = polhode(&[&gate[..], more].concat());
    let text =
        std::fs::read_to_string(&*records).unwrap_or_else(|error| panic!("{error}: {}", stderr(&output)));
    let now: Value = serde_json::from_str(&text).expect("JSON");
    let steps = stage.text("asked").lines().map(|line| line.parse::<u64>().expect("a number")).sum();
    (code(&output), now["verdicts"].as_array().expect("verdicts").clone(), steps)
}

fn of_budget(verdicts: &[Value]) -> Vec<&Value> {
    verdicts.iter().filter(|verdict| verdict["claim"] == "budget").collect()
}

#[test]
fn a_budget_cuts_the_runs_of_a_slow_engine_and_not_those_of_a_fast_one() {
    let (exit, verdicts, all) = gate(0, &[]);
    assert!(exit == 0 && of_budget(&verdicts).is_empty(), "{verdicts:?}");
    let (exit, verdicts, enough) = gate(0, &["--budget", "1e6"]);
    assert!(exit == 0 && of_budget(&verdicts).is_empty() && enough >= all, "{verdicts:?}");
    // The estimate takes half a second, far longer than the delays of a busy machine; all runs would take a minute and more.
    let (exit, verdicts, few) = gate(20, &["--budget", "4"]);
    let budget = of_budget(&verdicts);
    assert_eq!(budget.len(), 1, "{verdicts:?}");
    let open = budget[0]["verdict"] == "inconclusive";
    assert_eq!(exit, if open { 2 } else { 0 }, "{verdicts:?}");
    assert!(few < all, "{few} of {all}");
}

#[test]
fn a_budget_of_nothing_leaves_everything_undecided_and_says_so() {
    let (exit, verdicts, steps) = gate(0, &["--budget", "1e-9"]);
    assert_eq!(exit, 2, "{verdicts:?}");
    let budget = of_budget(&verdicts);
    assert_eq!((budget.len(), &budget[0]["verdict"]), (1, &Value::from("inconclusive")), "{verdicts:?}");
    assert!(budget[0]["measured"].as_f64().expect("seconds") > 0.0);
    // Those of the estimate.
    assert!(steps <= 34, "{steps}");
    assert_eq!(code(&polhode(&["gate", "free-rod", "--budget", "0"])), 64);
}
