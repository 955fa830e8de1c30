//! Primitive shapes: volume, uniform inertia and outline.

use nalgebra::{Matrix3, Vector3};

use super::pose::Pose;
use crate::model::body::second_moment_inertia;

/// A shape about its own centre, lengths in m; round shapes have their axis along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    /// Half sizes.
    Box(Vector3<f64>),
    /// Semi-axes; a sphere has three equal ones.
    Ellipsoid(Vector3<f64>),
    /// Radius, half length.
    Cylinder(f64, f64),
    /// Radius, half length of the straight part.
    Capsule(f64, f64),
}

/// A shape in the axes of its link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Solid {
    pub shape: Shape,
    pub pose: Pose,
    /// Density [kg/m³] where the file gives it one.
    pub density: Option<f64>,
}

impl Shape {
    /// A sphere.
    pub fn sphere(radius: f64) -> Shape {
        Shape::Ellipsoid(Vector3::repeat(radius))
    }

    /// [m³].
    pub fn volume(&self) -> f64 {
        let pi = std::f64::consts::PI;
        match *self {
            Shape::Box(half) => 8.0 * half.x * half.y * half.z,
            Shape::Ellipsoid(axes) => 4.0 / 3.0 * pi * axes.x * axes.y * axes.z,
            Shape::Cylinder(r, half) => 2.0 * pi * r * r * half,
            Shape::Capsule(r, half) => 2.0 * pi * r * r * half + 4.0 / 3.0 * pi * r * r * r,
        }
    }

    /// Principal moments of the uniform solid of 1 kg about its centre [m²].
    fn moments(&self) -> Vector3<f64> {
        match *self {
            Shape::Box(half) => across(half.component_mul(&half) / 3.0),
            Shape::Ellipsoid(axes) => across(axes.component_mul(&axes) / 5.0),
            Shape::Cylinder(r, half) => across(Vector3::new(r * r / 4.0, r * r / 4.0, half * half / 3.0)),
            Shape::Capsule(r, half) => {
                // A cylinder and two half balls, whose centres are 3/8 r beyond its ends.
                let ball = 4.0 / 3.0 * r / (2.0 * half + 4.0 / 3.0 * r);
                let tube = 1.0 - ball;
                let round = tube * r * r / 4.0 + ball * r * r / 5.0;
                let along = tube * half * half / 3.0 + ball * (r * r / 5.0 + half * half + 0.75 * half * r);
                across(Vector3::new(round, round, along))
            }
        }
    }

    /// Distance from the centre to the tangent plane with the unit normal `n`, in the axes of the shape [m].
    fn support(&self, n: &Vector3<f64>) -> f64 {
        match *self {
            Shape::Box(half) => half.dot(&n.abs()),
            Shape::Ellipsoid(axes) => axes.component_mul(n).norm(),
            Shape::Cylinder(r, half) => r * n.x.hypot(n.y) + half * n.z.abs(),
            Shape::Capsule(r, half) => r + half * n.z.abs(),
        }
    }
}

/// Moments from the variances of 1 kg along three axes.
fn across(variance: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(variance.y + variance.z, variance.x + variance.z, variance.x + variance.y)
}

impl Solid {
    /// Tensor of the uniform solid of 1 kg about its own centre, axes of the link [m²].
    pub fn tensor(&self) -> Matrix3<f64> {
        self.pose.turned(&Matrix3::from_diagonal(&self.shape.moments()))
    }

    /// Half size along the axes of the link [m].
    pub fn half_size(&self) -> Vector3<f64> {
        Vector3::from_fn(|i, _| self.shape.support(&self.pose.axes.row(i).transpose()))
    }
}

/// Matter that is put together: a uniform solid of a mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// [kg].
    pub mass: f64,
    /// Centre of mass [m], axes of the link.
    pub center: Vector3<f64>,
    /// Tensor of 1 kg about the centre, axes of the link [m²].
    pub tensor: Matrix3<f64>,
}

impl Solid {
    /// The solid with a mass [kg].
    pub fn of_mass(&self, mass: f64) -> Part {
        Part { mass, center: self.pose.position, tensor: self.tensor() }
    }
}

/// Mass, centre of mass and tensor about it, in the axes of the link.
pub(super) fn compose(parts: &[Part]) -> (f64, Vector3<f64>, Matrix3<f64>) {
    let mass: f64 = parts.iter().map(|part| part.mass).sum();
    if mass == 0.0 {
        return (0.0, Vector3::zeros(), Matrix3::zeros());
    }
    let center: Vector3<f64> = parts.iter().map(|part| part.center * (part.mass / mass)).sum();
    let about = |part: &Part| (part.tensor + second_moment_inertia(&(part.center - center))) * part.mass;
    (mass, center, parts.iter().map(about).sum())
}
