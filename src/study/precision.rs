//! What a scheme reaches in single and in double precision.
//!
//! A ladder of steps is run in f32, in f64 and, as far as its cost allows, in double-double. The error of a run is its largest
//! angle to the reference over sixteen equal distances; that of the double-double run is truncation alone. Rounding is the largest
//! angle between a run and the same run in an arithmetic of more digits: double-double, and f64 for the finer steps of f32.
//!
//! The smallest error of a ladder is the least that the arithmetic reaches, and its step the smallest useful one, where two further
//! halvings do not make it smaller and rounding is as large within them. An error that stays where it is far above rounding is that of a
//! scheme that converges to another motion. Any other ladder ends while the error still falls, and its smallest error is a bound.
//!
//! Rounding grows as n^q with the number of steps n. The exponent q is the slope of log rounding against log n.
//!
//! A body in single precision has its mass, moments and start rounded to single precision. That rounding is part of the error.

use rayon::prelude::*;

use crate::arithmetic::{DoubleDouble, Real, Single};
use crate::journal::{self, Journal};
use crate::measure::{self, Sight};
use crate::model::{Quantity, Snapshot, System, SystemError, difference, larger};
use crate::record::{Growth, PrecisionRow, PrecisionRun, Reach};
use crate::reference::{Reference, ReferenceError, stored};
use crate::scenes::Scene;
use crate::simulate::{Arithmetic, Contestant, Form, Plan};

/// Scenes of the report: a free body, a top on a pivot under gravity, a body on springs.
pub const SCENES: [&str; 3] = ["free-asymmetric", "heavy-asymmetric-top", "tether-springs"];

/// Distances of a run at whose ends errors are taken, and the fewest steps of a run.
const SAMPLES: u64 = 16;
/// Halvings of the ladder in f32 and f64: 65,536 steps.
const HALVINGS: u32 = 12;
/// Most halvings in double-double, whose step costs thirty in f64: 4,096 steps …
const PRECISE_HALVINGS: u32 = 8;
/// … and most evaluations and iterations of a run: implicit schemes iterate to 31 digits.
const MOST_WORK: u64 = 1 << 15;
/// Further halvings that must not lower an error that is the smallest one.
const CONFIRMED: usize = 2;
/// Part of the error before as many halvings that an error is below while it falls: a quarter at order 1.
const FALLS: f64 = 0.5;
/// Part of the smallest error that rounding must be at its step or at one of the two below.
const PART: f64 = 0.5;
/// Fewest steps of a run that the law of growth is fitted on: with fewer, the rounding of the numbers of the body is as large as that
/// of the steps …
const FEWEST_FITTED: u64 = 128;
/// … and fewest runs.
const LEAST_POINTS: usize = 4;

/// A scene with its reference, in every arithmetic.
pub struct Bench {
    scene: Scene,
    reference: Reference,
    double_double: System<DoubleDouble>,
    single: System<Single>,
}

/// A scene that precision cannot be studied in.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    /// No reference.
    #[error("there is no reference to measure errors against: {0}")]
    Reference(#[from] ReferenceError),
    /// An arithmetic does not hold its numbers.
    #[error(transparent)]
    System(#[from] SystemError),
}

impl Bench {
    /// A scene.
    ///
    /// # Errors
    /// [`BenchError`].
    pub fn new(scene: Scene) -> Result<Bench, BenchError> {
        let known =
            if scene.built_in { stored::find(&scene.name).map_err(ReferenceError::from)? } else { None };
        Ok(Bench {
            reference: Reference::of(&scene.system, scene.duration, SAMPLES as usize, known.as_ref())?,
            double_double: System::of(&scene.system)?,
            single: System::of(&scene.system)?,
            scene,
        })
    }

    /// Rows of f32, f64 and double-double; `None` where the scheme cannot take the scene or runs in f64 alone.
    pub fn rows(&self, contestant: &Contestant) -> Option<[PrecisionRow; 3]> {
        if contestant.refusal(&self.scene.system).is_some() || !contestant.runs_in_double_double() {
            return None;
        }
        let [mut singles, mut doubles, mut precises] = [const { Vec::new() }; 3];
        let mut work = 0;
        for halving in 0..=HALVINGS {
            let plan = Plan::over(self.scene.duration, SAMPLES << halving, SAMPLES);
            let (double, _) = whole_run(contestant, &self.scene.system, &plan);
            let (single, _) = whole_run(contestant, &self.single, &plan);
            let mut precise = None;
            if halving <= PRECISE_HALVINGS && 2 * work <= MOST_WORK {
                (precise, work) = whole_run(contestant, &self.double_double, &plan);
                precises.push(self.rung(&plan, precise.as_deref(), None));
            }
            doubles.push(self.rung(&plan, double.as_deref(), precise.as_deref()));
            let exact = precise.or_else(|| double.as_deref().map(same));
            singles.push(self.rung(&plan, single.as_deref(), exact.as_deref()));
        }
        let named = |name: &str, row: PrecisionRow| PrecisionRow {
            scene: self.scene.name.clone(),
            scheme: contestant.card.name.to_owned(),
            arithmetic: name.to_owned(),
            ..row
        };
        let truncation = PrecisionRow { reach: None, ..summed_up(precises) };
        Some([
            named(Single::NAME, summed_up(singles)),
            named(f64::NAME, summed_up(doubles)),
            named(DoubleDouble::NAME, truncation),
        ])
    }

    fn rung<T: Real>(
        &self,
        plan: &Plan,
        run: Option<&[Snapshot<T>]>,
        exact: Option<&[Snapshot<DoubleDouble>]>,
    ) -> PrecisionRun {
        let rounding = run.zip(exact).map(|(run, exact)| {
            let body = &self.double_double.body;
            let angle = |(a, b): (&Snapshot<T>, &Snapshot<DoubleDouble>)| {
                difference(body, &a.nearest(), b)[Quantity::Orientation].to_f64()
            };
            run.iter().zip(exact).map(angle).fold(0.0, larger)
        });
        PrecisionRun {
            steps: plan.steps,
            step_s: plan.step,
            error_rad: run.map(|run| self.error(run)),
            rounding_rad: rounding,
        }
    }

    /// Largest angle to the reference [rad].
    fn error<T: Real>(&self, run: &[Snapshot<T>]) -> f64 {
        let states = same(run);
        let sight = Sight { system: &self.scene.system, reference: &self.reference, states: &states };
        measure::errors(&sight)[Quantity::Orientation].max
    }
}

/// The states of a run, `None` where it broke, and its evaluations and iterations.
fn whole_run<T: Arithmetic>(
    contestant: &Contestant,
    system: &System<T>,
    plan: &Plan,
) -> (Option<Vec<Snapshot<T>>>, u64) {
    let (states, outcome) = contestant.run_in(system, Form::Least, plan);
    (outcome.broken.is_none().then_some(states), outcome.evaluations + outcome.iterations)
}

/// States in another arithmetic.
fn same<T: Real, U: Real>(states: &[Snapshot<T>]) -> Vec<Snapshot<U>> {
    states.iter().map(Snapshot::nearest).collect()
}

/// What a ladder says, without the names.
fn summed_up(runs: Vec<PrecisionRun>) -> PrecisionRow {
    let growth = growth(&runs);
    let least = runs
        .iter()
        .enumerate()
        .filter_map(|(place, run)| Some((place, run.error_rad.filter(|error| error.is_finite())?)))
        .min_by(|a, b| a.1.total_cmp(&b.1));
    PrecisionRow {
        smallest_error_rad: least.map(|(_, error)| error),
        at_step_s: least.map(|(place, _)| runs[place].step_s),
        reach: Some(least.map_or(Reach::Broken, |(place, error)| reach(&runs, place, error, growth))),
        growth,
        runs,
        ..PrecisionRow::default()
    }
}

/// What the smallest error of a ladder says.
fn reach(runs: &[PrecisionRun], place: usize, error: f64, growth: Option<Growth>) -> Reach {
    let confirmed = place + CONFIRMED < runs.len();
    let before = place.checked_sub(CONFIRMED).and_then(|coarser| runs[coarser].error_rad);
    if !confirmed && before.is_none_or(|before| error < FALLS * before) {
        return Reach::Falling;
    }
    let finer = place..(place + CONFIRMED + 1).min(runs.len());
    let rounding = finer.map(|place| rounding(runs, place, growth)).fold(0.0, f64::max);
    if rounding >= PART * error { Reach::Rounding } else { Reach::OtherMotion }
}

/// Rounding of a run: measured, or by the law of growth from the finest run where it is.
fn rounding(runs: &[PrecisionRun], place: usize, growth: Option<Growth>) -> f64 {
    let measured = runs[..=place].iter().rev().find_map(|run| Some((run.steps, run.rounding_rad?)));
    let Some((steps, size)) = measured else { return 0.0 };
    let more = runs[place].steps as f64 / steps as f64;
    size * more.powf(growth.map_or(1.0, |growth| growth.exponent))
}

/// The slope of log rounding against log n, with twice its standard error; `None` where fewer than four runs show rounding.
fn growth(runs: &[PrecisionRun]) -> Option<Growth> {
    let shown = |run: &PrecisionRun| {
        let rounding = run.rounding_rad.filter(|size| *size > 0.0 && size.is_finite())?;
        (run.steps >= FEWEST_FITTED).then(|| ((run.steps as f64).ln(), rounding.ln()))
    };
    let points: Vec<(f64, f64)> = runs.iter().filter_map(shown).collect();
    if points.len() < LEAST_POINTS {
        return None;
    }
    let (count, slope) = (points.len() as f64, measure::slope(&points));
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let squares = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(|point| of(point).powi(2)).sum::<f64>();
    let left = squares(&|point| point.1 - y - slope * (point.0 - x));
    let spread = squares(&|point| point.0 - x);
    Some(Growth::new(slope, 2.0 * (left / (count - 2.0) / spread).sqrt()))
}

/// Rows of every scheme in every scene that it can take, scene by scene.
///
/// # Errors
/// [`BenchError`].
pub fn rows(
    scenes: Vec<Scene>,
    contestants: &[Contestant],
    journal: Option<&Journal>,
) -> Result<Vec<PrecisionRow>, BenchError> {
    let benches: Vec<Bench> = scenes.into_par_iter().map(Bench::new).collect::<Result<_, BenchError>>()?;
    let cells: Vec<(&Bench, &Contestant)> =
        benches.iter().flat_map(|bench| contestants.iter().map(move |one| (bench, one))).collect();
    let rows = cells.into_par_iter().with_max_len(1).filter_map(|(bench, one)| {
        let key = ("precision", &bench.scene.name, bench.scene.content(), one.identity());
        journal::row(journal, &key, || bench.rows(one)).flatten()
    });
    Ok(rows.flatten_iter().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::GrowsAs;
    use crate::simulate::Precision;

    /// A ladder of n = 16 … 65,536 steps of a second with these errors and roundings.
    fn ladder(error: impl Fn(f64) -> f64, rounding: impl Fn(f64) -> f64) -> PrecisionRow {
        let run = |halving| {
            let n = (SAMPLES << halving) as f64;
            PrecisionRun {
                steps: SAMPLES << halving,
                step_s: 1.0 / n,
                error_rad: Some(error(n)),
                rounding_rad: Some(rounding(n)),
            }
        };
        summed_up((0..=HALVINGS).map(run).collect())
    }

    #[test]
    fn the_smallest_error_stands_where_truncation_and_rounding_balance() {
        // e = 1/n² + u √n is least where n^(5/2) = 4/u: at n = 1099 for u = 1e-7, 1024 on the ladder.
        let rounding = |n: f64| 1e-7 * n.sqrt();
        let row = ladder(|n| n.powi(-2) + rounding(n), rounding);
        assert_eq!((row.reach, row.at_step_s), (Some(Reach::Rounding), Some(1.0 / 1024.0)));
        let least = row.smallest_error_rad.expect("an error");
        assert!((least - (1.0 / 1024.0 / 1024.0 + 3.2e-6)).abs() < 1e-12, "{least:e}");
        let growth = row.growth.expect("a law");
        assert!((growth.exponent - 0.5).abs() < 1e-12 && growth.law == GrowsAs::Root, "{growth:?}");
        assert_eq!(ladder(rounding, |n| 1e-7 * n).growth.map(|one| one.law), Some(GrowsAs::Linear));
    }

    #[test]
    fn a_bound_and_another_motion_are_no_reach() {
        let rounding = |n: f64| 1e-16 * n;
        let reach = |error: fn(f64) -> f64| ladder(error, rounding).reach;
        assert_eq!(reach(|n| 1.0 / n), Some(Reach::Falling));
        assert_eq!(reach(|n| 0.5 + 1.0 / n), Some(Reach::OtherMotion));
        assert_eq!(reach(|n| 0.5 - 1.0 / n), Some(Reach::OtherMotion));
        assert_eq!(reach(|_| f64::NAN), Some(Reach::Broken));
    }

    #[test]
    fn a_law_needs_more_than_three_runs_and_an_interval_that_decides() {
        let laws = [(0.55, 0.1), (0.9, 0.15), (0.7, 0.4), (0.2, 0.1), (0.8, 0.1), (1.2, 0.1)]
            .map(|(q, s)| Growth::new(q, s).law);
        assert_eq!(
            laws,
            [
                GrowsAs::Root,
                GrowsAs::Linear,
                GrowsAs::Either,
                GrowsAs::Slower,
                GrowsAs::Between,
                GrowsAs::Faster
            ]
        );
        let row = ladder(|n| 1.0 / n, |_| 1e-16);
        assert_eq!(growth(&row.runs[..6]), None);
        assert!(growth(&row.runs[..7]).is_some());
    }

    #[test]
    fn the_exact_rotor_has_no_truncation_and_reaches_a_few_units_of_each_arithmetic() {
        let scene = Scene::find("free-asymmetric").expect("built in");
        let all = Contestant::all();
        let rotor = all.iter().find(|one| one.card.name == "exact-rotor").expect("in the list");
        let bench = Bench::new(scene.clone()).expect("a bench");
        let [single, double, truncation] = bench.rows(rotor).expect("rows");
        // The start and what follows from it are rounded to f64 where the two are compared: measured 3.8e-16.
        assert!(truncation.runs.iter().all(|run| run.error_rad.is_some_and(|error| error < 1e-15)));
        // The finest roundings of f32 are those against f64, whose own is 1.2e-12 at 65,536 steps.
        for (row, unit, apart) in [(&single, Single::UNIT, 1e-11), (&double, f64::UNIT, 2e-15)] {
            let least = row.smallest_error_rad.expect("an error");
            // Measured 7 units in f32, 9 in f64.
            assert!((unit / 4.0..32.0 * unit).contains(&least), "{}: {least:e}", row.arithmetic);
            assert_eq!(row.reach, Some(Reach::Rounding), "{}", row.arithmetic);
            for run in &row.runs {
                // Without truncation an error is a rounding.
                let (error, rounding) = (run.error_rad.expect("ran"), run.rounding_rad);
                assert!(rounding.is_none_or(|size| (error - size).abs() < apart), "{run:?}");
            }
        }
        // A separate run in single precision has the error of the row.
        let steps = single.runs[3].steps;
        let plan = Plan::over(scene.duration, steps, SAMPLES);
        let run = rotor.at(Precision::F32).expect("a scheme").run(&scene.system, Form::Least, &plan);
        assert_eq!(Some(bench.error(&run.states)), single.runs[3].error_rad);
    }
}
