//! A step of every scheme against an independent computation: rotation matrices, exponentials by their series, commutators of
//! matrices, equations solved by plain repetition. Nothing here is shared with the library but the vectors.

mod body;
mod implicit;
mod multistep;
mod points;
mod rotations;
mod runge_kutta;
mod splittings;
mod times;

use self::body::{M, State, V};
use crate::common::scene;
use polhode::model::Snapshot;
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form, Plan};

/// h [s]: a fifth of a radian a step.
const STEP: f64 = 1.0 / 16.0;
/// Roundings of numbers of size three in a few dozen operations, and those of a solved equation: at most 1.3e-15 in a step and
/// 2.1e-14 in six, measured.
const ROUNDING: f64 = 4e-15;

/// The state after so many steps, by other means than the scheme's own.
enum Expected {
    /// R and L.
    Rigid(State),
    /// L and Ω, where the points need not turn rigidly.
    Points { momentum: V, spin: V },
}

/// So many steps of a rule for one.
fn repeated(steps: u64, step: impl Fn(&State, f64) -> State) -> Expected {
    Expected::Rigid((0..steps).fold(body::start(), |state, _| step(&state, STEP)))
}

/// So many steps of a composition.
fn composed(steps: u64, half: &[f64], step: impl Fn(&State, f64) -> State) -> Expected {
    repeated(steps, |state, h| splittings::composed(state, h, half, &step))
}

/// An exhaustive list: a scheme that is added without a step here fails the test below.
fn expected(name: &str, n: u64) -> Expected {
    match name {
        "peskin-rk2" | "peskin-trapezoid" => repeated(n, runge_kutta::peskin_rk2),
        "euler" => repeated(n, runge_kutta::euler),
        "peskin-heun" => repeated(n, runge_kutta::heun),
        "peskin-ralston" => repeated(n, runge_kutta::ralston),
        "peskin-cayley" => repeated(n, runge_kutta::peskin_cayley),
        "peskin-rk3" => repeated(n, runge_kutta::peskin_rk3),
        "peskin-rk4" => repeated(n, runge_kutta::peskin_rk4),
        "course-notes-euler" => repeated(n, runge_kutta::course_notes),
        "substepped-4-euler" => repeated(4 * n, |state, h| runge_kutta::euler(state, h / 4.0)),
        "crouch-grossman-3" => repeated(n, runge_kutta::crouch_grossman_3),
        "rkmk4" => repeated(n, runge_kutta::rkmk4),
        "magnus-4" => repeated(n, runge_kutta::magnus_4),
        "cf4" => repeated(n, runge_kutta::cf4),
        "rk4-quaternion" => repeated(n, runge_kutta::rk4_quaternion),
        "cooper-verner-8" => repeated(n, runge_kutta::cooper_verner_8),
        "rk4-matrix" => repeated(n, runge_kutta::rk4_matrix),
        "buss-augmented" => repeated(n, runge_kutta::buss),
        "semi-implicit-euler-no-gyro" => repeated(n, runge_kutta::no_gyro),
        "semi-implicit-euler-explicit-gyro" => repeated(n, runge_kutta::explicit_gyro),
        "semi-implicit-euler-implicit-gyro" => repeated(n, runge_kutta::implicit_gyro),
        "momentum-clamped-euler" => repeated(n, runge_kutta::momentum_clamped),
        "adams-bashforth-2" => multistep::adams_bashforth(n, &[1.5, -0.5], false),
        "adams-bashforth-3" => multistep::adams_bashforth(n, &multistep::THREE, false),
        "adams-bashforth-4" => multistep::adams_bashforth(n, &multistep::FOUR, false),
        "adams-bashforth-3-cold" => multistep::adams_bashforth(n, &multistep::THREE, true),
        "adams-bashforth-4-cold" => multistep::adams_bashforth(n, &multistep::FOUR, true),
        "adams-bashforth-2-body" => multistep::adams_bashforth_body(n, &[1.5, -0.5]),
        "adams-bashforth-3-body" => multistep::adams_bashforth_body(n, &multistep::THREE),
        "adams-bashforth-4-body" => multistep::adams_bashforth_body(n, &multistep::FOUR),
        "generalized-alpha-constrained" => multistep::generalized_alpha_constrained(n),
        "generalized-alpha" => multistep::generalized_alpha(n),
        "implicit-midpoint" => repeated(n, implicit::midpoint),
        "simo-wong" => repeated(n, implicit::simo_wong),
        "krysl-liemid" => repeated(n, implicit::liemid),
        "krysl-liemid-ea" => repeated(n, implicit::liemid_explicit),
        "lie-verlet" => repeated(n, implicit::lie_verlet),
        "omelyan-leapfrog" => repeated(n, implicit::omelyan),
        "gauss-legendre-4" => repeated(n, implicit::gauss_legendre_4),
        "gauss-legendre-6" => repeated(n, implicit::gauss_legendre_6),
        "moser-veselov" | "rattle" => repeated(n, |s, h| splittings::kicked(s, h, splittings::veselov)),
        "moser-veselov-4" => {
            repeated(n, |s, h| splittings::kicked(s, h, |l, h| splittings::preprocessed(l, h, 1)))
        }
        "moser-veselov-6" => {
            repeated(n, |s, h| splittings::kicked(s, h, |l, h| splittings::preprocessed(l, h, 2)))
        }
        "moser-veselov-8" => {
            repeated(n, |s, h| splittings::kicked(s, h, |l, h| splittings::preprocessed(l, h, 3)))
        }
        "moser-veselov-10" => {
            repeated(n, |s, h| splittings::kicked(s, h, |l, h| splittings::preprocessed(l, h, 4)))
        }
        "strang-rotations" => repeated(n, splittings::strang),
        "no-squish" => {
            repeated(n, |s, h| splittings::kicked(s, h, |l, h| splittings::turns(l, h, [2, 1, 0])))
        }
        "strang-symmetric" => repeated(n, splittings::strang_symmetric),
        "exact-rotor" => repeated(n, splittings::exact_rotor),
        "yoshida-4" => composed(n, &splittings::triple_jump(), splittings::strang),
        "suzuki-4" => composed(n, &splittings::fractal(), splittings::strang),
        "kahan-li-6" => composed(n, &splittings::KAHAN_LI_6, splittings::strang),
        "kahan-li-8" => composed(n, &splittings::KAHAN_LI_8, splittings::strang),
        "strang-symmetric-6" => composed(n, &splittings::KAHAN_LI_6, splittings::strang_symmetric),
        "strang-symmetric-8" => composed(n, &splittings::KAHAN_LI_8, splittings::strang_symmetric),
        "exact-rotor-6" => composed(n, &splittings::KAHAN_LI_6, splittings::exact_rotor),
        "exact-rotor-8" => composed(n, &splittings::KAHAN_LI_8, splittings::exact_rotor),
        "euler-linear" => points::euler_linear(n),
        "rk2-linear" => points::rk2_linear(n),
        "course-code-euler" => points::course_code(n),
        _ => panic!("{name}: no independent computation of a step"),
    }
}

fn run(contestant: &Contestant, scene: &Scene, steps: u64) -> Snapshot {
    let plan = Plan { step: STEP, steps, every: steps };
    let run = contestant.run(&scene.system, Form::Least, &plan);
    assert_eq!(run.outcome.broken, None, "{}", contestant.card.name);
    run.states[run.states.len() - 1]
}

#[test]
fn steps_of_every_scheme_are_those_of_an_independent_computation() {
    let scene = scene("heavy-asymmetric-top");
    for contestant in Contestant::all() {
        let name = contestant.card.name;
        // One step, and as many as the longest history needs to be full.
        for steps in [1, 6] {
            let found = run(&contestant, &scene, steps);
            let apart = match expected(name, steps) {
                Expected::Rigid((r, l)) => {
                    let matrix: M = found.orientation.to_rotation_matrix().into_inner();
                    (matrix - r).amax().max((found.angular_momentum - l).amax())
                }
                Expected::Points { momentum, spin } => {
                    (found.angular_momentum - momentum).amax().max((found.angular_velocity - spin).amax())
                }
            };
            println!("{name}, {steps} steps: {apart:.1e}");
            assert!(apart < ROUNDING * steps as f64, "{name}, {steps} steps: {apart:e}");
        }
    }
}

#[test]
fn the_independent_steps_move_the_body() {
    for contestant in Contestant::all() {
        if let Expected::Rigid((r, l)) = expected(contestant.card.name, 1) {
            let (r0, l0) = body::start();
            assert!((r - r0).amax() > 0.05 && (l - l0).amax() > 0.01, "{}", contestant.card.name);
        }
    }
}
