//! A scene in other units has the same answer.

use polhode::internals::rotation::angle_between;
use polhode::model::forces::{Attachment, CentralGravity, Drag, Law, PerPoint, Spring};
use polhode::model::{PerQuantity, Quantity, Snapshot, System};
use polhode::reference::{Reference, Role};

use super::building::{CLUSTER, V, free, gravity, largest, worst};

fn spring(point: usize, anchor: [f64; 3], stiffness: f64, damping: f64) -> Law {
    let attachment = Attachment::Point(point);
    Law::Spring(Spring { attachment, anchor: V::from(anchor), stiffness, damping, rest_length: 0.0 })
}

/// Gravity, a damped spring, drag and a central force, in units of mass, length and time.
fn scaled([m, l, t]: [f64; 3]) -> System {
    let points: Vec<_> = CLUSTER.iter().map(|[w, x, y, z]| [w * m, x * l, y * l, z * l]).collect();
    let laws = vec![
        gravity([0.0, -0.5 * l / (t * t), -l / (t * t)]),
        spring(1, [-l, 1.5 * l, 0.0], 5.0 * m / (t * t), 0.5 * m / t),
        Law::Drag(Drag { coefficient: PerPoint::Same(0.125 * m / t) }),
        Law::CentralGravity(CentralGravity { mu: l * l * l / (t * t), center: V::new(8.0, 0.0, 0.0) * l }),
    ];
    let start = [[0.25 * l, 0.0, -0.125 * l], [0.5 * l / t, 0.25 * l / t, 0.0]];
    let momentum = [1.5, -2.0, 2.5].map(|x| x * m * l * l / t);
    free(&points, [start[0], start[1], momentum], laws)
}

#[test]
fn a_scene_scaled_by_1e_plus_minus_10_gives_the_same_dimensionless_answer() {
    let plain = scaled([1.0; 3]);
    let expected = Reference::of(&plain, 4.0, 8, None).expect("a reference");
    for axis in 0..3 {
        for factor in [1e-10, 1e10] {
            let mut units = [1.0; 3];
            units[axis] = factor;
            let [m, l, t] = units;
            let reference = Reference::of(&scaled(units), 4.0 * t, 8, None).expect("a reference");
            assert!(reference.sources.iter().all(|s| s.role != Role::Failed), "{:?}", reference.sources);
            let scaled_back: Vec<_> = reference
                .states
                .iter()
                .map(|s| Snapshot {
                    position: s.position / l,
                    velocity: s.velocity * (t / l),
                    angular_velocity: s.angular_velocity * t,
                    angular_momentum: s.angular_momentum * (t / (m * l * l)),
                    ..*s
                })
                .collect();
            let error = worst(&plain, &scaled_back, &expected.states);
            assert!(largest(&error) < 1e-12, "{units:?}: {error:?}");
            let scale = PerQuantity::from([l, l / t, 1.0, 1.0 / t, m * l * l / t, l]);
            let stated = reference.largest_uncertainty();
            assert!(
                stated.zip(scale).values().all(|(stated, scale)| stated / scale < 1e-12),
                "{units:?}: {stated:?}"
            );
        }
    }
}

#[test]
fn a_body_turns_alike_however_fast_it_flies() {
    // In the time in which it passes its own length it turns by 1e-10 rad and less: powers of that leave the range of f64.
    for speed in [1e3, 1e6, 1e9, 1e12] {
        let system =
            |velocity| free(CLUSTER, [[0.0; 3], [velocity, 0.0, 0.0], [1.5e-3, -2.0e-3, 2.5e-3]], Vec::new());
        let turned = |velocity| Reference::of(&system(velocity), 2e4, 8, None).expect("a reference");
        let (still, flying) = (turned(0.0), turned(speed));
        assert!(flying.sources.iter().all(|s| s.role != Role::Failed), "{:?}", flying.sources);
        let uncertainty = flying.largest_uncertainty()[Quantity::Orientation];
        assert!(uncertainty < 1e-10, "{speed} m/s: {uncertainty}");
        for (a, b) in flying.states.iter().zip(&still.states) {
            let apart = angle_between(&a.orientation, &b.orientation);
            assert!(apart < 1e-15, "{speed} m/s at {} s: {apart} rad", a.time);
        }
    }
}
