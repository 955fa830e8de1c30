//! Build servers and other programs.

use super::{Here, Script, Statement, Test};

pub const STATEMENTS: [Statement; 33] = [
    Statement {
        says: "polhode.toml names schemes and scenes",
        command: "printf 'schemes = [\"euler\"]\\nscenes = [\"free-rod\"]\\n' > polhode.toml; polhode gate --format json",
        shown: Here(0, |ran| {
            let all = ran.json();
            let rows = all["verdicts"].as_array().expect("rows");
            rows.iter().all(|row| {
                row["scene"] == "free-rod" && ["euler", "reference"].iter().any(|one| row["scheme"] == *one)
            })
        }),
    },
    Statement {
        says: "the command line comes before polhode.toml, and that before the defaults",
        command: "polhode gate --config polhode.toml --order 1",
        shown: Test(
            "tests/commands/settings.rs",
            "the_command_line_comes_before_the_file_and_the_file_before_the_defaults",
        ),
    },
    Statement {
        says: "polhode.toml has tolerances",
        command: "polhode gate --baseline b.json --config polhode.toml",
        shown: Test(
            "tests/commands/baselines.rs",
            "more_work_and_larger_errors_than_on_record_fail_and_a_tolerance_allows_them",
        ),
    },
    Statement {
        says: "init writes a commented polhode.toml that changes nothing",
        command: "polhode init && grep -c '^#' polhode.toml && polhode gate free-rod --scheme euler",
        shown: Here(0, |ran| {
            ran.stdout.lines().next().is_some_and(|line| line.parse::<u32>().is_ok_and(|count| count > 10))
        }),
    },
    Statement {
        says: "gate --baseline compares order, constant, every rung, drift and counted work",
        command: "polhode gate free-oblate --scheme euler --json b.json --quiet > log; polhode gate free-oblate --scheme euler --baseline b.json",
        shown: Here(0, |ran| {
            ["orders", "constants", "quantities over all runs", "drifts", "counts of work"]
                .iter()
                .all(|what| ran.stderr.contains(&format!("{what} compared")))
        }),
    },
    Statement {
        says: "a worse run of any rung fails a gate with a baseline",
        command: "polhode gate free-asymmetric --scheme peskin-rk2 --baseline b.json",
        shown: Test("tests/commands/baselines.rs", "a_gate_against_its_own_baseline_compares_everything"),
    },
    Statement {
        says: "bless writes a baseline with who, when, version and reason",
        command: "polhode bless free-oblate --scheme euler --reason first --by me",
        shown: Here(0, |ran| {
            let provenance = &ran.json_of("polhode-baseline.json")["provenance"][0];
            provenance["reason"] == "first" && provenance["who"] == "me" && provenance["when"].is_string()
        }),
    },
    Statement {
        says: "bless says what changes, as JSON too",
        command: "polhode bless free-oblate --scheme euler --reason first --quiet > log; polhode bless free-oblate --scheme euler --reason again --format json",
        shown: Here(0, |ran| {
            ran.json()["schema"] == "polhode/bless/1"
                && ran.json()["changes"].as_array().is_some_and(Vec::is_empty)
        }),
    },
    Statement {
        says: "--github annotates a cell with the file of its scene, and adds a summary to the step",
        command: "cp scene.toml mine.toml; GITHUB_STEP_SUMMARY=s.md polhode gate mine.toml --scheme euler --order 2 --github; cat s.md",
        shown: Here(0, |ran| ran.stdout.lines().any(|line| line.starts_with("## polhode gate"))),
    },
    Statement {
        says: "--github gives one annotation a scheme and scene, what got worse on top",
        command: "polhode gate thin-body --scheme euler --github",
        shown: Test("tests/commands/campaigns.rs", "a_gate_writes_for_build_servers"),
    },
    Statement {
        says: "JUnit has a body for each failure",
        command: "polhode gate free-oblate --scheme euler --order 2 --junit j.xml",
        shown: Here(1, |ran| {
            let text = ran.text("j.xml");
            let body =
                text.split("<failure").nth(1).and_then(|rest| rest.split('>').nth(1)).unwrap_or_default();
            text.contains("<testsuites name=\"polhode\"") && body.contains("order")
        }),
    },
    Statement {
        says: "--benchmark writes customSmallerIsBetter",
        command: "polhode gate free-oblate --scheme euler --benchmark b.json",
        shown: Here(0, |ran| ran.json_of("b.json")[0]["value"].is_number()),
    },
    Statement {
        says: "--bencher writes Bencher's format",
        command: "polhode gate free-oblate --scheme euler --bencher b.json",
        shown: Here(0, |ran| ran.json_of("b.json").as_object().is_some_and(|all| !all.is_empty())),
    },
    Statement {
        says: "--sarif writes SARIF",
        command: "polhode gate free-oblate --scheme euler --order 2 --sarif s.json",
        shown: Here(1, |ran| ran.json_of("s.json")["runs"][0]["results"][0]["ruleId"].is_string()),
    },
    Statement {
        says: "--markdown writes a summary",
        command: "polhode gate free-oblate --scheme euler --order 2 --markdown m.md",
        shown: Here(1, |ran| ran.text("m.md").contains("euler")),
    },
    Statement {
        says: "the GitHub Action, the GitLab job and the pre-commit hooks run as far as they do without their hosts",
        command: "polhode gate --scene my-body.toml --junit polhode.xml",
        shown: Script(".ci/citizens"),
    },
    Statement {
        says: "gate --format json",
        command: "polhode gate free-oblate --scheme euler --order 2 --format json --quiet",
        shown: Here(1, |ran| {
            let all = ran.json();
            let rows = all["verdicts"].as_array().expect("rows");
            all["schema"] == "polhode/verdicts/1"
                && all["complete"] == true
                && rows.iter().any(|row| row["verdict"] == "fail" && row["rule"].is_string())
        }),
    },
    Statement {
        says: "gate --from gives the verdicts of the run",
        command: "polhode gate free-rod --scheme euler --config c.toml --format json | grep -v made_at > a; polhode gate --from now.json --format json | grep -v made_at | diff a -",
        shown: Here(0, |ran| ran.stdout.is_empty()),
    },
    Statement {
        says: "report --format json",
        command: "polhode report --from now.json --format json",
        shown: Here(0, |ran| ran.json()["schema"] == "polhode/verdicts/1"),
    },
    Statement {
        says: "compare --format json",
        command: "polhode compare now.json now.json --all --format json --quiet",
        shown: Here(0, |ran| ran.json()[0]["standing"].is_string()),
    },
    Statement {
        says: "run --format json",
        command: "polhode run free-rod --steps 4 --format json",
        shown: Here(0, |ran| ran.json()["schema"] == "polhode/run/1"),
    },
    Statement {
        says: "advise --format json",
        command: "polhode advise free-oblate --tolerance 1e-2 --scheme euler --format json",
        shown: Here(0, |ran| ran.json()["schema"] == "polhode/advice/1"),
    },
    Statement {
        says: "sweep --format json, into a file that the command replaces",
        command: "for step in 0.1 0.2; do polhode sweep free-rod --vary step=$step:1:2 --format json --out f.json --quiet || exit 1; done",
        shown: Here(0, |ran| {
            let all = ran.json_of("f.json");
            all["schema"] == "polhode/sweep/1" && all["rows"][0]["varied"]["step"] == 0.2
        }),
    },
    Statement {
        says: "stability --format json",
        command: "polhode stability free-oblate --scheme euler --cells 0 --long 0 --out out --format json",
        shown: Here(0, |ran| ran.json()["limits"].is_array()),
    },
    Statement {
        says: "judge --format json",
        command: "polhode judge log.csv --scene free-rod --quantity orientation --tolerance 1e-6 --format json",
        shown: Here(1, |ran| {
            let all = ran.json();
            let log = &all["logs"][0];
            all["schema"] == "polhode/judge/1"
                && log["rows"] == 2
                && log["verdict"]["verdict"] == "fail"
                && log["findings"][0]["why"].is_string()
        }),
    },
    Statement {
        says: "judge --format json has hints, and the deviations of several logs",
        command: "polhode run free-rod --steps 100 --format csv > a.csv; sed 's/,/;/g' a.csv > b.csv; polhode judge a.csv b.csv --scene free-rod --format json",
        shown: Here(0, |ran| {
            let all = ran.json();
            all["logs"][1]["hints"].is_array() && all["deviations"][0]["largest"] == 0.0
        }),
    },
    Statement {
        says: "inspect --format json",
        command: "polhode inspect scene.toml --format json",
        shown: Here(0, |ran| ran.json()["schema"] == "polhode/inspect/1"),
    },
    Statement {
        says: "replay --format json",
        command: "polhode report free-rod --scheme euler --out out --capsule c.json --quiet > log; polhode replay c.json --format json",
        shown: Here(0, |ran| {
            let all = ran.json();
            all["schema"] == "polhode/replay/1"
                && all["rows"].as_u64() > Some(0)
                && all["differences"].as_array().is_some_and(Vec::is_empty)
        }),
    },
    Statement {
        says: "self-test --format json",
        command: "polhode self-test --random 2 --format json",
        shown: Test("tests/commands/json_forms.rs", "verdicts_in_random_scenes_are_counted_in_json"),
    },
    Statement {
        says: "engine check --format json",
        command: "polhode engine check --format json 'python3 engine.py'",
        shown: Test("tests/engines/behaving.rs", "findings_of_a_check_are_rows_of_json"),
    },
    Statement {
        says: "list --format json",
        command: "polhode list metrics --format json",
        shown: Here(0, |ran| ran.json()[0]["unit"].is_string()),
    },
    Statement {
        says: "list claims RULE explains a rule",
        command: "polhode list claims order",
        shown: Here(0, |ran| ran.stdout.starts_with("order: ")),
    },
    Statement {
        says: "every rule is explained by its stable name",
        command: "polhode list claims budget",
        shown: Test("tests/commands/lists.rs", "every_rule_is_explained_by_its_name"),
    },
];
