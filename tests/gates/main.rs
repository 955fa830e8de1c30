//! Every gate at its bounds: cases whose numbers are made up, so that what must hold at a bound and what beyond it are known.
//! `claims.rs` asks the same gates about real runs.

mod case;
mod consistency;
mod counted;
mod energies;
mod exactness;
mod excuses;
mod flips;
mod orders;
mod sameness;
mod tolerances;
mod whole;
