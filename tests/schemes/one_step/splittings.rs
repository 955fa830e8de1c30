//! Half kick, a turn of the free body, half kick.

use super::body::{M, State, V, moments, torque};
use super::rotations::{exponential, vector_of};

/// `turn` gives Q for l = Rᵀ L and h, so that R becomes R Q.
pub fn kicked((r, l): &State, h: f64, turn: impl Fn(&V, f64) -> M) -> State {
    let l = l + torque(r) * (h / 2.0);
    let r = r * turn(&(r.transpose() * l), h);
    (r, l + torque(&r) * (h / 2.0))
}

/// F D − D Fᵀ = h l̂ with F = exp v: v is corrected by I⁻¹ times what is left.
fn veselov_with(moments: &V, l: &V, h: f64) -> M {
    let d = M::from_diagonal(&(V::repeat(moments.sum() / 2.0) - moments));
    let mut v = V::zeros();
    for _ in 0..80 {
        let f = exponential(&v);
        // The vector of a skew part is half that of F D − D Fᵀ.
        let left = vector_of(&(f * d)) * 2.0 - l * h;
        v -= left.component_div(moments);
    }
    exponential(&v)
}

pub fn veselov(l: &V, h: f64) -> M {
    veselov_with(&moments(), l, h)
}

/// The equation with moments 1/Ĩ = σ/I + 2 δ, where σ and δ solve σ ∂K̃/∂H = 1 and δ ∂K̃/∂H + ∂K̃/∂C = 0 for the modified
/// Hamiltonian K = C [η + Σ x^m k_m(η)], x = h² C, of which `terms` are kept and the equations solved `terms` times. The k_m are
/// found here from what they must be, at every node η_j: a steady spin about axis j turns by arcsin(h |l|/I_j), so that
/// 2 (m + 1) k_m(η_j) = (2 η_j)^(2m+1) a_m with the arcsine's series arcsin y = Σ a_m y^(2m+1), and the slope that the frequency
/// of small oscillations fixes.
pub fn preprocessed(l: &V, h: f64, terms: usize) -> M {
    let own = moments().map(|moment| 0.5 / moment);
    let square = l.norm_squared();
    let eta = own.component_mul(&l.component_mul(l)).sum() / square;
    let x = h * h * square;
    let (mut sigma, mut delta) = (1.0, 0.0);
    for _ in 0..terms {
        let nodes = own.map(|node| sigma * node + delta);
        let here = sigma * eta + delta;
        let (mut by_energy, mut by_square) = (1.0, 0.0);
        for m in 1..=terms {
            let k = Interpolated::new(&nodes, m);
            let power = x.powi(m as i32);
            by_energy += power * k.slope(here);
            by_square += power * ((m as f64 + 1.0) * k.value(here) - here * k.slope(here));
        }
        (sigma, delta) = (1.0 / by_energy, -by_square / by_energy);
    }
    veselov_with(&own.map(|node| 0.5 / (sigma * node + delta)), l, h)
}

/// k_m by Hermite interpolation: value and slope at three nodes.
struct Interpolated {
    /// Nodes, each twice, and divided differences.
    nodes: [f64; 6],
    differences: [f64; 6],
}

impl Interpolated {
    fn new(eta: &V, m: usize) -> Interpolated {
        let nodes = [eta[0], eta[0], eta[1], eta[1], eta[2], eta[2]];
        let values = [0, 1, 2].map(|j| steady(eta[j], m));
        let slopes = [0, 1, 2].map(|j| oscillating(eta, j, m));
        let mut table: Vec<f64> = (0..6).map(|i| values[i / 2]).collect();
        let mut differences = [table[0]; 6];
        for order in 1..6 {
            table = (0..6 - order)
                .map(|i| {
                    let apart = nodes[i + order] - nodes[i];
                    if apart == 0.0 { slopes[i / 2] } else { (table[i + 1] - table[i]) / apart }
                })
                .collect();
            differences[order] = table[0];
        }
        Interpolated { nodes, differences }
    }

    fn value(&self, x: f64) -> f64 {
        self.both(x).0
    }

    fn slope(&self, x: f64) -> f64 {
        self.both(x).1
    }

    fn both(&self, x: f64) -> (f64, f64) {
        (0..6).rev().fold((0.0, 0.0), |(value, slope), i| {
            (value * (x - self.nodes[i]) + self.differences[i], slope * (x - self.nodes[i]) + value)
        })
    }
}

/// Coefficients of the series of arcsin y in y, y³, …
const ARCSINE: [f64; 5] = [1.0, 1.0 / 6.0, 3.0 / 40.0, 15.0 / 336.0, 105.0 / 3456.0];

/// ∂K/∂|l| h = arcsin(h |l|/I), K = Σ h^2m |l|^(2m+2) k_m, 1/I = 2 η.
fn steady(eta: f64, m: usize) -> f64 {
    ARCSINE[m] * (2.0 * eta).powi(2 * m as i32 + 1) / (2.0 * m as f64 + 2.0)
}

/// k_m'(η_j) from the frequency of small oscillations about axis j. The flow of K about the axis is that of the body, ω = |l|
/// √((1/I_k − 1/I_j)(1/I_l − 1/I_j)), sped up by ∂K/∂H = Σ x^m k_m'; the equation's own obeys tan(h ν/2) = κ tan(h ω_s/2) with
/// the spin's own turn sin(h ω_s) = h |l|/I_j, as its linearisation says. Compared power by power in h |l|.
fn oscillating(eta: &V, j: usize, m: usize) -> f64 {
    let [i_j, i_k, i_l] = [0, 1, 2].map(|k| 0.5 / eta[(j + k) % 3]);
    let kappa_squared = (i_j - i_k) * (i_j - i_l) / (i_k * i_l);
    // ν/ω_s as a series in y = h |l|/I_j: with t = tan(h ω_s/2), 2 atan(κ t) / 2 atan(t) in even powers of κ.
    let t = half_tangent();
    let atan = |k2: f64| -> [f64; 5] {
        // atan(κ t)/κ = t − κ² t³/3 + …
        let mut sum = [0.0; 5];
        let mut power = t;
        for n in 0..5 {
            let factor = (-k2).powi(n) / f64::from(2 * n + 1);
            for (place, value) in sum.iter_mut().zip(power) {
                *place += factor * value;
            }
            power = times_odd_twice(&power, &t);
        }
        sum
    };
    // h ν = 2 κ (s₀ y + s₁ y³ + …), and h |l| √(…) = κ y: the ratio is ∂K/∂H.
    let series = atan(kappa_squared);
    2.0 * series[m] / i_j.powi(2 * m as i32)
}

/// tan(½ arcsin y) = y/(1 + √(1 − y²)) = ½ y + ⅛ y³ + 1/16 y⁵ + 5/128 y⁷ + 7/256 y⁹ …
fn half_tangent() -> [f64; 5] {
    [0.5, 0.125, 0.0625, 5.0 / 128.0, 7.0 / 256.0]
}

/// p t², for odd series given by their coefficients of y, y³, …
fn times_odd_twice(p: &[f64; 5], t: &[f64; 5]) -> [f64; 5] {
    let mut product = [0.0; 5];
    for a in 0..5 {
        for b in 0..5 {
            for c in 0..5 {
                // y^(2a+1) y^(2b+1) y^(2c+1) = y^(2(a+b+c+1)+1)
                if a + b + c + 1 < 5 {
                    product[a + b + c + 1] += p[a] * t[b] * t[c];
                }
            }
        }
    }
    product
}

/// Turns about axes: the first two half, the third whole, and back.
pub fn turns(l: &V, h: f64, [a, b, c]: [usize; 3]) -> M {
    let mut product = M::identity();
    let mut l = *l;
    for (axis, part) in [(a, 0.5), (b, 0.5), (c, 1.0), (b, 0.5), (a, 0.5)] {
        let mut about = V::zeros();
        about[axis] = part * h * l[axis] / moments()[axis];
        let turn = exponential(&about);
        product *= turn;
        l = turn.transpose() * l;
    }
    product
}

pub fn strang(s: &State, h: f64) -> State {
    kicked(s, h, |l, h| turns(l, h, [0, 1, 2]))
}

/// The moments 2.5 > 2 > 1.25: 1/1.25 is farther from 1/2 than 1/2.5 is, so that the top's axis is z and the rest turns about y.
pub fn symmetric_top(l: &V, h: f64) -> M {
    let rest = |l: &V| exponential(&V::new(0.0, h / 2.0 * (1.0 / 2.5 - 1.0 / 2.0) * l.y, 0.0));
    let before = rest(l);
    let inside = before.transpose() * l;
    // The top with moments (2, 2, 1.25), whose Ω turns about l, by a fine solution of its equations.
    let top = flow(&V::new(2.0, 2.0, 1.25), &inside, h);
    before * top * rest(&(top.transpose() * inside))
}

pub fn free_flow(l: &V, h: f64) -> M {
    flow(&moments(), l, h)
}

/// Q' = Q ω̂, ω = I⁻¹ Qᵀ l, by the classical Runge–Kutta method in many parts; the truncation is 1e-16.
fn flow(moments: &V, l: &V, h: f64) -> M {
    const PARTS: usize = 256;
    let s = h / PARTS as f64;
    let f = |q: &M| q * (q.transpose() * l).component_div(moments).cross_matrix();
    (0..PARTS).fold(M::identity(), |q, _| {
        let k1 = f(&q);
        let k2 = f(&(q + k1 * (s / 2.0)));
        let k3 = f(&(q + k2 * (s / 2.0)));
        let k4 = f(&(q + k3 * s));
        q + (k1 + (k2 + k3) * 2.0 + k4) * (s / 6.0)
    })
}

/// A composition of a step, the coefficients from the first to the middle one.
pub fn composed(s: &State, h: f64, half: &[f64], step: impl Fn(&State, f64) -> State) -> State {
    let back = half.iter().rev().skip(1);
    half.iter().chain(back).fold(*s, |s, part| step(&s, part * h))
}

pub fn strang_symmetric(s: &State, h: f64) -> State {
    kicked(s, h, symmetric_top)
}

pub fn exact_rotor(s: &State, h: f64) -> State {
    kicked(s, h, free_flow)
}

pub fn triple_jump() -> [f64; 2] {
    let first = 1.0 / (2.0 - 2f64.powf(1.0 / 3.0));
    [first, 1.0 - 2.0 * first]
}

pub fn fractal() -> [f64; 3] {
    let first = 1.0 / (4.0 - 4f64.powf(1.0 / 3.0));
    [first, first, 1.0 - 4.0 * first]
}

/// Hairer, Lubich and Wanner, Geometric Numerical Integration, second edition, (V.3.11).
#[allow(clippy::excessive_precision, reason = "twenty digits, as they are printed")]
pub const KAHAN_LI_6: [f64; 5] = [
    0.39216144400731413928,
    0.33259913678935943860,
    -0.70624617255763935981,
    0.08221359629355080023,
    0.79854399093482996340,
];

/// The same, (V.3.13).
#[allow(clippy::excessive_precision, reason = "twenty digits, as they are printed")]
pub const KAHAN_LI_8: [f64; 9] = [
    0.13020248308889008088,
    0.56116298177510838456,
    -0.38947496264484728641,
    0.15884190655515560090,
    -0.39590389413323757734,
    0.18453964097831570709,
    0.25837438768632204729,
    0.29501172360931029887,
    -0.60550853383003451170,
];
