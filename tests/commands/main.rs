//! The commands from outside.

#[path = "../common/mod.rs"]
mod common;

/// The logs that the slow tests judge a thousand of.
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

mod advice;
mod advise_and_sweep;
mod baselines;
mod campaigns;
mod comparing;
mod expecting;
mod explained_logs;
mod files;
mod help;
mod inspect;
mod inspect_stepping;
mod interrupted;
mod json_forms;
mod judge;
mod killed;
mod lists;
mod log_formats;
mod log_series;
mod mutated;
mod read_only;
mod records_faults;
mod reference;
mod runs;
mod scene;
mod settings;
mod stability;
mod statements;
mod terminal;
