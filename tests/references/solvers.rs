//! dop853 and tsit45 by themselves.

use polhode::internals::ode::{SolverError, dop853, tsit45};
use polhode::internals::reference::stored::Solution;
use polhode::model::{PerQuantity, Quantity, Snapshot};
use polhode::reference::{Reference, ReferenceError};
use polhode::scenes::Scene;

use super::building::{V, from_moments, largest, quarters, worst};
use crate::common::{scene, stored_of};

fn worst_against(scene: &Scene, states: &[Snapshot]) -> PerQuantity<f64> {
    match stored_of(&scene.name).solution(&scene.system).expect("a solution") {
        Solution::Motion(exact) => worst(&scene.system, states, &exact),
        Solution::Spin(spins) => {
            let apart = |(s, (_, spin)): (&Snapshot, &(f64, V))| {
                (s.orientation.inverse_transform_vector(&s.angular_velocity) - spin).norm()
            };
            let mut worst = PerQuantity::all(0.0);
            worst[Quantity::AngularVelocity] = states.iter().zip(&spins).map(apart).fold(0.0, f64::max);
            worst
        }
    }
}

/// Largest error over quantities (SI) and quarter points as measured: dop853, tsit45. The bound is ten times that:
/// another mathematical library rounds elsewhere. Near the separatrix f64 itself is good to 1e-10 only.
const MEASURED: [(&str, f64, f64); 14] = [
    ("free-asymmetric", 2.8e-15, 2.2e-14),
    ("dzhanibekov", 6.7e-11, 6.4e-11),
    ("free-oblate", 1.8e-15, 1.5e-14),
    ("exact-separatrix", 2.2e-14, 1.3e-14),
    ("free-rod", 3.1e-15, 3.0e-15),
    ("lagrange-top-pivot-spring", 5.4e-14, 1.7e-13),
    ("lagrange-top-pivot-spring-undamped", 9.4e-14, 3.4e-13),
    ("lagrange-fast-top", 9.0e-13, 5.3e-12),
    ("kovalevskaya", 1.0e-14, 1.2e-13),
    ("gravity-drag", 8.3e-15, 2.6e-14),
    ("tether-springs", 6.2e-15, 5.8e-14),
    ("sciml-rigidbody-wpd", 7.3e-15, 7.0e-14),
    ("gravity-gradient", 8.4e-14, 3.6e-13),
    ("time-dependent-field", 1.1e-14, 4.5e-14),
];

#[test]
fn both_solvers_meet_the_stored_solutions() {
    for (name, order_8, order_5) in MEASURED {
        let scene = &scene(name);
        let times = quarters(scene.duration);
        let a = dop853::solve(&scene.system, &times, dop853::TOLERANCE).expect("dop853");
        let b = tsit45::solve(&scene.system, &times, tsit45::TOLERANCE).expect("tsit45");
        let errors = [&a, &b].map(|run| largest(&worst_against(scene, &run.states)));
        assert!(errors[0] < 10.0 * order_8, "{name}: dop853 {:e}", errors[0]);
        assert!(errors[1] < 10.0 * order_5, "{name}: tsit45 {:e}", errors[1]);
        assert!(b.evaluations < 40_000, "{name}: {} evaluations", b.evaluations);
    }
}

#[test]
fn impossible_runs_are_refused_with_their_numbers() {
    let asymmetric = || from_moments(1.0, [1.0, 2.0, 2.5], false, [1.0, 1.0, 1.0], vec![]);
    let grid = Reference::of(&asymmetric(), 8.0, 6, None);
    assert!(matches!(grid, Err(ReferenceError::Grid { samples: 6, .. })));
    assert!(matches!(Reference::of(&asymmetric(), f64::NAN, 8, None), Err(ReferenceError::Grid { .. })));
    let backwards = dop853::solve(&asymmetric(), &[1.0, 0.5], 1e-15);
    assert!(matches!(backwards, Err(SolverError::Times { index: 1, .. })));
    let wild = from_moments(1.0, [1.0, 2.0, 2.5], false, [1e200, 1e200, 1e200], vec![]);
    assert!(matches!(Reference::of(&wild, 1.0, 4, None), Err(ReferenceError::Both { .. })));
    let endless = from_moments(1.0, [1.0, 2.0, 2.5], false, [1e9, 1e9, 1e9], vec![]);
    let endless = dop853::solve(&endless, &[1e6], 1e-15);
    assert!(matches!(endless, Err(SolverError::NoConvergence { .. })), "{endless:?}");
}
