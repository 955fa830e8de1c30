//! Lagrange's top in all its motions.

use polhode::internals::reference::closed;
use polhode::internals::rotation;
use polhode::model::{PerQuantity, difference};

use super::known::{BLADES, ROD, SIDEWAYS, V, exact, grid, top, turned};

/// Tops and pendulums of every kind; through the vertical the axis passes with p = ± s exactly.
#[test]
fn every_kind_of_symmetric_top_is_covered() {
    let down = V::new(0.0, 0.0, -8.0);
    let oblique = V::new(3.0, -2.0, -6.0);
    let none = V::zeros();
    let tilt = V::new(0.0, 1.0, 0.0);
    let cases = [
        ("slow, through loops", top(&BLADES, V::new(0.5, 0.25, 0.0), V::new(0.5, -0.25, 2.0), oblique)),
        ("hanging", top(&BLADES, V::new(2.5, 0.0, 0.5), V::new(0.5, 1.0, -0.5), down)),
        ("axis along x", top(&SIDEWAYS, V::new(0.5, 0.25, 1.0), V::new(2.0, -0.25, 1.0), oblique)),
        ("spherical pendulum", top(&ROD, tilt, rotation::turn(&tilt) * V::new(1.5, 0.75, 0.0), down)),
        ("pendulum from rest", top(&ROD, V::new(1.0, 0.0, 0.0), none, down)),
        ("pendulum from the top", top(&ROD, none, V::new(20.0, 0.0, 0.0), down)),
        ("pendulum from the bottom", top(&ROD, none, V::new(6.0, 4.0, 0.0), -down)),
        ("disc released from rest", top(&BLADES, V::new(1.0, 0.0, 0.0), none, down)),
        ("upright, kicked", top(&BLADES, none, V::new(0.5, 0.25, 4.0), down)),
        ("nearly upright", top(&BLADES, V::new(1e-7, 0.0, 0.0), V::new(0.0, 0.5, 8.0), down)),
    ];
    for (name, system) in cases {
        let duration = 10.0;
        let times = grid(duration);
        let found = closed::solve(&system, &times).unwrap_or_else(|| panic!("{name}: a closed form"));
        let exact = exact(&system, &times);
        for (j, (a, b)) in found.states.iter().zip(&exact).enumerate() {
            let error = difference(&system.body, a, b);
            let sizes = PerQuantity::from([1.0, 4.0, 1.0, 8.0, 16.0, 2.0]);
            for (i, error) in error {
                let stated = found.uncertainty[j][i] + 8.0 * f64::EPSILON * sizes[i];
                assert!(error <= stated, "{name} at {} s, {i:?}: {error:e} > {stated:e}", times[j]);
                // Measured: up to 6e-12 over the top of a pendulum, near the separatrix; 2e-13 elsewhere.
                assert!(stated < 1e-10, "{name} at {} s, {i:?}: {stated:e}", times[j]);
            }
        }
        assert!(turned(&exact, duration) > 5.0, "{name}");
    }
}
