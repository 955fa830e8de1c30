//! What theory says of stability, where it says anything.
//!
//! A body on a spring of stiffness k and a damper c at the point r, to first order about rest, is a set of oscillators
//!
//! ```text
//! (1)  x'' = −ω² x − 2 ζ ω x',   ω = √(k μ),  ζ = c μ / (2 ω),  μ an eigenvalue of E/M − [r] I⁻¹ [r]
//! ```
//!
//! with eigenvalues λ = ω (−ζ ± √(ζ² − 1)). A Runge–Kutta scheme multiplies such a mode by R(hλ) a step, R its stability
//! polynomial: the exact rotation of the note is a translation to first order, so Peskin's scheme is the midpoint rule there,
//! R(z) = 1 + z + z²/2, and |R| ≤ 1 reads, with a = ω h,
//!
//! ```text
//! (2)  a³/4 − ζ a² + 2 ζ² a − 2 ζ ≤ 0   (ζ < 1),   |λ_max| h ≤ 2   (ζ ≥ 1)
//! ```
//!
//! Source of (2): |1 + z + z²/2|² = 1 + 2 Re z + 2 (Re z)² + |z|² Re z + |z|⁴/4 with Re z = −ζa, |z| = a.
//!
//! How any scheme acts on such a mode is derived from its own steps ([`Mode`]).

use nalgebra::{Matrix3, Matrix6, SymmetricEigen, Vector3};

use crate::model::System;
use crate::model::forces::{Attachment, Law};

pub use super::amplification::{Amplification, Mode, limit_of_a_body};

/// The left side of (2), or |λ_max| h − 2 from ζ = 1 on: at most zero where Peskin's scheme is stable.
pub fn peskin_condition(a: f64, zeta: f64) -> f64 {
    if zeta < 1.0 {
        a.powi(3) / 4.0 - zeta * a * a + 2.0 * zeta * zeta * a - 2.0 * zeta
    } else {
        a * (zeta + (zeta * zeta - 1.0).sqrt()) - 2.0
    }
}

/// The eigenvalues μ of E/M − [r] I⁻¹ [r] at a point `arm` from the centre of mass, rising [1/kg]; world axes at t = 0.
pub fn mobilities(system: &System, arm: &Vector3<f64>) -> Vector3<f64> {
    let cross = arm.cross_matrix();
    let matrix = Matrix3::identity() / system.body.mass - cross * inverse_inertia(system) * cross;
    let mut values: Vec<f64> = SymmetricEigen::new(matrix).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    Vector3::from_vec(values)
}

/// ω of the fastest linear mode of the springs and of a ground that is touched [rad/s], at the start; `None` without any. Springs
/// count with their full stiffness in every direction, which is exact for a rest length of zero.
pub fn natural_frequency(system: &System) -> Option<f64> {
    let stiffness: Matrix6<f64> = system.forces.laws().iter().filter_map(|law| stiffness(system, law)).sum();
    let inverse_mass = if system.body.pivoted { 0.0 } else { 1.0 / system.body.mass };
    let mut root = Matrix6::<f64>::zeros();
    root.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() * inverse_mass.sqrt()));
    root.fixed_view_mut::<3, 3>(3, 3).copy_from(&symmetric_root(&inverse_inertia(system)));
    let largest = SymmetricEigen::new(root * stiffness * root).eigenvalues.max();
    (largest > 0.0).then(|| largest.sqrt())
}

/// The stiffness that a law gives the body's displacement and turn.
fn stiffness(system: &System, law: &Law) -> Option<Matrix6<f64>> {
    let axes = system.start.orientation.to_rotation_matrix().into_inner();
    match law {
        Law::Spring(spring) => {
            let arm = match &spring.attachment {
                Attachment::Point(index) => system.body.points[*index].position,
                Attachment::At(position) => *position,
            };
            Some(point_stiffness(&(axes * arm), &Matrix3::identity()) * spring.stiffness)
        }
        Law::Ground(ground) => {
            let normal = ground.normal.normalize();
            // One point touches at a time: that which the ground throws off the fastest.
            let arms = system.body.points.iter().map(|point| axes * point.position);
            let arm =
                arms.max_by(|a, b| mobility(system, a, &normal).total_cmp(&mobility(system, b, &normal)))?;
            Some(point_stiffness(&arm, &(normal * normal.transpose())) * ground.stiffness)
        }
        _ => None,
    }
}

/// The stiffness of a spring of 1 N/m at a point, which moves by dx − [arm] dθ, in the directions that are projected on.
fn point_stiffness(arm: &Vector3<f64>, projector: &Matrix3<f64>) -> Matrix6<f64> {
    let blocks = [Matrix3::identity(), -arm.cross_matrix()];
    let mut whole = Matrix6::<f64>::zeros();
    for (row, left) in blocks.iter().enumerate() {
        for (column, right) in blocks.iter().enumerate() {
            let block = left.transpose() * projector * right;
            whole.fixed_view_mut::<3, 3>(3 * row, 3 * column).copy_from(&block);
        }
    }
    whole
}

/// I⁻¹ [1/(kg m²)], world axes at t = 0.
fn inverse_inertia(system: &System) -> Matrix3<f64> {
    let axes = system.start.orientation.to_rotation_matrix().into_inner();
    axes * system.body.inverse_inertia() * axes.transpose()
}

/// Velocity that a unit impulse along a normal gives the point at `arm` [1/kg], world axes.
fn mobility(system: &System, arm: &Vector3<f64>, normal: &Vector3<f64>) -> f64 {
    let across = arm.cross(normal);
    1.0 / system.body.mass + across.dot(&(inverse_inertia(system) * across))
}

fn symmetric_root(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    let eigen = SymmetricEigen::new(*matrix);
    let roots = eigen.eigenvalues.map(|value| value.max(0.0).sqrt());
    eigen.eigenvectors * Matrix3::from_diagonal(&roots) * eigen.eigenvectors.transpose()
}

/// dE/dt of Peskin's scheme on a free body with moments (A, A, C) [W]: h³ β⁴ l⁶ sin²θ cos⁴θ / (8 A) with β = 1/C − 1/A, l = |L|
/// and θ the angle between L and the axis of C. `None` for a body without an axis of symmetry.
pub fn energy_rate(system: &System, step: f64) -> Option<f64> {
    let moments = system.body.moments;
    let close = |i: usize, j: usize| (moments[i] - moments[j]).abs() <= 1e-9 * moments.amax();
    let axis = (0..3).find(|i| close((i + 1) % 3, (i + 2) % 3))?;
    let (across, along) = (moments[(axis + 1) % 3], moments[axis]);
    let momentum = system.start.orientation.inverse_transform_vector(&system.start.angular_momentum);
    let momentum = system.body.principal.inverse_transform_vector(&momentum);
    let length = momentum.norm();
    let cosine = momentum[axis] / length;
    let beta = 1.0 / along - 1.0 / across;
    let sine2 = 1.0 - cosine * cosine;
    Some(step.powi(3) * beta.powi(4) * length.powi(6) * sine2 * cosine.powi(4) / (8.0 * across))
}

/// Growth rate of a small wobble about the middle axis [1/s]: λ = Ω₂ √((I₂ − I₁)(I₃ − I₂)/(I₁ I₃)), moments rising.
/// Source: Euler's equations, linear about (0, Ω₂, 0).
pub fn middle_axis_growth(moments: [f64; 3], spin: f64) -> f64 {
    let [small, middle, large] = moments;
    spin * ((middle - small) * (large - middle) / (small * large)).sqrt()
}

/// The spin above which an upright top sleeps [rad/s]: Ω² = 4 M g l I₁ / I₃², moments about the pivot.
pub fn sleeping_spin(weight_times_arm: f64, across: f64, along: f64) -> f64 {
    (4.0 * weight_times_arm * across).sqrt() / along
}
