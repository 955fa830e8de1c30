//! How fast implicit equations are solved: a wrong derivative gives the same steps, only later.

use polhode::campaign::Campaign;
use polhode::model::{Broken, Model};
use polhode::record::{ClaimName, Ruling};
use polhode::schemes::Claim;
use polhode::schemes::{Card, Scheme, Step};
use polhode::simulate::{Contestant, Form, Plan};

use crate::common::scene;

/// Iterations of one equation, in the mean over 16 steps; `None` of a scheme that solves none.
fn iterations(contestant: &Contestant, scene_name: &str, step: f64) -> Option<f64> {
    let scene = scene(scene_name);
    let run = contestant.run(&scene.system, Form::Least, &Plan { step, steps: 16, every: 16 });
    assert_eq!(run.outcome.broken, None, "{}", contestant.card.name);
    (run.outcome.solves > 0).then(|| run.outcome.iterations as f64 / run.outcome.solves as f64)
}

#[test]
fn newtons_method_squares_its_error_and_repetition_gains_a_digit() {
    let mut solving = 0;
    for contestant in Contestant::all() {
        let Some(found) = iterations(&contestant, "heavy-asymmetric-top", 1.0 / 32.0) else { continue };
        let name = contestant.card.name;
        println!("{name}: {found:.2}");
        solving += 1;
        // A step of a tenth of a radian: 0.1 squared three times is 1e-8, and what Newton's method makes of that is rounding.
        // Repetition gains one to two digits. Measured: 3, and 6.1 to 10.
        let most = if name == "lie-verlet" { 3.0 } else { 10.0 };
        assert!(found > 1.0 && found <= most, "{name}: {found}");
    }
    assert!(solving >= 9, "{solving}");
}

#[test]
fn equations_are_solved_as_fast_in_any_unit_of_time() {
    // Two bodies that turn by 1e8 and 1e-8 rad/s, at steps of a tenth of a radian.
    for contestant in Contestant::all() {
        let [fast, slow] = [("spin-1e8", 1e-9), ("spin-1e-8", 1e7)]
            .map(|(scene, step)| iterations(&contestant, scene, step));
        // The unit is no power of two: rounding may put an end one iteration sooner or later, in a step of the sixteen.
        let apart = fast.zip(slow).map_or(0.0, |(fast, slow)| (fast - slow).abs());
        assert!(
            fast.is_some() == slow.is_some() && apart <= 0.25,
            "{}: {fast:?} {slow:?}",
            contestant.card.name
        );
    }
}

/// Euler's rule that finds no solution: of a step larger than so many parts of 1e-9 s.
#[derive(Clone, Copy)]
struct Unsolved<const UP_TO: u32>;

impl<const UP_TO: u32> Scheme for Unsolved<UP_TO> {
    fn card(&self) -> Card {
        Card {
            name: "unsolved",
            title: "finds no solution",
            family: "test",
            source: "none",
            claims: &[Claim::Order(1), Claim::Evaluations(1)],
        }
    }

    const STATES: usize = 0;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        if h > f64::from(UP_TO) * 1e-9 {
            return Err(Broken::NoConvergence { iterations: 100, residual: 1.0, tolerance: 1e-12 });
        }
        model.advance(from, h, &model.rates(t, from)?, to);
        Ok(())
    }
}

#[test]
fn a_ladder_without_a_solution_at_its_finest_step_is_undecided_and_one_that_gets_past_is_judged_after_it() {
    let rulings = |contestant: Contestant, claim: ClaimName| -> Vec<Ruling> {
        let verdicts = Campaign::of(vec![scene("free-asymmetric")], vec![contestant]).run().verdicts;
        let own = verdicts.into_iter().filter(|v| v.scheme == "unsolved" && v.claim == claim);
        own.map(|verdict| verdict.verdict).collect()
    };
    // The finest step of a ladder of eight seconds is of 6e-5 s or more.
    for contestant in [Contestant::new(Unsolved::<0>), Contestant::new(Unsolved::<1000>)] {
        assert_eq!(rulings(contestant.clone(), ClaimName::Run), [Ruling::Inconclusive]);
        assert!(rulings(contestant, ClaimName::Order).is_empty());
    }
    // Steps of a hundredth of a second and less have a solution.
    let orders = rulings(Contestant::new(Unsolved::<10_000_000>), ClaimName::Order);
    assert!(orders.contains(&Ruling::Pass) && !orders.contains(&Ruling::Fail), "{orders:?}");
}
