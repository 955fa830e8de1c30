//! The exact free rotor and a kick.
//!
//! (1)  Q: the turn of the free body in the time h in closed form, by Jacobi's elliptic functions (`free_rotor`)
//!
//! between half kicks. Source: vanzon2007, celledoni2008. Order 2 under torque, exact without; symplectic, symmetric.

use nalgebra::Vector3;

use super::Card;
use super::families::{KICKS, claims};
use super::splitting::splitting;
use crate::arithmetic::Real;
use crate::model::{Broken, Rotational};
use crate::rotation::Rotation;
use crate::rotation::free_rotor;

splitting! {
    /// Jacobi's elliptic functions and a kick.
    ExactRotor, free_turn, Card {
        name: "exact-rotor",
        title: "Exact free rotor by elliptic functions, and a kick",
        family: "geometric",
        source: "vanzon2007; celledoni2008",
        claims: claims![KICKS;
            Exact(Orientation, NoTorque), Exact(AngularVelocity, NoTorque), Energy(Constant),
        ],
    }
}

fn free_turn<T: Real>(
    rotational: &Rotational<T>,
    momentum: &Vector3<T>,
    h: T,
) -> Result<Rotation<T>, Broken> {
    Ok(free_rotor::turn_in(&rotational.moments, momentum, h)) // (1)
}
