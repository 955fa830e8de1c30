//! A moment of a motion as every model shows it, and how far two of them are apart.

use nalgebra::Vector3;

use super::body::{Body, Shape};
use crate::arithmetic::Real;
use crate::quantity::{PerQuantity, Quantity};
use crate::rotation::{self, Rotation};

/// A moment of a motion, the same for every model. World axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapshot<T: Real = f64> {
    /// t [s].
    pub time: T,
    /// X_cm [m].
    pub position: Vector3<T>,
    /// U_cm [m/s].
    pub velocity: Vector3<T>,
    /// Takes body axes to world axes.
    pub orientation: Rotation<T>,
    /// Ω [rad/s].
    pub angular_velocity: Vector3<T>,
    /// L [kg m²/s], about the centre of mass, or about the pivot where there is one.
    pub angular_momentum: Vector3<T>,
    /// Largest change of a distance between points of the body, over its extent.
    pub stretch: T,
}

impl<T: Real> Snapshot<T> {
    /// The same moment in another arithmetic, by the nearest f64: exact from f32 and f64 into one of as many digits or more.
    pub fn nearest<U: Real>(&self) -> Snapshot<U> {
        let number = |value: T| U::of(value.to_f64());
        Snapshot {
            time: number(self.time),
            position: self.position.map(number),
            velocity: self.velocity.map(number),
            // Not normalised: an angle between rotations is that between quaternions of any length.
            orientation: Rotation::new_unchecked(self.orientation.as_ref().coords.map(number).into()),
            angular_velocity: self.angular_velocity.map(number),
            angular_momentum: self.angular_momentum.map(number),
            stretch: number(self.stretch),
        }
    }
}

/// How far two moments of one body are apart, each quantity in its unit.
///
/// Lengths are Euclidean. For a rod the orientation is the angle between its directions, for a single point it
/// is 0. The body-point difference is the largest over the mass points, or over the ends of the principal
/// radii of gyration where the body has none.
pub fn difference<T: Real>(body: &Body<T>, a: &Snapshot<T>, b: &Snapshot<T>) -> PerQuantity<T> {
    let orientation = match body.shape {
        Shape::Point => T::zero(),
        Shape::Rod { direction } => {
            rotation::angle_between_directions(&(a.orientation * direction), &(b.orientation * direction))
        }
        Shape::Extended => rotation::angle_between(&a.orientation, &b.orientation),
    };
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position => rotation::length(&(a.position - b.position)),
        Quantity::Velocity => rotation::length(&(a.velocity - b.velocity)),
        Quantity::Orientation => orientation,
        Quantity::AngularVelocity => rotation::length(&(a.angular_velocity - b.angular_velocity)),
        Quantity::AngularMomentum => rotation::length(&(a.angular_momentum - b.angular_momentum)),
        Quantity::BodyPoint => body_point_difference(body, a, b),
    })
}

/// Largest distance between the places of a body point in two moments [m].
///
/// X_k = X_cm + R (x_k − c). The difference of the rotations is applied as one small matrix, so that equal
/// orientations give exactly the difference of the positions.
fn body_point_difference<T: Real>(body: &Body<T>, a: &Snapshot<T>, b: &Snapshot<T>) -> T {
    let shift = a.position - b.position;
    let turn =
        a.orientation.to_rotation_matrix().into_inner() - b.orientation.to_rotation_matrix().into_inner();
    let apart = |x: Vector3<T>| rotation::length(&(shift + turn * (x - body.center)));
    if body.points.is_empty() {
        let radii = body.moments.map(|moment| (moment / body.mass).sqrt());
        return (0..3)
            .map(|i| apart(body.center + body.principal * Vector3::ith(i, radii[i])))
            .fold(T::zero(), T::max);
    }
    body.points.iter().map(|p| apart(p.position)).fold(T::zero(), T::max)
}
