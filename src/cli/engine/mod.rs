//! `polhode engine`: write a minimal engine, hold one against the protocol or the contract, and compare some with one another.

mod compare;
mod contract;

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};
use serde_json::{Value, json};

use super::Failure;
use super::output::{Force, Format, print};
use super::progress::with_word;
use crate::engine::{self, Finding, Language};
use crate::record;

/// Options of `polhode engine`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(subcommand)]
    what: What,
}

const EXAMPLES: &str = "\
Examples:
  polhode engine new --language python --out engine.py
  polhode engine check 'python3 engine.py'
  polhode engine check --contract 'python3 engine.py'
  polhode gate --scheme 'engine:python3 engine.py' --scene free-asymmetric
  polhode engine compare --scheme 'engine:python3 engine.py' --scheme peskin-rk2 --scene free-asymmetric

Exit code of a check: 0 the engine keeps to the protocol, 1 it does not, 69 it cannot be run.";

const CHECK_EXAMPLES: &str = "\
Examples:
  polhode engine check 'python3 engine.py'
  polhode engine check --contract 'python3 engine.py'

Exit code: 0 the engine keeps to the protocol, or every clause of the contract that applies holds; 1 a rule or a clause \
is broken; 2 no clause applies; 69 the engine cannot be run.";

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// Write a minimal engine to begin with: a free body under gravity, by RK4
    New {
        /// Language to write it in
        #[arg(long, value_enum)]
        language: Choice,
        /// File to write instead of stdout
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
        #[command(flatten)]
        force: Force,
    },
    /// Hold an engine against the protocol, line by line, or against the contract, clause by clause
    #[command(after_help = CHECK_EXAMPLES)]
    Check {
        /// Check what every engine must do whatever its scheme, in place of the protocol: a step of zero length, a run
        /// in two parts, a restart, the same request twice and by two processes, slow motions, energies, and one body
        /// described in three ways
        #[arg(long)]
        contract: bool,
        /// Form of the findings
        #[arg(long, value_enum, default_value_t)]
        format: Format,
        /// The command line that starts it, quoted, or after --; with or without 'engine:' before it
        #[arg(value_name = "COMMAND LINE", required = true, num_args = 1..)]
        command: Vec<String>,
    },
    /// Compare engines with one another and with schemes: errors, costs, and which of them have one rule
    Compare(compare::Options),
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Choice {
    Python,
    C,
    Cpp,
    Javascript,
    Julia,
}

pub(super) fn engine(options: &Options, quiet: bool) -> Result<u8, Failure> {
    match &options.what {
        What::New { language, out, force } => {
            let text = language.language().template();
            force.try_place(out.as_ref(), |head| head == text)?;
            match out {
                Some(path) => record::write_whole(path, text.as_bytes())?,
                None => print(text)?,
            }
            Ok(0)
        }
        What::Check { contract: true, format, command } => contract::check(&line(command), *format, quiet),
        What::Check { contract: false, format, command } => check(&line(command), *format, quiet),
        What::Compare(options) => compare::compare(options, quiet),
    }
}

/// One word is a whole command line; several were split by the shell already.
fn line(command: &[String]) -> String {
    match command {
        [one] => one.strip_prefix(engine::PREFIX).unwrap_or(one).to_owned(),
        several => engine::join(several),
    }
}

fn check(command: &str, format: Format, quiet: bool) -> Result<u8, Failure> {
    let findings = with_word(quiet, "checking", || engine::check(command))?;
    let violations = findings.iter().filter(|finding| finding.violation.is_some()).count();
    print(&match format {
        Format::Text => in_words(&findings, violations),
        Format::Json => in_json(command, &findings),
    })?;
    Ok(u8::from(violations > 0))
}

/// As JSON, schema polhode/engine-check/1.
fn in_json(command: &str, findings: &[Finding]) -> String {
    let rule = |finding: &Finding| {
        json!({
            "rule": finding.rule,
            "holds": finding.violation.is_none(),
            "violation": finding.violation,
            "seen": finding.seen,
        })
    };
    let rules: Vec<Value> = findings.iter().map(rule).collect();
    format!("{:#}\n", json!({ "schema": "polhode/engine-check/1", "command": command, "rules": rules }))
}

fn in_words(findings: &[Finding], violations: usize) -> String {
    let mut text = String::new();
    for finding in findings {
        let (word, seen) = match &finding.violation {
            None => ("ok  ", &finding.seen),
            Some(violation) => ("FAIL", violation),
        };
        text += &format!("{word}  {}\n      {seen}\n", finding.rule);
    }
    text + &match violations {
        0 => format!("\nthe engine keeps to the protocol: {} of {0} rules hold\n", findings.len()),
        count => format!("\nthe engine breaks {count} of {} rules\n", findings.len()),
    }
}

impl Choice {
    fn language(self) -> Language {
        match self {
            Choice::Python => Language::Python,
            Choice::C => Language::C,
            Choice::Cpp => Language::Cpp,
            Choice::Javascript => Language::Javascript,
            Choice::Julia => Language::Julia,
        }
    }
}
