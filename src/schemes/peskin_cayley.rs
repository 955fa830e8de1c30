//! The note's scheme with Cayley's map in place of the exact rotation.
//!
//! (0)  C(Ω, s) = (E − s/2 Ω×)⁻¹ (E + s/2 Ω×), a turn about Ω through 2 atan(|Ω| s/2): that of the exact R(Ω', s),
//!      Ω' = Ω · 2 atan(|Ω| s/2)/(|Ω| s)
//! (1)  X̃_k(t+h/2) = C(Ω(t), h/2) X̃_k(t)
//! (5)  X̃_k(t+h) = C(Ω(t+h/2), h) X̃_k(t)
//! (2)–(4), (6)–(8)  as in the note
//!
//! Source: peskin2021 with (1) and (5) by cayley1846. Second order; the angle of a step is short by |Ω|³h³/12, so
//! that even a steady spin lags.

use nalgebra::Vector3;

use super::families::{BALLISTIC, claims};
use super::{Card, Scheme, Step};
use crate::arithmetic::Real;
use crate::model::{Broken, Model, Motion, Rates};
use crate::rotation;

/// Peskin's scheme with Cayley's map.
#[derive(Clone, Copy, Debug)]
pub struct PeskinCayley;

impl Scheme for PeskinCayley {
    fn card(&self) -> Card {
        Card {
            name: "peskin-cayley",
            title: "Peskin's scheme with Cayley's map",
            family: "the note, varied",
            source: "cayley1846; peskin2021",
            claims: claims![BALLISTIC;
                Order(2), Exact(AngularVelocity, SteadySpin), Energy(Secular { rate_order: 3 }), Rigid,
                Evaluations(2),
            ],
        }
    }
    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [half] = work.buffers();
        let k0 = model.rates(t, from)?.motion();
        model.advance(from, h / 2.0, &by_cayley(k0, h / 2.0), half); // (1)–(4)
        let k1 = model.rates(t + h / 2.0, half)?.motion();
        model.advance(from, h, &by_cayley(k1, h), to); // (5)–(8)
        Ok(())
    }
}

/// Rates whose exact rotation over `s` is Cayley's.
fn by_cayley<T: Real, R: Rates<T>>(rates: Motion<T>, s: T) -> R {
    R::of(Motion { spin: cayley_spin(&rates.spin, s), ..rates }) // (0)
}

/// Ω' of (0).
fn cayley_spin<T: Real>(spin: &Vector3<T>, s: T) -> Vector3<T> {
    let x = rotation::length(spin) * s / 2.0;
    if x == 0.0 { *spin } else { spin * (x.atan() / x) }
}
