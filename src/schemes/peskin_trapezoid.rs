//! The note's scheme with the trapezoid for X_cm: the mean of U_cm at both ends of the step.
//!
//! (1)–(5), (7), (8)  as in the note
//! (6)  X_cm(t+h) = X_cm(t) + h/2 (U_cm(t) + U_cm(t+h)),  U_cm(t+h) from (7)
//!                = X_cm(t) + h (U_cm(t) + h/2 F(t+h/2)/M)
//!
//! Source: peskin2021 with (6) replaced. Second order; another constant for X_cm, and all else through the forces.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::model::{Broken, Model, Motion, Rates};

/// Peskin's scheme with the trapezoid for X_cm.
#[derive(Clone, Copy, Debug)]
pub struct PeskinTrapezoid;

impl Scheme for PeskinTrapezoid {
    fn card(&self) -> Card {
        Card {
            name: "peskin-trapezoid",
            title: "Peskin's scheme with the trapezoid for X_cm",
            family: "the note, varied",
            source: "peskin2021",
            claims: claims![ROTATIONS;
                Order(2), Energy(GrowsSecularly { rate_order: 3 }), FlipTimes, Evaluations(2),
            ],
        }
    }
    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [half] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h / 2.0, &k0, half); // (1)–(4)
        let k1 = model.rates(t + h / 2.0, half)?.motion();
        let velocity = k0.motion().velocity + k1.acceleration * (h / 2.0); // (6)
        model.advance(from, h, &M::Rates::of(Motion { velocity, ..k1 }), to); // (5)–(8)
        Ok(())
    }
}
