//! Which scenes have a closed form, and how good it is.

use polhode::internals::reference::closed;
use polhode::internals::rotation;
use polhode::model::{PerQuantity, Quantity, difference};
use polhode::scenes;

use super::known::{UNITS, amplification, exact, grid, radians};
use crate::common::scene;

#[test]
fn closed_forms_are_found_by_what_a_system_is() {
    let expected = [
        ("free-asymmetric", "free asymmetric body, by Jacobi's functions; straight line"),
        ("free-oblate", "free symmetric body, by two steady rotations; straight line"),
        ("free-rod", "free rod, by a steady rotation; straight line"),
        ("fast-sphere", "free sphere, by a steady rotation; straight line"),
        ("exact-separatrix", "free body on the separatrix, by tanh and sech; straight line"),
        ("dzhanibekov", "free asymmetric body, by Jacobi's functions; straight line"),
        ("nasa-check-case-2", "free asymmetric body, by Jacobi's functions; parabola"),
        ("spinning-coin", "free symmetric body, by two steady rotations; parabola"),
        ("lagrange-fast-top", "symmetric heavy top, by Jacobi's functions"),
        ("sleeping-top", "symmetric heavy top, by Jacobi's functions"),
    ];
    for (name, form) in expected {
        assert_eq!(closed::solve(&scene(name).system, &[0.0]).expect("a closed form").name, form, "{name}");
    }
    let none = scenes::built_in().iter().filter(|s| closed::solve(&s.system, &[0.0]).is_none()).count();
    // The tops of Kovalevskaya and of no name, and every scene with another law than gravity but for wheels about an axis of symmetry.
    assert_eq!(none, 23);
}

#[test]
fn closed_forms_are_good_to_a_few_units_a_radian_and_say_so() {
    let mut count = 0;
    for scene in scenes::built_in() {
        let times = grid(scene.duration);
        let Some(found) = closed::solve(&scene.system, &times) else { continue };
        let exact = exact(&scene.system, &times);
        let turned = radians(&exact);
        let amplified = amplification(&scene.system, &exact);
        let mut worst = 0.0f64;
        for (j, state) in found.states.iter().enumerate() {
            let error = difference(&scene.system.body, state, &exact[j]);
            let bound = UNITS * f64::EPSILON * (1.0 + turned[j]).max(amplified[j]);
            worst = worst.max(UNITS * error[Quantity::Orientation] / bound);
            assert!(
                error[Quantity::Orientation] <= bound,
                "{} at {} s: {:e} > {bound:e}",
                scene.name,
                times[j],
                error[Quantity::Orientation]
            );
            let sizes = PerQuantity::from([
                rotation::length(&exact[j].position) + scene.system.body.extent(),
                rotation::length(&exact[j].velocity),
                1.0,
                rotation::length(&exact[j].angular_velocity),
                rotation::length(&exact[j].angular_momentum),
                rotation::length(&exact[j].position) + scene.system.body.extent(),
            ]);
            for (quantity, error) in error {
                let stated = found.uncertainty[j][quantity] + 4.0 * f64::EPSILON * sizes[quantity];
                let place = format!("{} at {} s, {quantity:?}", scene.name, times[j]);
                assert!(error <= stated, "{place}: {error:e} > {stated:e}");
            }
        }
        println!("{}: {worst:.2} units", scene.name);
        count += 1;
    }
    assert_eq!(count, 27);
}
