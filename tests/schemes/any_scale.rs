//! Any scale works: molecules in SI, planets, and days of steps give the motion that plain units give.

use nalgebra::Vector3;
use polhode::internals::arithmetic::{DoubleDouble, Real};
use polhode::internals::model::Change;
use polhode::internals::rotation;
use polhode::model::{Snapshot, System};
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form, Plan};

use crate::common::scene;

/// Steps of a run.
const STEPS: u64 = 40;

/// A generic free body, a top and a body on springs.
const SCENES: [&str; 3] = ["free-asymmetric", "heavy-asymmetric-top", "tether-springs"];

/// Units of mass, length and time as powers of two: their moments of inertia and times stand beside.
const BINARY: [(&str, [i32; 3]); 5] = [
    ("a molecule: 1.1e-47 kg m², 1.1e-13 s", [-90, -33, -43]),
    ("an atom: 1.0e-54 kg m², 2.7e-20 s", [-90, -44, -65]),
    ("a moon: 5.3e36 kg m², 1.3e5 s", [76, 23, 17]),
    ("a planet: 1.1e40 kg m², 5.4e8 s", [87, 23, 29]),
    ("a star: 1.0e50 kg m², 3.4e10 s", [106, 30, 35]),
];

/// The same as decimal numbers.
const DECIMAL: [(&str, [f64; 3]); 3] = [
    ("a molecule", [3.1e-26, 1.7e-11, 1e-12]),
    ("a moon", [7.3e22, 1.7e6, 1e5]),
    ("a planet", [6.1e24, 3.7e7, 1e9]),
];

fn change([mass, length, time]: [f64; 3]) -> Change {
    Change { mass, length, time, ..Change::none() }
}

fn binary(powers: [i32; 3]) -> Change {
    change(powers.map(|power| 2f64.powi(power)))
}

/// The states of a run of a tenth of a radian a step, in these units, its states converted to the scene's units; or why it broke.
fn run(contestant: &Contestant, scene: &Scene, form: Form, change: &Change) -> Result<Vec<Snapshot>, String> {
    let start = &scene.system.start;
    let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let spin = scene.system.body.inverse_inertia() * momentum;
    let step = (scene.duration / 1024.0).min(0.1 / rotation::length(&spin));
    let plan = Plan { step: step * change.time, steps: STEPS, every: 8 };
    let system = change.apply(&scene.system);
    let run = contestant.run(&system, form, &plan);
    match run.outcome.broken {
        Some(broken) => Err(broken.to_string()),
        None => Ok(run.states.iter().map(|state| change.undo(state)).collect()),
    }
}

/// Every scheme in every form that takes a scene.
fn runs(scene: &Scene) -> impl Iterator<Item = (Contestant, Form)> {
    Contestant::everyone().into_iter().flat_map(move |contestant| {
        let least = contestant.refusal(&scene.system).is_none().then_some((contestant.clone(), Form::Least));
        let points = contestant.takes_points() && !scene.system.body.points.is_empty();
        least.into_iter().chain(points.then_some((contestant, Form::Points)))
    })
}

/// Every number of a state but the time and the stretch.
fn bits(state: &Snapshot) -> Vec<u64> {
    let vectors = [&state.position, &state.velocity, &state.angular_velocity, &state.angular_momentum];
    let vectors = vectors.into_iter().flat_map(|v| v.iter());
    vectors.chain(state.orientation.coords.iter()).map(|x| x.to_bits()).collect()
}

/// What does not hold of every scheme in units like these, of how many comparisons.
fn broken(
    units: &[(&str, Change)],
    holds: impl Fn(&Contestant, &System, &[Snapshot], &[Snapshot]) -> bool,
) -> (Vec<String>, u32) {
    let (mut rows, mut compared) = (Vec::new(), 0);
    for scene in SCENES.map(scene) {
        for (contestant, form) in runs(&scene) {
            let plain = run(&contestant, &scene, form, &Change::none()).expect("a run in plain units");
            for (name, change) in units {
                compared += 1;
                let why = match run(&contestant, &scene, form, change) {
                    Ok(own)
                        if own.len() == plain.len() && holds(&contestant, &scene.system, &plain, &own) =>
                    {
                        continue;
                    }
                    Ok(own) => format!("off by {:e}", farthest(&scene.system, &plain, &own)),
                    Err(why) => why,
                };
                rows.push(format!("{}, {} {form:?}, {name}: {why}", contestant.card.name, scene.name));
            }
        }
    }
    (rows, compared)
}

#[test]
fn units_that_are_powers_of_two_give_the_same_bits() {
    let units = BINARY.map(|(name, powers)| (name, binary(powers)));
    let same = |_: &Contestant, _: &System, a: &[Snapshot], b: &[Snapshot]| {
        a.iter().zip(b).all(|(a, b)| bits(a) == bits(b))
    };
    let (rows, compared) = broken(&units, same);
    assert!(rows.is_empty(), "{} of {compared}: {rows:#?}", rows.len());
    assert!(compared > 500, "{compared}");
}

#[test]
fn decimal_units_give_the_same_motion_to_rounding() {
    let units = DECIMAL.map(|(name, numbers)| (name, change(numbers)));
    let (rows, compared) = broken(&units, |contestant, system, a, b| {
        // After a rounding, a solver that chooses its steps takes other ones: it keeps its own tolerance.
        let bound = if contestant.chooses_steps() { 1e-4 } else { 1e-12 };
        farthest(system, a, b) < bound
    });
    assert!(rows.is_empty(), "{} of {compared}: {rows:#?}", rows.len());
    assert!(compared > 300, "{compared}");
}

/// The largest difference between two runs, each quantity over its size.
fn farthest(system: &System, a: &[Snapshot], b: &[Snapshot]) -> f64 {
    let extent = system.body.extent();
    let size =
        |of: fn(&Snapshot) -> Vector3<f64>| a.iter().map(|s| rotation::length(&of(s))).fold(0.0, f64::max);
    let (spin, momentum) = (size(|s| s.angular_velocity), size(|s| s.angular_momentum));
    let (reach, speed) = (size(|s| s.position).max(extent), size(|s| s.velocity).max(spin * extent));
    let apart = |a: &Vector3<f64>, b: &Vector3<f64>, size: f64| rotation::length(&(a - b)) / size;
    a.iter().zip(b).fold(0.0, |largest: f64, (a, b)| {
        [
            apart(&a.position, &b.position, reach),
            apart(&a.velocity, &b.velocity, speed),
            apart(&a.angular_velocity, &b.angular_velocity, spin),
            apart(&a.angular_momentum, &b.angular_momentum, momentum),
            rotation::angle_between(&a.orientation, &b.orientation),
        ]
        .into_iter()
        .fold(largest, |largest, off| if off > largest || off.is_nan() { off } else { largest })
    })
}

#[test]
fn a_body_a_million_kilometres_from_the_origin_turns_as_at_the_origin() {
    let far = Change { shift: Vector3::new(2f64.powi(30), -2f64.powi(29), 2f64.powi(28)), ..Change::none() };
    let (rows, compared) = broken(&[("1e9 m away", far)], |contestant, system, a, b| {
        // A rounding of a position is 1e-7 m, which springs of a metre feel.
        let springs = !system.forces.laws().is_empty() && !system.body.pivoted;
        let bound = if springs || contestant.chooses_steps() { 1e-4 } else { 1e-12 };
        let at_the_origin = |states: &[Snapshot]| -> Vec<Snapshot> {
            let still = |s: &Snapshot| Snapshot { position: Vector3::zeros(), ..*s };
            states.iter().map(if springs { |s: &Snapshot| *s } else { still }).collect()
        };
        farthest(system, &at_the_origin(a), &at_the_origin(b)) < bound
    });
    assert!(rows.is_empty(), "{} of {compared}: {rows:#?}", rows.len());
}

#[test]
fn moments_a_million_apart_are_stepped_to_their_rounding() {
    let text = "name = \"needle\"\nduration = 1.0\n[body]\nmass = 1.0\ninertia = [1e-6, 1.0, 1.0000005]\n\
                [initial]\nangular_velocity = [0.5, 1.0, 2.0]\n";
    let scene = Scene::parse(text, "needle.toml").expect("a scene");
    // L over the thin moment is 2.2e6 rad/s: larger steps multiply a rounding of the axis by more than one, again and again.
    let plan = Plan { step: 2f64.powi(-24), steps: STEPS, every: STEPS };
    let precise = System::<DoubleDouble>::of(&scene.system).expect("a system");
    for contestant in Contestant::all() {
        let name = contestant.card.name;
        if contestant.refusal(&scene.system).is_some() {
            continue;
        }
        let own = contestant.run(&scene.system, Form::Least, &plan);
        assert_eq!(own.outcome.broken, None, "{name}");
        let mut known = None;
        contestant.stream_in(&precise, Form::Least, &plan, &mut |state| known = Some(*state));
        let known: Snapshot<DoubleDouble> = known.expect("a state");
        let (own, momentum) = (own.states[own.states.len() - 1], known.angular_momentum.map(Real::to_f64));
        let apart = rotation::length(&(own.angular_momentum - momentum)) / rotation::length(&momentum);
        let q = known.orientation.as_ref().coords.map(Real::to_f64);
        let turned = (own.orientation.coords - q).norm().min((own.orientation.coords + q).norm());
        // A million roundings of the thin moment.
        assert!(apart.max(turned) < 1e-9, "{name}: {apart:e}, {turned:e}");
    }
}
