use super::*;
use crate::rotation::elliptic::amplitude;

/// b₀ over a₀ = 1.
const COMPLEMENTS: [f64; 6] = [1.0, 0.9, 0.3, 1e-3, 1e-9, 1e-30];

fn passage(b: f64, v: f64) -> Passage<f64> {
    let ladder = Ladder::up(1.0, b, 0.8, 0.2);
    ladder.down((ladder.mean * v).sin_cos())
}

fn angle([x, y]: [f64; 2]) -> f64 {
    y.atan2(x)
}

#[test]
fn the_levels_give_jacobis_functions() {
    for b in COMPLEMENTS {
        let quarter = amplitude(0.0, b * b).quarter_period;
        for part in [-2.7, -1.0, -0.4, 1e-9, 0.5, 0.999, 1.6, 3.2] {
            let v = part * quarter;
            let (found, other) = (passage(b, v), amplitude(v, b * b));
            let delta = other.cosine.hypot(b * other.sine);
            // Both reduce v by K, which costs a rounding of v; measured up to 3.
            let bound = 4.0 * f64::EPSILON * (1.0 + v.abs());
            assert!((found.sine - other.sine).abs() < bound, "k' {b}, v {v}");
            assert!((found.cosine - other.cosine).abs() < bound, "k' {b}, v {v}");
            assert!((found.delta - delta).abs() < bound, "k' {b}, v {v}");
        }
    }
}

#[test]
fn near_a_quarter_period_the_cosine_keeps_its_digits() {
    // cn(K − w) = k′ sn w/dn w and dn(K − w) = k′/dn w.
    for b in COMPLEMENTS {
        let w: f64 = 0.25;
        let quarter = amplitude(0.0, b * b).quarter_period;
        let (near, far) = (passage(b, quarter - w), passage(b, w));
        // K is good to a rounding of its own, at most 100.
        let bound = f64::EPSILON * (16.0 + 4.0 * quarter);
        assert!((near.cosine / (b * far.sine / far.delta) - 1.0).abs() < bound, "k' {b}: {}", near.cosine);
        assert!((near.delta / (b / far.delta) - 1.0).abs() < bound, "k' {b}: {}", near.delta);
    }
}

#[test]
fn the_phase_is_odd_and_comes_back_after_half_a_period() {
    for b in COMPLEMENTS {
        let quarter = amplitude(0.0, b * b).quarter_period;
        for part in [0.1, 0.5, 0.9] {
            let v = part * quarter;
            let here = angle(passage(b, v).phase);
            assert!((here + angle(passage(b, -v).phase)).abs() < 1e-15, "k' {b}, v {v}");
            let bound = 4.0 * f64::EPSILON * (1.0 + quarter);
            assert!((here - angle(passage(b, v + 2.0 * quarter).phase)).abs() < bound, "k' {b}, v {v}");
        }
        assert!(angle(passage(b, quarter).phase).abs() < 4.0 * f64::EPSILON * (1.0 + quarter), "k' {b}");
    }
}

/// dQ/dt = Q ω, with ω from the body's own L: by the midpoint rule over many short steps.
#[test]
fn the_turn_is_what_the_spin_adds_up_to() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    for l in [Vector3::new(0.3, 0.5, 0.8), Vector3::new(0.9, 0.1, 0.4), Vector3::new(0.5, 0.8, -0.33)] {
        let (t, count) = (3.0, 3000);
        let step = t / f64::from(count);
        let mut added = Rotation::identity();
        for n in 0..count {
            let middle = turn_in(&moments, &l, (f64::from(n) + 0.5) * step).inverse_transform_vector(&l);
            added *= rotation::turn(&(middle.component_div(&moments) * step));
        }
        let apart = rotation::angle_between(&added, &turn_in(&moments, &l, t));
        // t h²/24 = 1e-7 times derivatives of order one.
        assert!(apart < 1e-7 && apart > 1e-12, "{l:?}: {apart:e}");
    }
}

#[test]
fn both_forms_of_the_separatrix_meet() {
    let moments = Vector3::new(1.0, 2.0, 4.0);
    // l₁² c (b − a) = l₃² a (c − b): l₁² · 4 = l₃² · 2.
    for up in [0.5, 1e-3, 1e-9] {
        for side in [1.0 + 1e-13, 1.0 - 1e-13] {
            let on = Vector3::new(up / 2f64.sqrt(), -1.0, up);
            let off = Vector3::new(on.x * side, on.y, on.z);
            for t in [-7.0, 0.3, 4.0] {
                let apart = rotation::angle_between(&turn_in(&moments, &on, t), &turn_in(&moments, &off, t));
                // exp(λ t) times 1e-13, λ² = (w₁ − w₂)(w₂ − w₃) = 1/8 at |L| = 1 and 1.6 times that at |L| = 1.2.
                assert!(apart < 1e-11, "{up}, {side}, {t}: {apart:e}");
            }
        }
    }
}

/// Rounding of the product of attitudes leaves √n units, 1e-14 rad; a unit more in the same direction at each step would be
/// some 1e-13, and near the middle axis all of it grows.
#[test]
fn roundings_of_equal_steps_do_not_add_up() {
    let steps = 4096;
    for (moments, l, t, bound) in [
        // Measured: 2e-15; 1e-13 where (3) and (4) are taken as they stand.
        (Vector3::new(1.0, 1.0, 2.5), Vector3::new(0.4, 0.3, 0.8), 8.0, 2e-14),
        // Measured: 3e-14; 5e-13 where they are.
        (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.001, 2.0, 0.003), 16.0, 2e-13),
    ] {
        let step = t / f64::from(steps);
        let mut added = Rotation::identity();
        for _ in 0..steps {
            let body = added.inverse_transform_vector(&l);
            added = rotation::renormalized(added * turn_in(&moments, &body, step));
        }
        let apart = rotation::angle_between(&added, &turn_in(&moments, &l, t));
        assert!(apart < bound, "{moments:?}: {apart:e}");
    }
}
