//! One run of a ladder, measured: as error vectors for the gates and as numbers for tables.

use nalgebra::Vector3;

use super::copies;
use super::order::{Asked, BELOW, Decision, Run, decide};
use super::{ALL, Reading, Sight, errors};
use crate::arithmetic::Real;
use crate::model::body::{Body, Shape};
use crate::model::copies::CLEAR;
use crate::model::{Broken, PerQuantity, Quantity, Snapshot, System, sizes};
use crate::record::{self, length, to_digits};
use crate::reference::Reference;
use crate::reference::precise::Moment;
use crate::rotation;
use crate::simulate::{Break, Contestant, Form, Outcome, Plan, Program};

/// So many digits hold every double.
const ALL_DIGITS: usize = 16;
/// Digits of errors in the evidence, …
const ERROR_DIGITS: usize = 5;
/// … and of roundings.
pub(super) const ROUNDING_DIGITS: usize = 2;

/// What a scheme did on the ladder of a scene.
#[derive(Clone, Debug)]
pub struct Climbed {
    /// Name of the model that was run.
    pub model: &'static str,
    /// What gates read.
    pub ladder: record::Ladder,
    /// The same in double-double, where f64 leaves an order open.
    pub precise: Option<record::Ladder>,
    /// Runs in double-double to the first sample time, where a quantity is promised to be exact.
    pub exactness: Option<record::Ladder>,
    /// Runs over the beginning of the motion, where neither decides an order.
    pub beginning: Option<record::Ladder>,
    /// The runs, step falling, as tables show them.
    pub rungs: Vec<Rung>,
    /// States of the two finest runs at equal intervals, the finest first.
    pub finest: [Vec<Snapshot>; 2],
    /// The truth at the same times.
    pub truth: Vec<Snapshot>,
    /// Steps of the coarsest run that there is no time for, where it would have been made.
    pub left_out: Option<u64>,
}

impl Climbed {
    /// Why the scheme cannot take the scene, where that was known only when it was asked.
    pub fn refusal(&self) -> Option<&str> {
        self.rungs.iter().find_map(|rung| rung.outcome.refusal())
    }
}

/// One run of a ladder, as tables show it.
#[derive(Clone, Debug)]
pub struct Rung {
    /// h [s].
    pub step: f64,
    /// Steps of a whole run.
    pub steps: u64,
    /// Errors; NaN where the run broke.
    pub errors: PerQuantity<Reading>,
    /// Roundings of the errors, and the uncertainty of the truth.
    pub floors: PerQuantity<Reading>,
    /// The other metrics, in the order of [`ALL`].
    pub readings: Vec<Option<Reading>>,
    /// Cost and end.
    pub outcome: Outcome,
}

impl Rung {
    /// Whether the run follows the truth, to a tenth of the body's size.
    pub(super) fn follows(&self, system: &System) -> bool {
        self.errors[Quantity::BodyPoint].max <= BELOW * system.body.extent()
    }
}

/// What every run of a ladder is compared with.
pub(super) struct Truth<'a> {
    pub(super) system: &'a System,
    /// The truth at equal intervals of the run; its states stand beside those of every run.
    reference: Reference,
    /// Indices of the sample times among them; the first, the start, is left out.
    pub(super) samples: Vec<usize>,
    arms: Vec<[f64; 3]>,
}

impl<'a> Truth<'a> {
    /// With the sample times that begin with the quarter of the quarter … of the end, as often as `quarters` says; with the
    /// middle and the end for none.
    pub fn new(system: &'a System, reference: &Reference, quarters: u32) -> Truth<'a> {
        let last = (1usize << (2 * quarters)).max(2);
        let early = (1..=quarters).rev().map(|quarter| last >> (2 * quarter));
        let mut samples: Vec<usize> = early.chain([last / 2, 3 * last / 4, last]).collect();
        samples.dedup();
        let reference = reference.thinned((reference.times.len() - 1) / last);
        Truth { system, reference, samples, arms: arms(&system.body) }
    }

    /// The ladder before its first run.
    pub fn ladder(&self) -> record::Ladder {
        record::Ladder {
            times: self.samples.iter().map(|index| self.reference.times[*index]).collect(),
            sizes: sizes(self.system, &self.reference.states),
            uncertainty: self.reference.largest_uncertainty(),
            arms: self.arms.clone(),
            ..record::Ladder::default()
        }
    }

    pub fn duration(&self) -> f64 {
        self.time(self.intervals() as usize)
    }

    /// Equal intervals of the run.
    pub fn intervals(&self) -> u64 {
        self.reference.times.len() as u64 - 1
    }

    /// The end of so many intervals [s].
    pub fn time(&self, index: usize) -> f64 {
        self.reference.times[index]
    }

    /// The truth to 31 digits after so many intervals.
    pub fn moment(&self, index: usize) -> Option<&Moment> {
        self.reference.moment(self.time(index))
    }

    /// The truth at the equal intervals of every run.
    pub fn states(self) -> Vec<Snapshot> {
        self.reference.states
    }

    /// The states at the sample times.
    fn sampled(&self, states: &[Snapshot]) -> Vec<Snapshot> {
        self.samples.iter().filter_map(|index| states.get(*index)).copied().collect()
    }

    /// A run of so many steps, for gates and for tables. The states that it is measured at are handed on.
    pub fn run(
        &self,
        contestant: &Contestant,
        steps: u64,
        ladder: &mut record::Ladder,
    ) -> (record::Rung, Rung, Vec<Snapshot>) {
        let plan = Plan::over(self.duration(), steps, self.intervals());
        let run = contestant.run(self.system, Form::Least, &plan);
        (ladder.arithmetic, ladder.printed) = units(contestant.program());
        self.look_at_start(&run.states, ladder);
        let (states, truth) = (self.sampled(&run.states), self.sampled(&self.reference.states));
        let mut rung = measured(&self.system.body, &plan, &run.outcome, &states, &truth);
        let mut shown = Rung {
            step: plan.step,
            steps,
            errors: PerQuantity::all(Reading::NAN),
            floors: PerQuantity::all(Reading::NAN),
            readings: vec![None; ALL.len()],
            outcome: run.outcome,
        };
        if rung.broken.is_none() {
            self.add_rounding(contestant, &mut rung, &plan, (&states, |states| self.sampled(states)));
            let sight = Sight { system: self.system, reference: &self.reference, states: &run.states };
            shown.errors = errors(&sight);
            shown.readings = ALL.iter().map(|metric| metric.measure(&sight)).collect();
            let vertical = ALL.iter().position(|metric| metric.name == "vertical-momentum");
            rung.vertical_momentum = vertical
                .and_then(|index| shown.readings[index])
                .map(|reading| to_digits(reading.max, ERROR_DIGITS));
        }
        shown.floors = floors(ladder, &rung);
        (rung, shown, run.states)
    }

    /// An odd number of steps, compared at the end.
    pub fn odd(&self, contestant: &Contestant, steps: u64) -> record::Rung {
        let plan = Plan { step: self.duration() / steps as f64, steps, every: steps };
        let run = contestant.run(self.system, Form::Least, &plan);
        let end = |states: &[Snapshot]| states.get(1..).unwrap_or_default().to_vec();
        let (states, truth) = (end(&run.states), &self.reference.states[self.reference.states.len() - 1..]);
        let mut rung = measured(&self.system.body, &plan, &run.outcome, &states, truth);
        if rung.broken.is_none() {
            self.add_rounding(contestant, &mut rung, &plan, (&states, end));
        }
        rung
    }

    fn look_at_start(&self, states: &[Snapshot], ladder: &mut record::Ladder) {
        if let (Some(first), Some(truth)) = (states.first(), self.reference.states.first()) {
            let apart = crate::model::difference(&self.system.body, first, truth);
            ladder.start = PerQuantity::of(|quantity| super::larger(ladder.start[quantity], apart[quantity]));
        }
    }

    /// Takes in the distances of the copies from the run, at the states that `sampled` takes of each. A copy that breaks is no evidence of
    /// rounding. Runs that choose their own steps have no copies: those would choose others.
    pub fn add_rounding(
        &self,
        contestant: &Contestant,
        rung: &mut record::Rung,
        plan: &Plan,
        (states, sampled): (&[Snapshot], impl Fn(&[Snapshot]) -> Vec<Snapshot>),
    ) {
        if contestant.chooses_steps() {
            return;
        }
        let (unit, _) = units(contestant.program());
        // A sum over points rounds the inertia.
        let retold = self.system.body.is_given_by_points();
        for start in copies::starts(self.system, &self.reference.states, unit, retold) {
            let copy = sampled(&contestant.run(&start, Form::Least, plan).states);
            if copy.len() == states.len() {
                let errors = between(&self.system.body, &copy, states);
                self.widen(rung, &record::Rung { errors, ..record::Rung::default() });
            }
        }
    }

    /// The larger of the roundings of a run and the distances of a copy from it.
    fn widen(&self, rung: &mut record::Rung, apart: &record::Rung) {
        for quantity in Quantity::ALL {
            let (vector, rounding) = (apart.error(quantity, &self.arms), &mut rung.rounding[quantity]);
            let components = (vector.len() / rounding.len()).max(1);
            for (largest, apart) in rounding.iter_mut().zip(vector.chunks(components)) {
                *largest = largest.max(length(apart));
            }
        }
    }
}

/// Error vectors of a run at the sample times.
pub(super) fn measured<T: Real>(
    body: &Body<T>,
    plan: &Plan,
    outcome: &Outcome,
    states: &[Snapshot<T>],
    truth: &[Snapshot<T>],
) -> record::Rung {
    let unsolved = |broken: &Break| matches!(broken.why, Broken::NoConvergence { .. });
    let mut rung = record::Rung {
        step: plan.step,
        steps: plan.steps,
        broken: outcome.broken.as_ref().map(ToString::to_string),
        unsolved: outcome.broken.as_ref().is_some_and(unsolved),
        evaluations: outcome.evaluations,
        solves: outcome.solves,
        iterations: outcome.iterations,
        ..record::Rung::default()
    };
    if rung.broken.is_none() {
        rung.errors = between(body, states, truth);
        rung.rounding = PerQuantity::of(|_| vec![0.0; truth.len()]);
        if states.len() < truth.len() || rung.errors.values().flatten().any(|x| !x.is_finite()) {
            rung.broken = Some("a state of the run is missing or not finite".to_owned());
            rung.errors = PerQuantity::default();
        }
    }
    rung
}

/// Body axes from the centre of mass to points that stand for the body [m].
fn arms(body: &Body) -> Vec<[f64; 3]> {
    match body.shape {
        Shape::Point => Vec::new(),
        Shape::Rod { direction } => {
            vec![(direction / rotation::length(&direction) * (body.moments.max() / body.mass).sqrt()).into()]
        }
        Shape::Extended => {
            (0..3).map(|axis| (body.principal * Vector3::ith(axis, spread(body, axis))).into()).collect()
        }
    }
}

/// Root mean square of the mass along a principal axis [m]: the moments are sums of two such squares.
fn spread(body: &Body, axis: usize) -> f64 {
    let squared = (0.5 * body.moments.sum() - body.moments[axis]) / body.mass;
    // A textbook's moments may be those of no masses.
    if squared > 0.0 { squared.sqrt() } else { 0.0 }
}

/// The differences of two runs, as vectors in which errors add.
pub fn between<T: Real>(body: &Body<T>, a: &[Snapshot<T>], b: &[Snapshot<T>]) -> PerQuantity<Vec<f64>> {
    PerQuantity::of(|quantity| a.iter().zip(b).flat_map(|(a, b)| vector(body, quantity, a, b)).collect())
}

fn vector<T: Real>(body: &Body<T>, quantity: Quantity, a: &Snapshot<T>, b: &Snapshot<T>) -> Vec<f64> {
    let of = |v: Vector3<T>| v.iter().map(|x| x.to_f64()).collect();
    match (quantity, &body.shape) {
        (Quantity::Position, _) => of(a.position - b.position),
        (Quantity::Velocity, _) => of(a.velocity - b.velocity),
        (Quantity::AngularVelocity, _) => of(a.angular_velocity - b.angular_velocity),
        (Quantity::AngularMomentum, _) => of(a.angular_momentum - b.angular_momentum),
        (Quantity::BodyPoint, _) => Vec::new(),
        (Quantity::Orientation, Shape::Point) => vec![0.0],
        (Quantity::Orientation, shape) => {
            let turn = a.orientation.to_rotation_matrix().into_inner()
                - b.orientation.to_rotation_matrix().into_inner();
            match shape {
                Shape::Rod { direction } => of(turn * (direction / rotation::length(direction))),
                _ => turn.iter().map(|x| x.to_f64() * std::f64::consts::FRAC_1_SQRT_2).collect(),
            }
        }
    }
}

/// What an error at the end and the largest one may be off by: its floor in the rule of orders, over [`CLEAR`].
fn floors(ladder: &record::Ladder, rung: &record::Rung) -> PerQuantity<Reading> {
    PerQuantity::of(|quantity| {
        let rounding = &rung.rounding[quantity];
        let at = |rounding: f64| {
            let run = Run { steps: rung.steps, rounding: vec![rounding], ..Run::default() };
            Asked { runs: Vec::new(), ..Asked::of(ladder, quantity) }.floor(&run, 1) / CLEAR
        };
        let largest = rounding.iter().copied().fold(0.0, super::larger);
        Reading { end: at(rounding.last().copied().unwrap_or(f64::NAN)), max: at(largest) }
    })
}

/// How far the first state of a run may be from the start of the scene: what its arithmetic and its digits allow.
pub fn start_allows(ladder: &record::Ladder, quantity: Quantity) -> f64 {
    CLEAR * (ladder.arithmetic + ladder.printed) * ladder.sizes[quantity]
}

/// The digits that the evidence keeps: all of them where runs converge to another motion, which their small differences show, or would seem to
/// with fewer digits.
pub(super) fn shortened(ladder: &mut record::Ladder) {
    let goes_elsewhere = |ladder: &record::Ladder| {
        let is_elsewhere =
            |quantity| matches!(decide(&Asked::of(ladder, quantity)), Decision::Elsewhere { .. });
        Quantity::ALL.into_iter().any(is_elsewhere)
    };
    let mut short = ladder.clone();
    for rung in short.rungs.iter_mut().chain(&mut short.odd) {
        for quantity in Quantity::ALL {
            rung.errors[quantity].iter_mut().for_each(|x| *x = to_digits(*x, ERROR_DIGITS));
            rung.rounding[quantity].iter_mut().for_each(|x| *x = to_digits(*x, ROUNDING_DIGITS));
        }
    }
    if !goes_elsewhere(ladder) && !goes_elsewhere(&short) {
        *ladder = short;
    }
}

/// A unit in the last place of a program's arithmetic, and half of one that it prints, relative.
fn units(program: Option<Program>) -> (f64, f64) {
    let program = program.unwrap_or_default();
    if program.single_precision {
        return (f64::from(f32::EPSILON), f64::from(f32::EPSILON) / 2.0);
    }
    let few = program.digits > 0 && program.digits < ALL_DIGITS;
    (f64::EPSILON, if few { 0.5 * 10f64.powi(1 - program.digits as i32) } else { 0.0 })
}
