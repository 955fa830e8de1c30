//! The heavy asymmetric top in plain arrays: I = (2, 2.5, 1.25), Σ M X = (¼, 0, 1), g = (−¾, 0, −1).

pub type V = [f64; 3];
pub type M = [V; 3];
/// R and L.
pub type State = (M, V);
/// Ω and τ.
pub type Rates = (V, V);

pub fn start() -> State {
    ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.5, 0.25, 3.0])
}

pub fn rates((r, l): &State) -> Rates {
    let moments = [2.0, 2.5, 1.25];
    let (mut spin, mut center) = ([0.0; 3], [0.0; 3]);
    for i in 0..3 {
        for j in 0..3 {
            let momentum: f64 = (0..3).map(|k| r[k][j] * l[k]).sum();
            spin[i] += r[i][j] * momentum / moments[j];
            center[i] += r[i][j] * [0.25, 0.0, 1.0][j];
        }
    }
    (spin, cross(center, [-0.75, 0.0, -1.0]))
}

pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn mix(parts: &[(f64, Rates)]) -> Rates {
    let mut sum = ([0.0; 3], [0.0; 3]);
    for (weight, (spin, torque)) in parts {
        for i in 0..3 {
            sum.0[i] += weight * spin[i];
            sum.1[i] += weight * torque[i];
        }
    }
    sum
}

/// Rodrigues' formula on every column of R.
pub fn advance(state: &State, s: f64, rates: &Rates) -> State {
    let v = rates.0.map(|x| x * s);
    let angle = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if angle == 0.0 {
        return moved(state, s, rates, 0.0, 0.0, v);
    }
    let (sine, versine) = (angle.sin() / angle, 2.0 * ((angle / 2.0).sin() / angle).powi(2));
    moved(state, s, rates, sine, versine, v)
}

/// (E − V/2)⁻¹ (E + V/2) = E + (V + V²/2)/(1 + |v|²/4).
pub fn advance_by_cayley(state: &State, s: f64, rates: &Rates) -> State {
    let v = rates.0.map(|x| x * s);
    let scale = 1.0 / (1.0 + (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 4.0);
    moved(state, s, rates, scale, scale / 2.0, v)
}

/// R + a v × R + b v × (v × R), L + s τ.
fn moved((r, l): &State, s: f64, rates: &Rates, a: f64, b: f64, v: V) -> State {
    let mut matrix = *r;
    for j in 0..3 {
        let column = [r[0][j], r[1][j], r[2][j]];
        let once = cross(v, column);
        let twice = cross(v, once);
        for i in 0..3 {
            matrix[i][j] += a * once[i] + b * twice[i];
        }
    }
    (matrix, [0, 1, 2].map(|i| l[i] + s * rates.1[i]))
}
