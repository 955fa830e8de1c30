//! Costs of solvers that choose their steps, beside dop853: `cargo bench --bench adaptive`.
//!
//! A row is the least time in which a solver's orientation error at the end stays below an error, over a ladder of tolerances: the best of
//! several runs, taken in turn in one process. Ratios are worth more than microseconds.

use std::time::Instant;

use polhode::internals::ode::run::Run;
use polhode::internals::ode::{SolverError, dop853};
use polhode::internals::schemes::{dormand_prince_8, taylor};
use polhode::model::{Quantity, System, difference};
use polhode::reference::Reference;
use polhode::scenes::Scene;

type Solve = fn(&System, &[f64], f64) -> Result<Run, SolverError>;

const SOLVERS: [(&str, Solve); 3] =
    [("taylor", taylor::solve), ("dormand-prince-8", dormand_prince_8::solve), ("dop853", dop853::solve)];
const SCENES: [&str; 5] = [
    "heavy-asymmetric-top",
    "tether-springs",
    "gravity-gradient",
    "dipole-in-field",
    "charged-body-in-fields",
];
/// Errors [rad].
const ERRORS: [f64; 3] = [1e-8, 1e-10, 1e-12];
/// Runs of each solver at each tolerance.
const RUNS: usize = 15;

fn main() {
    // `cargo test` runs benches too, with this argument: then nothing is measured.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    println!("| scene | error [rad] | solver | µs | dop853 over it |\n|---|---|---|---|---|");
    for name in SCENES {
        let scene = Scene::find(name).expect("a scene");
        let reference = Reference::of(&scene.system, scene.duration, 4, None).expect("a reference");
        let mut rows: [Vec<(f64, f64)>; SOLVERS.len()] = Default::default();
        // Tolerances of 1e-6 to 1e-15, two a decade.
        for half_decades in 12..=30 {
            let tolerance = 10f64.powf(-f64::from(half_decades) / 2.0);
            let mut best = [f64::INFINITY; SOLVERS.len()];
            let mut errors = [f64::NAN; SOLVERS.len()];
            for _ in 0..RUNS {
                for (k, (_, solve)) in SOLVERS.iter().enumerate() {
                    let begun = Instant::now();
                    let run = solve(&scene.system, &reference.times, tolerance).expect("a run");
                    best[k] = best[k].min(begun.elapsed().as_secs_f64() * 1e6);
                    let ends = run.states.last().zip(reference.states.last()).expect("states");
                    errors[k] = difference(&scene.system.body, ends.0, ends.1)[Quantity::Orientation];
                }
            }
            for (row, point) in rows.iter_mut().zip(errors.into_iter().zip(best)) {
                row.push(point);
            }
        }
        for wanted in ERRORS {
            let costs = rows.each_ref().map(|row| {
                row.iter().filter(|row| row.0 <= wanted).map(|row| row.1).fold(f64::INFINITY, f64::min)
            });
            for ((solver, _), cost) in SOLVERS.iter().zip(costs) {
                let ratio = costs[SOLVERS.len() - 1] / cost;
                println!("| {name} | {wanted:e} | {solver} | {cost:.1} | {ratio:.2} |");
            }
        }
    }
}
