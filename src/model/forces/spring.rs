//! A spring and damper from a point of the body to an anchor in the world.

use nalgebra::Vector3;

use super::{Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

/// Where on the body a spring holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Attachment<T: Real = f64> {
    /// At a mass point.
    Point(usize),
    /// At a place that need not carry mass [m], body axes, relative to the origin.
    At(Vector3<T>),
}

/// F = −k (|d| − rest) d/|d| − c U with d = X − anchor; the damper takes the whole velocity U of the point.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring<T: Real = f64> {
    /// Where it holds.
    pub attachment: Attachment<T>,
    /// Anchor [m], world.
    pub anchor: Vector3<T>,
    /// k [N/m].
    pub stiffness: T,
    /// c [N s/m].
    pub damping: T,
    /// Length at which the spring is slack [m].
    pub rest_length: T,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    arm: Vector3<T>,
    spring: Spring<T>,
}

impl<T: Real> Spring<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &Spring) -> Spring<T> {
        Spring {
            attachment: match &law.attachment {
                Attachment::Point(index) => Attachment::Point(*index),
                Attachment::At(position) => Attachment::At(position.map(T::of)),
            },
            anchor: law.anchor.map(T::of),
            stiffness: T::of(law.stiffness),
            damping: T::of(law.damping),
            rest_length: T::of(law.rest_length),
        }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let arm = match &self.attachment {
            Attachment::Point(index) => body.points[*index].position,
            Attachment::At(position) => *position,
        };
        Reduced { arm: to_principal(body, &arm), spring: self.clone() }
    }

    /// Index of its arm in a cloud; counts the markers that come before it.
    pub(super) fn arm_index(&self, next_marker: &mut usize) -> usize {
        match self.attachment {
            Attachment::Point(index) => index,
            Attachment::At(_) => {
                *next_marker += 1;
                *next_marker - 1
            }
        }
    }

    /// Force [N] on the point at `position` [m] with `velocity` [m/s], world. A spring pulled to length zero
    /// has no direction and, unless its rest length is zero too, gives no elastic force there.
    #[inline]
    pub fn force(&self, position: &Vector3<T>, velocity: &Vector3<T>) -> Vector3<T> {
        let d = position - self.anchor;
        if self.rest_length == 0.0 {
            return d * -self.stiffness - velocity * self.damping;
        }
        let distance = rotation::length(&d);
        let stretch = if distance == 0.0 { distance } else { T::one() - self.rest_length / distance };
        d * (-self.stiffness * stretch) - velocity * self.damping
    }

    pub(super) fn potential(&self, position: &Vector3<T>) -> T {
        let stretch = rotation::length(&(position - self.anchor)) - self.rest_length;
        T::of(0.5) * self.stiffness * stretch * stretch
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, pose: &Pose<T>, load: &mut Load<T>) {
        let arm = pose.axes * self.arm;
        load.push(&arm, &self.spring.force(&(pose.origin + arm), &pose.velocity_at(&arm)));
    }
}
