//! Foreign programs under test: any program that speaks one JSON object a line on its standard input and output.
//!
//! An [`Engine`] is a command line that has said hello. As a [`Contestant`] it goes wherever a scheme of the list
//! goes: the same scenes, steps, references and gates. What it does wrong is a row with a reason, never an end of
//! the campaign: a reply that is late, cut, not JSON, of the wrong length or not finite breaks that run; the
//! engine is started once again, then given up.
//!
//! Every thread of a campaign has a copy of the program of its own. The order claim is the program's own `order`;
//! cost and evaluations are those that it reports (where it reports no time, the time from question to answer).

mod adapter;
mod check;
pub mod compare;
mod contract;
mod error;
mod files;
mod guard;
mod hello;
mod laws;
mod memory;
mod precision;
mod process;
mod remarks;
mod reply;
mod request;
mod specimen;
mod spread;
mod subject;

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use crate::claim::Claim;
use crate::model::{Broken, Snapshot, System};
use crate::schemes::Card;
use crate::simulate::{Break, Contestant, Outcome, Plan, Program};

pub use adapter::Language;
pub use check::{Finding, check};
pub use contract::{Clause, Conduct, Evidence, Judgement, hold};
pub use error::EngineError;
pub use memory::set_most_memory;
pub use process::end_all;

use error::Fault;
use hello::Hello;
use precision::Precision;
use process::Process;
use remarks::Oddest;
use reply::Answer;

/// What stands before the command line in the name of a scheme.
pub const PREFIX: &str = "engine:";

/// Milliseconds that an engine may take for an answer.
static PATIENCE: AtomicU64 = AtomicU64::new(60_000);

/// Sets how long an engine may take for an answer; the default is a minute.
pub fn set_patience(patience: Duration) {
    PATIENCE.store(patience.as_millis().clamp(1, u128::from(u64::MAX)) as u64, Ordering::Relaxed);
}

fn patience() -> Duration {
    Duration::from_millis(PATIENCE.load(Ordering::Relaxed))
}

/// Faults after which an engine is given up: one is followed by a new start.
const MOST_FAULTS: usize = 2;

/// A program that has said hello.
pub struct Engine {
    words: Vec<String>,
    hello: Hello,
    /// Fingerprint of its files when it was started.
    files: String,
    /// Copies that wait for a question.
    idle: Mutex<Vec<Process>>,
    faults: Mutex<Vec<String>>,
    asked: AtomicU64,
    precision: Mutex<Precision>,
    oddest: Mutex<Oddest>,
}

impl Engine {
    /// Starts the program of a command line, split as a shell would, and asks who it is.
    ///
    /// # Errors
    /// [`EngineError`]: it cannot be started, or does not say hello as the protocol has it.
    pub fn open(command: &str) -> Result<Engine, EngineError> {
        let words = words(command)?;
        let files = files::fingerprint(&words);
        let (process, hello) = greet(&words)
            .map_err(|why| EngineError::Hello { command: command.trim().to_owned(), why: why.to_string() })?;
        Ok(Engine {
            words,
            hello,
            files,
            idle: Mutex::new(vec![process]),
            faults: Mutex::default(),
            asked: AtomicU64::new(0),
            precision: Mutex::default(),
            oddest: Mutex::default(),
        })
    }

    /// The engine as something to be measured under `name`.
    pub fn contestant(self, name: &str) -> Contestant {
        let card = card(name, &self.hello);
        let takes = self.hello.forces.clone();
        let refusal = move |system: &System| hello::refusal(takes.as_deref(), system);
        let engine = Arc::new(self);
        let same = engine.clone();
        let run = move |system: &System, plan: &Plan, store: &mut dyn FnMut(&Snapshot)| {
            engine.run(system, plan, store)
        };
        Contestant::engine(card, refusal, run).by(move || same.program())
    }

    fn program(&self) -> Program {
        let precision = *lock(&self.precision);
        Program {
            single_precision: self.hello.single_precision() || precision.is_single(),
            digits: precision.digits(),
            files: self.files.clone(),
            remarks: lock(&self.oddest).remarks(&precision),
            ..self.hello.program()
        }
    }

    fn run(&self, system: &System, plan: &Plan, store: &mut dyn FnMut(&Snapshot)) -> Outcome {
        let asked = Instant::now();
        match self.ask(system, plan) {
            Ok(Answer::States(states)) => {
                lock(&self.precision).add(&states.precision);
                lock(&self.oddest).add(&states, plan.steps);
                states.states.iter().for_each(store);
                Outcome {
                    steps: plan.steps,
                    evaluations: states.evaluations,
                    nanoseconds: states.nanoseconds.unwrap_or_else(|| asked.elapsed().as_nanos() as u64),
                    broken: None,
                    ..Outcome::none_yet()
                }
            }
            Ok(Answer::Refused(why)) => broken(plan, 0, Broken::Refused(why.into())),
            Ok(Answer::Failed { why, step }) => {
                broken(plan, step.unwrap_or(0).min(plan.steps), Broken::Foreign(why.into()))
            }
            Err(Fault::Interrupted) => broken(plan, 0, Broken::Interrupted),
            Err(fault) => broken(plan, 0, Broken::Foreign(fault.to_string().into())),
        }
    }

    fn ask(&self, system: &System, plan: &Plan) -> Result<Answer, Fault> {
        let mut process = self.copy()?;
        let id = self.asked.fetch_add(1, Ordering::Relaxed) + 1;
        let request = request::run(id, system, plan);
        let answer = process
            .ask(&request, reply::most_bytes(plan), patience())
            .and_then(|line| reply::read(&line, id, system, plan));
        match answer {
            Ok(answer) => {
                lock(&self.idle).push(process);
                Ok(answer)
            }
            Err(fault) => Err(self.remember(process.blame(fault))),
        }
    }

    /// A copy that waits for a question, or a new one.
    fn copy(&self) -> Result<Process, Fault> {
        let faults = lock(&self.faults);
        if faults.len() >= MOST_FAULTS {
            return Err(Fault::GivenUp(faults.last().cloned().unwrap_or_default()));
        }
        drop(faults);
        if let Some(process) = lock(&self.idle).pop() {
            return Ok(process);
        }
        greet(&self.words).map(|(process, _)| process).map_err(|fault| self.remember(fault))
    }

    fn remember(&self, fault: Fault) -> Fault {
        if !matches!(fault, Fault::Interrupted | Fault::GivenUp(_)) {
            lock(&self.faults).push(fault.to_string());
        }
        fault
    }
}

impl Drop for Engine {
    fn drop(&mut self) {
        for process in lock(&self.idle).drain(..) {
            process.dismiss(&request::bye());
        }
    }
}

/// A command line as words, split as a shell would.
fn words(command: &str) -> Result<Vec<String>, EngineError> {
    match shlex::split(command) {
        Some(words) if !words.is_empty() => Ok(words),
        Some(_) => Err(EngineError::NoCommand),
        None => Err(EngineError::Quotes { command: command.to_owned() }),
    }
}

/// Words as a command line that [`Engine::open`] splits again.
pub fn join(words: &[String]) -> String {
    // Only a word with a zero byte cannot be quoted, and no argument of a program holds one.
    shlex::try_join(words.iter().map(String::as_str)).unwrap_or_else(|_| words.join(" "))
}

/// Starts the program and hears who it is.
fn greet(words: &[String]) -> Result<(Process, Hello), Fault> {
    let mut process = Process::start(words)?;
    let said = process.ask(&request::hello(), hello::MOST_BYTES, patience());
    match said.and_then(|line| hello::read(&line)) {
        Ok(hello) => Ok((process, hello)),
        Err(fault) => Err(process.blame(fault)),
    }
}

/// A card lives as long as the program: what an engine says of itself is kept for good, once an engine.
fn card(name: &str, hello: &Hello) -> Card {
    let keep = |text: String| -> &'static str { Box::leak(text.into_boxed_str()) };
    let claims: &'static [Claim] = match hello.order {
        Some(order) => Box::leak(Box::new([Claim::Order(order)])),
        None => &[],
    };
    Card {
        name: keep(name.to_owned()),
        title: keep(hello.title()),
        family: "foreign engines",
        source: "",
        claims,
    }
}

fn broken(plan: &Plan, step: u64, why: Broken) -> Outcome {
    let broken = Some(Break { step, time: step as f64 * plan.step, why });
    Outcome { steps: step.saturating_sub(1), broken, ..Outcome::none_yet() }
}

/// A lock that a panic elsewhere cannot take away.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}
