//! When a scheme looks at a force: one that depends on time alone is summed at the nodes of the rule.

use nalgebra::Vector3;
use polhode::scenes::Scene;
use polhode::simulate::{Form, Plan};

use crate::common::contestant;

/// Four equal points in a field that is the same at each of them: no torque, and F/M = cos(3 t) along x.
const SCENE: &str = r#"
name = "field"
duration = 1.0
[body]
points = [
    { mass = 0.25, position = [1, 0, 0] }, { mass = 0.25, position = [-1, 0.5, 0] },
    { mass = 0.25, position = [0, -1, 0.5] }, { mass = 0.25, position = [0, 0.5, -0.5] },
]
[initial]
angular_velocity = [0.25, 0.5, 1.0]
[[forces]]
law = "lorentz"
charge = 0.25
electric_cosine = [1, 0, 0]
frequency = 3.0
"#;

/// h [s].
const STEP: f64 = 0.125;

/// Nodes and weights of a rule over a step of length 1.
type Rule = Vec<(f64, f64)>;

fn rules() -> Vec<(&'static [&'static str], Rule)> {
    let simpson = vec![(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)];
    let root = |x: f64| x.sqrt();
    let composed = |gammas: &[f64]| {
        let mut at = 0.0;
        let mut rule = Vec::new();
        for gamma in gammas {
            rule.extend([(at, gamma / 2.0), (at + gamma, gamma / 2.0)]);
            at += gamma;
        }
        rule
    };
    let (two, four) = (f64::cbrt(2.0), f64::cbrt(4.0));
    let (jump, fractal) = (1.0 / (2.0 - two), 1.0 / (4.0 - four));
    vec![
        (&["euler"], vec![(0.0, 1.0)]),
        (&["substepped-4-euler"], vec![(0.0, 0.25), (0.25, 0.25), (0.5, 0.25), (0.75, 0.25)]),
        (&["peskin-rk2", "peskin-cayley"], vec![(0.5, 1.0)]),
        (&["peskin-heun", "strang-rotations", "exact-rotor", "moser-veselov"], vec![(0.0, 0.5), (1.0, 0.5)]),
        (&["peskin-ralston"], vec![(0.0, 0.25), (2.0 / 3.0, 0.75)]),
        (&["peskin-rk4", "rkmk4", "rk4-quaternion", "rk4-matrix"], simpson),
        (&["gauss-legendre-4"], vec![(0.5 - root(3.0) / 6.0, 0.5), (0.5 + root(3.0) / 6.0, 0.5)]),
        (
            &["gauss-legendre-6"],
            vec![
                (0.5 - root(15.0) / 10.0, 5.0 / 18.0),
                (0.5, 8.0 / 18.0),
                (0.5 + root(15.0) / 10.0, 5.0 / 18.0),
            ],
        ),
        (&["yoshida-4"], composed(&[jump, -two * jump, jump])),
        (&["suzuki-4"], composed(&[fractal, fractal, -four * fractal, fractal, fractal])),
    ]
}

#[test]
fn a_force_of_time_alone_is_summed_at_the_nodes_of_the_rule() {
    let scene = Scene::parse(SCENE, "field.toml").expect("a scene");
    for (schemes, rule) in rules() {
        for name in schemes {
            let contestant = contestant(name);
            let run = contestant.run(&scene.system, Form::Least, &Plan { step: STEP, steps: 3, every: 3 });
            assert_eq!(run.outcome.broken, None, "{name}");
            let force = |t: f64| Vector3::x() * (3.0 * t).cos();
            let expected: Vector3<f64> = (0..3)
                .flat_map(|n| rule.iter().map(move |(node, weight)| (f64::from(n) + node, *weight)))
                .map(|(time, weight)| force(time * STEP) * (weight * STEP))
                .sum();
            let apart = (run.states[run.states.len() - 1].velocity - expected).amax();
            // Sums of a dozen numbers below a half.
            assert!(apart < 8.0 * f64::EPSILON, "{name}: {apart:e}");
        }
    }
}
