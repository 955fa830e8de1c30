//! Mutated scenes and command lines, some hundred; the slow tests take thousands.

use crate::mutated_commands::{take_mutated_lines, take_mutated_scenes};

#[test]
fn a_mutated_scene_is_read_or_refused_and_nothing_panics() {
    assert!(take_mutated_scenes(200, 1) > 10);
}

#[test]
fn a_mutated_command_line_is_taken_or_refused_and_nothing_panics() {
    assert!(take_mutated_lines(100, 1) > 10);
}
