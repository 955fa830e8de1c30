//! Mutated scenes and command lines, thousands of them.

use crate::mutated_commands::{take_mutated_lines, take_mutated_scenes};

#[test]
fn five_thousand_mutated_scenes_are_read_or_refused() {
    assert!(take_mutated_scenes(5000, 2) > 500);
}

#[test]
fn a_thousand_mutated_command_lines_are_taken_or_refused() {
    assert!(take_mutated_lines(1000, 2) > 200);
}
