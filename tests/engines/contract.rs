//! `polhode engine check --contract`: a program that behaves keeps every clause, and each way of misbehaving breaks its own.

use crate::common::program::{code, polhode, stderr, stdout};
use crate::stage::{HELLO, Stage, example};

/// Names of the clauses, in order.
const CLAUSES: [&str; 8] = [
    "zero-step",
    "two-parts",
    "restart",
    "same-twice",
    "two-copies",
    "moves",
    "sane-numbers",
    "described-alike",
];

/// Multiplies the step by 1 + `factor`, an expression of awk in which `steps` is the number of steps and `first` the
/// first point's mass.
fn longer_step(factor: &str) -> String {
    format!(
        r#"awk '{{ match($0, /"step":[^,]*,/); step = substr($0, RSTART + 7, RLENGTH - 8)
           match($0, /"steps":[0-9]*/); steps = substr($0, RSTART + 8, RLENGTH - 8)
           match($0, /"points":.."mass":[^,]*/); first = substr($0, RSTART + 18, RLENGTH - 18)
           match($0, /"inertia":..[^,]*/); moment = substr($0, RSTART + 12, RLENGTH - 12)
           sub(/"step":[^,]*,/, sprintf("\"step\":%.17g,", step * (1 + ({factor})))); print }}'"#
    )
}

/// The engine of the examples behind a script: `request` edits the variable `line` before the engine reads it, `reply`
/// edits the variable `answer` before it is sent. `start` is run when the process starts.
fn behind(stage: &Stage, start: &str, request: &str, reply: &str) -> String {
    stage.script(&format!(
        "{start}\ncount=0\nwhile read -r line; do\ncase \"$line\" in *'\"bye\"'*) exit;; esac\n\
         count=$((count + 1))\ncase \"$line\" in *'\"run\"'*) :; {request};; esac\n\
         answer=$(printf '%s\\n' \"$line\" | '{}')\n:; {reply}\nprintf '%s\\n' \"$answer\"\ndone",
        example()
    ))
}

/// `line` through a filter.
fn edit(filter: &str) -> String {
    format!("line=$(printf '%s\\n' \"$line\" | {filter})")
}

/// The exit code, the clauses that fail, and the output.
fn check(scheme: &str) -> (i32, Vec<String>, String) {
    let output = polhode(&["engine", "check", "--contract", scheme]);
    let said = stdout(&output);
    let failing = said.lines().filter(|line| line.contains(" FAILS "));
    let names = failing.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect();
    (code(&output), names, said + &stderr(&output))
}

fn breaks(scheme: &str, clauses: &[&str]) {
    let (code, failing, said) = check(scheme);
    assert_eq!((code, failing), (1, clauses.iter().map(|name| (*name).to_owned()).collect()), "{said}");
}

#[test]
fn the_engine_of_the_examples_keeps_every_clause() {
    let (code, failing, said) = check(example());
    assert_eq!((code, failing), (0, Vec::new()), "{said}");
    for (line, name) in said.lines().zip(CLAUSES) {
        assert!(line.starts_with(name) && line.contains(" holds ") && line.contains("limit"), "{said}");
    }
    let stage = Stage::new();
    let (code, _, said) = check(&behind(&stage, "", "", ""));
    assert_eq!(code, 0, "the script alone breaks a clause: {said}");
}

#[test]
fn a_step_of_zero_length_that_moves_or_is_no_number_breaks_a_clause_and_a_refusal_does_not() {
    let stage = Stage::new();
    breaks(
        &behind(&stage, "", &edit(r#"sed 's/"step":0.0,"steps"/"step":0.001,"steps"/'"#), ""),
        &["zero-step"],
    );
    let on_zero = |answer: &str| format!("case \"$line\" in *'\"step\":0.0,'*) answer={answer};; esac");
    let not_a_number =
        on_zero(r#"$(printf '%s' "$answer" | sed 's/"velocity":.[^]]*/"velocity":[NaN,0,0/g')"#);
    breaks(&behind(&stage, "", "", &not_a_number), &["zero-step"]);
    let refused =
        on_zero(r#"$(printf '%s' "$answer" | sed 's/^{.*\("id":[0-9]*\).*/{\1,"refused":"no step"}/')"#);
    let (code, _, said) = check(&behind(&stage, "", "", &refused));
    assert_eq!(code, 0, "{said}");
    assert!(said.lines().next().is_some_and(|line| line.contains("refused: no step")), "{said}");
}

#[test]
fn a_program_that_keeps_a_history_breaks_two_clauses() {
    // The first step of every run is shorter by 2 %.
    let stage = Stage::new();
    let scheme = behind(&stage, "", &edit(&longer_step("-0.02 / steps")), "");
    breaks(&scheme, &["two-parts", "restart"]);
    assert!(check(&scheme).2.contains("keeps a history"));
}

#[test]
fn a_history_that_the_process_remembers_breaks_the_restart_alone() {
    // The first step is shorter by 1e-5, but for a run that begins where the last run of this process has ended: so little that
    // the error of RK4 changes by less than rounding.
    let stage = Stage::new();
    let request = format!(
        r#"start=$(printf '%s' "$line" | sed 's/.*"initial":[^}}]*"position":\(.[^]]*\).*/\1/')
        if [ "$start" != "$last" ]; then {}; fi"#,
        edit(&longer_step("-1e-5 / steps"))
    );
    let reply = r#"last=$(printf '%s' "$answer" | sed 's/.*"position":\(.[^]]*\).*/\1/')"#;
    breaks(&behind(&stage, "last=none", &request, reply), &["restart"]);
}

#[test]
fn numbers_that_change_in_their_last_bits_break_a_clause_each() {
    let stage = Stage::new();
    let change = edit(&longer_step("4e-15"));
    let every_other = format!("if [ $((count % 2)) = 0 ]; then {change}; fi");
    breaks(&behind(&stage, "", &every_other, ""), &["same-twice"]);
    let start = r#"if [ -e "$here/odd" ]; then rm "$here/odd"; odd=0; else : > "$here/odd"; odd=1; fi"#;
    breaks(&behind(&stage, start, &format!("if [ $odd = 1 ]; then {change}; fi"), ""), &["two-copies"]);
}

#[test]
fn a_body_that_is_put_to_sleep_breaks_a_clause() {
    let stage = Stage::new();
    let asleep = r#"awk '{ match($0, /"angular_velocity":.[^]]*/); split(substr($0, RSTART + 20, RLENGTH - 20), w, ",")
        if (w[1] ^ 2 + w[2] ^ 2 + w[3] ^ 2 < 1e-4) sub(/"step":[^,]*,/, "\"step\":0.0,"); print }'"#;
    breaks(&behind(&stage, "", &edit(asleep), ""), &["moves"]);
}

#[test]
fn finite_but_absurd_numbers_break_a_clause() {
    let stage = Stage::new();
    for key in ["angular_velocity", "velocity"] {
        let filter = format!(r#"sed 's/"{key}":.[^]]*/"{key}":[1000000.0,0.0,0.0/g'"#);
        let absurd = format!(
            "case \"$line\" in *'\"step\":0.001,'*) answer=$(printf '%s' \"$answer\" | {filter});; esac"
        );
        breaks(&behind(&stage, "", "", &absurd), &["sane-numbers"]);
    }
}

#[test]
fn a_motion_that_depends_on_the_description_of_the_body_breaks_a_clause() {
    let stage = Stage::new();
    // On the mass of the first point, and on the first entry of the inertia.
    for factor in ["1e-9 * first", "1e-9 * moment"] {
        breaks(&behind(&stage, "", &edit(&longer_step(factor)), ""), &["described-alike"]);
    }
}

#[test]
fn a_program_that_refuses_everything_leaves_nothing_to_check_and_one_that_is_none_cannot_be_run() {
    let stage = Stage::new();
    let refuses = stage.script(&format!(
        "{HELLO}; while read -r line; do echo \"$line\" | sed 's/.*\\(\"id\":[0-9]*\\).*/{{\\1,\"refused\":\"not today\"}}/'; done"
    ));
    let (exit, failing, said) = check(&refuses);
    assert_eq!((exit, failing), (2, Vec::new()), "{said}");
    assert_eq!(said.matches("not applicable").count(), CLAUSES.len(), "{said}");
    assert!(said.contains("not today"), "{said}");
    assert_eq!(check("/no/such/program").0, 69);
    let ends = stage.script(&format!("{HELLO}; read -r line; exit 3"));
    let (exit, failing, said) = check(&ends);
    assert_eq!((exit, failing.len()), (1, CLAUSES.len()), "{said}");
}
