//! The commands from outside.

#[path = "../common/mod.rs"]
mod common;

mod advice;
mod advise_and_sweep;
mod campaigns;
mod comparing;
mod files;
mod inspect;
mod judge;
mod lists;
mod reference;
mod runs;
mod scene;
mod stability;
