//! The clauses, one function each: which runs are asked for, and what of them is measured against which limit.

use nalgebra::Vector3;

use super::{Clause, Evidence, PART, STEP, Stage, WHOLE};
use crate::engine::specimen;
use crate::engine::spread::allowance;
use crate::engine::subject::{NoStates, Subject};
use crate::model::copies::CLEAR;
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference, larger, retold, sizes};
use crate::ode::dop853;
use crate::rotation::{self, Rotation};
use crate::simulate::Plan;

/// What a program says of itself in a state; the other quantities follow from these.
const SAID: [Quantity; 4] =
    [Quantity::Position, Quantity::Velocity, Quantity::Orientation, Quantity::AngularVelocity];

/// A part of a run.
const PARTED: Plan = Plan { step: STEP, steps: PART, every: PART };

/// Spin of the slow motion [rad/s], below the 0.01 to 1 rad/s at which engines put bodies to sleep.
const SLOW_SPIN: f64 = 1e-3;
/// The slow motion: a radian in a thousand steps, so that a scheme of first order is off by far less than [`ASLEEP`].
const SLOW: Plan = Plan { step: 1.0, steps: 1000, every: 1000 };
/// Part of the truth's way that a slow motion may be off by.
const ASLEEP: f64 = 0.1;
/// A way of the truth that shows anything [rad, m]: the slow motions go 0.25 and more where they go at all.
const A_WAY: f64 = 0.1;

/// The run at a small step: 0.001 s, in which a body turns by less than 2.5e-3 rad.
const SMALL: Plan = Plan { step: 1e-3, steps: 1000, every: 10 };
/// How far the energy of a free body may stand above L²/(2 I_min): a scheme of first order drifts by about the turn of a
/// step, 2.5e-3, in each radian, and the run is less than three radians long.
const ABOVE_BOUND: f64 = 1.01;
/// How many times larger than the truth positions and velocities may be: no scheme at a small step comes near it.
const ABSURD: f64 = 1e3;

/// The turn of the body axes [rad], about no axis of any scene.
const TURN: Vector3<f64> = Vector3::new(0.9, -1.3, 0.4);

type Seen = Result<Evidence, NoStates>;

/// What is seen of a clause in each scene, with the name of the scene.
pub(super) fn see(clause: Clause, subject: &mut Subject, stages: &[Stage]) -> Vec<(String, Evidence)> {
    if clause == Clause::Moves {
        return moves(subject);
    }
    let look = match clause {
        Clause::ZeroStep => zero_step,
        Clause::TwoParts => two_parts,
        Clause::Restart => restart,
        Clause::SameTwice => same_twice,
        Clause::TwoCopies => two_copies,
        Clause::SaneNumbers | Clause::Moves => sane_numbers,
        Clause::DescribedAlike => described_alike,
    };
    let stages = stages.iter();
    stages.map(|stage| (stage.name.to_owned(), look(subject, stage).unwrap_or_else(Evidence::from))).collect()
}

/// The worst of the quantities that a program says, beside its limit.
fn worst(what: &str, sizes: &PerQuantity<f64>, limits: &PerQuantity<f64>) -> Evidence {
    let evidence = SAID.map(|quantity| Evidence::Size {
        what: format!("{what}: {}", quantity.name().replace('-', " ")),
        size: sizes[quantity],
        limit: limits[quantity],
        unit: quantity.unit(),
    });
    most_severe(evidence)
}

/// The worst of some evidence.
fn most_severe(evidence: impl IntoIterator<Item = Evidence>) -> Evidence {
    let worst = evidence.into_iter().reduce(|a, b| if b.severity() > a.severity() { b } else { a });
    worst.unwrap_or_else(|| super::nothing().1)
}

/// The last state of a run.
fn end(subject: &mut Subject, system: &System, plan: &Plan) -> Result<Snapshot, NoStates> {
    let states = subject.run(system, plan)?.states;
    states.last().copied().ok_or_else(|| NoStates::Fault("the answer has no state".to_owned()))
}

/// A few steps of zero length, against the start.
fn zero_step(subject: &mut Subject, stage: &Stage) -> Seen {
    let plan = Plan { step: 0.0, steps: 4, every: 1 };
    let states = match subject.run(&stage.system, &plan) {
        Err(why @ (NoStates::Refused(_) | NoStates::Failed(_))) => {
            return Ok(Evidence::RefusedAloud(why.to_string()));
        }
        other => other?.states,
    };
    let start = stage.system.start;
    let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let start = Snapshot {
        time: 0.0,
        position: start.position,
        velocity: start.velocity,
        orientation: start.orientation,
        angular_velocity: start.orientation * (stage.system.body.inverse_inertia() * momentum),
        angular_momentum: start.angular_momentum,
        stretch: 0.0,
    };
    let changes = states.iter().map(|state| difference(&stage.system.body, state, &start));
    let moved =
        changes.fold(PerQuantity::all(0.0), |largest, change| largest.zip(change).map(|(a, b)| larger(a, b)));
    Ok(worst("change", &moved, &stage.grain.times(CLEAR, &sizes(&stage.system, &[start]))))
}

fn two_parts(subject: &mut Subject, stage: &Stage) -> Seen {
    in_parts(subject, stage, false)
}

fn restart(subject: &mut Subject, stage: &Stage) -> Seen {
    in_parts(subject, stage, true)
}

/// A whole run beside two parts of it, the second in a new process where asked for.
fn in_parts(subject: &mut Subject, stage: &Stage, anew: bool) -> Seen {
    let system = &stage.system;
    let whole = subject.run(system, &WHOLE)?.states;
    let limits = allowance(subject, (system, &stage.grain), &WHOLE, &whole)?;
    let half = end(subject, system, &PARTED)?;
    if anew {
        subject.restart();
    }
    let parts = end(subject, &system.started_at(&half), &PARTED)?;
    Ok(match whole.last() {
        Some(whole) => worst("difference", &difference(&system.body, whole, &parts), &limits),
        None => super::nothing().1,
    })
}

fn same_twice(subject: &mut Subject, stage: &Stage) -> Seen {
    subject.restart();
    let first = subject.run(&stage.system, &WHOLE)?.states;
    let second = subject.run(&stage.system, &WHOLE)?.states;
    Ok(to_the_bit(&stage.system, &first, &second))
}

fn two_copies(subject: &mut Subject, stage: &Stage) -> Seen {
    subject.restart();
    let one = subject.run(&stage.system, &WHOLE)?.states;
    subject.restart();
    let other = subject.run(&stage.system, &WHOLE)?.states;
    Ok(to_the_bit(&stage.system, &one, &other))
}

/// The largest difference of two runs that should be the same to the last bit. Where the states differ in the sign of a
/// quaternion alone, their number is what is measured.
fn to_the_bit(system: &System, one: &[Snapshot], other: &[Snapshot]) -> Evidence {
    let pairs = one.iter().zip(other);
    let count = pairs.clone().filter(|(a, b)| a != b).count();
    let largest = pairs
        .filter(|(a, b)| a != b)
        .map(|(a, b)| difference(&system.body, a, b))
        .fold(PerQuantity::all(0.0), PerQuantity::max);
    let found = SAID.into_iter().filter(|quantity| largest[*quantity] > 0.0);
    let relative = |quantity: &Quantity| largest[*quantity] / sizes(system, one)[*quantity];
    match found.max_by(|a, b| relative(a).total_cmp(&relative(b))) {
        Some(quantity) => Evidence::Size {
            what: format!("difference: {}", quantity.name().replace('-', " ")),
            size: largest[quantity],
            limit: 0.0,
            unit: quantity.unit(),
        },
        None => {
            Evidence::Size { what: "difference:".to_owned(), size: count as f64, limit: 0.0, unit: "states" }
        }
    }
}

/// A slow spin, and a body at rest under a weak force.
fn moves(subject: &mut Subject) -> Vec<(String, Evidence)> {
    let mut seen = vec![("a slow spin".to_owned(), goes(subject, &slow_spin()))];
    for (law, lines) in WEAK {
        let text = format!("[[forces]]\nlaw = \"{law}\"\n{lines}\n");
        let mut system = specimen::scene(&text, "");
        system.start.velocity = Vector3::zeros();
        system.start.angular_momentum = Vector3::zeros();
        let evidence = goes(subject, &system);
        let taken = !matches!(evidence, Evidence::NotTaken(_));
        seen.push((format!("a body at rest under weak {law}"), evidence));
        if taken {
            break;
        }
    }
    seen
}

/// Forces that move the body of the check, 2 kg, by 0.25 m and more in 1000 s: half of 1e-6 m/s² times the square of the
/// time is 0.5 m, and a spring of 2e-6 N/m has swung through a radian.
const WEAK: [(&str, &str); 2] = [
    ("gravity", "acceleration = [0.0, 0.0, -1e-6]"),
    ("spring", "point = 0\nanchor = [0.0, 0.0, 1.0]\nstiffness = 2e-6"),
];

/// The free body with a slow spin and no velocity.
fn slow_spin() -> System {
    let mut system = super::free();
    let start = &mut system.start;
    let spin = start.orientation.inverse_transform_vector(&(Vector3::new(0.6, 0.0, 0.8) * SLOW_SPIN));
    start.angular_momentum = start.orientation * (system.body.inertia * spin);
    start.velocity = Vector3::zeros();
    system
}

/// How far the end of a slow motion is off, beside a part of the truth's way.
fn goes(subject: &mut Subject, system: &System) -> Evidence {
    let duration = SLOW.step * SLOW.steps as f64;
    let truth = match dop853::solve(system, &[duration], dop853::TOLERANCE) {
        Ok(run) => run.states[0],
        Err(error) => return NoStates::NotAsked(error.to_string()).into(),
    };
    let end = match end(subject, system, &SLOW) {
        Ok(end) => end,
        Err(why) => return why.into(),
    };
    let start = &system.start;
    let ways = [
        (Quantity::Position, rotation::length(&(truth.position - start.position))),
        (Quantity::Orientation, rotation::angle_between(&truth.orientation, &start.orientation)),
    ];
    let off = difference(&system.body, &end, &truth);
    most_severe(ways.into_iter().filter(|(_, way)| *way > A_WAY).map(|(quantity, way)| Evidence::Size {
        what: format!("{} after {duration} s off by", quantity.name()),
        size: off[quantity],
        limit: ASLEEP * way,
        unit: quantity.unit(),
    }))
}

/// Energies of the free body, and positions and velocities, at a small step.
fn sane_numbers(subject: &mut Subject, stage: &Stage) -> Seen {
    let system = &stage.system;
    let states = subject.run(system, &SMALL)?.states;
    let times: Vec<f64> =
        (0..=10).map(|part| f64::from(part) * 0.1 * SMALL.step * SMALL.steps as f64).collect();
    let truth = dop853::solve(system, &times, dop853::TOLERANCE)
        .map_err(|error| NoStates::NotAsked(error.to_string()))?
        .states;
    let (own, limits) = (sizes(system, &states), sizes(system, &truth).map(|size| ABSURD * size));
    let mut evidence: Vec<Evidence> = [Quantity::Position, Quantity::Velocity, Quantity::AngularVelocity]
        .map(|quantity| Evidence::Size {
            what: format!("largest {}", quantity.name().replace('-', " ")),
            size: own[quantity],
            limit: limits[quantity],
            unit: quantity.unit(),
        })
        .into();
    if system.torque_free() {
        let energies = states.iter().map(|state| system.rotational_energy(state));
        evidence.push(Evidence::Size {
            what: "largest energy of the rotation".to_owned(),
            size: energies.fold(0.0, larger),
            limit: ABOVE_BOUND * system.start.angular_momentum.norm_squared()
                / (2.0 * system.body.moments.min()),
            unit: "J",
        });
    }
    Ok(most_severe(evidence))
}

/// The same body described in three other ways, each beside the run of the scene.
fn described_alike(subject: &mut Subject, stage: &Stage) -> Seen {
    let system = &stage.system;
    let whole = subject.run(system, &WHOLE)?.states;
    let limits = allowance(subject, (system, &stage.grain), &WHOLE, &whole)?;
    let Some(whole) = whole.last() else { return Ok(super::nothing().1) };
    let axes = rotation::turn(&TURN);
    let none = Rotation::identity();
    let ways = [
        ("other body axes", Some(retold::in_axes(system, &axes)), axes),
        ("points in another order", retold::permuted(system), none),
        ("a point split in two", retold::split(system), none),
    ];
    let mut evidence = Vec::new();
    for (way, other, axes) in ways {
        let Some(other) = other else { continue };
        match end(subject, &other, &WHOLE) {
            Ok(mut end) => {
                end.orientation *= axes;
                evidence.push(worst(way, &difference(&system.body, whole, &end), &limits));
            }
            Err(why) => evidence.push(Evidence::from(why)),
        }
    }
    Ok(most_severe(evidence))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::forces::Law;

    #[test]
    fn a_body_in_other_axes_moves_alike_under_every_law() {
        let axes = rotation::turn(&TURN);
        let laws = Law::ALL.map(|law| (specimen::law(law.name), ""));
        for (forces, pivot) in laws.into_iter().chain([(String::new(), "pivot = [0.1, 0.2, -0.3]")]) {
            let system = specimen::scene(&forces, pivot);
            let end = |system: &System| {
                dop853::solve(system, &[0.5], dop853::TOLERANCE).expect("a solution").states[0]
            };
            let (own, mut other) = (end(&system), end(&retold::in_axes(&system, &axes)));
            other.orientation *= axes;
            let apart = difference(&system.body, &own, &other);
            // Smooth laws agree to 1e-14; on the ground the solver meets a kink, and its error control leaves 3e-12.
            assert!(SAID.iter().all(|quantity| apart[*quantity] < 1e-11), "{forces}{pivot}: {apart:?}");
        }
    }

    #[test]
    fn the_truth_of_the_slow_motions_goes_a_way_that_shows() {
        let truth = |system: &System| {
            dop853::solve(system, &[1000.0], dop853::TOLERANCE).expect("a solution").states[0]
        };
        let spin = slow_spin();
        let turned = rotation::angle_between(&truth(&spin).orientation, &spin.start.orientation);
        assert!(turned > 0.9 && turned < 1.1, "{turned}");
    }
}
