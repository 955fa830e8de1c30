//! Defects of 1e-20 in what is claimed exact: f64 does not hold them, double-double does.

use super::planted::{Plant, Row};
use crate::arithmetic::Real;
use crate::model::{Broken, Model, Motion, Rates, Turning};
use crate::rotation::{self, free_rotor};
use crate::schemes::{Card, ExactRotor, PeskinRk2, Scheme, Step, TurningScheme};
use crate::simulate::Contestant;

/// What the defects are off by, relative.
const OFF: f64 = 1e-20;

/// The defects, and the scenes that show them.
pub(super) const BEYOND_F64: &[Row] = &[
    (
        "a rotation angle off by 1e-20",
        Plant::Other(|| Contestant::new(Part::Spin)),
        &["fast-sphere", "slow-sphere"],
    ),
    (
        "a velocity off by 1e-20",
        Plant::Other(|| Contestant::new(Part::Velocity)),
        &["osrf-boxes-complex", "nasa-check-case-2"],
    ),
    (
        "a force off by 1e-20",
        Plant::Other(|| Contestant::new(Part::Acceleration)),
        &["osrf-boxes-complex", "nasa-check-case-2"],
    ),
    (
        "the period of the free rotor off by 1e-20",
        Plant::Other(|| Contestant::turning(SlowRotor)),
        &["free-asymmetric", "dzhanibekov"],
    ),
    (
        "an angular momentum that grows by 1e-20 a step",
        Plant::Other(|| Contestant::turning(GrowingMomentum)),
        &["free-asymmetric", "dzhanibekov"],
    ),
];

/// 1 + 1e-20.
fn off<T: Real>() -> T {
    T::constant(1.0, OFF)
}

/// peskin-rk2 with one part of its last rates off.
#[derive(Clone, Copy)]
enum Part {
    Spin,
    Velocity,
    Acceleration,
}

impl Part {
    fn bend<T: Real>(self, motion: Motion<T>) -> Motion<T> {
        match self {
            Part::Spin => Motion { spin: motion.spin * off::<T>(), ..motion },
            Part::Velocity => Motion { velocity: motion.velocity * off::<T>(), ..motion },
            Part::Acceleration => Motion { acceleration: motion.acceleration * off::<T>(), ..motion },
        }
    }
}

impl Scheme for Part {
    fn card(&self) -> Card {
        PeskinRk2.card()
    }

    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [half] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h / 2.0, &k0, half);
        let k1 = model.rates(t + h / 2.0, half)?;
        model.advance(from, h, &M::Rates::of(self.bend(k1.motion())), to);
        Ok(())
    }
}

/// The turn of the free rotor in a time that is off.
#[derive(Clone, Copy)]
struct SlowRotor;

impl TurningScheme for SlowRotor {
    fn card(&self) -> Card {
        ExactRotor.card()
    }

    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = false;

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        turned(model, step, off(), M::Real::of(1.0))
    }
}

/// The exact free rotor with an L that grows.
#[derive(Clone, Copy)]
struct GrowingMomentum;

impl TurningScheme for GrowingMomentum {
    fn card(&self) -> Card {
        ExactRotor.card()
    }

    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = false;
    const KEEPS_MOMENTUM: bool = false;

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        turned(model, step, M::Real::of(1.0), off())
    }
}

/// The step of the exact free rotor without torque, in a time and to an L that are so many times the right ones.
fn turned<M: Turning>(
    model: &M,
    Step { t, h, from, to, .. }: Step<M>,
    time: M::Real,
    growth: M::Real,
) -> Result<(), Broken> {
    // A step evaluates the rates once.
    model.rates(t, from)?;
    to.clone_from(from);
    let (attitude, momentum) = (model.attitude(from), model.momentum(from));
    let body = attitude.inverse_transform_vector(&momentum);
    let q = free_rotor::turn_in(&model.rotational().moments, &body, h * time);
    model.place(to, rotation::renormalized(attitude * q), momentum * growth);
    model.drift(to, h);
    Ok(())
}
