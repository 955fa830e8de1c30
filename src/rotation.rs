//! Rotations in space, and the one place where their conventions are stated.
//!
//! - A [`Rotation`] is a unit quaternion (w, x, y, z) under Hamilton's product. An orientation takes body axes
//!   to world axes: x_world = R x_body.
//! - A rotation vector v turns about v/|v| through the angle |v| [rad], counter-clockwise seen from its tip.
//! - R(Ω, s) of PESKIN.md is `turn(Ω s)`: exact for every angle, the identity for Ω = 0.
//!
//! |v| is never taken as a bare √(Σ²) where that could overflow: numbers near 1e±160 occur in rescaled scenes.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

/// A proper rotation of space.
pub type Rotation = UnitQuaternion<f64>;

/// Length of a vector, without overflow or underflow of the squares.
pub fn length(v: &Vector3<f64>) -> f64 {
    let plain = v.norm_squared();
    if plain > 1e-280 && plain < 1e280 {
        return plain.sqrt();
    }
    let largest = v.amax();
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * (v / largest).norm()
}

/// The rotation whose rotation vector is `v` [rad]: the exponential map.
///
/// With x = |v|/2 the quaternion is (cos x, (sin x / x) v/2). Where x² underflows, sin x / x is 1 to the last
/// bit anyway; where it would overflow, the length is taken scaled.
pub fn turn(v: &Vector3<f64>) -> Rotation {
    let half = v * 0.5;
    let x = length(&half);
    if x == 0.0 {
        return Rotation::identity();
    }
    let (sine, cosine) = x.sin_cos();
    Rotation::new_unchecked(Quaternion::from_parts(cosine, half * (sine / x)))
}

/// R − E for the rotation whose rotation vector is `v` [rad], without cancellation: x + (R − E) x keeps lengths
/// far better over many small turns than R x.
///
/// With the quaternion (w, u) of the turn and K the matrix of u ×, R − E = s (w K + K²). With s = 2/|q|² this is
/// exact for a quaternion of any length, so that the rounding of its norm does not stretch what is turned.
pub fn change_of_turn(v: &Vector3<f64>) -> Matrix3<f64> {
    let q = turn(v).into_inner();
    let cross = q.imag().cross_matrix();
    (cross * q.w + cross * cross) * (2.0 / q.norm_squared())
}

/// The rotation vector of `rotation` [rad], with an angle in [0, π]: the logarithm.
pub fn vector_of(rotation: &Rotation) -> Vector3<f64> {
    let sign = if rotation.w < 0.0 { -1.0 } else { 1.0 };
    let imaginary = rotation.imag() * sign;
    let sine = length(&imaginary);
    if sine == 0.0 {
        return imaginary * 2.0;
    }
    imaginary * (2.0 * sine.atan2(rotation.w * sign) / sine)
}

/// The angle of the relative rotation between two orientations [rad], in [0, π], good down to 1e-16:
/// 2 atan2(|imaginary|, |real|) rather than 2 acos|real|, which reads 0 below 1e-8.
pub fn angle_between(a: &Rotation, b: &Rotation) -> f64 {
    let relative = a.inverse() * b;
    2.0 * length(&relative.imag().into_owned()).atan2(relative.w.abs())
}

/// The angle between two directions [rad], in [0, π]; 0 where either vector is zero.
pub fn angle_between_directions(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    let (length_a, length_b) = (length(a), length(b));
    if length_a == 0.0 || length_b == 0.0 {
        return 0.0;
    }
    let (a, b) = (a / length_a, b / length_b);
    length(&a.cross(&b)).atan2(a.dot(&b))
}

/// A quaternion that rounding has moved off the unit sphere, put back: one Newton step for 1/|q|, exact to
/// the order of the square of the deviation.
pub fn renormalized(rotation: Rotation) -> Rotation {
    let q = rotation.into_inner();
    Rotation::new_unchecked(q * (1.5 - 0.5 * q.norm_squared()))
}

/// The rotation nearest to a matrix that is one but for rounding, by its largest quaternion component.
pub fn from_matrix(matrix: &Matrix3<f64>) -> Rotation {
    let rotation = nalgebra::Rotation3::from_matrix_unchecked(*matrix);
    Rotation::new_normalize(Rotation::from_rotation_matrix(&rotation).into_inner())
}

/// The rotation R that best carries `from` onto `to`: the minimum of Σ |to_k − R from_k|² weighted by `weights`
/// (Wahba's problem, solved by the singular value decomposition of Σ w to fromᵀ). A plane or a line of points
/// is enough; about a line the angle is the one of least turning.
pub fn best_fit(from: &[Vector3<f64>], to: &[Vector3<f64>], weights: &[f64]) -> Rotation {
    let mut moment = Matrix3::zeros();
    for ((a, b), w) in from.iter().zip(to).zip(weights) {
        moment += b * a.transpose() * *w;
    }
    let scale = moment.amax();
    if scale == 0.0 || !scale.is_finite() {
        return Rotation::identity();
    }
    let decomposition = (moment / scale).svd(true, true);
    let (Some(u), Some(v_transposed)) = (decomposition.u, decomposition.v_t) else {
        return Rotation::identity();
    };
    let singular = decomposition.singular_values;
    if singular[1] < 1e-12 * singular[0] {
        let direction_from = v_transposed.row(0).transpose();
        let direction_to = u.column(0).into_owned();
        return between(&direction_from, &direction_to);
    }
    let handedness = (u * v_transposed).determinant().signum();
    let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, handedness));
    from_matrix(&(u * mirror * v_transposed))
}

/// The least rotation that carries one unit vector onto another: (1 + a·b, a × b), scaled to length one. An angle from the inverse
/// cosine of a·b would be off by 1e-8 where they nearly agree. Where they point apart, a is carried to −b, and on by a half turn
/// about the axis that is across both.
fn between(a: &Vector3<f64>, b: &Vector3<f64>) -> Rotation {
    if a.dot(b) >= 0.0 {
        return Rotation::new_normalize(Quaternion::from_parts(1.0 + a.dot(b), a.cross(b)));
    }
    let across = a.cross(b);
    let across = across - b * b.dot(&across);
    let half = if across.norm() > 1e-8 {
        Rotation::new_normalize(Quaternion::from_parts(0.0, across))
    } else {
        half_turn(b)
    };
    half * between(a, &-b)
}

/// A half turn that reverses `direction`, about any axis across it.
fn half_turn(direction: &Vector3<f64>) -> Rotation {
    let smallest = direction.iamin();
    let across = direction.cross(&Vector3::ith(smallest, 1.0)).normalize();
    turn(&(across * std::f64::consts::PI))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_turn_is_a_rotation_for_tiny_huge_and_no_angles() {
        for exponent in [-320, -200, -160, -30, -8, -3, 0, 3, 8, 15, 160, 300] {
            let v = Vector3::new(1.0, -2.0, 0.5) * 10f64.powi(exponent);
            let rotation = turn(&v);
            assert!((rotation.norm() - 1.0).abs() < 4.0 * f64::EPSILON, "exponent {exponent}");
        }
        assert_eq!(turn(&Vector3::zeros()), Rotation::identity());
    }

    #[test]
    fn a_quaternion_off_the_sphere_is_put_back_to_the_square_of_its_deviation() {
        let unit = turn(&Vector3::new(0.3, -0.8, 1.7)).into_inner();
        for deviation in [1e-3, -1e-3] {
            let back = renormalized(Rotation::new_unchecked(unit * (1.0 + deviation)));
            // (1 + d)(1.5 − (1 + d)²/2) = 1 − 1.5 d² − d³/2.
            assert!((back.into_inner().norm() - 1.0).abs() < 1.6 * deviation * deviation);
        }
    }

    #[test]
    fn an_angle_between_directions_does_not_depend_on_their_lengths() {
        let (a, b) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0));
        for length in [1e-200, 1e-3, 1.0, 1e200] {
            let angle = angle_between_directions(&(a * length), &(b * length));
            assert!((angle - PI / 4.0).abs() < 4.0 * f64::EPSILON, "{length:e}: {angle}");
        }
    }

    #[test]
    fn a_line_of_points_is_fitted_to_rounding_at_every_angle() {
        let line = [Vector3::new(0.3, -0.2, 0.5), Vector3::new(-0.6, 0.4, -1.0)];
        for angle in [0.0, 1e-12, 1e-8, 1e-3, 1.0, 3.0, PI] {
            let turned = line.map(|x| {
                turn(&(Vector3::new(0.0, 0.928_476_690_885_259, 0.371_390_676_354_103_7) * angle)) * x
            });
            let fitted = best_fit(&line, &turned, &[1.0, 2.0]);
            let apart = angle_between_directions(&(fitted * line[0]), &turned[0]);
            // The bound that stored solutions are read to.
            let bound = 16.0 * f64::EPSILON;
            assert!(apart < bound, "angle {angle}: {apart:e}");
        }
    }

    #[test]
    fn a_turn_agrees_with_rodrigues_formula() {
        for angle in [1e-9, 1e-3, 0.5, 2.0, PI, 4.0, 100.0] {
            let axis = Vector3::new(2.0, -1.0, 2.0) / 3.0;
            let p = Vector3::new(0.3, 0.7, -1.1);
            let rodrigues = p * f64::cos(angle)
                + axis.cross(&p) * f64::sin(angle)
                + axis * axis.dot(&p) * (1.0 - f64::cos(angle));
            // Two evaluations of trigonometric functions of an angle that is itself rounded: a few u (1 + angle).
            let error = (turn(&(axis * angle)) * p - rodrigues).norm();
            assert!(error < 4.0 * f64::EPSILON * (1.0 + angle), "angle {angle}: {error:e}");
        }
    }

    #[test]
    fn the_logarithm_undoes_the_exponential_below_a_half_turn() {
        for angle in [1e-300, 1e-12, 1e-4, 1.0, 3.0, 3.1] {
            let v = Vector3::new(-1.0, 2.0, 2.0) / 3.0 * angle;
            assert!((vector_of(&turn(&v)) - v).norm() <= 4e-15 * angle, "angle {angle}");
        }
    }

    #[test]
    fn an_angle_of_1e_minus_12_is_seen() {
        let a = turn(&Vector3::new(0.4, 0.1, -0.9));
        let b = a * turn(&Vector3::new(0.0, 1e-12, 0.0));
        assert!((angle_between(&a, &b) - 1e-12).abs() < 3e-16);
    }

    #[test]
    fn the_best_fit_finds_the_rotation_of_solids_plates_and_rods() {
        let rotation = turn(&Vector3::new(0.7, -1.9, 0.4));
        let solid = vec![
            Vector3::new(1.0, 0.0, 0.2),
            Vector3::new(-0.3, 1.0, 0.0),
            Vector3::new(0.0, -0.4, 1.0),
            Vector3::new(-0.7, -0.6, -1.2),
        ];
        let plate: Vec<_> = solid.iter().map(|p| Vector3::new(p.x, p.y, 0.0)).collect();
        for points in [solid, plate] {
            let turned: Vec<_> = points.iter().map(|p| rotation * p).collect();
            assert!(angle_between(&best_fit(&points, &turned, &[1.0, 2.0, 0.5, 1.5]), &rotation) < 1e-14);
        }
        let rod = [Vector3::new(1.0, 2.0, -1.0), Vector3::new(-0.5, -1.0, 0.5)];
        let turned = rod.map(|p| rotation * p);
        let found = best_fit(&rod, &turned, &[1.0, 2.0]);
        assert!((found * rod[0] - turned[0]).norm() < 1e-14);
    }
}
