//! Euler's method as lecture notes state it: positions first, then forces at the new positions.
//!
//! (1)  X̃_k(t+h) = R(Ω(t), h) X̃_k(t),  X_cm(t+h) = X_cm(t) + h U_cm(t)
//! (2)  F_k at t + h, from the new positions with the old U_cm and L
//! (3)  U_cm(t+h) = U_cm(t) + h/M F,  L(t+h) = L(t) + h Σ_k X̃_k(t+h) × F_k
//!
//! Source: peskin2021 with (1)–(4) in this order. First order; because a kick follows the drift, as in a symplectic
//! method, a body on springs keeps its energy for long. Its twin is `course-code-euler`. The forces are wanted
//! once a step; asking for Ω(t) through the model's rates counts as a second evaluation.

use super::families::{EULERS, claims};
use super::{Card, Scheme, Step};
use crate::model::{Broken, Model, Motion, Rates};

/// Euler's method with forces at the new positions.
#[derive(Clone, Copy, Debug)]
pub struct CourseNotesEuler;

impl Scheme for CourseNotesEuler {
    fn card(&self) -> Card {
        Card {
            name: "course-notes-euler",
            title: "Euler's method with forces at the new positions",
            family: "order of forces",
            source: "peskin2021",
            claims: claims![EULERS; Evaluations(2)],
        }
    }
    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [moved] = work.buffers();
        let Motion { spin, velocity, .. } = model.rates(t, from)?.motion();
        model.advance(from, h, &M::Rates::of(Motion { spin, velocity, ..Motion::default() }), moved); // (1)
        let Motion { acceleration, torque, .. } = model.rates(t + h, moved)?.motion(); // (2)
        model.advance(moved, h, &M::Rates::of(Motion { acceleration, torque, ..Motion::default() }), to); // (3)
        Ok(())
    }
}
