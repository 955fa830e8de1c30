//! How the benches measure: all rows in one process, in turn, in short blocks. A row is the minimum over its
//! blocks.

use std::time::{Duration, Instant};

use polhode::model::System;
use polhode::simulate::{Contestant, Form, Plan};

/// Length of a block.
const BLOCK: Duration = Duration::from_micros(60);

/// What is timed: it gives nanoseconds for one unit, from a number of steps.
pub struct Row {
    pub name: String,
    run: Box<dyn Fn(u64) -> f64>,
    steps: u64,
    spent: Duration,
    /// Fewest nanoseconds of a block.
    pub best: f64,
}

impl Row {
    pub fn new(name: String, run: impl Fn(u64) -> f64 + 'static) -> Row {
        Row { name, run: Box::new(run), steps: 16, spent: Duration::ZERO, best: f64::INFINITY }
    }
}

/// Whether `cargo test` runs the bench, with the argument `--test`: then nothing is measured.
pub fn is_test() -> bool {
    std::env::args().any(|argument| argument == "--test")
}

/// Measures every row for so long.
pub fn measure(rows: &mut [Row], long: Duration) {
    while rows.iter().any(|row| row.spent < long) {
        for row in rows.iter_mut().filter(|row| row.spent < long) {
            let before = Instant::now();
            let cost = (row.run)(row.steps);
            let elapsed = before.elapsed();
            row.spent += elapsed;
            row.best = row.best.min(cost);
            if elapsed < BLOCK && row.steps < 1 << 16 {
                row.steps *= 2;
            }
        }
    }
}

/// Nanoseconds a step of a scheme on a system.
pub fn steps(contestant: Contestant, system: System, form: Form, step: f64) -> impl Fn(u64) -> f64 + 'static {
    move |steps| {
        let plan = Plan { step, steps, every: steps };
        let outcome = contestant.stream(&system, form, &plan, &mut |state| {
            std::hint::black_box(state);
        });
        assert!(outcome.broken.is_none(), "{}", contestant.card.name);
        outcome.nanoseconds as f64 / steps as f64
    }
}

pub fn contestant(name: &str) -> Contestant {
    Contestant::all().into_iter().find(|c| c.card.name == name).expect("a scheme of the list")
}
