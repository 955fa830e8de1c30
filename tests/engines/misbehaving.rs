//! What an engine does wrong is a row with a reason: never a wait without end, never a process left behind.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::common::program::{code, polhode, stderr, stdout};
use crate::stage::{ANSWER, HELLO, Stage, runs};

/// The reason of a broken run of one step.
fn why(stage: &Stage, script: &str) -> String {
    let scheme = stage.script(script);
    let since = Instant::now();
    let output =
        polhode(&["run", "free-asymmetric", "--scheme", &scheme, "--steps", "1", "--engine-timeout", "0.7"]);
    assert!(since.elapsed() < Duration::from_secs(5), "{script}");
    assert_eq!(code(&output), 1, "{script}: {}{}", stdout(&output), stderr(&output));
    let run: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(run["status"], "broken", "{script}");
    run["why"].as_str().expect("a reason").to_owned()
}

#[test]
fn whatever_an_engine_answers_the_run_is_broken_with_the_reason() {
    let other = |from: &str, to: &str| format!("echo '{}'", ANSWER.replacen(from, to, 1));
    for (answer, reason) in [
        ("sleep 100".to_owned(), "no answer within 0.7 s"),
        ("exec 1>&-; sleep 100".to_owned(), "closed its output"),
        ("exit 3".to_owned(), "exit status: 3"),
        ("kill -SEGV $$".to_owned(), "signal: 11"),
        ("echo oh no >&2; exit 3".to_owned(), "oh no"),
        (format!("printf '%s' '{}'", &ANSWER[..90]), "cut"),
        ("echo good morning".to_owned(), "not JSON"),
        ("echo '[]'".to_owned(), "protocol"),
        ("echo '{\"id\":1}'".to_owned(), "\"states\", \"refused\" and \"failed\""),
        ("printf '\\377\\376\\n'".to_owned(), "not JSON"),
        ("yes | tr -d '\\n'".to_owned(), "longer than"),
        ("yes ''".to_owned(), "no answer within"),
        (other("\"id\":1", "\"id\":2"), "the id 2"),
        (other("\"id\":1", "\"ib\":1"), "no id"),
        (other("\"step\":1", "\"step\":2"), "step 2"),
        (other("[1,2,3]", "[1,2]"), "2 numbers"),
        (other("[1,2,3]", "[1,2,NaN]"), "NaN"),
        (other("[1,2,3]", "[1,2,null]"), "null"),
        (other("[1,2,3]", "[1,2,1e999]"), "out of range"),
        (other("[0,1,0,0]", "[0,2,0,0]"), "length 2"),
        (
            other(
                "},{",
                "},{\"step\":0,\"position\":[0,0,0],\"orientation\":[1,0,0,0],\"velocity\":[0,0,0],\"angular_velocity\":[0,0,0]},{",
            ),
            "3 states",
        ),
        (
            "echo '{\"id\":1,\"failed\":\"diverged\",\"step\":1}'".to_owned(),
            "broke in step 1, at t = 8 s: diverged",
        ),
    ] {
        let found = why(&Stage::new(), &format!("{HELLO}; read -r line; {answer}"));
        assert!(found.contains(reason), "{answer}: {found}");
    }
}

#[test]
fn megabytes_of_log_and_a_reader_that_does_not_read_stop_nobody() {
    let stage = Stage::new();
    let scheme =
        stage.script(&format!("{HELLO}; read -r line; yes noise | head -c 8000000 >&2; echo '{ANSWER}'"));
    let output = polhode(&["run", "free-asymmetric", "--scheme", &scheme, "--steps", "1"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    // A body of 20,000 points is a question of some megabytes, more than a pipe holds.
    let points: Vec<String> = (0..20_000)
        .map(|k| format!("{{ mass = 1.0, position = [{}, {}, {}] }}", k % 7, k % 11, k % 13))
        .collect();
    let text = format!("name = \"large\"\nduration = 1.0\n[body]\npoints = [{}]\n", points.join(", "));
    let large = stage.path("large.toml");
    std::fs::write(&large, text).expect("written");
    let scheme = stage.script(&format!("{HELLO}; sleep 100"));
    let run =
        ["run", &large.to_string_lossy(), "--scheme", &scheme, "--steps", "1", "--engine-timeout", "0.5"];
    let output = polhode(&run);
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    assert!(stderr(&output).contains("no answer within"), "{}", stderr(&output));
}

#[test]
fn an_engine_is_started_once_again_and_then_given_up() {
    let stage = Stage::new();
    let scheme = stage.script(&format!("echo start >> \"$here/starts\"; {HELLO}; read -r line; exit 3"));
    let output =
        polhode(&["gate", "--quiet", "--jobs", "1", "--scheme", &scheme, "--scene", "free-asymmetric"]);
    assert_eq!(code(&output), 1, "{}", stdout(&output));
    assert_eq!(stage.text("starts").lines().count(), 2);
    assert!(stdout(&output).contains("given up"), "{}", stdout(&output));
}

#[test]
fn an_engine_that_cannot_be_run_at_all_is_69() {
    for script in [
        "exit 0",
        "read -r line; exit 1",
        "sleep 100",
        "echo hello",
        "echo '{\"polhode\":2,\"name\":\"x\"}'",
        "echo '{\"polhode\":1}'",
        "echo '{\"polhode\":1,\"name\":\"x\",\"order\":0}'",
        "echo '{\"polhode\":1,\"name\":\"x\",\"order\":2.5}'",
        "yes | tr -d '\\n'",
    ] {
        let stage = Stage::new();
        let scheme = stage.script(script);
        for command in ["gate", "report"] {
            let out = stage.path("out");
            let mut arguments = vec![command, "--quiet", "--scheme", &scheme, "--engine-timeout", "0.5"];
            let out = out.to_string_lossy();
            if command == "report" {
                arguments.extend(["--out", &out]);
            }
            let output = polhode(&arguments);
            assert_eq!(code(&output), 69, "{script}: {}", stderr(&output));
            assert!(stderr(&output).contains("cannot be run"), "{script}: {}", stderr(&output));
        }
    }
    for scheme in ["engine:/no/such/program", "engine:", "engine:sh 'unclosed"] {
        assert_eq!(code(&polhode(&["gate", "--scheme", scheme])), 69, "{scheme}");
    }
    let wrong = polhode(&["gate", "--scheme", "euler", "--engine-timeout", "0"]);
    assert_eq!(code(&wrong), 64);
}

#[test]
fn an_engine_that_ignores_the_end_of_its_input_is_ended_with_all_that_it_has_started() {
    let stage = Stage::new();
    let scheme = stage.script(&format!(
        "trap '' TERM HUP INT; sleep 1000 & echo $! > \"$here/child\"; echo $$ > \"$here/self\"; {HELLO}; read -r line; echo '{ANSWER}'; while :; do sleep 1000; done"
    ));
    let output = polhode(&["run", "free-asymmetric", "--scheme", &scheme, "--steps", "1"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for name in ["self", "child"] {
        assert!(!stage.text(name).trim().is_empty());
        // What ends it sees the end of the harness a moment later.
        let ended = (0..1000).any(|_| {
            std::thread::sleep(Duration::from_millis(10));
            !runs(&stage.text(name))
        });
        assert!(ended, "{name} still runs");
    }
}

#[test]
fn an_interrupt_ends_the_engines_and_leaves_nothing_behind() {
    for (interrupts, signal) in [(1, "-INT"), (2, "-INT"), (1, "-TERM")] {
        let stage = Stage::new();
        let scheme = stage.script(&format!(
            "trap '' TERM HUP INT; echo $$ > \"$here/self\"; {HELLO}; read -r line; sleep 1000"
        ));
        let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
            .args(["gate", "--quiet", "--scheme", &scheme, "--scene", "free-asymmetric"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program runs");
        let since = Instant::now();
        while stage.text("self").is_empty() && since.elapsed() < Duration::from_secs(5) {
            std::thread::sleep(Duration::from_millis(20));
        }
        std::thread::sleep(Duration::from_millis(300));
        for _ in 0..interrupts {
            let id = child.id().to_string();
            assert!(Command::new("kill").args([signal, &id]).status().expect("kill runs").success());
        }
        let since = Instant::now();
        let status = child.wait().expect("it ends");
        assert!(since.elapsed() < Duration::from_secs(3), "{interrupts} times {signal}");
        assert_eq!(status.code(), Some(130));
        assert!(!runs(&stage.text("self")), "{interrupts} times {signal}");
    }
}

#[test]
fn a_harness_that_is_killed_leaves_no_engine_behind() {
    let stage = Stage::new();
    // It ignores the end of its input, and so does what it has started.
    let scheme = stage.script(&format!(
        "trap '' TERM HUP INT; sleep 1000 & echo $! > \"$here/child\"; {HELLO}; read -r line; echo $$ > \"$here/self\"; while :; do sleep 1000; done"
    ));
    let mut harness = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["gate", "--quiet", "--scheme", &scheme, "--scene", "free-asymmetric"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program runs");
    while !stage.text("self").ends_with('\n') && harness.try_wait().expect("a status").is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    harness.kill().expect("killed");
    harness.wait().expect("it ends");
    for name in ["self", "child"] {
        assert!(!stage.text(name).trim().is_empty(), "{name}");
        // What ends it sees the end of the harness a moment later.
        let ended = (0..1000).any(|_| {
            std::thread::sleep(Duration::from_millis(10));
            !runs(&stage.text(name))
        });
        assert!(ended, "{name} still runs");
    }
}

#[test]
fn an_engine_that_takes_too_much_memory_is_ended_and_so_is_what_it_has_started() {
    let stage = Stage::new();
    // A line without end is kept whole by tail, here a child of the engine.
    let scheme = stage.script(&format!("{HELLO}; read -r line; yes | tr -d '\\n' | tail -n 1 > /dev/null"));
    let run = ["run", "free-asymmetric", "--scheme", &scheme, "--steps", "1", "--engine-memory", "100"];
    let since = Instant::now();
    let output = polhode(&run);
    assert!(since.elapsed() < Duration::from_secs(30));
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    assert!(stderr(&output).contains("more than the 100 MiB"), "{}", stderr(&output));
    assert_eq!(code(&polhode(&["gate", "--scheme", "euler", "--engine-memory", "0"])), 64);
}

#[test]
fn a_command_line_that_cannot_be_one_is_told_what_to_write() {
    let folder = env!("CARGO_MANIFEST_DIR");
    let script = format!("engine:{folder}/references/engines/scipy_engine.py");
    for (scheme, words, exit) in [
        ("engine:", "needs a command line", 69),
        ("engine:  ", "needs a command line", 69),
        ("engine:sh 'unclosed", "quotes", 69),
        (&format!("engine:{folder}"), "it is a folder", 69),
        ("engine:Cargo.toml", "No such file or directory (os error 2): write ./Cargo.toml", 69),
        (&script, "write its interpreter before it", 69),
        ("engine", "engine:python3 my_engine.py", 64),
        ("python3 engine.py", "engine:python3 my_engine.py", 64),
    ] {
        let output = polhode(&["gate", "--scheme", scheme, "--scene", "free-asymmetric"]);
        assert_eq!(code(&output), exit, "{scheme}");
        assert!(stderr(&output).contains(words), "{scheme}: {}", stderr(&output));
    }
}

#[test]
fn an_engine_that_answers_only_one_of_two_questions_is_found_out() {
    let stage = Stage::new();
    // It reads what has arrived and answers the first line of it.
    let scheme = stage.script(&format!(
        "while read -r line; do echo \"$line\" | '{}' | tail -n 1; read -r -t 0.1 lost; done",
        crate::stage::example()
    ));
    let output =
        polhode(&["engine", "check", &scheme.replace("engine:sh", "engine:bash"), "--engine-timeout", "1"]);
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    let said = stdout(&output);
    let rule = said.lines().find(|line| line.contains("questions may be sent before")).expect("the rule");
    assert!(rule.starts_with("FAIL"), "{said}");
}
