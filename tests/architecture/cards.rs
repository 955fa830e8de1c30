//! What a card tells of its claims, and a workspace of its content.

use nalgebra::Vector3;
use polhode::internals::model::{AnyModel, Free, FreeRates};
use polhode::model::Model;
use polhode::schemes::{Card, Euler, PeskinRk2, Scheme, SideBySide, Workspace};
use polhode::schemes::{Claim, Quantity, When};
use polhode::simulate::Contestant;

use crate::common::scene;

fn card(claims: &'static [Claim]) -> Card {
    Card { name: "made-up", title: "Made up", family: "test", source: "none", claims }
}

#[test]
fn a_card_tells_the_numbers_of_its_claims_and_0_where_there_are_none() {
    let told = |claims| {
        let card = card(claims);
        [card.order(), card.order_without_torque(), card.tolerance_exponent(), card.evaluations()]
    };
    const EXACT: Claim = Claim::Exact(Quantity::Position, When::NoForce);
    assert_eq!(told(&[EXACT]), [0, 0, 0, 0]);
    assert_eq!(told(&[EXACT, Claim::Order(3)]), [3, 3, 0, 0]);
    assert_eq!(told(&[Claim::Order(2), Claim::OrderWithoutTorque(4), Claim::Evaluations(5)]), [2, 4, 0, 5]);
    assert_eq!(told(&[Claim::FollowsTolerance(6), Claim::Evaluations(7)]), [0, 0, 6, 7]);
}

#[test]
fn a_card_names_no_claim_twice_and_what_it_says_of_an_order_first() {
    for scheme in Contestant::all() {
        let claims = scheme.card.claims;
        for (k, claim) in claims.iter().enumerate() {
            assert!(!claims[..k].contains(claim), "{}: {claim}", scheme.card.name);
        }
        let of_an_order = |claim: &Claim| {
            matches!(
                claim,
                Claim::Order(_)
                    | Claim::OrderWithoutTorque(_)
                    | Claim::SolvesAnotherMotion
                    | Claim::FollowsTolerance(_)
            )
        };
        assert!(claims.iter().any(of_an_order), "{}", scheme.card.name);
        assert!(claims.is_sorted_by_key(|claim| !of_an_order(claim)), "{}", scheme.card.name);
    }
}

#[test]
fn the_name_of_a_substepped_scheme_tells_its_parts_and_its_base() {
    assert_eq!(Card::parts("substepped-4-peskin-rk2"), Some((4, "peskin-rk2")));
    for other in ["peskin-rk2", "substepped-", "substepped-4", "substepped-few-euler"] {
        assert_eq!(Card::parts(other), None, "{other}");
    }
}

#[test]
fn a_scheme_evaluates_the_rates_as_often_side_by_side_as_alone() {
    for (form, evaluations) in [
        (Euler::SIDE_BY_SIDE, Euler.card().evaluations()),
        (PeskinRk2::SIDE_BY_SIDE, PeskinRk2.card().evaluations()),
    ] {
        assert_eq!(form.map(SideBySide::evaluations), Some(u64::from(evaluations)));
    }
}

#[test]
fn a_workspace_takes_states_and_history_of_another() {
    let AnyModel::Free(model) = scene("free-asymmetric").system.least() else { panic!("a free body") };
    let start = model.start();
    let mut one = Workspace::<Free>::new(&start, 2);
    let mut other = Workspace::<Free>::new(&start, 2);
    let turned = model.rates(0.0, &start).expect("a spin");
    model.advance(&start, 0.5, &turned, &mut other.states[1]);
    let moved = other.states[1];
    assert_ne!(moved, start);
    let rates = FreeRates { spin: Vector3::x() };
    other.history.push(rates);
    one.copy_from(&other);
    assert_eq!((one.states, one.history), (vec![start, moved], vec![rates]));
}
