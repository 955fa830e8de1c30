//! Why a system cannot be.

/// A scene that contradicts itself.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// L of a rod has a part along it.
    #[error(
        "the body is a rod and the angular momentum has a part of {along:e} along it (|L| = {length:e}): no spin carries it; make it perpendicular to the rod"
    )]
    AlongRod {
        /// Part along the rod [kg m²/s].
        along: f64,
        /// |L| [kg m²/s].
        length: f64,
    },
    /// A torque about a rod.
    #[error(
        "the body is a rod and law '{law}' turns it about itself, which no spin can follow; write a torque in body \
         axes across the rod, a moment along it, or a spring that is fastened on its line"
    )]
    TorqueAlongRod {
        /// Index of the law.
        index: usize,
        /// Name of the law.
        law: &'static str,
    },
    /// L of a single point.
    #[error(
        "the body is a single point and cannot carry an angular momentum of {length:e} about itself; remove it"
    )]
    PointMomentum {
        /// |L| [kg m²/s].
        length: f64,
    },
    /// A law that acts on points on a body that has none.
    #[error("law '{law}' acts on mass points, and no positive masses have this body's inertia")]
    NoPoints {
        /// Index of the law.
        index: usize,
        /// Name of the law.
        law: &'static str,
    },
    /// A list with a length other than the number of points.
    #[error("law '{law}' has {given} values for {points} mass points")]
    ListLength {
        /// Index of the law.
        index: usize,
        /// Name of the law.
        law: &'static str,
        /// Values given.
        given: usize,
        /// Mass points of the body.
        points: usize,
    },
    /// A point index out of range.
    #[error("point {point} does not exist: the body has {points} mass points, counted from 0")]
    PointIndex {
        /// Index of the law.
        index: usize,
        /// Index given.
        point: usize,
        /// Mass points of the body.
        points: usize,
    },
    /// The point form of a body that has none.
    #[error("no positive masses have this body's inertia: it has no point form; use --model least")]
    NoPointForm,
    /// Numbers that an arithmetic does not hold.
    #[error(
        "moments, mass or momentum leave the range of {arithmetic}; choose units in which they are nearer to one"
    )]
    Range {
        /// Name of the arithmetic.
        arithmetic: &'static str,
    },
}
