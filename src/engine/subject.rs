//! One program under test, asked for one run after another in a separate process.

use super::error::Fault;
use super::hello::{self, Hello};
use super::process::Process;
use super::reply::{self, Answer, States};
use super::{EngineError, greet, patience, request, words};
use crate::model::System;
use crate::simulate::Plan;

/// Why a run gave no states.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(super) enum NoStates {
    /// The program does not take the scene, and says so.
    #[error("refused: {0}")]
    Refused(String),
    /// The program took the scene and says that the run broke.
    #[error("failed: {0}")]
    Failed(String),
    /// The answer is against the protocol, late or missing.
    #[error("{0}")]
    Fault(String),
    /// The user asked for the end, or there is no truth to compare with.
    #[error("{0}")]
    NotAsked(String),
}

/// A program under test.
pub(super) struct Subject {
    words: Vec<String>,
    hello: Hello,
    running: Option<Process>,
    asked: u64,
}

impl Subject {
    /// Starts the program of a command line.
    ///
    /// # Errors
    /// [`EngineError`]: it cannot be started, or does not say hello as the protocol has it.
    pub fn open(command: &str) -> Result<Subject, EngineError> {
        let words = words(command)?;
        let (process, hello) = greet(&words)
            .map_err(|why| EngineError::Hello { command: command.trim().to_owned(), why: why.to_string() })?;
        Ok(Subject { words, hello, running: Some(process), asked: 0 })
    }

    /// Whether the program says that it computes in single precision.
    pub fn single_precision(&self) -> bool {
        self.hello.single_precision()
    }

    /// Ends the process, so that the next run is the first one of a new process.
    pub fn restart(&mut self) {
        if let Some(process) = self.running.take() {
            process.dismiss(&request::bye());
        }
    }

    /// A run in the present process, or in a new one where there is none. A process that breaks the protocol is
    /// ended.
    ///
    /// # Errors
    /// [`NoStates`].
    pub fn run(&mut self, system: &System, plan: &Plan) -> Result<States, NoStates> {
        if let Some(why) = hello::refusal(self.hello.forces.as_deref(), system) {
            return Err(NoStates::Refused(why));
        }
        match self.ask(system, plan) {
            Ok(Answer::States(states)) => Ok(states),
            Ok(Answer::Refused(why)) => Err(NoStates::Refused(why)),
            Ok(Answer::Failed { why, .. }) => Err(NoStates::Failed(why)),
            Err(Fault::Interrupted) => Err(NoStates::NotAsked(Fault::Interrupted.to_string())),
            Err(fault) => Err(NoStates::Fault(fault.to_string())),
        }
    }

    fn ask(&mut self, system: &System, plan: &Plan) -> Result<Answer, Fault> {
        let mut process = match self.running.take() {
            Some(process) => process,
            None => greet(&self.words)?.0,
        };
        self.asked += 1;
        let answer = process
            .ask(&request::run(self.asked, system, plan), reply::most_bytes(plan), patience())
            .and_then(|line| reply::read(&line, self.asked, system, plan));
        match answer {
            Ok(answer) => {
                self.running = Some(process);
                Ok(answer)
            }
            Err(fault) => Err(process.blame(fault)),
        }
    }
}

impl Drop for Subject {
    fn drop(&mut self) {
        self.restart();
    }
}
