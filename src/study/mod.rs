//! Questions beside the gate: where a scheme is stable, which one to take, what a parameter does, what a step costs, and
//! what others published.

#[cfg(feature = "cli")]
pub mod advice;
pub mod cause;
pub mod cost;
#[cfg(feature = "cli")]
pub mod ensemble;
#[cfg(feature = "cli")]
pub mod expect;
#[cfg(feature = "cli")]
pub mod precision;
#[cfg(feature = "cli")]
pub mod published;
#[cfg(feature = "cli")]
pub mod stability;
#[cfg(feature = "cli")]
pub mod sweep;
