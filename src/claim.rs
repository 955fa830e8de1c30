//! What a scheme may promise. Every promise is a [`Claim`], and every claim owns a gate: `gates` matches on
//! this enumeration exhaustively, so a claim without a gate does not compile.

use std::fmt;

use serde::{Deserialize, Serialize};

pub use crate::quantity::Quantity;
use crate::words::words;

/// Scenes that a promise of exactness is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum When {
    /// No force and no torque: U_cm is constant and X_cm moves straight.
    NoForce,
    /// The force on the centre of mass is constant.
    ConstantForce,
    /// No torque about the centre of mass, and no pivot.
    NoTorque,
    /// No torque, and Ω constant: a sphere, a rod, a spin about a principal axis.
    SteadySpin,
    /// No torque, and two principal moments equal.
    SymmetricBody,
}

impl fmt::Display for When {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            When::NoForce => "without force",
            When::ConstantForce => "under a constant force",
            When::NoTorque => "without torque",
            When::SteadySpin => "in a steady spin (sphere, rod, principal axis)",
            When::SymmetricBody => "for a free symmetric body",
        })
    }
}

/// How the rotational energy of a free body changes over a long run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EnergyOfFreeBody {
    /// Grows at a rate of this order in the step, towards L²/(2 I_min) and never past it.
    GrowsSecularly {
        /// Order in h of dE/dt.
        rate_order: u32,
    },
    /// Grows or falls, depending on the body, at a rate of this order in the step.
    Secular {
        /// Order in h of dE/dt.
        rate_order: u32,
    },
    /// Oscillates, without a secular part.
    Bounded,
    /// Stays, but for rounding.
    Constant,
    /// Falls, towards L²/(2 I_max), or stays where the spin is steady.
    Falls,
}

/// A promise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Claim {
    /// The error of every quantity falls at least as hᵖ, and in a generic scene exactly so, with the constant that is on record.
    Order(u32),
    /// Without torque the order is this one instead.
    OrderWithoutTorque(u32),
    /// The runs converge, to another motion than that of the scene.
    SolvesAnotherMotion,
    /// The scheme chooses its own steps for a tolerance, which the step h of a plan stands for as hⁿ, and its error follows it.
    FollowsTolerance(u32),
    /// A quantity is exact but for rounding.
    Exact(Quantity, When),
    /// Energy of a free body.
    Energy(EnergyOfFreeBody),
    /// L·g of a body turning about a pivot under uniform gravity is constant: every torque is across g.
    VerticalMomentum,
    /// Flips of a tumbling body come at their exact times as h → 0.
    FlipTimes,
    /// Distances between points of the body change by rounding only.
    Rigid,
    /// A run with −h from where a run with h ended returns to its start.
    Reversible,
    /// One step leaves the canonical two-form where it was.
    Symplectic,
    /// Turned, mirrored, shifted and boosted worlds, other units, and the same body told in another way give the same motion.
    Equivariant,
    /// This many evaluations of the forces a step, exactly.
    Evaluations(u32),
    /// This many implicit equations are solved a step, exactly.
    Solves(u32),
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
        /// The order on record.
        OrderOnRecord = "order-on-record",
        /// The error of every run of the same step on record.
        ErrorOnRecord = "error-on-record",
        /// The drift of the energy on record.
        DriftOnRecord = "drift-on-record",
        /// Evaluations of the forces in every run of the same step on record.
        WorkOnRecord = "work-on-record",
        /// The claims on record.
        ClaimsOnRecord = "claims-on-record",
        /// Runs that converge to the truth, in every scene.
        #[serde(alias = "consistency")]
        Converges = "converges",
        /// The first state of a run.
        Start = "start",
        /// The least model beside the mass points.
        Reduction = "reduction",
        /// The limit of stability on record.
        Stability = "stability",
        /// That runs of a scheme without an order come to their end.
        Run = "run",
        /// The time that the user gives.
        Budget = "budget",
        /// The sources of a reference.
        ReferencesAgree = "references-agree",
        /// The conventions of a trajectory file.
        Frames = "frames",
    }
}

impl ClaimName {
    /// The rule by which it is judged, in a sentence.
    pub fn explained(self) -> &'static str {
        match self {
            ClaimName::Order => {
                "The error of each quantity falls with at least the claimed order as h is halved, and with exactly that order in generic scenes."
            }
            ClaimName::OrderWithoutTorque => "The order that a scheme has in scenes without torque.",
            ClaimName::FollowsTolerance => {
                "The error of a solver that chooses its steps falls with the tolerance as its card says."
            }
            ClaimName::Exact => "The error of the quantity is at its rounding at every step.",
            ClaimName::Energy => "The energy of a free body changes over a long run as the card says.",
            ClaimName::VerticalMomentum => {
                "L·g of a body on a pivot under uniform gravity changes by rounding only."
            }
            ClaimName::FlipTimes => {
                "The flips of a tumbling body come at their exact times as h falls, and in their number."
            }
            ClaimName::Rigid => "Distances between points of the body change by rounding only.",
            ClaimName::Reversible => {
                "A run with -h from the end of a run with h returns to its start, to rounding."
            }
            ClaimName::Symplectic => "One step preserves the canonical two-form, to rounding.",
            ClaimName::Equivariant => {
                "Turned, mirrored, shifted and boosted worlds and other units give the same motion, to rounding."
            }
            ClaimName::Evaluations => "A step takes the number of force evaluations that the card says.",
            ClaimName::Solves => "A step solves the number of implicit equations that the card says.",
            ClaimName::Constant => {
                "The error constant C of C h^p is within 1 % of the one on record, or within the tolerance of polhode.toml. It is not judged where the order differs."
            }
            ClaimName::OrderOnRecord => {
                "The order is not below the one in the baseline, whatever the scheme claims today."
            }
            ClaimName::ErrorOnRecord => {
                "The error of every run is that of the same step in the baseline, to a half, or to the tolerance of polhode.toml, and to rounding."
            }
            ClaimName::DriftOnRecord => {
                "The drift of the energy is of no worse kind than in the baseline, and no rate is larger by more than a tenth."
            }
            ClaimName::WorkOnRecord => {
                "No run takes more force evaluations than that of the same step in the baseline, to 1 %."
            }
            ClaimName::ClaimsOnRecord => {
                "Every claim in the baseline is still made. An order may be claimed higher than there."
            }
            ClaimName::Converges => {
                "The runs converge to the motion of the scene. Runs that converge to another motion fail, in every scene."
            }
            ClaimName::Start => {
                "The first state of a run is the start of the scene, to the digits that are printed."
            }
            ClaimName::Reduction => "The least model and the mass points give the same motion, to rounding.",
            ClaimName::Stability => "The limit of stability on a spring-held body is the one on record.",
            ClaimName::Run => "Runs come to their end.",
            ClaimName::Budget => {
                "The time that --budget gives is enough for the runs that decide. A larger one decides what is named."
            }
            ClaimName::ReferencesAgree => "The sources of a reference agree within their uncertainties.",
            ClaimName::Frames => {
                "A trajectory file follows the conventions for its axes that it is read with."
            }
        }
    }

    /// Whether it compares what was measured with what is on record.
    pub fn is_on_record(self) -> bool {
        matches!(
            self,
            ClaimName::Constant
                | ClaimName::OrderOnRecord
                | ClaimName::ErrorOnRecord
                | ClaimName::DriftOnRecord
                | ClaimName::WorkOnRecord
                | ClaimName::ClaimsOnRecord
        )
    }
}

impl Claim {
    /// Name of the claim in verdicts.
    pub fn name(self) -> ClaimName {
        match self {
            Claim::Order(_) => ClaimName::Order,
            Claim::OrderWithoutTorque(_) => ClaimName::OrderWithoutTorque,
            Claim::SolvesAnotherMotion => ClaimName::Converges,
            Claim::FollowsTolerance(_) => ClaimName::FollowsTolerance,
            Claim::Exact(..) => ClaimName::Exact,
            Claim::Energy(_) => ClaimName::Energy,
            Claim::VerticalMomentum => ClaimName::VerticalMomentum,
            Claim::FlipTimes => ClaimName::FlipTimes,
            Claim::Rigid => ClaimName::Rigid,
            Claim::Reversible => ClaimName::Reversible,
            Claim::Symplectic => ClaimName::Symplectic,
            Claim::Equivariant => ClaimName::Equivariant,
            Claim::Evaluations(_) => ClaimName::Evaluations,
            Claim::Solves(_) => ClaimName::Solves,
        }
    }

    /// Whether what keeps this claim keeps the other.
    pub fn contains(self, other: Claim) -> bool {
        match (self, other) {
            (Claim::Order(own), Claim::Order(other))
            | (Claim::OrderWithoutTorque(own), Claim::OrderWithoutTorque(other)) => own >= other,
            (own, other) => own == other,
        }
    }
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Claim::Order(order) => write!(f, "order {order} in every quantity, constants as recorded"),
            Claim::OrderWithoutTorque(order) => write!(f, "order {order} without torque"),
            Claim::SolvesAnotherMotion => write!(f, "converges to another motion than that of the scene"),
            Claim::Exact(quantity, when) => write!(f, "{} exact {when}", quantity.name()),
            Claim::Energy(energy) => write!(f, "energy of a free body {energy}"),
            Claim::FollowsTolerance(power) => {
                write!(f, "steps of its own for a tolerance ∝ h^{power}, which the error follows")
            }
            Claim::VerticalMomentum => write!(f, "L·g of a top on a pivot exact"),
            Claim::FlipTimes => write!(f, "flips of a tumbling body at their exact times as h → 0"),
            Claim::Rigid => write!(f, "rigid to rounding"),
            Claim::Reversible => write!(f, "reversible: back to the start with −h"),
            Claim::Symplectic => write!(f, "symplectic"),
            Claim::Equivariant => {
                write!(f, "the same in turned, mirrored, shifted, boosted worlds and other units")
            }
            Claim::Evaluations(count) => {
                write!(f, "{count} force evaluation{} a step", if *count == 1 { "" } else { "s" })
            }
            Claim::Solves(count) => {
                write!(f, "{count} implicit equation{} solved a step", if *count == 1 { "" } else { "s" })
            }
        }
    }
}

impl fmt::Display for EnergyOfFreeBody {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let power = |order: u32| if order == 1 { "h".to_owned() } else { format!("h^{order}") };
        match self {
            EnergyOfFreeBody::GrowsSecularly { rate_order } => {
                write!(f, "grows at a rate ∝ {}, never past L²/(2 I_min)", power(*rate_order))
            }
            EnergyOfFreeBody::Secular { rate_order } => {
                write!(f, "grows or falls at a rate ∝ {}", power(*rate_order))
            }
            EnergyOfFreeBody::Bounded => write!(f, "oscillates without drift"),
            EnergyOfFreeBody::Constant => write!(f, "constant to rounding"),
            EnergyOfFreeBody::Falls => write!(f, "falls towards L²/(2 I_max)"),
        }
    }
}
