//! The gates: at their bounds, in cases whose numbers are made up; on real runs, of schemes that keep their
//! claims and of schemes that do not; and as the assertion of a user.

#[path = "../common/mod.rs"]
mod common;

mod assertion;
mod case;
mod causes;
mod claims;
mod constants;
mod counted;
mod energies;
mod exactness;
mod flips;
mod orders;
mod programs;
mod recorded_claims;
mod sameness;
mod statistics;
mod tolerances;
mod whole;
