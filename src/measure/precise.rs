//! A ladder in double-double, against the motion to 31 digits: what decides an order whose range f64 does not hold.
//!
//! How a rounding grows is seen in copies in f64; its unit is that of the arithmetic. A copy that goes astray in f64 says nothing of finer
//! roundings, and the order stays open there.

use super::copies;
use super::ladder::{Truth, between, measured};
use super::order::{Asked, Decision, decide};
use nalgebra::{Matrix3, Vector3};

use crate::arithmetic::{DoubleDouble, Real};
use crate::claim::Claim;
use crate::model::{PerQuantity, Quantity, Snapshot, System};
use crate::record::{self, length};
use crate::reference::precise::Moment;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Most evaluations and iterations of a run.
const MOST_WORK: u64 = 1 << 15;
/// Fewest runs.
const FEWEST_RUNGS: usize = 6;

/// What every run of a ladder in double-double is compared with.
pub(super) struct PreciseTruth<'a> {
    contestant: &'a Contestant,
    truth: &'a Truth<'a>,
    order: u32,
    system: System<DoubleDouble>,
    /// Those of the truth that f64 holds.
    samples: Vec<usize>,
    states: Vec<Snapshot<DoubleDouble>>,
    uncertainty: PerQuantity<f64>,
}

impl<'a> PreciseTruth<'a> {
    /// `None` where no order of the scene's own motion is claimed, or where scheme or truth are in f64 alone.
    pub fn new(
        contestant: &'a Contestant,
        truth: &'a Truth<'a>,
        order: Option<u32>,
    ) -> Option<PreciseTruth<'a>> {
        let order = order.filter(|order| *order > 0 && contestant.runs_in_double_double())?;
        if contestant.card.claims.contains(&Claim::SolvesAnotherMotion) {
            return None;
        }
        let moment = |index: &usize| Some((*index, truth.reference.moment(truth.reference.times[*index])?));
        let (samples, moments): (Vec<usize>, Vec<&Moment>) = truth.samples.iter().filter_map(moment).unzip();
        // The end is asked first.
        if samples.last() != truth.samples.last() {
            return None;
        }
        Some(PreciseTruth {
            contestant,
            truth,
            order,
            system: System::of(truth.system).ok()?,
            samples,
            states: moments.iter().map(|moment| snapshot(moment)).collect(),
            uncertainty: moments.iter().fold(PerQuantity::all(0.0), |most, moment| most.max(moment.error)),
        })
    }

    /// The runs of so many steps, until every quantity is decided that the ladder in f64 leaves open; `None` where it leaves none.
    pub fn climb(&self, own: &record::Ladder, steps: &[u64]) -> Option<record::Ladder> {
        let is_open = |quantity: &Quantity| decide(&Asked::of(own, *quantity)).is_open(self.order);
        let open: Vec<Quantity> = Quantity::ALL.into_iter().filter(is_open).collect();
        if open.is_empty() {
            return None;
        }
        let mut ladder = record::Ladder {
            double_double: true,
            times: self.samples.iter().map(|index| self.truth.reference.times[*index]).collect(),
            uncertainty: self.uncertainty,
            arithmetic: DoubleDouble::UNIT,
            rungs: Vec::new(),
            odd: Vec::new(),
            ..own.clone()
        };
        let decisions = |ladder: &record::Ladder| {
            open.iter().map(|of| decide(&Asked::of(ladder, *of))).collect::<Vec<_>>()
        };
        let mut before = Vec::new();
        for steps in steps.iter().copied() {
            let rung = self.run(steps, own);
            let work = rung.evaluations + rung.iterations;
            ladder.rungs.push(rung);
            let now = decisions(&ladder);
            // Twice the same, so that a chance at large steps decides nothing.
            let settled = ladder.rungs.len() >= FEWEST_RUNGS && same(&before, &now, self.order);
            if settled || 2 * work > MOST_WORK {
                break;
            }
            before = now;
        }
        Some(ladder)
    }

    fn run(&self, steps: u64, own: &record::Ladder) -> record::Rung {
        let intervals = self.truth.reference.states.len() as u64 - 1;
        let plan = Plan::over(self.truth.duration(), steps, intervals);
        let (states, outcome) = self.contestant.run_in(&self.system, Form::Least, &plan);
        let states = self.sampled(&states);
        let mut rung = measured(&self.system.body, &plan, &outcome, &states, &self.states);
        if rung.broken.is_none() {
            rung.rounding = self.rounding(&plan, own);
        }
        rung
    }

    /// The distances of copies in f64 from a run, in the unit of double-double.
    fn rounding(&self, plan: &Plan, own: &record::Ladder) -> PerQuantity<Vec<f64>> {
        let system = self.truth.system;
        let run = |system: &System| self.sampled(&self.contestant.run(system, Form::Least, plan).states);
        let states = run(system);
        let mut rounding = PerQuantity::of(|_| vec![0.0f64; self.samples.len()]);
        for start in copies::starts(system, &self.truth.reference.states, f64::EPSILON, false) {
            let errors = between(&system.body, &run(&start), &states);
            let apart = record::Rung { errors, ..record::Rung::default() };
            for quantity in Quantity::ALL {
                let vector = apart.error(quantity, &own.arms);
                let components = (vector.len() / self.samples.len()).max(1);
                for (largest, apart) in rounding[quantity].iter_mut().zip(vector.chunks(components)) {
                    *largest = largest.max(length(apart) * (DoubleDouble::UNIT / f64::EPSILON));
                }
            }
        }
        rounding
    }

    fn sampled<T: Real>(&self, states: &[Snapshot<T>]) -> Vec<Snapshot<T>> {
        self.samples.iter().filter_map(|index| states.get(*index)).copied().collect()
    }
}

/// Whether all are decided, and as they were before.
fn same(before: &[Decision], now: &[Decision], claimed: u32) -> bool {
    let alike = |(before, now): (&Decision, &Decision)| match (before, now) {
        (Decision::Exact, Decision::Exact) => true,
        (Decision::Order(before), Decision::Order(now)) => before.order == now.order && now.order >= claimed,
        _ => false,
    };
    before.len() == now.len() && before.iter().zip(now).all(alike)
}

/// A moment of the truth in the arithmetic of the runs.
fn snapshot(moment: &Moment) -> Snapshot<DoubleDouble> {
    let number = |x: crate::reference::precise::DoubleDouble| DoubleDouble::of_sum(x.high, x.low);
    let vector = |v: &[crate::reference::precise::DoubleDouble; 3]| Vector3::from(v.map(number));
    Snapshot {
        time: DoubleDouble::exact(moment.time),
        position: vector(&moment.position),
        velocity: vector(&moment.velocity),
        orientation: rotation::from_matrix(&Matrix3::from_columns(&moment.axes.each_ref().map(vector))),
        angular_velocity: vector(&moment.angular_velocity),
        angular_momentum: vector(&moment.angular_momentum),
        stretch: DoubleDouble::exact(0.0),
    }
}
