//! Runge–Kutta stages in body axes: the attitude as a quaternion of plain numbers and l = Rᵀ L in principal axes.
//!
//! (1)  q̇ = ½ Ω q,  Ω and forces at q/|q|
//! (2)  l̇ = l × I⁻¹ l + Rᵀ τ
//!
//! L in world axes in the place of l would make l turn with the error of the attitude, and Ω with the ratio of the moments times that: 10
//! to 1000 times larger errors where a thin body flips (`osrf-boxes-complex`: 2.3e-3 rad by L, 8e-7 by body rates at 1,200
//! evaluations of order 8).

use nalgebra::{Quaternion, Vector3};

use super::vector_form::hold;
use crate::arithmetic::Real;
use crate::model::{Broken, Rates, Turning};
use crate::rotation::{rate_of, turned_back, unit};

/// How a state changes: U_cm, F/M in rates, q̇ (1) and l̇ (2).
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope<T: Real, R> {
    /// Rates of the model, of which those of the translation are used.
    pub rates: R,
    /// q̇ [1/s].
    pub turn: Quaternion<T>,
    /// l̇ [N m].
    pub gain: Vector3<T>,
}

/// Σ wⱼ kⱼ of one term at least.
#[inline(always)]
pub(super) fn sum<'a, T: Real, R: Rates<T> + 'a>(
    first: (T, &'a Slope<T, R>),
    others: impl IntoIterator<Item = (T, &'a Slope<T, R>)>,
) -> Slope<T, R> {
    let (weight, k) = first;
    let start = Slope { rates: k.rates.scaled(weight), turn: k.turn * weight, gain: k.gain * weight };
    others.into_iter().fold(start, |sum, (weight, k)| Slope {
        rates: sum.rates + k.rates.scaled(weight),
        turn: sum.turn + k.turn * weight,
        gain: sum.gain + k.gain * weight,
    })
}

/// Where a step begins.
pub(super) struct From<'a, M: Turning> {
    model: &'a M,
    state: &'a M::State,
    q: Quaternion<M::Real>,
    l: Vector3<M::Real>,
}

impl<'a, M: Turning> From<'a, M> {
    #[inline(always)]
    pub(super) fn new(model: &'a M, state: &'a M::State) -> From<'a, M> {
        let attitude = model.attitude(state);
        let l = turned_back(&attitude, &model.momentum(state));
        From { model, state, q: attitude.into_inner(), l }
    }

    /// The slope at the start.
    ///
    /// # Errors
    /// Ω does not exist.
    #[inline(always)]
    pub(super) fn slope(&self, t: M::Real) -> Result<Slope<M::Real, M::Rates>, Broken> {
        slope(self.model, t, self.state, &self.q, &self.l)
    }

    /// The slope where `mean`, held for a time `h`, leads; `stage` is a buffer.
    ///
    /// # Errors
    /// Ω does not exist.
    #[inline(always)]
    pub(super) fn stage(
        &self,
        t: M::Real,
        h: M::Real,
        mean: &Slope<M::Real, M::Rates>,
        stage: &mut M::State,
    ) -> Result<Slope<M::Real, M::Rates>, Broken> {
        let (q, l) = self.go(h, mean, stage);
        slope(self.model, t, stage, &q, &l)
    }

    /// Holds `mean` for a time `h`; gives q and l as plain numbers.
    #[inline(always)]
    pub(super) fn go(
        &self,
        h: M::Real,
        mean: &Slope<M::Real, M::Rates>,
        into: &mut M::State,
    ) -> (Quaternion<M::Real>, Vector3<M::Real>) {
        let (q, l) = (self.q + mean.turn * h, self.l + mean.gain * h);
        let attitude = unit(&q);
        hold(self.model, self.state, h, &mean.rates, attitude, into);
        self.model.place(into, attitude, attitude * l);
        (q, l)
    }
}

/// (1) and (2) at a state.
#[inline(always)]
fn slope<M: Turning>(
    model: &M,
    t: M::Real,
    state: &M::State,
    q: &Quaternion<M::Real>,
    l: &Vector3<M::Real>,
) -> Result<Slope<M::Real, M::Rates>, Broken> {
    let rates = model.rates(t, state)?;
    let torque = turned_back(&model.attitude(state), &model.torque_of(&rates));
    let spin = model.rotational().inverse_moments.component_mul(l);
    Ok(Slope {
        rates,
        turn: rate_of(&model.spin_of(&rates), q), // (1)
        gain: l.cross(&spin) + torque,            // (2)
    })
}
