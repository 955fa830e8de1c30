//! Bodies on the ground: the series stops at every touch and every leave, and its bound holds.

use polhode::internals::ode::dop853;
use polhode::internals::reference::precise::{self, AFFORDABLE, DoubleDouble, Moment, Motion};
use polhode::internals::rotation::Rotation;
use polhode::model::forces::{Ground, Law};
use polhode::model::{Quantity, Snapshot, Spin, System};

use super::building::{NONE, V, body, free, gravity, largest, quarters, worst};
use crate::common::scene;

const POINT: &[[f64; 4]] = &[[1.0, 0.0, 0.0, 0.0]];
const CROSS: &[[f64; 4]] =
    &[[1.0, 1.0, 0.0, 0.0], [1.0, -1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, -1.0]];
const BOX: &[[f64; 4]] = &[
    [0.25, 0.5, 0.25, -0.125],
    [0.25, -0.5, 0.25, -0.125],
    [0.25, 0.5, -0.25, -0.125],
    [0.25, -0.5, -0.25, -0.125],
    [0.5, 0.0, 0.0, 0.125],
];

fn ground(stiffness: f64, damping: f64, friction: f64) -> Ground {
    Ground { normal: V::z(), height: 0.0, stiffness, damping, friction, slip_velocity: 0.0625 }
}

fn solve(system: &System, times: &[f64]) -> Motion {
    precise::solve(system, times, 10.0 * AFFORDABLE).expect("a motion")
}

/// π, whose second part is the rest of the nearest f64.
fn pi() -> DoubleDouble {
    DoubleDouble::of_sum(std::f64::consts::PI, 1.224_646_799_147_353_2e-16)
}

/// A point of 1 kg dropped from 1 m on a spring of 4 N/m under 8 m/s²: it falls for ½ s, and is down at 4 m/s, as fast as the
/// spring's √(k/m) = 2 rad/s takes g to; so it stays for ¾ of a turn, 3π/4 s, and is back at its height after 1 + 3π/4 s.
#[test]
fn a_point_on_an_undamped_ground_bounces_by_parabola_and_sine() {
    let laws = vec![gravity([0.0, 0.0, -8.0]), Law::Ground(ground(4.0, 0.0, 0.25))];
    let system = free(POINT, [[0.0, 0.0, 1.0], [0.0, 0.0, 0.0], NONE], laws);
    let period = DoubleDouble::ONE + pi().scaled(0.75);
    for bounces in [1.0, 2.0, 64.0] {
        let back = period * bounces.into();
        let lowest = back - DoubleDouble::from(0.5) - pi().scaled(0.375);
        let motion = solve(&system, &[lowest.to_f64(), back.to_f64()]);
        assert_eq!(motion.switches, 2 * bounces as usize);
        // Times are f64: what is left of them is known.
        let [low, high] = &motion.moments[..] else { panic!("two moments") };
        let late = DoubleDouble::from(high.time) - back;
        let height = DoubleDouble::ONE - (late * late).scaled(4.0);
        holds("height", high.position[2] - height, high.error[Quantity::Position]);
        holds("fall", high.velocity[2] + late.scaled(8.0), high.error[Quantity::Velocity]);
        let late = DoubleDouble::from(low.time) - lowest;
        // z'' = −8 − 4 z = 8 √2 where z = −2 − 2 √2.
        let root = DoubleDouble::from(2.0).sqrt();
        let depth = (DoubleDouble::ONE + root).scaled(2.0) - (root * late * late).scaled(4.0);
        holds("depth", low.position[2] + depth, low.error[Quantity::Position]);
        holds("rise", low.velocity[2] - (root * late).scaled(8.0), low.error[Quantity::Velocity]);
        // Measured: 2e-31 after one bounce, 2e-29 after 64.
        assert!(high.error[Quantity::Velocity] < 1e-27, "{bounces}: {:e}", high.error[Quantity::Velocity]);
    }
}

fn holds(what: &str, error: DoubleDouble, bound: f64) {
    assert!(error.high.abs() <= bound, "{what}: {:e} > {bound:e}", error.high.abs());
}

/// A point of 1 kg falls 8 m in 4 s. Below the ground d'' = g − k d − c d' until k d + c d' = 0, where the ground lets go, while
/// the point is still below it.
#[test]
fn a_damped_ground_lets_go_before_the_point_is_out() {
    let (g, k, c, down) = (1.0, 5.0, 2.0, 4.0);
    let laws = vec![gravity([0.0, 0.0, -g]), Law::Ground(ground(k, c, 0.0))];
    let system = free(POINT, [[0.0, 0.0, 8.0], NONE, NONE], laws);
    // d = g/k + e^{−βt} (a cos ωt + b sin ωt), with d(0) = 0 and d'(0) = down.
    let (beta, omega): (f64, f64) = (0.5 * c, (k - 0.25 * c * c).sqrt());
    let (a, b) = (-g / k, (down - beta * g / k) / omega);
    let depth = |t: f64| g / k + (-beta * t).exp() * (a * (omega * t).cos() + b * (omega * t).sin());
    let sinking = |t: f64| {
        let (sine, cosine) = (omega * t).sin_cos();
        (-beta * t).exp() * ((omega * b - beta * a) * cosine - (omega * a + beta * b) * sine)
    };
    let push = |t: f64| k * depth(t) + c * sinking(t);
    let (mut low, mut high): (f64, f64) = (0.25, 0.25);
    while push(high) > 0.0 {
        (low, high) = (high, high + 0.01);
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if push(middle) > 0.0 { low = middle } else { high = middle }
    }
    assert!(depth(low) > 0.1);
    let times = [4.5, 4.0 + low + 0.125];
    let motion = solve(&system, &times);
    let inside = motion.moments[0].snapshot();
    assert!((inside.position.z + depth(0.5)).abs() < 1e-14, "{}", inside.position.z + depth(0.5));
    let out = motion.moments[1].snapshot();
    let height = -depth(low) - 0.125 * sinking(low) - 0.5 * g * 0.125 * 0.125;
    assert!((out.position.z - height).abs() < 1e-14, "{}", out.position.z - height);
    assert_eq!(motion.switches, 2);
}

/// A system, its duration [s], and how far dop853 is from its motion at most.
type Case = (&'static str, System, f64, f64);

fn every_way_of_touching() -> Vec<Case> {
    let weight = gravity([0.0, 0.0, -9.75]);
    let on = |law: Ground| vec![weight.clone(), Law::Ground(law)];
    let floor = ground(512.0, 4.0, 0.5);
    let high = [[0.0, 0.0, 0.5], [0.25, 0.0, 0.0], NONE];
    let level = [[0.0, 0.0, 0.125], [0.25, 0.5, 0.0], NONE];
    let spinning = [[0.0, 0.0, 0.125], [0.25, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let wall = Ground { normal: V::new(-0.6, 0.0, 0.8), height: -1.0, ..floor.clone() };
    let slope = Ground { normal: V::new(0.6, 0.0, 0.8), height: 0.25, ..ground(300.0, 0.0, 0.0) };
    let both = vec![weight.clone(), Law::Ground(floor.clone()), Law::Ground(wall)];
    let weightless = vec![Law::Ground(floor.clone())];
    vec![
        ("flat", free(BOX, high, on(floor.clone())), 2.0, 1e-9),
        ("just touching", free(BOX, level, on(floor.clone())), 1.0, 1e-9),
        ("sliding in its plane, weightless", free(BOX, level, weightless), 1.0, 1e-13),
        ("spinning flat", free(BOX, spinning, on(floor.clone())), 2.0, 1e-9),
        (
            "floor and wall",
            free(BOX, [[0.0, 0.0, 0.5], [1.5, 0.0, 0.0], [0.125, 0.25, 0.0]], both),
            2.0,
            1e-8,
        ),
        (
            "a slope without damper",
            free(BOX, [[0.0, 0.0, 1.0], NONE, [0.0, 0.25, 0.5]], on(slope)),
            2.0,
            1e-8,
        ),
        ("no stiffness", free(BOX, high, on(ground(0.0, 8.0, 0.5))), 1.0, 1e-9),
        ("on a pivot", on_a_pivot(on(floor.clone())), 4.0, 1e-9),
        ("to rest", free(BOX, high, on(ground(64.0, 16.0, 0.5))), 16.0, 1e-9),
    ]
}

/// Touching all at once, at the start already, hardly, never, on a wall and a floor, about a pivot, at rest after long.
#[test]
fn every_way_of_touching_is_solved_with_a_bound_that_dop853_bears_out() {
    for (name, system, duration, apart) in every_way_of_touching() {
        let times = quarters(duration);
        let motion = solve(&system, &times);
        let precise: Vec<Snapshot> = motion.moments.iter().map(Moment::snapshot).collect();
        let rough = dop853::solve(&system, &times, dop853::TOLERANCE).expect("dop853").states;
        let worst = largest(&worst(&system, &rough, &precise));
        assert!(worst < apart, "{name}: {worst:e}");
        let bound = motion.moments.iter().map(|m| largest(&m.error)).fold(0.0, f64::max);
        assert!(bound < 1e-24, "{name}: {bound:e}");
        // At rest there is nothing left of Ω and L but their errors, which are told over what they were.
        let digits = motion.certain_digits(&system);
        assert!(digits >= 24, "{name}: {digits}");
        assert_eq!(motion.switches == 0, name.starts_with("sliding"), "{name}: {}", motion.switches);
    }
}

fn on_a_pivot(laws: Vec<Law>) -> System {
    let body = body(&[[1.0, 0.0, 1.0, 0.0], [1.0, 0.5, -0.5, 0.25], [2.0, 0.0, 0.0, 0.5]], Some(V::z()));
    let position = V::new(0.0, 0.0, 0.75) + body.center;
    let spin = Spin::Momentum(V::new(4.0, 1.0, 0.0));
    System::new(body, laws, position, Rotation::identity(), V::zeros(), spin).expect("a system")
}

/// Points on a circle of 1 m about a weightless centre turn past a ground just as far below it, a rounding more or less.
#[test]
fn a_touch_that_grazes_costs_no_digit() {
    for off in [-1e-12, -f64::EPSILON, 0.0, 0.5 * f64::EPSILON, 1e-15, 1e-9] {
        let law = Ground { height: -1.0 + off, ..ground(512.0, 8.0, 0.5) };
        let spin = [[0.0; 3], NONE, [0.0, 4.0, 0.0]];
        let system = free(CROSS, spin, vec![Law::Ground(law)]);
        let motion = solve(&system, &[2.0, 4.0]);
        for moment in &motion.moments {
            // Measured: up to 1.5e-27, where it is a rounding that tells whether there is a touch at all.
            assert!(largest(&moment.error) < 1e-26, "{off:e}: {:?}", moment.error);
            if off <= 0.0 {
                let [x, y, z] = moment.angular_velocity;
                let change = [x, y - DoubleDouble::ONE, z].map(|x| x.high.abs());
                assert!(
                    change.iter().all(|x| *x <= moment.error[Quantity::AngularVelocity]),
                    "{off:e}: {change:?}"
                );
            }
            // A touch of depth δ takes a part √δ of a turn, and is pushed by up to 8 N s/m times √δ: about δ each.
            let spin = moment.snapshot().angular_velocity;
            let slower = (spin - V::y()).norm();
            let bound = 64.0 * off.max(0.0) + 1e-15;
            assert!(slower <= bound, "{off:e}: {slower:e} > {bound:e}");
            assert!(off < 1e-10 || slower > 0.5 * off, "{off:e}: {slower:e}");
        }
        // Whether what is neither above nor below touches is decided by rounding.
        assert!(off == 0.0 || (motion.switches > 0) == (off > 0.0), "{off:e}: {}", motion.switches);
    }
}

#[test]
fn the_scenes_on_the_ground_touch_and_leave_as_often_as_they_do() {
    // Counted by a second program too: extrapolated midpoint rule, 42 digits, steps below 4 ms and 0.4 ms; its solutions agree with
    // these to the 26 and 28 digits that are stored.
    for (name, switches) in [("bouncing-body", 12), ("tippe-top", 35)] {
        let scene = scene(name);
        let motion = solve(&scene.system, &quarters(scene.duration));
        assert_eq!(motion.switches, switches, "{name}");
    }
}
