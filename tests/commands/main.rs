//! The commands from outside.

#[path = "../common/mod.rs"]
mod common;

/// The logs that the slow tests judge a thousand of.
#[path = "../common/changed_logs.rs"]
mod changed_logs;

mod advice;
mod advise_and_sweep;
mod campaigns;
mod comparing;
mod explained_logs;
mod files;
mod inspect;
mod judge;
mod log_formats;
mod lists;
mod reference;
mod runs;
mod scene;
mod stability;
