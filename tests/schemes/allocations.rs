//! A step allocates nothing: a run of a thousand more steps asks for no more memory.

use polhode::scenes;
use polhode::simulate::{Contestant, Form, Plan};

/// Allocations of a whole run in so many steps, the states not kept.
fn allocations(contestant: &Contestant, scene: &scenes::Scene, form: Form, steps: u64) -> Option<u64> {
    // Small steps: whatever the scheme, it gets through them.
    let plan = Plan { step: scene.duration / 65_536.0, steps, every: steps };
    let mut whole = true;
    let counted = allocation_counter::measure(|| {
        whole = contestant.stream(&scene.system, form, &plan, &mut |_| {}).broken.is_none();
    });
    whole.then_some(counted.count_total)
}

#[test]
fn a_run_allocates_as_much_whether_it_has_sixteen_steps_or_two_thousand() {
    let mut models = std::collections::BTreeSet::new();
    for contestant in Contestant::all() {
        let mut runs = 0;
        for scene in scenes::built_in() {
            // Some break in the scenes that are there to break them.
            if scene.only_for_stability.is_some() || contestant.refusal(&scene.system).is_some() {
                continue;
            }
            for form in [Form::Least, Form::Points] {
                if form == Form::Points && (!contestant.takes_points() || scene.system.body.points.is_empty())
                {
                    continue;
                }
                let name = contestant.card.name;
                let [few, many] = [16, 2064].map(|steps| allocations(&contestant, &scene, form, steps));
                let few = few.unwrap_or_else(|| panic!("{name} broke in {}", scene.name));
                assert_eq!(Some(few), many, "{name} in {}, {form:?}", scene.name);
                // The buffers of a run, made once.
                assert!(few < 200, "{name} in {}, {form:?}: {few}", scene.name);
                models.insert(if form == Form::Least { contestant.model(&scene.system) } else { "points" });
                runs += 1;
            }
        }
        assert!(runs >= 20, "{}: {runs} runs", contestant.card.name);
    }
    let all: Vec<&str> = models.into_iter().collect();
    assert_eq!(all, ["falling", "forced", "free", "pivot", "points", "torque"]);
}

#[test]
fn an_allocation_in_every_step_would_be_seen() {
    let counted = |steps: u64| {
        let measured = allocation_counter::measure(|| {
            for n in 0..steps {
                std::hint::black_box(vec![n]);
            }
        });
        measured.count_total
    };
    assert_eq!((counted(16), counted(2064)), (16, 2064));
}
