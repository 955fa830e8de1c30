//! What was judged.

use serde::{Deserialize, Serialize};

use super::words::words;

words! {
    /// Whether a claim holds.
    Ruling {
        /// The claim holds.
        Pass = "pass",
        /// The claim does not hold.
        Fail = "fail",
        /// The measurement cannot decide.
        #[default]
        Inconclusive = "inconclusive",
        /// The claim says nothing about this scene.
        NotApplicable = "not-applicable",
        /// The run or its reference failed.
        Broken = "broken",
    }
}

words! {
    /// What a verdict is about: a claim of a card, or what every scheme and every reference is held to.
    ClaimName {
        /// The order of the error of each quantity.
        #[default]
        Order = "order",
        /// The same without torque.
        OrderWithoutTorque = "order-without-torque",
        /// The error of a solver that chooses its own steps.
        FollowsTolerance = "follows-tolerance",
        /// A quantity that is exact.
        Exact = "exact",
        /// The energy of a free body.
        Energy = "energy",
        /// L·g of a body on a pivot.
        VerticalMomentum = "vertical-momentum",
        /// The times of the flips of a tumbling body.
        FlipTimes = "flip-times",
        /// Distances between points of the body.
        Rigid = "rigid",
        /// The way there and back.
        Reversible = "reversible",
        /// The two-form of a step.
        Symplectic = "symplectic",
        /// The same motion in other worlds.
        Equivariant = "equivariant",
        /// Evaluations of the forces a step.
        Evaluations = "evaluations",
        /// Implicit equations a step.
        Solves = "solves",
        /// The error constant on record.
        Constant = "constant",
        /// Runs that converge to the truth where no order applies.
        Consistency = "consistency",
        /// Runs of a program under test that converge to the truth.
        Converges = "converges",
        /// The first state of a program under test.
        Start = "start",
        /// The least model beside the mass points.
        Reduction = "reduction",
        /// The limit of stability on record.
        Stability = "stability",
        /// That runs of a scheme without an order come to their end.
        Run = "run",
        /// The sources of a reference.
        ReferencesAgree = "references-agree",
        /// The conventions of a trajectory file.
        Frames = "frames",
    }
}

/// One claim, judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// What it is about.
    pub claim: ClaimName,
    /// Quantity that the claim is about.
    pub quantity: String,
    /// The ruling.
    pub verdict: Ruling,
    /// What was measured.
    pub measured: Option<f64>,
    /// Lower end of its uncertainty.
    pub low: Option<f64>,
    /// Upper end of its uncertainty.
    pub high: Option<f64>,
    /// The reason in words, with bound and unit.
    pub detail: String,
    /// Reason why this failure is known and does not fail the gate, if it is.
    #[serde(default)]
    pub known_deviation: Option<String>,
}
