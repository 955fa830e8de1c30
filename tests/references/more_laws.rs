//! Laws with a motion in closed form: a gyrostat with its wheel on the axis, a damped sphere, a circular orbit of the centre of mass.

use nalgebra::Matrix3;
use polhode::internals::rotation;
use polhode::model::forces::{Law, MassCenterGravity, RotationalDamping, TorqueAxes, TorquePulse, Wheels};
use polhode::model::{Snapshot, Spin, System, difference};
use polhode::reference::Reference;
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form, Plan};

use super::building::{CLUSTER, NONE, V, body, free, from_moments, largest};

/// R(t) = Rot(M t/A) Rot(e₃ (Ω₃ − M₃/A) t) from axes along the world's, with M = I Ω + h e₃ and CΩ₃ = M₃ − h.
#[test]
fn a_gyrostat_with_an_axial_wheel_precesses_about_the_whole_angular_momentum() {
    let (a, c, h) = (2.0, 3.0, 1.5);
    let spin = V::new(0.75, -0.5, 1.25);
    let system = from_moments(1.0, [a, a, c], false, spin.into(), vec![wheels([0.0, 0.0, h])]);
    let whole = V::new(a * spin.x, a * spin.y, c * spin.z + h);
    let own = spin.z - whole.z / a;
    let reference = Reference::of(&system, 20.0, 40, None).expect("a reference");
    for state in &reference.states {
        let t = state.time;
        let turned = rotation::turn(&(whole / a * t)) * rotation::turn(&(V::z() * (own * t)));
        // Angles of 50 radians in the exact form: a hundred roundings of 2e-16.
        assert!(rotation::angle_between(&turned, &state.orientation) < 2e-14, "t = {t}");
        let exact = whole / a + turned * V::z() * own;
        assert!((state.angular_velocity - exact).norm() < 1e-13, "t = {t}");
    }
    assert!(largest(&reference.largest_uncertainty()) < 1e-11, "{:?}", reference.largest_uncertainty());
}

#[test]
fn a_gyrostat_keeps_its_whole_angular_momentum_and_its_energy() {
    let inner = V::new(0.5, -1.0, 0.75);
    let system = from_moments(1.0, [1.0, 2.0, 2.5], false, [0.5, 2.0, -0.25], vec![wheels(inner.into())]);
    let reference = Reference::of(&system, 10.0, 40, None).expect("a reference");
    let whole = |s: &Snapshot| s.angular_momentum + s.orientation * inner;
    let (first, energy) = (whole(&reference.states[0]), system.rotational_energy(&reference.states[0]));
    for state in &reference.states {
        assert!((whole(state) - first).norm() < 1e-13);
        assert!((system.rotational_energy(state) - energy).abs() < 1e-13);
    }
    let turned = |s: &Snapshot| (s.angular_momentum - reference.states[0].angular_momentum).norm();
    assert!(reference.states.iter().map(turned).fold(0.0, f64::max) > 1.0);
}

#[test]
fn a_damped_sphere_slows_exponentially() {
    let coefficients = Matrix3::from_diagonal_element(0.25);
    let law = Law::RotationalDamping(RotationalDamping { coefficients });
    let spin = V::new(1.0, -2.0, 0.5);
    let system = from_moments(1.0, [2.0; 3], false, spin.into(), vec![law]);
    let reference = Reference::of(&system, 16.0, 32, None).expect("a reference");
    for state in &reference.states {
        let left = (-0.125 * state.time).exp();
        assert!((state.angular_velocity - spin * left).norm() < 1e-14, "t = {}", state.time);
        let turned = rotation::turn(&(spin * ((1.0 - left) / 0.125)));
        assert!(rotation::angle_between(&turned, &state.orientation) < 1e-13, "t = {}", state.time);
    }
}

#[test]
fn gravity_on_the_centre_of_mass_alone_makes_a_circle_and_no_torque() {
    let law = || Law::MassCenterGravity(MassCenterGravity { mu: 8.0, center: V::zeros() });
    // v² = μ/r.
    let system = free(CLUSTER, [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1.0, -2.0, 0.5]], vec![law()]);
    let reference = Reference::of(&system, 10.0, 40, None).expect("a reference");
    for state in &reference.states {
        let (sine, cosine) = state.time.sin_cos();
        assert!((state.position - V::new(cosine, sine, 0.0) * 2.0).norm() < 1e-13, "t = {}", state.time);
        assert_eq!(state.angular_momentum, reference.states[0].angular_momentum);
    }
    let pivot = body(CLUSTER, Some(V::new(0.5, 0.75, -0.25)));
    let at = pivot.center + V::new(4.0, 0.0, 0.0);
    let still = Spin::Momentum(V::zeros());
    let system = System::new(pivot, vec![law()], at, rotation::Rotation::identity(), V::zeros(), still)
        .expect("a system");
    let reference = Reference::of(&system, 2.0, 8, None).expect("a reference");
    let energy = |s: &Snapshot| system.kinetic_energy(s) + system.potential_energy(s).expect("a potential");
    let first = energy(&reference.states[0]);
    assert!(reference.states.iter().all(|s| (energy(s) - first).abs() < 1e-12));
    assert!(reference.states.iter().any(|s| s.angular_momentum.norm() > 0.1));
}

/// The transcription of the reference against that of the schemes, which dop853 and tsit45 run: a difference of the two would
/// be in the uncertainty.
#[test]
fn every_transcription_of_every_law_agrees() {
    let smooth =
        Law::ALL.iter().map(polhode::model::forces::Described::example).filter(|law| law.name() != "ground");
    let taylor = Contestant::adaptive().into_iter().find(|c| c.card.name == "taylor").expect("a solver");
    for law in smooth {
        let name = law.name();
        let system = free(CLUSTER, [NONE, [0.25, 0.5, -0.5], [1.5, -2.0, 2.5]], vec![law]);
        let reference = Reference::of(&system, 2.0, 8, None).expect("a reference");
        // Measured 1e-13 and below; a wrong sign or factor of any law is above 1e-3.
        let uncertainty = largest(&reference.largest_uncertainty());
        assert!(uncertainty < 1e-11, "{name}: {uncertainty:e}");
        if taylor.refusal(&system).is_some() {
            assert_eq!(name, "torque-pulse");
            continue;
        }
        // The third transcription, as power series in f64, at its finest tolerance of 1e-13.
        let plan = Plan { step: 1e-3, steps: 2000, every: 2000 };
        let run = taylor.run(&system, Form::Least, &plan);
        let apart = difference(&system.body, &run.states[1], &reference.states[8]);
        assert!(largest(&apart) < 1e-10, "{name}: {apart:?}");
    }
}

/// Drag of a massless point is a damper without a spring in its place.
#[test]
fn a_massless_point_carries_forces_and_nothing_else() {
    let scene = |massless: &str, law: &str| {
        let text = format!(
            "name = \"a\"\nduration = 4.0\n[body]\npoints = [\n{{ mass = 1.0, position = [1.0, 0.0, 0.5] }},\n\
             {{ mass = 2.0, position = [0.0, 1.0, 0.0] }},\n{{ mass = 0.5, position = [-1.0, 0.25, 1.0] }},\n]\n{massless}\
             [initial]\nvelocity = [1.0, 0.5, 0.0]\nangular_velocity = [0.5, -1.0, 2.0]\n[[forces]]\n{law}\n"
        );
        Scene::parse(&text, "a.toml").unwrap_or_else(|error| panic!("{error}")).system
    };
    let massless = "massless = [[0.5, -1.0, 2.0], [0.0, 3.0, 0.0]]\n";
    let dragged = scene(massless, "law = \"drag\"\ncoefficient = [0.0, 0.0, 0.0, 0.75, 0.0]");
    let damper = "law = \"spring\"\nstiffness = 0.0\ndamping = 0.75\n";
    let held = scene("", &format!("{damper}at = [0.5, -1.0, 2.0]"));
    let by_index = scene(massless, &format!("{damper}point = 3"));
    assert_eq!((dragged.body.mass, dragged.body.inertia), (held.body.mass, held.body.inertia));
    let states = |system: &System| Reference::of(system, 4.0, 8, None).expect("a reference").states;
    let exact = states(&held);
    for system in [&dragged, &by_index] {
        for (a, b) in states(system).iter().zip(&exact) {
            let apart = difference(&held.body, a, b);
            assert!(largest(&apart) < 1e-13, "{apart:?}");
        }
    }
    let scheme = Contestant::all().into_iter().find(|c| c.card.name == "peskin-rk2").expect("a scheme");
    let plan = Plan { step: 0.05, steps: 80, every: 80 };
    let last = |form| *scheme.run(&dragged, form, &plan).states.last().expect("a state");
    let apart = difference(&held.body, &last(Form::Least), &last(Form::Points));
    // Both forms of eighty steps, to roundings of numbers of size one.
    assert!(largest(&apart) < 1e-12, "{apart:?}");
}

/// A rotor about a principal axis under a pulse from 1 s to 2.5 s: Ω and the angle are polynomials of time between the jumps.
fn pulsed(start: f64, end: f64) -> System {
    let pulse = TorquePulse { axes: TorqueAxes::Body, torque: V::new(0.0, 0.0, 2.0), start, end };
    from_moments(1.0, [1.0, 2.0, 2.5], false, [0.0, 0.0, 0.5], vec![Law::TorquePulse(pulse)])
}

#[test]
fn a_pulse_about_an_axis_gives_what_it_lasts() {
    let (start, end) = (1.0, 2.5);
    let reference = Reference::of(&pulsed(start, end), 4.0, 32, None).expect("a reference");
    for state in &reference.states {
        let acted = (state.time.min(end) - start).max(0.0);
        let after = (state.time - end).max(0.0);
        let spin = 0.5 + 0.8 * acted;
        let angle = 0.5 * state.time + 0.4 * acted * acted + 0.8 * acted * after;
        assert!((state.angular_velocity - V::z() * spin).norm() < 1e-14, "t = {}", state.time);
        let turned = rotation::turn(&(V::z() * angle));
        assert!(rotation::angle_between(&turned, &state.orientation) < 1e-14, "t = {}", state.time);
    }
    assert!(largest(&reference.largest_uncertainty()) < 1e-12, "{:?}", reference.largest_uncertainty());
}

/// Errors of a scheme at the end, for steps halved twice.
fn errors(system: &System, scheme: &str, steps: u64) -> [f64; 3] {
    let scheme = Contestant::all().into_iter().find(|c| c.card.name == scheme).expect("a scheme");
    let exact = Reference::of(system, 4.0, 4, None).expect("a reference").states[4];
    [1, 2, 4].map(|finer| {
        let steps = steps * finer;
        let plan = Plan { step: 4.0 / steps as f64, steps, every: steps };
        let last = *scheme.run(system, Form::Least, &plan).states.last().expect("a state");
        largest(&difference(&system.body, &last, &exact))
    })
}

/// With torques off every axis: the order of the scheme where steps end at both jumps, and one where no step does.
#[test]
fn a_pulse_keeps_an_order_where_steps_end_at_its_jumps() {
    let general = |start, end| {
        let torque = V::new(1.0, -0.5, 2.0);
        let pulse = TorquePulse { axes: TorqueAxes::World, torque, start, end };
        from_moments(1.0, [1.0, 2.0, 2.5], false, [0.5, 1.0, -0.25], vec![Law::TorquePulse(pulse)])
    };
    for (scheme, order) in [("euler", 1), ("peskin-rk2", 2), ("peskin-rk4", 4)] {
        let [first, second, third] = errors(&general(1.0, 2.5), scheme, 64);
        let slopes = [first / second, second / third].map(f64::log2);
        // Slopes of two halvings come as near to the order as the next term of the error lets them.
        assert!(slopes.iter().all(|slope| (slope - f64::from(order)).abs() < 0.35), "{scheme}: {slopes:?}");
    }
    // Jumps a third into a step, however often it is halved: errors fall by two a halving on average, for every scheme.
    let [first, _, third] = errors(&general(1.0 + 1.0 / 48.0, 2.5 + 1.0 / 48.0), "peskin-rk4", 64);
    let slope = (first / third).log2() / 2.0;
    assert!((0.5..2.0).contains(&slope), "{slope}");
}

fn wheels(momentum: [f64; 3]) -> Law {
    Law::Wheels(Wheels { momentum: V::from(momentum) })
}
