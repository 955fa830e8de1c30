//! A point on springs, with drag.

use polhode::internals::reference::closed;
use polhode::internals::rotation::Rotation;
use polhode::model::body::{Body, MassPoint};
use polhode::model::forces::{Attachment, Drag, Gravity, Law, PerPoint, Spring};
use polhode::model::{Spin, System};

use super::known::{V, exact, grid};

#[test]
fn a_point_on_springs_with_drag_is_covered_under_and_over_critical_damping() {
    let spring = |stiffness, damping, anchor: V| {
        Law::Spring(Spring { attachment: Attachment::Point(0), anchor, stiffness, damping, rest_length: 0.0 })
    };
    let drag = |c| Law::Drag(Drag { coefficient: PerPoint::Same(c) });
    let gravity = Law::Gravity(Gravity { acceleration: V::new(0.5, 0.0, -9.75) });
    let cases = [
        ("undamped", vec![spring(8.0, 0.0, V::new(1.0, 2.0, 0.0))]),
        (
            "two springs",
            vec![spring(8.0, 0.5, V::new(1.0, 2.0, 0.0)), spring(3.0, 0.25, V::new(0.0, -1.0, 1.0))],
        ),
        ("underdamped", vec![gravity.clone(), spring(8.0, 0.5, V::zeros()), drag(0.25)]),
        ("critical", vec![gravity.clone(), spring(8.0, 8.0, V::zeros())]),
        ("overdamped", vec![gravity.clone(), spring(8.0, 40.0, V::zeros()), drag(1.0)]),
        ("drag", vec![gravity.clone(), drag(0.75)]),
        ("little drag", vec![gravity.clone(), drag(1e-6)]),
        ("much drag", vec![drag(60.0)]),
        ("gravity", vec![gravity.clone()]),
    ];
    for (name, laws) in cases {
        let given = [MassPoint { mass: 2.0, position: V::zeros() }];
        let (body, _) = Body::from_points(&given, None).expect("a point");
        let (position, velocity) = (V::new(3.0, -1.0, 0.5), V::new(1.0, 0.5, -2.0));
        let spin = Spin::Momentum(V::zeros());
        let system =
            System::new(body, laws, position, Rotation::identity(), velocity, spin).expect("a system");
        let times = grid(20.0);
        let found = closed::solve(&system, &times).expect("a closed form");
        for (a, b) in found.states.iter().zip(&exact(&system, &times)) {
            // A phase of 40 rad and rounding of a fall of 2 km.
            let size = b.position.norm() + b.velocity.norm() + 10.0;
            let error = (a.position - b.position).norm().max((a.velocity - b.velocity).norm());
            assert!(error < 32.0 * f64::EPSILON * size, "{name} at {} s: {error:e}", a.time);
        }
    }
}
