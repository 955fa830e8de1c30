//! `polhode engine check --contract`: what a program does, clause by clause.

use crate::cli::Failure;
use crate::cli::exit::UNDECIDED;
use crate::cli::output::print;
use crate::engine::{Conduct, Judgement, hold};

/// Prints a line for each clause. Returns 0 where all that apply hold, 1 where one fails, 2 where none applies.
pub(super) fn check(command: &str) -> Result<u8, Failure> {
    let judgements = hold(command)?;
    let mut text: String = judgements.iter().map(line).collect();
    let count = |conduct| judgements.iter().filter(|judgement| judgement.conduct() == conduct).count();
    let (held, failed) = (count(Conduct::Holds), count(Conduct::Fails));
    text += &match (held, failed) {
        (0, 0) => "\nno clause of the contract applies: nothing was checked\n".to_owned(),
        (held, 0) => {
            format!("\nthe engine keeps the contract: {held} of {} clauses hold\n", judgements.len())
        }
        (_, failed) => format!("\nthe engine breaks {failed} of {} clauses\n", judgements.len()),
    };
    print(&text)?;
    Ok(match (held, failed) {
        (0, 0) => UNDECIDED,
        (_, 0) => 0,
        _ => 1,
    })
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
