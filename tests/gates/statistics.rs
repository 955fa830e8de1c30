//! The rule of orders on ladders made up of numbers: what it says of each, that judges which are wrong in ways that have passed in respected
//! projects say something else, and that a wrong order never passes.

use polhode::internals::measure::{Asked, Decision, Run, decide};
use polhode::internals::self_test::judges::WRONG_JUDGES;
use polhode::internals::self_test::ladders::{TABLE, judge};
use polhode::internals::self_test::noise::Noise;
use polhode::record::Ruling;

#[test]
fn the_rule_says_of_every_made_up_ladder_what_is_right() {
    let wrong: Vec<String> = TABLE
        .iter()
        .map(|row| (row, judge(&row.rungs(), row.order)))
        .filter(|(row, said)| *said != row.right)
        .map(|(row, said)| format!("{} (order {}): {said:?}, not {:?}", row.name, row.order, row.right))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    for ruling in Ruling::ALL {
        assert!(TABLE.iter().any(|row| row.right == ruling), "{ruling:?} is in no row");
    }
}

#[test]
fn every_wrong_judge_is_told_from_the_right_one() {
    for wrong in WRONG_JUDGES {
        assert!(wrong.exposed_by().next().is_some(), "a judge that {} is never exposed", wrong.name);
    }
    assert!(WRONG_JUDGES.len() >= 18);
}

/// Ladders of each kind.
const LADDERS: usize = 10_000;

/// A direction of three components, evenly on the sphere.
fn direction(noise: &mut Noise) -> [f64; 3] {
    let vector: [f64; 3] = std::array::from_fn(|_| noise.normal());
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    vector.map(|x| x / length)
}

/// The order that is decided on runs of halved steps whose error has a leading term of an order and the next one, each in another direction at
/// four times; the next is `part` of the leading one at the finest step.
fn decided(noise: &mut Noise, order: i32, runs: i32, part: f64) -> Option<u32> {
    const TIMES: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
    let terms: Vec<([f64; 3], [f64; 3])> =
        TIMES.iter().map(|_| (direction(noise), direction(noise))).collect();
    let next = part * 2f64.powi(runs - 1);
    let run = |k: i32| {
        let h = 0.5f64.powi(k);
        let of_time = |(leading, other): &([f64; 3], [f64; 3])| -> [f64; 3] {
            std::array::from_fn(|i| h.powi(order) * (leading[i] + next * h * other[i]))
        };
        let errors = terms.iter().flat_map(of_time).collect();
        Run { step: h, steps: 1 << k, errors, rounding: vec![0.0; TIMES.len()] }
    };
    let runs = (0..runs).map(run).collect();
    match decide(&Asked::in_f64(runs, &TIMES, 0.0)) {
        Decision::Order(found) => Some(found.order),
        _ => None,
    }
}

/// With a next term of a part x of the leading one at the finest run, and so 2 x at the one before, r of the right order is x/(1 − 2 x) at most at
/// this pair: up to x = 1/20 it is decided. r of an order lower by one is (1/2 − 3 x/2)/(1 + 2 x) at least, and of any other one more: up to
/// x = 1/5 none is. Beyond that two terms may cancel in the finest pair by chance, where their directions are opposite.
#[test]
fn a_wrong_order_with_a_next_term_never_passes_and_a_right_one_is_decided() {
    for order in 1..=4 {
        let mut noise = Noise::of(11 + order as u64);
        let mut chances = 0;
        for _ in 0..LADDERS {
            // Evenly in the logarithm.
            let part = 1e-4 * 2e3f64.powf(noise.unit());
            let found = decided(&mut noise, order, 10, part);
            assert!(found.is_none_or(|found| found == order as u32), "order {order}, {part}: {found:?}");
            assert!(found.is_some() || part > 0.05, "order {order}, {part}");
            let part = 0.2 * 20f64.powf(noise.unit());
            let under_next = decided(&mut noise, order, 10, part);
            chances += usize::from(under_next.is_some_and(|found| found != order as u32));
        }
        println!("order {order}: {chances} of {LADDERS} with a large next term have another order by chance");
        assert!(chances * 100 < LADDERS, "order {order}: {chances}");
    }
}
