//! The least model of a scene as one type, for arithmetics whose runs are not timed: a scheme is compiled once for all scenes.
//!
//! In f64 every scheme is compiled with each model by itself ([`AnyModel`](super::AnyModel)). The numbers are the same.

use nalgebra::{Quaternion, Vector3};

use super::falling::FallingState;
use super::forced::ForcedState;
use super::free::FreeState;
use super::rotor::RotorState;
use super::{
    AnyModel, Broken, Falling, Forced, Free, Model, Motion, Rates, Rotational, Rotor, Snapshot, System,
    Turning,
};
use crate::arithmetic::Real;
use crate::rotation::Rotation;

/// One of the reduced models.
#[derive(Clone, Debug)]
pub enum Least<T: Real> {
    /// Neither force nor torque.
    Free(Free<T>),
    /// Uniform gravity only.
    Falling(Falling<T>),
    /// Torques without force, or a pivot.
    Rotor(Rotor<T>),
    /// Forces on points.
    Forced(Forced<T>),
}

/// A state of it.
#[derive(Clone, Copy, Debug)]
pub enum LeastState<T: Real> {
    /// Of a free body.
    Free(FreeState<T>),
    /// Of a falling one.
    Falling(FallingState<T>),
    /// Of a rotor.
    Rotor(RotorState<T>),
    /// Of a forced body.
    Forced(ForcedState<T>),
}

impl<T: Real> Least<T> {
    /// The model of a system in its least form.
    pub fn of(system: &System<T>) -> Least<T> {
        match system.least() {
            AnyModel::Free(model) => Least::Free(model),
            AnyModel::Falling(model) => Least::Falling(model),
            AnyModel::Torque(model) | AnyModel::Pivot(model) => Least::Rotor(model),
            AnyModel::Forced(model) => Least::Forced(model),
            AnyModel::Points(_) => unreachable!("the least form of a system is a reduced one"),
        }
    }

    /// The same body with L in its state, for schemes that do not keep L by themselves.
    pub fn with_momentum(self) -> Least<T> {
        match self {
            Least::Free(model) => Least::Rotor(model.with_momentum()),
            Least::Falling(model) => Least::Forced(model.with_momentum()),
            other => other,
        }
    }
}

/// Calls a function of the model that a state belongs to.
macro_rules! on {
    ($model:expr, |$one:ident| $call:expr) => {
        match $model {
            Least::Free($one) => $call,
            Least::Falling($one) => $call,
            Least::Rotor($one) => $call,
            Least::Forced($one) => $call,
        }
    };
    ($model:expr, $state:expr, |$one:ident, $at:ident| $call:expr) => {
        match ($model, $state) {
            (Least::Free($one), LeastState::Free($at)) => $call,
            (Least::Falling($one), LeastState::Falling($at)) => $call,
            (Least::Rotor($one), LeastState::Rotor($at)) => $call,
            (Least::Forced($one), LeastState::Forced($at)) => $call,
            _ => unreachable!("a state belongs to the model that made it"),
        }
    };
    ($model:expr, $first:expr, $second:expr, |$one:ident, $at:ident, $into:ident| $call:expr) => {
        match ($model, $first, $second) {
            (Least::Free($one), LeastState::Free($at), LeastState::Free($into)) => $call,
            (Least::Falling($one), LeastState::Falling($at), LeastState::Falling($into)) => $call,
            (Least::Rotor($one), LeastState::Rotor($at), LeastState::Rotor($into)) => $call,
            (Least::Forced($one), LeastState::Forced($at), LeastState::Forced($into)) => $call,
            _ => unreachable!("a state belongs to the model that made it"),
        }
    };
}

impl<T: Real> Model for Least<T> {
    type Real = T;
    type State = LeastState<T>;
    type Rates = Motion<T>;

    fn start(&self) -> LeastState<T> {
        match self {
            Least::Free(model) => LeastState::Free(model.start()),
            Least::Falling(model) => LeastState::Falling(model.start()),
            Least::Rotor(model) => LeastState::Rotor(model.start()),
            Least::Forced(model) => LeastState::Forced(model.start()),
        }
    }

    fn pieces(&self) -> Vec<(T, Least<T>)> {
        fn of<T: Real, M: Model<Real = T>>(model: &M, whole: fn(M) -> Least<T>) -> Vec<(T, Least<T>)> {
            model.pieces().into_iter().map(|(end, piece)| (end, whole(piece))).collect()
        }
        match self {
            Least::Free(model) => of(model, Least::Free),
            Least::Falling(model) => of(model, Least::Falling),
            Least::Rotor(model) => of(model, Least::Rotor),
            Least::Forced(model) => of(model, Least::Forced),
        }
    }

    fn rates(&self, t: T, state: &LeastState<T>) -> Result<Motion<T>, Broken> {
        on!(self, state, |model, at| Ok(model.rates(t, at)?.motion()))
    }

    fn advance(&self, from: &LeastState<T>, s: T, rates: &Motion<T>, into: &mut LeastState<T>) {
        on!(self, from, into, |model, at, to| model.advance(at, s, &Rates::of(*rates), to));
    }

    fn is_finite(&self, state: &LeastState<T>) -> bool {
        on!(self, state, |model, at| model.is_finite(at))
    }

    fn observe(&self, t: T, state: &LeastState<T>) -> Result<Snapshot<T>, Broken> {
        on!(self, state, |model, at| model.observe(t, at))
    }
}

impl<T: Real> Turning for Least<T> {
    fn rotational(&self) -> &Rotational<T> {
        on!(self, |model| model.rotational())
    }

    fn attitude(&self, state: &LeastState<T>) -> Rotation<T> {
        on!(self, state, |model, at| model.attitude(at))
    }

    fn momentum(&self, state: &LeastState<T>) -> Vector3<T> {
        on!(self, state, |model, at| model.momentum(at))
    }

    fn place(&self, state: &mut LeastState<T>, attitude: Rotation<T>, momentum: Vector3<T>) {
        on!(self, state, |model, at| model.place(at, attitude, momentum));
    }

    fn rates_at_stage(
        &self,
        t: T,
        (from, s, rates): (&LeastState<T>, T, &Motion<T>),
        q: (&Quaternion<T>, T),
        stage: &mut LeastState<T>,
    ) -> Result<(Motion<T>, Quaternion<T>), Broken> {
        on!(self, from, stage, |model, at, to| {
            let (rates, moved) = model.rates_at_stage(t, (at, s, &Rates::of(*rates)), q, to)?;
            Ok((rates.motion(), moved))
        })
    }

    fn spin_of(&self, rates: &Motion<T>) -> Vector3<T> {
        rates.spin
    }

    fn torque_of(&self, rates: &Motion<T>) -> Vector3<T> {
        rates.torque
    }

    fn kick(&self, state: &mut LeastState<T>, s: T, rates: &Motion<T>) {
        on!(self, state, |model, at| model.kick(at, s, &Rates::of(*rates)));
    }

    fn drift(&self, state: &mut LeastState<T>, s: T) {
        on!(self, state, |model, at| model.drift(at, s));
    }

    fn apart(&self, a: &LeastState<T>, b: &LeastState<T>) -> T {
        on!(self, a, b, |model, one, other| model.apart(one, other))
    }

    fn reads_velocity(&self) -> bool {
        on!(self, |model| model.reads_velocity())
    }
}
