//! Counts of work, exactly.

use polhode::record::ClaimName::{self, Evaluations, Solves};
use polhode::record::Ruling::{Fail, NotApplicable, Pass};
use polhode::schemes::Claim;

use super::case::{Made, RUNS, numbers};

/// Three evaluations and two equations a step, five iterations to an equation, and so many more of each on every run of 8 to 1024 steps.
fn counted(more: [u64; RUNS]) -> Made {
    let mut made = Made::new("free-asymmetric", &[Claim::Evaluations(3), Claim::Solves(2)]);
    for (rung, more) in made.evidence.ladder.rungs.iter_mut().zip(more) {
        rung.evaluations = 3 * rung.steps + more;
        rung.solves = 2 * rung.steps + more;
        rung.iterations = 5 * rung.solves;
    }
    made
}

/// So many on one run alone.
fn on(run: usize, more: u64) -> [u64; RUNS] {
    std::array::from_fn(|k| if k == run { more } else { 0 })
}

#[test]
fn counts_are_as_claimed_on_every_run_but_for_one_evaluation_at_the_beginning_of_each() {
    for (more, evaluations, solves) in [
        ([0; RUNS], Pass, Pass),
        ([1; RUNS], Pass, Fail),
        ([2; RUNS], Fail, Fail),
        (on(1, 1), Fail, Fail),
        (on(RUNS - 1, 1), Fail, Fail),
    ] {
        let made = counted(more);
        let rulings = [made.ruling(Evaluations, "evaluations"), made.ruling(Solves, "solves")];
        assert_eq!(rulings, [evaluations, solves], "{more:?}");
    }
    // Fewer than claimed are as wrong as more.
    let mut made = counted([0; RUNS]);
    made.evidence.ladder.rungs.iter_mut().for_each(|rung| {
        (rung.evaluations, rung.solves) = (2 * rung.steps, rung.steps);
    });
    assert_eq!([made.ruling(Evaluations, "evaluations"), made.ruling(Solves, "solves")], [Fail; 2]);
}

#[test]
fn each_jump_of_a_law_may_cost_an_evaluation_more() {
    let jumps = 2;
    for (more, expected) in [
        ([3; RUNS], Pass),
        (std::array::from_fn(|run| 1 + jumps.min(run as u64)), Pass),
        (std::array::from_fn(|run| jumps.min(run as u64)), Pass),
        // Three jumps, of which some runs meet none, and three with a beginning.
        (std::array::from_fn(|run| (jumps + 1).min(run as u64)), Fail),
        ([4; RUNS], Fail),
    ] {
        let mut made = counted(more);
        made.evidence.setting.jumps = jumps;
        assert_eq!(made.ruling(Evaluations, "evaluations"), expected, "{more:?}");
    }
}

#[test]
fn runs_that_broke_are_not_counted_but_where_all_did() {
    let mut made = counted(on(RUNS - 1, 7)).broken(RUNS - 1);
    let shown = |made: &Made, claim: ClaimName, quantity: &str| {
        let verdict = made.verdict(claim, quantity);
        (verdict.verdict, numbers(&verdict))
    };
    assert_eq!(shown(&made, Evaluations, "evaluations"), (Pass, [Some(3.0); 3]));
    assert_eq!(shown(&made, Solves, "solves"), (Pass, [Some(2.0); 3]));
    for run in 0..RUNS {
        made = made.broken(run);
    }
    // The verdict on the run says that it broke.
    assert_eq!(shown(&made, Evaluations, "evaluations").0, NotApplicable);
    assert_eq!(shown(&made, Solves, "solves").0, NotApplicable);
}

#[test]
fn the_evaluations_of_the_finest_run_and_the_equations_of_the_coarsest_stand_beside_the_claim() {
    let verdict = counted([512; RUNS]).verdict(Evaluations, "evaluations");
    assert_eq!((verdict.verdict, numbers(&verdict)), (Fail, [Some(3.5), Some(3.0), Some(3.0)]));
    let verdict = counted(on(0, 4)).verdict(Solves, "solves");
    assert_eq!((verdict.verdict, numbers(&verdict)), (Fail, [Some(2.5), Some(2.0), Some(2.0)]));
}
