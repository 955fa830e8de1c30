//! Programs under test are judged by the one rule for an order: right ones are green, wrong ones red, each for its reason.

use polhode::campaign::Campaign;
use polhode::internals::study::cause::Cause;
use polhode::model::Snapshot;
use polhode::record::Ruling::{Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::{ClaimName, Ruling, Verdict};
use polhode::schemes::{Card, Claim, Quantity};
use polhode::simulate::{Contestant, Form};

use crate::common::{contestant, scene};

/// A scheme of the list as a program under test, which claims an order and reports its states in a given way.
fn program(scheme: &str, order: Option<u32>, tell: fn(&Snapshot) -> Snapshot) -> Contestant {
    let inner = contestant(scheme);
    let claims: Vec<Claim> = order.into_iter().map(Claim::Order).collect();
    let card = Card { name: "program", title: "", family: "", source: "", claims: claims.leak() };
    Contestant::engine(
        card,
        |_| None,
        move |system, plan, store| {
            inner.stream(system, Form::Least, plan, &mut |s| {
                let reported = tell(s);
                // The harness computes L from the reported angular velocity.
                let spin = reported.orientation.inverse_transform_vector(&reported.angular_velocity);
                let angular_momentum = reported.orientation * (system.body.inertia * spin);
                store(&Snapshot { angular_momentum, ..reported });
            })
        },
    )
}

fn judged(scene_name: &str, program: &Contestant) -> Vec<Verdict> {
    let campaign = Campaign::of(vec![scene(scene_name)], vec![program.clone()]);
    campaign.run().verdicts.into_iter().filter(|v| v.scheme == "program").collect()
}

fn rulings(verdicts: &[Verdict], claim: ClaimName) -> Vec<Ruling> {
    verdicts.iter().filter(|v| v.claim == claim && v.quantity != "cause").map(|v| v.verdict).collect()
}

fn as_it_is(s: &Snapshot) -> Snapshot {
    *s
}

fn in_body_axes(s: &Snapshot) -> Snapshot {
    Snapshot { angular_velocity: s.orientation.inverse_transform_vector(&s.angular_velocity), ..*s }
}

fn in_degrees(s: &Snapshot) -> Snapshot {
    Snapshot { angular_velocity: s.angular_velocity.map(f64::to_degrees), ..*s }
}

/// The cause that is named in a scene.
fn cause(scene_name: &str, program: &Contestant) -> Option<Cause> {
    let records = Campaign::of(vec![scene(scene_name)], vec![program.clone()]).run();
    let named = records.evidence.iter().find_map(|evidence| evidence.ladder.cause.clone())?;
    Cause::ALL.into_iter().find(|cause| cause.words() == named)
}

#[test]
fn a_right_program_is_green_in_every_kind_of_scene() {
    let scenes = [
        "free-asymmetric",
        "kovalevskaya",
        "tether-springs",
        "gravity-drag",
        "mujoco-fast-spin",
        "dzhanibekov",
    ];
    for (scheme, order) in [("rk4-quaternion", 4), ("peskin-rk2", 2), ("euler", 1)] {
        let program = program(scheme, Some(order), as_it_is);
        for scene in scenes {
            let verdicts = judged(scene, &program);
            let wrong: Vec<_> =
                verdicts.iter().filter(|v| !matches!(v.verdict, Pass | NotApplicable)).collect();
            // Euler's first-order error saturates over the 600 radians of the fast spin at every step that is taken.
            let saturated = scheme == "euler" && scene == "mujoco-fast-spin";
            assert!(
                wrong.is_empty() || saturated && wrong.iter().all(|v| v.verdict == Inconclusive),
                "{wrong:#?}"
            );
        }
    }
}

#[test]
fn a_claim_one_too_high_or_one_too_low_fails_in_a_generic_scene() {
    // L is exact: orientation, angular velocity and body points have an order, and together one that is too high for a claim of three.
    for (order, failures) in [(3, 1), (5, 3)] {
        let verdicts = judged("free-asymmetric", &program("rk4-quaternion", Some(order), as_it_is));
        let failed = rulings(&verdicts, ClaimName::Order).iter().filter(|ruling| **ruling == Fail).count();
        assert_eq!(failed, failures, "{order}");
    }
    // In another scene a higher order than the claimed one is a remark.
    let verdicts = judged("euler-top-unit", &program("rk4-quaternion", Some(3), as_it_is));
    assert!(rulings(&verdicts, ClaimName::Order).iter().all(|ruling| matches!(ruling, Pass | NotApplicable)));
}

#[test]
fn a_program_that_claims_no_order_is_not_green_and_one_that_is_held_to_it_is() {
    let silent = program("rk4-quaternion", None, as_it_is);
    assert!(rulings(&judged("free-asymmetric", &silent), ClaimName::Order).contains(&Inconclusive));
    let held = rulings(&judged("free-asymmetric", &silent.claiming(4)), ClaimName::Order);
    assert!(held.contains(&Pass) && held.iter().all(|ruling| matches!(ruling, Pass | NotApplicable)));
}

#[test]
fn another_motion_fails_whatever_the_step_and_its_cause_is_named() {
    let no_gyro = program("semi-implicit-euler-no-gyro", Some(1), as_it_is);
    assert!(rulings(&judged("free-asymmetric", &no_gyro), ClaimName::Converges).contains(&Fail));
    assert_eq!(cause("free-asymmetric", &no_gyro), Some(Cause::NoGyroscopicTerm));
    let body = program("rk4-quaternion", Some(4), in_body_axes);
    let verdicts = judged("free-asymmetric", &body);
    let of = |quantity: Quantity, claim: ClaimName| {
        verdicts.iter().find(|v| v.quantity == quantity.name() && v.claim == claim).map(|v| v.verdict)
    };
    assert_eq!(of(Quantity::AngularVelocity, ClaimName::Converges), Some(Fail));
    assert_eq!(of(Quantity::Orientation, ClaimName::Order), Some(Pass));
    assert_eq!(cause("free-asymmetric", &body), Some(Cause::SpinInBodyAxes));
}

#[test]
fn a_first_state_that_is_not_the_start_fails() {
    let degrees = program("rk4-quaternion", Some(4), in_degrees);
    assert_eq!(rulings(&judged("free-asymmetric", &degrees), ClaimName::Start), [Fail, Fail]);
    assert_eq!(cause("free-asymmetric", &degrees), Some(Cause::SpinInDegrees));
    // A sphere that spins about one axis shows no order; its angular velocity is wrong all the same.
    assert!(rulings(&judged("fast-sphere", &degrees), ClaimName::Converges).contains(&Fail));
}
