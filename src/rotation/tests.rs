//! The conventions, and the quick forms beside the plain ones.

use super::*;
use crate::arithmetic::DoubleDouble;
use std::f64::consts::PI;

#[test]
fn a_turn_is_a_rotation_for_tiny_huge_and_no_angles() {
    for exponent in [-320, -200, -160, -30, -8, -3, 0, 3, 8, 15, 160, 300] {
        let v = Vector3::new(1.0, -2.0, 0.5) * 10f64.powi(exponent);
        let rotation = turn(&v);
        assert!((rotation.norm() - 1.0).abs() < 4.0 * f64::EPSILON, "exponent {exponent}");
    }
    assert_eq!(turn(&Vector3::<f64>::zeros()), Rotation::identity());
}

#[test]
fn a_quaternion_off_the_sphere_is_put_back_to_the_square_of_its_deviation() {
    let unit = turn(&Vector3::new(0.3, -0.8, 1.7)).into_inner();
    for deviation in [1e-3, -1e-3] {
        let back = renormalized(Rotation::new_unchecked(unit * (1.0 + deviation)));
        // (1 + d)(1.5 − (1 + d)²/2) = 1 − 1.5 d² − d³/2.
        assert!((back.into_inner().norm() - 1.0).abs() < 1.6 * deviation * deviation);
    }
}

#[test]
fn an_angle_between_directions_does_not_depend_on_their_lengths() {
    let (a, b) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0));
    for length in [1e-200, 1e-3, 1.0, 1e200] {
        let angle = angle_between_directions(&(a * length), &(b * length));
        assert!((angle - PI / 4.0).abs() < 4.0 * f64::EPSILON, "{length:e}: {angle}");
    }
}

#[test]
fn a_vector_of_no_length_makes_no_angle() {
    let (zero, x) = (Vector3::<f64>::zeros(), Vector3::x());
    assert_eq!(
        [(&zero, &x), (&x, &zero), (&zero, &zero)].map(|(a, b)| angle_between_directions(a, b)),
        [0.0; 3]
    );
}

#[test]
fn half_a_turn_is_about_the_axis_that_its_quaternion_names() {
    for axis in [Vector3::x(), -Vector3::y(), Vector3::z()] {
        let half = Rotation::new_unchecked(Quaternion::from_parts(0.0, axis));
        assert_eq!(vector_of(&half), axis * PI);
    }
}

#[test]
fn a_line_of_points_is_fitted_to_rounding_at_every_angle() {
    let line = [Vector3::new(0.3, -0.2, 0.5), Vector3::new(-0.6, 0.4, -1.0)];
    for angle in [0.0, 1e-12, 1e-8, 1e-3, 1.0, 3.0, PI - 1e-3, PI - 1e-6, PI - 1e-7, PI] {
        let turned = line
            .map(|x| turn(&(Vector3::new(0.0, 0.928_476_690_885_259, 0.371_390_676_354_103_7) * angle)) * x);
        let fitted = best_fit(&line, &turned, &[1.0, 2.0]);
        let apart = angle_between_directions(&(fitted * line[0]), &turned[0]);
        // The bound that stored solutions are read to.
        let bound = 16.0 * f64::EPSILON;
        assert!(apart < bound, "angle {angle}: {apart:e}");
        // About the line there are many that do: it is that of least turning, to what the angle of the line is known to.
        let least = length(&vector_of(&fitted));
        assert!((least - angle).abs() < bound, "angle {angle}: {least}");
    }
}

#[test]
fn a_fit_is_to_points_by_their_weights_at_every_scale() {
    let rotation = turn(&Vector3::new(0.7, -1.9, 0.4));
    for scale in [1e-150, 1.0, 1e150] {
        let points = [Vector3::x(), Vector3::y(), Vector3::new(0.3, -0.2, 1.0)].map(|p| p * scale);
        let mut turned = points.map(|p| rotation * p);
        turned[1] = -turned[1];
        let apart = angle_between(&best_fit(&points, &turned, &[1.0, 0.0, 2.0]), &rotation);
        assert!(apart < 1e-14, "{scale:e}: {apart:e}");
    }
    let point = [Vector3::x()];
    for nothing in [Vector3::zeros(), Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NAN)] {
        assert_eq!(best_fit(&point, &[nothing], &[1.0]), Rotation::identity());
    }
    assert_eq!(best_fit::<f64>(&[], &[], &[]), Rotation::identity());
}

#[test]
fn a_turn_agrees_with_rodrigues_formula() {
    for angle in [1e-9, 1e-3, 0.5, 2.0, PI, 4.0, 100.0] {
        let axis = Vector3::new(2.0, -1.0, 2.0) / 3.0;
        let p = Vector3::new(0.3, 0.7, -1.1);
        let rodrigues = p * f64::cos(angle)
            + axis.cross(&p) * f64::sin(angle)
            + axis * axis.dot(&p) * (1.0 - f64::cos(angle));
        // Two evaluations of trigonometric functions of an angle that is itself rounded: a few u (1 + angle).
        let error = (turn(&(axis * angle)) * p - rodrigues).norm();
        assert!(error < 4.0 * f64::EPSILON * (1.0 + angle), "angle {angle}: {error:e}");
    }
}

#[test]
fn the_quick_turn_is_the_plain_one_for_tiny_and_huge_angles() {
    let from = turn(&Vector3::new(0.4, -1.1, 0.7));
    let direction = Vector3::new(2.0, -1.0, 2.0) / 3.0;
    for exponent in -300..=15 {
        for digits in [1.0, 2.7, 3.3, 9.99] {
            let angle = digits * 10f64.powi(exponent);
            for (spin, s) in [(direction * angle, 1.0), (direction, angle), (direction * -angle, 0.25)] {
                let plain = renormalized(turn(&(spin * s)) * from);
                let quick = turned(&from, &spin, s);
                // Two products of quaternions, four parts of up to 1 each: measured 3.4e-16. Beyond a radian the
                // angle itself is rounded, to u of it, in its own way.
                let apart = (quick.into_inner() - plain.into_inner()).norm();
                let bound =
                    3.0 * f64::EPSILON * (1.0 + if angle * s.abs() > 1.0 { angle * s.abs() } else { 0.0 });
                assert!(apart < bound, "angle {angle:e} × {s}: {apart:e}");
            }
        }
    }
}

#[test]
fn the_quick_turn_tells_small_angles_and_more_than_half_a_turn() {
    let unit = Rotation::identity();
    for angle in [1e-12, 1e-5, 9e-4, 0.999, 1.001, 3.0] {
        let quick = turned(&unit, &Vector3::new(0.0, angle, 0.0), 1.0);
        assert!((vector_of(&quick).y - angle).abs() <= 2.0 * f64::EPSILON * angle, "{angle}");
    }
    // Half a turn and a quarter more is a quarter turn short of a whole one, the other way.
    let quick = turned(&unit, &Vector3::new(0.0, 0.0, 1.5 * PI), 1.0);
    assert!((vector_of(&quick).z + 0.5 * PI).abs() < 1e-15);
    assert_eq!(turned(&unit, &Vector3::zeros(), 1.0), unit);
    assert!(turned(&unit, &Vector3::x(), f64::INFINITY).w.is_nan());
}

#[test]
fn a_million_quick_turns_keep_the_length() {
    let mut q = turn(&Vector3::new(0.4, -1.1, 0.7));
    let mut worst = 0.0f64;
    for _ in 0..1_000_000 {
        q = turned(&q, &Vector3::new(0.3, -0.2, 0.9), 0.01);
        worst = worst.max((q.norm_squared() - 1.0).abs());
    }
    // One turn's rounding, not that of all: measured 4.4e-16.
    assert!(worst < 6.0 * f64::EPSILON && worst > 0.0, "{worst:e}");
}

#[test]
fn the_matrix_and_the_spin_of_the_formulas_are_the_plain_ones() {
    let momentum = Vector3::new(0.7, -2.0, 1.1);
    for k in 0..100 {
        let rotation = turn(&(Vector3::new(0.31, -0.17, 0.43) * f64::from(k)));
        let plain = rotation.to_rotation_matrix().into_inner();
        assert!((axes(&rotation) - plain).amax() < 4.0 * f64::EPSILON);
        for inverse in [Vector3::new(1.0, 0.5, 0.25), Vector3::new(0.0, 2.0, 2.0), Vector3::repeat(0.3)] {
            let columns = formulas::outer_columns([rotation.w, rotation.i, rotation.j, rotation.k]);
            let quick: Vector3<f64> = formulas::spin(&columns, inverse.into(), momentum.into()).into();
            let spin = plain * plain.tr_mul(&momentum).component_mul(&inverse);
            // Two products with a matrix whose entries are good to 4 u.
            let bound = 8.0 * f64::EPSILON * momentum.norm() * inverse.amax();
            assert!((quick - spin).amax() < bound, "{inverse:?}");
        }
        // On a sphere Ω is L over the moment, without rounding of the attitude.
        let columns = formulas::outer_columns([rotation.w, rotation.i, rotation.j, rotation.k]);
        assert_eq!(Vector3::from(formulas::spin(&columns, [0.3; 3], momentum.into())), momentum * 0.3);
    }
}

#[test]
fn the_logarithm_undoes_the_exponential_below_a_half_turn() {
    for angle in [1e-300, 1e-12, 1e-4, 1.0, 3.0, 3.1] {
        let v = Vector3::new(-1.0, 2.0, 2.0) / 3.0 * angle;
        assert!((vector_of(&turn(&v)) - v).norm() <= 4e-15 * angle, "angle {angle}");
    }
}

#[test]
fn an_angle_of_1e_minus_12_is_seen() {
    let a = turn(&Vector3::new(0.4, 0.1, -0.9));
    let b = a * turn(&Vector3::new(0.0, 1e-12, 0.0));
    assert!((angle_between(&a, &b) - 1e-12).abs() < 3e-16);
}

#[test]
fn the_best_fit_finds_the_rotation_of_solids_plates_and_rods() {
    let rotation = turn(&Vector3::new(0.7, -1.9, 0.4));
    let solid = vec![
        Vector3::new(1.0, 0.0, 0.2),
        Vector3::new(-0.3, 1.0, 0.0),
        Vector3::new(0.0, -0.4, 1.0),
        Vector3::new(-0.7, -0.6, -1.2),
    ];
    let plate: Vec<_> = solid.iter().map(|p| Vector3::new(p.x, p.y, 0.0)).collect();
    for points in [solid, plate] {
        let turned: Vec<_> = points.iter().map(|p| rotation * p).collect();
        assert!(angle_between(&best_fit(&points, &turned, &[1.0, 2.0, 0.5, 1.5]), &rotation) < 1e-14);
    }
    let rod = [Vector3::new(1.0, 2.0, -1.0), Vector3::new(-0.5, -1.0, 0.5)];
    let turned = rod.map(|p| rotation * p);
    let found = best_fit(&rod, &turned, &[1.0, 2.0]);
    assert!((found * rod[0] - turned[0]).norm() < 1e-14);
}

/// How far the best fit of a body that is a thousand times as long as wide is off [rad].
fn off_about_a_line<T: Real>() -> f64 {
    let vector = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).map(T::of);
    let rotation = turn(&vector(0.7, -1.9, 0.4));
    let axes = turn(&vector(-0.3, 0.2, 1.1));
    let points =
        [vector(1000.0, 0.0, 0.0), vector(-1000.0, 1.0, 0.0), vector(0.0, 0.0, 1.0), vector(0.0, -1.0, -1.0)];
    let points = points.map(|point| axes * point);
    let turned = points.map(|point| rotation * point);
    angle_between(&best_fit(&points, &turned, &[T::one(); 4]), &rotation).to_f64()
}

#[test]
fn the_best_fit_of_a_thin_body_is_as_good_as_the_sums_that_it_is_made_from() {
    // A sum over the points is off by a unit of the largest square, which is a million times the smallest.
    let condition = 1e6;
    assert!(off_about_a_line::<f64>() < 4.0 * condition * f64::UNIT);
    assert!(off_about_a_line::<DoubleDouble>() < 4.0 * condition * DoubleDouble::UNIT);
}

#[test]
fn the_change_of_a_turn_is_its_matrix_less_the_unit_matrix() {
    for angle in [0.0, 1e-200, 1e-9, 0.3, 0.999, 1.001, 3.0, 1e3] {
        let spin = Vector3::new(2.0, -1.0, 2.0) / 3.0;
        let rows = change_of_turn(&spin, angle);
        let plain = turn(&(spin * angle)).to_rotation_matrix().into_inner() - Matrix3::identity();
        for (i, row) in rows.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let bound = 4.0 * f64::EPSILON * (1.0 + if angle > 1.0 { angle } else { 0.0 });
                assert!((entry - plain[(i, j)]).abs() <= bound, "angle {angle}, entry {i} {j}");
            }
        }
        // Off the diagonal a small turn keeps its digits, which the difference of two matrices does not have.
        assert!((rows[0][1] + spin.z * angle).abs() <= angle * angle + 1e-15 * angle, "{angle}");
    }
}

#[test]
fn a_quaternion_near_the_unit_sphere_is_put_on_it_without_a_root() {
    let q = turn(&Vector3::new(0.4, -1.1, 0.7)).into_inner();
    for stretch in [-0.3, -1e-3, -4e-7, -1e-12, 0.0, 3e-16, 2e-9, 4e-7, 1e-2, 5.0] {
        let long = q * (1.0 + stretch);
        let apart = (unit(&long).into_inner() - long / long.norm()).norm();
        assert!(apart < 2.0 * f64::EPSILON, "{stretch}: {apart:e}");
    }
}

/// Parts of which sums and products are 1 in many ways: a length that is taken for one by mistake is left as it is.
#[test]
fn a_quaternion_of_any_parts_and_any_length_is_put_on_the_unit_sphere() {
    const PARTS: [f64; 5] = [0.0, 0.5, 1.0, -1.0, 2.0];
    for place in 1..PARTS.len().pow(4) {
        let part = |digit: u32| PARTS[place / PARTS.len().pow(digit) % PARTS.len()];
        for scale in [1.0, 1e-4] {
            let q = Quaternion::new(part(0), part(1), part(2), part(3)) * scale;
            let apart = (unit(&q).into_inner() - q / q.norm()).norm();
            assert!(apart < 2.0 * f64::EPSILON, "{q}: {apart:e}");
        }
    }
}

#[test]
fn the_spin_of_a_quaternion_of_any_length_is_that_of_its_direction() {
    let momentum = Vector3::new(0.7, -2.0, 1.1);
    let inverse = Vector3::new(1.25, 0.5, 0.25);
    for k in 1..50 {
        let rotation = turn(&(Vector3::new(0.31, -0.17, 0.43) * f64::from(k)));
        let columns = formulas::outer_columns([rotation.w, rotation.i, rotation.j, rotation.k]);
        let spin = Vector3::from(formulas::spin(&columns, inverse.into(), momentum.into()));
        let q = rotation.into_inner() * (0.7 + 0.1 * f64::from(k));
        let (found, moved) = formulas::spin_at([q.w, q.i, q.j, q.k], 0.05, inverse.into(), momentum.into());
        let bound = 8.0 * f64::EPSILON * momentum.norm();
        assert!((Vector3::from(found) - spin).amax() < bound);
        let rate = rate_of(&spin, &q) * 0.1;
        let moved = Quaternion::new(moved[0], moved[1], moved[2], moved[3]);
        assert!((moved - rate).norm() < bound * 0.1 * q.norm());
    }
}

#[test]
fn what_is_written_out_has_the_bits_of_nalgebra() {
    for round in 0..200 {
        let part = |k: i32| (0.7 + f64::from(round) + 1.3 * f64::from(k * k)).sin();
        let q = Quaternion::new(part(0), part(1), part(2), part(3));
        let v = Vector3::new(part(4), part(5), part(6));
        assert_eq!(normalized(q), UnitQuaternion::new_normalize(q));
        assert_eq!(turned_back(&normalized(q), &v), normalized(q).inverse_transform_vector(&v));
        assert_eq!(along(round as usize % 3, v.x), Vector3::ith(round as usize % 3, v.x));
    }
    assert_eq!(identity::<f64>(), UnitQuaternion::identity());
}
