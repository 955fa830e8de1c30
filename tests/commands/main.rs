//! The commands from outside.

#[path = "../common/mod.rs"]
mod common;

mod advice;
mod advise_and_sweep;
mod baselines;
mod campaigns;
mod comparing;
mod expecting;
mod files;
mod help;
mod inspect;
mod judge;
mod killed;
mod lists;
mod reference;
mod runs;
mod settings;
mod stability;
