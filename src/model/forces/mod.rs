//! Force laws, each in two forms that must agree: as the note sums them, point by point, and reduced to what a
//! rigid body needs of them.
//!
//! Point form: F = Σ F_k and τ = Σ X̃_k × F_k over every mass point, U_k = U + Ω × X̃_k. It runs under
//! `--model points` and in the references. Reduced form: sums over the points are taken once, in principal
//! axes, before the run; only laws that are not polynomial in X̃_k still visit their points.

mod central_gravity;
mod dipole;
mod drag;
mod gravity;
mod gravity_gradient;
mod ground;
mod lorentz;
mod per_point;
mod pose;
mod spring;
mod torque;

pub use central_gravity::CentralGravity;
pub use dipole::Dipole;
pub use drag::Drag;
pub use gravity::Gravity;
pub use gravity_gradient::GravityGradient;
pub use ground::Ground;
pub use lorentz::Lorentz;
pub use per_point::PerPoint;
pub(crate) use pose::{Arms, Cloud, Load, Pose};
pub use spring::{Attachment, Spring};
pub use torque::{Torque, TorqueAxes};

use nalgebra::{Matrix3, Vector3};

use super::body::Body;
use crate::arithmetic::Real;
use pose::{each_point, sum_points};

/// A force law as a scene states it.
#[derive(Clone, Debug, PartialEq)]
pub enum Law<T: Real = f64> {
    /// F_k = M_k g.
    Gravity(Gravity<T>),
    /// A spring with damper from a point of the body to an anchor.
    Spring(Spring<T>),
    /// F_k = −c_k U_k.
    Drag(Drag<T>),
    /// F_k = −μ M_k d/|d|³.
    CentralGravity(CentralGravity<T>),
    /// F_k = q_k (E(t) + U_k × B).
    Lorentz(Lorentz<T>),
    /// A torque that depends on time alone.
    Torque(Torque<T>),
    /// τ = m × B.
    Dipole(Dipole<T>),
    /// τ = 3 μ/r³ (r̂ × I r̂).
    GravityGradient(GravityGradient<T>),
    /// A one-sided elastic plane with friction.
    Ground(Ground<T>),
}

impl Law {
    /// Names of all laws, with the formula of each.
    pub const NAMES: [(&'static str, &'static str); 9] = [
        ("gravity", "F_k = M_k g"),
        ("spring", "F = -k (|d| - rest) d/|d| - c U,  d = X_k - anchor"),
        ("drag", "F_k = -c_k U_k"),
        ("central-gravity", "F_k = -mu M_k d/|d|^3,  d = X_k - center"),
        ("lorentz", "F_k = q_k (E(t) + U_k x B)"),
        ("torque", "tau = constant + cosine cos(wt) + sine sin(wt), world or body axes"),
        ("dipole", "tau = m x B"),
        ("gravity-gradient", "tau = 3 mu/r^3 (r x I r), r a unit vector turning at a rate"),
        ("ground", "F_k = (k d - c U_k.n)+ n and friction -mu N s/sqrt(s.s + v0^2), d = height - X_k.n > 0"),
    ];
}

impl<T: Real> Law<T> {
    /// The same law in this arithmetic.
    pub(crate) fn of(law: &Law) -> Law<T> {
        match law {
            Law::Gravity(law) => Law::Gravity(Gravity::of(law)),
            Law::Spring(law) => Law::Spring(Spring::of(law)),
            Law::Drag(law) => Law::Drag(Drag::of(law)),
            Law::CentralGravity(law) => Law::CentralGravity(CentralGravity::of(law)),
            Law::Lorentz(law) => Law::Lorentz(Lorentz::of(law)),
            Law::Torque(law) => Law::Torque(Torque::of(law)),
            Law::Dipole(law) => Law::Dipole(Dipole::of(law)),
            Law::GravityGradient(law) => Law::GravityGradient(GravityGradient::of(law)),
            Law::Ground(law) => Law::Ground(Ground::of(law)),
        }
    }

    /// Name of the law as in a scene file.
    pub fn name(&self) -> &'static str {
        let index = match self {
            Law::Gravity(_) => 0,
            Law::Spring(_) => 1,
            Law::Drag(_) => 2,
            Law::CentralGravity(_) => 3,
            Law::Lorentz(_) => 4,
            Law::Torque(_) => 5,
            Law::Dipole(_) => 6,
            Law::GravityGradient(_) => 7,
            Law::Ground(_) => 8,
        };
        Law::<f64>::NAMES[index].0
    }

    /// Whether the law is a torque without a force.
    pub fn is_torque(&self) -> bool {
        matches!(self, Law::Torque(_) | Law::Dipole(_) | Law::GravityGradient(_))
    }

    /// Whether the law acts on every mass point in a way that needs the points themselves.
    pub fn needs_points(&self) -> bool {
        matches!(self, Law::Drag(_) | Law::CentralGravity(_) | Law::Lorentz(_) | Law::Ground(_))
    }

    /// Whether the point form needs the direction of the body axes.
    pub fn needs_axes(&self) -> bool {
        matches!(self, Law::Torque(Torque { axes: TorqueAxes::Body, .. }) | Law::Dipole(_))
    }
}

/// The laws of a scene, bound to its body.
#[derive(Clone, Debug, Default)]
pub struct Forces<T: Real = f64> {
    laws: Vec<Law<T>>,
    reduced: Vec<Reduced<T>>,
    markers: Vec<Vector3<T>>,
}

/// A law with its sums over the points taken, in principal axes.
#[derive(Clone, Debug)]
enum Reduced<T: Real = f64> {
    Gravity(gravity::Reduced<T>),
    Spring(spring::Reduced<T>),
    Drag(drag::Reduced<T>),
    CentralGravity(central_gravity::Reduced<T>),
    Lorentz(lorentz::Reduced<T>),
    Torque(torque::Reduced<T>),
    Dipole(dipole::Reduced<T>),
    GravityGradient(gravity_gradient::Reduced<T>),
    Ground(ground::Reduced<T>),
}

impl<T: Real> Forces<T> {
    /// Binds laws to a body. The caller has checked that indices and lists fit the body's points.
    pub fn new(laws: Vec<Law<T>>, body: &Body<T>) -> Forces<T> {
        let reduced = laws.iter().map(|law| reduce(law, body)).collect();
        let markers = laws.iter().filter_map(Law::marker).collect();
        Forces { laws, reduced, markers }
    }

    /// The laws as stated.
    pub fn laws(&self) -> &[Law<T>] {
        &self.laws
    }

    /// Massless points that carry a force [m], body axes, relative to the origin, in the order of their springs.
    pub fn markers(&self) -> &[Vector3<T>] {
        &self.markers
    }

    /// Force and torque in the reduced form.
    pub fn load(&self, t: T, pose: &Pose<T>) -> Load<T> {
        let mut load = Load::default();
        for law in &self.reduced {
            match law {
                Reduced::Gravity(law) => law.add(pose, &mut load),
                Reduced::Spring(law) => law.add(pose, &mut load),
                Reduced::Drag(law) => law.add(pose, &mut load),
                Reduced::CentralGravity(law) => law.add(pose, &mut load),
                Reduced::Lorentz(law) => law.add(t, pose, &mut load),
                Reduced::Torque(law) => law.add(t, pose, &mut load),
                Reduced::Dipole(law) => law.add(pose, &mut load),
                Reduced::GravityGradient(law) => law.add(t, pose, &mut load),
                Reduced::Ground(law) => law.add(pose, &mut load),
            }
        }
        load
    }

    /// Force and torque summed over the points, as the note writes them.
    pub fn load_on_points(&self, t: T, cloud: &Cloud<T>) -> Load<T> {
        let mut load = Load::default();
        let mut marker = cloud.masses.len();
        for law in &self.laws {
            match law {
                Law::Gravity(law) => law.add_on_points(cloud, &mut load),
                Law::Spring(law) => {
                    let index = law.arm_index(&mut marker);
                    let arm = cloud.arms.at(index);
                    load.push(
                        &cloud.levers.at(index),
                        &law.force(&(cloud.origin + arm), &cloud.velocity_at(&arm)),
                    );
                }
                Law::Drag(law) => each_point(cloud, &mut load, |k, _, u| law.force(k, u)),
                Law::CentralGravity(law) => {
                    each_point(cloud, &mut load, |k, x, _| law.force(cloud.masses[k], x));
                }
                Law::Lorentz(law) => each_point(cloud, &mut load, |k, _, u| law.force(t, k, u)),
                Law::Ground(law) => each_point(cloud, &mut load, |_, x, u| law.force(x, u)),
                Law::Torque(law) => load.torque += law.torque(t, &cloud.axes),
                Law::Dipole(law) => load.torque += law.torque(&cloud.axes),
                Law::GravityGradient(law) => load.torque += law.torque(t, &cloud.inertia),
            }
        }
        load
    }

    /// Potential energy [J]; `None` where a law has no potential.
    pub fn potential(&self, cloud: &Cloud<T>) -> Option<T> {
        let mut marker = cloud.masses.len();
        let mut total = T::zero();
        for law in &self.laws {
            total += match law {
                Law::Gravity(law) => law.potential(cloud),
                Law::Spring(law) => {
                    law.potential(&(cloud.origin + cloud.arms.at(law.arm_index(&mut marker))))
                }
                Law::CentralGravity(law) => sum_points(cloud, |k, x| law.potential(cloud.masses[k], x)),
                Law::Lorentz(law) if law.is_static() => sum_points(cloud, |k, x| law.potential(k, x)),
                Law::Dipole(law) => law.potential(&cloud.axes),
                Law::GravityGradient(law) if law.rate == 0.0 => law.potential(&cloud.inertia),
                Law::Ground(law) => sum_points(cloud, |_, x| law.potential(x)),
                Law::Drag(_) | Law::Torque(_) | Law::Lorentz(_) | Law::GravityGradient(_) => return None,
            };
        }
        Some(total)
    }

    /// Whether a force depends on a velocity.
    pub fn read_velocity(&self) -> bool {
        self.laws.iter().any(|law| match law {
            Law::Drag(_) => true,
            Law::Spring(spring) => spring.damping != 0.0,
            Law::Lorentz(lorentz) => lorentz.magnetic.amax() != 0.0,
            Law::Ground(ground) => ground.damping != 0.0 || ground.friction != 0.0,
            Law::Gravity(_) | Law::CentralGravity(_) | Law::Torque(_) => false,
            Law::Dipole(_) | Law::GravityGradient(_) => false,
        })
    }

    /// Whether a law depends on time by itself.
    pub fn read_time(&self) -> bool {
        self.laws.iter().any(|law| match law {
            Law::Lorentz(lorentz) => !lorentz.is_static(),
            Law::Torque(torque) => {
                torque.frequency != 0.0 && (torque.cosine.amax() != 0.0 || torque.sine.amax() != 0.0)
            }
            Law::GravityGradient(gradient) => gradient.rate != 0.0,
            Law::Gravity(_) | Law::Spring(_) | Law::Drag(_) => false,
            Law::CentralGravity(_) | Law::Dipole(_) | Law::Ground(_) => false,
        })
    }

    /// The fastest that a law goes round by itself [rad/s]; 0 where none reads the time.
    pub fn fastest_clock(&self) -> T {
        let rate = |law: &Law<T>| match law {
            Law::Lorentz(lorentz) if !lorentz.is_static() => lorentz.frequency,
            Law::Torque(torque) => torque.frequency,
            Law::GravityGradient(gradient) => gradient.rate,
            _ => T::zero(),
        };
        self.laws.iter().map(|law| rate(law).abs()).fold(T::zero(), T::max)
    }

    /// Whether every law conserves the total energy.
    pub fn conservative(&self) -> bool {
        self.laws.iter().all(|law| match law {
            Law::Gravity(_) | Law::CentralGravity(_) | Law::Dipole(_) => true,
            Law::Spring(spring) => spring.damping == 0.0,
            Law::Lorentz(lorentz) => lorentz.is_static(),
            Law::GravityGradient(gradient) => gradient.rate == 0.0,
            Law::Ground(ground) => ground.damping == 0.0 && ground.friction == 0.0,
            Law::Drag(_) | Law::Torque(_) => false,
        })
    }
}

impl<T: Real> Law<T> {
    fn marker(&self) -> Option<Vector3<T>> {
        match self {
            Law::Spring(Spring { attachment: Attachment::At(position), .. }) => Some(*position),
            _ => None,
        }
    }
}

fn reduce<T: Real>(law: &Law<T>, body: &Body<T>) -> Reduced<T> {
    match law {
        Law::Gravity(law) => Reduced::Gravity(law.reduce(body)),
        Law::Spring(law) => Reduced::Spring(law.reduce(body)),
        Law::Drag(law) => Reduced::Drag(law.reduce(body)),
        Law::CentralGravity(law) => Reduced::CentralGravity(law.reduce(body)),
        Law::Lorentz(law) => Reduced::Lorentz(law.reduce(body)),
        Law::Torque(law) => Reduced::Torque(law.reduce(body)),
        Law::Dipole(law) => Reduced::Dipole(law.reduce(body)),
        Law::GravityGradient(law) => Reduced::GravityGradient(law.reduce(body)),
        Law::Ground(law) => Reduced::Ground(law.reduce(body)),
    }
}

/// A vector in body axes, taken to principal axes.
fn to_principal<T: Real>(body: &Body<T>, vector: &Vector3<T>) -> Vector3<T> {
    body.principal.inverse() * vector
}

/// A symmetric tensor in body axes, taken to principal axes.
fn tensor_to_principal<T: Real>(body: &Body<T>, tensor: &Matrix3<T>) -> Matrix3<T> {
    let axes = body.principal.to_rotation_matrix().into_inner();
    axes.transpose() * tensor * axes
}
