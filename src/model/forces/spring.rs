//! A spring and damper from a point of the body to an anchor in the world.

use nalgebra::Vector3;

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{ALONG_ROD, Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{Cloud, Load, Pose, to_principal};
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

parameters! {
    /// F = −k (|d| − rest) d/|d| − c U with d = X − anchor; the damper takes the whole velocity U of the point.
    pub struct Spring {
        /// Where it holds: a mass point, or a place on the body that need not carry mass
        attachment: Attachment<T> ["m"] = Body(Length), REQUIRED, point(0);
        /// Anchor, world
        anchor: Vector3<T> ["m"] = Place, ZEROS, vector(0.0, 0.0, 2.0);
        /// k
        stiffness: T ["N/m"] = Number(Stiffness), REQUIRED, number(100.0);
        /// c, of the whole velocity of the point
        damping: T ["N s/m"] = Number(Damping), ZERO, number(0.5);
        /// Length at which the spring is slack
        rest_length: T ["m"] = Number(Length), ZERO, number(0.5);
    }
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    arm: Vector3<T>,
    spring: Spring<T>,
}

impl<T: Real> Spring<T> {
    /// Index of its arm in a cloud; counts the markers that come before it.
    fn arm_index(&self, next_marker: &mut usize) -> usize {
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
}

impl<T: Real> ForceLaw<T> for Spring<T> {
    const NAME: &'static str = "spring";
    const FORMULA: &'static str = "F = -k (|d| - rest) d/|d| - c U,  d = X_k - anchor";
    const SOURCE: &'static str = "Hooke's law with a viscous damper";
    const ACTS: Acts = Acts::OnPlace;
    const HAS_KINK: bool = false;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        self.damping != 0.0
    }

    fn clock(&self) -> T {
        T::zero()
    }

    fn conserves(&self) -> bool {
        self.damping == 0.0
    }

    fn drives(&self) -> bool {
        false
    }

    fn is_galilean(&self) -> bool {
        false
    }

    fn uniform_acceleration(&self) -> Option<Vector3<T>> {
        None
    }

    fn turns_rod(&self, direction: &Vector3<T>, extent: T) -> bool {
        match &self.attachment {
            Attachment::Point(_) => false,
            Attachment::At(place) => {
                let off = rotation::length(&place.cross(direction));
                off > rotation::length(place).max(extent) * ALONG_ROD
            }
        }
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        None
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let arm = match &self.attachment {
            Attachment::Point(index) => body.points[*index].position,
            Attachment::At(position) => *position,
        };
        Reduced { arm: to_principal(body, &arm), spring: self.clone() }
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, marker: &mut usize, load: &mut Load<T>) {
        let index = self.arm_index(marker);
        let arm = cloud.arms.at(index);
        load.push(&cloud.levers.at(index), &self.force(&(cloud.origin + arm), &cloud.velocity_at(&arm)));
    }

    fn potential(&self, cloud: &Cloud<T>, marker: &mut usize) -> Option<T> {
        let position = cloud.origin + cloud.arms.at(self.arm_index(marker));
        let stretch = rotation::length(&(position - self.anchor)) - self.rest_length;
        Some(T::of(0.5) * self.stiffness * stretch * stretch)
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        let arm = pose.in_world(&self.arm);
        load.push(&arm, &self.spring.force(&(pose.origin + arm), &pose.velocity_at(&arm)));
    }
}

impl RandomLaw for Spring {
    /// On a mass point, or near one.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let rate = draw.logarithmic(0.3, 2.0);
        let distance = draw.between(2.0, 4.0);
        let anchor = around.position + draw.vector(distance);
        let anchor = anchor.map(|x| draw.number(x));
        let attachment = if draw.chance(0.6) {
            Attachment::Point(draw.below(around.body.points.len()))
        } else {
            Attachment::At(around.place(draw))
        };
        let stiffness = draw.number(rate * rate);
        let mut spring = Spring { attachment, anchor, stiffness, damping: 0.0, rest_length: 0.0 };
        if draw.chance(0.5) {
            let part = draw.logarithmic(0.02, 0.5);
            spring.damping = draw.number(2.0 * part * rate);
        }
        if draw.chance(0.3) {
            spring.rest_length = draw.between(0.5, 1.5);
        }
        Some((spring, rate))
    }
}
