//! Output that answers.

use super::{Here, Ran, Statement, Test};

/// Whether rows are no wider than a page.
fn fits(ran: &Ran) -> bool {
    ran.stdout.lines().count() > 5 && ran.stdout.lines().all(|line| line.chars().count() <= 100)
}

pub const STATEMENTS: [Statement; 53] = [
    Statement {
        says: "a green gate is a line a scheme and a summary",
        command: "polhode gate free-rod free-oblate --scheme euler --scheme peskin-rk2 --quiet",
        // Two schemes, the references, a blank line, the summary.
        shown: Here(0, |ran| ran.stdout.lines().count() == 5 && ran.is_silent()),
    },
    Statement {
        says: "a red gate is a line more a scheme and scene, the size of the error before the rule",
        command: "polhode gate free-oblate --scheme euler --order 2",
        shown: Here(1, |ran| {
            let red: Vec<&str> = ran.stdout.lines().filter(|line| line.starts_with("fail: ")).collect();
            let place = |word: &str| red.first().and_then(|line| line.find(word));
            red.len() == 1 && place(" off by ").is_some() && place(" off by ") < place("order, body-point")
        }),
    },
    Statement {
        says: "--verbose gives ten lines at most to a scheme in a scene",
        command: "polhode gate kovalevskaya --scheme peskin-rk2 --verbose",
        shown: Here(0, |ran| {
            let blocks: Vec<usize> = ran.stdout.split("\n\n").map(|block| block.lines().count()).collect();
            blocks[0] > 3 && blocks.iter().all(|lines| *lines <= 10)
        }),
    },
    Statement {
        says: "an order is one row a quantity, not one at the end and one at most",
        command: "polhode gate free-oblate --scheme euler --format json",
        shown: Here(0, |ran| {
            let all = ran.json();
            let rows = all["verdicts"].as_array().expect("rows");
            let orders = rows.iter().filter(|row| row["claim"] == "order");
            let names: Vec<&str> = orders.filter_map(|row| row["quantity"].as_str()).collect();
            let mut once = names.clone();
            once.dedup();
            !names.is_empty() && once == names && !names.iter().any(|name| name.ends_with("-end"))
        }),
    },
    Statement {
        says: "compare ends with a ratio at equal work",
        command: "polhode compare peskin-rk2 peskin-heun free-oblate --quiet",
        shown: Here(1, |ran| {
            ran.last().starts_with("peskin-heun's orientation error is ")
                && ran.last().contains(" × peskin-rk2's at equal work")
        }),
    },
    Statement {
        says: "the ratio of several scenes is their geometric mean with its range, and rows that are the same are hidden",
        command: "polhode compare peskin-rk2 peskin-heun free-asymmetric kovalevskaya --all",
        shown: Test(
            "tests/commands/comparing.rs",
            "a_comparison_ends_with_a_sentence_and_hides_what_is_the_same",
        ),
    },
    Statement {
        says: "compare writes text, CSV, JSON, Markdown and LaTeX",
        command: "polhode compare peskin-rk2 euler free-asymmetric --format latex",
        shown: Test("tests/commands/comparing.rs", "a_comparison_has_five_forms_and_a_page_is_100_columns"),
    },
    Statement {
        says: "list schemes has name, order, evaluations, family and title in 100 columns",
        command: "polhode list schemes | head -60",
        shown: Here(0, |ran| {
            let head: Vec<&str> = ran.stdout.lines().next().unwrap_or_default().split_whitespace().collect();
            fits(ran) && head == ["name", "order", "evals", "family", "title"]
        }),
    },
    Statement {
        says: "list schemes NAME shows the card",
        command: "polhode list schemes peskin-rk2",
        shown: Here(0, |ran| ["order 2", "fails where"].iter().all(|word| ran.stdout.contains(word))),
    },
    Statement {
        says: "list forces prints a block to paste, with units",
        command: "(cat scene.toml; echo; polhode list forces gravity) > with.toml; polhode run with.toml --steps 4; polhode list forces gravity",
        shown: Here(0, |ran| ran.stdout.contains("\"status\": \"ok\"") && ran.stdout.contains("m/s²")),
    },
    Statement {
        says: "every block of list forces parses",
        command: "polhode list forces",
        shown: Test("tests/scenes/tables.rs", "every_block_parses_and_gives_the_example_of_every_parameter"),
    },
    Statement {
        says: "scene show prints the file",
        command: "polhode scene show free-rod --quiet | diff - scene.toml",
        shown: Here(0, |ran| ran.stdout.is_empty()),
    },
    Statement {
        says: "scene new --from begins with a scene, names its schema and runs",
        command: "polhode scene new mine --from kovalevskaya && polhode run mine.toml --steps 64",
        shown: Here(0, |ran| ran.text("mine.toml").starts_with("#:schema ./")),
    },
    Statement {
        says: "advise begins with the advice in a sentence, in plain numbers",
        command: "polhode advise free-oblate --tolerance 1e-2 --scheme peskin-rk2 --scheme euler",
        shown: Here(0, |ran| {
            let first = ran.stdout.lines().next().unwrap_or_default();
            let step = first.strip_prefix("Take peskin-rk2 with a step of ").unwrap_or_default();
            let number = step.split(' ').next().unwrap_or_default();
            number.parse::<f64>().is_ok_and(|step| step > 0.0) && !number.contains('e')
        }),
    },
    Statement {
        says: "advise shows the ten best, and unstable ones apart",
        command: "polhode advise free-asymmetric --tolerance 1e-2",
        shown: Test(
            "tests/commands/advise_and_sweep.rs",
            "advice_begins_with_a_sentence_and_shows_the_cheapest_in_plain_numbers",
        ),
    },
    Statement {
        says: "run has a scheme and a step where none is named, and says which",
        command: "polhode run free-rod",
        shown: Here(0, |ran| ran.json()["scheme"] == "peskin-rk2" && ran.stderr.contains("with a step of")),
    },
    Statement {
        says: "sweep has a scheme and a step where none is named, and says which",
        command: "polhode sweep free-rod --vary body.scale=1:2:2",
        shown: Here(0, |ran| ran.stdout.lines().count() == 3 && ran.stderr.contains("under peskin-rk2")),
    },
    Statement {
        says: "a step that does not divide the duration is taken to the nearest, and said",
        command: "polhode run free-asymmetric --step 0.3",
        shown: Here(0, |ran| ran.json()["steps"] == 27 && ran.stderr.contains("27 steps")),
    },
    Statement {
        says: "sweep says which files it wrote",
        command: "polhode sweep free-rod --vary step=0.1:0.2:2 --out f.csv",
        shown: Here(0, |ran| {
            ["f.csv", "f.png"]
                .iter()
                .all(|name| ran.stderr.contains(name) && ran.folder.path().join(name).is_file())
        }),
    },
    Statement {
        says: "sweep says why a column is empty",
        command: "polhode sweep gravity-drag --vary body.scale=0.5:2:3 --step 0.37 --errors never",
        shown: Here(0, |ran| ran.stderr.contains("no energy: ")),
    },
    Statement {
        says: "reference prints quaternions at the times that are asked for, as JSON",
        command: "polhode reference kovalevskaya --times 0.5,1 --digits 12 --format json",
        shown: Here(0, |ran| {
            let moments = ran.json()["moments"].as_array().cloned().unwrap_or_default();
            moments.len() == 2 && moments[0]["orientation_wxyz"].as_array().map(Vec::len) == Some(4)
        }),
    },
    Statement {
        says: "reference prints CSV",
        command: "polhode reference kovalevskaya --times 0.5,1 --digits 12 --format csv",
        shown: Here(0, |ran| ran.stdout.lines().count() == 51),
    },
    Statement {
        says: "engine compare prints its table",
        command: "polhode engine compare free-asymmetric --scheme 'engine:python3 engine.py' --scheme peskin-rk2",
        shown: Test("tests/engines/peers.rs", "engines_are_compared_on_a_page_of_their_own"),
    },
    Statement {
        says: "expect predicts the error of each quantity at the end and over the run, with its band",
        command: "polhode expect free-asymmetric --scheme peskin-rk2 --step 0.01 --format json",
        shown: Here(0, |ran| {
            let answer = ran.json();
            let rows = answer["expected"].as_array().expect("rows");
            let whole = |row: &&serde_json::Value| {
                ["end", "end_band", "max", "max_band"].iter().all(|key| row[*key].is_number())
            };
            answer["checked_at_s"].as_array().map(Vec::len) == Some(2)
                && rows.iter().filter(whole).count() > 2
        }),
    },
    Statement {
        says: "what expect predicts holds in a run",
        command: "polhode expect free-asymmetric --scheme euler --step 0.01",
        shown: Test("tests/commands/expecting.rs", "a_prediction_holds_in_a_run_at_its_step"),
    },
    Statement {
        says: "expect prints the assertion to paste into Python, C++ and Rust",
        command: "polhode expect free-asymmetric --scheme peskin-rk2 --step 0.01 --quantity orientation",
        shown: Here(0, |ran| {
            [
                "\nassert orientation_error <= ",
                "\nassert(orientation_error <= ",
                "\nassert!(orientation_error <= ",
            ]
            .iter()
            .all(|line| ran.stdout.contains(line))
        }),
    },
    Statement {
        says: "without a terminal there is a line at least every ten seconds",
        command: "polhode run free-rod --steps 100000000000 --every 1000000 --out run.json 2> log",
        shown: Test(
            "tests/slow/signs_of_life.rs",
            "long_commands_without_a_terminal_write_a_line_again_and_again",
        ),
    },
    Statement {
        says: "a reader that goes away ends a run silently with 0",
        command: "polhode run free-rod --steps 100000 --format csv | head -1",
        shown: Here(0, |ran| ran.is_silent() && ran.last().starts_with("step,t,x,y,z")),
    },
    Statement {
        says: "a reader that goes away ends a list silently with 0",
        command: "polhode list claims | head -1",
        shown: Here(0, |ran| ran.is_silent() && ran.stdout.lines().count() == 1),
    },
    Statement {
        says: "pass and fail have colours where that is wanted",
        command: "polhode gate free-rod --scheme euler --color always",
        shown: Here(0, |ran| ran.stdout.contains("\u{1b}[32mpass")),
    },
    Statement {
        says: "there is no colour without a terminal",
        command: "polhode gate free-oblate --scheme euler --order 2",
        shown: Here(1, |ran| !ran.stdout.contains('\u{1b}') && !ran.stderr.contains('\u{1b}')),
    },
    Statement {
        says: "NO_COLOR is obeyed on a terminal, and verdicts have colours there",
        command: "NO_COLOR=1 polhode gate free-rod --scheme euler",
        shown: Test(
            "tests/commands/terminal.rs",
            "a_verdict_is_in_colour_on_a_terminal_and_not_where_the_user_wants_none",
        ),
    },
    Statement {
        says: "tables and help are no wider than the terminal",
        command: "polhode list scenes",
        shown: Test("tests/commands/terminal.rs", "tables_and_help_are_no_wider_than_the_terminal"),
    },
    Statement {
        says: "a bar of progress is on the terminal and not in the data",
        command: "polhode gate free-rod kovalevskaya --scheme euler > file",
        shown: Test("tests/commands/terminal.rs", "progress_goes_to_stderr_and_needs_a_terminal"),
    },
    Statement {
        says: "help of a subcommand is one screen of 24 lines and 100 columns",
        command: "polhode gate --help",
        shown: Here(0, |ran| fits(ran) && ran.stdout.lines().count() <= 24),
    },
    Statement {
        says: "help of every subcommand is one screen, and the long form has examples",
        command: "polhode help gate",
        shown: Test("tests/commands/help.rs", "help_is_one_screen_and_the_long_form_has_examples"),
    },
    Statement {
        says: "global options stand in the long help alone",
        command: "polhode run --help",
        shown: Here(0, |ran| {
            !["--engine-timeout", "--jobs", "--config"].iter().any(|one| ran.stdout.contains(one))
        }),
    },
    Statement {
        says: "the program alone shows three commands to begin with, on one screen",
        command: "cd . ; polhode --help",
        shown: Test("tests/commands/help.rs", "the_program_alone_shows_the_three_commands_to_begin_with"),
    },
    Statement {
        says: "gate --budget estimates first, and cuts the runs that do not fit",
        command: "polhode gate free-asymmetric --scheme euler --budget 1e-9",
        shown: Here(2, |ran| ran.stderr.contains("all runs take about") && ran.stdout.contains("budget")),
    },
    Statement {
        says: "gate --budget cuts the runs of a slow engine and names what stays undecided",
        command: "polhode gate free-asymmetric --scheme 'engine:python3 engine.py' --budget 600",
        shown: Test(
            "tests/engines/budget.rs",
            "a_budget_cuts_the_runs_of_a_slow_engine_and_not_those_of_a_fast_one",
        ),
    },
    Statement {
        says: "the bound of a reference covers the rounding of the digits that it prints",
        command: "polhode reference kovalevskaya --digits 4",
        shown: Test(
            "tests/commands/reference.rs",
            "bounds_cover_the_digits_that_are_printed_and_a_quaternion_is_that_of_the_matrix",
        ),
    },
    Statement {
        says: "an engine's quaternion off unit length, a run of 0 ns and half an evaluation a step are remarked",
        command: "polhode gate free-asymmetric --scheme 'engine:python3 engine.py'",
        shown: Test(
            "src/engine/remarks.rs",
            "quaternions_off_unit_length_no_time_and_half_an_evaluation_are_remarked",
        ),
    },
    Statement {
        says: "a mistyped scheme is answered with the three nearest names",
        command: "polhode gate --scheme rk4-quaternon",
        shown: Here(64, |ran| {
            let near = ran.stderr.split("did you mean ").nth(1).and_then(|rest| rest.split('?').next());
            near.is_some_and(|near| {
                near.starts_with("rk4-quaternion")
                    && near.split(&[',', ' '][..]).filter(|word| word.contains('-')).count() == 3
            })
        }),
    },
    Statement {
        says: "a mistyped scene is answered with the three nearest names",
        command: "polhode run kovalevskaia",
        shown: Here(64, |ran| ran.stderr.contains("did you mean kovalevskaya")),
    },
    Statement {
        says: "a mistyped quantity is answered with the nearest names",
        command: "polhode advise free-rod --tolerance 1e-3 --quantity orientaton",
        shown: Here(64, |ran| ran.stderr.contains("did you mean orientation")),
    },
    Statement {
        says: "a mistyped option is answered with the nearest one",
        command: "polhode run free-rod --step 0.1 --shceme euler",
        shown: Here(64, |ran| ran.stderr.contains("--scheme")),
    },
    Statement {
        says: "a mistyped key of a sweep is answered with those that there are",
        command: "polhode sweep tether-springs --vary forces.0.stifness=1:2:3",
        shown: Here(64, |ran| ran.stderr.contains("did you mean forces.0.stiffness")),
    },
    Statement {
        says: "a scene is named by position or by --scene",
        command: "polhode run --scene free-rod --steps 4 > a; polhode run free-rod --steps 4 | diff a -",
        shown: Here(0, |ran| ran.stdout.is_empty()),
    },
    Statement {
        says: "a scene is named by position or by --scene in every command",
        command: "polhode stability free-oblate --scheme euler --cells 0 --long 0 --out out",
        shown: Test("tests/commands/lists.rs", "a_scene_is_named_by_position_or_by_option_in_every_command"),
    },
    Statement {
        says: "completions come from the parser",
        command: "polhode completions bash | bash -n",
        shown: Here(0, |ran| ran.is_silent()),
    },
    Statement {
        says: "man pages come from the parser",
        command: "polhode completions --man . && head -1 polhode-gate.1",
        shown: Here(0, |ran| !ran.text("polhode-judge.1").is_empty()),
    },
    Statement {
        says: "5,000 mutated scenes end with a listed code and no panic",
        command: "polhode scene show mutated.toml",
        shown: Test("tests/slow/mutated.rs", "five_thousand_mutated_scenes_are_read_or_refused"),
    },
    Statement {
        says: "1,000 mutated command lines end with a listed code and no panic",
        command: "polhode gate free-rod --scheme euler --order 12 --verbose",
        shown: Test("tests/slow/mutated.rs", "a_thousand_mutated_command_lines_are_taken_or_refused"),
    },
];
