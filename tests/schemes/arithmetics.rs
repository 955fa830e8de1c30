//! One page, three arithmetics: every scheme gives the same motion in each, as far as its digits go.

use polhode::internals::arithmetic::{DoubleDouble, Single};
use polhode::internals::rotation;
use polhode::model::{Snapshot, System};
use polhode::scenes::{self, Scene};
use polhode::simulate::{Arithmetic, Contestant, Form, Plan};

/// Steps of a run.
const STEPS: u64 = 24;

/// The last state of a run in an arithmetic, or what broke it.
fn end_in<T: Arithmetic>(
    contestant: &Contestant,
    scene: &Scene,
    form: Form,
    plan: &Plan,
) -> Result<Snapshot<T>, String> {
    let system = System::<T>::of(&scene.system).map_err(|error| error.to_string())?;
    let mut end = None;
    let outcome = contestant.stream_in(&system, form, plan, &mut |state| end = Some(*state));
    match (outcome.broken, end) {
        (Some(broken), _) => Err(broken.to_string()),
        (None, end) => end.ok_or("no state".to_owned()),
    }
}

/// Largest difference of an end from one in f64, each quantity over its size, or over that of what it is made of.
fn apart<T: Arithmetic>(scene: &Scene, own: &Snapshot<T>, known: &Snapshot) -> f64 {
    let near = |a: &nalgebra::Vector3<T>, b: &nalgebra::Vector3<f64>, size: f64| {
        let off = rotation::length(&(a.map(T::to_f64) - b));
        if off == 0.0 { 0.0 } else { off / size }
    };
    let start = &scene.system.start;
    let extent = scene.system.body.extent();
    let spin = rotation::length(&known.angular_velocity);
    let reach = rotation::length(&known.position).max(extent).max(rotation::length(&start.position));
    let speed = rotation::length(&known.velocity).max(spin * extent).max(rotation::length(&start.velocity));
    let momentum = rotation::length(&known.angular_momentum).max(rotation::length(&start.angular_momentum));
    let q = own.orientation.as_ref().coords.map(T::to_f64) - known.orientation.as_ref().coords;
    let mirrored = own.orientation.as_ref().coords.map(T::to_f64) + known.orientation.as_ref().coords;
    [
        near(&own.position, &known.position, reach),
        near(&own.velocity, &known.velocity, speed),
        near(&own.angular_velocity, &known.angular_velocity, spin),
        near(&own.angular_momentum, &known.angular_momentum, momentum),
        q.norm().min(mirrored.norm()),
    ]
    .into_iter()
    .fold(0.0, |largest, off| if off > largest || off.is_nan() { off } else { largest })
}

/// How far every scheme is from its f64 run, in every scene that it takes: the rows above a bound.
fn above<T: Arithmetic>(bound: f64, form: Form) -> (Vec<String>, u32) {
    let (mut rows, mut compared) = (Vec::new(), 0);
    for scene in scenes::built_in().into_iter().filter(|scene| scene.only_for_stability.is_none()) {
        let spin = scene.system.body.inverse_inertia()
            * scene.system.start.orientation.inverse_transform_vector(&scene.system.start.angular_momentum);
        // A sixteenth of a radian a step, and 1/4096 of the run at most.
        let turn = rotation::length(&spin);
        let step = (scene.duration / 4096.0).min(if turn > 0.0 { 0.0625 / turn } else { f64::INFINITY });
        let plan = Plan { step, steps: STEPS, every: STEPS };
        for contestant in Contestant::all() {
            let takes = contestant.refusal(&scene.system).is_none()
                && (form == Form::Least
                    || (contestant.takes_points() && !scene.system.body.points.is_empty()));
            let Some(known) = takes.then(|| end_in::<f64>(&contestant, &scene, form, &plan).ok()).flatten()
            else {
                continue;
            };
            compared += 1;
            match end_in::<T>(&contestant, &scene, form, &plan) {
                Err(why) => rows.push(format!("{} in {}: {why}", contestant.card.name, scene.name)),
                Ok(own) => {
                    let off = apart(&scene, &own, &known);
                    if off.is_nan() || off > bound {
                        rows.push(format!("{} in {}: {off:e}", contestant.card.name, scene.name));
                    }
                }
            }
        }
    }
    (rows, compared)
}

#[test]
fn double_double_gives_the_motion_of_f64_to_its_rounding() {
    for form in [Form::Least, Form::Points] {
        let (rows, compared) = above::<DoubleDouble>(1e-11, form);
        assert!(rows.is_empty(), "{form:?}: {rows:#?}");
        assert!(compared > 300, "{compared}");
    }
}

#[test]
fn single_precision_gives_the_motion_of_f64_to_its_own_rounding() {
    // Bodies far from the origin or thin lose digits of what single precision holds; a short step is lost in a long time.
    let (rows, compared) = above::<Single>(1e-3, Form::Least);
    assert!(rows.is_empty(), "{rows:#?}");
    assert!(compared > 1000, "{compared}");
}
