//! `polhode engine check --contract`: what a program does, clause by clause.

use serde_json::{Value, json};

use crate::cli::Failure;
use crate::cli::exit::UNDECIDED;
use crate::cli::output::{Format, print};
use crate::cli::progress::with_word;
use crate::engine::{Conduct, Judgement, hold};

/// Prints a line for each clause. Returns 0 where all that apply hold, 1 where one fails, 2 where none applies.
pub(super) fn check(command: &str, format: Format, quiet: bool) -> Result<u8, Failure> {
    let judgements = with_word(quiet, "checking", || hold(command))?;
    let count = |conduct| judgements.iter().filter(|judgement| judgement.conduct() == conduct).count();
    let counts = (count(Conduct::Holds), count(Conduct::Fails));
    print(&match format {
        Format::Text => in_words(&judgements, counts),
        Format::Json => in_json(command, &judgements),
    })?;
    Ok(match counts {
        (0, 0) => UNDECIDED,
        (_, 0) => 0,
        _ => 1,
    })
}

/// As JSON, schema polhode/engine-contract/1.
fn in_json(command: &str, judgements: &[Judgement]) -> String {
    let clause = |judgement: &Judgement| {
        let conduct = match judgement.conduct() {
            Conduct::Holds => "holds",
            Conduct::NotApplicable => "not-applicable",
            Conduct::Fails => "fails",
        };
        json!({
            "clause": judgement.clause.name(),
            "contract": judgement.clause.sentence(),
            "conduct": conduct,
            "scene": judgement.scene,
            "seen": judgement.words(),
        })
    };
    let clauses: Vec<Value> = judgements.iter().map(clause).collect();
    let answer = json!({ "schema": "polhode/engine-contract/1", "command": command, "clauses": clauses });
    format!("{answer:#}\n")
}

fn in_words(judgements: &[Judgement], counts: (usize, usize)) -> String {
    let text: String = judgements.iter().map(line).collect();
    text + &match counts {
        (0, 0) => "\nno clause of the contract applies: nothing was checked\n".to_owned(),
        (held, 0) => {
            format!("\nthe engine keeps the contract: {held} of {} clauses hold\n", judgements.len())
        }
        (_, failed) => format!("\nthe engine breaks {failed} of {} clauses\n", judgements.len()),
    }
}

/// Name, conduct and evidence of a clause; what the clause says where it fails.
fn line(judgement: &Judgement) -> String {
    let (name, words) = (judgement.clause.name(), judgement.words());
    match judgement.conduct() {
        Conduct::Holds => format!("{name:<13} holds           {words}\n"),
        Conduct::NotApplicable => format!("{name:<13} not applicable  {words}\n"),
        Conduct::Fails => {
            format!("{name:<13} FAILS           {words}; the contract: {}\n", judgement.clause.sentence())
        }
    }
}
