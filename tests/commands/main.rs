//! The commands from outside.

mod advise_and_sweep;
mod campaigns;
mod comparing;
mod judge;
mod program;
mod runs;
