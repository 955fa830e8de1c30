//! The rigid body: mass points, or a mass and an inertia.
//!
//! Everything here is in body axes and relative to the **origin**: the centre of mass of a body that moves
//! freely, the pivot of a body that is fixed there. With P = Σ M x xᵀ the inertia is I = tr(P) E − P.
//!
//! A body given by its inertia is stood for by mass points that have it and no third moments: two on each principal axis along which
//! P is not zero, so six for a solid, four for a plate, two for a rod, and one for a point.

mod error;
mod moments;
mod precise;
mod stand_in;

use nalgebra::{Matrix3, Vector3};

use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};
pub use error::BodyError;
pub(crate) use moments::principal_axes;
use moments::{check_moments, shape_of_moments, shape_of_points, symmetric, thin_axis_outside};
pub(crate) use precise::rotation_of;
use stand_in::stand_in_points;

/// Above this ratio of moments, I Ω = L no longer determines the spin about the smallest one in f64.
pub(crate) const LARGEST_CONDITION: f64 = 1e12;

/// One mass point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassPoint<T: Real = f64> {
    /// Mass [kg], positive; zero of a point that carries forces alone.
    pub mass: T,
    /// Position [m], body axes, relative to the origin.
    pub position: Vector3<T>,
}

/// What rotation means for a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<T: Real = f64> {
    /// All mass in the origin: no rotation.
    Point,
    /// All mass on a line through the origin: no rotation about it.
    Rod {
        /// Unit vector along the line, body axes.
        direction: Vector3<T>,
    },
    /// Three moments above zero: plates and solids.
    Extended,
}

/// A rigid body about its origin.
#[derive(Clone, Debug)]
pub struct Body<T: Real = f64> {
    /// Total mass [kg].
    pub mass: T,
    /// Mass points; empty where no positive masses have the inertia.
    pub points: Vec<MassPoint<T>>,
    /// Centre of mass [m], body axes, relative to the origin: zero unless there is a pivot.
    pub center: Vector3<T>,
    /// Inertia about the origin [kg m²], body axes.
    pub inertia: Matrix3<T>,
    /// Principal moments about the origin [kg m²], in the order of the principal axes.
    pub moments: Vector3<T>,
    /// Takes principal axes to body axes; the identity where the body axes are principal.
    pub principal: Rotation<T>,
    /// What rotation means for it.
    pub shape: Shape<T>,
    /// Whether a point of it is fixed in the world.
    pub pivoted: bool,
}

impl Body {
    /// A body of mass points, given in any frame. Returns it with the centre of mass in that frame [m].
    ///
    /// `pivot` is a point fixed in the world, in the same frame.
    ///
    /// # Errors
    /// [`BodyError`].
    pub fn from_points(
        given: &[MassPoint],
        pivot: Option<Vector3<f64>>,
    ) -> Result<(Body, Vector3<f64>), BodyError> {
        Body::with_massless(given, &[], pivot)
    }

    /// The same with massless points [m], in the same frame, which carry forces alone. They come after the mass points.
    ///
    /// # Errors
    /// [`BodyError`].
    pub fn with_massless(
        given: &[MassPoint],
        massless: &[Vector3<f64>],
        pivot: Option<Vector3<f64>>,
    ) -> Result<(Body, Vector3<f64>), BodyError> {
        if given.is_empty() {
            return Err(BodyError::Empty);
        }
        for (index, point) in given.iter().enumerate() {
            if !(point.mass > 0.0 && point.mass.is_finite()) {
                return Err(BodyError::Mass { index, mass: point.mass });
            }
        }
        let mass: f64 = given.iter().map(|p| p.mass).sum();
        let center_given = given.iter().map(|p| p.position * (p.mass / mass)).sum::<Vector3<f64>>();
        let origin = pivot.unwrap_or(center_given);
        let rounding = 16.0 * f64::EPSILON * given.iter().map(|p| p.position.amax()).fold(0.0, f64::max);
        let mut points: Vec<_> =
            given.iter().map(|p| MassPoint { mass: p.mass, position: p.position - origin }).collect();
        let extent = points.iter().map(|p| p.position.amax()).fold(0.0, f64::max);
        let shape = if extent <= rounding { Shape::Point } else { shape_of_points(&points, rounding) };
        if !massless.is_empty() && shape != Shape::Extended {
            return Err(BodyError::Massless);
        }
        points.extend(massless.iter().map(|place| MassPoint { mass: 0.0, position: place - origin }));
        let center = if pivot.is_some() { center_given - origin } else { Vector3::zeros() };
        let body = Body::assemble(mass, inertia_of(&points), center, shape, pivot.is_some(), points)?;
        Ok((body, center_given))
    }

    /// A body of a mass [kg] and an inertia about the centre of mass [kg m²], body axes.
    ///
    /// `pivot` is a point fixed in the world, body axes, relative to the centre of mass. `unphysical` admits
    /// moments that no positive masses have; such a body has no mass points.
    ///
    /// # Errors
    /// [`BodyError`].
    pub fn from_inertia(
        mass: f64,
        inertia: Matrix3<f64>,
        pivot: Option<Vector3<f64>>,
        unphysical: bool,
    ) -> Result<Body, BodyError> {
        if !(mass > 0.0 && mass.is_finite()) {
            return Err(BodyError::Mass { index: 0, mass });
        }
        let inertia = symmetric(&inertia)?;
        let (moments, axes) = principal_axes(&inertia);
        check_moments(&moments, unphysical)?;
        let origin = pivot.unwrap_or_else(Vector3::zeros);
        let points = stand_in_points(mass, &moments, &axes, &origin);
        let about_origin = inertia + second_moment_inertia(&origin) * mass;
        let shape = shape_of_moments(&about_origin)?;
        Body::assemble(mass, about_origin, -origin, shape, pivot.is_some(), points)
    }

    fn assemble(
        mass: f64,
        inertia: Matrix3<f64>,
        center: Vector3<f64>,
        shape: Shape,
        pivoted: bool,
        points: Vec<MassPoint>,
    ) -> Result<Body, BodyError> {
        let out_of_range = |x: f64| !x.is_finite() || (x != 0.0 && x.abs() < f64::MIN_POSITIVE);
        let vanished = shape != Shape::Point && inertia.amax() == 0.0;
        if !mass.is_finite() || vanished || inertia.iter().any(|x| out_of_range(*x)) {
            return Err(BodyError::Range);
        }
        let (mut moments, principal) = principal_axes(&inertia);
        match shape {
            Shape::Point => moments = Vector3::zeros(),
            Shape::Rod { .. } => {
                let along = moments.iamin();
                moments[along] = 0.0;
            }
            Shape::Extended if moments.max() > LARGEST_CONDITION * moments.min() => {
                return Err(BodyError::Condition { smallest: moments.min(), largest: moments.max() });
            }
            Shape::Extended => {}
        }
        let (moments, principal) = thin_axis_outside(moments, principal);
        Ok(Body { mass, points, center, inertia, moments, principal, shape, pivoted })
    }
}

impl<T: Real> Body<T> {
    /// 1/moment for each principal axis [1/(kg m²)], 0 where the body cannot spin about it.
    pub fn inverse_moments(&self) -> Vector3<T> {
        self.moments.map(|moment| if moment == 0.0 { moment } else { T::one() / moment })
    }

    /// I⁻¹ about the origin [1/(kg m²)], body axes; its pseudo-inverse for a rod or a point.
    pub fn inverse_inertia(&self) -> Matrix3<T> {
        let axes = self.principal.to_rotation_matrix().into_inner();
        axes * Matrix3::from_diagonal(&self.inverse_moments()) * axes.transpose()
    }

    /// Whether two principal moments are equal, to rounding.
    pub fn symmetric(&self) -> bool {
        let rounding = self.moments.amax() * (16.0 * T::UNIT);
        (0..3).any(|i| (self.moments[i] - self.moments[(i + 1) % 3]).abs() <= rounding)
    }

    /// Whether a second moment of the mass, ½ tr I − I, is zero to rounding: a plate.
    pub fn flat(&self) -> bool {
        let second = Vector3::repeat(self.moments.sum() / 2.0) - self.moments;
        second.iter().any(|moment| moment.abs() <= self.moments.amax() * 1e-12)
    }

    /// Length scale of the body [m]: the farthest mass point from the origin, or the largest radius of gyration.
    pub fn extent(&self) -> T {
        let farthest = self.points.iter().map(|p| rotation::length(&p.position)).fold(T::zero(), T::max);
        if farthest > 0.0 { farthest } else { (self.moments.amax() / self.mass).sqrt() }
    }
}

/// Inertia of mass points about the origin, Σ M (|x|² E − x xᵀ) [kg m²].
pub(crate) fn inertia_of<T: Real>(points: &[MassPoint<T>]) -> Matrix3<T> {
    points.iter().map(|p| second_moment_inertia(&p.position) * p.mass).sum()
}

/// |x|² E − x xᵀ [m²].
pub(crate) fn second_moment_inertia<T: Real>(x: &Vector3<T>) -> Matrix3<T> {
    Matrix3::from_diagonal_element(x.norm_squared()) - x * x.transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(mass: f64, x: f64, y: f64, z: f64) -> MassPoint {
        MassPoint { mass, position: Vector3::new(x, y, z) }
    }

    #[test]
    fn stand_in_points_have_the_mass_center_and_inertia_and_no_third_moments() {
        let turned = rotation::turn(&Vector3::new(0.3, -0.8, 1.7)).to_rotation_matrix().into_inner();
        for (moments, count) in [
            ([1.0, 2.0, 2.5], 6),
            ([1.0, 1.0, 1.0], 6),
            ([1.0, 2.0, 3.0], 4),
            ([0.0, 2.0, 2.0], 2),
            ([0.0, 0.0, 0.0], 1),
        ] {
            let inertia = turned * Matrix3::from_diagonal(&Vector3::from(moments)) * turned.transpose();
            let body = Body::from_inertia(1.75, inertia, None, false).expect("a body");
            assert_eq!(body.points.len(), count, "{moments:?}");
            assert!((inertia_of(&body.points) - inertia).amax() < 4e-15, "{moments:?}");
            let center: Vector3<f64> = body.points.iter().map(|p| p.position * p.mass).sum();
            assert!(center.amax() < 1e-15);
            assert!((body.points.iter().map(|p| p.mass).sum::<f64>() - 1.75).abs() < 1e-15);
            // Each of the ten third moments: points in pairs cancel to the rounding of their places.
            for (i, j, k) in (0..27).map(|n| (n / 9, n / 3 % 3, n % 3)).filter(|(i, j, k)| i <= j && j <= k) {
                let third = |p: &MassPoint| p.mass * p.position[i] * p.position[j] * p.position[k];
                let moment: f64 = body.points.iter().map(third).sum();
                assert!(moment.abs() < 1e-15, "{moments:?}: {i}{j}{k} {moment:e}");
            }
        }
    }

    #[test]
    fn a_pivot_moves_the_inertia_by_the_parallel_axis_theorem() {
        let pivot = Vector3::new(0.5, -1.0, 2.0);
        let given = [point(1.0, 1.0, 0.0, 0.0), point(2.0, 0.0, 1.0, 0.5), point(1.5, -1.0, 0.25, 1.0)];
        let (body, center) = Body::from_points(&given, Some(pivot)).expect("a body");
        let (free, _) = Body::from_points(&given, None).expect("a body");
        let moved = free.inertia + second_moment_inertia(&(center - pivot)) * free.mass;
        assert!((body.inertia - moved).amax() < 1e-14);
        assert!((body.center - (center - pivot)).amax() < 1e-15);
    }

    #[test]
    fn a_thin_body_has_its_thin_axis_first_or_last_and_the_same_inertia() {
        for moments in [[26.0, 1.0, 26.5], [1.0, 26.0, 26.5], [26.0, 26.5, 1.0], [2.0, 1.0, 2.5]] {
            let inertia = Matrix3::from_diagonal(&Vector3::from(moments));
            let body = Body::from_inertia(1.0, inertia, None, false).expect("a body");
            assert!(4.0 * body.moments.y > body.moments.x.min(body.moments.z), "{moments:?}");
            let axes = body.principal.to_rotation_matrix().into_inner();
            assert_eq!(axes * Matrix3::from_diagonal(&body.moments) * axes.transpose(), inertia);
        }
    }

    #[test]
    fn rods_plates_and_points_are_told_apart() {
        let rod = [point(1.0, -0.5, -1.0, 1.0), point(1.0, 0.25, 0.5, -0.5), point(2.0, 0.125, 0.25, -0.25)];
        let (body, _) = Body::from_points(&rod, None).expect("a rod");
        assert!(matches!(body.shape, Shape::Rod { .. }));
        assert_eq!(body.moments.min(), 0.0);
        let far: Vec<_> = rod
            .iter()
            .map(|p| point(p.mass, p.position.x * 0.1 + 1e6, p.position.y * 0.1, p.position.z * 0.1))
            .collect();
        assert!(matches!(Body::from_points(&far, None).expect("a rod").0.shape, Shape::Rod { .. }));
        let (single, _) = Body::from_points(&[point(3.0, 1.0, 2.0, 3.0)], None).expect("a point");
        assert_eq!(single.shape, Shape::Point);
        let plate = [point(1.0, 1.0, 0.0, 0.0), point(1.0, -1.0, 0.5, 0.0), point(1.0, 0.0, -1.0, 0.0)];
        assert_eq!(Body::from_points(&plate, None).expect("a plate").0.shape, Shape::Extended);
    }

    #[test]
    fn masses_of_1e150_keep_their_inverse() {
        let given = [point(1e150, 1.0, 0.0, 0.0), point(1e150, 0.0, 1.0, 0.0), point(2e150, 0.0, 0.0, 1.0)];
        let (body, _) = Body::from_points(&given, None).expect("a body");
        let identity = body.inertia * body.inverse_inertia();
        assert!((identity - Matrix3::identity()).amax() < 1e-14);
    }

    #[test]
    fn impossible_bodies_are_refused_with_their_numbers() {
        let diagonal = |a, b, c| Matrix3::from_diagonal(&Vector3::new(a, b, c));
        assert!(matches!(
            Body::from_inertia(1.0, diagonal(0.5, 2.0, 3.0), None, false),
            Err(BodyError::Triangle { .. })
        ));
        let textbook = Body::from_inertia(1.0, diagonal(0.5, 2.0, 3.0), None, true).expect("admitted");
        assert!(textbook.points.is_empty());
        assert!(matches!(
            Body::from_inertia(1.0, diagonal(-1.0, 2.0, 3.0), None, true),
            Err(BodyError::NegativeMoment { .. })
        ));
        assert!(matches!(
            Body::from_inertia(f64::NAN, diagonal(1.0, 1.0, 1.0), None, false),
            Err(BodyError::Mass { .. })
        ));
        let lopsided = Matrix3::new(1.0, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
        assert!(matches!(Body::from_inertia(1.0, lopsided, None, false), Err(BodyError::Asymmetric { .. })));
    }
}
