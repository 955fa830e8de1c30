//! A run of any scheme in `N` equal parts of every step.
//!
//! (1)  s(i+1) = S(i h/N, h/N, s(i)),  i = 0, 1, 2, …;  every N-th is a step of the run
//!
//! A multistep scheme keeps the history of its parts, as it would in an engine.

use super::contestant::Run;
use super::{Break, Form, Outcome, Plan};
use crate::claim::Claim;
use crate::model::{Snapshot, System};
use crate::schemes::Card;

/// Runs the parts as steps of their own, and speaks of steps again.
pub(super) fn run(
    run: &Run,
    system: &System,
    form: Form,
    plan: &Plan,
    parts: u32,
    store: &mut dyn FnMut(&Snapshot),
) -> Outcome {
    let parts = u64::from(parts);
    let fine = Plan {
        step: plan.step / parts as f64,
        steps: plan.steps.saturating_mul(parts),
        every: plan.every.max(1).saturating_mul(parts),
    };
    let outcome = run(system, form, &fine, store); // (1)
    let broken = outcome.broken.map(|broken| Break { step: broken.step.div_ceil(parts), ..broken });
    Outcome { steps: outcome.steps / parts, broken, ..outcome }
}

/// The card of a scheme in so many parts. It lives as long as the program, once a scheme and command.
pub(super) fn card(base: &Card, parts: u32) -> Card {
    let counted = |claim: &Claim| match *claim {
        Claim::Evaluations(count) => Claim::Evaluations(count * parts),
        Claim::Solves(count) => Claim::Solves(count * parts),
        other => other,
    };
    let claims: Vec<Claim> = base.claims.iter().map(counted).collect();
    Card {
        name: format!("{}{parts}-{}", Card::SUBSTEPPED, base.name).leak(),
        title: format!("{}, in {parts} parts a step", base.title).leak(),
        family: "substepped",
        source: base.source,
        claims: claims.leak(),
    }
}
