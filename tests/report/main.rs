//! The report: what it must hold whatever was measured, the output for build servers, and that the published
//! one is up to date.

#[path = "../common/mod.rs"]
mod common;

mod pages;
mod published;
mod published_numbers;
mod synthetic;
mod texts;
mod written;
