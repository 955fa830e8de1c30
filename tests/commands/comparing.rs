//! `polhode compare` from outside, and schemes in equal parts of a step.

use polhode::simulate::{Contestant, Form, Plan};
use serde_json::Value;

use crate::common::program::{code, polhode, scratch, stdout};
use crate::common::{contestant, scene};

/// Exit code and rows of a comparison of two schemes in a scene.
fn compare(a: &str, b: &str, scene: &str) -> (i32, Vec<String>) {
    let output = polhode(&["compare", a, b, "--quiet", "--all", "--format", "csv", "--scene", scene]);
    (code(&output), stdout(&output).lines().map(str::to_owned).collect())
}

fn row<'a>(rows: &'a [String], scene: &str, quantity: &str) -> &'a str {
    rows.iter().find(|row| row.starts_with(scene) && row.contains(quantity)).expect("a row")
}

#[test]
fn constants_drifts_and_costs_are_printed_with_their_ratios() {
    let (code, rows) = compare("peskin-rk2", "peskin-heun", "free-asymmetric");
    assert_eq!(code, 1);
    // 3.117 times the constant at as many evaluations, and 5.5 times the drift, both measured.
    let orientation = row(&rows, "free-asymmetric", "orientation");
    assert!(orientation.contains("3.11") && orientation.contains("worse"), "{orientation}");
    let drift = row(&rows, "free-asymmetric", "drift: rotational-energy");
    assert!(
        drift.contains("secular, h^3.00") && drift.contains("5.49") && drift.contains("worse"),
        "{drift}"
    );
    let cost = row(&rows, "free-asymmetric", "cost: evaluations a step");
    assert!(cost.contains("2.00") && cost.contains("same"), "{cost}");
    let time = row(&rows, "free-asymmetric", "cost: time of a step");
    assert!(time.contains(" ns") && !time.contains("worse") && !time.contains("better"), "{time}");
    let (code, rows) = compare("peskin-heun", "peskin-rk2", "free-asymmetric");
    assert_eq!((code, row(&rows, "free-asymmetric", "drift").contains("better")), (0, true));
}

#[test]
fn a_comparison_ends_with_a_sentence_and_hides_what_is_the_same() {
    let compare = |more: &[&str]| {
        let scenes = ["free-asymmetric", "kovalevskaya", "--quiet"];
        stdout(&polhode(&[&["compare", "peskin-rk2", "peskin-heun"][..], &scenes, more].concat()))
    };
    let (text, all) = (compare(&[]), compare(&["--all"]));
    let sentence = text.lines().last().expect("a sentence");
    let start = "peskin-heun's orientation error is ";
    assert!(sentence.starts_with(start), "{text}");
    assert!(sentence.contains(" × peskin-rk2's at equal work (geometric mean of 2 scenes; "), "{sentence}");
    let number =
        |text: &str| text.split(' ').next().and_then(|word| word.parse::<f64>().ok()).expect("a number");
    let mean = number(&sentence[start.len()..]);
    let (least, largest) = sentence
        .split("scenes; ")
        .nth(1)
        .and_then(|range| range.trim_end_matches(')').split_once(" … "))
        .expect("a range");
    let (least, largest) = (number(least), number(largest));
    // The mean of two is the root of their product; three digits are printed.
    assert!((mean / (least * largest).sqrt() - 1.0).abs() < 0.01, "{sentence}");
    let same = |text: &str| text.lines().filter(|line| line.trim_end().ends_with("  same")).count();
    assert!(same(&text) == 0 && same(&all) > 0, "{text}{all}");
    assert!(text.contains(&format!("{} rows that are the same are not shown", same(&all))), "{text}");
}

#[test]
fn a_comparison_has_five_forms_and_a_page_is_100_columns() {
    let form = |format: &str| {
        let output =
            polhode(&["compare", "peskin-rk2", "euler", "free-asymmetric", "--quiet", "--format", format]);
        assert_eq!(code(&output), 1);
        stdout(&output)
    };
    let rows: Vec<Value> = serde_json::from_str(&form("json")).expect("JSON");
    assert!(rows.iter().any(|row| row["quantity"] == "orientation" && row["standing"] == "worse"));
    assert_eq!(form("csv").lines().count(), rows.len() + 1);
    assert_eq!(form("markdown").lines().count(), rows.len() + 2);
    let latex = form("latex");
    assert_eq!(latex.lines().filter(|line| line.ends_with("\\\\")).count(), rows.len() + 1);
    let text = form("text");
    let table = text.lines().take_while(|line| !line.starts_with("A = "));
    assert!(table.into_iter().all(|line| line.chars().count() <= 100), "{text}");
}

#[test]
fn a_scheme_of_higher_order_is_better_and_dearer() {
    let (code, rows) = compare("peskin-rk2", "kahan-li-8", "free-asymmetric");
    let orientation = row(&rows, "free-asymmetric", "orientation");
    assert!(orientation.contains("8.01") && orientation.contains("better"), "{orientation}");
    let cost = row(&rows, "free-asymmetric", "cost: evaluations a step");
    assert!(cost.contains("8.500") && cost.contains("dearer"), "{cost}");
    assert_eq!(code, 0);
    assert_eq!(compare("kahan-li-8", "peskin-rk2", "free-asymmetric").0, 1);
}

#[test]
fn solvers_that_choose_their_own_steps_are_compared_at_equal_work() {
    assert_eq!(compare("peskin-rk2", "dop853", "kovalevskaya").0, 0);
    assert_eq!(compare("dop853", "peskin-rk2", "kovalevskaya").0, 1);
}

#[test]
fn a_scene_that_one_of_the_two_does_not_take_is_a_row_with_the_reason() {
    let (code, rows) = compare("peskin-rk2", "exact-rotor", "gravity-drag");
    let refused = row(&rows, "gravity-drag", "all");
    assert!(refused.contains("not applicable: exact-rotor: a force depends on a velocity"), "{refused}");
    // Nothing was compared.
    assert_eq!(code, 2);
}

#[test]
fn the_same_work_in_other_parts_is_the_same_scheme() {
    for (a, b) in [
        ("peskin-rk2", "substepped-4-peskin-rk2"),
        ("substepped-4-peskin-rk2", "peskin-rk2"),
        ("rk4-quaternion", "rk4-quaternion"),
    ] {
        let (code, rows) = compare(a, b, "kovalevskaya");
        assert_eq!(code, 0, "{a}, {b}: {rows:#?}");
        assert!(!rows.iter().any(|row| row.trim_end().ends_with("worse")), "{a}, {b}: {rows:#?}");
    }
}

/// A records file with some of its numbers changed, compared with what it was.
fn doctored(change: impl Fn(&mut Value)) -> i32 {
    let folder = scratch();
    let (before, after) = (folder.path().join("before.json"), folder.path().join("after.json"));
    let scene = ["--scene", "free-asymmetric", "--scheme", "peskin-rk2"];
    let name = before.to_string_lossy();
    assert_eq!(code(&polhode(&[&["gate", "--quiet", "--json", &name], &scene[..]].concat())), 0);
    let mut records: Value = serde_json::from_slice(&std::fs::read(&before).expect("records")).expect("JSON");
    change(&mut records);
    std::fs::write(&after, records.to_string()).expect("written");
    code(&polhode(&["compare", &name, &after.to_string_lossy()]))
}

fn each<'a>(records: &'a mut Value, table: &str) -> impl Iterator<Item = &'a mut Value> {
    records[table].as_array_mut().expect("rows").iter_mut()
}

#[test]
fn records_files_are_worse_by_constant_drift_work_and_by_what_is_lost_but_not_by_the_clock() {
    let scale = |value: &mut Value, by: f64| {
        if let Some(number) = value.as_f64() {
            *value = (number * by).into();
        }
    };
    assert_eq!(doctored(|_| {}), 0);
    assert_eq!(doctored(|r| each(r, "orders").for_each(|row| scale(&mut row["constant"], 1.04))), 0);
    assert_eq!(doctored(|r| each(r, "orders").for_each(|row| scale(&mut row["constant"], 1.06))), 1);
    assert_eq!(doctored(|r| each(r, "drifts").for_each(|row| scale(&mut row["rate"], 1.05))), 0);
    assert_eq!(doctored(|r| each(r, "drifts").for_each(|row| scale(&mut row["rate"], 1.2))), 1);
    let slow = |r: &mut Value| {
        each(r, "measurements").for_each(|row| scale(&mut row["nanoseconds_per_step"], 100.0));
    };
    assert_eq!(doctored(slow), 0);
    let double = |row: &mut Value| {
        row["force_evaluations"] = (2 * row["force_evaluations"].as_u64().unwrap_or(0)).into();
    };
    assert_eq!(doctored(|r| each(r, "measurements").for_each(double)), 1);
    let lost = |row: &mut Value| {
        if row["order"].is_number() {
            (row["order"], row["status"]) = (Value::Null, "undecided".into());
        }
    };
    assert_eq!(doctored(|r| each(r, "orders").for_each(lost)), 1);
}

#[test]
fn parts_of_a_step_are_steps_of_the_scheme_itself() {
    for contestant in Contestant::all() {
        let parts = contestant.substepped(3).expect("a scheme that is given a step");
        assert_eq!(parts.card.name, format!("substepped-3-{}", contestant.card.name));
        assert_eq!(parts.card.evaluations(), 3 * contestant.card.evaluations());
        assert_eq!(parts.card.order(), contestant.card.order());
        let system = scene("tether-springs").system;
        if contestant.refusal(&system).is_some() {
            continue;
        }
        let run = |contestant: &Contestant, step: f64, steps: u64, every: u64| {
            contestant.run(&system, Form::Least, &Plan { step, steps, every })
        };
        // Dyadic steps: 3/64 s in three parts is 1/64 s to the last bit.
        let (coarse, fine) = (run(&parts, 3.0 / 64.0, 8, 4), run(&contestant, 1.0 / 64.0, 24, 12));
        assert_eq!(coarse.states, fine.states, "{}", contestant.card.name);
        assert_eq!((coarse.outcome.steps, coarse.states.len()), (8, 3));
        assert_eq!(coarse.outcome.evaluations, fine.outcome.evaluations);
    }
}

#[test]
fn the_listed_euler_in_four_parts_is_the_option_of_that_name() {
    let system = scene("gravity-drag").system;
    let plan = Plan { step: 1.0 / 64.0, steps: 64, every: 64 };
    let option = contestant("euler").substepped(4).expect("parts");
    let [listed, option] = [contestant("substepped-4-euler"), option].map(|c| {
        assert_eq!(c.card.name, "substepped-4-euler");
        c.run(&system, Form::Least, &plan).states[1]
    });
    // Times of parts are t + i h/4 in one and n h/4 in the other, and nothing here depends on time.
    assert_eq!(listed, option);
}

#[test]
fn a_scheme_in_parts_is_run_gated_and_refused_by_name() {
    let gate =
        |name: &str| polhode(&["gate", "--quiet", "--verbose", "--scheme", name, "--scene", "kovalevskaya"]);
    let output = gate("substepped-4-simo-wong");
    assert_eq!(code(&output), 0, "{}", stdout(&output));
    assert!(stdout(&output).contains("substepped-4-simo-wong"));
    for name in ["substepped-1-euler", "substepped-65-euler", "substepped-4-tsit45", "substepped-4-no-scheme"]
    {
        assert_eq!(code(&gate(name)), 64, "{name}");
    }
    let list = stdout(&polhode(&["list", "schemes"]));
    assert!(list.contains("substepped-N-S"));
    assert!(list.lines().any(|line| line.starts_with("peskin-rk2 ") && line.contains("the note")));
}
