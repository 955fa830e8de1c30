//! NO-SQUISH: the free rotor as a motion of quaternions, one axis at a time, and a kick.
//!
//! With q the attitude, p = 2 q (0, l) its conjugate momentum and P_k q = q e_k, the k-th term of the kinetic energy,
//! (p · P_k q)²/(8 I_k), turns q and p in their planes with P_k q and P_k p:
//!
//! (1)  ζ = p · P_k q / (4 I_k)
//! (2)  q ← cos(ζ s) q + sin(ζ s) P_k q,   p ← cos(ζ s) p + sin(ζ s) P_k p
//! (3)  k = 3, 2, 1, 2, 3 for the times s = h/2, h/2, h, h/2, h/2
//!
//! (2) leaves 2 l = q* p without a part along 1, so that q needs no constraint. Relative to the attitude at the
//! start of the step q = 1 and p = 2 (0, l).
//!
//! Source: miller2002. Order 2, symplectic, symmetric: strang-rotations about the axes in the opposite order.

use nalgebra::{Quaternion, Vector3};

use super::Card;
use super::families::{KICKS, claims};
use super::splitting::splitting;
use crate::arithmetic::Real;
use crate::model::{Broken, Rotational};
use crate::rotation::Rotation;

splitting! {
    /// Quaternion splitting and a kick.
    NoSquish, free_turn, Card {
        name: "no-squish",
        title: "NO-SQUISH quaternion splitting",
        family: "geometric",
        source: "miller2002",
        claims: claims![KICKS; Energy(Bounded), FlipTimes],
    }
}

fn free_turn<T: Real>(
    rotational: &Rotational<T>,
    momentum: &Vector3<T>,
    h: T,
) -> Result<Rotation<T>, Broken> {
    let mut q = Quaternion::identity();
    let mut p = Quaternion::from_imag(momentum * T::of(2.0));
    for (k, s) in [(2, h / 2.0), (1, h / 2.0), (0, h), (1, h / 2.0), (2, h / 2.0)] {
        let unit = Quaternion::from_imag(Vector3::ith(k, T::one()));
        let (permuted_q, permuted_p) = (q * unit, p * unit);
        let zeta = p.dot(&permuted_q) * rotational.inverse_moments[k] / 4.0; // (1)
        let (sine, cosine) = (zeta * s).sin_cos();
        q = q * cosine + permuted_q * sine; // (2)
        p = p * cosine + permuted_p * sine; // (2)
    } // (3)
    Ok(Rotation::new_unchecked(q))
}
