//! The coefficients of a rotation as power series, for f64 and for rows of it.
//!
//! A rotation vector v, |v| ≤ 1 rad, turns by the quaternion (c, s v/2); with x = |v|/2 and y = x² ≤ ¼
//!
//! (1)  c = cos x     = 1 − y/2! + y²/4! − y³/6! + … − y⁷/14!      left out: y⁸/16! < 1e-18
//! (2)  s = sin x / x = 1 − y/3! + y²/5! − y³/7! + … − y⁷/15!      left out: y⁸/17! < 1e-19
//!
//! in y, so that neither a root nor a division is taken, and in powers of y², so that the terms do not wait for each
//! other.

use super::Number;

/// Largest (angle/2)² that the series take: one radian.
pub const LARGEST_SQUARE: f64 = 0.25;

/// cos x and sin x / x for y = x² ≤ ¼, by (1) and (2).
#[inline(always)]
pub fn coefficients<T: Number>(y: T) -> (T, T) {
    let one = y.like(1.0);
    let yy = y * y;
    let y4 = yy * yy;
    let cosine = (pair(y, 24.0, 720.0) + yy * pair(y, 40_320.0, 3_628_800.0))
        + y4 * pair(y, 479_001_600.0, 87_178_291_200.0);
    let sine = (pair(y, 120.0, 5_040.0) + yy * pair(y, 362_880.0, 39_916_800.0))
        + y4 * pair(y, 6_227_020_800.0, 1_307_674_368_000.0);
    // The small parts are put together first: one rounding of the size of the result.
    (one - (y * 0.5 - yy * cosine), one - (y * (1.0 / 6.0) - yy * sine))
}

/// 1/n − y/m.
#[inline(always)]
fn pair<T: Number>(y: T, n: f64, m: f64) -> T {
    y.like(1.0 / n) - y * (1.0 / m)
}

/// Largest square of an angle that [`of_small_angle`] takes: what is left out of [`COSINE`] there is y⁵/10! < 1e-17.
pub const SMALL_SQUARE: f64 = 1.0 / 128.0;
/// cos x in y = x².
pub const COSINE: [f64; 5] = [1.0, -1.0 / 2.0, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40_320.0];
/// sin x / x.
pub const SINE: [f64; 5] = [1.0, -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5_040.0, 1.0 / 362_880.0];
/// (1 − cos x)/x².
pub const VERSINE: [f64; 5] = [1.0 / 2.0, -1.0 / 24.0, 1.0 / 720.0, -1.0 / 40_320.0, 1.0 / 3_628_800.0];

/// One of these series for y ≤ [`SMALL_SQUARE`], in the order in which it is ready first.
#[inline(always)]
pub fn of_small_angle<T: Number>(y: T, [a, b, c, d, e]: [f64; 5]) -> T {
    let yy = y * y;
    ((y.like(a) + y * b) + yy * c) + (y * yy) * (y.like(d) + y * e)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_meet_sine_and_cosine_to_a_rounding_unit() {
        let mut worst = [0.0f64; 2];
        for k in 0..=200_000 {
            let x = 0.5 * f64::from(k) / 200_000.0;
            let (cosine, sine) = coefficients(x * x);
            let true_sine = if x == 0.0 { 1.0 } else { x.sin() / x };
            worst[0] = worst[0].max((cosine - x.cos()).abs());
            worst[1] = worst[1].max((sine - true_sine).abs());
        }
        // A unit in the last place below 1 is EPSILON/2. sin x / x of the library is rounded twice itself. That the two are
        // not equal everywhere shows that something was compared.
        assert!(worst[0] <= 0.5 * f64::EPSILON && worst[0] > 0.0, "{worst:?}");
        assert!(worst[1] <= f64::EPSILON && worst[1] > 0.0, "{worst:?}");
    }

    #[test]
    fn the_series_are_one_to_the_last_bit_where_the_square_underflows() {
        for x in [0.0, 1e-308, 1e-200, 1e-160, 1e-9] {
            assert_eq!(coefficients(x * x), (1.0, 1.0));
        }
        // … and not before: an angle of 1e-7 is seen in the cosine of its half.
        assert!(coefficients(2.5e-15).0 < 1.0);
    }
}
