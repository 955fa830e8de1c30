//! Every smooth force law as a series: its coefficient of order k from coefficients of the motion up to order k.
//!
//! All is in principal axes and in [`Scales`]: forces as accelerations of the body, torques over the inertia unit.
//! A vector w(t) of the world is Σ w_i e_i there, with e_i the world axes as the body sees them.
//! The laws (3) to (5) stand in `fields`, (6) in `pulls`.
//!
//! ```text
//! (1)  gravity on a pivot, dipole   τ = m × w
//! (2)  torque                       τ = Σ w_i(t) e_i, or w(t) in body axes
//! (3)  gravity gradient             τ = 3 μ/r³ r × I r,  r = Σ r_i(t) e_i
//! (4)  drag                         F = −(c V + ω × s),  τ = −(s × V + D ω)
//! (5)  Lorentz                      F = q E + (q V + ω × s) × B,  τ = s × (E + V × B) + ω × Q B
//! (6)  spring, central gravity      F = (a + b |d|ᵉ) d − c U,  τ = x × F,  d = X + x − w
//! (7)  rotational damping           τ = −C ω
//! (8)  wheels                       τ = h × ω
//! ```

use nalgebra::{Matrix3, Vector3};

use super::fields::{Charges, Clocked, Gradient, Resistance};
use super::pulls::{Pull, Pulls};
use super::series::{Curve, Curves, Sinusoid, Vector, cross_product};
use crate::model::System;
use crate::model::body::Body;
use crate::model::forces::{
    Dipole, Gravity, Law, OrbitingDipole, RotationalDamping, Torque, TorqueAxes, Wheels,
};
use crate::ode::units::Units;
use crate::rotation;

/// Units of the series: powers of two, so that scaling by them does not round.
#[derive(Clone, Copy, Debug)]
pub struct Scales {
    /// Time [s].
    pub time: f64,
    /// Length [m].
    pub length: f64,
    /// Inertia [kg m²].
    pub inertia: f64,
    /// Mass of the body [kg].
    pub mass: f64,
}

impl Scales {
    pub fn new(system: &System, units: &Units) -> Scales {
        Scales { time: units.time, length: units.length, inertia: units.inertia, mass: system.body.mass }
    }

    /// One newton of force as an acceleration of the body.
    pub(super) fn force(&self) -> f64 {
        self.time * self.time / (self.mass * self.length)
    }

    /// One newton metre.
    pub(super) fn torque(&self) -> f64 {
        self.time * self.time / self.inertia
    }

    /// The torque of a unit of force at a unit of length.
    pub(super) fn lever(&self) -> f64 {
        self.torque() / self.force() * self.length
    }
}

/// The motion up to an order.
pub struct Seen<'a, const L: usize> {
    /// The order.
    pub k: usize,
    /// The world axes as the body sees them, in the first three lanes.
    pub frame: &'a Curves<L>,
    /// ω.
    pub spin: &'a Curve,
    /// Coefficient k of the velocity of the origin, in body axes.
    pub velocity: Vector,
    /// Coefficient k of the way of the origin since the start of the step, in body axes.
    pub way: Vector,
}

impl<const L: usize> Seen<'_, L> {
    /// Coefficient k of a vector of the world in body axes.
    #[inline(always)]
    pub fn in_body(&self, world: &[Vector]) -> Vector {
        let mut sum = [0.0; 3];
        for (w, axes) in world.iter().zip(self.frame[..=self.k].iter().rev()) {
            for (sum, axes) in sum.iter_mut().zip(axes) {
                *sum += w[0] * axes[0] + w[1] * axes[1] + w[2] * axes[2];
            }
        }
        sum
    }

    /// Coefficient k of V + ω × x of a point of the body.
    #[inline(always)]
    pub(super) fn velocity_at(&self, arm: &Vector) -> Vector {
        plus(&self.velocity, &cross_product(&self.spin[self.k], arm))
    }
}

/// Coefficients of force and torque of one order.
#[derive(Clone, Copy, Debug, Default)]
pub struct Load {
    pub force: Vector,
    pub torque: Vector,
}

impl Load {
    #[inline(always)]
    pub(super) fn add(&mut self, force: &Vector, torque: &Vector) {
        self.force = plus(&self.force, force);
        self.torque = plus(&self.torque, torque);
    }
}

#[inline(always)]
pub(super) fn plus(a: &Vector, b: &Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(super) fn by(a: &Vector, factor: f64) -> Vector {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

#[inline(always)]
pub(super) fn of(matrix: &Matrix3<f64>, a: &Vector) -> Vector {
    (matrix * Vector3::from(*a)).into()
}

/// A law as a series.
#[derive(Debug)]
pub enum Term {
    /// (1): m in body axes, w in world axes.
    Couple(Vector, Vector),
    /// (1) with a w that depends on time.
    Turned(Vector, Box<Clocked>),
    /// (2) in world axes.
    World(Box<Clocked>),
    /// (2) in body axes.
    Body(Box<Clocked>),
    /// (3).
    Gradient(Box<Gradient>),
    /// (4).
    Drag(Resistance),
    /// (5).
    Lorentz(Box<Charges>),
    /// (6).
    Pulls(Box<Pulls>),
    /// (7): C, principal axes.
    Damped(Matrix3<f64>),
    /// (8): h, principal axes.
    Wheels(Vector),
}

impl Term {
    /// The series of a law on the body of a system; none for a weight that a fall takes care of.
    pub fn of(law: &Law, system: &System, scales: &Scales) -> Vec<Term> {
        let body = &system.body;
        match law {
            Law::Gravity(Gravity { acceleration }) if body.pivoted => {
                let weight = acceleration * (body.mass * scales.torque());
                vec![Term::Couple(principal(body, &body.center), weight.into())]
            }
            // A law with a jump or a kink has no series and is refused before.
            Law::Gravity(_) | Law::Ground(_) | Law::TorquePulse(_) => Vec::new(),
            Law::Dipole(Dipole { moment, field }) => {
                vec![Term::Couple(principal(body, moment), (field * scales.torque()).into())]
            }
            Law::OrbitingDipole(dipole) => vec![Term::turned(dipole, body, scales)],
            Law::RotationalDamping(law) => vec![Term::damped(law, body, scales)],
            Law::Wheels(Wheels { momentum }) => {
                vec![Term::Wheels(principal(body, &(momentum * (scales.torque() / scales.time))))]
            }
            Law::MassCenterGravity(law) => Pulls::all(&[Pull::on_center(law, body, scales)], -1.5, scales),
            Law::Torque(torque) => vec![Term::torque(torque, body, scales)],
            Law::GravityGradient(law) => vec![Term::Gradient(Box::new(Gradient::new(law, body, scales)))],
            Law::Drag(drag) => vec![Term::Drag(Resistance::new(drag, body, scales))],
            Law::Lorentz(law) => vec![Term::Lorentz(Box::new(Charges::new(law, body, scales)))],
            Law::Spring(spring) => Pulls::all(&[Pull::spring(spring, body, scales)], -0.5, scales),
            Law::CentralGravity(law) => Pulls::all(&Pull::gravity(law, body, scales), -1.5, scales),
        }
    }

    fn turned(dipole: &OrbitingDipole, body: &Body, scales: &Scales) -> Term {
        let field = |part: &Vector3<f64>| (part * scales.torque()).into();
        let wave = Sinusoid {
            constant: field(&dipole.field),
            cosine: field(&dipole.field_cosine),
            sine: field(&dipole.field_sine),
            frequency: dipole.frequency * scales.time,
        };
        Term::Turned(principal(body, &dipole.moment), Box::new(Clocked::new(wave)))
    }

    fn damped(law: &RotationalDamping, body: &Body, scales: &Scales) -> Term {
        let axes = rotation::axes(&body.principal);
        Term::Damped(axes.transpose() * law.coefficients * axes * (scales.torque() / scales.time))
    }

    fn torque(torque: &Torque, body: &Body, scales: &Scales) -> Term {
        let amplitude = |vector: &Vector3<f64>| match torque.axes {
            TorqueAxes::World => (vector * scales.torque()).into(),
            TorqueAxes::Body => principal(body, &(vector * scales.torque())),
        };
        let clocked = Box::new(Clocked::new(Sinusoid {
            constant: amplitude(&torque.constant),
            cosine: amplitude(&torque.cosine),
            sine: amplitude(&torque.sine),
            frequency: torque.frequency * scales.time,
        }));
        match torque.axes {
            TorqueAxes::World => Term::World(clocked),
            TorqueAxes::Body => Term::Body(clocked),
        }
    }

    /// Begins a step at a time, with the origin at a place.
    pub fn start(&mut self, time: f64, origin: &Vector3<f64>) {
        match self {
            Term::Couple(..) | Term::Drag(_) | Term::Damped(_) | Term::Wheels(_) => {}
            Term::World(clocked) | Term::Body(clocked) | Term::Turned(_, clocked) => clocked.start(time),
            Term::Gradient(gradient) => gradient.start(time),
            Term::Lorentz(charges) => charges.start(time),
            Term::Pulls(pulls) => pulls.start(origin),
        }
    }

    /// Adds the coefficients of force and torque that belong to what is seen.
    #[inline(always)]
    pub fn grow<const L: usize>(&mut self, seen: &Seen<L>, load: &mut Load) {
        let k = seen.k;
        match self {
            Term::Couple(moment, field) => {
                load.add(&[0.0; 3], &cross_product(moment, &seen.in_body(&[*field])));
            }
            Term::Turned(moment, clocked) => {
                load.add(&[0.0; 3], &cross_product(moment, &seen.in_body(clocked.coefficients())));
            }
            Term::Damped(matrix) => load.add(&[0.0; 3], &by(&of(matrix, &seen.spin[k]), -1.0)),
            Term::Wheels(momentum) => load.add(&[0.0; 3], &cross_product(momentum, &seen.spin[k])),
            Term::World(clocked) => load.add(&[0.0; 3], &seen.in_body(clocked.coefficients())),
            Term::Body(clocked) => {
                if let Some(torque) = clocked.coefficients().get(k) {
                    load.add(&[0.0; 3], torque);
                }
            }
            Term::Gradient(gradient) => gradient.grow(seen, load),
            Term::Drag(drag) => drag.grow(seen, load),
            Term::Lorentz(charges) => charges.grow(seen, load),
            Term::Pulls(pulls) => pulls.grow(seen, load),
        }
    }
}

/// A vector in body axes, taken to principal axes.
pub(super) fn principal(body: &Body, vector: &Vector3<f64>) -> Vector {
    (body.principal.inverse() * vector).into()
}
