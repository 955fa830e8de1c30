//! The points of a body put into the world at an orientation, for laws in their point form.

use nalgebra::{Matrix3, Vector3};

use super::forces::{Arms, Cloud};
use super::system::System;
use crate::arithmetic::Real;
use crate::rotation::Rotation;

/// Mass points and markers of a body in world axes. Made once, turned often.
#[derive(Clone, Debug)]
pub struct Placed<T: Real = f64> {
    arms: Vec<Vector3<T>>,
    masses: Vec<T>,
    mass: T,
    axes: Matrix3<T>,
    inertia: Matrix3<T>,
    center: Vector3<T>,
}

impl<T: Real> Placed<T> {
    /// The points of the system's body in body axes, with room for its markers.
    pub fn new(system: &System<T>) -> Placed<T> {
        let body = &system.body;
        Placed {
            arms: vec![Vector3::zeros(); body.points.len() + system.forces.markers().len()],
            masses: body.points.iter().map(|p| p.mass).collect(),
            mass: body.mass,
            axes: Matrix3::identity(),
            inertia: body.inertia,
            center: body.center,
        }
    }

    /// Turns the points from body axes to `orientation`.
    pub fn turn(&mut self, system: &System<T>, orientation: &Rotation<T>) {
        let axes = orientation.to_rotation_matrix().into_inner();
        let given = system.body.points.iter().map(|p| &p.position).chain(system.forces.markers());
        for (arm, position) in self.arms.iter_mut().zip(given) {
            *arm = axes * position;
        }
        self.inertia = axes * system.body.inertia * axes.transpose();
        self.center = axes * system.body.center;
        self.axes = axes;
    }

    /// Centre of mass from the origin [m], world.
    pub fn center(&self) -> Vector3<T> {
        self.center
    }

    /// The points in motion: origin [m], its velocity [m/s] and Ω [rad/s], world.
    pub fn cloud(&self, origin: Vector3<T>, velocity: Vector3<T>, spin: Vector3<T>) -> Cloud<'_, T> {
        Cloud {
            arms: Arms::Listed(&self.arms),
            levers: Arms::Listed(&self.arms),
            masses: &self.masses,
            origin,
            velocity,
            spin,
            mass: self.mass,
            inertia: self.inertia,
            center: self.center,
            axes: self.axes,
        }
    }
}
