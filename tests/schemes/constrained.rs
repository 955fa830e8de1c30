//! RATTLE, Omelyan's leapfrog and the generalised-α method: orders under torque, and one step each against another formulation.

use nalgebra::{Matrix3, Vector3};
use polhode::internals::measure::{self, Asked, Decision, decide};
use polhode::internals::reference::{Reference, stored};
use polhode::internals::rotation;
use polhode::model::{Quantity, Snapshot, System};
use polhode::simulate::{Form, Plan};

use crate::common::{contestant, matrix, scene};

fn steps(scheme: &str, system: &System, step: f64, steps: u64) -> Vec<Snapshot> {
    contestant(scheme).run(system, Form::Least, &Plan { step, steps, every: 1 }).states
}

#[test]
fn their_order_is_two_under_torque() {
    for name in ["heavy-asymmetric-top", "tether-springs", "dipole-in-field", "kovalevskaya"] {
        let scene = scene(name);
        let stored = stored::find(name).expect("readable");
        let reference =
            Reference::of(&scene.system, scene.duration, 64, stored.as_ref()).expect("a reference");
        for scheme in ["rattle", "omelyan-leapfrog", "generalized-alpha"] {
            let contestant = contestant(scheme);
            if let Some(reason) = contestant.refusal(&scene.system) {
                // Kovalevskaya's top is flat: RATTLE divides by its second moments.
                assert_eq!((scheme, name), ("rattle", "kovalevskaya"), "{reason}");
                continue;
            }
            let climbed = measure::climb(&contestant, &scene.system, &reference, Some(2));
            let decision = decide(&Asked::of(&climbed.ladder, Quantity::Orientation));
            println!("{scheme} in {name}: {decision:?}");
            assert!(matches!(decision, Decision::Order(found) if found.order == 2), "{scheme} in {name}");
        }
    }
}

#[test]
fn rattle_makes_the_step_of_the_discrete_moser_veselov_equation() {
    // Multipliers on nine entries and Newton's iteration on a quaternion solve one equation.
    for name in ["free-asymmetric", "heavy-asymmetric-top", "tether-springs", "dzhanibekov"] {
        let system = scene(name).system;
        let rattle = steps("rattle", &system, 1.0 / 16.0, 8);
        let veselov = steps("moser-veselov", &system, 1.0 / 16.0, 8);
        for (a, b) in rattle.iter().zip(&veselov) {
            let apart = (matrix(a) - matrix(b)).amax();
            assert!(apart < 4e-15, "{name} at {} s: {apart:e}", a.time);
        }
    }
}

#[test]
fn omelyans_step_is_cayleys_turn_of_half_the_time_taken_twice() {
    let system = scene("free-asymmetric").system;
    let h = 0.25;
    let states = steps("omelyan-leapfrog", &system, h, 1);
    let (r0, r1) = (matrix(&states[0]), matrix(&states[1]));
    // Half the turn, and Ω there from L alone: R₁ = C² R₀ with C = (E − h/4 Ω̂)⁻¹ (E + h/4 Ω̂), since (3) is
    // q₁ = (1 − h Ω/4)⁻¹ (1 + h Ω/4) q₀ and a quaternion turns twice.
    let turned = (states[1].orientation * states[0].orientation.inverse()).scaled_axis();
    let halfway = (rotation::turn(&(turned / 2.0)) * states[0].orientation).to_rotation_matrix().into_inner();
    let spin = halfway * system.body.inverse_inertia() * halfway.transpose() * system.start.angular_momentum;
    let spun = spin.cross_matrix() * (h / 4.0);
    let cayley = (Matrix3::identity() - spun).try_inverse().expect("regular") * (Matrix3::identity() + spun);
    let error = (cayley * cayley * r0 - r1).amax();
    assert!(error < 2e-15, "{error:e}");
    assert!((r1 - r0).amax() > 0.01, "a step that turns the body");
}

#[test]
fn two_steps_of_the_generalised_alpha_method_satisfy_its_equations() {
    let system = scene("heavy-asymmetric-top").system;
    let (h, rho) = (1.0 / 16.0, 0.5);
    let (alpha_m, alpha_f) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
    let gamma = 0.5 + alpha_f - alpha_m;
    let beta = 0.25 * (gamma + 0.5f64).powi(2);
    let states = steps("generalized-alpha", &system, h, 2);
    let inertia = system.body.inertia;
    let weight = Vector3::new(-0.75, 0.0, -1.0) * system.body.mass;
    let spin = |s: &Snapshot| matrix(s).transpose() * s.angular_velocity;
    // v̇ from the torque of the weight in body axes, by the matrix of the inertia itself.
    let rate = |s: &Snapshot| {
        let torque = system.body.center.cross(&(matrix(s).transpose() * weight));
        let v = spin(s);
        inertia.try_inverse().expect("regular") * (torque - v.cross(&(inertia * v)))
    };
    let mut a0 = rate(&states[0]);
    for pair in states.windows(2) {
        let (v0, v1) = (spin(&pair[0]), spin(&pair[1]));
        let a1 = ((v1 - v0) / h - a0 * (1.0 - gamma)) / gamma;
        let turned = (pair[0].orientation.inverse() * pair[1].orientation).scaled_axis();
        let expected = v0 * h + (a0 * (0.5 - beta) + a1 * beta) * (h * h);
        assert!((turned - expected).amax() < 1e-15 * 8.0, "{:e}", (turned - expected).amax());
        let left = a1 * (1.0 - alpha_m) + a0 * alpha_m;
        let right = rate(&pair[1]) * (1.0 - alpha_f) + rate(&pair[0]) * alpha_f;
        // a₁ divides a rounding of v by h γ.
        assert!((left - right).amax() < 1e-13, "{:e}", (left - right).amax());
        a0 = a1;
    }
}
