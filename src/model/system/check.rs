//! What a start and a law must be for a body.

use nalgebra::Vector3;

use super::SystemError;
use crate::model::body::{Body, Shape};
use crate::model::forces::{Attachment, Law, PerPoint, Spring, TorqueAxes};
use crate::rotation::{self, Rotation};

/// Part along a rod, over the whole, that may still be rounding of what was given.
const ALONG_ROD: f64 = 1e-9;

pub(super) fn check_momentum(
    body: &Body,
    orientation: &Rotation,
    momentum: &Vector3<f64>,
) -> Result<(), SystemError> {
    let length = rotation::length(momentum);
    match body.shape {
        Shape::Point if length != 0.0 => Err(SystemError::PointMomentum { length }),
        Shape::Rod { direction } => {
            let along = (orientation * direction).dot(momentum);
            if along.abs() > ALONG_ROD * length {
                Err(SystemError::AlongRod { along, length })
            } else {
                Ok(())
            }
        }
        _ => Ok(()),
    }
}

pub(super) fn check_law(index: usize, law: &Law, body: &Body) -> Result<(), SystemError> {
    let points = body.points.len();
    if let Shape::Rod { direction } = body.shape
        && turns_about(law, &direction, body.extent())
    {
        return Err(SystemError::TorqueAlongRod { index, law: law.name() });
    }
    if law.needs_points() && points == 0 {
        return Err(SystemError::NoPoints { index, law: law.name() });
    }
    let list = match law {
        Law::Drag(drag) => Some(&drag.coefficient),
        Law::Lorentz(lorentz) => Some(&lorentz.charge),
        _ => None,
    };
    if let Some(PerPoint::Each(values)) = list
        && values.len() != points
    {
        return Err(SystemError::ListLength { index, law: law.name(), given: values.len(), points });
    }
    if let Law::Spring(spring) = law
        && let Attachment::Point(point) = spring.attachment
        && point >= points
    {
        return Err(SystemError::PointIndex { index, point, points });
    }
    Ok(())
}

/// Whether a law has a torque about a rod: one that is fixed in the world while the rod turns, one with a part along
/// the rod, that of a moment with a part across it, or a spring fastened off its line. Forces on points and
/// gravity-gradient torques have none.
fn turns_about(law: &Law, direction: &Vector3<f64>, extent: f64) -> bool {
    match law {
        Law::Torque(torque) => [torque.constant, torque.cosine, torque.sine].iter().any(|amplitude| {
            let along = amplitude.dot(direction).abs() > ALONG_ROD * rotation::length(amplitude);
            along || (torque.axes == TorqueAxes::World && amplitude.amax() > 0.0)
        }),
        Law::Dipole(dipole) => {
            let across = rotation::length(&dipole.moment.cross(direction));
            across > ALONG_ROD * rotation::length(&dipole.moment)
        }
        Law::Spring(Spring { attachment: Attachment::At(place), .. }) => {
            let off = rotation::length(&place.cross(direction));
            off > ALONG_ROD * rotation::length(place).max(extent)
        }
        _ => false,
    }
}
