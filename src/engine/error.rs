//! What can go wrong with an engine: before it runs, and while it runs.

use std::time::Duration;

/// An engine that cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// No word after the prefix.
    #[error("an engine needs a command line: write --scheme 'engine:python3 my_engine.py'")]
    NoCommand,
    /// Quotes that do not close.
    #[error("the quotes of this command line do not close: {command}")]
    Quotes {
        /// The command line.
        command: String,
    },
    /// It cannot be started, or does not say hello.
    #[error("engine '{command}' cannot be run: {why}")]
    Hello {
        /// The command line.
        command: String,
        /// Why.
        why: String,
    },
}

/// One thing that an engine did wrong.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(super) enum Fault {
    /// The program cannot be started.
    #[error("{program}: {why}")]
    NotStarted { program: String, why: String },
    /// No answer in time.
    #[error("no answer within {} s; --engine-timeout sets another limit", .0.as_secs_f64())]
    Late(Duration),
    /// The program ended or closed its output.
    #[error("the engine ended without an answer ({0})")]
    Ended(String),
    /// An answer longer than any that was asked for.
    #[error("the answer is longer than {0} bytes, which no answer to this question is")]
    TooLong(usize),
    /// More memory than is allowed.
    #[error(
        "the engine uses {used} MiB of memory, more than the {most} MiB that it may; --engine-memory sets another limit"
    )]
    Memory { used: u64, most: u64 },
    /// Against the protocol.
    #[error("{0}")]
    Protocol(String),
    /// Any of these, with what the engine's log ends on.
    #[error("{fault}; its log ends: {log}")]
    Logged { fault: Box<Fault>, log: String },
    /// Too many faults before.
    #[error("the engine was given up after two faults, the last: {0}")]
    GivenUp(String),
    /// The user asked for the end.
    #[error("interrupted")]
    Interrupted,
}
