//! The rules by which a verdict is made, where they are more special than the claim.

use crate::words::words;

words! {
    /// A rule of a gate, below the claim that it judges.
    Rule {
        /// Too few runs.
        #[default]
        FewRuns = "few-runs",
        /// Rounding hides the order.
        Rounding = "rounding",
        /// No order is seen yet.
        NotAsymptotic = "not-asymptotic",
        /// Rounding decides the motion.
        Open = "open-to-rounding",
        /// Equations that are solved to a tolerance.
        Solves = "solved-to-tolerance",
        /// Errors at their rounding.
        AtRounding = "at-rounding",
        /// Another motion.
        Elsewhere = "another-motion",
        /// A kink of a force.
        Kink = "kink",
        /// A jump of the error.
        Jump = "jump",
        /// Runs of an odd number of steps.
        Odd = "odd-steps",
        /// The order in a generic scene.
        Generic = "generic-order",
        /// No order to judge.
        NoClaim = "no-order-claimed",
        /// The number of flips.
        FlipCount = "flip-count",
        /// No run.
        NotSolved = "not-solved",
        /// A reference without solution.
        NoReference = "no-reference",
    }
}

impl Rule {
    /// The rule, in a sentence.
    pub fn explained(self) -> &'static str {
        match self {
            Rule::FewRuns => {
                "Fewer than four runs of halved steps came to their end. Smaller steps would decide it."
            }
            Rule::Rounding => {
                "Fewer than four errors are larger than their rounding. Larger steps would decide it."
            }
            Rule::NotAsymptotic => {
                "r(q) = |e(h) - 2^q e(h/2)| / |e(h)| falls below a tenth for no order q. Smaller steps would decide it."
            }
            Rule::Open => {
                "Rounding changes the quantity by more than a tenth of its size. A shorter run would decide it."
            }
            Rule::Solves => {
                "The difference is no larger than the tolerance to which implicit equations are solved. A smaller tolerance would decide it."
            }
            Rule::AtRounding => {
                "Every error is as small as its rounding, so that there is no order to measure."
            }
            Rule::Elsewhere => "Successive runs converge to one another and not to the reference.",
            Rule::Kink => {
                "The error stays, and is another one in a run whose steps meet the kinks of a force elsewhere."
            }
            Rule::Jump => "From one run to the next the error falls more than any order explains.",
            Rule::Odd => {
                "A run of an odd number of steps has an error between those of the next coarser and the next finer run."
            }
            Rule::Generic => "In a generic scene at least one quantity has exactly the claimed order.",
            Rule::NoClaim => "A program claims no order. --order P says which one to judge.",
            Rule::FlipCount => "The three finest runs flip as many times as the reference.",
            Rule::NotSolved => {
                "An implicit equation is not solved at the finest step. A smaller step would decide it."
            }
            Rule::NoReference => "Without a reference solution nothing is judged.",
        }
    }
}
