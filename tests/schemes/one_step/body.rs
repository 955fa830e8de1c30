//! The heavy asymmetric top: I = (2, 2.5, 1.25) about the pivot, Σ M X = (¼, 0, 1), g = (−¾, 0, −1).

use nalgebra::{Matrix3, Vector3};

pub type V = Vector3<f64>;
pub type M = Matrix3<f64>;
/// R and L.
pub type State = (M, V);
/// Ω and τ.
pub type Rates = (V, V);

pub fn moments() -> V {
    V::new(2.0, 2.5, 1.25)
}

pub fn inertia() -> M {
    M::from_diagonal(&moments())
}

/// I⁻¹ l about body axes.
pub fn over_moments(l: &V) -> V {
    l.component_div(&moments())
}

pub fn center() -> V {
    V::new(0.25, 0.0, 1.0)
}

pub fn gravity() -> V {
    V::new(-0.75, 0.0, -1.0)
}

pub fn start() -> State {
    (M::identity(), V::new(0.5, 0.25, 3.0))
}

/// τ, world axes.
pub fn torque(r: &M) -> V {
    (r * center()).cross(&gravity())
}

/// Ω, world axes.
pub fn spin((r, l): &State) -> V {
    r * over_moments(&(r.transpose() * l))
}

pub fn rates(state: &State) -> Rates {
    (spin(state), torque(&state.0))
}

pub fn mixed(parts: &[(f64, Rates)]) -> Rates {
    parts
        .iter()
        .fold((V::zeros(), V::zeros()), |sum, (weight, k)| (sum.0 + k.0 * *weight, sum.1 + k.1 * *weight))
}

pub fn advance(state: &State, s: f64, k: &Rates) -> State {
    (super::rotations::exponential(&(k.0 * s)) * state.0, state.1 + k.1 * s)
}
