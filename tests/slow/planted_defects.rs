//! The verifier verified: a faithful copy of the scheme stays green, and every planted defect turns a gate red.

use std::sync::LazyLock;

use polhode::internals::self_test::{self, Findings};

static FINDINGS: LazyLock<Findings> = LazyLock::new(|| self_test::run(&|_, _| ()));

#[test]
fn every_planted_defect_turns_a_gate_red_and_a_faithful_copy_stays_green() {
    let findings = &*FINDINGS;
    assert!(findings.held_against_the_copy.is_empty(), "{:#?}", findings.held_against_the_copy);
    let survivors: Vec<_> = findings.survivors().collect();
    assert!(survivors.is_empty(), "no gate caught {survivors:#?}");
    assert!(findings.outcomes.len() >= 80);
}

#[test]
fn defects_that_stay_second_order_are_caught_by_a_constant_or_by_exactness() {
    for name in [
        "cayley",
        "sine of angle",
        "rotation to second order",
        "trapezoid in 6",
        "heun corrector",
        "energy projection",
    ] {
        let outcome = FINDINGS.outcomes.iter().find(|outcome| outcome.name == name).expect("planted");
        let told = ["constant", "exact"].iter().any(|gate| outcome.caught_by.contains(*gate));
        assert!(told, "{name}: {:?}", outcome.caught_by);
    }
}
