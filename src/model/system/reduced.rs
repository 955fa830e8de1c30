//! The models that a system may be reduced to, and what all of them know.

use nalgebra::Vector3;

use crate::model::{Falling, Forced, Free, PointCloud, Rotor};
use crate::rotation::{Rotation, formulas};

/// Any of the models.
#[derive(Clone, Debug)]
pub enum AnyModel {
    /// Neither force nor torque.
    Free(Free),
    /// Uniform gravity only.
    Falling(Falling),
    /// Torques without force.
    Torque(Rotor),
    /// A point fixed in the world.
    Pivot(Rotor),
    /// Forces on points.
    Forced(Forced),
    /// The note as written.
    Points(PointCloud),
}

impl AnyModel {
    /// Name as in records.
    pub fn name(&self) -> &'static str {
        match self {
            AnyModel::Free(_) => "free",
            AnyModel::Falling(_) => "falling",
            AnyModel::Torque(_) => "torque",
            AnyModel::Pivot(_) => "pivot",
            AnyModel::Forced(_) => "forced",
            AnyModel::Points(_) => "points",
        }
    }
}

/// What every reduced model knows about rotation: the body in its principal axes.
#[derive(Clone, Debug)]
pub struct Rotational {
    /// Principal moments about the origin [kg m²].
    pub moments: Vector3<f64>,
    /// 1/moment about each principal axis [1/(kg m²)]; 0 where the body cannot spin.
    pub inverse_moments: Vector3<f64>,
    /// Takes principal axes to world axes at t = 0.
    pub attitude: Rotation,
    /// Takes body axes to principal axes.
    pub(super) body_to_principal: Rotation,
}

impl Rotational {
    /// Ω = R I⁻¹ Rᵀ L [rad/s], world.
    #[inline(always)]
    pub fn spin(&self, attitude: &Rotation, momentum: &Vector3<f64>) -> Vector3<f64> {
        let columns = formulas::outer_columns([attitude.w, attitude.i, attitude.j, attitude.k]);
        formulas::spin(&columns, self.inverse_moments.into(), (*momentum).into()).into()
    }

    /// The orientation of the body axes.
    #[inline]
    pub fn orientation(&self, attitude: &Rotation) -> Rotation {
        attitude * self.body_to_principal
    }
}
