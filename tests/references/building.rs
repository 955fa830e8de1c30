//! Systems made by hand, and what tests ask of states.

use nalgebra::{Matrix3, Vector3};
use polhode::internals::rotation::Rotation;
use polhode::model::body::{Body, MassPoint};
use polhode::model::forces::{Gravity, Law};
use polhode::model::{PerQuantity, Snapshot, Spin, System, difference};

pub type V = Vector3<f64>;

pub const NONE: [f64; 3] = [0.0; 3];

pub const CLUSTER: &[[f64; 4]] = &[
    [1.0, 1.25, -0.5, 0.25],
    [2.0, -0.5, 0.875, 0.25],
    [3.0, 0.125, -0.625, -0.75],
    [1.5, -0.75, 0.25, 1.0],
    [2.0, 0.25, 0.125, 0.0],
];

pub fn body(points: &[[f64; 4]], pivot: Option<V>) -> Body {
    let given: Vec<_> =
        points.iter().map(|[m, x, y, z]| MassPoint { mass: *m, position: V::new(*x, *y, *z) }).collect();
    Body::from_points(&given, pivot).expect("a body").0
}

pub fn free(points: &[[f64; 4]], start: [[f64; 3]; 3], laws: Vec<Law>) -> System {
    let [x, u, l] = start.map(V::from);
    System::new(body(points, None), laws, x, Rotation::identity(), u, Spin::Momentum(l)).expect("a system")
}

pub fn gravity(g: [f64; 3]) -> Law {
    Law::Gravity(Gravity { acceleration: V::from(g) })
}

pub fn from_moments(
    mass: f64,
    moments: [f64; 3],
    unphysical: bool,
    spin: [f64; 3],
    laws: Vec<Law>,
) -> System {
    let inertia = Matrix3::from_diagonal(&V::from(moments));
    let body = Body::from_inertia(mass, inertia, None, unphysical).expect("a body");
    let spin = Spin::Velocity(V::from(spin));
    System::new(body, laws, V::zeros(), Rotation::identity(), V::zeros(), spin).expect("a system")
}

pub fn quarters(duration: f64) -> [f64; 4] {
    [0.25, 0.5, 0.75, 1.0].map(|part| part * duration)
}

pub fn worst(system: &System, a: &[Snapshot], b: &[Snapshot]) -> PerQuantity<f64> {
    let mut worst = PerQuantity::all(0.0);
    for (a, b) in a.iter().zip(b) {
        worst = worst.max(difference(&system.body, a, b));
    }
    worst
}

pub fn largest(spread: &PerQuantity<f64>) -> f64 {
    spread.values().copied().fold(0.0, f64::max)
}
