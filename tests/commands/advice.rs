//! Advice held against runs of its own: the answer must be true at the step given, and at those below it.

use polhode::internals::study::advice::{Question, SAMPLES, search};
use polhode::measure::{self, Sight};
use polhode::model::Quantity;
use polhode::reference::Reference;
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form, Plan};

use crate::common::scene;

const TOLERANCE: f64 = 1e-3;

/// Largest error of the orientation over a run of so many steps.
fn error(contestant: &Contestant, scene: &Scene, reference: &Reference, steps: u64) -> f64 {
    let plan = Plan::over(scene.duration, steps, SAMPLES as u64);
    let run = contestant.run(&scene.system, Form::Least, &plan);
    let sight = Sight { system: &scene.system, reference, states: &run.states };
    measure::errors(&sight)[Quantity::Orientation].max
}

#[test]
fn a_step_that_is_advised_and_those_below_it_keep_the_tolerance() {
    for name in ["free-asymmetric", "heavy-asymmetric-top", "gravity-drag"] {
        let scene = scene(name);
        let reference = Reference::of(&scene.system, scene.duration, SAMPLES, None).expect("a reference");
        let contestants: Vec<Contestant> =
            Contestant::main().into_iter().filter(|c| c.card.evaluations() > 1).collect();
        let question =
            Question::new(&scene, scene.duration, Quantity::Orientation, TOLERANCE).expect("a question");
        let mut found = 0;
        for answer in question.ask(&contestants, &|_, _| ()).answers {
            let Ok(advice) = &answer.found else { continue };
            found += 1;
            let contestant = contestants.iter().find(|c| c.card.name == answer.scheme).expect("asked");
            // The samples divide the steps; the margin holds at the step itself, the tolerance anywhere down to half of it.
            let samples = SAMPLES as u64;
            let at = |factor: f64| (advice.steps as f64 * factor / samples as f64).round() as u64 * samples;
            let own = error(contestant, &scene, &reference, advice.steps);
            assert!(own <= search::MARGIN * TOLERANCE, "{} on {name}: {own:e}", answer.scheme);
            for factor in [1.1, 1.3, 1.6, 2.0] {
                let error = error(contestant, &scene, &reference, at(factor));
                assert!(
                    error <= TOLERANCE,
                    "{} on {name}, {factor} times the steps: {error:e}",
                    answer.scheme
                );
            }
            // And the step is about the largest: half as many steps miss the margin, where fewer can be tried at all.
            if advice.steps > 4 * samples {
                let coarser = error(contestant, &scene, &reference, at(0.5));
                assert!(coarser > search::MARGIN * TOLERANCE, "{} on {name}: {coarser:e}", answer.scheme);
            }
        }
        assert!(found >= 2, "{name}: {found} answers");
    }
}
