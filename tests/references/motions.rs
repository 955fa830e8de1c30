//! Motions with something known: a parabola, an energy.

use polhode::internals::rotation;
use polhode::model::body::Shape;
use polhode::model::forces::{
    Attachment, CentralGravity, Dipole, Forces, GravityGradient, Ground, Law, Lorentz, PerPoint, Spring,
};
use polhode::model::{Snapshot, Spin, System};
use polhode::reference::Reference;
use polhode::scenes::Scene;

use super::building::{CLUSTER, NONE, V, body, free, from_moments, gravity, largest};
use crate::common::scene;

#[test]
fn a_single_point_falls_on_its_parabola() {
    let start = [[1e3, 0.0, 2.0], [3.0, 0.0, 4.0], NONE];
    let system = free(&[[2.0, 0.0, 0.0, 0.0]], start, vec![gravity([0.0, 0.0, -10.0])]);
    let reference = Reference::of(&system, 2.0, 4, None).expect("a reference");
    for state in &reference.states {
        let t = state.time;
        let exact = V::new(1e3 + 3.0 * t, 0.0, 2.0 + 4.0 * t - 5.0 * t * t);
        assert!((state.position - exact).norm() < 1e-12, "{t}");
        assert_eq!(state.angular_velocity, V::zeros());
    }
}

#[test]
fn a_rod_on_a_pivot_swings_as_a_pendulum_of_its_reduced_length() {
    let body = body(&[[1.0, 0.0, 0.0, 0.0], [3.0, 0.0, 0.0, -2.0]], Some(V::zeros()));
    assert!(matches!(body.shape, Shape::Rod { .. }));
    let start = rotation::turn(&V::new(0.5, 0.0, 0.0));
    let position = start * body.center;
    let laws = vec![gravity([0.0, 0.0, -9.75])];
    let at_rest = Spin::Momentum(V::zeros());
    let system = System::new(body, laws, position, start, V::zeros(), at_rest).expect("a system");
    let reference = Reference::of(&system, 10.0, 40, None).expect("a reference");
    assert!(largest(&reference.largest_uncertainty()) < 1e-11, "{:?}", reference.largest_uncertainty());
    // I = 12, M g c = 3 · 9.75 · 2: the energy 6 Ω² − 58.5 cos θ is constant.
    let energy = |s: &Snapshot| 6.0 * s.angular_velocity.norm_squared() + 9.75 * 4.0 * s.position.z;
    let first = energy(&reference.states[0]);
    assert!(reference.states.iter().all(|s| (energy(s) - first).abs() < 1e-11));
    assert!(reference.states.iter().any(|s| s.angular_velocity.norm() > 1.0));
}

#[test]
fn a_dipole_without_mass_points_keeps_its_energy() {
    let law = Law::Dipole(Dipole { moment: V::new(0.25, 0.0, 1.0), field: V::new(0.0, 0.5, 2.0) });
    let system = from_moments(1.0, [0.5, 2.0, 3.0], true, [0.5, -0.25, 1.0], vec![law]);
    assert!(system.body.points.is_empty());
    let reference = Reference::of(&system, 10.0, 20, None).expect("a reference");
    let energy =
        |s: &Snapshot| system.rotational_energy(s) + system.potential_energy(s).expect("a potential");
    let first = energy(&reference.states[0]);
    assert!(reference.states.iter().all(|s| (energy(s) - first).abs() < 1e-12));
    assert!(largest(&reference.largest_uncertainty()) < 1e-11, "{:?}", reference.largest_uncertainty());
}

#[test]
fn a_bounce_with_friction_and_a_stiff_damper_still_have_a_reference() {
    let ground = Ground {
        normal: V::z(),
        height: 0.0,
        stiffness: 2e4,
        damping: 10.0,
        friction: 0.3,
        slip_velocity: 0.01,
    };
    let laws = vec![gravity([0.0, 0.0, -9.75]), Law::Ground(ground)];
    let bounce = free(CLUSTER, [[0.0, 0.0, 2.0], [0.5, 0.0, 0.0], [1.5, -2.0, 2.5]], laws);
    // Measured 1e-10, lost where the points touch, and 3e-13.
    let Scene { mut system, .. } = scene("lagrange-top-pivot-spring");
    let laws = system.forces.laws().iter().cloned().map(|law| match law {
        Law::Spring(spring) => Law::Spring(Spring { damping: 4096.0, ..spring }),
        other => other,
    });
    system.forces = Forces::new(laws.collect(), &system.body);
    for (system, duration, bound) in [(bounce, 1.5, 1e-9), (system, 2.0, 3e-12)] {
        let reference = Reference::of(&system, duration, 64, None).expect("a reference");
        assert!(largest(&reference.largest_uncertainty()) < bound);
    }
}

#[test]
fn every_conservative_law_keeps_the_total_energy() {
    let attachment = Attachment::At(V::new(0.5, 0.25, -1.0));
    let anchor = V::new(1.0, 0.0, 1.0);
    let elastic = Spring { attachment, anchor, stiffness: 8.0, damping: 0.0, rest_length: 1.5 };
    let lorentz = Lorentz {
        charge: PerPoint::Each(vec![2.0, -1.0, 0.5, 1.0, -1.5]),
        electric: V::new(0.5, 0.0, 1.0),
        electric_cosine: V::zeros(),
        electric_sine: V::zeros(),
        frequency: 0.0,
        magnetic: V::new(0.0, 2.0, -1.0),
    };
    let gradient =
        GravityGradient { mu_over_r3: 0.5, direction: V::new(0.6, 0.0, 0.8), normal: V::y(), rate: 0.0 };
    let ground = Ground {
        normal: V::new(0.0, 0.6, 0.8),
        height: -0.5,
        stiffness: 200.0,
        damping: 0.0,
        friction: 0.0,
        slip_velocity: 0.01,
    };
    for law in [
        gravity([0.0, 1.0, -9.75]),
        Law::Spring(elastic),
        Law::CentralGravity(CentralGravity { mu: 8.0, center: V::new(0.0, 4.0, 0.0) }),
        Law::Lorentz(lorentz),
        Law::Dipole(Dipole { moment: V::new(1.0, 0.5, 0.0), field: V::new(0.0, 2.0, 3.0) }),
        Law::GravityGradient(gradient),
        Law::Ground(ground),
    ] {
        let name = law.name();
        let system = free(CLUSTER, [NONE, [0.25, 0.5, -0.5], [1.5, -2.0, 2.5]], vec![law]);
        assert!(system.forces.conservative(), "{name}");
        let reference = Reference::of(&system, 3.0, 12, None).expect("a reference");
        let energy =
            |s: &Snapshot| system.kinetic_energy(s) + system.potential_energy(s).expect("a potential");
        let first = energy(&reference.states[0]);
        let change = reference.states.iter().map(|s| (energy(s) - first).abs()).fold(0.0, f64::max);
        let exchanged = system.kinetic_energy(&reference.states[0]);
        let most = |s: &Snapshot| (system.kinetic_energy(s) - exchanged).abs();
        // Rounding of the energies, up to 300 J; a kink of the ground costs more.
        assert!(change < 1e-11, "{name}: {change:e}");
        assert!(reference.states.iter().map(most).fold(0.0, f64::max) > 0.01, "{name}");
    }
}
