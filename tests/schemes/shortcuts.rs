//! A form that a model has of a scheme's step is held to the scheme's page.

use polhode::internals::arithmetic::Registers;
use polhode::internals::model::AnyModel;
use polhode::internals::rotation::{self, Rotation};
use polhode::internals::study::ensemble::{Ensemble, Member};
use polhode::model::{Broken, Model, Snapshot, System, Turning};
use polhode::scenes::{self, Scene};
use polhode::schemes::{Card, PeskinRk2, Rk4Quaternion, Scheme, Step, TurningScheme};
use polhode::simulate::{Contestant, Form, Plan};

/// The page of a scheme, without the name by which a model knows it.
#[derive(Clone)]
struct Page<S>(S);

impl<S: Scheme> Scheme for Page<S> {
    const STATES: usize = S::STATES;

    fn card(&self) -> Card {
        self.0.card()
    }

    fn step<M: Model>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        self.0.step(model, step)
    }
}

impl<S: TurningScheme> TurningScheme for Page<S> {
    const STATES: usize = S::STATES;
    const TAKES_VELOCITY_FORCES: bool = S::TAKES_VELOCITY_FORCES;
    const TAKES_RODS: bool = S::TAKES_RODS;

    fn card(&self) -> Card {
        self.0.card()
    }

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        self.0.step(model, step)
    }
}

/// Most steps of a run, and about what it turns by at most [rad].
const STEPS: u64 = 32;
const TURN: f64 = 3.0;

/// Orientations of two runs, each step of which turns by this angle [rad] at the start.
fn side_by_side(scheme: &Contestant, page: &Contestant, system: &System, turn: f64) -> Vec<[Rotation; 2]> {
    let start = page.run(system, Form::Least, &Plan { step: 1.0, steps: 0, every: 1 }).states[0];
    let steps = STEPS.min((TURN / turn.abs()) as u64);
    let plan = Plan { step: turn / rotation::length(&start.angular_velocity), steps, every: 2 };
    let [own, other] = [scheme, page].map(|contestant| contestant.run(system, Form::Least, &plan));
    assert_eq!(own.outcome.evaluations, other.outcome.evaluations);
    assert!(own.states.len() == other.states.len() && own.states.len() as u64 > steps / 2);
    own.states.iter().zip(&other.states).map(|(a, b)| [a.orientation, b.orientation]).collect()
}

#[test]
fn steps_in_moving_axes_are_those_of_the_page_but_for_rounding() {
    let pairs = [
        (Contestant::new(PeskinRk2), Contestant::new(Page(PeskinRk2))),
        (Contestant::turning(Rk4Quaternion), Contestant::turning(Page(Rk4Quaternion))),
    ];
    let (mut free, mut unequal) = (0, 0);
    for scene in scenes::built_in() {
        let turns = scene.system.start.angular_momentum.amax() > 0.0;
        if !turns || !matches!(scene.system.least(), AnyModel::Free(_)) {
            continue;
        }
        free += 1;
        for (scheme, page) in &pairs {
            let name = (&scene.name, scheme.card.name);
            for turn in [0.1, 0.01, -0.05, 0.6] {
                let pairs = side_by_side(scheme, page, &scene.system, turn);
                let angle = pairs.iter().map(|[a, b]| rotation::angle_between(a, b)).fold(0.0, f64::max);
                println!("{name:?}, {turn} rad: {angle:e}");
                // Each rounds a few units a step, and an unstable spin multiplies by e for a radian at most.
                let bound = 4.0 * STEPS as f64 * f64::EPSILON * TURN.exp();
                assert!(angle < bound, "{name:?}, {turn} rad: {angle:e}");
                unequal += usize::from(pairs.iter().any(|[a, b]| a != b));
            }
        }
        // A turn that the series do not take is the page's.
        let [(scheme, page), _] = &pairs;
        let pairs = side_by_side(scheme, page, &scene.system, 0.6);
        assert!(pairs.iter().all(|[a, b]| a == b), "{}", scene.name);
    }
    assert!(free > 3 && unequal > 2 * free, "{free} scenes, {unequal} runs");
}

#[test]
fn a_run_is_the_same_however_often_it_is_looked_at() {
    let scene = Scene::find("free-asymmetric").expect("built in");
    for scheme in [Contestant::new(PeskinRk2), Contestant::turning(Rk4Quaternion)] {
        let end = |every: u64| {
            let plan = Plan { step: 0.01, steps: 3000, every };
            *scheme.run(&scene.system, Form::Least, &plan).states.last().expect("a state")
        };
        assert_eq!(end(1), end(3000));
        assert_eq!(end(7), end(3000));
    }
}

#[test]
fn bodies_side_by_side_in_moving_axes_are_those_alone_to_the_last_bit() {
    let system = Scene::find("free-asymmetric").expect("built in").system;
    // Turns on both sides of what the series take: those beyond step as the page does.
    let member = |k: usize| Member {
        system: system.clone(),
        plan: Plan { step: 0.003 * (1 + k) as f64, steps: 100 + 50 * (k as u64 % 3), every: 30 },
    };
    let members: Vec<Member> = (0..60).map(member).collect();
    let peskin = Contestant::new(PeskinRk2);
    for registers in Registers::all() {
        let rows = Ensemble::new(&peskin, members.clone())
            .in_registers(registers)
            .fold(|_| Vec::new(), |states: &mut Vec<Snapshot>, state| states.push(*state));
        for ((states, outcome), member) in rows.iter().zip(&members) {
            let alone = peskin.run(&member.system, Form::Least, &member.plan);
            assert_eq!(states, &alone.states, "{registers:?}");
            assert_eq!(outcome.evaluations, alone.outcome.evaluations);
        }
    }
}
