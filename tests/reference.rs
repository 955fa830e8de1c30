//! The references agree with each other and with 40-digit solutions, and say how well.

use nalgebra::{Matrix3, Vector3};
use polhode::model::body::{Body, MassPoint, Shape};
use polhode::model::forces::{
    Attachment, CentralGravity, Dipole, Drag, Gravity, Ground, Law, Lorentz, PerPoint, Spring, Torque,
    TorqueAxes,
};
use polhode::model::{Quantity, Snapshot, Spin, System, difference};
use polhode::reference::stored::{self, Solution};
use polhode::reference::{Reference, ReferenceError, Role, Spread, StoredError, dop853, tsit45};
use polhode::rotation::{self, Rotation};

type V = Vector3<f64>;

const NONE: [f64; 3] = [0.0; 3];

/// A scene with a stored solution.
struct Scene {
    name: &'static str,
    duration: f64,
    system: System,
}

const CLUSTER: &[[f64; 4]] = &[
    [1.0, 1.25, -0.5, 0.25],
    [2.0, -0.5, 0.875, 0.25],
    [3.0, 0.125, -0.625, -0.75],
    [1.5, -0.75, 0.25, 1.0],
    [2.0, 0.25, 0.125, 0.0],
];
const CROSS: &[[f64; 4]] = &[
    [1.0, 1.0, 0.0, 0.0],
    [1.0, -1.0, 0.0, 0.0],
    [0.5, 0.0, 1.0, 0.0],
    [0.5, 0.0, -1.0, 0.0],
    [0.25, 0.0, 0.0, 1.0],
    [0.25, 0.0, 0.0, -1.0],
];
const SMALL_CROSS: &[[f64; 4]] = &[
    [1.0, 0.5, 0.0, 0.0],
    [1.0, -0.5, 0.0, 0.0],
    [0.5, 0.0, 0.5, 0.0],
    [0.5, 0.0, -0.5, 0.0],
    [0.25, 0.0, 0.0, 0.5],
    [0.25, 0.0, 0.0, -0.5],
];
const OBLATE: &[[f64; 4]] = &[
    [1.0, 1.0, 0.0, 0.0],
    [1.0, -1.0, 0.0, 0.0],
    [1.0, 0.0, 1.0, 0.0],
    [1.0, 0.0, -1.0, 0.0],
    [0.5, 0.0, 0.0, 0.5],
    [0.5, 0.0, 0.0, -0.5],
];
const ROD: &[[f64; 4]] = &[[1.0, -0.5, -1.0, 1.0], [1.0, 0.25, 0.5, -0.5], [2.0, 0.125, 0.25, -0.25]];
const HEAVY_TOP: &[[f64; 4]] = &[
    [0.5, 0.0, 0.0, -1.0],
    [0.5, 0.5, 0.0, 0.25],
    [0.5, -0.5, 0.0, 0.25],
    [0.5, 0.0, 0.5, 0.25],
    [0.5, 0.0, -0.5, 0.25],
];
const FAST_TOP: &[[f64; 4]] =
    &[[0.5, 0.5, 0.0, 1.0], [0.5, -0.5, 0.0, 1.0], [0.5, 0.0, 0.5, 1.0], [0.5, 0.0, -0.5, 1.0]];
const KOVALEVSKAYA: &[[f64; 4]] = &[
    [2.0, 0.5, 0.0, 0.0],
    [1.0, 0.0, 0.5, 0.0],
    [1.0, 0.0, -0.5, 0.0],
    [3.0, 0.0, 0.0, 0.5],
    [3.0, 0.0, 0.0, -0.5],
];

fn body(points: &[[f64; 4]], pivot: Option<V>) -> Body {
    let given: Vec<_> =
        points.iter().map(|[m, x, y, z]| MassPoint { mass: *m, position: V::new(*x, *y, *z) }).collect();
    Body::from_points(&given, pivot).expect("a body").0
}

fn free(points: &[[f64; 4]], start: [[f64; 3]; 3], laws: Vec<Law>) -> System {
    let [x, u, l] = start.map(V::from);
    System::new(body(points, None), laws, x, Rotation::identity(), u, Spin::Momentum(l)).expect("a system")
}

fn top(points: &[[f64; 4]], momentum: [f64; 3], g: [f64; 3]) -> System {
    let body = body(points, Some(V::zeros()));
    let (position, spin) = (body.center, Spin::Momentum(V::from(momentum)));
    System::new(body, vec![gravity(g)], position, Rotation::identity(), V::zeros(), spin).expect("a system")
}

fn gravity(g: [f64; 3]) -> Law {
    Law::Gravity(Gravity { acceleration: V::from(g) })
}

fn spring(point: usize, anchor: [f64; 3], stiffness: f64, damping: f64) -> Law {
    let attachment = Attachment::Point(point);
    Law::Spring(Spring { attachment, anchor: V::from(anchor), stiffness, damping, rest_length: 0.0 })
}

fn pivot_spring(damping: f64) -> System {
    let laws = vec![gravity([-6.0, 0.0, -8.0]), spring(0, NONE, 1024.0, damping)];
    free(HEAVY_TOP, [[0.0, 0.0, 1.0], NONE, [0.125, 0.0, 4.0]], laws)
}

fn tether() -> System {
    let laws = vec![
        spring(0, [2.0, -1.0, 0.5], 4.0, 0.0),
        spring(1, [-1.0, 1.5, 0.0], 2.0, 0.0),
        spring(2, [0.0, -1.0, -1.5], 6.0, 0.0),
        spring(3, [-1.5, 0.0, 1.5], 3.0, 0.0),
        spring(4, [0.5, 0.5, 0.5], 1.0, 0.0),
    ];
    free(CLUSTER, [[0.25, 0.0, -0.125], [0.5, 0.25, -0.5], [1.5, -2.0, 2.5]], laws)
}

fn field() -> System {
    let lorentz = Lorentz {
        charge: PerPoint::Each(vec![2.0, -1.0, 0.5, 1.0, -1.5]),
        electric: V::zeros(),
        electric_cosine: V::zeros(),
        electric_sine: V::new(1.0, -0.5, 2.0),
        frequency: 3.0,
        magnetic: V::zeros(),
    };
    let laws = vec![Law::Lorentz(lorentz), spring(0, [1.0, -0.5, 0.25], 2.0, 0.0)];
    free(CLUSTER, [NONE, [0.25, 0.0, -0.5], [1.5, -2.0, 2.5]], laws)
}

fn drag() -> System {
    let coefficient = PerPoint::Each(vec![0.25, 0.5, 0.125, 0.25, 0.375]);
    let laws = vec![gravity([0.0, 0.0, -9.75]), Law::Drag(Drag { coefficient })];
    free(CLUSTER, [[0.5, -1.0, 2.0], [2.0, 0.5, 4.0], [1.5, -2.0, 2.5]], laws)
}

fn orbit() -> System {
    let central = Law::CentralGravity(CentralGravity { mu: 8.0, center: V::zeros() });
    free(SMALL_CROSS, [[3.0, 0.0, 0.0], [0.0, 1.5, 0.25], [0.125, 0.25, 0.375]], vec![central])
}

fn from_moments(mass: f64, moments: [f64; 3], unphysical: bool, spin: [f64; 3], laws: Vec<Law>) -> System {
    let inertia = Matrix3::from_diagonal(&V::from(moments));
    let body = Body::from_inertia(mass, inertia, None, unphysical).expect("a body");
    let spin = Spin::Velocity(V::from(spin));
    System::new(body, laws, V::zeros(), Rotation::identity(), V::zeros(), spin).expect("a system")
}

fn sciml() -> System {
    let torque = Torque {
        axes: TorqueAxes::Body,
        constant: V::new(0.0, 0.0, 0.375),
        cosine: V::new(0.0, 0.0, -0.375),
        sine: V::zeros(),
        frequency: 2.0,
    };
    from_moments(1.0, [0.5, 2.0, 3.0], true, [1.0, 0.0, 0.9], vec![Law::Torque(torque)])
}

fn scenes() -> Vec<Scene> {
    let asymmetric = free(CLUSTER, [[0.5, -1.0, 2.0], [0.25, 0.5, -0.125], [1.5, -2.0, 2.5]], vec![]);
    let scene = |name, duration, system| Scene { name, duration, system };
    vec![
        scene("free-asymmetric", 8.0, asymmetric),
        scene("dzhanibekov", 48.0, free(CROSS, [NONE, NONE, [0.015625, 5.0, 0.0078125]], vec![])),
        scene("free-oblate", 10.0, free(OBLATE, [NONE, NONE, [1.0, 0.5, 3.0]], vec![])),
        scene("exact-separatrix", 8.0, free(CROSS, [NONE, NONE, [0.5, -4.0, 1.0]], vec![])),
        scene("free-rod", 6.0, free(ROD, [NONE, [0.5, 0.0, -0.25], [2.0, 0.0, 1.0]], vec![])),
        scene("lagrange-top-pivot-spring", 2.0, pivot_spring(8.0)),
        scene("lagrange-top-pivot-spring-undamped", 2.0, pivot_spring(0.0)),
        scene("lagrange-fast-top", 6.0, top(FAST_TOP, [0.5, 0.25, 5.0], [-0.75, 0.0, -1.0])),
        scene("kovalevskaya", 6.0, top(KOVALEVSKAYA, [1.0, 0.5, 1.5], [-0.5, -0.5, -0.75])),
        scene("gravity-drag", 3.0, drag()),
        scene("tether-springs", 4.0, tether()),
        scene("sciml-rigidbody-wpd", 10.0, sciml()),
        scene("gravity-gradient", 8.0, orbit()),
        scene("time-dependent-field", 4.0, field()),
    ]
}

fn stored_of(name: &str) -> stored::Stored {
    stored::find(name).expect("sound").expect("stored")
}

fn quarters(duration: f64) -> [f64; 4] {
    [0.25, 0.5, 0.75, 1.0].map(|part| part * duration)
}

fn worst(system: &System, a: &[Snapshot], b: &[Snapshot]) -> Spread {
    let mut worst = [0.0f64; 6];
    for (a, b) in a.iter().zip(b) {
        let apart = difference(&system.body, a, b);
        worst = std::array::from_fn(|i| worst[i].max(apart[i]));
    }
    worst
}

fn worst_against(scene: &Scene, states: &[Snapshot]) -> Spread {
    match stored_of(scene.name).solution(&scene.system).expect("a solution") {
        Solution::Motion(exact) => worst(&scene.system, states, &exact),
        Solution::Spin(spins) => {
            let apart = |(s, (_, spin)): (&Snapshot, &(f64, V))| {
                (s.orientation.inverse_transform_vector(&s.angular_velocity) - spin).norm()
            };
            [0.0, 0.0, 0.0, states.iter().zip(&spins).map(apart).fold(0.0, f64::max), 0.0, 0.0]
        }
    }
}

fn show(s: &Spread) -> String {
    s.iter().map(|x| format!("{x:.1e} ")).collect()
}
#[test]
fn measure() {
    for scene in scenes() {
        let times = quarters(scene.duration);
        let a = dop853::solve(&scene.system, &times, dop853::TOLERANCE).expect("dop853");
        let b = tsit45::solve(&scene.system, &times, tsit45::TOLERANCE).expect("tsit45");
        let max = |s: Spread| s.into_iter().fold(0.0, f64::max);
        let clock = std::time::Instant::now();
        let r = Reference::of(&scene.system, scene.duration, 64, Some(&stored_of(scene.name))).expect("ref");
        eprintln!(
            "{:36} dop853 {:.1e} ({}) tsit45 {:.1e} ({}) time {:.0} ms unc {:?}",
            scene.name,
            max(worst_against(&scene, &a.states)),
            a.evaluations,
            max(worst_against(&scene, &b.states)),
            b.evaluations,
            clock.elapsed().as_secs_f64() * 1e3,
            show(&r.largest_uncertainty()),
        );
        for s in &r.sources {
            eprintln!("      {} | {} | {:?}", s.name, s.detail, s.disagreement.map(|d| show(&d)));
        }
    }
    for (name, t, moments, spin) in [
        (
            "fast-spin",
            100.0,
            [0.043333333333333335, 0.03333333333333333, 0.01666666666666667],
            [20.0, 0.05, 0.05],
        ),
        (
            "middle",
            100.0,
            [0.043333333333333335, 0.03333333333333333, 0.01666666666666667],
            [0.05, 5.0, 0.05],
        ),
        ("thin", 2.0, [0.00017231, 6.58e-06, 0.00017243], [3.0, 0.3, 300.0]),
        ("jsbsim", 10.0, [10.0, 20.0, 26.0], [1.0, 15.0, 1.0]),
    ] {
        let s = from_moments(1.0, moments, false, spin, vec![]);
        let clock = std::time::Instant::now();
        let r = Reference::of(&s, t, 64, None).expect("ref");
        eprintln!(
            "{name:36} {:.0} ms {:?} {:?}",
            clock.elapsed().as_secs_f64() * 1e3,
            show(&r.largest_uncertainty()),
            r.sources
        );
    }
}
