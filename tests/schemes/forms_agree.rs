//! The reduced models and the mass points are one scheme: they agree to rounding in every scene.

use polhode::internals::measure;
use polhode::internals::rotation;
use polhode::reference::Reference;
use polhode::scenes;
use polhode::simulate::{Contestant, Form, Plan};

#[test]
fn points_and_the_least_model_agree_to_4096_units_in_every_judged_scene() {
    // Where no claim is judged, the reason is a motion that multiplies roundings a millionfold.
    for scene in scenes::built_in().into_iter().filter(|scene| scene.only_for_stability.is_none()) {
        let reference = Reference::of(&scene.system, scene.duration, 4, None).expect("a reference");
        let fastest =
            reference.states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
        for contestant in Contestant::all() {
            let name = contestant.card.name;
            match measure::point_run(&contestant, &scene.system, scene.duration, fastest) {
                Some(run) => {
                    assert!(matches!(run.steps, 128 | 1000));
                    let plan = Plan { step: run.step, steps: run.steps, every: run.steps };
                    let points = contestant.run(&scene.system, Form::Points, &plan);
                    assert!(points.outcome.broken.is_none(), "{}, {name}", scene.name);
                    // Measured for the note's two schemes in f64: at most 90 units, and 770 to 7200 on nasa-check-case-2, by
                    // the last bit of the step: there the torques of the weight cancel to a thousandth of L a second,
                    // and their rounding, which is alike for as long as the body hardly turns, remains. One torque a
                    // step enters L in both, a difference of two products with three roundings, and turns the body by as
                    // much for each of two radians; four torques in a scheme of four stages.
                    let torques = if matches!(name, "peskin-rk2" | "euler") { 6.0 } else { 12.0 };
                    let extra =
                        if run.torque_rounding.is_finite() { torques * run.torque_rounding } else { 0.0 };
                    let bound = 4096.0 * run.unit + extra;
                    assert!(run.difference < bound, "{}, {name}: {:e}", scene.name, run.difference);
                    // A body that only turns steadily, or a scheme of the points alone, may agree to the last bit.
                    let two_forms = contestant.model(&scene.system) != "points";
                    assert!(
                        !two_forms || run.difference > 0.0,
                        "{}: two forms that agree to the last bit are one form",
                        scene.name
                    );
                }
                None => assert!(scene.system.body.points.is_empty() || !contestant.takes_points()),
            }
        }
    }
}
