//! Counts of work, exactly.

use polhode::record::Ruling::{Broken, Fail, Inconclusive, Pass};
use polhode::schemes::Claim;

use super::case::{Made, broken, numbers};

/// Three evaluations a step on every rung of 8 to 256 steps, and so many more on each.
fn evaluated(more: [u64; 6]) -> Made {
    let mut made = Made::new("free-asymmetric", &[Claim::Evaluations(3)]);
    for (rung, more) in made.evidence.rungs.iter_mut().zip(more) {
        rung.outcome.evaluations = 3 * rung.steps + more;
    }
    made
}

#[test]
fn evaluations_are_as_many_as_claimed_and_one_at_the_beginning_of_every_run() {
    let ruling = |more| evaluated(more).ruling("evaluations", "evaluations");
    assert_eq!([ruling([0; 6]), ruling([1; 6])], [Pass; 2]);
    assert_eq!([ruling([2; 6]), ruling([0, 1, 0, 0, 0, 0]), ruling([1, 1, 1, 1, 1, 0])], [Fail; 3]);
    let mut made = evaluated([0; 6]);
    made.evidence.rungs.iter_mut().for_each(|rung| rung.outcome.evaluations = 2 * rung.steps);
    assert_eq!(made.ruling("evaluations", "evaluations"), Fail);
}

#[test]
fn runs_that_broke_are_not_counted_but_where_all_did() {
    let mut made = evaluated([0, 0, 0, 0, 0, 7]);
    made.evidence.rungs[5] = broken(made.evidence.rungs[5].clone());
    let verdict = made.verdict("evaluations", "evaluations");
    assert_eq!((verdict.verdict, numbers(&verdict)), (Pass, [Some(3.0); 3]));
    made.evidence.rungs = made.evidence.rungs.into_iter().map(broken).collect();
    assert_eq!(made.ruling("evaluations", "evaluations"), Broken);
    made.evidence.goes_on_in = Some(0.25);
    assert_eq!(made.ruling("evaluations", "evaluations"), Inconclusive);
}

#[test]
fn the_evaluations_of_the_finest_run_are_shown_beside_the_claim() {
    let verdict = evaluated([128; 6]).verdict("evaluations", "evaluations");
    assert_eq!((verdict.verdict, numbers(&verdict)), (Fail, [Some(3.5), Some(3.0), Some(3.0)]));
}

/// Two equations a step, and so many more on each rung; five iterations to an equation.
fn solved(more: [u64; 6]) -> Made {
    let mut made = Made::new("free-asymmetric", &[Claim::Solves(2)]);
    for (rung, more) in made.evidence.rungs.iter_mut().zip(more) {
        rung.outcome.solves = 2 * rung.steps + more;
        rung.outcome.iterations = 5 * rung.outcome.solves;
    }
    made
}

#[test]
fn implicit_equations_are_as_many_as_claimed_on_every_rung() {
    let verdict = solved([0; 6]).verdict("solves", "solves");
    assert_eq!((verdict.verdict, numbers(&verdict)), (Pass, [Some(2.0); 3]));
    assert!(verdict.detail.contains("5.0 iterations each"), "{}", verdict.detail);
    assert_eq!(
        [solved([0, 0, 0, 0, 0, 1]).ruling("solves", "solves"), solved([1; 6]).ruling("solves", "solves")],
        [Fail; 2]
    );
    let verdict = solved([4, 0, 0, 0, 0, 0]).verdict("solves", "solves");
    assert_eq!((verdict.verdict, numbers(&verdict)), (Fail, [Some(2.5), Some(2.0), Some(2.0)]));
}

#[test]
fn equations_of_runs_that_broke_are_not_counted_but_where_all_did() {
    let mut made = solved([7, 0, 0, 0, 0, 0]);
    made.evidence.rungs[0] = broken(made.evidence.rungs[0].clone());
    assert_eq!(made.ruling("solves", "solves"), Pass);
    made.evidence.rungs = made.evidence.rungs.into_iter().map(broken).collect();
    assert_eq!(made.ruling("solves", "solves"), Broken);
}
