//! What a law says of itself, held against the force and torque that it gives: an example of every law of the list.

use nalgebra::Vector3;

use super::{Acts, Argument, Forces, Law, Load};
use crate::model::body::{Body, MassPoint};
use crate::model::change::Change;
use crate::model::{Placed, Spin, System};
use crate::rotation::{self, Rotation};

type V = Vector3<f64>;

/// A turned and spinning body of three points, one of them below the ground of the example.
fn system(law: Law) -> System {
    let point = |mass, x, y, z| MassPoint { mass, position: V::new(x, y, z) };
    let points = [point(1.0, 1.0, 0.0, 0.5), point(2.0, 0.0, 1.0, 0.0), point(0.5, -1.0, 0.25, 1.0)];
    let (body, _) = Body::from_points(&points, None).expect("a body");
    let (position, orientation) = (V::new(0.25, -0.5, 0.125), rotation::turn(&V::new(0.5, -0.25, 1.0)));
    let (velocity, spin) = (V::new(0.5, -0.25, 1.0), Spin::Velocity(V::new(1.0, -2.0, 0.5)));
    System::new(body, vec![law], position, orientation, velocity, spin).expect("a system")
}

/// The load on the points at a time, at the start of a system in this motion.
fn load(system: &System, t: f64, position: V, velocity: V, spin: V) -> Load {
    let mut placed = Placed::new(system);
    placed.turn(system, &system.start.orientation);
    system.forces.load_on_points(t, &placed.cloud(position, velocity, spin))
}

fn load_at(system: &System, t: f64) -> Load {
    let start = &system.start;
    let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let spin = start.orientation * (system.body.inverse_inertia() * momentum);
    load(system, t, start.position, start.velocity, spin)
}

#[test]
fn a_law_depends_on_what_it_says() {
    let zero = V::zeros();
    for described in &Law::ALL {
        let (law, system) = (described.example(), system(described.example()));
        let (x, v) = (system.start.position, V::new(0.25, 0.5, -1.0));
        let rest = load(&system, 0.0, x, zero, zero);
        assert!(rest != Load::default() || law.reads_velocity(), "{}: no load", law.name());
        let later = load(&system, 1.7, x, zero, zero);
        assert_eq!(rest != later, law.clock() != 0.0, "{}: time", law.name());
        let moving = load(&system, 0.0, x, v, V::new(1.0, -2.0, 0.5));
        assert_eq!(rest != moving, law.reads_velocity(), "{}: velocity", law.name());
        assert_eq!(rest.force == zero && moving.force == zero, law.is_torque(), "{}: force", law.name());
        let elsewhere = load(&system, 0.0, x + V::new(0.0, 0.0, -0.25), v, zero);
        let is_galilean = elsewhere == load(&system, 0.0, x, zero, zero);
        assert_eq!(is_galilean, law.is_galilean(), "{}: boost", law.name());
        if let Some(acceleration) = law.uniform_acceleration() {
            assert_eq!(moving.force, acceleration * system.body.mass);
        }
        assert_eq!(law.acts() == Acts::OnMass, law.uniform_acceleration().is_some());
        assert!(!law.conserves() || law.clock() == 0.0, "{}: a clock drives", law.name());
    }
}

#[test]
fn a_law_is_the_same_in_every_world() {
    let turn = rotation::turn(&V::new(0.5, -1.0, 0.25));
    let shift = V::new(0.75, -1.25, 0.5);
    let boost = V::zeros();
    let worlds = [
        Change { turn, ..Change::none() },
        Change { shift, ..Change::none() },
        Change { length: -1.0, ..Change::none() },
        Change { turn, shift, boost, mass: 16.0, length: -0.25, time: 8.0 },
    ];
    for (described, change) in Law::ALL.iter().flat_map(|law| worlds.map(|change| (law, change))) {
        for example in [described.example(), other_axes(&described.example())] {
            let system = system(example);
            let (old, new) = (load_at(&system, 0.3), load_at(&change.apply(&system), 0.3 * change.time));
            let force = change.mass * change.length / (change.time * change.time);
            let apart = (change.turn * old.force * force - new.force).norm() / force.abs()
                + (change.turn * old.torque * (force * change.length) - new.torque).norm()
                    / (force * change.length).abs();
            // Loads of size 100, each a sum of fewer than thirty products.
            assert!(apart < 1e-12, "{} in {change:?}: {apart:e}", described.name);
        }
    }
}

/// The same law with vectors given in the other axes, where it has a choice.
fn other_axes(law: &Law) -> Law {
    use super::TorqueAxes;
    law.map(|_, argument| match argument {
        Argument::Axes(TorqueAxes::Body) => Argument::Axes(TorqueAxes::World),
        Argument::Axes(TorqueAxes::World) => Argument::Axes(TorqueAxes::Body),
        other => other,
    })
}

#[test]
fn the_reduced_form_is_the_sum_over_the_points() {
    for described in &Law::ALL {
        let system = system(described.example());
        let forces = Forces::new(system.forces.laws().to_vec(), &system.body);
        let (start, turn) = (&system.start, system.start.orientation * system.body.principal);
        let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
        let pose = super::Pose {
            axes: Rotation::to_rotation_matrix(turn).into_inner(),
            origin: start.position,
            velocity: start.velocity,
            spin: start.orientation * (system.body.inverse_inertia() * momentum),
        };
        let (reduced, summed) = (forces.load(0.3, &pose), load_at(&system, 0.3));
        let apart = (reduced.force - summed.force).norm() + (reduced.torque - summed.torque).norm();
        // Loads of size 100, as above.
        assert!(apart < 1e-12, "{}: {apart:e}", described.name);
    }
}

#[test]
fn a_law_is_rebuilt_from_its_arguments_and_named_once() {
    let mut names: Vec<&str> = Law::ALL.iter().map(|law| law.name).collect();
    for described in &Law::ALL {
        let law = described.example();
        assert_eq!(law.name(), described.name);
        assert_eq!(law.map(|_, argument| argument), law);
        assert_eq!(Law::<f64>::of(&law), law);
        for (parameter, argument) in law.arguments() {
            assert_eq!(argument, parameter.example, "{} of {}", parameter.key, described.name);
            assert!(!parameter.what.is_empty() && !parameter.unit.is_empty(), "{}", parameter.key);
        }
    }
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Law::ALL.len());
}
