//! A free motion after any time, in double-double arithmetic, from what one period of it does.

use nalgebra::Matrix3;
use polhode::internals::reference::precise::{self, AFFORDABLE, DoubleDouble, Moment, Motion};
use polhode::internals::rotation::{self, Rotation};
use polhode::model::System;

pub type Matrix = [[DoubleDouble; 3]; 3];

/// A free body comes back after a period T but for a turn P about L, so that R(n T + s) = Pⁿ R(s): squared as often as n
/// has digits, which loses 1e-26 on the way.
pub struct Recurrence {
    system: System,
    period: DoubleDouble,
    turn: Matrix,
}

pub fn motion(system: &System, times: &[f64]) -> Motion {
    precise::solve(system, times, 100.0 * AFFORDABLE).expect("a motion")
}

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

/// R a little later than at `moment`, to first order.
fn later(moment: &Moment, time: DoubleDouble) -> Matrix {
    product(&small_turn(&moment.angular_velocity, time), &rows(moment))
}

pub fn power(matrix: &Matrix, mut count: u64) -> Matrix {
    let one = |i: usize, j: usize| if i == j { DoubleDouble::ONE } else { DoubleDouble::ZERO };
    let mut all: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| one(i, j)));
    let mut square = *matrix;
    while count > 0 {
        if count % 2 == 1 {
            all = product(&all, &square);
        }
        square = product(&square, &square);
        count /= 2;
    }
    all
}

pub fn to_rotation(matrix: &Matrix) -> Rotation {
    rotation::from_matrix(&Matrix3::from_fn(|i, j| matrix[i][j].to_f64()))
}

/// The orientation after `count` seconds of a body that turns steadily, from `start`.
pub fn steady(system: &System, count: u64, start: &Moment) -> Rotation {
    let motion = motion(system, &[0.0, 1.0]);
    let turn = product(&rows(&motion.moments[1]), &transposed(&rows(&motion.moments[0])));
    to_rotation(&product(&power(&turn, count), &rows(start)))
}

/// L in body axes.
fn body_momentum(moment: &Moment) -> [DoubleDouble; 3] {
    let l = moment.angular_momentum;
    moment.axes.map(|column| column[0] * l[0] + column[1] * l[1] + column[2] * l[2])
}

fn apart(a: &[DoubleDouble; 3], b: &[DoubleDouble; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (*a - *b).high.powi(2)).sum::<f64>().sqrt()
}

/// (l − l₀)·l'/|l'|² with l' = l × ω in body axes, and |l − l₀|.
fn late(moment: &Moment, start: &[DoubleDouble; 3]) -> (DoubleDouble, f64) {
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

impl Recurrence {
    /// Of a body that comes back within `longest` [s].
    pub fn within(system: &System, longest: f64) -> Recurrence {
        let times: Vec<f64> = (0..4096).map(|j| f64::from(j) * longest / 4096.0).collect();
        let motion = motion(system, &times);
        let start = body_momentum(&motion.moments[0]);
        let distances: Vec<f64> = motion.moments.iter().map(|m| apart(&body_momentum(m), &start)).collect();
        let farthest = distances.iter().copied().fold(0.0, f64::max);
        let left = distances.iter().position(|d| *d > 0.5 * farthest).expect("leaves");
        let near = |j: &usize| distances[*j] < distances[j - 1] && distances[*j] <= distances[j + 1];
        (left + 1..4095)
            .filter(near)
            // A thin polhode comes close to itself without coming back.
            .find_map(|back| Recurrence::near(system, times[back], 8, 1e-12 * farthest))
            .unwrap_or_else(|| panic!("{longest} s are too short"))
    }

    /// Of a body that comes back near `time`, found in `tries`, no farther off than `close`.
    fn near(system: &System, mut time: f64, tries: usize, close: f64) -> Option<Recurrence> {
        for last in (0..tries).rev() {
            let moments = motion(system, &[0.0, time]).moments;
            let (late, apart) = late(&moments[1], &body_momentum(&moments[0]));
            if last == 0 && apart < close {
                let turn = product(&later(&moments[1], -late), &transposed(&rows(&moments[0])));
                return Some(Recurrence {
                    system: system.clone(),
                    period: DoubleDouble::from(time) - late,
                    turn,
                });
            }
            time -= late.high;
        }
        None
    }

    /// The same of a system a little off.
    pub fn moved(&self, system: &System) -> Recurrence {
        let size = rotation::length(&system.start.angular_momentum);
        Recurrence::near(system, self.period.high, 4, 1e-12 * size).expect("comes back as well")
    }

    /// Mean |Ω| [rad/s].
    pub fn spin(&self) -> f64 {
        let times: Vec<f64> = (0..64).map(|j| f64::from(j) * self.period.high / 64.0).collect();
        let spins = motion(&self.system, &times).moments;
        spins.iter().map(|m| rotation::length(&m.snapshot().angular_velocity)).sum::<f64>() / 64.0
    }

    /// The orientation at `time` [s], at least a period.
    pub fn at(&self, time: f64) -> Rotation {
        let count = (time / self.period.high).floor() - 1.0;
        let rest = DoubleDouble::from(time) - self.period * count.into();
        let moment = &motion(&self.system, &[rest.high]).moments[0];
        let rest = later(moment, rest - rest.high.into());
        to_rotation(&product(&power(&self.turn, count as u64), &rest))
    }
}
