//! The command line: one file a subcommand. Data goes to stdout, talk and progress to stderr.
//!
//! No file of a subcommand uses the file of another one: what several need stands in `config`, `exit`, `faults`,
//! `measured`, `output`, `progress`, `resume` and `select`.

mod advise;
mod bless;
mod compare;
mod completions;
mod config;
mod engine;
mod exit;
mod expect;
mod faults;
mod gate;
mod help;
mod init;
mod inspect;
mod judge;
mod list;
mod measured;
mod output;
mod progress;
mod reference;
mod replay;
mod resume;
mod report;
mod run;
mod scene;
mod select;
mod self_test;
mod sweep;
mod stability;

use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::time::Duration;

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};

pub use exit::Failure;
use help::Colour;

/// How accurate, how stable and how fast is a time-stepping scheme for a rigid body, and how do you know?
#[derive(Parser)]
#[command(name = "polhode", version, about, max_term_width = 100, after_help = CODES)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    everywhere: Everywhere,
}

const CODES: &str = "\
Exit: 0 all holds, 1 a claim failed, 2 undecided, 64 usage, 65 input, 69 engine, 74 file";

/// Options of every subcommand.
#[derive(Args)]
struct Everywhere {
    /// Threads to use [default: all]
    #[arg(long, global = true, hide_short_help = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// No progress and no talk on stderr
    #[arg(long, global = true, hide_short_help = true)]
    quiet: bool,
    /// Colour of pass and fail
    #[arg(long, global = true, hide_short_help = true, value_enum, default_value_t, value_name = "WHEN")]
    color: Colour,
    /// Settings [default: polhode.toml, where there is one]
    #[arg(long, global = true, hide_short_help = true, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Largest input file [default: 64 a scene, 1024 a log by a pipe, 4096 records]
    #[arg(long, global = true, hide_short_help = true, value_name = "MIB", value_parser = clap::value_parser!(u64).range(1..=1 << 30))]
    input_limit: Option<u64>,
    /// Longest time that a foreign engine may take for an answer
    #[arg(long, global = true, hide_short_help = true, value_name = "SECONDS", default_value_t = 60.0, value_parser = seconds)]
    engine_timeout: f64,
    /// Most memory that a foreign engine may use
    #[arg(long, global = true, hide_short_help = true, value_name = "MIB", default_value_t = 4096, value_parser = clap::value_parser!(u64).range(1..))]
    engine_memory: u64,
}

/// A time above zero.
fn seconds(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(seconds) if seconds > 0.0 && seconds <= 1e9 => Ok(seconds),
        _ => Err("expected a number of seconds above 0".to_owned()),
    }
}

#[derive(Subcommand)]
enum Command {
    /// Measure, judge and draw: records, Markdown, one HTML page and PNGs
    Report(report::Options),
    /// Judge every claim; the exit code says whether all hold
    Gate(gate::Options),
    /// Write a new baseline for the gate, with the reason
    Bless(bless::Options),
    /// Write a commented polhode.toml
    Init(init::Options),
    /// Two schemes, or two records files, side by side: is the second worse?
    Compare(compare::Options),
    /// Run one scheme in one scene and write its states
    Run(run::Options),
    /// Which scheme and which step for a tolerance, ranked by cost
    Advise(advise::Options),
    /// The error of a scheme at a step, with its band, and the line to paste into a test
    Expect(expect::Options),
    /// Run a scene with its numbers varied: tidy CSV and a picture
    Sweep(sweep::Options),
    /// Write a minimal foreign engine, or check that one keeps to the protocol
    Engine(engine::Options),
    /// Where schemes fail: the largest usable steps, and maps
    Stability(stability::Options),
    /// Judge a trajectory that another program wrote
    Judge(judge::Options),
    /// Bodies of a URDF, MJCF or SDF file, or of a scene: can they exist?
    Inspect(inspect::Options),
    /// Solve a scene to many digits, with a bound of the error
    Reference(reference::Options),
    /// Run a capsule again and compare every row to the bit
    Replay(replay::Options),
    /// Plant defects: each must turn a gate red
    SelfTest(self_test::Options),
    /// List what there is
    List(list::Options),
    /// Print a scene file, or write a new one
    Scene(scene::Options),
    /// What a shell completes, and man pages
    Completions(completions::Options),
}

/// Runs the program and returns its exit code.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let words: Vec<OsString> = arguments.into_iter().collect();
    let command = help::arranged(Arguments::command()).color(Colour::of_words(&words));
    let matches = command.try_get_matches_from(words);
    let arguments = match matches.and_then(|matches| Arguments::from_arg_matches(&matches)) {
        Ok(arguments) => arguments,
        Err(error) => {
            let code = if error.use_stderr() { exit::USAGE } else { 0 };
            let printed = error.print();
            return match printed {
                // Nothing can be done about a stderr that takes no text.
                Err(source) if code == 0 && source.kind() != ErrorKind::BrokenPipe => {
                    let failure = Failure::Write { name: "stdout".to_owned(), source };
                    eprintln!("{}", faults::shown(&failure));
                    failure.code()
                }
                _ => code,
            };
        }
    };
    match dispatch(arguments) {
        Ok(code) => code,
        Err(Failure::ReaderGone) => 0,
        // A run whose output cannot be written is ended the same way, and says why.
        Err(failure) if crate::interrupt::requested() && !matches!(failure, Failure::Write { .. }) => {
            exit::INTERRUPTED
        }
        Err(failure) => {
            eprintln!("{}", faults::shown(&failure));
            failure.code()
        }
    }
}

fn dispatch(arguments: Arguments) -> Result<u8, Failure> {
    let everywhere = arguments.everywhere;
    if let Some(jobs) = everywhere.jobs {
        rayon::ThreadPoolBuilder::new()
            .num_threads(usize::from(jobs))
            .build_global()
            .map_err(|error| Failure::Usage(format!("--jobs {jobs}: {error}")))?;
    }
    everywhere.input_limit.into_iter().for_each(crate::bounded::set_most);
    crate::engine::set_patience(Duration::from_secs_f64(everywhere.engine_timeout));
    crate::engine::set_most_memory(everywhere.engine_memory);
    exit::listen_to_interrupts()?;
    output::set_colour(everywhere.color.colours());
    let Some(command) = arguments.command else {
        output::print(&help::screen(&Arguments::command()))?;
        return Ok(0);
    };
    config::Config::load(everywhere.config.as_deref())?;
    let code = match command {
        Command::Report(options) => report::report(&options, everywhere.quiet),
        Command::Gate(options) => gate::gate(&options, everywhere.quiet),
        Command::Bless(options) => bless::bless(&options, everywhere.quiet),
        Command::Init(options) => init::init(&options),
        Command::Compare(options) => compare::compare(&options, everywhere.quiet),
        Command::Run(options) => run::run(&options, everywhere.quiet),
        Command::Advise(options) => advise::advise(&options, everywhere.quiet),
        Command::Expect(options) => expect::expect(&options, everywhere.quiet),
        Command::Sweep(options) => sweep::sweep(&options, everywhere.quiet),
        Command::Engine(options) => engine::engine(&options, everywhere.quiet),
        Command::Stability(options) => stability::stability(&options, everywhere.quiet),
        Command::Judge(options) => judge::judge(&options, everywhere.quiet),
        Command::Inspect(options) => inspect::inspect(&options),
        Command::Reference(options) => reference::reference(&options, everywhere.quiet),
        Command::Replay(options) => replay::replay(&options, everywhere.quiet),
        Command::SelfTest(options) => self_test::self_test(&options, everywhere.quiet),
        Command::List(options) => list::list(&options),
        Command::Scene(options) => scene::scene(&options, everywhere.quiet),
        Command::Completions(options) => {
            completions::completions(&options, help::arranged(Arguments::command()))
        }
    }?;
    Ok(if crate::interrupt::requested() { exit::INTERRUPTED } else { code })
}
