//! What laws are told of a body in motion, and what they answer.

use nalgebra::{Matrix3, Vector3};

use crate::arithmetic::Real;
use crate::rotation;

/// Force and torque about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load<T: Real = f64> {
    /// F [N], world.
    pub force: Vector3<T>,
    /// τ about the origin [N m], world.
    pub torque: Vector3<T>,
}

impl<T: Real> Default for Load<T> {
    /// Neither force nor torque.
    #[inline]
    fn default() -> Load<T> {
        Load { force: rotation::zero(), torque: rotation::zero() }
    }
}

impl<T: Real> Load<T> {
    /// Adds a force that acts at `arm` from the origin [m], world.
    #[inline]
    pub fn push(&mut self, arm: &Vector3<T>, force: &Vector3<T>) {
        self.force += force;
        self.torque += arm.cross(force);
    }
}

/// Where a body is and how it moves.
#[derive(Clone, Copy, Debug)]
pub struct Pose<T: Real = f64> {
    /// Takes principal axes to world axes.
    pub axes: Matrix3<T>,
    /// Position of the origin [m], world.
    pub origin: Vector3<T>,
    /// Velocity of the origin [m/s], world.
    pub velocity: Vector3<T>,
    /// Ω [rad/s], world.
    pub spin: Vector3<T>,
}

impl<T: Real> Pose<T> {
    /// A vector about principal axes, in world axes.
    #[inline]
    pub fn in_world(&self, v: &Vector3<T>) -> Vector3<T> {
        rotation::applied(&self.axes, v)
    }

    /// Velocity of the body point at `arm` from the origin, U + Ω × arm [m/s].
    #[inline]
    pub fn velocity_at(&self, arm: &Vector3<T>) -> Vector3<T> {
        self.velocity + self.spin.cross(arm)
    }
}

/// Arms of points [m], world, one by one or coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
pub enum Arms<'a, T: Real = f64> {
    /// A vector a point.
    Listed(&'a [Vector3<T>]),
    /// A column a coordinate.
    Columns {
        /// Along the first axis.
        x: &'a [T],
        /// Along the second.
        y: &'a [T],
        /// Along the third.
        z: &'a [T],
    },
}

impl<T: Real> Arms<'_, T> {
    /// The arm of a point.
    #[inline]
    pub fn at(&self, k: usize) -> Vector3<T> {
        match self {
            Arms::Listed(arms) => arms[k],
            Arms::Columns { x, y, z } => Vector3::new(x[k], y[k], z[k]),
        }
    }
}

/// Mass points and massless markers of a body in motion, and what their laws need besides.
pub struct Cloud<'a, T: Real = f64> {
    /// X̃ of every mass point, then of every marker [m], world.
    pub arms: Arms<'a, T>,
    /// Lever arms of their forces [m], world: X̃ again, but in schemes that keep a force while its point moves.
    pub levers: Arms<'a, T>,
    /// Masses of the mass points [kg].
    pub masses: &'a [T],
    /// Position of the origin [m], world.
    pub origin: Vector3<T>,
    /// Velocity of the origin [m/s], world.
    pub velocity: Vector3<T>,
    /// Ω [rad/s], world.
    pub spin: Vector3<T>,
    /// Total mass [kg].
    pub mass: T,
    /// Inertia about the origin [kg m²], world.
    pub inertia: Matrix3<T>,
    /// Centre of mass from the origin [m], world.
    pub center: Vector3<T>,
    /// Takes body axes to world axes; read by the laws of [`Law::needs_axes`](super::Law::needs_axes) alone.
    pub axes: Matrix3<T>,
}

impl<T: Real> Cloud<'_, T> {
    #[inline]
    pub(super) fn velocity_at(&self, arm: &Vector3<T>) -> Vector3<T> {
        self.velocity + self.spin.cross(arm)
    }
}

#[inline]
pub(super) fn each_point<T: Real>(
    cloud: &Cloud<T>,
    load: &mut Load<T>,
    force: impl Fn(usize, &Vector3<T>, &Vector3<T>) -> Vector3<T>,
) {
    for k in 0..cloud.masses.len() {
        let arm = cloud.arms.at(k);
        load.push(&cloud.levers.at(k), &force(k, &(cloud.origin + arm), &cloud.velocity_at(&arm)));
    }
}

#[inline]
pub(super) fn sum_points<T: Real>(cloud: &Cloud<T>, potential: impl Fn(usize, &Vector3<T>) -> T) -> T {
    (0..cloud.masses.len()).map(|k| potential(k, &(cloud.origin + cloud.arms.at(k)))).sum()
}
