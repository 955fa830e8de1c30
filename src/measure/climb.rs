//! The same run at halved steps, until the orders of a scheme on a scene are settled.

use super::cause::likeliest_cause;
use super::giant_steps::giant_steps;
use super::ladder::{APART, BAND, Evidence, Place, QuantityLadder, Rung};
use super::order::Decision;
use super::past_break::goes_on_in;
use super::rounding::{Adding, Rounding};
use super::sightings::Sightings;
use super::{ALL, Reading, Sight, errors, largest, tolerance};
use crate::measure::regression::Ladder;
use crate::model::forces::Law;
use crate::model::{PerQuantity, Quantity, Snapshot, System};
use crate::reference::Reference;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan, Trajectory};

/// Fewest rungs of a ladder.
const FEWEST_RUNGS: usize = 6;
/// Further rungs of a ladder that carries no order, while its runs do not tell where they go.
const MORE_RUNGS: usize = 3;
/// Steps of its rungs, over those of the coarsest, where a force has a kink: about powers of two, and no two with a common factor.
const PAST_A_KINK: [u64; FEWEST_RUNGS + MORE_RUNGS] = [1, 2, 5, 7, 17, 31, 67, 127, 257];
/// Most rungs of a ladder.
const MOST_RUNGS: usize = 20;
/// Radians turned in a step of the coarsest rung, at most.
const COARSEST_TURN: f64 = 0.4;
/// Order from which on a run may have fewer steps than the reference has samples, …
const HIGH_ORDER: u32 = 4;
/// … and is compared at this many.
const FEWEST_SAMPLES: usize = 8;
/// A solver that chooses its own steps is compared at this many.
const SAMPLES_OF_OWN_STEPS: usize = 4;
/// Change of a slope by one more rung from which on the ladder may still become something else.
const STANDS: f64 = 0.02;
/// Slope below which errors hardly fall.
const FLAT: f64 = 0.5;
/// Fewest steps of a run of a program under test.
const FEWEST_STEPS_BY_RULE: u64 = 4;
/// Numbers of its sample times: the end, a quarter of the run, a sixteenth and so on are among them.
const SAMPLES_BY_RULE: [usize; 3] = [64, 16, 4];
/// Radians turned in a step of its coarsest rung, at most.
const COARSEST_TURN_BY_RULE: f64 = 1.6;
/// Rungs of a program under test after which the rule of orders is asked, …
const FEWEST_BY_RULE: usize = 5;
/// … in a scene without an order, at most …
const MOST_WITHOUT_ORDER: usize = 8;
/// … and most steps of a run of it, which is made four times.
const MOST_STEPS_BY_RULE: u64 = 1 << 15;
/// Steps of the run that rounding is measured in, over those of the coarsest rung, …
const MEASURED_AT: u64 = 4;
/// … and at most, where that run does not follow the truth and a finer one does.
const MOST_STEPS_OF_MEASUREMENT: u64 = 1 << 16;

/// Runs a ladder. `order` is the claimed one: the ladder grows finer until every quantity's order is settled, at
/// its floor, or out of reach.
///
/// The higher the order, the larger the steps that the ladder begins at, so that a few halvings remain above
/// rounding: √2 times for each order above two. From the fourth on there is a rung between any two halvings, and the
/// maximum over the run is taken over eight samples.
///
/// Where `settle` is false, as in a scene that carries no order, six rungs are enough, or a few more where those do not tell
/// whether they come to the truth.
pub fn climb(
    contestant: &Contestant,
    system: &System,
    reference: &Reference,
    order: u32,
    settle: bool,
) -> Evidence {
    let by_rule = contestant.has_own_clock();
    let first_by_rule = first_by_rule(reference);
    let coarser = 2f64.powf(f64::from(order.saturating_sub(2)) / 2.0);
    let samples = match order {
        // Every stored time cuts a step that the solver has chosen.
        _ if contestant.card.tolerance_exponent() > 0 => SAMPLES_OF_OWN_STEPS,
        _ if by_rule => samples_by_rule(first_by_rule),
        HIGH_ORDER.. => FEWEST_SAMPLES,
        _ => reference.times.len() - 1,
    };
    let thinned = reference.thinned((reference.times.len() - 1) / samples);
    let reference = &thinned;
    let coarsest = COARSEST_TURN * coarser;
    let samples = reference.times.len() as u64 - 1;
    let duration = reference.times[reference.times.len() - 1];
    let turned =
        reference.states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max) * duration;
    let mut first = match order {
        _ if by_rule => first_by_rule,
        HIGH_ORDER.. => 2 * samples,
        _ => samples,
    };
    while !by_rule && turned / first as f64 > coarsest && first << FEWEST_RUNGS <= contestant.most_steps() {
        first *= 2;
    }
    // The rounding of h turns the forces that read the time as it turns the body.
    let phase = turned + system.forces.fastest_clock() * duration;
    let motion = &reference.states;
    let mut rounding = Rounding::measure(contestant, system, motion, &plan(reference, MEASURED_AT * first));
    let mut followed = false;
    let mut evidence = Evidence {
        model: contestant.model(system),
        rungs: Vec::new(),
        ladders: Vec::new(),
        giant_steps: Vec::new(),
        goes_on_in: None,
        by_rule: None,
    };
    let mut sightings = by_rule.then(|| Sightings::new(system, reference));
    let kink = !settle && system.forces.laws().iter().any(|law| matches!(law, Law::Ground(_)));
    let (mut before, mut coarser_run) = (Vec::new(), Vec::new());
    let mut earlier: Vec<Vec<QuantityLadder>> = Vec::new();
    // Rungs of one halving of h.
    let halving = if order < HIGH_ORDER || sightings.is_some() { 1 } else { 2 };
    for index in 0..MOST_RUNGS {
        let steps =
            if sightings.is_some() { first << index } else { steps_of_rung(first, index, order, kink) };
        // The steps of a solver that chooses its own are its tolerances' names alone.
        let dear = steps > contestant.most_steps() && contestant.card.tolerance_exponent() == 0;
        let dear_by_rule = sightings.is_some() && steps > MOST_STEPS_BY_RULE && index >= FEWEST_BY_RULE;
        if dear && index >= FEWEST_RUNGS || dear_by_rule {
            break;
        }
        let plan = plan(reference, steps);
        // A steady spin is exact at every step but for roundings, and those a large step may amplify by itself.
        let own = system.steady_spin().then(|| Rounding::measure(contestant, system, motion, &plan));
        let of_law = |rounding: &Rounding, law| rounding.floors(system, reference, steps, phase, law);
        let floors = of_law(own.as_ref().unwrap_or(&rounding), Adding::Alike);
        let (mut rung, states) = run_rung(contestant, system, reference, steps, floors, &before);
        if !followed && rung.follows(system) {
            followed = true;
            // Coarser runs went another way, past another instability.
            if own.is_none() && steps > MEASURED_AT * first && steps <= MOST_STEPS_OF_MEASUREMENT {
                rounding = Rounding::measure(contestant, system, motion, &plan);
                rung.floors = of_law(&rounding, Adding::Alike);
            }
        }
        if own.is_none()
            && sightings.is_none()
            && rung.is_clear_by_one_law(&of_law(&rounding, Adding::Unlike))
        {
            rounding.draw_again(contestant, system, motion, &plan, &states);
            rung.floors = of_law(&rounding, Adding::Alike);
        }
        let refused = rung.outcome.refusal().is_some();
        evidence.rungs.push(rung);
        if refused {
            break;
        }
        if let Some(sightings) = &mut sightings {
            sightings.take_in(contestant, (system, reference), &plan, &states);
            evidence.ladders = ladders(&evidence.rungs, order);
            coarser_run = std::mem::replace(&mut before, states);
            if index + 1 >= FEWEST_BY_RULE {
                let by_rule = sightings.judged(contestant);
                let open = |decision: &Decision| matches!(decision, Decision::Undecided(_));
                let done = !by_rule.decisions.values().any(open);
                evidence.by_rule = Some(by_rule);
                if done || !settle && index + 1 >= MOST_WITHOUT_ORDER {
                    break;
                }
            }
            continue;
        }
        before = states;
        if index + 1 >= FEWEST_RUNGS {
            evidence.ladders = ladders(&evidence.rungs, order);
            let last = earlier.len().checked_sub(halving).map(|index| &earlier[index]);
            let of_last = |index: usize| last.and_then(|ladders| ladders.get(index));
            let mut pairs = evidence.ladders.iter().enumerate();
            let power = contestant.card.tolerance_exponent();
            let done = match settle {
                _ if power > 0 => tolerance::settled(&evidence, system, power),
                false => tells_where_it_goes(&evidence.rungs) || index + 1 >= FEWEST_RUNGS + MORE_RUNGS,
                // A scheme that claims no order has none to settle.
                true => order == 0 || pairs.all(|(index, ladder)| settled(ladder, of_last(index), order)),
            };
            if done {
                break;
            }
            earlier.push(evidence.ladders.clone());
        }
    }
    if let Some(by_rule) = evidence.by_rule.as_mut().filter(|by_rule| by_rule.fails()) {
        by_rule.cause = likeliest_cause(system, &reference.states, &before, &coarser_run);
    }
    evidence.goes_on_in = evidence.rungs.last().and_then(|finest| goes_on_in(contestant, system, finest));
    if system.steady_spin() && evidence.refusal().is_none() {
        evidence.giant_steps = giant_steps(contestant, system, reference, turned);
    }
    evidence
}

/// Steps of the coarsest run of a program under test.
fn first_by_rule(reference: &Reference) -> u64 {
    let duration = reference.times.last().copied().unwrap_or_default();
    let fastest = reference.states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
    let mut first = FEWEST_STEPS_BY_RULE;
    while fastest * duration / first as f64 > COARSEST_TURN_BY_RULE && first < MOST_STEPS_BY_RULE {
        first *= 2;
    }
    first
}

/// The most sample times that end a step of every run and divide those of the reference.
fn samples_by_rule(first: u64) -> usize {
    let fits = |samples: &&usize| first.is_multiple_of(**samples as u64);
    SAMPLES_BY_RULE.iter().find(fits).copied().unwrap_or(FEWEST_STEPS_BY_RULE as usize)
}

/// Steps of a rung: halvings of h, and from the fourth order on their middles too, 3/2 and 4/3 times as many by turns. Where a force has
/// a kink the ends of steps must not be the same from rung to rung: one that lies by chance at the kink makes one error in all of them.
fn steps_of_rung(first: u64, index: usize, order: u32, kink: bool) -> u64 {
    if kink {
        return first * PAST_A_KINK.get(index).copied().unwrap_or(1 << index);
    }
    if order < HIGH_ORDER {
        return first << index;
    }
    (if index.is_multiple_of(2) { first } else { first / 2 * 3 }) << (index / 2)
}

/// Whether the last two runs came to their ends, and differ from one another by as much as from the truth or are at its floor.
fn tells_where_it_goes(rungs: &[Rung]) -> bool {
    let [.., before, last] = rungs else { return false };
    let whole = |rung: &Rung| rung.outcome.broken.is_none();
    let point = Quantity::BodyPoint;
    let (error, floor) = (last.errors[point].max, last.floors[point].max);
    whole(before) && whole(last) && (error <= 10.0 * floor || last.moved[point].max >= APART * error)
}

/// Whether a finer rung would change nothing: the order holds, the error is at its floor, or the last halving of h has
/// left the slope where it was, below the band. (What a slope still has to go is about what the last halving changed,
/// where the next term of the error is one power of h higher. A slope above the band may stand there for as long as the next
/// term leads, and come down at last.)
fn settled(ladder: &QuantityLadder, last: Option<&QuantityLadder>, order: u32) -> bool {
    let at_floor = ladder.rungs.last().is_some_and(|(_, e, floor)| *e <= 10.0 * floor);
    let before = last.and_then(QuantityLadder::fit);
    let stands = ladder.fit().zip(before).is_some_and(|(now, before)| {
        // What a slope still has to go is about what the last halving changed: it must not be enough to come into the band.
        let change = (now.slope - before.slope).abs();
        let below = now.slope + change < f64::from(order) - BAND;
        // A slope that has come to rest at another whole order will not leave it for the claimed one.
        let at_rest = (now.slope - now.slope.round()).abs() < STANDS && change < 0.25 * STANDS;
        (below && change < STANDS || at_rest) && !ladder.is_on_its_way(order)
    });
    at_floor || stands || ladder.holds(order)
}

fn run_rung(
    contestant: &Contestant,
    system: &System,
    reference: &Reference,
    steps: u64,
    floors: PerQuantity<Reading>,
    before: &[Snapshot],
) -> (Rung, Vec<Snapshot>) {
    let plan = plan(reference, steps);
    let Trajectory { states, outcome } = contestant.run(system, Form::Least, &plan);
    let nothing = PerQuantity::all(Reading::NAN);
    let (mut measured, mut readings) = (nothing, vec![None; ALL.len()]);
    let moved = if before.len() == states.len() { largest(system, &states, before) } else { nothing };
    if outcome.broken.is_none() {
        let sight = Sight { system, reference, states: &states };
        measured = errors(&sight);
        readings = ALL.iter().map(|metric| metric.measure(&sight)).collect();
    }
    (Rung { step: plan.step, steps, errors: measured, floors, moved, readings, outcome }, states)
}

fn plan(reference: &Reference, steps: u64) -> Plan {
    let samples = reference.times.len() as u64 - 1;
    Plan::over(reference.times[reference.times.len() - 1], steps, samples)
}

fn ladders(rungs: &[Rung], order: u32) -> Vec<QuantityLadder> {
    let mut ladders = Vec::new();
    for quantity in Quantity::ALL {
        for place in Place::ALL {
            let points: Vec<_> = rungs
                .iter()
                .map(|r| (r.step, place.of(&r.errors[quantity]), place.of(&r.floors[quantity])))
                .collect();
            let moved: Vec<f64> = rungs.iter().map(|r| place.of(&r.moved[quantity])).collect();
            let mut ladder = QuantityLadder::of(quantity, place, points, order);
            if is_doubtful(&ladder, &moved, order) {
                (ladder.ladder, ladder.constant) = (Ladder::Unsettled, None);
            }
            ladders.push(ladder);
        }
    }
    ladders
}

/// A window whose slope is below the claimed order says nothing of the limit h → 0 where its runs do not agree with one another
/// as that slope would have it: where they differ by far more (errors as large as the motion do not fall, yet every run goes a
/// way of its own), and where errors hardly fall and the runs do not come nearer to one another either. (Runs that agree with
/// one another but not with the truth stay: they converge to something wrong.)
fn is_doubtful(ladder: &QuantityLadder, moved: &[f64], order: u32) -> bool {
    let Ladder::Window { rungs, fit } = &ladder.ladder else { return false };
    let (last, before) = (rungs.end - 1, rungs.end - 2);
    let (fine, coarse) = (ladder.rungs[last], ladder.rungs[before]);
    let expected = (coarse.0 / fine.0).powf(fit.slope.max(0.0)) - 1.0;
    let differ = moved[last] > (3.0 * expected + 0.1) * fine.1;
    // Even a first-order rule that converges to something wrong comes nearer to it by half with every halving.
    let wander = fit.slope < FLAT && moved[last] > 0.01 * fine.1 && moved[last] > 0.75 * moved[before];
    fit.slope < f64::from(order) - BAND && (differ || wander)
}
