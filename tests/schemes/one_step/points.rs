//! Rules on the mass points, as motions of the matrix A that takes the body's points to where they are: A need not be a
//! rotation. With S = Σ M X Xᵀ = ½ tr I E − I, the inertia of the moved points is tr(A S Aᵀ) E − A S Aᵀ.

use super::body::{M, V, center, gravity, inertia, start};
use super::rotations::exponential;
use super::{Expected, STEP};

fn spin(a: &M, l: &V) -> V {
    let second = M::identity() * (inertia().trace() / 2.0) - inertia();
    let moved = a * second * a.transpose();
    (M::identity() * moved.trace() - moved).try_inverse().expect("regular") * l
}

fn torque(a: &M) -> V {
    (a * center()).cross(&gravity())
}

fn after(steps: u64, step: impl Fn(&M, &V) -> (M, V)) -> Expected {
    let (a, l) = (0..steps).fold(start(), |(a, l), _| step(&a, &l));
    Expected::Points { momentum: l, spin: spin(&a, &l) }
}

pub fn euler_linear(steps: u64) -> Expected {
    after(steps, |a, l| (a + spin(a, l).cross_matrix() * a * STEP, l + torque(a) * STEP))
}

pub fn rk2_linear(steps: u64) -> Expected {
    after(steps, |a, l| {
        let half = a + spin(a, l).cross_matrix() * a * (STEP / 2.0);
        let l_half = l + torque(a) * (STEP / 2.0);
        (a + spin(&half, &l_half).cross_matrix() * half * STEP, l + torque(&half) * STEP)
    })
}

/// Gravity does not depend on the place, so that the new lever arm is all that counts.
pub fn course_code(steps: u64) -> Expected {
    after(steps, |a, l| {
        let moved = exponential(&(spin(a, l) * STEP)) * a;
        (moved, l + torque(&moved) * STEP)
    })
}
