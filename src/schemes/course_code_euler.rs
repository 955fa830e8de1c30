//! Euler's method as course code has it: the old force on the new lever arm.
//!
//! (1)  F_k at t, from the old positions and velocities
//! (2)  X̃_k(t+h) = R(Ω(t), h) X̃_k(t),  X_cm(t+h) = X_cm(t) + h U_cm(t)
//! (3)  U_cm(t+h) = U_cm(t) + h/M Σ_k F_k,  L(t+h) = L(t) + h Σ_k X̃_k(t+h) × F_k
//!
//! The positions were overwritten before the torque was taken. First order all the same, so that no order test
//! sees it: the error constant and the energy of a body on springs tell it from `course-notes-euler`. Torques
//! without a force stay those of t. Runs on the mass points, where a force has its lever arm. The forces are
//! wanted once a step; Ω(t), which moves the arms, counts as a second evaluation.
//!
//! Source: peskin2021 with (4) in this order.

use super::families::{EULERS, claims};
use super::{Card, PointScheme, Step};
use crate::model::{Broken, Motion, Pointwise, Rates};

/// Euler's method with old forces on new lever arms.
#[derive(Clone, Copy, Debug)]
pub struct CourseCodeEuler;

impl PointScheme for CourseCodeEuler {
    fn card(&self) -> Card {
        Card {
            name: "course-code-euler",
            title: "Euler's method with old forces on new lever arms",
            family: "order of forces",
            source: "peskin2021",
            claims: claims![EULERS; Evaluations(2)],
        }
    }
    const STATES: usize = 1;

    fn step<M: Pointwise>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [moved] = work.buffers();
        let old = model.rates(t, from)?; // (1)
        model.advance(from, h, &old, moved); // (2)
        let Motion { torque, .. } = model.rates_on_levers(t, from, moved)?.motion();
        model.advance(from, h, &M::Rates::of(Motion { torque, ..old.motion() }), to); // (3)
        Ok(())
    }
}
