//! What a run is compared with: solutions of the Euler equations that share nothing with the schemes, and what
//! they disagree by.
//!
//! | source | what it is | good to |
//! |---|---|---|
//! | `precise` | Taylor series of our own in double-double arithmetic, from touch to touch on the ground | 1e-24 and better, with its bound |
//! | `closed` | closed forms, where the system has one: free and falling bodies, Lagrange's top, a point on springs | a few roundings times 1 + \|Ω\| t |
//! | `dop853` | differential-equations, order 8 | 1e-14 |
//! | `tsit45` | diffsol, order 5 | 1e-13 |
//! | `stored` | 24 to 40 digits at T/4, T/2, 3T/4, T | rounding |
//!
//! The first that there is gives the states at every time; all others are held against it, and one that contradicts it
//! shows in the uncertainty, which travels with every error. The asymmetric closed form shares its functions with the
//! schemes that turn by the exact free rotor: it is therefore not the first.

mod agreement;
mod best;
pub(crate) mod closed;
mod nudge;
pub(crate) mod precise;
mod sample;
#[cfg(feature = "solvers")]
mod solvers;
mod sources;
pub(crate) mod stored;

use crate::ode::SolverError;

pub use agreement::Reference;
pub use sources::{Role, Source};
pub(crate) use stored::{Stored, StoredError};

/// A reference that cannot be had.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReferenceError {
    /// A solver gives no solution.
    #[error(transparent)]
    Solver(#[from] SolverError),
    /// Times that cannot be sampled.
    #[error(
        "a reference needs a positive duration and a multiple of 4 samples; got {duration} s and {samples} samples"
    )]
    Grid {
        /// Duration [s].
        duration: f64,
        /// Samples.
        samples: usize,
    },
    /// No solver gives a solution, or none a second one.
    #[error("no reference: {first}; {second}")]
    Both {
        /// One failure.
        first: Box<ReferenceError>,
        /// The other.
        second: Box<ReferenceError>,
    },
    /// A stored solution that cannot be used.
    #[error(transparent)]
    Stored(#[from] StoredError),
    /// A stored solution that this system does not have.
    #[error(
        "the stored solution of '{scene}' does not belong to this system: at t = {time} s its {quantity} differs by {difference:e} {unit}, more than {bound:e}; give a changed scene another name"
    )]
    OtherSystem {
        /// Scene.
        scene: String,
        /// Time [s].
        time: f64,
        /// Quantity that differs.
        quantity: &'static str,
        /// Its unit.
        unit: &'static str,
        /// Difference.
        difference: f64,
        /// Largest difference that a solver's error would explain.
        bound: f64,
    },
}
