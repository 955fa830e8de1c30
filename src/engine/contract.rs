//! The contract: what a program that steps rigid bodies must do whatever its scheme and its order.
//!
//! Each clause is run in up to two scenes that the program takes: a free body, and a body under forces. A clause whose
//! scenes are all refused is not applicable.

mod clauses;

use super::EngineError;
use super::specimen;
use super::spread::Grain;
use super::subject::{NoStates, Subject};
use crate::model::System;
use crate::scenes::Scene;
use crate::simulate::Plan;

/// One clause of the contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Clause {
    /// A step of zero length.
    ZeroStep,
    /// One run in two parts, in one process.
    TwoParts,
    /// One run in two parts, the second in a new process.
    Restart,
    /// The same request twice in one process.
    SameTwice,
    /// The same request to two processes.
    TwoCopies,
    /// A slow motion for a long time.
    Moves,
    /// Energies, positions and velocities at a small step.
    SaneNumbers,
    /// One body described in three ways.
    DescribedAlike,
}

impl Clause {
    /// All clauses, in the order in which they are checked.
    pub const ALL: [Clause; 8] = [
        Clause::ZeroStep,
        Clause::TwoParts,
        Clause::Restart,
        Clause::SameTwice,
        Clause::TwoCopies,
        Clause::Moves,
        Clause::SaneNumbers,
        Clause::DescribedAlike,
    ];

    /// Stable name, kebab-case.
    pub fn name(self) -> &'static str {
        match self {
            Clause::ZeroStep => "zero-step",
            Clause::TwoParts => "two-parts",
            Clause::Restart => "restart",
            Clause::SameTwice => "same-twice",
            Clause::TwoCopies => "two-copies",
            Clause::Moves => "moves",
            Clause::SaneNumbers => "sane-numbers",
            Clause::DescribedAlike => "described-alike",
        }
    }

    /// What the clause says, in one sentence without a full stop.
    pub fn sentence(self) -> &'static str {
        match self {
            Clause::ZeroStep => {
                "a step of zero length leaves the state where it was, or is refused with a reason"
            }
            Clause::TwoParts => "n steps, and n more from the returned state, give what 2 n steps give",
            Clause::Restart => {
                "n steps, and n more from the returned state in a new process, give what 2 n steps give"
            }
            Clause::SameTwice => "one process gives the same numbers to the last bit when it is asked twice",
            Clause::TwoCopies => "two processes give the same numbers to the last bit",
            Clause::Moves => "a slow motion is neither frozen nor put to sleep",
            Clause::SaneNumbers => {
                "at a small step the energy of a free body, positions and velocities stay within bounds"
            }
            Clause::DescribedAlike => {
                "a body moves alike in other body axes, with its points in another order, and with a point split in two"
            }
        }
    }

    /// What a failure points to.
    fn remark(self) -> &'static str {
        match self {
            Clause::ZeroStep => "the step moves the body, or divides by its length",
            Clause::TwoParts => {
                "the program keeps a history: its next step needs more than the returned state, as in a multistep method"
            }
            Clause::Restart => {
                "the program keeps a history that a new process does not have: the returned state is not the whole state"
            }
            Clause::SameTwice => "an earlier request, a clock or a random number changes the answer",
            Clause::TwoCopies => "the process, a clock or a random number changes the answer",
            Clause::Moves => "the body is frozen, asleep or damped, or steps are lost",
            Clause::SaneNumbers => "the numbers are finite but not those of a motion",
            Clause::DescribedAlike => "the motion depends on how the body is described",
        }
    }
}

/// How a program keeps to a clause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conduct {
    /// It keeps to it.
    Holds,
    /// It does not.
    Fails,
    /// It takes none of the scenes of the clause.
    NotApplicable,
}

/// What was seen of a clause.
#[derive(Clone, Debug, PartialEq)]
pub enum Evidence {
    /// A size and its limit.
    Size {
        /// What was measured.
        what: String,
        /// How large it is, in `unit`; it may be NaN.
        size: f64,
        /// How large it may be, in `unit`.
        limit: f64,
        /// Unit of both.
        unit: &'static str,
    },
    /// The program refused with a reason, which the clause allows.
    RefusedAloud(String),
    /// The program gave no states where the clause asks for some.
    NoStates(String),
    /// The program does not take the scene.
    NotTaken(String),
}

impl Evidence {
    /// What the evidence says of the clause.
    pub fn conduct(&self) -> Conduct {
        match self {
            Evidence::Size { size, limit, .. } if size <= limit => Conduct::Holds,
            Evidence::Size { .. } | Evidence::NoStates(_) => Conduct::Fails,
            Evidence::RefusedAloud(_) => Conduct::Holds,
            Evidence::NotTaken(_) => Conduct::NotApplicable,
        }
    }

    /// Size over limit, for finding the worst of several; 0 for a size of 0.
    fn severity(&self) -> f64 {
        match self {
            Evidence::Size { size: 0.0, .. } => 0.0,
            Evidence::Size { size, limit, .. } if size.is_finite() => size / limit,
            Evidence::Size { .. } | Evidence::NoStates(_) => f64::INFINITY,
            Evidence::RefusedAloud(_) => 0.0,
            Evidence::NotTaken(_) => -1.0,
        }
    }
}

impl From<NoStates> for Evidence {
    fn from(why: NoStates) -> Evidence {
        match why {
            NoStates::Refused(_) | NoStates::NotAsked(_) => Evidence::NotTaken(why.to_string()),
            NoStates::Failed(_) | NoStates::Fault(_) => Evidence::NoStates(why.to_string()),
        }
    }
}

/// What was found of one clause: the worst of its scenes.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The clause.
    pub clause: Clause,
    /// The scene in which it was seen.
    pub scene: String,
    /// What was seen.
    pub evidence: Evidence,
}

impl Judgement {
    /// How the program keeps to the clause.
    pub fn conduct(&self) -> Conduct {
        self.evidence.conduct()
    }

    /// The evidence in words: size, unit, limit and scene; after a failure also what it points to.
    pub fn words(&self) -> String {
        let (scene, remark) = (&self.scene, self.clause.remark());
        let seen = match &self.evidence {
            Evidence::Size { what, size, limit, unit } => {
                format!("{what} {} {unit}, limit {} {unit}, in {scene}", number(*size), number(*limit))
            }
            Evidence::RefusedAloud(why) | Evidence::NoStates(why) => format!("{why}, in {scene}"),
            Evidence::NotTaken(why) => format!("{why} ({scene})"),
        };
        if self.conduct() == Conduct::Fails { format!("{seen}; {remark}") } else { seen }
    }
}

/// Three digits of a number.
fn number(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.2e}") }
}

/// A scene of the contract.
struct Stage {
    name: &'static str,
    system: System,
    grain: Grain,
}

/// Step of the runs [s]: the bodies of the scenes turn by less than 0.025 rad in it.
const STEP: f64 = 0.01;
/// Steps of a part of a run.
const PART: u64 = 50;

/// A whole run: two parts.
const WHOLE: Plan = Plan { step: STEP, steps: 2 * PART, every: 2 };

/// Holds the program of a command line to the contract; a judgement for each clause.
///
/// # Errors
/// [`EngineError`]: the program cannot be started, or does not say hello.
pub fn hold(command: &str) -> Result<Vec<Judgement>, EngineError> {
    let mut subject = Subject::open(command)?;
    let free = free();
    let (stages, refusals) = stages(&mut subject, &free);
    let judgements = Clause::ALL.into_iter().map(|clause| {
        let seen = clauses::see(clause, &mut subject, &stages);
        let seen = seen.into_iter().chain(refusals.iter().cloned());
        let worst = seen.reduce(|a, b| if b.1.severity() > a.1.severity() { b } else { a });
        let (scene, evidence) = worst.unwrap_or_else(nothing);
        Judgement { clause, scene, evidence }
    });
    Ok(judgements.collect())
}

/// No scene to look at, which [`stages`] rules out.
fn nothing() -> (String, Evidence) {
    (String::new(), Evidence::NotTaken("there is no scene".to_owned()))
}

/// The free body, and the first body under forces that the program takes; the refusals of the others.
fn stages(subject: &mut Subject, free: &System) -> (Vec<Stage>, Vec<(String, Evidence)>) {
    let mut stages = Vec::new();
    let mut refusals = Vec::new();
    let forced = [
        ("tether-springs", built_in("tether-springs")),
        ("gravity-drag", built_in("gravity-drag")),
        ("a body under gravity", specimen::scene(&specimen::law("gravity"), "")),
    ];
    let mut with_forces = false;
    for (name, system) in [("free-asymmetric", free.clone())].into_iter().chain(forced) {
        let is_forced = !system.forces.laws().is_empty();
        if is_forced && with_forces {
            continue;
        }
        let grain = match subject.run(&system, &WHOLE) {
            Ok(states) => Grain::of(subject, &states),
            Err(why @ (NoStates::Refused(_) | NoStates::NotAsked(_))) => {
                refusals.push((name.to_owned(), why.into()));
                continue;
            }
            // The clauses meet the fault again and say so.
            Err(_) => Grain::DOUBLE,
        };
        with_forces |= is_forced;
        stages.push(Stage { name, system, grain });
    }
    (stages, refusals)
}

/// The generic free body.
fn free() -> System {
    built_in("free-asymmetric")
}

/// The system of a built-in scene.
///
/// # Panics
/// There is no such scene, which a test rules out.
fn built_in(name: &str) -> System {
    Scene::find(name).expect("a built-in scene").system
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn clauses_have_names_of_their_own_and_sentences() {
        let names: BTreeSet<&str> = Clause::ALL.iter().map(|clause| clause.name()).collect();
        assert_eq!(names.len(), Clause::ALL.len());
        assert!(Clause::ALL.iter().all(|clause| !clause.sentence().ends_with('.')));
    }

    #[test]
    fn the_scenes_of_the_contract_are_built_in() {
        let of_the_check = specimen::scene(&specimen::law("gravity"), "");
        let built_in = ["free-asymmetric", "tether-springs", "gravity-drag"].map(built_in);
        for system in built_in.into_iter().chain([of_the_check]) {
            let start = system.start;
            let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
            let spin = system.body.inverse_inertia() * momentum;
            assert!(crate::rotation::length(&spin) * STEP < 0.025, "{spin}");
        }
    }

    #[test]
    fn a_size_that_is_no_number_fails_and_is_the_worst() {
        let size = |size, limit| Evidence::Size { what: String::new(), size, limit, unit: "m" };
        assert_eq!(size(f64::NAN, 1.0).conduct(), Conduct::Fails);
        assert_eq!(size(0.0, 0.0).conduct(), Conduct::Holds);
        assert!(size(f64::NAN, 1.0).severity() > size(3.0, 1.0).severity());
        assert!(size(0.0, 0.0).severity() > Evidence::NotTaken(String::new()).severity());
        assert_eq!(size(1e-300, 0.0).conduct(), Conduct::Fails);
    }
}
