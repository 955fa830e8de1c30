//! Adams and Bashforth's method on three rates, with an exact start.
//!
//! (1), (2)  as in `adams_bashforth`, with the weights b = 23/12, −16/12, 5/12
//! (0)  the first 2 steps by `peskin-rk4`, whose error does not cap the order
//!
//! Source: bashforth1883 for the weights; jsbsim for integrating attitudes so. Third order at one evaluation a step.

use super::{Card, TurningScheme, Workspace, adams_bashforth};
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
use crate::model::{Broken, Turning};

/// Adams–Bashforth on three rates.
#[derive(Clone, Copy, Debug)]
pub struct AdamsBashforth3;

impl TurningScheme for AdamsBashforth3 {
    const CARD: Card = Card {
        name: "adams-bashforth-3",
        title: "Adams–Bashforth 3 in quaternions, exact start",
        family: "multistep",
        source: "bashforth1883; jsbsim",
        claims: &[
            Claim::Order(3),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::Exact(Quantity::AngularVelocity, When::SteadySpin),
            Claim::VerticalMomentum,
            Claim::FlipTimes,
            Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 3 }),
            Claim::Equivariant,
        ],
    };
    const STATES: usize = adams_bashforth::states(3);
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
        if adams_bashforth::start::<M, 3>(model, t, h, from, to, work)? {
            return Ok(()); // (0)
        }
        adams_bashforth::step(&adams_bashforth::THREE, model, t, h, from, to, work) // (1), (2)
    }
}
