//! The likeliest cause of a run that converges to another motion.

use polhode::internals::study::cause::{Cause, likeliest_cause};
use polhode::reference::Reference;

use crate::common::scene;

/// Each fault is found in the one scene that shows it, from the states of a program that has it, two runs apart by little.
#[test]
fn a_fault_is_named_where_a_scene_shows_it_and_none_where_nothing_is_wrong() {
    let scene_of = |cause: Cause| match cause {
        Cause::TorqueAboutOrigin | Cause::NotOverMass => "tether-springs",
        Cause::PointsDoNotTurn | Cause::PointsTurnBackwards => "gravity-drag",
        Cause::QuadraticDrag | Cause::DragTimesMass => "gravity-drag",
        Cause::FieldInBodyAxes => "charged-body-in-fields",
        Cause::Products => "tether-springs",
        _ => "free-asymmetric",
    };
    for cause in Cause::ALL {
        let scene = scene(scene_of(cause));
        let reference = Reference::of(&scene.system, scene.duration, 16, None).expect("a reference");
        let (system, truth) = (&scene.system, &reference.states);
        let Some(states) = cause.motion(system, truth) else { panic!("{cause:?} changes nothing") };
        let mut before = states.clone();
        before.iter_mut().for_each(|s| s.angular_velocity *= 1.0 + 1e-6);
        assert_eq!(likeliest_cause(system, truth, &states, &before), Some(cause));
        assert_eq!(likeliest_cause(system, truth, truth, truth), None);
    }
}
