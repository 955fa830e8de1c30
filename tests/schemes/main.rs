//! The schemes: their steps against independent computations, their orders, errors and energies against known
//! ones, what they solve and allocate.

#[path = "../common/mod.rs"]
mod common;

mod allocations;
mod any_scale;
mod arithmetics;
mod classical;
mod constrained;
mod forms_agree;
mod geometric;
mod golden_steps;
mod measured_elsewhere;
mod one_step;
mod orders_of_laws;
mod orders_under_torque;
mod shortcuts;
mod solves;
mod variants;
