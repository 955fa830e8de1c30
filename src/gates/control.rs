//! What a scheme shows in a generic scene, beside what it shows in the one that is judged.

use super::{Case, energy, order, order_here};
use crate::claim::Claim;
use crate::record::{ClaimName, Ruling, Verdict};

/// A scheme in a generic scene. In another an order above the claimed one says that the scene is too easy, where the claimed order
/// holds here, and that the claim is too low, where it does not; one below it may be no order yet.
#[derive(Clone, Debug, Default)]
pub struct Control {
    /// What the gates said there, without a control of their own; nothing where the scheme takes no such scene.
    pub verdicts: Vec<Verdict>,
}

impl Control {
    /// Whether the claim fails there and holds in nothing.
    pub(super) fn denies(&self, claim: ClaimName) -> bool {
        let said = |ruling| self.verdicts.iter().any(|v| v.claim == claim && v.verdict == ruling);
        said(Ruling::Fail) && !said(Ruling::Pass)
    }

    /// The scene, where the claim holds in it: in one quantity at least, and in none not.
    pub(super) fn shows(&self, claim: ClaimName, quantity: &str) -> Option<&str> {
        let mut spoken =
            self.verdicts.iter().filter(|v| v.claim == claim && v.quantity.starts_with(quantity));
        let against = |v: &Verdict| matches!(v.verdict, Ruling::Fail | Ruling::Broken);
        if spoken.clone().any(against) {
            return None;
        }
        spoken.find(|v| v.verdict == Ruling::Pass).map(|v| v.scene.as_str())
    }
}

/// Whether a control may tell more of what failed: an order of an error or of an energy's rate.
pub fn ask_for_control(verdicts: &[Verdict]) -> bool {
    let open = |v: &Verdict| v.verdict == Ruling::Fail && v.known_deviation.is_none();
    verdicts.iter().any(|v| open(v) && (v.claim == ClaimName::Order || v.quantity == energy::RATE))
}

/// The verdicts on orders alone, of errors and of the energy's rate, as they are without a control.
pub fn judge_orders(case: &Case) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    for claim in case.card.claims {
        match *claim {
            Claim::Order(order) => verdicts.extend(order::judge(case, order_here(case, order))),
            Claim::Energy(energy) => verdicts.extend(energy::judge(case, energy)),
            _ => {}
        }
    }
    verdicts
}
