//! Foreign programs beside one another and beside our schemes, at equal steps: how far each is off, and which of
//! them make the same motion.
//!
//! Two are **twins** where their difference is a small part of their error: log₁₀(error / difference) is the number of
//! digits of the error that both share, in orientation and in position. Equal errors alone would not do: two rules may
//! be off by as much in different directions. Where both are right to rounding there is nothing to share, and no pair.
//! Rules of the same leading error come together as the step falls: what tells them apart is the coarse step.

use rayon::prelude::*;

use crate::interrupt;
use crate::model::{Quantity, Snapshot, difference};
use crate::ode::dop853;
use crate::record::{PeerRow, Twin};
use crate::rotation;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Form, Outcome, Plan, Trajectory};

/// Intervals of a run whose ends are compared.
const SAMPLES: u64 = 50;
/// Largest turn in a coarse step [rad].
const COARSE_TURN: f64 = 0.02;
/// Fine steps of a coarse one.
const REFINEMENT: u64 = 10;
/// Most coarse steps.
const MOST_STEPS: u64 = 10_000;
/// A difference of this part of a radian, or of the way that a body goes, is rounding: 10⁴ steps leave 3e-13, measured …
const ROUNDING: f64 = 1e-12;
/// … and an error has to be so many times larger before it shows digits.
const CLEAR: f64 = 100.0;
/// Digits of their errors that twins share.
pub const DIGITS: f64 = 3.0;

/// What was measured at equal steps.
#[derive(Clone, Debug, Default)]
pub struct Peers {
    /// A row a scene, step and contestant.
    pub rows: Vec<PeerRow>,
    /// The pairs that share digits, one of each at least a foreign program.
    pub twins: Vec<Twin>,
}

/// A scene at a step: the plan, and the truth at the times that it stores.
struct Stage<'a> {
    scene: &'a Scene,
    plan: Plan,
    truth: Vec<Snapshot>,
}

/// A run of a contestant: position [m] and orientation [rad] errors at the end and the largest, where it has any.
struct Ran<'a> {
    contestant: &'a Contestant,
    outcome: Outcome,
    states: Vec<Snapshot>,
    errors: Option<[[f64; 2]; 2]>,
}

/// Runs contestants in scenes at two steps each. Those of `others` are run too, and told of where they have a twin.
pub fn compare(
    scenes: &[Scene],
    contestants: &[Contestant],
    others: &[Contestant],
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Peers {
    let asked = |name: &str| contestants.iter().any(|contestant| contestant.card.name == name);
    let others = others.iter().filter(|other| !asked(other.card.name));
    let everyone: Vec<&Contestant> = contestants.iter().chain(others).collect();
    let mut peers = Peers::default();
    for (index, scene) in scenes.iter().enumerate() {
        let takes = |contestant: &&Contestant| contestant.refusal(&scene.system).is_none();
        let foreign = contestants.iter().filter(|contestant| contestant.program().is_some());
        let stages = if foreign.filter(takes).count() > 0 { stages(scene) } else { Vec::new() };
        let runs: Vec<Vec<Ran>> = stages.iter().map(|stage| stage.run_all(&everyone)).collect();
        let twins: Vec<Twin> = stages.iter().zip(&runs).flat_map(|(stage, runs)| stage.twins(runs)).collect();
        let told =
            |name: &str| asked(name) || twins.iter().any(|twin| twin.one == name || twin.other == name);
        for (stage, runs) in stages.iter().zip(&runs) {
            let told = runs.iter().filter(|ran| told(ran.contestant.card.name));
            peers.rows.extend(told.map(|ran| stage.row(ran)));
        }
        peers.twins.extend(twins);
        progress(index + 1, scenes.len());
    }
    peers
}

/// A coarse step and a fine one; none where there is no reference.
fn stages(scene: &Scene) -> Vec<Stage<'_>> {
    let Some(coarse) = coarse_steps(scene) else { return Vec::new() };
    let stage = |steps: u64| {
        let plan = Plan::over(scene.duration, steps, SAMPLES);
        let stored = (0..steps).step_by(plan.every as usize).chain([steps]);
        let times: Vec<f64> = stored.map(|step| step as f64 * plan.step).collect();
        let truth = dop853::solve(&scene.system, &times, dop853::TOLERANCE).ok()?.states;
        Some(Stage { scene, plan, truth })
    };
    [coarse, coarse * REFINEMENT].into_iter().filter_map(stage).collect()
}

/// h is 1, 2 or 5 times a power of ten where one that is small enough divides the duration.
fn coarse_steps(scene: &Scene) -> Option<u64> {
    let times: Vec<f64> = (0..=SAMPLES).map(|n| n as f64 * scene.duration / SAMPLES as f64).collect();
    let truth = dop853::solve(&scene.system, &times, dop853::TOLERANCE).ok()?.states;
    let fastest = truth.iter().map(|state| rotation::length(&state.angular_velocity)).fold(0.0, f64::max);
    let widest = (scene.duration / SAMPLES as f64).min(COARSE_TURN / fastest.max(f64::MIN_POSITIVE));
    let power = 10f64.powf(widest.log10().floor());
    let whole = |steps: &f64| (steps - steps.round()).abs() < 1e-9 * steps;
    let round = [5.0, 2.0, 1.0, 0.5, 0.2].map(|part| part * power).into_iter().filter(|h| *h <= widest);
    let steps = round.map(|h| scene.duration / h).find(whole).unwrap_or((scene.duration / widest).ceil());
    Some((steps.round() as u64).min(MOST_STEPS))
}

impl Stage<'_> {
    /// Everyone who takes the scene.
    fn run_all<'a>(&self, everyone: &[&'a Contestant]) -> Vec<Ran<'a>> {
        let system = &self.scene.system;
        everyone
            .par_iter()
            .filter(|contestant| contestant.refusal(system).is_none() && !interrupt::requested())
            .map(|contestant| self.run(contestant))
            .filter(|ran| ran.outcome.refusal().is_none())
            .collect()
    }

    fn run<'a>(&self, contestant: &'a Contestant) -> Ran<'a> {
        let Trajectory { states, outcome } = contestant.run(&self.scene.system, Form::Least, &self.plan);
        let whole = outcome.broken.is_none() && states.len() == self.truth.len();
        let errors = whole.then(|| self.apart(&states, &self.truth));
        Ran { contestant, outcome, states, errors }
    }

    /// Difference of two runs in position [m] and orientation [rad], at the end and the largest.
    fn apart(&self, a: &[Snapshot], b: &[Snapshot]) -> [[f64; 2]; 2] {
        let (mut end, mut largest) = ([0.0; 2], [0.0f64; 2]);
        for (a, b) in a.iter().zip(b) {
            let apart = difference(&self.scene.system.body, a, b);
            end = [apart[Quantity::Position], apart[Quantity::Orientation]];
            largest = std::array::from_fn(|i| largest[i].max(end[i]));
        }
        [end, largest]
    }

    fn row(&self, ran: &Ran) -> PeerRow {
        let energies = || ran.states.iter().map(|state| self.scene.system.rotational_energy(state));
        let first = energies().next().filter(|energy| *energy > 0.0);
        let change = |first: f64| energies().map(|energy| (energy / first - 1.0).abs()).fold(0.0, f64::max);
        let finite = |value: f64| value.is_finite().then_some(value);
        PeerRow {
            scene: self.scene.name.clone(),
            scheme: ran.contestant.card.name.to_owned(),
            step_s: self.plan.step,
            steps: self.plan.steps,
            position_end_m: ran.errors.and_then(|[end, _]| finite(end[0])),
            orientation_end_rad: ran.errors.and_then(|[end, _]| finite(end[1])),
            rotational_energy_max: ran.errors.and(first).and_then(|first| finite(change(first))),
            nanoseconds_per_step: (ran.outcome.steps > 0)
                .then(|| ran.outcome.nanoseconds as f64 / ran.outcome.steps as f64),
            why: ran.outcome.broken.as_ref().map(ToString::to_string),
        }
    }

    /// The pairs, one of each at least a foreign program.
    fn twins(&self, runs: &[Ran]) -> Vec<Twin> {
        let pairs = runs
            .iter()
            .enumerate()
            .flat_map(|(index, one)| runs[index + 1..].iter().map(move |other| (one, other)));
        let foreign = |ran: &Ran| ran.contestant.program().is_some();
        pairs
            .filter(|(one, other)| foreign(one) || foreign(other))
            .filter_map(|(one, other)| self.twin(one, other))
            .filter(|twin| twin.digits >= DIGITS)
            .collect()
    }

    fn twin(&self, one: &Ran, other: &Ran) -> Option<Twin> {
        let ([_, a], [_, b]) = (one.errors?, other.errors?);
        let [_, apart] = self.apart(&one.states, &other.states);
        let way = self
            .truth
            .iter()
            .map(|state| (state.position - self.truth[0].position).norm())
            .fold(0.0, f64::max);
        let sizes = [way.max(self.scene.system.body.extent()), 1.0];
        let digits =
            (0..2).filter_map(|i| shared_digits(a[i].max(b[i]), apart[i], CLEAR * ROUNDING * sizes[i]));
        Some(Twin {
            scene: self.scene.name.clone(),
            step_s: self.plan.step,
            one: one.contestant.card.name.to_owned(),
            other: other.contestant.card.name.to_owned(),
            apart_rad: apart[1],
            error_rad: a[1].max(b[1]),
            digits: digits.reduce(f64::min)?,
            to_rounding: (0..2).all(|i| apart[i] <= ROUNDING * sizes[i]),
        })
    }
}

/// log₁₀(error / difference); `None` where the error is rounding. No f64 shows more than 16.
fn shared_digits(error: f64, apart: f64, rounding: f64) -> Option<f64> {
    (error > rounding).then(|| (error / apart.max(error * 1e-16)).log10())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::Program;

    /// A scheme of the list that plays a foreign program.
    fn playing(name: &str) -> Contestant {
        let all = Contestant::all();
        let mut played =
            all.iter().find(|c| c.card.name == name).expect("a scheme").clone().by(Program::default);
        played.card.name = "engine:played";
        played
    }

    fn twins_of(name: &str) -> Vec<String> {
        let scene = Scene::find("free-asymmetric").expect("a scene");
        let peers = compare(&[scene], &[playing(name)], &Contestant::all(), &|_, _| ());
        assert!(
            peers.rows.iter().any(|row| row.scheme == "engine:played" && row.orientation_end_rad > Some(0.0))
        );
        let largest = peers.rows.iter().map(|row| row.step_s).fold(0.0, f64::max);
        let coarse = peers.twins.into_iter().filter(|twin| twin.step_s == largest);
        coarse.map(|twin| twin.other).collect()
    }

    #[test]
    fn a_program_finds_the_scheme_whose_rule_it_has_and_no_other() {
        // The trapezoid stands in (6) alone, which a body without a force has no use for.
        assert_eq!(twins_of("peskin-rk2"), ["peskin-rk2", "peskin-trapezoid"]);
        let of_simo_wong = twins_of("simo-wong");
        assert!(of_simo_wong.contains(&"simo-wong".to_owned()));
        assert!(!of_simo_wong.contains(&"peskin-rk2".to_owned()));
        assert!(
            twins_of("semi-implicit-euler-explicit-gyro")
                .contains(&"semi-implicit-euler-explicit-gyro".to_owned())
        );
    }

    #[test]
    fn what_is_right_to_rounding_has_no_twin() {
        assert!(twins_of("exact-rotor").is_empty());
        assert_eq!(shared_digits(1e-12, 1e-13, 1e-10), None);
        assert_eq!(shared_digits(1e-2, 1e-6, 1e-10), Some(4.0));
        assert_eq!(shared_digits(1e-2, 0.0, 1e-10), Some(16.0));
    }
}
