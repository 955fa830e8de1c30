//! Metrics that read something else than an error. A right scheme runs and a right gate judges what they say.

use super::planted::{Measure, Plant, Row};
use crate::measure::{Climbed, between};
use crate::model::{PerQuantity, Quantity, Snapshot, System};
use crate::record::{self, length};
use crate::reference::Reference;
use crate::simulate::{Contestant, Form, Plan};

const FREE: &[&str] = &["free-asymmetric", "fast-sphere", "free-rod", "tether-springs"];

const SLOW: &[&str] = &["satellite-gravity-gradient"];

/// A run at the sample times, the truth there, and the right error vectors.
pub(super) struct Seen<'a> {
    system: &'a System,
    run: &'a [Snapshot],
    truth: &'a [Snapshot],
    right: &'a PerQuantity<Vec<f64>>,
}

/// Wrong metrics.
pub(super) const METRICS: &[Row] = &[
    ("angle by 2 acos |w|", Plant::Metric(acos), FREE),
    ("angle in degrees", Plant::Metric(|s| s.scaled(Quantity::Orientation, 57.295_779_513_082_32)), FREE),
    ("angle of the half quaternion", Plant::Metric(|s| s.scaled(Quantity::Orientation, 0.5)), FREE),
    ("the largest so far for each", Plant::Metric(largest_so_far), FREE),
    ("the last for all", Plant::Metric(|s| s.of_samples(|all, _| all[all.len() - 1].to_vec())), FREE),
    ("the mean for all", Plant::Metric(mean), FREE),
    ("the reference one sample late", Plant::Metric(|s| s.between(late, <[Snapshot]>::to_vec)), FREE),
    ("the run one sample late", Plant::Metric(|s| s.between(<[Snapshot]>::to_vec, late)), FREE),
    (
        "the last sample left out",
        Plant::Metric(|s| s.of_samples(|all, index| all[index.min(all.len() - 2)].to_vec())),
        FREE,
    ),
    (
        "the first half of the run alone",
        Plant::Metric(|s| s.of_samples(|all, index| all[index.min(all.len() / 2)].to_vec())),
        FREE,
    ),
    (
        "components for lengths",
        Plant::Metric(|s| {
            s.each(|_, vector| {
                vector.iter().enumerate().map(|(i, x)| if i == 0 { *x } else { 0.0 }).collect()
            })
        }),
        &["tether-springs", "gravity-drag"],
    ),
    (
        "an absolute threshold of 1e-6",
        Plant::Metric(|s| {
            s.each(|_, vector| if length(vector) < 1e-6 { vec![0.0; vector.len()] } else { vector.to_vec() })
        }),
        SLOW,
    ),
    (
        "squares of errors",
        Plant::Metric(|s| s.each(|_, vector| vector.iter().map(|x| x * length(vector)).collect())),
        FREE,
    ),
    ("NaN taken for no error", Plant::Metric(|s| s.each(|_, vector| vec![0.0; vector.len()])), FREE),
    ("quantities in another order", Plant::Metric(swapped), FREE),
    ("position relative to the path", Plant::Metric(relative_to_path), &["tether-springs", "gravity-drag"]),
    ("run compared with itself", Plant::Metric(|s| s.between(|run| run.to_vec(), |_| Vec::new())), FREE),
];

type Vectors = PerQuantity<Vec<f64>>;

impl Seen<'_> {
    /// A change of the vector at each sample time.
    fn each(&self, change: impl Fn(Quantity, &[f64]) -> Vec<f64>) -> Vectors {
        PerQuantity::of(|quantity| {
            let right = &self.right[quantity];
            let parts = (right.len() / self.truth.len()).max(1);
            right.chunks(parts).flat_map(|vector| change(quantity, vector)).collect()
        })
    }

    /// The vector of each sample time from those of all.
    fn of_samples(&self, change: impl Fn(&[&[f64]], usize) -> Vec<f64>) -> Vectors {
        PerQuantity::of(|quantity| {
            let right = &self.right[quantity];
            let all: Vec<&[f64]> = right.chunks((right.len() / self.truth.len()).max(1)).collect();
            (0..all.len()).flat_map(|index| change(&all, index)).collect()
        })
    }

    fn scaled(&self, scaled: Quantity, factor: f64) -> Vectors {
        self.each(|quantity, vector| {
            let factor = if quantity == scaled { factor } else { 1.0 };
            vector.iter().map(|x| factor * x).collect()
        })
    }

    /// The run against the truth, both changed; against the run itself where there is no truth.
    fn between(
        &self,
        run: impl Fn(&[Snapshot]) -> Vec<Snapshot>,
        truth: impl Fn(&[Snapshot]) -> Vec<Snapshot>,
    ) -> Vectors {
        let (run, truth) = (run(self.run), truth(self.truth));
        between(&self.system.body, &run, if truth.is_empty() { &run } else { &truth })
    }
}

/// Every state a sample late.
fn late(states: &[Snapshot]) -> Vec<Snapshot> {
    states.iter().take(1).chain(states).take(states.len()).copied().collect()
}

fn acos(seen: &Seen) -> Vectors {
    let mut vectors = seen.right.clone();
    let parts = (vectors[Quantity::Orientation].len() / seen.truth.len()).max(1);
    let pairs = seen.run.iter().zip(seen.truth);
    for ((a, b), vector) in pairs.zip(vectors[Quantity::Orientation].chunks_mut(parts)) {
        let angle = 2.0 * (a.orientation.inverse() * b.orientation).w.abs().min(1.0).acos();
        let right = length(vector);
        vector.iter_mut().for_each(|x| *x *= if right > 0.0 { angle / right } else { 0.0 });
    }
    vectors
}

fn largest_so_far(seen: &Seen) -> Vectors {
    seen.of_samples(|all, index| {
        let so_far = all[..=index].iter().max_by(|a, b| length(a).total_cmp(&length(b)));
        so_far.map_or_else(Vec::new, |vector| vector.to_vec())
    })
}

fn mean(seen: &Seen) -> Vectors {
    seen.of_samples(|all, _| {
        let sum = |part: usize| all.iter().map(|vector| vector[part]).sum::<f64>();
        (0..all[0].len()).map(|part| sum(part) / all.len() as f64).collect()
    })
}

/// The spin has the size of the angle, and the angle that of the spin.
fn swapped(seen: &Seen) -> Vectors {
    let mut vectors = seen.right.clone();
    let (angle, spin) = (Quantity::Orientation, Quantity::AngularVelocity);
    for (own, other) in [(angle, spin), (spin, angle)] {
        let (size, wanted) = (length(&seen.right[own]), length(&seen.right[other]));
        vectors[own].iter_mut().for_each(|x| *x *= if size > 0.0 { wanted / size } else { 1.0 });
    }
    vectors
}

fn relative_to_path(seen: &Seen) -> Vectors {
    let path = seen.truth.iter().map(|s| s.position.norm()).fold(0.0, f64::max);
    seen.scaled(Quantity::Position, 1.0 / path)
}

/// The ladder with its errors measured wrongly.
pub(super) fn mismeasured(
    contestant: &Contestant,
    system: &System,
    reference: &Reference,
    climbed: &Climbed,
    measure: Measure,
) -> record::Ladder {
    let mut ladder = climbed.ladder.clone();
    let duration = reference.times[reference.times.len() - 1];
    let intervals = (duration / ladder.times[0]).round() as u64;
    let at = |states: &[Snapshot]| -> Vec<Snapshot> {
        let every = (states.len() - 1) as f64 / duration;
        ladder.times.iter().map(|time| states[(time * every).round() as usize]).collect()
    };
    let truth = at(&reference.states);
    let mut changed = ladder.rungs.clone();
    for rung in changed.iter_mut().filter(|rung| rung.broken.is_none()) {
        let states = contestant.run(system, Form::Least, &Plan::over(duration, rung.steps, intervals)).states;
        rung.errors = measure(&Seen { system, run: &at(&states), truth: &truth, right: &rung.errors });
    }
    ladder.rungs = changed;
    ladder.odd.clear();
    ladder
}
