//! A reference of our own to 25 digits: a Taylor series of high order in double-double arithmetic.
//!
//! It shares nothing with the other references: its arithmetic ([`DoubleDouble`]), its equations (world L and a
//! quaternion, every law written once more) and its method are all written here. Its error is what two runs of
//! different order and step disagree by: the second has the larger error of truncation, its rounding errors are
//! others, and its inertia and angular momentum are off by a rounding, so that what the motion makes of one shows too.
//! [`DIFFERENCE`] times the largest difference so far is the bound that is told.
//!
//! A body on the ground is followed from one touch or leave to the next, each found to the last digit on the series of
//! depth and push.

mod contact;
mod crossings;
pub mod decimal;
mod double_double;
mod laws;
mod matter;
mod pieces;
mod problem;
mod scale;
mod sheet;
mod solution;
mod stretch;
mod tape;
mod taylor;
mod triple;

pub use double_double::DoubleDouble;
pub use solution::{AFFORDABLE, DIFFERENCE, MOST_DIGITS, Moment, Motion, solve};
