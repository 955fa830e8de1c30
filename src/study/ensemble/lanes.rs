//! The note's two schemes on free bodies and on tops side by side, one in each lane of the registers that the machine has.
//!
//! (1)  Ω = R I⁻¹ Rᵀ L,  τ = R c × M g for a top                rates
//! (2)  q ← R(Ω, s) q,  L ← L + s τ                            advance
//! (3)  Euler:   s₁ = advance(s₀, h, rates(s₀))
//! (4)  Peskin:  s½ = advance(s₀, h/2, rates(s₀)),  s₁ = advance(s₀, h, rates(s½))
//!
//! Free bodies that turn little in a step take Peskin's in moving axes (`model::moving_axes`), as the model does by itself.
//!
//! The others are the formulas of the models `Free` and `Rotor` under the pages `euler` and `peskin-rk2`: sum for sum, so that a
//! test holds them to the last bit. What the series of a turn do not reach, more than a radian in a step, they leave to
//! the pages.

use crate::arithmetic::{Number, Registers, Row, Work, series};
use crate::model::moving_axes::{Moving, Stand};
use crate::rotation::formulas;
use crate::schemes::SideBySide;

/// A body as it is stepped: quaternion w, x, y, z, principal axes to world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Lane {
    pub(super) attitude: [f64; 4],
    /// L [kg m²/s], world.
    pub(super) momentum: [f64; 3],
    /// L [kg m²/s], principal axes, for steps in moving axes.
    pub(super) ahead: [f64; 3],
    /// Largest square of the turn of half a step in moving axes [rad²].
    pub(super) largest: f64,
    /// 1/moment [1/(kg m²)], principal axes.
    pub(super) inverse_moments: [f64; 3],
    /// M g of a top [N], world; zero for a free body.
    pub(super) weight: [f64; 3],
    /// Centre of mass of a top from its pivot [m], principal axes.
    pub(super) center: [f64; 3],
    /// h [s].
    pub(super) step: f64,
}

/// In which form a group of bodies is stepped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// By a scheme, as its page says.
    Page(SideBySide),
    /// By Peskin's scheme, free, in moving axes.
    MovingAxes,
}

/// Takes `steps` steps with every body. False where a turn was larger than the series take: then the attitudes are
/// worth nothing.
pub(super) fn advance(registers: Registers, way: Way, steps: u64, bodies: &mut [Lane]) -> bool {
    match way {
        Way::Page(scheme) => registers.by_two(ByPage { scheme, steps, bodies }),
        Way::MovingAxes => registers.by_fitting(InMovingAxes { steps, bodies }),
    }
}

struct ByPage<'a> {
    scheme: SideBySide,
    steps: u64,
    bodies: &'a mut [Lane],
}

impl Work<f64> for ByPage<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_rows<T: Row<Scalar = f64>>(self, proof: T::Proof) -> bool {
        let mut within = true;
        for group in self.bodies.chunks_mut(T::COUNT) {
            let free = group.iter().all(|body| body.weight == [0.0; 3]);
            within &= if free {
                group_steps::<T, false>(proof, self.scheme, self.steps, group)
            } else {
                group_steps::<T, true>(proof, self.scheme, self.steps, group)
            };
        }
        within
    }
}

struct InMovingAxes<'a> {
    steps: u64,
    bodies: &'a mut [Lane],
}

impl Work<f64> for InMovingAxes<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_rows<T: Row<Scalar = f64>>(self, proof: T::Proof) -> bool {
        let mut within = true;
        for group in self.bodies.chunks_mut(T::COUNT) {
            within &= moving_steps::<T>(proof, self.steps, group);
        }
        within
    }
}

/// As many lanes as two of the widest registers hold.
const WIDEST: usize = 16;

/// A row of one number of each body.
#[inline(always)]
fn row<T: Row<Scalar = f64>>(proof: T::Proof, group: &[Lane], part: fn(&Lane) -> f64) -> T {
    let mut values = [0.0; WIDEST];
    for (value, body) in values.iter_mut().zip(group) {
        *value = part(body);
    }
    T::load(proof, &T::chunks(&values)[0])
}

/// A vector of each body.
macro_rules! vector {
    ($proof:ident, $group:ident, $part:ident) => {
        [
            row($proof, $group, |body| body.$part[0]),
            row($proof, $group, |body| body.$part[1]),
            row($proof, $group, |body| body.$part[2]),
        ]
    };
}

/// Writes a vector of each body.
#[inline(always)]
fn store<T: Row<Scalar = f64>, const N: usize>(
    rows: &[T; N],
    group: &mut [Lane],
    part: fn(&mut Lane) -> &mut [f64; N],
) {
    let mut values = [0.0; WIDEST];
    for (i, row) in rows.iter().enumerate() {
        row.store(&mut T::chunks_mut(&mut values)[0]);
        for (body, value) in group.iter_mut().zip(values) {
            part(body)[i] = value;
        }
    }
}

/// A quaternion of each body.
#[inline(always)]
fn attitudes<T: Row<Scalar = f64>>(proof: T::Proof, group: &[Lane]) -> [T; 4] {
    let [i, j, k] = vector!(proof, group, attitude);
    [i, j, k, row(proof, group, |body| body.attitude[3])]
}

#[inline(always)]
fn moving_steps<T: Row<Scalar = f64>>(proof: T::Proof, steps: u64, group: &mut [Lane]) -> bool {
    let half_step = row(proof, group, |body| 0.5 * body.step);
    let body =
        Moving::<T>::new(vector!(proof, group, momentum), half_step, vector!(proof, group, inverse_moments));
    let mut now = Stand { attitude: attitudes(proof, group), momentum: vector!(proof, group, ahead) };
    let largest = row(proof, group, |body| body.largest);
    let mut beyond = T::splat(proof, f64::NEG_INFINITY);
    for _ in 0..steps {
        beyond = beyond.larger(body.square_of_half(now.momentum) - largest);
        now = body.peskin_rk2(now);
    }
    store(&now.attitude, group, |body| &mut body.attitude);
    store(&now.momentum, group, |body| &mut body.ahead);
    beyond.largest() <= 0.0
}

#[inline(always)]
fn group_steps<T: Row<Scalar = f64>, const TOPS: bool>(
    proof: T::Proof,
    scheme: SideBySide,
    steps: u64,
    group: &mut [Lane],
) -> bool {
    let mut bodies = Bodies::<T, TOPS> {
        inverse_moments: vector!(proof, group, inverse_moments),
        weight: vector!(proof, group, weight),
        center: vector!(proof, group, center),
        step: row(proof, group, |body| body.step),
        half_step: row(proof, group, |body| 0.5 * body.step),
        quarter_step: row(proof, group, |body| 0.5 * (0.5 * body.step)),
        largest: T::splat(proof, 0.0),
    };
    let mut now = State { attitude: attitudes(proof, group), momentum: vector!(proof, group, momentum) };
    match scheme {
        SideBySide::Euler => {
            for _ in 0..steps {
                now = bodies.euler(&now);
            }
        }
        SideBySide::PeskinRk2 => {
            for _ in 0..steps {
                now = bodies.peskin_rk2(&now);
            }
        }
    }
    store(&now.attitude, group, |body| &mut body.attitude);
    store(&now.momentum, group, |body| &mut body.momentum);
    bodies.largest.largest() <= series::LARGEST_SQUARE
}

/// Attitude and L of a group.
#[derive(Clone, Copy)]
struct State<T> {
    attitude: [T; 4],
    momentum: [T; 3],
}

/// Constants of the bodies of a group, and the largest (angle/2)² so far.
struct Bodies<T, const TOPS: bool> {
    inverse_moments: [T; 3],
    weight: [T; 3],
    center: [T; 3],
    step: T,
    half_step: T,
    quarter_step: T,
    largest: T,
}

impl<T: Number, const TOPS: bool> Bodies<T, TOPS> {
    /// Ω and τ, by (1).
    #[inline(always)]
    fn rates(&self, at: &State<T>) -> ([T; 3], [T; 3]) {
        let columns = formulas::outer_columns(at.attitude);
        let spin = formulas::spin(&columns, self.inverse_moments, at.momentum);
        if !TOPS {
            return (spin, self.weight);
        }
        let [x, y, z] = formulas::apply(&formulas::axes(at.attitude), self.center);
        let [f, g, h] = self.weight;
        (spin, [y * h - z * g, z * f - x * h, x * g - y * f])
    }

    /// (2), for a time and its half.
    #[inline(always)]
    fn advance(
        &mut self,
        from: &State<T>,
        (time, half_time): (T, T),
        (spin, torque): ([T; 3], [T; 3]),
    ) -> State<T> {
        let half = formulas::scaled(spin, half_time);
        let square = formulas::dot(half, half);
        self.largest = self.largest.larger(square);
        let attitude = formulas::turned(series::coefficients(square), half, from.attitude);
        let mut momentum = from.momentum;
        if TOPS {
            let kick = formulas::scaled(torque, time);
            momentum = [momentum[0] + kick[0], momentum[1] + kick[1], momentum[2] + kick[2]];
        }
        State { attitude, momentum }
    }

    #[inline(always)]
    fn euler(&mut self, now: &State<T>) -> State<T> {
        let k0 = self.rates(now);
        self.advance(now, (self.step, self.half_step), k0) // (3)
    }

    #[inline(always)]
    fn peskin_rk2(&mut self, now: &State<T>) -> State<T> {
        let k0 = self.rates(now);
        let half = self.advance(now, (self.half_step, self.quarter_step), k0);
        let k1 = self.rates(&half);
        self.advance(now, (self.step, self.half_step), k1) // (4)
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
                ahead: [1.0 + part, -0.5, 2.0 * part],
                largest: 1.0,
                inverse_moments: [1.0, 0.5 + 0.5 * part, 0.25],
                step: 0.01 + 0.02 * part,
                ..Lane::default()
            }
        };
        (0..37).map(body).collect()
    }

    #[test]
    fn registers_of_every_width_give_the_same_numbers_to_the_last_bit() {
        let ways = [Way::Page(SideBySide::Euler), Way::Page(SideBySide::PeskinRk2), Way::MovingAxes];
        for scheme in ways {
            let mut narrow = bodies();
            assert!(advance(Registers::all()[0], scheme, 10_000, &mut narrow));
            assert_ne!(narrow, bodies());
            for width in Registers::all() {
                let mut wide = bodies();
                assert!(advance(width, scheme, 10_000, &mut wide));
                assert_eq!(wide, narrow, "{width:?}, {scheme:?}");
            }
            let tops = || {
                let mut bodies = bodies();
                for (k, body) in bodies.iter_mut().enumerate() {
                    (body.weight, body.center) = ([0.1, -0.2, -0.05 * k as f64], [0.2, 0.3, 0.5]);
                }
                bodies
            };
            if scheme == Way::MovingAxes {
                continue;
            }
            let mut narrow = tops();
            assert!(advance(Registers::all()[0], scheme, 300, &mut narrow));
            assert_ne!(narrow[3].momentum, tops()[3].momentum);
            for width in Registers::all() {
                let mut wide = tops();
                assert!(advance(width, scheme, 300, &mut wide));
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
                    advance(width, Way::Page(SideBySide::PeskinRk2), 3, &mut bodies),
                    within,
                    "{width:?}, {step}"
                );
            }
        }
    }
}
