//! What the engines' first-order rules share: velocities first, then positions and orientation by them.

use nalgebra::Vector3;

use super::vector_form::quaternion_rate;
use crate::model::Turning;
use crate::rotation::{normalized, turned_back};

/// The spin about the principal axes and the torque about them, at a state with these rates.
#[inline]
pub(super) fn in_body_axes<M: Turning>(
    model: &M,
    state: &M::State,
    rates: &M::Rates,
) -> (Vector3<M::Real>, Vector3<M::Real>) {
    let attitude = model.attitude(state);
    let to_body = |v: Vector3<M::Real>| turned_back(&attitude, &v);
    (to_body(model.spin_of(rates)), to_body(model.torque_of(rates)))
}

/// ω₁ = ω₀ + h I⁻¹ (τ − ω₀ × I ω₀), about the principal axes of the old attitude.
#[inline]
pub(super) fn explicit_spin<M: Turning>(
    model: &M,
    h: M::Real,
    from: &M::State,
    rates: &M::Rates,
) -> Vector3<M::Real> {
    let (spin, torque) = in_body_axes(model, from, rates);
    let body = model.rotational();
    let gyroscopic = spin.cross(&body.moments.component_mul(&spin));
    spin + body.inverse_moments.component_mul(&(torque - gyroscopic)) * h
}

/// The step once the new spin ω₁ is known, about the principal axes of the old attitude:
/// U₁ = U₀ + h F/M, X₁ = X₀ + h U₁, q₁ = q₀ + h/2 Ω₁ q₀ over its length, L₁ = I(q₁) Ω₁ with Ω₁ = R₀ ω₁.
#[inline]
pub(super) fn move_by<M: Turning>(
    model: &M,
    h: M::Real,
    from: &M::State,
    rates: &M::Rates,
    spin: &Vector3<M::Real>,
    to: &mut M::State,
) {
    to.clone_from(from);
    model.kick(to, h, rates);
    model.drift(to, h);
    let attitude = model.attitude(from);
    let spin = attitude * spin;
    let turned = normalized(*attitude + quaternion_rate(&spin, &attitude) * h);
    let momentum = turned * turned_back(&turned, &spin).component_mul(&model.rotational().moments);
    model.place(to, turned, momentum);
}
