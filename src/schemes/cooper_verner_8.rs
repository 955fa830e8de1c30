//! Cooper and Verner's Runge–Kutta method of order 8, in eleven stages, in body axes.
//!
//! With y = (q, l, X_cm, U_cm), l = Rᵀ L in principal axes, and f as `body_form` has it:
//!
//! (1)  kᵢ = f(t + cᵢ h, y₀ + h Σ aᵢⱼ kⱼ)
//! (2)  y₁ = y₀ + h Σ bᵢ kᵢ, then q₁ over its length
//! (3)  aᵢⱼ, bᵢ and cᵢ = Σ aᵢⱼ are numbers (m + n √21)/d; b are the weights of Lobatto's quadrature in five nodes
//!
//! Source: cooper1972. Order 8; neither L nor the energy of a free body is constant. The 200 conditions of rooted trees up to order 8
//! are tested.

use super::body_form::{From, sum};
use super::families::{FLIGHT, claims};
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Turning};

/// Stages.
const STAGES: usize = 11;

/// Cooper and Verner's eleven stages.
#[derive(Clone, Copy, Debug)]
pub struct CooperVerner8;

/// aᵢⱼ and bᵢ (3).
#[inline(always)]
fn tableau<T: Real>() -> ([[T; STAGES]; STAGES], [T; STAGES]) {
    let root = T::of(21.0).sqrt();
    let n = |whole: f64, roots: f64, over: f64| (root * roots + whole) / over;
    let o = T::of(0.0);
    let a = [
        [o; STAGES],
        [n(1.0, 0.0, 2.0), o, o, o, o, o, o, o, o, o, o],
        [n(1.0, 0.0, 4.0), n(1.0, 0.0, 4.0), o, o, o, o, o, o, o, o, o],
        [n(1.0, 0.0, 7.0), n(-7.0, -3.0, 98.0), n(21.0, 5.0, 49.0), o, o, o, o, o, o, o, o],
        [n(11.0, 1.0, 84.0), o, n(18.0, 4.0, 63.0), n(21.0, -1.0, 252.0), o, o, o, o, o, o, o],
        [
            n(5.0, 1.0, 48.0),
            o,
            n(9.0, 1.0, 36.0),
            n(-231.0, 14.0, 360.0),
            n(63.0, -7.0, 80.0),
            o,
            o,
            o,
            o,
            o,
            o,
        ],
        [
            n(10.0, -1.0, 42.0),
            o,
            n(-432.0, 92.0, 315.0),
            n(633.0, -145.0, 90.0),
            n(-504.0, 115.0, 70.0),
            n(63.0, -13.0, 35.0),
            o,
            o,
            o,
            o,
            o,
        ],
        [n(1.0, 0.0, 14.0), o, o, o, n(14.0, -3.0, 126.0), n(13.0, -3.0, 63.0), n(1.0, 0.0, 9.0), o, o, o, o],
        [
            n(1.0, 0.0, 32.0),
            o,
            o,
            o,
            n(91.0, -21.0, 576.0),
            n(11.0, 0.0, 72.0),
            n(-385.0, -75.0, 1152.0),
            n(63.0, 13.0, 128.0),
            o,
            o,
            o,
        ],
        [
            n(1.0, 0.0, 14.0),
            o,
            o,
            o,
            n(1.0, 0.0, 9.0),
            n(-733.0, -147.0, 2205.0),
            n(515.0, 111.0, 504.0),
            n(-51.0, -11.0, 56.0),
            n(132.0, 28.0, 245.0),
            o,
            o,
        ],
        [
            o,
            o,
            o,
            o,
            n(-42.0, 7.0, 18.0),
            n(-18.0, 28.0, 45.0),
            n(-273.0, -53.0, 72.0),
            n(301.0, 53.0, 72.0),
            n(28.0, -28.0, 45.0),
            n(49.0, -7.0, 18.0),
            o,
        ],
    ];
    let (end, side, middle) = (n(1.0, 0.0, 20.0), n(49.0, 0.0, 180.0), n(16.0, 0.0, 45.0));
    (a, [end, o, o, o, o, o, o, side, middle, side, end])
}

impl TurningScheme for CooperVerner8 {
    fn card(&self) -> Card {
        Card {
            name: "cooper-verner-8",
            title: "Cooper and Verner's eleven stages of order 8 in body axes",
            family: "classical",
            source: "cooper1972",
            claims: claims![FLIGHT; Order(8), Exact(AngularVelocity, SteadySpin), Rigid, Evaluations(11)],
        }
    }
    const STATES: usize = 1;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;
    const KEEPS_MOMENTUM: bool = false;

    #[inline(always)]
    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [stage] = work.buffers();
        let (a, b) = tableau::<M::Real>();
        let c = |row: usize| a[row].iter().copied().sum::<M::Real>();
        let start = From::new(model, from);
        let mut at = |row: usize, mean| start.stage(t + h * c(row), h, &mean, stage); // (1)
        let k1 = start.slope(t)?;
        let k2 = at(1, sum((a[1][0], &k1), []))?;
        let k3 = at(2, sum((a[2][0], &k1), [(a[2][1], &k2)]))?;
        let k4 = at(3, sum((a[3][0], &k1), [(a[3][1], &k2), (a[3][2], &k3)]))?;
        let k5 = at(4, sum((a[4][0], &k1), [(a[4][2], &k3), (a[4][3], &k4)]))?;
        let k6 = at(5, sum((a[5][0], &k1), [(a[5][2], &k3), (a[5][3], &k4), (a[5][4], &k5)]))?;
        let on_three = [(a[6][2], &k3), (a[6][3], &k4), (a[6][4], &k5), (a[6][5], &k6)];
        let k7 = at(6, sum((a[6][0], &k1), on_three))?;
        let k8 = at(7, sum((a[7][0], &k1), [(a[7][4], &k5), (a[7][5], &k6), (a[7][6], &k7)]))?;
        let on_five = |row: usize| [(a[row][4], &k5), (a[row][5], &k6), (a[row][6], &k7), (a[row][7], &k8)];
        let k9 = at(8, sum((a[8][0], &k1), on_five(8)))?;
        let k10 = at(9, sum((a[9][0], &k1), on_five(9).into_iter().chain([(a[9][8], &k9)])))?;
        let last = [(a[10][8], &k9), (a[10][9], &k10)];
        let k11 = at(10, sum((a[10][0], &k1), on_five(10).into_iter().chain(last)))?;
        let mean = sum((b[0], &k1), [(b[7], &k8), (b[8], &k9), (b[9], &k10), (b[10], &k11)]);
        start.go(h, &mean, to); // (2)
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::trees::Tree;
    use super::*;
    use crate::arithmetic::DoubleDouble;

    #[test]
    fn every_rooted_tree_up_to_order_8_has_its_weight() {
        // Up to eight products and sums of eleven terms; the size of what cancels is in the measure.
        let (a, b) = tableau::<f64>();
        assert!(Tree::worst(8, &a, &b, 1.0) < 1e-15, "{:e}", Tree::worst(8, &a, &b, 1.0));
        assert!(Tree::worst(9, &a, &b, 1.0) > 1e-6, "not of order 9");
        let (a, b) = tableau::<DoubleDouble>();
        assert!(Tree::worst(8, &a, &b, 1.0) < 1e-30, "{:e}", Tree::worst(8, &a, &b, 1.0));
    }
}
