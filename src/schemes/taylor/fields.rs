//! Vectors of time, and the laws of velocities and fields as series: (3) to (5) of [`loads`](super::loads).

use nalgebra::Matrix3;

use super::loads::{Load, Scales, Seen, by, of, plus};
use super::series::{CAPACITY, Curve, Sinusoid, Vector, cross_of_two, cross_product, pairs};
use crate::model::body::Body;
use crate::model::forces::{Drag, GravityGradient, Lorentz};
use crate::rotation;

/// A vector that depends on time alone, with its coefficients about the start of the step.
#[derive(Debug)]
pub struct Clocked {
    wave: Sinusoid,
    curve: Curve,
    length: usize,
}

impl Clocked {
    pub(super) fn new(wave: Sinusoid) -> Clocked {
        Clocked { wave, curve: [[0.0; 3]; CAPACITY], length: 0 }
    }

    pub(super) fn start(&mut self, time: f64) {
        self.length = self.wave.expand(time, &mut self.curve).len();
    }

    pub(super) fn coefficients(&self) -> &[Vector] {
        &self.curve[..self.length]
    }
}

/// (3): r in world and in body axes, and what the pairs of its components give a torque.
#[derive(Debug)]
pub struct Gradient {
    direction: Clocked,
    in_body: Curve,
    factor: Vector,
}

/// (4): c, s, D.
#[derive(Debug)]
pub struct Resistance {
    total: f64,
    first: Vector,
    torque_first: Vector,
    second: Matrix3<f64>,
}

/// (5): q, s, Q, and the series of V, q V + ω × s, B and Q B.
#[derive(Debug)]
pub struct Charges {
    electric: Clocked,
    magnetic: Vector,
    total: f64,
    first: Vector,
    torque_first: Vector,
    second: Matrix3<f64>,
    velocity: Curve,
    current: Curve,
    field: Curve,
    turned_field: Curve,
}

impl Gradient {
    pub(super) fn start(&mut self, time: f64) {
        self.direction.start(time);
    }

    pub(super) fn new(law: &GravityGradient, body: &Body, scales: &Scales) -> Gradient {
        let length = rotation::length(&law.normal);
        let axis = if length > 0.0 { law.normal / length } else { law.normal };
        let along = axis * axis.dot(&law.direction);
        let direction = Clocked::new(Sinusoid {
            constant: along.into(),
            cosine: (law.direction - along).into(),
            sine: axis.cross(&law.direction).into(),
            frequency: law.rate * length * scales.time,
        });
        let factor = 3.0 * law.mu_over_r3 * scales.torque();
        let [x, y, z] = body.moments.into();
        Gradient {
            direction,
            in_body: [[0.0; 3]; CAPACITY],
            factor: [(z - y) * factor, (x - z) * factor, (y - x) * factor],
        }
    }

    #[inline(always)]
    pub(super) fn grow<const L: usize>(&mut self, seen: &Seen<L>, load: &mut Load) {
        self.in_body[seen.k] = seen.in_body(self.direction.coefficients());
        let pairs = pairs(&self.in_body, seen.k);
        load.add(&[0.0; 3], &std::array::from_fn(|c| pairs[c] * self.factor[c])); // (3)
    }
}

impl Resistance {
    pub(super) fn new(drag: &Drag, body: &Body, scales: &Scales) -> Resistance {
        let (total, first, second) = drag.sums(body);
        // Forces of velocities: a time less.
        let (force, torque) = (scales.force() * scales.length / scales.time, scales.torque() / scales.time);
        Resistance {
            total: total * force,
            first: (first * (force / scales.length)).into(),
            torque_first: (first * (torque * scales.length)).into(),
            second: second * torque,
        }
    }

    #[inline(always)]
    pub(super) fn grow<const L: usize>(&self, seen: &Seen<L>, load: &mut Load) {
        let spin = &seen.spin[seen.k];
        let force = plus(&by(&seen.velocity, self.total), &cross_product(spin, &self.first));
        let torque = plus(&cross_product(&self.torque_first, &seen.velocity), &of(&self.second, spin));
        load.add(&by(&force, -1.0), &by(&torque, -1.0)); // (4)
    }
}

impl Charges {
    pub(super) fn start(&mut self, time: f64) {
        self.electric.start(time);
    }

    pub(super) fn new(law: &Lorentz, body: &Body, scales: &Scales) -> Charges {
        let (total, first, second) = law.sums(body);
        let (force, torque) = (scales.force(), scales.torque());
        let electric = Clocked::new(Sinusoid {
            constant: law.electric.into(),
            cosine: law.electric_cosine.into(),
            sine: law.electric_sine.into(),
            frequency: law.frequency * scales.time,
        });
        let speed = scales.length / scales.time;
        Charges {
            electric,
            magnetic: (law.magnetic * speed).into(),
            total: total * force,
            first: (first * (force / scales.length)).into(),
            torque_first: (first * torque).into(),
            second: second * (torque / scales.length),
            velocity: [[0.0; 3]; CAPACITY],
            current: [[0.0; 3]; CAPACITY],
            field: [[0.0; 3]; CAPACITY],
            turned_field: [[0.0; 3]; CAPACITY],
        }
    }

    #[inline(always)]
    pub(super) fn grow<const L: usize>(&mut self, seen: &Seen<L>, load: &mut Load) {
        let (k, spin) = (seen.k, &seen.spin[seen.k]);
        let electric = seen.in_body(self.electric.coefficients());
        self.velocity[k] = seen.velocity;
        self.current[k] = plus(&by(&seen.velocity, self.total), &cross_product(spin, &self.first));
        self.field[k] = seen.in_body(&[self.magnetic]);
        self.turned_field[k] = of(&self.second, &self.field[k]);
        let force = plus(&by(&electric, self.total), &cross_of_two(&self.current, &self.field, k));
        let pushing = plus(&electric, &cross_of_two(&self.velocity, &self.field, k));
        let torque = plus(
            &cross_product(&self.torque_first, &pushing),
            &cross_of_two(seen.spin, &self.turned_field, k),
        );
        load.add(&force, &torque); // (5)
    }
}
