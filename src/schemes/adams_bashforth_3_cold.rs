//! Adams and Bashforth's method on three rates, its history filled with the first one.
//!
//! (1), (2)  as in `adams_bashforth`, with the weights b = 23/12, −16/12, 5/12
//! (0)  at t = 0 all earlier rates are those of t = 0: the first step is Euler's
//!
//! Source: bashforth1883 for the weights; jsbsim for integrating attitudes so, started like this. The error of the
//! first step, ∝ h², stays in the motion: second order, whatever the weights promise.

use super::{Card, TurningScheme, Workspace, adams_bashforth};
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
use crate::model::{Broken, Turning};

/// Adams–Bashforth on three rates, cold.
#[derive(Clone, Copy, Debug)]
pub struct AdamsBashforth3Cold;

impl TurningScheme for AdamsBashforth3Cold {
    const CARD: Card = Card {
        name: "adams-bashforth-3-cold",
        title: "Adams–Bashforth 3 in quaternions, history filled with the first rates",
        family: "multistep",
        source: "bashforth1883; jsbsim",
        claims: &[
            Claim::Order(2),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::NoForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::Exact(Quantity::AngularVelocity, When::SteadySpin),
            Claim::VerticalMomentum,
            Claim::FlipTimes,
            Claim::Evaluations(1),
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
        adams_bashforth::step(&adams_bashforth::THREE, model, t, h, from, to, work) // (0)–(2)
    }
}
