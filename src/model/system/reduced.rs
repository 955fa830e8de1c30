//! The models that a system may be reduced to, and what all of them know.

use nalgebra::Vector3;

use crate::arithmetic::Real;
use crate::model::{Falling, Forced, Free, PointCloud, Rotor};
use crate::rotation::{Rotation, formulas};

/// Any of the models.
#[derive(Clone, Debug)]
pub enum AnyModel<T: Real = f64> {
    /// Neither force nor torque.
    Free(Free<T>),
    /// Uniform gravity only.
    Falling(Falling<T>),
    /// Torques without force.
    Torque(Rotor<T>),
    /// A point fixed in the world.
    Pivot(Rotor<T>),
    /// Forces on points.
    Forced(Forced<T>),
    /// The note as written.
    Points(PointCloud<T>),
}

impl<T: Real> AnyModel<T> {
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
pub struct Rotational<T: Real = f64> {
    /// Principal moments about the origin [kg m²].
    pub moments: Vector3<T>,
    /// 1/moment about each principal axis [1/(kg m²)]; 0 where the body cannot spin.
    pub inverse_moments: Vector3<T>,
    /// Takes principal axes to world axes at t = 0.
    pub attitude: Rotation<T>,
    /// What a pivot carries; `None` where nothing holds the body.
    pub carried: Option<Carried<T>>,
    /// Takes body axes to principal axes.
    pub(super) body_to_principal: Rotation<T>,
}

/// The centre of mass of a body on a pivot, which a scheme may treat as held by a constraint.
#[derive(Clone, Copy, Debug)]
pub struct Carried<T: Real = f64> {
    /// Mass [kg].
    pub mass: T,
    /// Centre of mass from the pivot [m], principal axes.
    pub center: Vector3<T>,
}

impl<T: Real> Rotational<T> {
    /// Ω = R I⁻¹ Rᵀ L [rad/s], world.
    #[inline(always)]
    pub fn spin(&self, attitude: &Rotation<T>, momentum: &Vector3<T>) -> Vector3<T> {
        let columns = formulas::outer_columns([attitude.w, attitude.i, attitude.j, attitude.k]);
        formulas::spin(&columns, self.inverse_moments.into(), (*momentum).into()).into()
    }

    /// The orientation of the body axes.
    #[inline]
    pub fn orientation(&self, attitude: &Rotation<T>) -> Rotation<T> {
        attitude * self.body_to_principal
    }
}
