//! The report: what it must hold whatever was measured, what build servers are told, and that the published
//! one is up to date.

#[path = "../common/mod.rs"]
mod common;

mod published;
mod published_numbers;
mod synthetic;
mod texts;
mod written;
