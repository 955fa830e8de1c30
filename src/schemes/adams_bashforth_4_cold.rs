//! Adams and Bashforth's method on four rates, its history filled with the first one.
//!
//! (1), (2)  as in `adams_bashforth`, with the weights b = 55/24, −59/24, 37/24, −9/24
//! (0)  at t = 0 all earlier rates are those of t = 0: the first step is Euler's
//!
//! Source: bashforth1883 for the weights; jsbsim for integrating attitudes so, started like this. The error of the
//! first step, ∝ h², stays in the motion: second order, whatever the weights promise.

use super::{Card, TurningScheme, Workspace, adams_bashforth};
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
use crate::model::{Broken, Turning};

/// Adams–Bashforth on four rates, cold.
#[derive(Clone, Copy, Debug)]
pub struct AdamsBashforth4Cold;

impl TurningScheme for AdamsBashforth4Cold {
    const CARD: Card = Card {
        name: "adams-bashforth-4-cold",
        title: "Adams–Bashforth 4 in quaternions, history filled with the first rates",
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
        adams_bashforth::step(&adams_bashforth::FOUR, model, t, h, from, to, work) // (0)–(2)
    }
}
