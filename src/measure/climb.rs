//! The same run at halved steps, until the rule of orders ([`super::order`]) decides every quantity.

use super::ladder::{Climbed, Truth, shortened};
use super::order::{Asked, Decision, decide};
use super::precise::{Precise, decide_either};
use crate::model::{Quantity, System};
use crate::record::{self, length};
use crate::reference::Reference;
use crate::rotation;
use crate::simulate::Contestant;

/// Fewest steps of a run.
const FEWEST_STEPS: u64 = 4;
/// Radians turned in a step of the coarsest run, of the body or of a force's own clock, at most.
const COARSEST_TURN: f64 = 1.6;
/// Every ladder comes down to this many steps, or to rounding: a term of lower order that the leading one hides shows at the fine end …
pub(super) const FINE: u64 = 2048;
/// … after so many runs at least.
pub(super) const FEWEST_RUNGS: usize = 6;
/// Steps after which a ladder that is not decided ends, …
const MOST_STEPS: u64 = 1 << 17;
/// … or after so many halvings, where its first run has many steps.
const MOST_HALVINGS: u32 = 10;
/// Least order that has a run between any two halvings: few of them lie between errors of the size of the motion and rounding.
const HIGH_ORDER: u32 = 6;
/// Evaluations of a run of an adaptive solver after which a ladder of [`FEWEST_RUNGS`] ends, …
const MOST_EVALUATIONS: u64 = 60_000;
/// … and its tolerances: none is looser, and solvers in f64 fail below.
const TOLERANCE: std::ops::RangeInclusive<f64> = 1e-12..=0.1;
/// Times of the truth over a beginning, without the start.
const BEGINNING_TIMES: usize = 4;
/// Steps of the runs of a steady spin beside its ladder: exact is exact at every step.
pub const GIANT_STEPS: [u64; 4] = [1, 3, 5, 7];

/// What a user wants of a ladder, in steps of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bounds {
    /// Steps of the first run, a power of two.
    pub coarsest: Option<u64>,
    /// Most steps of a run.
    pub finest: Option<u64>,
    /// Most steps of a run that there is time for; no run at all where it is 0.
    pub afforded: Option<u64>,
}

/// Runs a ladder. `order` is the claimed one, 0 where none is claimed: a ladder whose orders are below it goes on to the finest steps. Without
/// it, as in a scene that carries no order, the ladder does not.
pub fn climb(contestant: &Contestant, system: &System, reference: &Reference, order: Option<u32>) -> Climbed {
    climb_within(contestant, system, reference, order, Bounds::default())
}

/// The same within bounds. Where they end a ladder earlier than its rule does, it is the time that is short.
pub fn climb_within(
    contestant: &Contestant,
    system: &System,
    reference: &Reference,
    order: Option<u32>,
    bounds: Bounds,
) -> Climbed {
    let phase = phase(system, reference);
    // Sample times cut the steps of a solver that chooses them: over a turn or two there is one before the end.
    let fewest = if contestant.chooses_steps() { 0 } else { 1 };
    let truth = Truth::new(system, reference, quarters(reference, phase).max(fewest));
    let precise = Precise::new(contestant, &truth);
    let asked = steps(contestant, phase, order.unwrap_or_default(), bounds);
    let affordable = |steps: &u64| bounds.afforded.is_none_or(|most| *steps <= most);
    let (steps, left_out) = asked.split_at(asked.partition_point(affordable));
    let (mut climbed, is_done) = halved(contestant, &truth, steps, (order, precise.is_some()));
    climbed.left_out = left_out.first().copied().filter(|_| !is_done);
    let mut odd = odd_steps(contestant, system, &climbed);
    // A step across a jump of the laws says nothing of a scheme.
    odd.retain(|steps| ends_at_jumps(system, reference, *steps));
    // Where an error stays, runs whose steps meet a kink elsewhere show whether it is that of the kink.
    let lasting = lasting(&climbed.ladder).filter(|_| order.is_none() && !contestant.chooses_steps());
    odd.extend(lasting.into_iter().flat_map(between));
    climbed.ladder.odd = odd.into_iter().map(|steps| truth.odd(contestant, steps)).collect();
    if let Some(precise) = precise {
        climbed.precise = precise.climb(&climbed.ladder, steps, order.unwrap_or_default());
        climbed.exactness = steps.first().and_then(|first| precise.exactness(&climbed.ladder, *first));
    }
    climbed.truth = truth.states();
    if bounds == Bounds::default() && !contestant.chooses_steps() {
        climbed.beginning = beginning(contestant, system, &climbed, order.unwrap_or_default());
    }
    shortened(&mut climbed.ladder);
    let others = [&mut climbed.precise, &mut climbed.exactness, &mut climbed.beginning];
    others.into_iter().flatten().for_each(shortened);
    climbed
}

/// Runs of these steps until finer ones would not change the answer, and whether it came to that; `precise` says whether double-double takes over.
fn halved(
    contestant: &Contestant,
    truth: &Truth,
    steps: &[u64],
    (order, precise): (Option<u32>, bool),
) -> (Climbed, bool) {
    let mut climbed = Climbed {
        model: contestant.model(truth.system),
        ladder: truth.ladder(),
        precise: None,
        exactness: None,
        beginning: None,
        rungs: Vec::new(),
        finest: [Vec::new(), Vec::new()],
        truth: Vec::new(),
        left_out: None,
    };
    let is_done = steps.iter().any(|steps| {
        let (rung, shown, states) = truth.run(contestant, *steps, &mut climbed.ladder);
        climbed.ladder.rungs.push(rung);
        climbed.rungs.push(shown);
        climbed.finest.swap(0, 1);
        climbed.finest[0] = states;
        climbed.refusal().is_some() || is_done(contestant, &climbed, order, precise)
    });
    (climbed, is_done)
}

/// Runs over the beginning of the motion, where the whole leaves orders open: over the longest of its quarters of quarters that decides the most of
/// them. The shortest has four steps of the finest run. `None` where none is claimed, open or decided.
fn beginning(
    contestant: &Contestant,
    system: &System,
    climbed: &Climbed,
    order: u32,
) -> Option<record::Ladder> {
    let (own, precise) = (&climbed.ladder, climbed.precise.as_ref());
    let is_open = |quantity: &Quantity| decide_either((own, precise, None), *quantity).0.is_open();
    let open: Vec<Quantity> = Quantity::ALL.into_iter().filter(is_open).collect();
    if order == 0 || open.is_empty() {
        return None;
    }
    let decided = |ladder: &record::Ladder| {
        let is_decided =
            |quantity: &&Quantity| decide_either((own, precise, Some(ladder)), **quantity).1.is_some();
        open.iter().filter(is_decided).count()
    };
    let shortest = FEWEST_STEPS as f64 * own.rungs.last()?.step;
    let quarters = std::iter::successors(own.times.first().copied(), |time| Some(0.25 * time)).skip(1);
    let (mut most, mut found) = (0, None);
    for duration in quarters.take_while(|duration| *duration >= shortest) {
        let reference = Reference::of(system, duration, BEGINNING_TIMES, None).ok()?;
        let truth = Truth::new(system, &reference, 1);
        let bounds = Bounds { finest: Some(FINE), ..Bounds::default() };
        let steps = steps(contestant, phase(system, &reference), order, bounds);
        let ladder = halved(contestant, &truth, &steps, (Some(order), false)).0.ladder;
        if decided(&ladder) > most {
            (most, found) = (decided(&ladder), Some(ladder));
        }
        if most == open.len() {
            break;
        }
    }
    found
}

/// Steps of the runs beside a ladder, an odd number each.
fn odd_steps(contestant: &Contestant, system: &System, climbed: &Climbed) -> Vec<u64> {
    match decisive(&climbed.ladder) {
        _ if climbed.refusal().is_some() || contestant.chooses_steps() => Vec::new(),
        _ if system.steady_spin() => GIANT_STEPS.to_vec(),
        steps => steps.map(|steps| 3 * steps / 2 + 1).into_iter().collect(),
    }
}

/// Odd numbers between so many steps and twice as many, by the golden section: runs of halved steps and one of a simple multiple of them may meet a
/// kink at one distance from the end of a step.
fn between(steps: u64) -> [u64; 3] {
    [0.236, 0.618, 0.854].map(|part| ((1.0 + part) * steps as f64) as u64 | 1)
}

/// Steps of the coarser of the two finest runs where an error stays.
fn lasting(ladder: &record::Ladder) -> Option<u64> {
    let stays = |quantity| matches!(decide(&Asked::of(ladder, quantity)), Decision::Elsewhere { .. });
    let [.., coarser, _] = &ladder.rungs[..] else { return None };
    Quantity::ALL.into_iter().any(stays).then_some(coarser.steps)
}

/// Steps of the coarser of the two runs that decide an order, the most of any quantity; of a run in the middle where all are exact.
fn decisive(ladder: &record::Ladder) -> Option<u64> {
    let steps = |quantity| match decide(&Asked::of(ladder, quantity)) {
        Decision::Order(found) => Some(ladder.rungs[found.rungs - 2].steps),
        Decision::Exact => Some(ladder.rungs[ladder.rungs.len() / 2].steps),
        _ => None,
    };
    Quantity::ALL.into_iter().filter_map(steps).max()
}

/// Radians turned by the fastest of the body and the forces' own clocks.
pub(super) fn phase(system: &System, reference: &Reference) -> f64 {
    let fastest = reference.states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
    fastest.max(system.forces.fastest_clock()) * reference.times[reference.times.len() - 1]
}

/// Whether a run of so many steps ends one at each jump of the laws.
fn ends_at_jumps(system: &System, reference: &Reference, steps: u64) -> bool {
    let duration = reference.times[reference.times.len() - 1];
    let off = |jump: f64| {
        let step = jump / duration * steps as f64;
        (step - step.round()).abs()
    };
    // A jump is a number of f64, and so is the place in the run.
    let tiny = 4.0 * f64::EPSILON * steps as f64;
    system.forces.pieces().iter().all(|(end, _)| *end >= duration || off(*end) <= tiny)
}

/// How often the duration is quartered down to the first turn.
fn quarters(reference: &Reference, phase: f64) -> u32 {
    let turns = (phase / std::f64::consts::TAU).max(1.0);
    let most = (reference.times.len() - 1).ilog2() / 2;
    (turns.log2() / 2.0).floor().min(f64::from(most)) as u32
}

/// The steps of the runs, each twice as many as before, and from [`HIGH_ORDER`] on 3/2 and 4/3 times as many by turns; so are those of a solver
/// that chooses its own, which name its tolerances alone.
pub(super) fn steps(contestant: &Contestant, phase: f64, order: u32, bounds: Bounds) -> Vec<u64> {
    let least = (phase / COARSEST_TURN).min(contestant.most_steps() as f64).ceil() as u64;
    let first = bounds.coarsest.unwrap_or(least.next_power_of_two()).max(FEWEST_STEPS);
    let most = MOST_STEPS.max(first << MOST_HALVINGS).min(contestant.most_steps());
    let most = bounds.finest.map_or(most, |finest| finest.max(first));
    let halved = std::iter::successors(Some(first), |steps| Some(2 * steps));
    // The first has no middle in which every sample time ends a step.
    let middle = |steps: u64| (steps > first).then_some(3 * steps / 2);
    let halved_twice = halved.clone().flat_map(|steps| std::iter::once(steps).chain(middle(steps)));
    if contestant.chooses_steps() {
        let power = contestant.card.tolerance_exponent() as i32;
        let tolerance = |steps: &u64| (phase.max(1.0) / *steps as f64).powi(power);
        let asked = halved_twice.skip_while(|steps| tolerance(steps) > *TOLERANCE.end());
        return asked.take_while(|steps| tolerance(steps) >= *TOLERANCE.start()).collect();
    }
    let affordable = |steps: &u64| *steps <= most;
    if order < HIGH_ORDER {
        halved.take_while(affordable).collect()
    } else {
        halved_twice.take_while(affordable).collect()
    }
}

/// Whether finer runs would not change the answer; where double-double takes over, rounding ends it too.
fn is_done(contestant: &Contestant, climbed: &Climbed, order: Option<u32>, precise: bool) -> bool {
    let Some(finest) = climbed.ladder.rungs.last() else { return false };
    let exact = |quantity| {
        let asked = Asked::of(&climbed.ladder, quantity);
        asked.runs.last().is_some_and(|run| {
            !run.errors.is_empty() && length(&run.errors) <= asked.floor(run, asked.times.len())
        })
    };
    let decided = |quantity| match decide(&Asked::of(&climbed.ladder, quantity)) {
        Decision::Exact | Decision::Elsewhere { .. } => true,
        Decision::Order(found) => Some(found.order) >= order,
        Decision::Undecided(_) => false,
    };
    let at_rounding = Quantity::ALL.into_iter().all(exact);
    let decided_or_rounding = |quantity| decided(quantity) || (precise && exact(quantity));
    if contestant.chooses_steps() {
        let is_enough = climbed.rungs.len() >= FEWEST_RUNGS && finest.evaluations > MOST_EVALUATIONS;
        return is_enough || at_rounding;
    }
    let is_fine = climbed.rungs.len() >= FEWEST_RUNGS && (finest.steps >= FINE || at_rounding);
    is_fine && (order.is_none() || at_rounding || Quantity::ALL.into_iter().all(decided_or_rounding))
}
