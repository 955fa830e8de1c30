//! Files that say everything wrong at once.

use super::{Here, Statement, Test};

pub const STATEMENTS: [Statement; 12] = [
    Statement {
        says: "all faults of a scene are said at once, each with its line shown and the place marked",
        command: "sed 's/^duration = .*/duration = \"ten\"/; s/^law = .*/law = 7/; 1s/.*/nme = \"x\"/' scene.toml > bad.toml; polhode run bad.toml",
        shown: Here(65, |ran| {
            ran.stderr.contains("bad.toml:1:1")
                && ran.stderr.contains('^')
                && ran.stderr.matches("bad.toml:").count() >= 2
        }),
    },
    Statement {
        says: "the wrong word of a scene is quoted",
        command: "sed 's/^duration = .*/duration = \"ten\"/' scene.toml > bad.toml; polhode gate bad.toml",
        shown: Here(65, |ran| ran.stderr.contains("\"ten\"")),
    },
    Statement {
        says: "all faults of polhode.toml are said at once, with the wrong words quoted",
        command: "printf 'shemes = [\"euler\"]\\n[gate]\\nordre = 2\\n' > polhode.toml; polhode gate free-rod",
        shown: Here(65, |ran| {
            ["polhode.toml:1:1", "polhode.toml:3:1", "'shemes'", "'ordre'", "^"]
                .iter()
                .all(|word| ran.stderr.contains(word))
        }),
    },
    Statement {
        says: "a records file that is cut is refused with its line",
        command: "head -c 3000 now.json > cut.json; polhode gate --from cut.json",
        shown: Here(65, |ran| ran.stderr.contains("cut.json:")),
    },
    Statement {
        says: "a file of another schema is refused with the command that makes it anew",
        command: "polhode replay now.json",
        shown: Here(65, |ran| {
            ran.stderr.contains("now.json:2") && ran.stderr.contains("polhode report --capsule FILE")
        }),
    },
    Statement {
        says: "all faults of a records file are said at once by every command that reads it",
        command: "polhode compare now.json wrong.json",
        shown: Test(
            "tests/commands/records_faults.rs",
            "every_fault_is_shown_with_its_line_by_every_command_that_reads_records",
        ),
    },
    Statement {
        says: "what is proposed parses when it is pasted: a hundred malformed scenes",
        command: "polhode run bad.toml",
        shown: Test(
            "tests/scenes/malformed.rs",
            "every_fault_of_a_hundred_malformed_scenes_is_found_at_once_and_its_proposal_mends_it",
        ),
    },
    Statement {
        says: "every kind of fault marks its line and quotes what was written",
        command: "polhode scene show bad.toml",
        shown: Test(
            "tests/scenes/malformed.rs",
            "every_kind_of_fault_marks_its_line_and_quotes_what_was_written",
        ),
    },
    Statement {
        says: "all faults of a robot description are said at once",
        command: "polhode inspect robot.urdf",
        shown: Test("tests/commands/inspect.rs", "all_faults_of_a_file_are_said_at_once"),
    },
    Statement {
        says: "the schema of scenes is JSON Schema of draft 7",
        command: "polhode list forces --schema",
        shown: Here(0, |ran| ran.json()["$schema"] == "http://json-schema.org/draft-07/schema#"),
    },
    Statement {
        says: "the schema of settings is JSON Schema of draft 7",
        command: "polhode init --schema",
        shown: Here(0, |ran| ran.json()["$schema"] == "http://json-schema.org/draft-07/schema#"),
    },
    Statement {
        says: "a new scene names its schema, which stands beside it",
        command: "polhode scene new mine && head -1 mine.toml",
        shown: Here(0, |ran| {
            let schema =
                ran.stdout.lines().find_map(|line| line.strip_prefix("#:schema ./")).unwrap_or_default();
            ran.json_of(schema)["$schema"] == "http://json-schema.org/draft-07/schema#"
        }),
    },
];
