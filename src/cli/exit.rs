//! Exit codes, and what they are given for.

use crate::bounded::FileError;
use crate::campaign::JournalError;
use crate::engine::{self, EngineError};
use crate::fault::{self, Fault};
use crate::inspect::InspectError;
use crate::interrupt;
use crate::record::RecordError;
use crate::report::ReportError;
use crate::scenes::SceneError;

/// Nothing failed, and something is undecided.
pub(super) const UNDECIDED: u8 = 2;
/// Wrong usage.
pub(super) const USAGE: u8 = 64;
/// Bad input: scene, records or log file.
const BAD_INPUT: u8 = 65;
/// An engine could not be run.
const ENGINE: u8 = 69;
/// A file could not be read or written.
const FILE: u8 = 74;
/// Ended by Ctrl-C, as shells count it.
pub(super) const INTERRUPTED: u8 = 130;

/// Why a command could not do its work.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The command was not meant like that.
    #[error("{0}")]
    Usage(String),
    /// A scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A records file.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// A report.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// Finished rows of a run.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// Standard output or a file while it was written.
    #[error("{name}: {source}")]
    Write {
        /// The file.
        name: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// The reader of standard output has gone away, as `head` does: no failure.
    #[error("stdout: the reader has gone")]
    ReaderGone,
    /// An engine that cannot be run.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// A trajectory file.
    #[error(transparent)]
    Judge(#[from] FileError),
    /// A robot description.
    #[error(transparent)]
    Inspect(#[from] InspectError),
    /// Settings, every fault of the file.
    #[error("{}", fault::lines(file, faults))]
    Config {
        /// The file.
        file: String,
        /// What it says.
        text: String,
        /// All that is wrong, in the order of the file.
        faults: Vec<Fault>,
    },
    /// A scene that has no point form, asked for one.
    #[error("{0}")]
    Model(String),
}

impl Failure {
    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Failure::ReaderGone => 0,
            Failure::Engine(_) => ENGINE,
            Failure::Usage(_) | Failure::Scene(SceneError::Unknown { .. }) => USAGE,
            Failure::Scene(SceneError::Unreadable { .. })
            | Failure::Judge(FileError::Unreadable { .. })
            | Failure::Inspect(InspectError::File(FileError::Unreadable { .. })) => FILE,
            Failure::Inspect(_) | Failure::Judge(FileError::Content { .. }) => BAD_INPUT,
            Failure::Scene(_)
            | Failure::Record(RecordError::Format { .. } | RecordError::Content { .. })
            | Failure::Model(_)
            | Failure::Config { .. } => BAD_INPUT,
            Failure::Record(RecordError::File { .. } | RecordError::Foreign { .. })
            | Failure::Report(_)
            | Failure::Journal(_)
            | Failure::Write { .. } => FILE,
        }
    }
}

/// The first Ctrl-C asks the work to end, so that what was measured is written; the second ends the program.
pub(super) fn listen_to_interrupts() -> Result<(), Failure> {
    ctrlc::set_handler(|| {
        if interrupt::request() {
            engine::end_all();
            std::process::exit(i32::from(INTERRUPTED));
        }
        eprintln!("\npolhode: interrupted; writing what was measured (again to end at once)");
    })
    .map_err(|error| Failure::Usage(format!("Ctrl-C cannot be listened to: {error}")))
}
