//! No green light that means nothing.

use super::{Here, Statement, Test};

pub const STATEMENTS: [Statement; 14] = [
    Statement {
        says: "a baseline that matches nothing is 2 and said",
        command: "polhode gate free-oblate --scheme euler --baseline now.json",
        shown: Here(2, |ran| ran.stderr.contains("nothing was compared")),
    },
    Statement {
        says: "two records files with nothing in common are 2",
        command: "polhode gate free-oblate --scheme euler --json other.json --quiet > log; polhode compare now.json other.json",
        shown: Here(2, |ran| ran.stderr.contains("nothing was compared")),
    },
    Statement {
        says: "an engine that claims no order is 2, and --order P judges it",
        command: "polhode gate --scheme 'engine:python3 engine.py' --order 4",
        shown: Test(
            "tests/gates/programs.rs",
            "a_program_that_claims_no_order_is_not_green_and_one_that_is_held_to_it_is",
        ),
    },
    Statement {
        says: "a scene in which nothing moves is 2 and said",
        command: "printf '%s\\n' 'name = \"still\"' 'duration = 1.0' '[body]' 'mass = 1.0' 'inertia = [1, 2, 2.5]' > still.toml; polhode gate still.toml --scheme euler",
        shown: Here(2, |ran| ran.stderr.contains("'still'")),
    },
    Statement {
        says: "stored records of a scene in which nothing moves are 2, too",
        command: "polhode gate still.toml --scheme euler --json still.json",
        shown: Test("tests/commands/campaigns.rs", "a_scene_in_which_nothing_moves_is_no_green_light"),
    },
    Statement {
        says: "two scenes of one name are 65",
        command: "polhode gate free-rod scene.toml --scheme euler",
        shown: Here(65, |ran| ran.stderr.contains("'free-rod'")),
    },
    Statement {
        says: "what was compared with a baseline is counted",
        command: "polhode gate free-oblate --scheme euler --json b.json --quiet > log; polhode gate free-oblate --scheme euler --baseline b.json",
        shown: Here(0, |ran| {
            let line =
                ran.stderr.lines().find(|line| line.ends_with("constants compared")).unwrap_or_default();
            let counts: Vec<u32> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
            matches!(counts[..], [some, all] if some == all && all > 0)
        }),
    },
    Statement {
        says: "a lower order than on record comes first, and no constant is judged there",
        command: "polhode gate free-oblate --scheme euler --baseline now.json",
        shown: Test(
            "tests/commands/baselines.rs",
            "a_lower_order_than_on_record_comes_first_and_no_constant_is_judged",
        ),
    },
    Statement {
        says: "judge --tolerance ends with FAIL, size, limit and time",
        command: "polhode judge log.csv --scene free-rod --quantity orientation --tolerance 1e-6",
        shown: Here(1, |ran| {
            let words = ["FAIL orientation", "largest error", "limit 1e-6 rad", "at t = 0.1 s"];
            words.iter().all(|word| ran.last().contains(word))
        }),
    },
    Statement {
        says: "judge --tolerance ends with PASS where the error is within it",
        command: "polhode judge log.csv --scene free-rod --quantity orientation --tolerance 10",
        shown: Here(0, |ran| ran.last().starts_with("PASS orientation")),
    },
    Statement {
        says: "what a log does not have is no pass",
        command: "polhode judge log.csv --scene free-rod --quantity position --tolerance 10",
        shown: Here(2, |ran| ran.last().starts_with("UNDECIDED position")),
    },
    Statement {
        says: "a comparison of schemes in which nothing was compared is 2",
        command: "polhode compare peskin-rk2 exact-rotor gravity-drag",
        shown: Test(
            "tests/commands/comparing.rs",
            "a_scene_that_one_of_the_two_does_not_take_is_a_row_with_the_reason",
        ),
    },
    Statement {
        says: "a self-test of no scene is wrong usage",
        command: "polhode self-test --random 0",
        shown: Here(64, |ran| ran.stderr.contains("--random")),
    },
    Statement {
        says: "a baseline of no order is not written",
        command: "polhode bless free-rod --scheme euler --reason why; echo $?; test ! -e polhode-baseline.json",
        shown: Here(0, |ran| ran.last() == "2"),
    },
];
