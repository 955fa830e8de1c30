//! A claim that a scheme does not keep turns its gate red, and one that it keeps stays green.

use nalgebra::Vector3;
use polhode::campaign::Campaign;
use polhode::gates::Baseline;
use polhode::internals::campaign::setting;
use polhode::model::{Broken, Model, Rates};
use polhode::record::{Ruling, Verdict};
use polhode::scenes::{self, Scene};
use polhode::schemes::{Card, Scheme, Step};
use polhode::schemes::{Claim, EnergyOfFreeBody};
use polhode::simulate::Contestant;

use crate::common::{contestant, scene};

fn verdicts(contestant: Contestant, scene_name: &str, claim: &str) -> Vec<Verdict> {
    let verdicts = campaign(contestant, scene_name).run().verdicts;
    verdicts.into_iter().filter(|verdict| verdict.claim.word() == claim).collect()
}

/// A scheme in a scene, held against nothing on record.
fn campaign(contestant: Contestant, scene_name: &str) -> Campaign<'_> {
    let scenes = vec![scene(scene_name)];
    Campaign { baseline: Baseline::default(), ..Campaign::of(scenes, vec![contestant]) }
}

/// A scheme of the list with one claim in place of its own.
fn claiming(name: &str, claims: &'static [Claim]) -> Contestant {
    let mut contestant = contestant(name);
    contestant.card = Card { name: "claimant", claims, ..contestant.card };
    contestant
}

fn ruling(contestant: Contestant, scene: &str, claim: &str) -> Ruling {
    let verdicts = verdicts(contestant, scene, claim);
    verdicts.iter().for_each(|v| println!("{} {} {:?} {}", v.scene, v.quantity, v.verdict, v.detail));
    let failed = verdicts.iter().any(|v| v.verdict == Ruling::Fail);
    if failed { Ruling::Fail } else { verdicts.first().expect("a verdict").verdict }
}

#[test]
fn a_scheme_that_is_not_symmetric_does_not_return_to_its_start() {
    for scene in ["tether-springs", "heavy-asymmetric-top", "free-asymmetric", "dipole-in-field"] {
        for (scheme, expected) in [
            ("peskin-rk2", Ruling::Fail),
            ("euler", Ruling::Fail),
            ("rk4-quaternion", Ruling::Fail),
            ("peskin-rk4", Ruling::Fail),
            ("strang-rotations", Ruling::Pass),
            ("implicit-midpoint", Ruling::Pass),
            ("krysl-liemid", Ruling::Pass),
        ] {
            let claimant = claiming(scheme, &[Claim::Order(2), Claim::Reversible]);
            assert_eq!(ruling(claimant, scene, "reversible"), expected, "{scheme} in {scene}");
        }
    }
}

#[test]
fn a_scheme_that_is_not_symplectic_changes_the_two_form() {
    const SECOND: &[Claim] = &[Claim::Order(2), Claim::Symplectic];
    const FOURTH: &[Claim] = &[Claim::Order(4), Claim::Symplectic];
    for scene in ["tether-springs", "heavy-asymmetric-top", "free-asymmetric"] {
        for (scheme, claims, expected) in [
            ("peskin-rk2", SECOND, Ruling::Fail),
            ("implicit-midpoint", SECOND, Ruling::Fail),
            ("gauss-legendre-4", FOURTH, Ruling::Fail),
            ("rk4-quaternion", FOURTH, Ruling::Fail),
            ("moser-veselov", SECOND, Ruling::Pass),
            ("exact-rotor", SECOND, Ruling::Pass),
            ("no-squish", SECOND, Ruling::Pass),
            ("yoshida-4", FOURTH, Ruling::Pass),
        ] {
            assert_eq!(
                ruling(claiming(scheme, claims), scene, "symplectic"),
                expected,
                "{scheme} in {scene}"
            );
        }
    }
}

#[test]
fn an_energy_is_ruled_by_its_kind() {
    const GROWS: Claim = Claim::Energy(EnergyOfFreeBody::GrowsSecularly { rate_order: 3 });
    const THIRD: Claim = Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 3 });
    const SECOND: Claim = Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 2 });
    const BOUNDED: Claim = Claim::Energy(EnergyOfFreeBody::Bounded);
    const CONSTANT: Claim = Claim::Energy(EnergyOfFreeBody::Constant);
    const FALLS: Claim = Claim::Energy(EnergyOfFreeBody::Falls);
    let cases: [(&str, &'static [Claim], Ruling); 11] = [
        ("peskin-rk2", &[GROWS], Ruling::Pass),
        ("peskin-rk2", &[THIRD], Ruling::Pass),
        ("peskin-rk2", &[SECOND], Ruling::Fail),
        ("peskin-rk2", &[BOUNDED], Ruling::Fail),
        ("peskin-rk2", &[CONSTANT], Ruling::Fail),
        ("peskin-rk2", &[FALLS], Ruling::Fail),
        ("strang-rotations", &[BOUNDED], Ruling::Pass),
        ("strang-rotations", &[CONSTANT], Ruling::Fail),
        ("exact-rotor", &[CONSTANT], Ruling::Pass),
        ("semi-implicit-euler-implicit-gyro", &[FALLS], Ruling::Pass),
        ("euler", &[FALLS], Ruling::Fail),
    ];
    for (scheme, claims, expected) in cases {
        let found = ruling(claiming(scheme, claims), "free-asymmetric", "energy");
        assert_eq!(found, expected, "{scheme}: {:?}", claims[0]);
    }
}

#[test]
fn implicit_equations_are_counted() {
    for (scheme, claims, expected) in [
        ("implicit-midpoint", &[Claim::Solves(1)], Ruling::Pass),
        ("implicit-midpoint", &[Claim::Solves(2)], Ruling::Fail),
        ("krysl-liemid-ea", &[Claim::Solves(2)], Ruling::Pass),
        ("peskin-rk2", &[Claim::Solves(1)], Ruling::Fail),
    ] as [(&str, &'static [Claim], Ruling); 4]
    {
        let found = ruling(claiming(scheme, claims), "kovalevskaya", "solves");
        assert_eq!(found, expected, "{scheme}: {:?}", claims[0]);
    }
}

/// Euler's method with a flaw that only another world shows.
#[derive(Clone, Copy)]
struct Flawed<const FLAW: u8>;

/// The spin is nothing below a fixed rate.
const THRESHOLD: u8 = 0;
/// The first axis of the world is preferred.
const AXIS: u8 = 1;
/// Nothing is wrong.
const NONE: u8 = 2;

impl<const FLAW: u8> Scheme for Flawed<FLAW> {
    fn card(&self) -> Card {
        Card {
            name: "flawed",
            title: "Euler's method with a flaw",
            family: "test",
            source: "none",
            claims: &[Claim::Order(1), Claim::Equivariant],
        }
    }

    const STATES: usize = 0;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let mut motion = model.rates(t, from)?.motion();
        match FLAW {
            THRESHOLD if motion.spin.norm() < 1e-6 => motion.spin = Vector3::zeros(),
            AXIS => motion.spin.x *= h + 1.0,
            _ => {}
        }
        model.advance(from, h, &M::Rates::of(motion), to);
        Ok(())
    }
}

#[test]
fn a_rule_that_prefers_an_axis_or_a_unit_is_found_in_another_world() {
    // The worlds in which the motion differs by more than thirty roundings, and the verdict on all.
    let judged = |contestant: Contestant| -> (Vec<String>, Ruling) {
        let records = campaign(contestant, "kovalevskaya").run();
        let worlds = records.evidence[0].other_worlds.iter();
        let differ = worlds.filter(|world| world.of_rounding.is_none_or(|times| times > 30.0));
        let verdict = records.verdicts.iter().find(|verdict| verdict.claim.word() == "equivariant");
        (differ.map(|world| world.name.clone()).collect(), verdict.expect("a verdict").verdict)
    };
    assert_eq!(judged(Contestant::new(Flawed::<THRESHOLD>)), (vec!["time-1e10".to_owned()], Ruling::Fail));
    let (axis, ruling) = judged(Contestant::new(Flawed::<AXIS>));
    assert!(["turned", "binary-units"].iter().all(|name| axis.iter().any(|other| other == name)), "{axis:?}");
    assert_eq!(ruling, Ruling::Fail);
    assert_eq!(judged(Contestant::new(Flawed::<NONE>)), (Vec::new(), Ruling::Pass));
}

#[test]
fn a_way_back_has_copies_only_where_a_rounding_of_each_evaluation_does_not_explain_its_distance() {
    let way_back = |name| {
        let records = campaign(claiming(name, &[Claim::Reversible]), "kovalevskaya").run();
        let reversal = records.evidence[0].reversal.clone().expect("a way back");
        (reversal.open > 0.0, reversal.of_rounding.is_some_and(|times| times > 30.0), records.verdicts)
    };
    for (name, far) in [("implicit-midpoint", false), ("rk4-quaternion", true)] {
        let (has_copies, is_far, verdicts) = way_back(name);
        assert_eq!((has_copies, is_far), (far, far), "{name}");
        let verdict =
            verdicts.iter().find(|verdict| verdict.claim.word() == "reversible").expect("a verdict");
        assert_eq!(verdict.verdict, if far { Ruling::Fail } else { Ruling::Pass }, "{name}");
    }
}

#[test]
fn an_order_that_is_claimed_one_too_low_fails_in_every_generic_scene() {
    let generic: Vec<Scene> = scenes::built_in().into_iter().filter(|scene| setting(scene).generic).collect();
    assert_eq!(generic.len(), 8);
    let low: Vec<Contestant> = Contestant::all()
        .into_iter()
        .filter(|contestant| contestant.card.order_without_torque().min(contestant.card.order()) > 1)
        .map(|mut contestant| {
            let (order, free) = (contestant.card.order(), contestant.card.order_without_torque());
            let claims = vec![Claim::Order(order - 1), Claim::OrderWithoutTorque(free - 1)];
            contestant.card.claims = claims.leak();
            contestant
        })
        .collect();
    let campaign = Campaign { baseline: Baseline::default(), ..Campaign::of(generic.clone(), low.clone()) };
    let verdicts = campaign.run().verdicts;
    let mut judged = 0;
    for (contestant, scene) in low.iter().flat_map(|one| generic.iter().map(move |scene| (one, scene))) {
        let own: Vec<&Verdict> =
            verdicts.iter().filter(|v| v.scheme == contestant.card.name && v.scene == scene.name).collect();
        let of_order = |wanted: Ruling| own.iter().any(|v| v.claim.word() == "order" && v.verdict == wanted);
        if of_order(Ruling::Pass) {
            judged += 1;
            assert!(of_order(Ruling::Fail), "{} in {}: {own:#?}", contestant.card.name, scene.name);
        }
    }
    assert!(judged > 90, "{judged}");
}
