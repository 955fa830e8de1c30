//! Strang splitting into a symmetric top and a rotation: kick, half rotation, symmetric top, half rotation, kick.
//!
//! With B the middle moment, C the extreme one that 1/B is farther from and A the other, axes c and a:
//!
//! (1)  ½ Σ l²/I = [½ |l|²/B + ½ (1/C − 1/B) l_c²] + ½ (1/A − 1/B) l_a²
//! (2)  the bracket, a symmetric top, turns by   exp(h l/B) exp(h (1/C − 1/B) l_c e_c)
//! (3)  the rest turns by                        exp(s (1/A − 1/B) l_a e_a),  s = h/2 before and after
//!
//! Source: touma1994, fasso2003. Order 2, symplectic, symmetric; exact for spheres and symmetric bodies.

use nalgebra::Vector3;

use super::Card;
use super::families::{KICKS, claims};
use super::splitting::splitting;
use crate::arithmetic::Real;
use crate::model::{Broken, Rotational};
use crate::rotation::{self, Rotation};

splitting! {
    /// Symmetric top, rotation and kick.
    StrangSymmetric, free_turn, Card {
        name: "strang-symmetric",
        title: "Strang splitting into a symmetric top and a rotation",
        family: "geometric",
        source: "touma1994; fasso2003",
        claims: claims![KICKS;
            Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin), Energy(Bounded), FlipTimes,
        ],
    }
}

/// (3) (2) (3).
fn free_turn<T: Real>(
    rotational: &Rotational<T>,
    momentum: &Vector3<T>,
    h: T,
) -> Result<Rotation<T>, Broken> {
    let inverse = &rotational.inverse_moments;
    let mut order = [0, 1, 2];
    order.sort_by(|i, j| inverse[*i].to_f64().total_cmp(&inverse[*j].to_f64()));
    let [low, b, high] = order;
    let high_is_farther = inverse[high] - inverse[b] > inverse[b] - inverse[low];
    let (a, c) = if high_is_farther { (low, high) } else { (high, low) };
    let rest = |l: &Vector3<T>| rotation::along(a, h * 0.5 * (inverse[a] - inverse[b]) * l[a]); // (3)

    let before = rotation::turn(&rest(momentum));
    let l = rotation::turned_back(&before, momentum);
    let own = rotation::along(c, h * (inverse[c] - inverse[b]) * l[c]);
    let top = rotation::turn(&(l * (h * inverse[b]))) * rotation::turn(&own); // (2)
    let l = rotation::turned_back(&top, &l);
    Ok(before * top * rotation::turn(&rest(&l)))
}
