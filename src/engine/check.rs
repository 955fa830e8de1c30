//! The conformance run: what the protocol says, line by line, and whether an engine keeps to it.

use std::time::Duration;

use super::error::Fault;
use super::hello::Hello;
use super::process::Process;
use super::remarks::Oddest;
use super::reply::{self, Answer, States};
use super::specimen::{self, scene};
use super::{EngineError, greet, patience, request, words};
use crate::model::forces::Law;
use crate::model::{Broken, Quantity, System, difference};
use crate::simulate::Plan;

/// One sentence of the protocol, held against an engine.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What the protocol says.
    pub rule: String,
    /// What the engine did instead; `None` where it keeps to it.
    pub violation: Option<String>,
    /// What was seen, or what is missing and allowed to be.
    pub seen: String,
}

/// Time that an engine has to end by itself.
const FAREWELL: Duration = Duration::from_secs(5);
/// Difference of the first state from the start: single precision passes.
const SAME_START: f64 = 1e-5;
/// Orientation error [rad] after a second in a thousand steps, above which the motion is another one: a rule of
/// first order stays below it, a wrong frame does not.
const OTHER_MOTION: f64 = 0.05;

/// Difference of two states of one run that rounding, and an error control that begins anew, explain.
const SAME_END: f64 = 1e-9;

/// Holds the program of a command line against the protocol.
///
/// # Errors
/// [`EngineError`]: there is no such program.
pub fn check(command: &str) -> Result<Vec<Finding>, EngineError> {
    let mut inquiry = Inquiry { words: words(command)?, findings: Vec::new(), running: None };
    let rule = "{\"polhode\":1,\"ask\":\"hello\"} is answered by polhode 1, a name, and where it has them version, \
                scheme, order and forces";
    match greet(&inquiry.words) {
        Ok((process, hello)) => {
            inquiry.running = Some(process);
            inquiry.keeps(rule, hello.title());
            inquiry.all(&hello);
            Ok(inquiry.findings)
        }
        Err(Fault::NotStarted { program, why }) => {
            Err(EngineError::Hello { command: command.to_owned(), why: format!("{program}: {why}") })
        }
        Err(fault) => {
            inquiry.breaks(rule, fault.to_string());
            Ok(inquiry.findings)
        }
    }
}

struct Inquiry {
    words: Vec<String>,
    findings: Vec<Finding>,
    running: Option<Process>,
}

impl Inquiry {
    fn keeps(&mut self, rule: &str, seen: impl Into<String>) {
        self.findings.push(Finding { rule: rule.to_owned(), violation: None, seen: seen.into() });
    }

    fn breaks(&mut self, rule: &str, violation: impl Into<String>) {
        let violation = Some(violation.into());
        self.findings.push(Finding { rule: rule.to_owned(), violation, seen: String::new() });
    }

    fn finds(&mut self, rule: &str, found: Result<String, String>) {
        match found {
            Ok(seen) => self.keeps(rule, seen),
            Err(violation) => self.breaks(rule, violation),
        }
    }

    fn all(&mut self, hello: &Hello) {
        self.finds("\"forces\" lists laws of scene files", known_laws(hello));
        let free = scene("", "");
        let steps = 10;
        let run = self.run(&free, steps, 4);
        self.finds(
            "a run is answered by the states of step 0, of every K-th and of the last, finite, with all their numbers",
            run.as_ref().map(|states| format!("{} states", states.states.len())).map_err(Clone::clone),
        );
        if let Ok(states) = run {
            self.finds("the state of step 0 is the initial one", starts_there(&free, &states));
            self.keeps("elapsed_ns and evaluations say what the run cost", costs(&states));
            let mut oddest = Oddest::default();
            oddest.add(&states, steps);
            let remarks = oddest.remarks(&states.precision);
            let seen = if remarks.is_empty() { "none".to_owned() } else { remarks.join("; ") };
            self.keeps(
                "quaternions off unit length, runs of 0 ns, steps without an evaluation: remarks, no faults",
                seen,
            );
            let found = self.moves_as_it_should(&free);
            self.finds(
                "position is X_cm; orientation takes body to world; both velocities are in world axes",
                found,
            );
        }
        let found = self.looks_without_touching(&free);
        self.finds("which states are asked for does not change them", found);
        self.laws(hello);
        let found = self.survives("", "pivot = [0.1, 0.2, -0.3]");
        self.finds("a scene that it cannot take is refused with a reason: a pivot", found);
        let found = self.answers_two(&free);
        self.finds(
            "questions may be sent before the last is answered; answers keep their order and id",
            found,
        );
        let found = self.ends(true);
        self.finds("{\"polhode\":1,\"ask\":\"bye\"} ends the engine", found);
        let found = self.ends(false);
        self.finds("the end of its input ends the engine", found);
    }

    /// The program, started again where it has gone.
    fn process(&mut self) -> Result<Process, Fault> {
        match self.running.take() {
            Some(process) => Ok(process),
            None => greet(&self.words).map(|(process, _)| process),
        }
    }

    fn ask(&mut self, system: &System, plan: &Plan) -> Result<Answer, String> {
        let mut process = self.process().map_err(|fault| fault.to_string())?;
        let answer = process
            .ask(&request::run(7, system, plan), reply::most_bytes(plan), patience())
            .and_then(|line| reply::read(&line, 7, system, plan));
        match answer {
            Ok(answer) => {
                self.running = Some(process);
                Ok(answer)
            }
            Err(fault) => Err(process.blame(fault).to_string()),
        }
    }

    fn run(&mut self, system: &System, steps: u64, every: u64) -> Result<States, String> {
        self.run_by(system, &Plan { step: 1.0 / steps as f64, steps, every })
    }

    fn run_by(&mut self, system: &System, plan: &Plan) -> Result<States, String> {
        match self.ask(system, plan)? {
            Answer::States(states) => Ok(states),
            Answer::Refused(why) => Err(format!("a free body was refused: {why}")),
            Answer::Failed { why, .. } => Err(format!("a free body failed: {why}")),
        }
    }

    /// A second of a free body beside its exact motion.
    fn moves_as_it_should(&mut self, free: &System) -> Result<String, String> {
        let run = self.run(free, 1000, 1000)?;
        let truth = crate::ode::dop853::solve(free, &[1.0], crate::ode::dop853::TOLERANCE)
            .map_err(|error| error.to_string())?;
        let last = run.states.last().ok_or(Broken::NotFinite.to_string())?;
        let apart = difference(&free.body, last, &truth.states[0]);
        let [position, velocity] = [apart[Quantity::Position], apart[Quantity::Velocity]];
        let [orientation, spin] = [apart[Quantity::Orientation], apart[Quantity::AngularVelocity]];
        let seen = format!(
            "after 1 s in 1,000 steps off by {position:.1e} m, {velocity:.1e} m/s, {orientation:.1e} rad, {spin:.1e} rad/s"
        );
        let largest = [position, velocity, orientation, spin].into_iter().fold(0.0, f64::max);
        if largest < OTHER_MOTION { Ok(seen) } else { Err(format!("{seen}: that is another motion")) }
    }

    /// Every state of a run that is looked at at each step, beside the ends of runs that are not.
    fn looks_without_touching(&mut self, free: &System) -> Result<String, String> {
        let plan = |steps, every| Plan { step: 0.01, steps, every };
        let often = self.run_by(free, &plan(100, 1))?;
        let mut largest: f64 = 0.0;
        for steps in [1, 50, 100] {
            let once = self.run_by(free, &plan(steps, steps))?;
            let (Some(a), Some(b)) = (often.states.get(steps as usize), once.states.last()) else {
                return Err("there is no state".to_owned());
            };
            let apart = difference(&free.body, a, b).values().copied().fold(0.0, f64::max);
            if apart.is_nan() || apart > SAME_END {
                return Err(format!(
                    "with every 1 the state of step {steps} differs by {apart:.1e} from the end of a run of {steps} steps"
                ));
            }
            largest = largest.max(apart);
        }
        Ok(format!("states on the way and ends of shorter runs agree to {largest:.1e}"))
    }

    fn laws(&mut self, hello: &Hello) {
        let listed = hello.forces.clone().unwrap_or_default();
        for law in Law::ALL.iter().map(|law| law.name) {
            if hello.forces.is_some() && !listed.iter().any(|name| name == law) {
                continue;
            }
            let found = self.survives(&specimen::law(law), "");
            self.finds(&format!("a scene with the law '{law}' is run, or refused with a reason"), found);
        }
    }

    fn survives(&mut self, forces: &str, pivot: &str) -> Result<String, String> {
        match self.ask(&scene(forces, pivot), &Plan { step: 0.01, steps: 4, every: 1 })? {
            Answer::States(_) => Ok("run".to_owned()),
            Answer::Refused(why) if why.trim().is_empty() => Err("refused without a reason".to_owned()),
            Answer::Refused(why) => Ok(format!("refused: {why}")),
            Answer::Failed { why, .. } => Err(format!("failed: {why}")),
        }
    }

    fn answers_two(&mut self, free: &System) -> Result<String, String> {
        let plan = Plan { step: 0.01, steps: 4, every: 2 };
        let mut process = self.process().map_err(|fault| fault.to_string())?;
        process.send(&request::run(8, free, &plan));
        let first = process.ask(&request::run(9, free, &plan), reply::most_bytes(&plan), patience());
        let read = |line: Result<Vec<u8>, Fault>, id| line.and_then(|l| reply::read(&l, id, free, &plan));
        let both = read(first, 8).and_then(|_| read(process.listen(patience()), 9));
        match both {
            Ok(_) => {
                self.running = Some(process);
                Ok("two questions, two answers".to_owned())
            }
            Err(fault) => Err(process.blame(fault).to_string()),
        }
    }

    fn ends(&mut self, asked: bool) -> Result<String, String> {
        let mut process = self.process().map_err(|fault| fault.to_string())?;
        if asked {
            process.send(&request::bye());
        } else {
            process.close();
        }
        if process.ends_within(FAREWELL) {
            return Ok("it ended by itself".to_owned());
        }
        Err(format!("it still ran {} s later and had to be killed", FAREWELL.as_secs()))
    }
}

fn known_laws(hello: &Hello) -> Result<String, String> {
    let Some(listed) = &hello.forces else {
        return Ok("no list: it is asked about every scene, and may refuse".to_owned());
    };
    let known = |name: &&String| Law::ALL.iter().any(|law| law.name == name.as_str());
    match listed.iter().find(|name| !known(name)) {
        None => Ok(if listed.is_empty() { "none".to_owned() } else { listed.join(", ") }),
        Some(other) => {
            let names: Vec<_> = Law::ALL.iter().map(|law| law.name).collect();
            Err(format!("there is no law '{other}'; the laws are {}", names.join(", ")))
        }
    }
}

fn starts_there(free: &System, states: &States) -> Result<String, String> {
    let first = states.states.first().ok_or_else(|| "there is no state".to_owned())?;
    let (position, orientation) = reply::off_start(free, first);
    let spin =
        (first.angular_momentum - free.start.angular_momentum).norm() / free.start.angular_momentum.norm();
    let velocity = (first.velocity - free.start.velocity).norm() / free.start.velocity.norm();
    let off = [
        ("position", position),
        ("velocity", velocity),
        ("orientation", orientation),
        ("angular_velocity", spin),
    ];
    match off.into_iter().find(|(_, by)| by.is_nan() || *by > SAME_START) {
        None => Ok("it is".to_owned()),
        Some((key, by)) => Err(format!("its {key} is off by {by:.1e}, relative")),
    }
}

fn costs(states: &States) -> String {
    match (states.nanoseconds, states.evaluations) {
        (None, _) => "no elapsed_ns: the time from question to answer stands in for it".to_owned(),
        (Some(time), 0) => format!("{time} ns; no evaluations"),
        (Some(time), count) => format!("{time} ns, {count} evaluations"),
    }
}
