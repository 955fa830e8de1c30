//! The note's two schemes on free bodies side by side, one in each lane of the registers that the machine has.
//!
//! (1)  Ω = R I⁻¹ Rᵀ L                                         rates
//! (2)  q ← R(Ω, s) q                                          advance
//! (3)  Euler:   q₁ = advance(q₀, h, rates(q₀))
//! (4)  Peskin:  q½ = advance(q₀, h/2, rates(q₀)),  q₁ = advance(q₀, h, rates(q½))
//!
//! These are the formulas of the model `Free` under the pages `euler` and `peskin-rk2`: sum for sum, so that a test
//! holds them to the last bit. What the series of a turn do not reach, more than a radian in a step, they leave to the pages.

use pulp::{Simd, WithSimd};

use crate::number::{Lanes, Number, Registers};
use crate::rotation::formulas;
use crate::schemes::SideBySide;

/// Registers of a lane: two, so that one computes while the other waits.
const REGISTERS: usize = 2;

/// A free body as its attitude is stepped: quaternion w, x, y, z, principal axes to world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lane {
    pub(super) attitude: [f64; 4],
    /// L [kg m²/s], world.
    pub(super) momentum: [f64; 3],
    /// 1/moment [1/(kg m²)], principal axes.
    pub(super) inverse_moments: [f64; 3],
    /// h [s].
    pub(super) step: f64,
}

/// Takes `steps` steps with every body. False where a turn was larger than the series take: then the attitudes are
/// worth nothing.
pub(super) fn advance(registers: Registers, scheme: SideBySide, steps: u64, bodies: &mut [Lane]) -> bool {
    registers.dispatch(Advance { scheme, steps, bodies })
}

struct Advance<'a> {
    scheme: SideBySide,
    steps: u64,
    bodies: &'a mut [Lane],
}

impl WithSimd for Advance<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let mut within = true;
        for group in self.bodies.chunks_mut(Lanes::<S, REGISTERS>::COUNT) {
            within &= group_steps(simd, self.scheme, self.steps, group);
        }
        within
    }
}

/// As many lanes as two of the widest registers hold.
const WIDEST: usize = 16;

/// A row of one number of each body.
#[inline(always)]
fn row<S: Simd>(simd: S, group: &[Lane], part: fn(&Lane) -> f64) -> Lanes<S, REGISTERS> {
    let mut values = [0.0; WIDEST];
    for (value, body) in values.iter_mut().zip(group) {
        *value = part(body);
    }
    Lanes::load(simd, &values)
}

#[inline(always)]
fn group_steps<S: Simd>(simd: S, scheme: SideBySide, steps: u64, group: &mut [Lane]) -> bool {
    let mut bodies = Bodies {
        momentum: [
            row(simd, group, |body| body.momentum[0]),
            row(simd, group, |body| body.momentum[1]),
            row(simd, group, |body| body.momentum[2]),
        ],
        inverse_moments: [
            row(simd, group, |body| body.inverse_moments[0]),
            row(simd, group, |body| body.inverse_moments[1]),
            row(simd, group, |body| body.inverse_moments[2]),
        ],
        half_step: row(simd, group, |body| 0.5 * body.step),
        quarter_step: row(simd, group, |body| 0.5 * (0.5 * body.step)),
        largest: Lanes::splat(simd, 0.0),
    };
    let mut q = [
        row(simd, group, |body| body.attitude[0]),
        row(simd, group, |body| body.attitude[1]),
        row(simd, group, |body| body.attitude[2]),
        row(simd, group, |body| body.attitude[3]),
    ];
    match scheme {
        SideBySide::Euler => {
            for _ in 0..steps {
                q = bodies.euler(q);
            }
        }
        SideBySide::PeskinRk2 => {
            for _ in 0..steps {
                q = bodies.peskin_rk2(q);
            }
        }
    }
    for (i, part) in q.iter().enumerate() {
        let mut values = [0.0; WIDEST];
        part.store(&mut values);
        for (body, value) in group.iter_mut().zip(values) {
            body.attitude[i] = value;
        }
    }
    bodies.largest.largest() <= formulas::LARGEST_SQUARE
}

type Attitude<T> = [T; 4];

/// Constants of the bodies of a group, and the largest (angle/2)² so far.
struct Bodies<T> {
    momentum: [T; 3],
    inverse_moments: [T; 3],
    half_step: T,
    quarter_step: T,
    largest: T,
}

impl<T: Number> Bodies<T> {
    /// Ω, by (1).
    #[inline(always)]
    fn rates(&self, q: Attitude<T>) -> [T; 3] {
        formulas::spin(&formulas::outer_columns(q), self.inverse_moments, self.momentum)
    }

    /// (2), for a time of which half is given.
    #[inline(always)]
    fn advance(&mut self, q: Attitude<T>, half_time: T, spin: [T; 3]) -> Attitude<T> {
        let half = formulas::scaled(spin, half_time);
        let square = formulas::dot(half, half);
        self.largest = self.largest.larger(square);
        formulas::turned(formulas::coefficients(square), half, q)
    }

    #[inline(always)]
    fn euler(&mut self, q: Attitude<T>) -> Attitude<T> {
        let k0 = self.rates(q);
        self.advance(q, self.half_step, k0) // (3)
    }

    #[inline(always)]
    fn peskin_rk2(&mut self, q: Attitude<T>) -> Attitude<T> {
        let k0 = self.rates(q);
        let half = self.advance(q, self.quarter_step, k0);
        let k1 = self.rates(half);
        self.advance(q, self.half_step, k1) // (4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bodies() -> Vec<Lane> {
        let body = |k: usize| {
            let part = k as f64 / 37.0;
            Lane {
                attitude: [0.8, 0.0, -0.6, 0.0],
                momentum: [1.0 + part, -0.5, 2.0 * part],
                inverse_moments: [1.0, 0.5 + 0.5 * part, 0.25],
                step: 0.01 + 0.02 * part,
            }
        };
        (0..37).map(body).collect()
    }

    #[test]
    fn registers_of_every_width_give_the_same_numbers_to_the_last_bit() {
        for scheme in [SideBySide::Euler, SideBySide::PeskinRk2] {
            let mut narrow = bodies();
            assert!(advance(Registers::all()[0], scheme, 10_000, &mut narrow));
            assert_ne!(narrow, bodies());
            for width in Registers::all() {
                let mut wide = bodies();
                assert!(advance(width, scheme, 10_000, &mut wide));
                assert_eq!(wide, narrow, "{width:?}, {scheme:?}");
            }
        }
    }

    #[test]
    fn a_turn_of_more_than_a_radian_is_told() {
        for width in Registers::all() {
            for (step, within) in [(0.9, true), (1.1, false), (30.0, false)] {
                let mut bodies = vec![Lane { step: 0.1, ..bodies()[0] }; 20];
                let slow = Lane { momentum: [1.0, 0.0, 0.0], attitude: [1.0, 0.0, 0.0, 0.0], ..bodies[0] };
                bodies[17] = Lane { step, ..slow };
                assert_eq!(
                    advance(width, SideBySide::PeskinRk2, 3, &mut bodies),
                    within,
                    "{width:?}, {step}"
                );
            }
        }
    }
}
