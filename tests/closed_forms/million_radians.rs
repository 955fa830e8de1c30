//! Closed forms after a million radians, against powers of what a period does.

use nalgebra::Matrix3;
use polhode::model::System;
use polhode::model::body::Shape;
use polhode::reference::closed;
use polhode::reference::precise::{self, AFFORDABLE, DoubleDouble, Moment};
use polhode::rotation::{self, Rotation};

use super::known::{fastest, scene};

pub type Matrix = [[DoubleDouble; 3]; 3];

pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |i: usize, j: usize| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

pub fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// R of a moment, row by row.
pub fn rows(moment: &Moment) -> Matrix {
    transposed(&moment.axes)
}

/// E + factor [v]×.
pub fn small_turn(v: &[DoubleDouble; 3], factor: DoubleDouble) -> Matrix {
    let [x, y, z] = v.map(|x| x * factor);
    let one = DoubleDouble::ONE;
    [[one, -z, y], [z, one, -x], [-y, x, one]]
}

pub fn squared(mut matrix: Matrix, times: u32) -> Matrix {
    for _ in 0..times {
        matrix = product(&matrix, &matrix);
    }
    matrix
}

pub fn to_rotation(matrix: &Matrix) -> Rotation {
    rotation::from_matrix(&Matrix3::from_fn(|i, j| matrix[i][j].to_f64()))
}

/// L in body axes.
fn body_momentum(moment: &Moment) -> [DoubleDouble; 3] {
    let l = moment.angular_momentum;
    moment.axes.map(|column| column[0] * l[0] + column[1] * l[1] + column[2] * l[2])
}

fn apart(a: &[DoubleDouble; 3], b: &[DoubleDouble; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (*a - *b).high.powi(2)).sum::<f64>().sqrt()
}

/// A time [s] at which L is back in the body to rounding, and how much later than the true period that is.
fn period(system: &System, longest: f64) -> (f64, DoubleDouble) {
    let times: Vec<f64> = (0..4096).map(|j| f64::from(j) * longest / 4096.0).collect();
    let motion = precise::solve(system, &times, 100.0 * AFFORDABLE).expect("a motion");
    let start = body_momentum(&motion.moments[0]);
    let distances: Vec<f64> = motion.moments.iter().map(|m| apart(&body_momentum(m), &start)).collect();
    let farthest = distances.iter().copied().fold(0.0, f64::max);
    let left = distances.iter().position(|d| *d > 0.5 * farthest).expect("leaves");
    let near = |j: &usize| distances[*j] < distances[j - 1] && distances[*j] <= distances[j + 1];
    for back in (left + 1..4095).filter(near) {
        let mut time = times[back];
        for _ in 0..8 {
            time -= late(system, &start, time).0.high;
        }
        let (late, apart) = late(system, &start, time);
        // A thin polhode comes close to itself without coming back.
        if apart < 1e-12 * farthest {
            return (time, late);
        }
    }
    panic!("{longest} s are too short");
}

/// (l − l₀)·l'/|l'|² with l' = l × ω in body axes, and |l − l₀|.
fn late(system: &System, start: &[DoubleDouble; 3], time: f64) -> (DoubleDouble, f64) {
    let moment = &precise::solve(system, &[time], 100.0 * AFFORDABLE).expect("a motion").moments[0];
    let l = body_momentum(moment);
    let spin = moment.angular_velocity;
    let w = moment.axes.map(|column| column[0] * spin[0] + column[1] * spin[1] + column[2] * spin[2]);
    let rate = [l[1] * w[2] - l[2] * w[1], l[2] * w[0] - l[0] * w[2], l[0] * w[1] - l[1] * w[0]];
    let (mut along, mut square) = (DoubleDouble::ZERO, DoubleDouble::ZERO);
    for i in 0..3 {
        along += (l[i] - start[i]) * rate[i];
        square += rate[i] * rate[i];
    }
    (along / square, apart(&l, start))
}

/// A free body comes back after a period but for a turn P about L, so that R(N T) = Pᴺ R(0): squared seventeen times in
/// double-double arithmetic, which loses 1e-26 on the way. Near a separatrix the period is long and N smaller.
#[test]
fn closed_forms_hold_for_a_million_radians() {
    for (name, longest, squarings) in [
        ("free-asymmetric", 100.0, 15),
        ("euler-top-unit", 20.0, 17),
        ("free-oblate", 20.0, 17),
        ("dzhanibekov", 60.0, 14),
        ("mujoco-middle-axis", 20.0, 15),
        ("thin-body", 0.2, 16),
    ] {
        let system = scene(name).system;
        let (time, late) = period(&system, longest);
        let motion = precise::solve(&system, &[0.0, time], 100.0 * AFFORDABLE).expect("a motion");
        let [first, last] = &motion.moments[..] else { panic!("two moments") };
        let back = product(&small_turn(&last.angular_velocity, -late), &rows(last));
        let turn = product(&back, &transposed(&rows(first)));
        let count = f64::from(1u32 << squarings);
        let rest = small_turn(&first.angular_velocity, late * count.into());
        let exact = to_rotation(&product(&squared(turn, squarings), &product(&rest, &rows(first))));
        let stated = holds(name, &system, count * time, &exact);
        assert!(stated < 1e3, "{name}: {stated}");
    }
}

#[test]
fn steady_rotations_hold_for_a_million_radians() {
    for name in ["free-rod", "fast-sphere"] {
        let system = scene(name).system;
        let motion = precise::solve(&system, &[0.0, 1.0], AFFORDABLE).expect("a motion");
        let turn = product(&rows(&motion.moments[1]), &transposed(&rows(&motion.moments[0])));
        let exact = product(&squared(turn, 20), &rows(&motion.moments[0]));
        let stated = holds(name, &system, f64::from(1u32 << 20), &to_rotation(&exact));
        assert!(stated < 1e3, "{name}: {stated}");
    }
}

/// On the separatrix a body is on its middle axis to 1e-15 after 64 s, and turns steadily from then on.
#[test]
fn the_separatrix_holds_for_a_million_radians() {
    let system = scene("exact-separatrix").system;
    let settled = precise::solve(&system, &[64.0], 100.0 * AFFORDABLE).expect("a motion").moments[0].clone();
    // The same L on a sphere of the middle moment: the same turn in the world.
    let mut steady = system.clone();
    steady.body.inertia = Matrix3::from_diagonal_element(2.5);
    steady.body.points.clear();
    let motion = precise::solve(&steady, &[0.0, 1.0], AFFORDABLE).expect("a motion");
    let turn = product(&rows(&motion.moments[1]), &transposed(&rows(&motion.moments[0])));
    let exact = product(&squared(turn, 20), &rows(&settled));
    let stated = holds("exact-separatrix", &system, 64.0 + f64::from(1u32 << 20), &to_rotation(&exact));
    // A body a rounding off turns over again and again: of a system known to f64 nothing can be said.
    assert!(stated > 1e6, "{stated}");
}

/// Asserts the error; returns the uncertainty that is stated over it, or over half a unit a radian.
fn holds(name: &str, system: &System, time: f64, exact: &Rotation) -> f64 {
    let found = closed::solve(system, &[time]).expect("a closed form");
    let state = &found.states[0];
    let turned = 1.0 + time * rotation::length(&state.angular_velocity);
    assert!(turned > 2e5, "{name}: {turned:e}");
    let error = match system.body.shape {
        Shape::Rod { direction } => {
            rotation::angle_between_directions(&(state.orientation * direction), &(exact * direction))
        }
        _ => rotation::angle_between(&state.orientation, exact),
    };
    let units = error / f64::EPSILON / (1.0 + time * fastest(system));
    let stated = found.uncertainty[0][2];
    // Measured: 0.2 to 2.1 units a radian of the fastest rate; 53 a radian of |Ω| for the thin body.
    assert!(error <= stated + 4.0 * f64::EPSILON, "{name}: {error:e} > {stated:e}");
    assert!(units < 6.0, "{name}: {units}");
    stated / error.max(0.5 * f64::EPSILON * turned)
}
