//! A command that is killed leaves whole rows, and goes on from there.

use std::fs;

use crate::common::program::{code, polhode_in, scratch, stderr};
use crate::killing::{commands, random};

#[test]
fn a_killed_command_leaves_whole_rows_and_ends_with_the_files_of_an_unbroken_one() {
    for (command, seed) in commands().iter().zip(1..) {
        let whole = command.unbroken();
        let kills = command.killed_until_it_ends(&whole, 4, &mut random(seed));
        assert!(kills > 0, "{:?}", command.arguments);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn rows_of_a_run_that_did_not_end_are_not_thrown_away_unless_that_is_asked_for() {
    let folder = scratch();
    let gate = |more: &[&str]| {
        let options = [
            "gate",
            "free-rod",
            "free-oblate",
            "--scheme",
            "euler",
            "--scheme",
            "peskin-heun",
            "--json",
            "now.json",
        ];
        polhode_in(folder.path(), &[&options[..], more].concat())
    };
    let rows = folder.path().join("now.json.rows");
    // The records are written and the next file cannot be: the rows stay.
    let full = || {
        assert_eq!(code(&gate(&["--junit", "/dev/full"])), 74);
        fs::read_to_string(&rows).expect("rows")
    };
    let text = full();
    assert_eq!(text.lines().count(), 5);
    let refused = gate(&[]);
    assert_eq!(code(&refused), 74, "{}", stderr(&refused));
    assert!(["--resume", "--force", " 4 "].iter().all(|word| stderr(&refused).contains(word)));
    assert_eq!(fs::read_to_string(&rows).expect("kept"), text);
    // A row that is cut is measured again.
    fs::write(&rows, &text[..text.len() - 10]).expect("written");
    let resumed = gate(&["--resume"]);
    assert_eq!(code(&resumed), 0, "{}", stderr(&resumed));
    assert!(stderr(&resumed).contains("3 rows"), "{}", stderr(&resumed));
    assert!(!rows.exists());
    full();
    let anew = gate(&["--force"]);
    assert!(code(&anew) == 0 && !stderr(&anew).contains("rows") && !rows.exists(), "{}", stderr(&anew));
    // Rows of another program are no rows.
    fs::write(&rows, "my notes").expect("written");
    assert_eq!(code(&gate(&["--resume"])), 74);
    assert_eq!(fs::read_to_string(&rows).expect("kept"), "my notes");
}

#[test]
fn a_command_that_cannot_begin_leaves_no_rows() {
    let folder = scratch();
    let output =
        polhode_in(folder.path(), &["gate", "--scheme", "engine:/no/such/program", "--json", "now.json"]);
    assert_eq!(code(&output), 69, "{}", stderr(&output));
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}
