//! The generalised-α method on the centre of mass and the rotation, with the pivot as a constraint.
//!
//! In world axes, with V = (Ω, U) and R, X of the centre of mass, r = X − pivot, and an algorithmic acceleration A that is carried from
//! step to step:
//!
//! (1)  R₁ = exp(h D_Ω) R₀,  X₁ = X₀ + h D_U,   D = V₀ + h ((½ − β) A₀ + β A₁)
//! (2)  V₁ = V₀ + h ((1 − γ) A₀ + γ A₁)
//! (3)  (1 − α_m) A₁ + α_m A₀ = (1 − α_f) V̇₁ + α_f V̇₀
//! (4)  M U̇₁ = F₁ + λ,  J₁ Ω̇₁ + Ω₁ × J₁ Ω₁ = τ₁ − r₁ × λ,   J and τ about the centre of mass
//! (5)  r₁ = R₁ c on a pivot, which fixes λ;  λ = 0 elsewhere
//! (6)  α_m, α_f, γ, β as in [`GeneralizedAlpha`](super::GeneralizedAlpha);  A₀ = V̇₀ when a run starts
//!
//! Without λ, and with I and the torque T about the pivot, (4) reads
//!
//! (7)  I₁ Ω̇₁ = T₁ − Ω₁ × I₁ Ω₁ − M r₁ × (U̇₁ − Ω̇₁ × r₁ − Ω₁ × (Ω₁ × r₁))
//!
//! where (5), (1) and (3) give U̇₁. U₁ is not Ω₁ × r₁: the constraint is kept in the positions alone. U, U̇, Ω̇ and A stand in the history.
//!
//! Solved by fixed-point iteration. Source: bruls2012, whose corrected start A₀ = V̇₀ + (α_m − α_f) h V̈₀ is left out, as Kynema does;
//! chung1993 for (6). Second order in every quantity that a model keeps.

use nalgebra::Vector3;

use super::accelerations::{Accelerations, Alphas};
use super::families::{FLIGHT, claims};
use super::iteration::until_settled;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Carried, Motion, Rates, Turning};
use crate::rotation::{Rotation, renormalized, turn, turned_back};

/// The generalised-α method with the pivot as a constraint.
#[derive(Clone, Copy, Debug)]
pub struct GeneralizedAlphaConstrained {
    /// ρ, the spectral radius at infinite frequency.
    radius: f64,
    name: &'static str,
    title: &'static str,
}

impl GeneralizedAlphaConstrained {
    /// ρ = 0.9.
    pub const NINE_TENTHS: GeneralizedAlphaConstrained = GeneralizedAlphaConstrained {
        radius: 0.9,
        name: "generalized-alpha-constrained",
        title: "generalized-alpha with the pivot as a constraint, spectral radius 0.9 (Kynema)",
    };
}

impl TurningScheme for GeneralizedAlphaConstrained {
    fn card(&self) -> Card {
        Card {
            name: self.name,
            title: self.title,
            family: "Lie group",
            source: "bruls2012; chung1993",
            claims: claims![FLIGHT;
                Order(2), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin), Rigid, Solves(1),
            ],
        }
    }

    const STATES: usize = 1;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = false;
    const KEEPS_MOMENTUM: bool = false;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let start = Start::of(model, t, from, &mut work.history, h, Alphas::of(M::Real::of(self.radius)))?;
        let [before] = work.buffers();
        let (mut algorithmic, mut real) = (start.algorithmic, start.real);
        to.clone_from(from);
        until_settled(model, || {
            std::mem::swap(to, before);
            [algorithmic, real] = start.improved(model, t + h, &algorithmic, from, to)?;
            Ok(model.apart(to, before))
        })?;
        start.keep(&mut work.history, &algorithmic, &real);
        Ok(())
    }
}

/// What a step starts from.
struct Start<T: Real> {
    h: T,
    alphas: Alphas<T>,
    attitude: Rotation<T>,
    /// Ω₀ [rad/s].
    spin: Vector3<T>,
    /// U₀ [m/s].
    velocity: Vector3<T>,
    /// A₀.
    algorithmic: Accelerations<T>,
    /// V̇₀.
    real: Accelerations<T>,
    /// The constraint.
    carried: Option<Carried<T>>,
}

impl<T: Real> Start<T> {
    /// Recalls what the last step kept, or makes it from the state.
    fn of<M: Turning<Real = T>>(
        model: &M,
        t: T,
        from: &M::State,
        history: &mut Vec<M::Rates>,
        h: T,
        alphas: Alphas<T>,
    ) -> Result<Start<T>, Broken> {
        let rates = model.rates(t, from)?;
        let (attitude, carried) = (model.attitude(from), model.rotational().carried);
        let spin = model.spin_of(&rates);
        let rotation =
            spin_rate(model, &attitude, &(model.torque_of(&rates) - spin.cross(&model.momentum(from))));
        let (mut velocity, mut acceleration) = (rates.motion().velocity, rates.motion().acceleration);
        if let Some(Carried { center, .. }) = carried {
            let arm = attitude * center;
            velocity = spin.cross(&arm);
            acceleration = rotation.cross(&arm) + spin.cross(&velocity);
        }
        let mut real = Accelerations { spin: rotation, velocity: acceleration };
        let mut algorithmic = real; // (6)
        if carried.is_some() && history.len() == 3 {
            (velocity, real) = (history[2].motion().spin, recalled(&history[1]));
            algorithmic = recalled(&history[0]);
        } else if let Some(kept) = history.first() {
            algorithmic = Accelerations::remembered(*kept);
        }
        history.clear();
        Ok(Start { h, alphas, attitude, spin, velocity, algorithmic, real, carried })
    }

    /// A₁ and V̇₁ from an earlier A₁; writes the state that it leads to.
    fn improved<M: Turning<Real = T>>(
        &self,
        model: &M,
        end: T,
        algorithmic: &Accelerations<T>,
        from: &M::State,
        to: &mut M::State,
    ) -> Result<[Accelerations<T>; 2], Broken> {
        let (h, alphas) = (self.h, &self.alphas);
        let mean = alphas.mean(&self.algorithmic, algorithmic);
        let change = alphas.change(&self.algorithmic, algorithmic);
        let spin = self.spin + change.spin * h; // (2)
        let turn = turn(&((self.spin + mean.spin * h) * h));
        let attitude = renormalized(turn * self.attitude); // (1)
        let momentum = attitude * turned_back(&attitude, &spin).component_mul(&model.rotational().moments);
        let (velocity, zero) = (self.velocity + mean.velocity * h, Vector3::zeros());
        let motion = Motion { spin: zero, velocity, acceleration: change.velocity, torque: zero };
        model.advance(from, h, &M::Rates::of(motion), to); // (1), (2)
        model.place(to, attitude, momentum);
        let rates = model.rates(end, to)?;
        let mut torque = model.torque_of(&rates) - spin.cross(&momentum);
        let mut acceleration = rates.motion().acceleration; // (4)
        if let Some(Carried { mass, center }) = self.carried {
            let arm = attitude * center;
            let real = self.constrained(&turn, &center, algorithmic);
            let off = real.velocity - real.spin.cross(&arm) - spin.cross(&spin.cross(&arm));
            torque -= arm.cross(&off) * mass; // (7)
            acceleration = real.velocity;
        }
        let real = Accelerations { spin: spin_rate(model, &attitude, &torque), velocity: acceleration };
        Ok([alphas.algorithmic(&self.algorithmic, &self.real, &real), real]) // (3)
    }

    /// V̇₁ that takes the centre of mass to where the turn of the step takes it.
    fn constrained(
        &self,
        turn: &Rotation<T>,
        center: &Vector3<T>,
        algorithmic: &Accelerations<T>,
    ) -> Accelerations<T> {
        let (arm, axis) = (self.attitude * center, turn.imag());
        let way = axis.cross(&(arm * turn.w + axis.cross(&arm))) * T::of(2.0); // (5): r₁ − r₀, without a difference
        let mean = (way / self.h - self.velocity) / self.h; // (1)
        let alphas = &self.alphas;
        let velocity = (mean - self.algorithmic.velocity * (-alphas.beta + 0.5)) / alphas.beta;
        let algorithmic = Accelerations { spin: algorithmic.spin, velocity };
        alphas.real(&self.algorithmic, &self.real, &algorithmic) // (3)
    }

    /// Leaves A₁, V̇₁ and U₁ for the next step; without a constraint a state has the last two.
    fn keep<R: Rates<T>>(
        &self,
        history: &mut Vec<R>,
        algorithmic: &Accelerations<T>,
        real: &Accelerations<T>,
    ) {
        if self.carried.is_none() {
            history.push(algorithmic.kept());
            return;
        }
        let change = self.alphas.change(&self.algorithmic, algorithmic);
        let velocity = self.velocity + change.velocity * self.h; // (2)
        let pair = |spin, torque| R::of(Motion { spin, torque, ..Motion::default() });
        history.push(pair(algorithmic.spin, algorithmic.velocity));
        history.push(pair(real.spin, real.velocity));
        history.push(pair(velocity, Vector3::zeros()));
    }
}

/// A pair of accelerations that [`Start::keep`] put into rates of a body on a pivot.
fn recalled<T: Real, R: Rates<T>>(rates: &R) -> Accelerations<T> {
    let Motion { spin, torque, .. } = rates.motion();
    Accelerations { spin, velocity: torque }
}

/// I⁻¹ of a vector [rad/s²], world.
fn spin_rate<M: Turning>(
    model: &M,
    attitude: &Rotation<M::Real>,
    torque: &Vector3<M::Real>,
) -> Vector3<M::Real> {
    attitude * turned_back(attitude, torque).component_mul(&model.rotational().inverse_moments)
}
