//! Slopes, windows, confidence intervals and drift rates.
//!
//! A convergence ladder is a list of (step h, error e) with h falling. Fits use log h itself, so any ratio of
//! steps will do.

mod two_terms;

pub use two_terms::{misfit, misfit_of_a_power};

/// Student's t, 97.5 % quantile, for 1 … 10 degrees of freedom.
const STUDENT: [f64; 10] = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228];

/// The 97.5 % quantile of Student's t with ν degrees of freedom, one or more. Beyond ten the expansion of Cornish and Fisher about
/// the quantile z of the normal distribution is good to 1.2e-4 at ν = 11 and to 2e-6 at ν = 30:
///
/// ```text
/// t = z + (z³ + z)/(4 ν) + (5 z⁵ + 16 z³ + 3 z)/(96 ν²) + (3 z⁷ + 19 z⁵ + 17 z³ − 15 z)/(384 ν³)
/// ```
fn student(freedom: usize) -> f64 {
    if let Some(quantile) = STUDENT.get(freedom.saturating_sub(1)) {
        return *quantile;
    }
    let (z, n): (f64, f64) = (1.959_963_985, freedom as f64);
    z + (z.powi(3) + z) / (4.0 * n)
        + (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / (96.0 * n * n)
        + (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / (384.0 * n.powi(3))
}

/// Successive slopes that differ by no more than this belong to one asymptotic window.
pub const SLOPES_AGREE: f64 = 0.15;

/// Fewest successive slopes in a window.
pub const FEWEST_SLOPES: usize = 3;

/// Most rungs in a window: coarser ones add bias, not certainty.
pub const MOST_RUNGS: usize = 6;

/// Standard deviation of a normal distribution over the lower quartile of its sizes.
const QUARTILE_TO_DEVIATION: f64 = 3.139;

/// A straight line through log e against log h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Least-squares slope.
    pub slope: f64,
    /// Lower end of its 95 % confidence interval.
    pub low: f64,
    /// Upper end of its 95 % confidence interval.
    pub high: f64,
}

/// Least-squares slope of ln e against ln h with its 95 % confidence interval, from three or more rungs with
/// positive finite errors; `None` otherwise.
pub fn fit_power(ladder: &[(f64, f64)]) -> Option<Fit> {
    fit_scattered(ladder, 0.0)
}

/// The same, with an interval for residuals of at least this standard deviation.
fn fit_scattered(ladder: &[(f64, f64)], least: f64) -> Option<Fit> {
    if ladder.len() < 3
        || ladder.iter().any(|(h, e)| !(*h > 0.0 && *e > 0.0 && h.is_finite() && e.is_finite()))
    {
        return None;
    }
    let count = ladder.len() as f64;
    let logs: Vec<(f64, f64)> = ladder.iter().map(|(h, e)| (h.ln(), e.ln())).collect();
    let mean_x = logs.iter().map(|p| p.0).sum::<f64>() / count;
    let mean_y = logs.iter().map(|p| p.1).sum::<f64>() / count;
    let spread: f64 = logs.iter().map(|p| (p.0 - mean_x).powi(2)).sum();
    let slope = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum::<f64>() / spread;
    let residual: f64 = logs.iter().map(|p| (p.1 - mean_y - slope * (p.0 - mean_x)).powi(2)).sum();
    let freedom = ladder.len() - 2;
    let deviation = (residual / freedom as f64).sqrt().max(least);
    let width = student(freedom) * deviation / spread.sqrt();
    Some(Fit { slope, low: slope - width, high: slope + width })
}

/// What a ladder says of its order.
#[derive(Clone, Debug, PartialEq)]
pub enum Ladder {
    /// A window of rungs, as indices into the ladder, with its fit.
    Window {
        /// First and one past the last rung of the window.
        rungs: std::ops::Range<usize>,
        /// The fit over them.
        fit: Fit,
    },
    /// Every rung is at its floor: exact but for rounding.
    Exact,
    /// Fewer than four rungs stand clear of the floor.
    TooFew {
        /// Rungs that do.
        clear: usize,
    },
    /// No three successive slopes agree.
    Unsettled,
    /// An error is NaN or infinite at the finest rungs.
    Broken,
}

/// Finds the asymptotic window of a ladder.
///
/// `ladder` holds (step, error, floor) with the step falling. Rungs whose error is below ten times their floor
/// are dropped, and so are broken (not finite) rungs at the coarse end. The window is a run of three or more
/// successive pairwise slopes that agree to [`SLOPES_AGREE`]; it extends towards coarser steps as long as they
/// agree, up to [`MOST_RUNGS`] rungs. It ends at the finest clear rung: slopes that have settled at coarse steps
/// and change again are no asymptotic range. Only rungs below a hundred times their floor, whose slopes the
/// floor may bend, are passed over. The interval of the slope is that of the scatter in the window, or of all clear rungs where
/// that is larger.
pub fn find_window(ladder: &[(f64, f64, f64)]) -> Ladder {
    if ladder.last().is_none_or(|(_, e, floor)| !(e.is_finite() && floor.is_finite())) {
        return Ladder::Broken;
    }
    let start = ladder.iter().rposition(|(_, e, _)| !e.is_finite()).map_or(0, |i| i + 1);
    let is_clear = |rung: &(f64, f64, f64)| rung.1 > 10.0 * rung.2;
    let sound = &ladder[start..];
    if sound.iter().all(|rung| !is_clear(rung)) {
        return Ladder::Exact;
    }
    let (first_clear, clear) = longest_run(sound, is_clear);
    if clear < FEWEST_SLOPES + 1 {
        return Ladder::TooFew { clear };
    }
    let start = start + first_clear;
    let points: Vec<(f64, f64)> = ladder[start..start + clear].iter().map(|r| (r.0, r.1)).collect();
    let slopes: Vec<f64> =
        points.windows(2).map(|w| (w[0].1 / w[1].1).ln() / (w[0].0 / w[1].0).ln()).collect();
    let sure = points.iter().zip(&ladder[start..]).rposition(|(p, rung)| p.1 >= 100.0 * rung.2).unwrap_or(0);
    for last in (FEWEST_SLOPES.max(sure.min(slopes.len()))..=slopes.len()).rev() {
        let mut first = last;
        let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
        while first > 0 && last - first + 1 < MOST_RUNGS {
            let slope = slopes[first - 1];
            if highest.max(slope) - lowest.min(slope) > SLOPES_AGREE {
                break;
            }
            (lowest, highest) = (lowest.min(slope), highest.max(slope));
            first -= 1;
        }
        if last - first >= FEWEST_SLOPES
            && let Some(fit) = fit_scattered(&points[first..=last], scatter(&points))
        {
            return Ladder::Window { rungs: start + first..start + last + 1, fit };
        }
    }
    Ladder::Unsettled
}

/// Standard deviation of ln e about a power law, from all rungs that stand clear: slopes in a window have been chosen for their
/// agreement, so that what they leave is too small where there is noise. The lower quartile of the differences of successive
/// slopes, each over what a unit of noise makes of it, is not moved by many rungs that are not asymptotic.
fn scatter(points: &[(f64, f64)]) -> f64 {
    let mut changes: Vec<f64> = points
        .windows(3)
        .map(|w| {
            let (a, b) = ((w[0].0 / w[1].0).ln(), (w[1].0 / w[2].0).ln());
            let change = (w[0].1 / w[1].1).ln() / a - (w[1].1 / w[2].1).ln() / b;
            change.abs() / (a.powi(-2) + (1.0 / a + 1.0 / b).powi(2) + b.powi(-2)).sqrt()
        })
        .collect();
    changes.sort_by(f64::total_cmp);
    let Some(last) = changes.len().checked_sub(1) else { return 0.0 };
    let place = 0.25 * last as f64;
    let (below, above) = (changes[place.floor() as usize], changes[place.ceil() as usize]);
    QUARTILE_TO_DEVIATION * (below + (above - below) * place.fract())
}

/// Start and length of the longest run of rungs that stand clear; the finer one of two that are equally long.
fn longest_run<T>(rungs: &[T], is_clear: impl Fn(&T) -> bool) -> (usize, usize) {
    let (mut best, mut run) = ((0, 0), 0);
    for (index, rung) in rungs.iter().enumerate() {
        run = if is_clear(rung) { run + 1 } else { 0 };
        if run >= best.1 {
            best = (index + 1 - run, run);
        }
    }
    best
}

/// Secular rate of a sampled quantity, in its unit over that of time: the difference of two averages over its
/// halves, each weighted by a Hann window, over the time between them. An oscillation of n periods a half
/// leaks into the rate as n⁻³ only.
///
/// `None` with fewer than eight samples.
pub fn secular_rate(time: &[f64], value: &[f64]) -> Option<f64> {
    let half = time.len() / 2;
    if half < 4 || time.len() != value.len() {
        return None;
    }
    let (early, late) = (hann_mean(&time[..half], &value[..half]), hann_mean(&time[half..], &value[half..]));
    Some((late.1 - early.1) / (late.0 - early.0))
}

/// Means of time and value under a Hann window.
fn hann_mean(time: &[f64], value: &[f64]) -> (f64, f64) {
    let count = time.len() as f64;
    let (mut weight_sum, mut time_sum, mut value_sum) = (0.0, 0.0, 0.0);
    for (index, (t, v)) in time.iter().zip(value).enumerate() {
        let weight = (std::f64::consts::PI * (index as f64 + 0.5) / count).sin().powi(2);
        weight_sum += weight;
        time_sum += weight * t;
        value_sum += weight * v;
    }
    (time_sum / weight_sum, value_sum / weight_sum)
}

#[cfg(test)]
mod bounds;

#[cfg(test)]
mod tests {
    use super::*;

    fn ladder(error: impl Fn(f64) -> f64, floor: f64) -> Vec<(f64, f64, f64)> {
        (0..10).map(|k| 0.5f64.powi(k)).map(|h| (h, error(h), floor)).collect()
    }

    #[test]
    fn a_pure_power_gives_its_exponent_with_any_ratio_of_steps() {
        for ratio in [1.1f64, 1.5, 2.0, 10.0] {
            let rungs: Vec<_> = (0..6).map(|k| ratio.powi(-k)).map(|h| (h, 3.0 * h.powf(2.0), 0.0)).collect();
            let Ladder::Window { fit, .. } = find_window(&rungs) else { panic!("no window at {ratio}") };
            assert!((fit.slope - 2.0).abs() < 1e-12 && fit.high - fit.low < 1e-10);
        }
    }

    #[test]
    fn a_first_order_term_hidden_under_a_second_order_one_is_seen_at_fine_steps() {
        let rungs: Vec<_> = (4..20).map(|k| 0.5f64.powi(k)).map(|h| (h, h * h + 0.01 * h, 0.0)).collect();
        let Ladder::Window { fit, .. } = find_window(&rungs) else { panic!("no window") };
        assert!(fit.high < 1.2, "{fit:?}");
    }

    #[test]
    fn rungs_at_the_floor_and_before_the_asymptotic_range_are_left_out() {
        let rungs = ladder(|h| 2.0 * h.powi(4) + 1e-9, 1e-9);
        let Ladder::Window { fit, rungs: used } = find_window(&rungs) else { panic!("no window") };
        assert!((fit.slope - 4.0).abs() < 0.05, "{fit:?}");
        assert!(rungs[used.end - 1].1 > 1e-8);
        let hump = ladder(|h| h * h / (1.0 + (h / 0.05).powi(3)), 0.0);
        let Ladder::Window { fit, rungs: used } = find_window(&hump) else { panic!("no window") };
        assert!((fit.slope - 2.0).abs() < 0.1 && used.start > 3, "{fit:?}");
    }

    #[test]
    fn ladders_that_say_nothing_are_not_given_a_number() {
        assert_eq!(find_window(&ladder(|_| 0.0, 1e-15)), Ladder::Exact);
        assert_eq!(find_window(&ladder(|h| h * h, 3e-3)), Ladder::TooFew { clear: 3 });
        assert_eq!(find_window(&ladder(|_| f64::NAN, 0.0)), Ladder::Broken);
        assert_eq!(find_window(&[]), Ladder::Broken);
        let noise = ladder(|h| if (h.log2() as i64) % 2 == 0 { h } else { h * 3.0 }, 0.0);
        assert_eq!(find_window(&noise), Ladder::Unsettled);
    }

    #[test]
    fn a_secular_rate_is_seen_under_a_thousand_times_larger_oscillation() {
        let time: Vec<f64> = (0..4096).map(|k| f64::from(k) * 0.05).collect();
        let value: Vec<f64> = time.iter().map(|t| 1e-3 * t / 204.8 + (1.7 * t + 0.3).sin()).collect();
        let rate = secular_rate(&time, &value).expect("enough samples");
        assert!((rate / (1e-3 / 204.8) - 1.0).abs() < 0.05, "{rate:e}");
        assert_eq!(secular_rate(&time[..7], &value[..7]), None);
        assert!(secular_rate(&time[..8], &value[..8]).is_some());
        assert_eq!(secular_rate(&time[..16], &value[..15]), None);
    }
}
