//! Runs in double-double against the motion to 31 digits: what decides an order whose range f64 does not hold, and what is exact.
//!
//! How a rounding grows is seen in copies in f64; its unit is that of the arithmetic. A copy that goes astray in f64 says nothing of finer
//! roundings, and nothing is decided there.

use nalgebra::{Matrix3, Vector3};

use super::ladder::{Truth, measured};
use super::order::{Asked, Decision, Doubt, Run, decide};
use crate::arithmetic::{DoubleDouble, Real};
use crate::claim::Claim;
use crate::model::body::{Body, MassPoint, Shape};
use crate::model::{PerQuantity, Quantity, Snapshot, System};
use crate::record::{Ladder, Ladders, Rung, length};
use crate::reference::precise;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Most evaluations and iterations of a run of a ladder.
const MOST_WORK: u64 = 1 << 16;
/// Steps of the coarsest run, at most: over a longer motion a ladder ends at an earlier sample time.
const MOST_COARSEST: u64 = 128;
/// Fewest runs of a ladder.
const FEWEST_RUNGS: usize = 6;
/// Runs that show whether a quantity is exact, each of half the step of the last, …
const EXACT_RUNGS: u32 = 3;
/// … and the steps of the coarsest, at least.
const FEWEST_STEPS: u64 = 4;
/// Steps of the runs of a steady spin beside them: exact is exact at every step.
const GIANT_STEPS: [u64; 2] = [1, 3];

/// A contestant in double-double, and what its runs are compared with.
pub(super) struct Precise<'a> {
    contestant: &'a Contestant,
    truth: &'a Truth<'a>,
    system: System<DoubleDouble>,
    /// The sample times of the truth at which it is known to 31 digits.
    samples: Vec<usize>,
    states: Vec<Snapshot<DoubleDouble>>,
    uncertainty: PerQuantity<f64>,
}

impl<'a> Precise<'a> {
    /// `None` where scheme or truth are in f64 alone, or where the scheme solves another motion.
    pub fn new(contestant: &'a Contestant, truth: &'a Truth<'a>) -> Option<Precise<'a>> {
        let another = contestant.card.claims.contains(&Claim::SolvesAnotherMotion);
        if another || !contestant.runs_in_double_double() {
            return None;
        }
        let known = |index: &usize| Some((*index, truth.moment(*index)?));
        let (samples, moments): (Vec<usize>, Vec<_>) = truth.samples.iter().filter_map(known).unzip();
        // The first is asked for exactness and the last for orders.
        if samples.first() != truth.samples.first() || samples.last() != truth.samples.last() {
            return None;
        }
        Some(Precise {
            contestant,
            truth,
            system: as_given(contestant, truth.system)?,
            samples,
            states: moments.iter().map(|moment| snapshot(moment)).collect(),
            uncertainty: moments.iter().fold(PerQuantity::all(0.0), |most, moment| most.max(moment.error)),
        })
    }

    /// The runs of so many steps, until every order is decided that the ladder in f64 leaves open; `None` where it leaves none, or where none
    /// is claimed.
    pub fn climb(&self, own: &Ladder, steps: &[u64], order: u32) -> Option<Ladder> {
        let is_open = |quantity: &Quantity| decide(&Asked::of(own, *quantity)).is_open();
        let open: Vec<Quantity> = Quantity::ALL.into_iter().filter(is_open).collect();
        if order == 0 || open.is_empty() {
            return None;
        }
        let (end, intervals) = (self.end(*steps.first()?), self.truth.intervals());
        let samples: Vec<usize> = self.samples.iter().copied().filter(|index| *index <= end).collect();
        let times = samples.iter().map(|index| self.truth.time(*index)).collect();
        let mut ladder = self.ladder(own, times);
        let mut before = Vec::new();
        for steps in steps.iter().copied() {
            let plan = Plan::over(self.truth.time(end), steps * end as u64 / intervals, end as u64);
            let rung = self.run(&plan, &samples, &self.states[..samples.len()]);
            let work = rung.evaluations + rung.iterations;
            ladder.rungs.push(rung);
            let now: Vec<Decision> = open.iter().map(|of| decide(&Asked::of(&ladder, *of))).collect();
            // Twice the same, so that a chance at large steps decides nothing.
            let settled = ladder.rungs.len() >= FEWEST_RUNGS && same(&before, &now, order);
            if settled || 2 * work > MOST_WORK {
                break;
            }
            before = now;
        }
        Some(ladder)
    }

    /// The interval that ends a ladder whose coarsest run over the whole motion has so many steps: the last, or that of a quarter of the
    /// quarter … of the duration.
    fn end(&self, coarsest: u64) -> usize {
        let intervals = self.truth.intervals();
        let fits = |end: &u64| coarsest * end / intervals <= MOST_COARSEST;
        let mut quarters = std::iter::successors(Some(intervals), |end| (end % 4 == 0).then_some(end / 4));
        quarters.find(fits).unwrap_or(1) as usize
    }

    /// Runs to the first sample time, about one turn, from steps of the size that the ladder in f64 begins with; `coarsest` is the steps of
    /// that run. `None` where nothing is promised to be exact.
    pub fn exactness(&self, own: &Ladder, coarsest: u64) -> Option<Ladder> {
        let system = self.truth.system;
        let promised = self.contestant.card.claims.iter().any(|claim| matches!(claim, Claim::Exact(..)));
        if !promised || !system.constant_force().0 {
            return None;
        }
        let part = self.truth.intervals() / self.samples[0] as u64;
        let first = (coarsest / part).max(FEWEST_STEPS);
        let time = self.truth.time(self.samples[0]);
        // A run covers h n in f64, which is not the time where the quotient was rounded.
        let ends = |steps: &u64| time / *steps as f64 * *steps as f64 == time;
        let giant = GIANT_STEPS.into_iter().filter(|steps| system.steady_spin() && ends(steps));
        let mut ladder = self.ladder(own, vec![time]);
        ladder.uncertainty = self.truth.moment(self.samples[0])?.error;
        for steps in giant.chain((0..EXACT_RUNGS).map(|halvings| first << halvings)) {
            let plan = Plan { step: time / steps as f64, steps, every: steps };
            ladder.rungs.push(self.run(&plan, &[1], &self.states[..1]));
        }
        Some(ladder)
    }

    /// A ladder before its first run.
    fn ladder(&self, own: &Ladder, times: Vec<f64>) -> Ladder {
        Ladder {
            double_double: true,
            times,
            sizes: own.sizes,
            uncertainty: self.uncertainty,
            arithmetic: DoubleDouble::UNIT,
            arms: own.arms.clone(),
            ..Ladder::default()
        }
    }

    /// A run, compared at these of its states.
    fn run(&self, plan: &Plan, at: &[usize], truth: &[Snapshot<DoubleDouble>]) -> Rung {
        let (states, outcome) = self.contestant.run_in(&self.system, Form::Least, plan);
        let mut rung = measured(&self.system.body, plan, &outcome, &taken(&states, at), truth);
        if rung.broken.is_none() {
            let own = self.contestant.run(self.truth.system, Form::Least, plan).states;
            let of_run = (taken(&own, at), |copy: &[Snapshot]| taken(copy, at));
            self.truth.add_rounding(self.contestant, &mut rung, plan, (&of_run.0, of_run.1));
            let finer = DoubleDouble::UNIT / f64::EPSILON;
            Quantity::ALL
                .into_iter()
                .for_each(|quantity| rung.rounding[quantity].iter_mut().for_each(|x| *x *= finer));
        }
        rung
    }
}

impl Decision {
    /// Whether f64 leaves an order open: it is undecided for another reason than too few runs.
    pub fn is_open(&self) -> bool {
        match self {
            Decision::Undecided(doubt) => !matches!(doubt, Doubt::FewRuns { .. }),
            _ => false,
        }
    }
}

/// What the rule says of a quantity in f64; where that leaves the order open, in double-double if that decides it and f64 differs from it by
/// rounding; where that leaves it open too, over the beginning of the motion. The other ladder is the second, where it decides.
pub fn decide_either(
    (ladder, precise, beginning): Ladders<'_>,
    quantity: Quantity,
) -> (Decision, Option<&Ladder>) {
    let own = decide(&Asked::of(ladder, quantity));
    if !own.is_open() {
        return (own, None);
    }
    let said = |other| (decide(&Asked::of(other, quantity)), Some(other));
    let finer = precise.filter(|finer| differ_by_rounding(ladder, finer, quantity)).map(said);
    // Where f64 is open, numbers of the start that differ in the last place of f64 may grow to another motion.
    let finer = finer.filter(|(found, _)| matches!(found, Decision::Exact | Decision::Order(_)));
    // An error that is still zero at the beginning is no evidence about the rest.
    let is_evidence = |found: &Decision| matches!(found, Decision::Order(_) | Decision::Elsewhere { .. });
    let early = || beginning.map(said).filter(|(found, _)| is_evidence(found));
    finer.or_else(early).unwrap_or((own, None))
}

/// Whether runs of the same step differ by no more than the floor of the one in f64: a defect of that code alone shows here.
fn differ_by_rounding(own: &Ladder, finer: &Ladder, quantity: Quantity) -> bool {
    let (own, finer) = (Asked::of(own, quantity), Asked::of(finer, quantity));
    let place = |time: &f64| own.times.iter().position(|own| own == time);
    let places: Vec<usize> = finer.times.iter().filter_map(place).collect();
    let alike = |run: &Run| {
        let of_f64 = own.runs.iter().find(|own| own.step == run.step);
        let Some(of_f64) = of_f64.filter(|own| !own.errors.is_empty() && !run.errors.is_empty()) else {
            return true;
        };
        let components = run.errors.len() / places.len();
        let errors = places.iter().flat_map(|place| of_f64.errors.chunks(components).nth(*place));
        let apart = errors.flatten().zip(&run.errors).map(|(own, finer)| own - finer);
        length(&apart.collect::<Vec<_>>()) <= own.floor(of_f64, places.last().map_or(0, |last| last + 1))
    };
    places.len() == finer.times.len() && finer.runs.iter().all(alike)
}

/// The system that the truth is of: a body given by mass points is the sum of them, and laws act on the points as f64 has them. `None` where
/// double-double does not hold its numbers, and for a scheme on points whose inertia is the given one to rounding of f64 only.
fn as_given(contestant: &Contestant, given: &System) -> Option<System<DoubleDouble>> {
    let system = System::<DoubleDouble>::of(given).ok()?;
    let exact = |p: &MassPoint| MassPoint {
        mass: DoubleDouble::exact(p.mass),
        position: p.position.map(DoubleDouble::exact),
    };
    let points: Vec<MassPoint<DoubleDouble>> = given.body.points.iter().map(exact).collect();
    let by_points = given.body.is_given_by_points();
    // Where no law acts on the points, those of double-double have the given inertia.
    if system.body.points == points || (!by_points && given.constant_force().0) {
        return Some(system);
    }
    // The points of a free rod lie on a line to rounding of f64 only, and the truth drops the part of L along it.
    let is_rod = matches!(given.body.shape, Shape::Rod { .. }) && !given.body.pivoted;
    if (by_points && is_rod) || (!by_points && contestant.model(given) == "points") {
        return None;
    }
    let body = if by_points { system.body.made_of(points) } else { Body { points, ..system.body.clone() } };
    Some(system.with_body(body, system.forces.laws().to_vec()))
}

/// The states of these places.
fn taken<T: Real>(states: &[Snapshot<T>], at: &[usize]) -> Vec<Snapshot<T>> {
    at.iter().filter_map(|index| states.get(*index)).copied().collect()
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
fn snapshot(moment: &precise::Moment) -> Snapshot<DoubleDouble> {
    let number = |x: precise::DoubleDouble| DoubleDouble::of_sum(x.high, x.low);
    let vector = |v: &[precise::DoubleDouble; 3]| Vector3::from(v.map(number));
    let axes = Matrix3::from_columns(&moment.axes.each_ref().map(vector));
    Snapshot {
        time: DoubleDouble::exact(moment.time),
        position: vector(&moment.position),
        velocity: vector(&moment.velocity),
        orientation: rotation::from_matrix(&axes),
        angular_velocity: vector(&moment.angular_velocity),
        angular_momentum: vector(&moment.angular_momentum),
        stretch: DoubleDouble::exact(0.0),
    }
}
