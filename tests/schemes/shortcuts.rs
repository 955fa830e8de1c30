//! A form that a model has of a scheme's step is held to the scheme's page.

use polhode::internals::model::AnyModel;
use polhode::internals::rotation;
use polhode::model::{Broken, Model, System, Turning};
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

const STEPS: u64 = 300;

/// Largest angle [rad] between two runs of `STEPS` steps, each of at most this angle [rad].
fn apart(scheme: &Contestant, page: &Contestant, system: &System, largest_turn: f64) -> f64 {
    let inverse = system.body.inverse_moments().amax();
    let fastest = rotation::length(&system.start.angular_momentum) * inverse;
    let plan = Plan { step: largest_turn / fastest, steps: STEPS, every: 7 };
    let [own, other] = [scheme, page].map(|contestant| contestant.run(system, Form::Least, &plan));
    assert_eq!(own.outcome.evaluations, other.outcome.evaluations);
    assert!(own.states.len() == other.states.len() && own.states.len() as u64 > STEPS / 7);
    let pairs = own.states.iter().zip(&other.states);
    pairs.map(|(a, b)| rotation::angle_between(&a.orientation, &b.orientation)).fold(0.0, f64::max)
}

#[test]
fn steps_in_moving_axes_are_those_of_the_page_but_for_rounding() {
    let pairs = [
        (Contestant::new(PeskinRk2), Contestant::new(Page(PeskinRk2))),
        (Contestant::turning(Rk4Quaternion), Contestant::turning(Page(Rk4Quaternion))),
    ];
    let mut free = 0;
    for scene in scenes::built_in() {
        if !matches!(scene.system.least(), AnyModel::Free(_)) || scene.system.start.angular_momentum.amax() == 0.0 {
            continue;
        }
        free += 1;
        for (scheme, page) in &pairs {
            let name = (&scene.name, scheme.card.name);
            for turn in [0.17, 0.01, -0.1] {
                let angle = apart(scheme, page, &scene.system, turn);
                println!("{name:?}, {turn} rad: {angle:e}");
                // Each rounds a few times in a step; measured up to 6e-15.
                assert!(angle < 0.25 * STEPS as f64 * f64::EPSILON, "{name:?}, {turn} rad: {angle:e}");
            }
            // A turn that the series do not take is the page's.
            assert_eq!(apart(scheme, page, &scene.system, 0.3), 0.0, "{name:?}");
        }
    }
    assert!(free > 5, "{free} scenes");
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
