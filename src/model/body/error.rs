//! Why a body cannot be.

/// A body that cannot be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BodyError {
    /// No mass points.
    #[error("a body needs at least one mass point")]
    Empty,
    /// A mass that is not positive.
    #[error("mass {mass} of point {index} is not a positive number")]
    Mass {
        /// Index of the point.
        index: usize,
        /// Its mass [kg].
        mass: f64,
    },
    /// Massless points on a rod or on a single point, which no force may turn in every direction.
    #[error("massless points need a body whose mass is not on one line")]
    Massless,
    /// An inertia that is not symmetric.
    #[error("inertia is not symmetric: entry ({row}, {column}) differs from its mirror by {difference:e}")]
    Asymmetric {
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// Difference [kg m²].
        difference: f64,
    },
    /// A moment of inertia below zero.
    #[error("principal moment {moment} is negative")]
    NegativeMoment {
        /// The moment [kg m²].
        moment: f64,
    },
    /// Moments that break the triangle inequality.
    #[error(
        "no positive masses have the principal moments {smallest}, {middle}, {largest}: the largest must not \
         exceed the sum of the others; set unphysical_inertia = true to admit them"
    )]
    Triangle {
        /// Smallest moment [kg m²].
        smallest: f64,
        /// Middle moment [kg m²].
        middle: f64,
        /// Largest moment [kg m²].
        largest: f64,
    },
    /// Moments too far apart, but not those of a rod.
    #[error(
        "the principal moments {smallest:e} and {largest:e} differ by more than 1e12: too thin for f64, too thick for a rod"
    )]
    Condition {
        /// Smallest moment [kg m²].
        smallest: f64,
        /// Largest moment [kg m²].
        largest: f64,
    },
    /// Numbers whose products leave the range of f64.
    #[error("mass and size give an inertia outside the range of f64")]
    Range,
}
