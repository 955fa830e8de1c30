//! Gauss and Legendre's collocation on the quaternion, X_cm, U_cm and L as plain numbers, solved by fixed-point
//! iteration.

use super::Step;
use super::iteration::until_settled;
use super::vector_form::{hold, quaternion_rate};
use crate::arithmetic::{Number, Real};
use crate::model::{Broken, Rates, Turning};
use crate::rotation::normalized;

/// Coefficients of an implicit Runge–Kutta method of S stages.
pub(super) struct Tableau<T, const S: usize> {
    /// a_ij.
    pub(super) matrix: [[T; S]; S],
    /// b_j.
    pub(super) weights: [T; S],
    /// c_i.
    pub(super) nodes: [T; S],
}

/// One step: y_i = y₀ + h Σ a_ij f(t + c_j h, y_j), y₁ = y₀ + h Σ b_j f(t + c_j h, y_j). The workspace holds S + 1
/// states.
pub(super) fn step<M: Turning, const S: usize>(
    tableau: &Tableau<M::Real, S>,
    model: &M,
    Step { t, h, from, to, work }: Step<M>,
) -> Result<(), Broken> {
    let Some((next, stages)) = work.states.split_last_mut() else { return Err(Broken::NeedsAttitude) };
    let q0 = model.attitude(from).into_inner();
    let first = model.rates(t, from)?;
    let mut rates = [first; S];
    let mut slopes = [quaternion_rate(&model.spin_of(&first), &q0); S];
    for stage in stages.iter_mut() {
        stage.clone_from(from);
    }
    let sum = |weights: &[M::Real; S], rates: &[M::Rates; S]| {
        (1..S).fold(rates[0].scaled(weights[0]), |sum, j| sum + rates[j].scaled(weights[j]))
    };
    until_settled(model, || {
        let mut largest = M::Real::of(0.0);
        for i in 0..S {
            let row = &tableau.matrix[i];
            let q = (0..S).fold(q0, |q, j| q + slopes[j] * (h * row[j]));
            hold(model, from, h, &sum(row, &rates), normalized(q), next);
            largest = largest.larger(model.apart(next, &stages[i]));
            std::mem::swap(next, &mut stages[i]);
            rates[i] = model.rates(t + tableau.nodes[i] * h, &stages[i])?;
            slopes[i] = quaternion_rate(&model.spin_of(&rates[i]), &q);
        }
        Ok(largest)
    })?;
    let q1 = (0..S).fold(q0, |q, j| q + slopes[j] * (h * tableau.weights[j]));
    hold(model, from, h, &sum(&tableau.weights, &rates), normalized(q1), to);
    Ok(())
}
