//! What the schemes of Adams and Bashforth share: rates of earlier steps, weighted, in a vector space.
//!
//! (1)  q(t+h) = q(t) + h Σ_j b_j q̇(t − j h),  q̇ = ½ Ω q, then scaled back to length one
//! (2)  X_cm, U_cm and L likewise from U_cm, F/M and τ
//!
//! (1) is in quaternions: weighted spins held in one exact rotation would be of second order at most, because spins
//! at different times do not commute.
//!
//! Earlier states stand behind those of the start-up scheme, the latest last, as their rates do in the history.

use nalgebra::Quaternion;

use super::{PeskinRk4, Scheme, Workspace};
use crate::model::{Broken, Turning};
use crate::rotation::Rotation;

/// b of three rates, from the latest to the earliest.
pub(super) const THREE: [f64; 3] = [23.0 / 12.0, -16.0 / 12.0, 5.0 / 12.0];
/// b of four rates.
pub(super) const FOUR: [f64; 4] = [55.0 / 24.0, -59.0 / 24.0, 37.0 / 24.0, -9.0 / 24.0];

/// States of a method with so many weights: those of the start-up scheme and the earlier ones.
pub(super) const fn states(weights: usize) -> usize {
    PeskinRk4::STATES + weights - 1
}

/// Takes a step by `peskin-rk4` while the history is short, and keeps its rates; whether it did.
pub(super) fn start<M: Turning, const N: usize>(
    model: &M,
    t: f64,
    h: f64,
    from: &M::State,
    to: &mut M::State,
    work: &mut Workspace<M>,
) -> Result<bool, Broken> {
    let known = work.history.len();
    if known + 1 >= N {
        return Ok(false);
    }
    work.history.push(model.rates(t, from)?);
    work.states[PeskinRk4::STATES + known].clone_from(from);
    PeskinRk4::step(model, t, h, from, to, work)?;
    Ok(true)
}

/// A step; `weights` from the latest rates to the earliest. An empty history is filled with the rates of now.
pub(super) fn step<M: Turning, const N: usize>(
    weights: &[f64; N],
    model: &M,
    t: f64,
    h: f64,
    from: &M::State,
    to: &mut M::State,
    work: &mut Workspace<M>,
) -> Result<(), Broken> {
    let (k0, past) = (model.rates(t, from)?, &mut work.states[PeskinRk4::STATES..]);
    if work.history.is_empty() {
        work.history.resize(N - 1, k0);
        past.fill(from.clone());
    }
    let mut rates = k0 * weights[0];
    let mut change = derivative(model, from, &k0) * weights[0];
    for (weight, (k, state)) in weights[1..].iter().zip(work.history.iter().zip(past.iter()).rev()) {
        rates = rates + *k * *weight;
        change += derivative(model, state, k) * *weight;
    }
    model.advance(from, h, &rates, to); // (2)
    let attitude = Rotation::new_normalize(model.attitude(from).into_inner() + change * h); // (1)
    let momentum = model.momentum(to);
    model.place(to, attitude, momentum);
    past.rotate_left(1);
    work.history.rotate_left(1);
    if let (Some(state), Some(k)) = (past.last_mut(), work.history.last_mut()) {
        state.clone_from(from);
        *k = k0;
    }
    Ok(())
}

/// q̇ = ½ Ω q [1/s].
fn derivative<M: Turning>(model: &M, state: &M::State, rates: &M::Rates) -> Quaternion<f64> {
    Quaternion::from_imag(model.spin_of(rates) * 0.5) * model.attitude(state).into_inner()
}
