//! Periods of the truth: the time from one zero of a signal to the next but one.
//!
//! The zeros are found on a grid, and on ever finer ones inside the interval where the sign changes. No closed form is
//! used: the published periods are often closed forms.

use std::f64::consts::TAU;

use super::PublishedError;
use super::data::{Figure, Measure};
use super::motion::{Motion, truth_at};
use crate::model::Snapshot;
use crate::rotation;

/// Times of the first grid, over the figure's time.
const GRID: usize = 128;
/// Parts of an interval in each refinement.
const PARTS: usize = 32;
/// Refinements: 32⁻⁹ of an interval is below the rounding of a time.
const REFINEMENTS: usize = 9;

/// The period that a figure asks for [s]; three zeros must lie before its time.
pub(super) fn of(figure: &Figure, motion: &Motion) -> Result<f64, PublishedError> {
    let signal = |state: &Snapshot| signal(figure, state);
    let grid: Vec<f64> = (1..=GRID).map(|j| figure.time * j as f64 / GRID as f64).collect();
    let states = truth_at(motion.scene, &grid)?;
    let values: Vec<f64> = states.iter().map(signal).collect();
    let changes: Vec<usize> =
        (1..GRID).filter(|i| (values[i - 1] < 0.0) != (values[*i] < 0.0)).take(3).collect();
    let [first, _, third] = changes[..] else {
        return Err(motion.missing(figure, "three zeros of its signal do not lie before its time"));
    };
    let first = zero(figure, motion, grid[first - 1], grid[first])?;
    let third = zero(figure, motion, grid[third - 1], grid[third])?;
    if figure.measure != Measure::PrecessionPeriod {
        return Ok(third.time - first.time);
    }
    // R(t₃) R(t₁)⁻¹ is a turn about L, for the spin in body axes is the same at both times.
    let turn = rotation::vector_of(&(third.orientation * first.orientation.inverse()));
    let angle = turn.dot(&first.angular_momentum) / rotation::length(&first.angular_momentum);
    Ok((third.time - first.time) * TAU / angle.rem_euclid(TAU))
}

/// What vanishes twice a period.
fn signal(figure: &Figure, state: &Snapshot) -> f64 {
    let to_body = state.orientation.inverse();
    match figure.measure {
        // d/dt of R₃₃ = Ω × R e₃ · e₃.
        Measure::NutationPeriod => {
            let axis = state.orientation * nalgebra::Vector3::z();
            state.angular_velocity.cross(&axis).z
        }
        Measure::LibrationPeriod => state.angular_velocity.z - figure.rate.unwrap_or(0.0),
        _ => (to_body * state.angular_velocity)[figure.rate_component.unwrap_or(0)],
    }
}

/// The state where the signal changes its sign between two times.
fn zero(figure: &Figure, motion: &Motion, from: f64, to: f64) -> Result<Snapshot, PublishedError> {
    let (mut low, mut high) = (from, to);
    let mut found = None;
    for _ in 0..REFINEMENTS {
        let width = (high - low) / PARTS as f64;
        let mut times: Vec<f64> = (0..=PARTS).map(|j| low + width * j as f64).collect();
        times.dedup();
        let states = truth_at(motion.scene, &times)?;
        let negative = |state: &Snapshot| signal(figure, state) < 0.0;
        let Some(i) = (1..states.len()).find(|i| negative(&states[i - 1]) != negative(&states[*i])) else {
            break;
        };
        (low, high) = (states[i - 1].time, states[i].time);
        found = Some(states[i]);
    }
    found.ok_or_else(|| motion.missing(figure, "its signal has no zero where its sign changes"))
}
