//! The exact free rotor and a kick.
//!
//! (1)  Q: the turn of the free body in the time h in closed form, by Jacobi's elliptic functions (`free_rotor`)
//!
//! between half kicks. Source: vanzon2007, celledoni2008. Order 2 under torque, exact without; symplectic, symmetric.

use nalgebra::Vector3;

use super::Card;
use super::splitting::splitting;
use crate::arithmetic::Real;
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
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
        claims: &[
            Claim::Order(2),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::Exact(Quantity::Orientation, When::NoTorque),
            Claim::Exact(Quantity::AngularVelocity, When::NoTorque),
            Claim::VerticalMomentum,
            Claim::Rigid,
            Claim::Evaluations(1),
            Claim::Energy(EnergyOfFreeBody::Constant),
            Claim::Reversible,
            Claim::Symplectic,
            Claim::Equivariant,
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
