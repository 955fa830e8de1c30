//! Adams and Bashforth's method on four rates, with an exact start.
//!
//! (1), (2)  as in `adams_bashforth`, with the weights b = 55/24, −59/24, 37/24, −9/24
//! (0)  the first 3 steps by `peskin-rk4`, whose error does not cap the order
//!
//! Source: bashforth1883 for the weights; jsbsim for integrating attitudes so. Fourth order at one evaluation a step.

use super::{Card, TurningScheme, Workspace, adams_bashforth};
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
use crate::model::{Broken, Turning};

/// Adams–Bashforth on four rates.
#[derive(Clone, Copy, Debug)]
pub struct AdamsBashforth4;

impl TurningScheme for AdamsBashforth4 {
    const CARD: Card = Card {
        name: "adams-bashforth-4",
        title: "Adams–Bashforth 4 in quaternions, exact start",
        family: "multistep",
        source: "bashforth1883; jsbsim",
        claims: &[
            Claim::Order(4),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::Exact(Quantity::AngularVelocity, When::SteadySpin),
            Claim::VerticalMomentum,
            Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 5 }),
            Claim::Equivariant,
        ],
    };
    const STATES: usize = adams_bashforth::states(4);
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(
        model: &M,
        t: f64,
        h: f64,
        from: &M::State,
        to: &mut M::State,
        work: &mut Workspace<M>,
    ) -> Result<(), Broken> {
        if adams_bashforth::start::<M, 4>(model, t, h, from, to, work)? {
            return Ok(()); // (0)
        }
        adams_bashforth::step(&adams_bashforth::FOUR, model, t, h, from, to, work) // (1), (2)
    }
}
