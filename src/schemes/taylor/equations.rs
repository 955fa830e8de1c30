//! The Euler equations in principal axes, solved order by order.
//!
//! ```text
//! (1)  e_i' = e_i × ω                               world axis i as the body sees it
//! (2)  I ω' = I ω × ω + τ
//! (3)  v' = v × ω + F/M,  V = v + Σ (U₀ + g s)_i e_i
//! (4)  p' = p × ω + v,    the origin has gone  Σ (U₀ s + ½ g s²)_i e_i + p
//! ```
//!
//! The frame of (3) and (4) falls with U₀ + g s, where a step begins with U₀: v and p hold only what the other forces do, so that a
//! body without forces flies straight, exactly. Coefficient k + 1 of each follows from coefficients up to k.
//!
//! Source: jorba2005; the equations are Euler's of 1765.

use nalgebra::{Matrix3, Vector3};

use super::loads::{Load, Scales, Seen, Term};
use super::series::{CAPACITY, Curve, Curves, Vector, Vectors, cross, pairs, sum, zeros};
use crate::model::{Snapshot, System};
use crate::ode::units::Units;
use crate::rotation;

/// Lane of v.
const SPEED: usize = 3;
/// Lane of p.
const WAY: usize = 4;
/// Lanes of a body whose origin is fixed or falls: the world axes, and one that is empty.
pub const TURNING: usize = 4;
/// Lanes of a body that forces push about: v and p besides.
pub const MOVING: usize = 6;

/// The series of one step, in [`Scales`].
pub struct Expansion<'a, const L: usize> {
    system: &'a System,
    scales: Scales,
    terms: Vec<Term>,
    /// e_i, v, p.
    frame: Curves<L>,
    /// ω.
    spin: Curve,
    inertia: Vector3<f64>,
    /// 1/I_x, 1/I_y, 1/I_z.
    inverse: Vector,
    /// (I_y − I_z)/I_x, and so on.
    gyroscopic: Vector,
    /// t.
    time: f64,
    /// Origin, its velocity and g, world axes.
    origin: Vector3<f64>,
    velocity: Vector3<f64>,
    fall: Vector3<f64>,
    /// Least sizes of ω and v.
    sizes: (f64, f64),
}

impl<'a, const L: usize> Expansion<'a, L> {
    /// Before the first step.
    pub fn new(system: &'a System, units: &Units) -> Expansion<'a, L> {
        let scales = Scales::new(system, units);
        let (body, start) = (&system.body, &system.start);
        let speed = scales.length / scales.time;
        let (velocity, fall) = if body.pivoted {
            (Vector3::zeros(), Vector3::zeros())
        } else {
            let accelerations = system.forces.laws().iter().filter_map(|law| law.uniform_acceleration());
            (start.velocity / speed, accelerations.sum::<Vector3<f64>>() * (scales.time / speed))
        };
        let inertia = body.moments / scales.inertia;
        let inverse = body.inverse_moments() * scales.inertia;
        let [x, y, z] = inertia.into();
        let attitude = start.orientation * body.principal;
        let momentum = attitude.inverse_transform_vector(&start.angular_momentum);
        let terms = system.forces.laws().iter().flat_map(|law| Term::of(law, system, &scales));
        let mut expansion = Expansion {
            system,
            scales,
            terms: terms.collect(),
            frame: zeros(),
            spin: [[0.0; 3]; CAPACITY],
            inertia,
            inverse: inverse.into(),
            gyroscopic: [(y - z) * inverse.x, (z - x) * inverse.y, (x - y) * inverse.z],
            time: 0.0,
            origin: system.origin() / scales.length,
            velocity,
            fall,
            sizes: (units.spin * scales.time, units.speed / speed),
        };
        let spin = momentum.component_mul(&body.inverse_moments()) * scales.time;
        expansion.place(&attitude.to_rotation_matrix().into_inner(), spin.into());
        expansion
    }

    /// The time that the series begins at, in units of the scene.
    pub fn time(&self) -> f64 {
        self.time
    }

    fn place(&mut self, axes: &Matrix3<f64>, spin: Vector) {
        for (c, frame) in self.frame[0].iter_mut().enumerate() {
            *frame = [0.0; L];
            for (lane, row) in frame.iter_mut().zip(axes.row_iter()) {
                *lane = row[c];
            }
        }
        self.spin[0] = spin;
    }

    /// Makes the coefficients up to an order.
    #[inline(always)]
    pub fn grow(&mut self, order: usize) {
        for term in &mut self.terms {
            term.start(self.time, &self.origin);
        }
        let (start, fall): (Vector, Vector) = (self.velocity.into(), self.fall.into());
        let travel = [[0.0; 3], start, fall.map(|g| 0.5 * g)];
        for k in 0..order {
            let mut seen =
                Seen { k, frame: &self.frame, spin: &self.spin, velocity: [0.0; 3], way: [0.0; 3] };
            if L == MOVING {
                seen.velocity = seen.in_body(&[start, fall]);
                seen.way = seen.in_body(&travel);
                for c in 0..3 {
                    seen.velocity[c] += self.frame[k][c][SPEED];
                    seen.way[c] += self.frame[k][c][WAY];
                }
            }
            let mut load = Load::default();
            for term in &mut self.terms {
                term.grow(&seen, &mut load);
            }
            let share = 1.0 / (k + 1) as f64;
            let products = pairs(&self.spin, k);
            let (frame, above) = self.frame.split_at_mut(k + 1);
            let next = &mut above[0];
            cross(frame, &self.spin[..=k], next); // (1)
            for (c, next) in next.iter_mut().enumerate() {
                if L == MOVING {
                    next[SPEED] += load.force[c]; // (3)
                    next[WAY] += frame[k][c][SPEED]; // (4)
                }
                for lane in next {
                    *lane *= share;
                }
            }
            self.spin[k + 1] = std::array::from_fn(|c| {
                (self.gyroscopic[c] * products[c] + self.inverse[c] * load.torque[c]) * share // (2)
            });
        }
    }

    /// Largest part of the coefficients of an order, each over its size.
    pub fn size(&self, order: usize) -> f64 {
        let largest = |values: &[f64]| values.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let mut size = largest(&self.spin[order]) / largest(&self.spin[0]).max(self.sizes.0);
        for parts in &self.frame[order] {
            size = size.max(largest(&parts[..SPEED]));
            if L == MOVING {
                size = size.max(parts[SPEED].abs() / self.sizes.1).max(parts[WAY].abs());
            }
        }
        size
    }

    /// The state a time `s` after the start, the axes made orthogonal.
    fn at(&self, order: usize, s: f64) -> State {
        let frame = sum(&self.frame[..=order], s);
        let mut spin = [0.0; 3];
        for coefficient in self.spin[..=order].iter().rev() {
            for (spin, coefficient) in spin.iter_mut().zip(coefficient) {
                *spin = *spin * s + coefficient;
            }
        }
        let axes = Matrix3::from_fn(|row, column| frame[column][row]);
        let axes = orthogonal(&axes);
        let (mut velocity, mut origin) =
            (self.velocity + self.fall * s, self.origin + (self.velocity + self.fall * (0.5 * s)) * s);
        if L == MOVING {
            let lane = |lane: usize| axes * Vector3::from(frame.map(|parts| parts[lane]));
            velocity += lane(SPEED);
            origin += lane(WAY);
        }
        State { axes, spin, velocity, origin }
    }

    /// Goes on from a time `s` after the start, which is `time`.
    pub fn advance(&mut self, order: usize, s: f64, time: f64) {
        let state = self.at(order, s);
        self.place(&state.axes, state.spin);
        (self.velocity, self.origin, self.time) = (state.velocity, state.origin, time);
    }

    /// What the polynomial gives a time `s` after the start, which is `time` [s].
    pub fn observe(&self, order: usize, s: f64, time: f64) -> Snapshot {
        let State { axes, spin, velocity, origin } = self.at(order, s);
        let (scales, body) = (&self.scales, &self.system.body);
        let spin = Vector3::from(spin);
        let attitude = rotation::from_matrix(&axes);
        let angular_velocity = axes * spin / scales.time;
        let arm = attitude * (body.principal.inverse() * body.center);
        Snapshot {
            time,
            position: origin * scales.length + arm,
            velocity: velocity * (scales.length / scales.time) + angular_velocity.cross(&arm),
            orientation: attitude * body.principal.inverse(),
            angular_velocity,
            angular_momentum: axes * (self.inertia.component_mul(&spin) * (scales.inertia / scales.time)),
            stretch: 0.0,
        }
    }

    /// Whether every coefficient of an order is finite.
    pub fn is_finite(&self, order: usize) -> bool {
        let finite = |parts: &Vectors<L>| parts.iter().flatten().all(|x| x.is_finite());
        self.spin[order].iter().all(|x| x.is_finite()) && finite(&self.frame[order])
    }
}

/// A moment, in units of the scene: axes of the body and ω in principal axes, velocity and place of the origin in world axes.
struct State {
    axes: Matrix3<f64>,
    spin: Vector,
    velocity: Vector3<f64>,
    origin: Vector3<f64>,
}

/// The rotation next to a matrix that is one but for an error e: one step of Newton's iteration leaves e².
fn orthogonal(axes: &Matrix3<f64>) -> Matrix3<f64> {
    axes * (Matrix3::from_diagonal_element(1.5) - axes.tr_mul(axes) * 0.5)
}
