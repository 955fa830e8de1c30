//! Rotations in space, and the one place where their conventions are stated.
//!
//! - A [`Rotation`] is a unit quaternion (w, x, y, z) under Hamilton's product. An orientation takes body axes
//!   to world axes: x_world = R x_body.
//! - A rotation vector v turns about v/|v| through the angle |v| [rad], counter-clockwise seen from its tip.
//! - R(Ω, s) of PESKIN.md is `turn(Ω s)`: exact for every angle, the identity for Ω = 0.
//!
//! |v| is never taken as a bare √(Σ²) where that could overflow: numbers near 1e±160 occur in rescaled scenes.

pub mod elliptic;
pub mod formulas;
pub mod free_rotor;

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::arithmetic::{Real, series};

/// A proper rotation of space.
pub type Rotation<T = f64> = UnitQuaternion<T>;

/// Length of a vector, without overflow or underflow of the squares.
#[inline]
pub fn length<T: Real>(v: &Vector3<T>) -> T {
    let plain = v.norm_squared();
    if plain > T::PLAIN_SQUARES[0] && plain < T::PLAIN_SQUARES[1] {
        return plain.sqrt();
    }
    scaled_length(v)
}

/// The length where squares overflow or lose digits.
#[cold]
fn scaled_length<T: Real>(v: &Vector3<T>) -> T {
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
#[inline(always)]
pub fn turn<T: Real>(v: &Vector3<T>) -> Rotation<T> {
    let half = v * T::of(0.5);
    let x = length(&half);
    if x == 0.0 {
        return identity();
    }
    let (sine, cosine) = x.sin_cos();
    Rotation::new_unchecked(Quaternion::from_parts(cosine, half * (sine / x)))
}

/// Turns by three angles [rad] one after the other, each about a coordinate axis 0, 1 or 2: of the body, which turns along, or of the
/// world.
///
/// About axes of the body R = R₁ R₂ R₃, about those of the world R = R₃ R₂ R₁.
pub(crate) fn euler(angles: [f64; 3], axes: [usize; 3], of_body: bool) -> Rotation {
    let [first, second, third] = [0, 1, 2].map(|i| turn(&along(axes[i], angles[i])));
    if of_body { first * second * third } else { third * second * first }
}

/// cos x and sin x / x, x = |half|.
#[inline(always)]
fn coefficients<T: Real>(half: [T; 3]) -> (T, T) {
    let square = formulas::dot(half, half);
    if square <= series::LARGEST_SQUARE {
        T::turn_coefficients(square)
    } else {
        let x = length(&half.into());
        let (sine, cosine) = x.sin_cos();
        (cosine, sine / x)
    }
}

/// sin x and cos x: by the series of [`series`] up to half a radian.
#[inline(always)]
pub fn sine_and_cosine<T: Real>(x: T) -> (T, T) {
    let square = x * x;
    if square <= series::LARGEST_SQUARE {
        let (cosine, sine) = T::turn_coefficients(square);
        return (x * sine, cosine);
    }
    x.sin_cos()
}

/// R(Ω, s) · from, the length of `from` put right before.
#[inline(always)]
pub fn turned<T: Real>(from: &Rotation<T>, spin: &Vector3<T>, s: T) -> Rotation<T> {
    let half = s * 0.5;
    let half = [spin.x * half, spin.y * half, spin.z * half];
    let [w, x, y, z] = formulas::turned(coefficients(half), half, [from.w, from.i, from.j, from.k]);
    Rotation::new_unchecked(Quaternion::new(w, x, y, z))
}

/// dq/dt = ½ Ω q, Ω in world axes as the quaternion (0, Ω).
#[inline(always)]
pub fn rate_of<T: Real>(spin: &Vector3<T>, q: &Quaternion<T>) -> Quaternion<T> {
    let half = [spin.x * 0.5, spin.y * 0.5, spin.z * 0.5];
    let [w, x, y, z] = formulas::pure_times(half, [q.w, q.i, q.j, q.k]);
    Quaternion::new(w, x, y, z)
}

/// No rotation.
#[inline(always)]
pub fn identity<T: Real>() -> Rotation<T> {
    Rotation::new_unchecked(Quaternion::new(T::one(), T::zero(), T::zero(), T::zero()))
}

/// The zero vector. nalgebra's is made by an iterator that is compiled apart, like the loops of its products.
#[inline(always)]
pub fn zero<T: Real>() -> Vector3<T> {
    Vector3::new(T::zero(), T::zero(), T::zero())
}

/// A vector of this length along an axis.
#[inline(always)]
pub fn along<T: Real>(axis: usize, length: T) -> Vector3<T> {
    let mut vector = zero();
    vector[axis] = length;
    vector
}

/// q/|q|.
#[inline(always)]
pub fn normalized<T: Real>(q: Quaternion<T>) -> Rotation<T> {
    let length = q.norm();
    Rotation::new_unchecked(Quaternion::new(q.w / length, q.i / length, q.j / length, q.k / length))
}

/// R⁻¹ v.
#[inline(always)]
pub fn turned_back<T: Real>(rotation: &Rotation<T>, v: &Vector3<T>) -> Vector3<T> {
    let axis = Vector3::new(-rotation.i, -rotation.j, -rotation.k);
    let across = axis.cross(v) * T::of(2.0);
    across * rotation.w + axis.cross(&across) + v
}

/// A x. nalgebra's product is a call of loops that are compiled apart from the code around it.
#[inline(always)]
pub fn applied<T: Real>(a: &Matrix3<T>, x: &Vector3<T>) -> Vector3<T> {
    Vector3::new(
        a.m11 * x.x + a.m12 * x.y + a.m13 * x.z,
        a.m21 * x.x + a.m22 * x.y + a.m23 * x.z,
        a.m31 * x.x + a.m32 * x.y + a.m33 * x.z,
    )
}

/// The matrix of a rotation.
#[inline(always)]
pub fn axes<T: Real>(rotation: &Rotation<T>) -> Matrix3<T> {
    let [x, y, z] = formulas::axes([rotation.w, rotation.i, rotation.j, rotation.k]);
    Matrix3::new(x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2])
}

/// Rows of R(Ω, s) − E without cancellation: x + (R − E) x keeps lengths far better over many small turns than R x.
///
/// With v = Ω s/2, x = |v|, c = cos x, S = sin x / x and K the matrix of v ×, R − E = 2 c S K + 2 S² K². What rounding
/// makes of c² + S² x² = 1 stretches what is turned by that times the square of the angle.
#[inline]
pub fn change_of_turn<T: Real>(spin: &Vector3<T>, s: T) -> [[T; 3]; 3] {
    let half_time = s * 0.5;
    let [x, y, z] = [spin.x * half_time, spin.y * half_time, spin.z * half_time];
    let (cosine, sine) = coefficients([x, y, z]);
    let (a, b) = (cosine * 2.0 * sine, sine * 2.0 * sine);
    let (bx, by, bz) = (b * x, b * y, b * z);
    let (ax, ay, az) = (a * x, a * y, a * z);
    [
        [-(by * y + bz * z), bx * y - az, bx * z + ay],
        [bx * y + az, -(bx * x + bz * z), by * z - ax],
        [bx * z - ay, by * z + ax, -(bx * x + by * y)],
    ]
}

/// The rotation vector of `rotation` [rad], with an angle in [0, π]: the logarithm.
#[inline]
pub fn vector_of<T: Real>(rotation: &Rotation<T>) -> Vector3<T> {
    let sign = if rotation.w < 0.0 { -T::one() } else { T::one() };
    let imaginary = rotation.imag() * sign;
    let sine = length(&imaginary);
    if sine == 0.0 {
        return imaginary;
    }
    imaginary * (sine.atan2(rotation.w * sign) * 2.0 / sine)
}

/// The angle of the relative rotation between two orientations [rad], in [0, π], good down to 1e-16:
/// 2 atan2(|imaginary|, |real|) rather than 2 acos|real|, which reads 0 below 1e-8.
pub fn angle_between<T: Real>(a: &Rotation<T>, b: &Rotation<T>) -> T {
    let relative = a.inverse() * b;
    length(&relative.imag().into_owned()).atan2(relative.w.abs()) * 2.0
}

/// The angle between two directions [rad], in [0, π]; 0 where either vector is zero.
pub fn angle_between_directions<T: Real>(a: &Vector3<T>, b: &Vector3<T>) -> T {
    let (length_a, length_b) = (length(a), length(b));
    if length_a == 0.0 || length_b == 0.0 {
        return T::zero();
    }
    let (a, b) = (a / length_a, b / length_b);
    length(&a.cross(&b)).atan2(a.dot(&b))
}

/// A quaternion that rounding has moved off the unit sphere, put back: one Newton step for 1/|q|, exact to
/// the order of the square of the deviation.
#[inline]
pub fn renormalized<T: Real>(rotation: Rotation<T>) -> Rotation<T> {
    let q = rotation.into_inner();
    Rotation::new_unchecked(q * (T::of(1.5) - q.norm_squared() * 0.5))
}

/// q/|q|, by a series in |q|² − 1 where that is below 1e-6: neither a root nor a division.
#[inline(always)]
pub fn unit<T: Real>(q: &Quaternion<T>) -> Rotation<T> {
    let excess = (q.w * q.w + q.i * q.i) + (q.j * q.j + q.k * q.k) - 1.0;
    if excess.abs() <= T::LARGEST_EXCESS {
        Rotation::new_unchecked(q * formulas::inverse_root(excess))
    } else {
        normalized(*q)
    }
}

/// The rotation nearest to a matrix that is one but for rounding, by its largest quaternion component.
pub fn from_matrix<T: Real>(matrix: &Matrix3<T>) -> Rotation<T> {
    let rotation = nalgebra::Rotation3::from_matrix_unchecked(*matrix);
    Rotation::new_normalize(Rotation::from_rotation_matrix(&rotation).into_inner())
}

/// The rotation R that best carries `from` onto `to`: the minimum of Σ |to_k − R from_k|² weighted by `weights`
/// (Wahba's problem, solved by the singular value decomposition of Σ w to fromᵀ and a step of Newton's method). A plane or a line of points
/// is enough; about a line the angle is the one of least turning.
pub fn best_fit<T: Real>(from: &[Vector3<T>], to: &[Vector3<T>], weights: &[T]) -> Rotation<T> {
    let mut moment: Matrix3<T> = Matrix3::zeros();
    for ((a, b), w) in from.iter().zip(to).zip(weights) {
        moment += b * a.transpose() * *w;
    }
    let scale = moment.amax();
    if scale == 0.0 || !scale.is_finite() {
        return Rotation::identity();
    }
    let moment = moment / scale;
    let decomposition = moment.svd(true, true);
    let (Some(u), Some(v_transposed)) = (decomposition.u, decomposition.v_t) else {
        return Rotation::identity();
    };
    let singular = decomposition.singular_values;
    // The largest entry of what was decomposed is 1, and so is the largest singular value at least.
    if singular[1] < 1e-12 * (T::UNIT / f64::EPSILON).max(1.0) {
        let direction_from = v_transposed.row(0).transpose();
        let direction_to = u.column(0).into_owned();
        return between(&direction_from, &direction_to);
    }
    let handedness = (u * v_transposed).determinant().signum();
    let mirror = Matrix3::from_diagonal(&Vector3::new(T::one(), T::one(), handedness));
    nearer(from_matrix(&(u * mirror * v_transposed)), &moment)
}

/// A step of Newton's method towards the rotation R that makes Rᵀ M symmetric, from one that nearly does. With N = Rᵀ M it turns by θ about body
/// axes, (tr N E − N) θ = the axis of N − Nᵀ. The decomposition squares M: of points close to a line it loses the turn about that line.
fn nearer<T: Real>(rotation: Rotation<T>, moment: &Matrix3<T>) -> Rotation<T> {
    let seen = axes(&rotation).transpose() * moment;
    let off = Vector3::new(seen.m32 - seen.m23, seen.m13 - seen.m31, seen.m21 - seen.m12);
    let curvature = Matrix3::from_diagonal_element(seen.trace()) - (seen + seen.transpose()) / T::of(2.0);
    curvature.try_inverse().map_or(rotation, |inverse| renormalized(rotation * turn(&(inverse * off))))
}

/// The least rotation that carries one unit vector onto another: (1 + a·b, a × b), scaled to length one. An angle from the inverse
/// cosine of a·b would be off by 1e-8 where they nearly agree. Where they point apart, a is carried to −b, and on by a half turn
/// about the axis that is across both.
fn between<T: Real>(a: &Vector3<T>, b: &Vector3<T>) -> Rotation<T> {
    if a.dot(b) >= 0.0 {
        return Rotation::new_normalize(Quaternion::from_parts(a.dot(b) + 1.0, a.cross(b)));
    }
    let across = a.cross(b);
    let across = across - b * b.dot(&across);
    let half = if across.norm() > 1e-8 {
        Rotation::new_normalize(Quaternion::from_parts(T::zero(), across))
    } else {
        half_turn(b)
    };
    half * between(a, &-b)
}

/// A half turn that reverses `direction`, about any axis across it.
fn half_turn<T: Real>(direction: &Vector3<T>) -> Rotation<T> {
    let smallest = direction.iamin();
    let across = direction.cross(&Vector3::ith(smallest, T::one())).normalize();
    turn(&(across * T::pi()))
}

#[cfg(test)]
mod tests;
