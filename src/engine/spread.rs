//! Rounding of a program under test: the digits of its numbers, and how far copies of a run end from it.
//!
//! A copy starts a few units in the last place off, its mass points too. The unit is that of the program: of a double, of
//! a single, or of the last digit that it prints. What the copies differ by is rounding, however it grows.

use super::reply::States;
use super::subject::{NoStates, Subject};
use crate::model::copies::{CLEAR, COPIES, OFF, displaced};
use crate::model::{PerQuantity, Snapshot, System, difference, sizes};
use crate::simulate::Plan;

/// Numbers of so many significant digits are doubles to the last bit or nearly so.
const DOUBLE_DIGITS: usize = 16;

/// How fine the numbers of a program are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grain {
    /// Unit in the last place of the arithmetic or of the printed digits, relative.
    unit: f64,
    /// The last decimal place that is printed, in the unit of each number; 0 where it is finer than `unit`.
    place: f64,
}

impl Grain {
    /// The grain of a double.
    pub const DOUBLE: Grain = Grain { unit: f64::EPSILON, place: 0.0 };

    /// The grain that a run shows.
    pub fn of(subject: &Subject, states: &States) -> Grain {
        let single = subject.single_precision() || states.precision.is_single();
        let digits = states.precision.digits();
        let few = digits > 0 && digits < DOUBLE_DIGITS;
        let unit = match (single, few) {
            (true, _) => f64::from(f32::EPSILON),
            (false, true) => 10f64.powi(1 - digits as i32),
            (false, false) => f64::EPSILON,
        };
        let place = if few { last_place(&states.states) } else { 0.0 };
        Grain { unit, place }
    }

    /// Sizes of quantities in units in the last place, so many times.
    pub fn times(&self, count: f64, sizes: &PerQuantity<f64>) -> PerQuantity<f64> {
        sizes.map(|size| count * (self.unit * size + self.place))
    }
}

/// The finest decimal place of all positions, velocities and angular velocities of a run.
fn last_place(states: &[Snapshot]) -> f64 {
    let numbers = states
        .iter()
        .flat_map(|s| [s.position, s.velocity, s.angular_velocity])
        .flat_map(|v| [v.x, v.y, v.z]);
    let places = numbers.filter(|number| *number != 0.0).filter_map(|number| {
        let text = format!("{number:e}");
        let (mantissa, exponent) = text.split_once('e')?;
        let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        Some(exponent.parse::<i32>().ok()? - decimals as i32)
    });
    places.min().map_or(0.0, |place| 10f64.powi(place))
}

/// How far rounding may take the end of a run, each quantity in its unit: the larger of [`CLEAR`] times the distance of
/// the copies and a unit in the last place for each step.
///
/// # Errors
/// [`NoStates`]: a copy gives no states.
pub(super) fn allowance(
    subject: &mut Subject,
    (system, grain): (&System, &Grain),
    plan: &Plan,
    own: &[Snapshot],
) -> Result<PerQuantity<f64>, NoStates> {
    let sizes = sizes(system, own);
    let mut spread = PerQuantity::all(0.0);
    for way in 0..COPIES {
        let copy = subject.run(&displaced(system, &grain.times(OFF, &sizes), way, true), plan)?.states;
        if let (Some(copy), Some(own)) = (copy.last(), own.last()) {
            spread = difference(&system.body, copy, own).max(spread);
        }
    }
    let floor = grain.times(CLEAR.max(plan.steps as f64), &sizes);
    Ok(spread.map(|spread| CLEAR * spread).max(floor))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::engine::specimen::scene;
    use crate::rotation;

    #[test]
    fn the_last_place_is_that_of_the_finest_number() {
        let free = scene("", "");
        let mut state = crate::ode::dop853::solve(&free, &[0.5], 1e-12).expect("a solution").states[0];
        assert!(last_place(&[state]) < 1e-14);
        state.position = Vector3::new(1.25, -100.5, 0.0);
        state.velocity = Vector3::new(3.0, 20.0, 0.001);
        state.angular_velocity = Vector3::zeros();
        assert_eq!(last_place(&[state]), 1e-3);
        assert_eq!(last_place(&[]), 0.0);
    }

    #[test]
    fn a_displaced_start_is_off_by_what_was_asked_for() {
        let free = scene("", "");
        let moved = displaced(&free, &PerQuantity::all(1e-6), 1, true);
        let off = rotation::length(&(moved.start.position - free.start.position));
        assert!((off - 1e-6).abs() < 1e-12, "{off}");
        let turned = rotation::angle_between(&moved.start.orientation, &free.start.orientation);
        assert!((turned - 1e-6).abs() < 1e-12, "{turned}");
    }
}
