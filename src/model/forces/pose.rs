//! What laws are told of a body in motion, and what they answer.

use nalgebra::{Matrix3, Vector3};

/// Force and torque about the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// F [N], world.
    pub force: Vector3<f64>,
    /// τ about the origin [N m], world.
    pub torque: Vector3<f64>,
}

impl Load {
    /// Adds a force that acts at `arm` from the origin [m], world.
    #[inline]
    pub fn push(&mut self, arm: &Vector3<f64>, force: &Vector3<f64>) {
        self.force += force;
        self.torque += arm.cross(force);
    }
}

/// Where a body is and how it moves.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// Takes principal axes to world axes.
    pub axes: Matrix3<f64>,
    /// Position of the origin [m], world.
    pub origin: Vector3<f64>,
    /// Velocity of the origin [m/s], world.
    pub velocity: Vector3<f64>,
    /// Ω [rad/s], world.
    pub spin: Vector3<f64>,
}

impl Pose {
    /// Velocity of the body point at `arm` from the origin, U + Ω × arm [m/s].
    #[inline]
    pub fn velocity_at(&self, arm: &Vector3<f64>) -> Vector3<f64> {
        self.velocity + self.spin.cross(arm)
    }
}

/// Arms of points [m], world, one by one or coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
pub enum Arms<'a> {
    /// A vector a point.
    Listed(&'a [Vector3<f64>]),
    /// A column a coordinate.
    Columns {
        /// Along the first axis.
        x: &'a [f64],
        /// Along the second.
        y: &'a [f64],
        /// Along the third.
        z: &'a [f64],
    },
}

impl Arms<'_> {
    /// The arm of a point.
    #[inline]
    pub fn at(&self, k: usize) -> Vector3<f64> {
        match self {
            Arms::Listed(arms) => arms[k],
            Arms::Columns { x, y, z } => Vector3::new(x[k], y[k], z[k]),
        }
    }
}

/// Mass points and massless markers of a body in motion, and what their laws need besides.
pub struct Cloud<'a> {
    /// X̃ of every mass point, then of every marker [m], world.
    pub arms: Arms<'a>,
    /// Lever arms of their forces [m], world: X̃ again, but in schemes that keep a force while its point moves.
    pub levers: Arms<'a>,
    /// Masses of the mass points [kg].
    pub masses: &'a [f64],
    /// Position of the origin [m], world.
    pub origin: Vector3<f64>,
    /// Velocity of the origin [m/s], world.
    pub velocity: Vector3<f64>,
    /// Ω [rad/s], world.
    pub spin: Vector3<f64>,
    /// Total mass [kg].
    pub mass: f64,
    /// Inertia about the origin [kg m²], world.
    pub inertia: Matrix3<f64>,
    /// Centre of mass from the origin [m], world.
    pub center: Vector3<f64>,
    /// Takes body axes to world axes; read by the laws of [`Law::needs_axes`](super::Law::needs_axes) alone.
    pub axes: Matrix3<f64>,
}

impl Cloud<'_> {
    #[inline]
    pub(super) fn velocity_at(&self, arm: &Vector3<f64>) -> Vector3<f64> {
        self.velocity + self.spin.cross(arm)
    }
}

#[inline]
pub(super) fn each_point(
    cloud: &Cloud,
    load: &mut Load,
    force: impl Fn(usize, &Vector3<f64>, &Vector3<f64>) -> Vector3<f64>,
) {
    for k in 0..cloud.masses.len() {
        let arm = cloud.arms.at(k);
        load.push(&cloud.levers.at(k), &force(k, &(cloud.origin + arm), &cloud.velocity_at(&arm)));
    }
}

#[inline]
pub(super) fn sum_points(cloud: &Cloud, potential: impl Fn(usize, &Vector3<f64>) -> f64) -> f64 {
    (0..cloud.masses.len()).map(|k| potential(k, &(cloud.origin + cloud.arms.at(k)))).sum()
}
