//! Free bodies of every kind, drawn at random: thin, flat, nearly symmetric, near the separatrix, near each axis.

use nalgebra::Matrix3;
use polhode::internals::reference::closed;
use polhode::internals::rotation::{self, Rotation};
use polhode::model::body::Body;
use polhode::model::{Quantity, Spin, System, difference};

use super::known::{UNITS, V, amplification, exact, radians};

/// Numbers that are the same in every run.
struct Draw(u64);

impl Draw {
    /// Between two numbers.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// A power of ten between two exponents, of either sign.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        let size = 10f64.powf(self.between(low, high));
        if self.between(0.0, 1.0) < 0.5 { size } else { -size }
    }

    fn vector(&mut self) -> V {
        V::from_fn(|_, _| self.between(-1.0, 1.0))
    }
}

/// Moments and L of a body of each kind.
fn kinds(draw: &mut Draw) -> Vec<(&'static str, V, V)> {
    let generic = V::new(draw.between(1.0, 1.3), draw.between(1.4, 1.7), draw.between(1.8, 2.2));
    let [a, b, c] = generic.into();
    let thin =
        V::new(10f64.powf(draw.between(-3.0, -1.0)), draw.between(0.95, 0.97), draw.between(0.98, 1.0));
    let nearly = V::new(1.0, 1.0 + 10f64.powf(draw.between(-14.0, -3.0)), draw.between(0.2, 1.8));
    let up = draw.size(-8.0, -1.0);
    // On the separatrix l₁² c (b − a) = l₃² a (c − b).
    let off = 1.0 + draw.size(-14.0, -2.0);
    let separatrix = V::new(up * (a * (c - b) / (c * (b - a))).sqrt() * off, 1.0, up);
    let small = |draw: &mut Draw, axis: V| {
        axis + V::from_fn(|i, _| if axis[i] == 0.0 { draw.size(-20.0, -1.0) } else { 0.0 })
    };
    vec![
        ("generic", generic, draw.vector()),
        ("thin", thin, draw.vector()),
        ("thin, spun across", thin, V::new(draw.size(-4.0, -2.0), 1.0, draw.size(-2.0, 0.0))),
        ("nearly symmetric", nearly, draw.vector()),
        (
            "nearly symmetric, spun across",
            nearly,
            V::new(0.6, draw.between(-1.0, 1.0), draw.size(-10.0, 0.0)),
        ),
        ("near the separatrix", generic, separatrix),
        ("near the smallest axis", generic, small(draw, V::x())),
        ("near the middle axis", generic, small(draw, -V::y())),
        ("near the largest axis", generic, small(draw, V::z())),
    ]
}

/// Measured, in units: see what it prints; the closed form with Carlson's integrals had up to 4e7, in nearly symmetric bodies
/// spun across, and 3e3 in thin ones.
#[test]
fn a_free_body_of_any_kind_is_covered_at_any_time() {
    let mut draw = Draw(1);
    for _ in 0..6 {
        for (name, moments, momentum) in kinds(&mut draw) {
            // The axes of the moments in every order.
            let by = draw.between(0.0, 3.0) as usize;
            let [moments, momentum] = [moments, momentum].map(|v| V::from_fn(|i, _| v[(i + by) % 3]));
            let body = Body::from_inertia(1.0, Matrix3::from_diagonal(&moments), None, true).expect("a body");
            let spin = Spin::Momentum(momentum);
            let system = System::new(body, Vec::new(), V::zeros(), Rotation::identity(), V::zeros(), spin)
                .expect("a system");
            let rate = rotation::length(&momentum.component_div(&moments));
            let times = [1e-6, 0.01, 1.0, 6.0, 36.0].map(|angle| angle / rate);
            let exact = exact(&system, &times);
            let (turned, amplified) = (radians(&exact), amplification(&system, &exact));
            let found = closed::solve(&system, &times).expect("a closed form");
            for (j, (state, exact)) in found.states.iter().zip(&exact).enumerate() {
                let error = difference(&system.body, state, exact)[Quantity::Orientation];
                let scale = f64::EPSILON * (1.0 + turned[j]).max(amplified[j]);
                println!("{name} after {:.2e} rad: {:.2} units", turned[j], error / scale);
                assert!(error <= UNITS * scale, "{name} after {} rad: {error:e}", turned[j]);
            }
        }
    }
}
