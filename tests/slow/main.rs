//! What takes longer than ten seconds in an optimised build, by itself or with what belongs to it: planted
//! defects, random scenes, closed forms after a million radians, the studies of stability, a report of thirty
//! scenes. `cargo test --release` runs it like the others; `cargo test --release --test slow` runs it alone.

#[path = "../common/mod.rs"]
mod common;
/// What is known of a system, as the other tests of closed forms take it.
#[allow(dead_code, reason = "the other tests use the rest")]
#[path = "../references/closed_forms/known.rs"]
mod known;
/// The logs that the other tests judge a few of.
#[path = "../common/changed_logs.rs"]
mod changed_logs;

#[path = "../common/tallied_logs.rs"]
mod tallied_logs;

#[path = "../common/mutated_logs.rs"]
mod mutated_logs;

#[path = "../common/killing.rs"]
mod killing;

#[path = "../common/mutated_commands.rs"]
mod mutated_commands;
/// The records that the other tests of reports take a part of.
#[allow(dead_code, reason = "the other tests use the rest")]
#[path = "../report/synthetic.rs"]
mod synthetic;

mod equal_work;
mod explained_logs;
mod killed;
mod long_inputs;
mod million_radians;
mod mutated;
mod planted_defects;
mod random_scenes;
mod recurrence;
mod signs_of_life;
mod stability;
mod turning_tops;
mod whole_report;
