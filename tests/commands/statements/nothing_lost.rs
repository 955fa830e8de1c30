//! Nothing of the user's is lost.

use super::{Here, Statement, Test};

pub const STATEMENTS: [Statement; 30] = [
    Statement {
        says: "a report deletes and overwrites only what its manifest lists",
        command: "polhode report free-rod --scheme euler --out mine",
        shown: Test(
            "tests/commands/files.rs",
            "a_report_removes_and_overwrites_only_what_an_earlier_one_made",
        ),
    },
    Statement {
        says: "a report of other scenes goes to another folder",
        command: "polhode report free-rod --scheme euler",
        shown: Test("tests/commands/files.rs", "a_report_of_one_scene_has_a_folder_of_its_own"),
    },
    Statement {
        says: "run --out keeps a file of another origin",
        command: "echo mine > f; polhode run free-rod --steps 4 --out f",
        shown: Here(74, |ran| ran.text("f") == "mine\n" && ran.stderr.contains("--force")),
    },
    Statement {
        says: "engine new --out keeps a file of another origin",
        command: "echo mine > f; polhode engine new --language c --out f",
        shown: Here(74, |ran| ran.text("f") == "mine\n"),
    },
    Statement {
        says: "gate --json keeps a file of another origin",
        command: "echo mine > f; polhode gate free-rod --scheme euler --json f",
        shown: Here(74, |ran| ran.text("f") == "mine\n"),
    },
    Statement {
        says: "gate --junit keeps a file of another origin",
        command: "echo mine > f; polhode gate free-rod --scheme euler --junit f",
        shown: Here(74, |ran| ran.text("f") == "mine\n"),
    },
    Statement {
        says: "--force overwrites, and what the command wrote itself needs none",
        command: "echo mine > f; polhode run free-rod --steps 4 --out f --force && polhode run free-rod --steps 5 --out f",
        shown: Here(0, |ran| ran.json_of("f")["steps"] == 5),
    },
    Statement {
        says: "every command that writes keeps a file of another origin",
        command: "polhode sweep free-rod --vary step=0.1:0.2:2 --out f.csv",
        shown: Test(
            "tests/commands/files.rs",
            "a_file_of_another_origin_is_kept_unless_forced_and_one_of_this_program_is_replaced",
        ),
    },
    Statement {
        says: "a device is written through",
        command: "polhode run free-rod --steps 4 --out /dev/full; test -c /dev/full && polhode run free-rod --steps 4 --out /dev/stdout",
        shown: Here(0, |ran| ran.json()["steps"] == 4 && ran.stderr.contains("/dev/full")),
    },
    Statement {
        says: "a full disk behind stdout is 74",
        command: "polhode run free-rod --steps 4 > /dev/full",
        shown: Here(74, |ran| ran.stderr.contains("stdout")),
    },
    Statement {
        says: "a link stays one",
        command: "ln -s real.json link.json; polhode run free-rod --steps 4 --out link.json && test -L link.json",
        shown: Here(0, |ran| ran.json_of("real.json")["steps"] == 4),
    },
    Statement {
        says: "a pipe stays one",
        command: "mkfifo p; cat p > got & polhode run free-rod --steps 4 --out p && wait && test -p p",
        shown: Here(0, |ran| ran.json_of("got")["steps"] == 4),
    },
    Statement {
        says: "a place that cannot be written is found before measuring",
        command: "polhode gate --scheme all --json scene.toml/now.json",
        shown: Here(74, |ran| ran.stdout.is_empty() && ran.stderr.contains("scene.toml/now.json")),
    },
    Statement {
        says: "a read-only folder is found before measuring, by every command that writes",
        command: "polhode gate --scheme all --json read-only/now.json",
        shown: Test("tests/commands/read_only.rs", "a_folder_that_takes_no_file_is_found_before_measuring"),
    },
    Statement {
        says: "a mistyped folder is not created",
        command: "polhode gate --scheme all --junit no/such/junit.xml; test ! -e no",
        shown: Here(0, |ran| ran.stderr.contains("no/such/junit.xml")),
    },
    Statement {
        says: "a mistyped folder of scenes is not created",
        command: "polhode inspect scene.toml --out no/such; test ! -e no",
        shown: Here(0, |ran| ran.stderr.contains("no/such") && ran.stdout.is_empty()),
    },
    Statement {
        says: "a mistyped folder of a study is not created",
        command: "polhode stability --out no/such; test ! -e no",
        shown: Here(0, |ran| ran.stderr.contains("no/such") && ran.stdout.is_empty()),
    },
    Statement {
        says: "report --out creates its folder",
        command: "polhode report free-oblate --out deep/report",
        shown: Test("tests/commands/campaigns.rs", "a_report_has_all_its_files"),
    },
    Statement {
        says: "kill -9 at any moment leaves every finished row readable, and no temporary file",
        command: "polhode sweep free-asymmetric --vary step=0.01:0.1:7 --out f.csv --resume",
        shown: Test("tests/slow/killed.rs", "two_hundred_kills_at_random_moments_lose_no_finished_row"),
    },
    Statement {
        says: "--resume ends with the bytes of an unbroken run",
        command: "polhode gate free-rod --scheme euler --json now.json --resume",
        shown: Test(
            "tests/commands/killed.rs",
            "a_killed_command_leaves_whole_rows_and_ends_with_the_files_of_an_unbroken_one",
        ),
    },
    Statement {
        says: "a killed harness leaves no engine behind",
        command: "polhode gate --scheme 'engine:python3 engine.py'",
        shown: Test("tests/engines/misbehaving.rs", "a_harness_that_is_killed_leaves_no_engine_behind"),
    },
    Statement {
        says: "Ctrl-C writes what was measured and draws nothing",
        command: "polhode report --out mine",
        shown: Test("tests/commands/interrupted.rs", "what_was_measured_is_written_and_nothing_is_drawn"),
    },
    Statement {
        says: "Ctrl-C ends commands that keep no records, with 130",
        command: "polhode run kovalevskaya --steps 100000000000 --every 1000000000 --out run.json",
        shown: Test("tests/commands/interrupted.rs", "commands_without_records_end_too"),
    },
    Statement {
        says: "Ctrl-C ends the reading of a log, with 130 and no verdict",
        command: "polhode judge log.csv --scene free-rod",
        shown: Test("tests/commands/interrupted.rs", "a_long_log_is_not_read_to_its_end"),
    },
    Statement {
        says: "a full disk behind the help is 74",
        command: "polhode --help > /dev/full",
        shown: Here(74, |ran| ran.stderr.contains("stdout")),
    },
    Statement {
        says: "a scene without an end is 65 at once",
        command: "timeout 5 polhode run /dev/zero",
        shown: Here(65, |ran| ran.stdout.is_empty()),
    },
    Statement {
        says: "a scene of more than 64 MiB is 65",
        command: "head -c 65M /dev/zero | tr '\\0' '#' > big.toml; polhode run big.toml",
        shown: Here(65, |ran| ran.stderr.contains("64 MiB")),
    },
    Statement {
        says: "a larger scene is read where the user says so",
        command: "{ polhode scene show free-rod; head -c 65M /dev/zero | tr '\\0' '#'; } > big.toml; polhode run big.toml --steps 4 --input-limit 80",
        shown: Here(0, |ran| ran.json()["steps"] == 4),
    },
    Statement {
        says: "a smaller bound holds too",
        command: "head -c 2M /dev/zero | tr '\\0' '#' > big.toml; polhode run big.toml --input-limit 1",
        shown: Here(65, |ran| ran.stderr.contains("--input-limit")),
    },
    Statement {
        says: "a log without an end is 65 in bounded memory",
        command: "yes | polhode judge /dev/stdin --scene free-rod",
        shown: Test("tests/slow/long_inputs.rs", "ten_gigabytes_by_a_pipe_are_65"),
    },
];
