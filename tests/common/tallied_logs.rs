//! How many changed logs are named rightly and wrongly, by kind, and how many right ones get a hint.

use std::collections::BTreeMap;
use std::fmt;

use crate::changed_logs::{CHANGES, Named, changed, right};

/// What changed logs were named by.
#[derive(Default)]
pub struct Tally {
    pub rightly: u64,
    pub wrongly: u64,
    pub not: u64,
    /// The same of each kind of change.
    kinds: BTreeMap<&'static str, [u64; 3]>,
    /// Those that are not named rightly.
    pub others: Vec<String>,
}

impl Tally {
    fn add(&mut self, name: &'static str, seed: u64, named: Named) {
        let kind = self.kinds.entry(name).or_default();
        match named {
            Named::Rightly => (self.rightly, kind[0]) = (self.rightly + 1, kind[0] + 1),
            Named::Wrongly(hints) => {
                (self.wrongly, kind[1]) = (self.wrongly + 1, kind[1] + 1);
                self.others.push(format!("{seed} {name}: wrongly {hints:?}"));
            }
            Named::Not => {
                (self.not, kind[2]) = (self.not + 1, kind[2] + 1);
                self.others.push(format!("{seed} {name}: not named"));
            }
        }
    }
}

/// The counts of each kind and of all, a line each.
impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Tally { rightly, wrongly, not, .. } = *self;
        let mut line = |name: &str, [rightly, wrongly, not]: [u64; 3]| {
            let all = rightly + wrongly + not;
            writeln!(f, "{name:24}  named rightly {rightly}, wrongly {wrongly}, not named {not} of {all}")
        };
        self.kinds.iter().try_for_each(|(name, counts)| line(name, *counts))?;
        line("all", [rightly, wrongly, not])
    }
}

/// So many changed logs, judged.
pub fn tally(count: u64) -> Tally {
    let mut tally = Tally::default();
    for seed in 0..count {
        let (name, expected) = CHANGES[seed as usize % CHANGES.len()];
        tally.add(name, seed, changed(seed, name, expected));
    }
    tally
}

/// The right logs among so many that get a hint.
pub fn false_alarms(count: u64) -> Vec<String> {
    let hint = |seed: u64| match right(1_000_000 + seed) {
        Named::Wrongly(hints) => Some(format!("{seed}: {hints:?}")),
        _ => None,
    };
    (0..count).filter_map(hint).collect()
}
