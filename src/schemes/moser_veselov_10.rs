//! Moser–Veselov preprocessed to order 10 for a free body, and a kick.
//!
//! (1)  Ĩ from I, l and h: the series of `preprocessing` with four of its polynomials
//! (2)  the discrete Moser–Veselov equation with Ĩ in place of I
//!
//! Source: hairer2006mv. Order 10 without torque, 2 with the kicks of a torque; symplectic, symmetric; a free body keeps
//! energy and |L| to rounding.

use nalgebra::Vector3;

use super::moser_veselov::discrete_turn;
use super::preprocessing::{preprocessed, preprocessed_scheme};
use crate::claim::{Claim, Quantity, When};
use crate::model::{Broken, Rotational};
use crate::rotation::Rotation;

preprocessed_scheme! {
    /// Preprocessed to order 10.
    MoserVeselov10, "moser-veselov-10", "Moser-Veselov preprocessed to order 10, and a kick", 4
}
