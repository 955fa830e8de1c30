//! What a start and a law must be for a body.

use nalgebra::Vector3;

use super::SystemError;
use crate::model::body::{Body, Shape};
use crate::model::forces::{ALONG_ROD, Argument, Attachment, Law, PerPoint};
use crate::rotation::{self, Rotation};

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
        && law.turns_rod(&direction, body.extent())
    {
        return Err(SystemError::TorqueAlongRod { index, law: law.name() });
    }
    if law.needs_points() && points == 0 {
        return Err(SystemError::NoPoints { index, law: law.name() });
    }
    for (_, argument) in law.arguments() {
        match argument {
            Argument::PerPoint(PerPoint::Each(values)) if values.len() != points => {
                return Err(SystemError::ListLength { index, law: law.name(), given: values.len(), points });
            }
            Argument::Attachment(Attachment::Point(point)) if point >= points => {
                return Err(SystemError::PointIndex { index, point, points });
            }
            _ => {}
        }
    }
    Ok(())
}
