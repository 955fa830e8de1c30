//! Lower bounds of a step's time: latencies and rates of this machine, and the longest chain of a scheme by them.

use std::hint::black_box;
use std::time::Instant;

use polhode::internals::arithmetic::{Latencies, Timed, operations};
use polhode::internals::model::AnyModel;
use polhode::model::{Shortcut, System, Turning};
use polhode::schemes::{
    BussAugmented, Euler, ExactRotor, ImplicitMidpoint, KryslLiemid, MoserVeselov, PeskinRk2, Rk4Quaternion,
    Scheme, SemiImplicitEulerImplicitGyro, SemiImplicitEulerNoGyro, SimoWong, Step, StrangSymmetric,
    TurningScheme, Workspace,
};

/// Operations of a timed chain, and how often it is timed.
const LINKS: usize = 4096;
const TIMES: usize = 400;
/// Steps before a chain is measured, and at its end.
const FIRST: u64 = 16;
const LAST: u64 = 48;

/// The least time of a block [ns].
fn least(run: impl Fn() -> f64) -> f64 {
    let time = |_| {
        let before = Instant::now();
        black_box(run());
        before.elapsed().as_nanos() as f64
    };
    (0..TIMES).map(time).fold(f64::INFINITY, f64::min)
}

/// Nanoseconds of one link of a chain.
fn link(next: impl Fn(f64) -> f64) -> f64 {
    let chain = || (0..LINKS).fold(black_box(1.5), |x, _| next(x));
    least(chain) / LINKS as f64
}

/// Latencies of this machine.
pub fn latencies() -> Latencies {
    let operand = black_box(1.000_000_1);
    let sum = link(|x| x + operand);
    Latencies {
        sum,
        product: link(|x| x * operand),
        quotient: link(|x| x / operand),
        // A chain of roots alone would end at 1.
        root: link(|x| (x + operand).sqrt()) - sum,
        function: link(|x| (x + operand).sin()) - sum,
    }
}

/// Sums and products that the machine takes in a nanosecond when none waits for another.
pub fn rate() -> f64 {
    const SIDE: usize = 6;
    let (factor, part) = (black_box(1.000_000_1), black_box(1e-9));
    let run = || {
        let (mut products, mut sums) = ([1.0f64; SIDE], [1.0f64; SIDE]);
        for _ in 0..LINKS {
            for (product, sum) in products.iter_mut().zip(&mut sums) {
                *product *= factor;
                *sum += part;
            }
        }
        products.iter().chain(&sums).sum()
    };
    (2 * SIDE * LINKS) as f64 / least(run)
}

/// What bounds a step from below.
#[derive(Clone, Copy)]
pub struct Bound {
    /// The longest chain [ns].
    pub chain: f64,
    /// Sums, products, quotients, roots and functions.
    pub operations: f64,
}

/// The bound of steps on a model.
fn of_steps<M: Turning<Real = Timed>>(model: &M, mut take: impl FnMut(u64, &mut M::State)) -> Bound {
    let mut state = model.start();
    let mut at = |steps: u64| {
        take(steps, &mut state);
        let (q, l) = (model.attitude(&state), model.momentum(&state));
        let ready = q.coords.iter().chain(l.iter()).map(|part| part.ready()).fold(0.0, f64::max);
        (ready, operations())
    };
    let ((first, before), (last, after)) = (at(FIRST), at(LAST - FIRST));
    let steps = (LAST - FIRST) as f64;
    Bound { chain: (last - first) / steps, operations: (after - before) as f64 / steps }
}

fn of_scheme<M: Turning<Real = Timed>>(
    model: &M,
    (states, shortcut): (usize, Option<Shortcut>),
    step: impl Fn(&M, Step<M>) -> Result<(), polhode::model::Broken>,
) -> Bound {
    let h = Timed::constant(super::STEP);
    let mut work = Workspace::<M>::new(&model.start(), states);
    let mut next = model.start();
    let mut n = 0;
    of_steps(model, |steps, state| {
        if shortcut.and_then(|shortcut| model.shortcut(shortcut, h, steps, state)) == Some(steps) {
            return;
        }
        for _ in 0..steps {
            let t = h * n as f64;
            step(model, Step { t, h, from: state, to: &mut next, work: &mut work }).expect("a step");
            std::mem::swap(state, &mut next);
            n += 1;
        }
    })
}

fn of_any<S: Scheme>(scheme: S, system: &System<Timed>) -> Bound {
    let needs = (S::STATES, S::SHORTCUT);
    match system.least() {
        AnyModel::Free(model) => of_scheme(&model, needs, |model, step| scheme.step(model, step)),
        AnyModel::Pivot(model) => of_scheme(&model, needs, |model, step| scheme.step(model, step)),
        _ => unreachable!("a free body or a top"),
    }
}

fn of_turning<S: TurningScheme>(scheme: S, system: &System<Timed>) -> Bound {
    let needs = (S::STATES, S::SHORTCUT);
    match system.least() {
        AnyModel::Free(model) if S::KEEPS_MOMENTUM => {
            of_scheme(&model, needs, |model, step| scheme.step(model, step))
        }
        AnyModel::Free(model) => {
            of_scheme(&model.with_momentum(), needs, |model, step| scheme.step(model, step))
        }
        AnyModel::Pivot(model) => of_scheme(&model, needs, |model, step| scheme.step(model, step)),
        _ => unreachable!("a free body or a top"),
    }
}

/// Every main scheme's bound on a free body or a top.
pub fn of_main(system: &System) -> Vec<(&'static str, Bound)> {
    let system = System::<Timed>::of(system).expect("the same numbers");
    macro_rules! bounds {
        ($($by:ident $scheme:expr),* $(,)?) => {
            vec![$(($scheme.card().name, $by($scheme, &system))),*]
        };
    }
    bounds![
        of_any PeskinRk2, of_any Euler, of_turning SemiImplicitEulerNoGyro,
        of_turning SemiImplicitEulerImplicitGyro, of_turning Rk4Quaternion, of_turning BussAugmented,
        of_turning KryslLiemid, of_turning SimoWong, of_turning ImplicitMidpoint, of_turning StrangSymmetric,
        of_turning ExactRotor, of_turning MoserVeselov::FOUR,
    ]
}
