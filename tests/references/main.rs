//! The references agree with each other, with closed forms and with stored solutions, and say how well.

#[path = "../common/mod.rs"]
mod common;

mod agreement;
mod building;
mod closed_forms;
mod contacts;
mod more_laws;
mod motions;
mod precise;
mod rounding;
mod scaling;
mod solvers;
mod stored;
mod taylor;
mod uncertainty;
