//! A motion to many digits, with a bound of its error.

use nalgebra::{Matrix3, Vector3};

use super::double_double::DoubleDouble;
use super::pieces;
use super::problem::{Problem, SHOWN};
use super::taylor::Control;
use crate::model::{PerQuantity, Quantity, Snapshot, System};
use crate::ode::SolverError;
use crate::ode::run;
use crate::rotation;

/// Bound of the error over the largest difference of the two runs so far.
pub const DIFFERENCE: f64 = 4.0;

/// The run, and the one that it is compared with: a little coarser, and of another order.
const CONTROLS: [Control; 2] =
    [Control { order: 38, tolerance: 1e-33 }, Control { order: 36, tolerance: 1e-32 }];

/// Multiply-adds of a run, at five nanoseconds or so each, that a reference may cost.
pub const AFFORDABLE: f64 = 1e8;

/// What the constants of the second run are off by, relative, a power of two: rounding errors of constants are the same
/// in both runs, and what they grow to would else go unseen.
const NUDGE: f64 = DoubleDouble::ROUNDING;

/// Digits that a double-double number has.
pub const MOST_DIGITS: usize = 30;

/// Rounding of a number by the last operations, over its size.
const ROUNDING: f64 = 8.0 * DoubleDouble::ROUNDING;

/// A moment of a motion to many digits. World axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// t [s].
    pub time: f64,
    /// X_cm [m].
    pub position: [DoubleDouble; 3],
    /// U_cm [m/s].
    pub velocity: [DoubleDouble; 3],
    /// R, column by column; takes body axes to world axes.
    pub axes: [[DoubleDouble; 3]; 3],
    /// Ω [rad/s].
    pub angular_velocity: [DoubleDouble; 3],
    /// L about the origin [kg m²/s].
    pub angular_momentum: [DoubleDouble; 3],
    /// Bound of the error of each quantity.
    pub error: PerQuantity<f64>,
}

/// A motion to many digits.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// One for each time.
    pub moments: Vec<Moment>,
    /// Order and number of steps of the run, and of the one that it was compared with.
    pub runs: [(usize, usize); 2],
    /// Contacts with the ground that were made or lost in the run.
    pub switches: usize,
    /// What each quantity of the scene comes to, to a power of two; nothing of a body point.
    scales: PerQuantity<f64>,
}

/// The motion of `system` at increasing `times` [s], given up where a run would take more than `most_work`
/// multiply-adds.
///
/// # Errors
/// [`SolverError::Times`], [`SolverError::NotFinite`], [`SolverError::NoConvergence`],
/// [`SolverError::Interrupted`].
pub fn solve(system: &System, times: &[f64], most_work: f64) -> Result<Motion, SolverError> {
    compared(system, times, most_work, &CONTROLS)
}

fn compared(
    system: &System,
    times: &[f64],
    most_work: f64,
    controls: &[Control; 2],
) -> Result<Motion, SolverError> {
    let last = run::increasing(times)?;
    let problem = |nudge| Problem::of(system, if last > 0.0 { last } else { 1.0 }, nudge);
    let (problem, nudged) = (problem(0.0), problem(NUDGE));
    let fine = pieces::along(&problem, times, &controls[0], most_work)?;
    let coarse = pieces::along(&nudged, times, &controls[1], most_work)?;
    let mut largest = PerQuantity::all(0.0);
    let moments = times
        .iter()
        .zip(fine.states.iter().zip(&coarse.states))
        .map(|(time, (fine, coarse))| {
            let mut moment = moment_of(&problem, *time, fine);
            let other = moment_of(&nudged, *time, coarse);
            largest = apart(system, &moment, &other).max(largest);
            moment.error = bound(system, &moment, &largest);
            moment
        })
        .collect();
    let runs = [(controls[0].order, fine.steps), (controls[1].order, coarse.steps)];
    let momentum = problem.scale.momentum * problem.scale.unit([1, 2, -1]);
    let moment = system.body.moments.amax();
    let scales = PerQuantity::of(|quantity| match quantity {
        Quantity::Position => system.body.extent(),
        Quantity::Velocity => problem.scale.speed * problem.scale.unit([0, 1, -1]),
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => {
            if moment > 0.0 {
                momentum / moment
            } else {
                0.0
            }
        }
        Quantity::AngularMomentum => momentum,
        Quantity::BodyPoint => 0.0,
    });
    Ok(Motion { moments, runs, switches: fine.switches, scales })
}

fn moment_of(problem: &Problem, time: f64, state: &[DoubleDouble]) -> Moment {
    let shown = problem.shown.values(state);
    debug_assert_eq!(shown.len(), SHOWN);
    let triple = |first: usize, dimension: [i32; 3]| {
        let unit = problem.scale.unit(dimension);
        [0, 1, 2].map(|i| shown[first + i].scaled(unit))
    };
    Moment {
        time,
        position: triple(0, [0, 1, 0]),
        velocity: triple(3, [0, 1, -1]),
        axes: [6, 9, 12].map(|first| triple(first, [0, 0, 0])),
        angular_velocity: triple(15, [0, 0, -1]),
        angular_momentum: triple(18, [1, 2, -1]),
        error: PerQuantity::all(0.0),
    }
}

fn bound(system: &System, moment: &Moment, largest: &PerQuantity<f64>) -> PerQuantity<f64> {
    let size = |v: &[DoubleDouble; 3]| v.iter().map(|x| x.high.abs()).fold(0.0, f64::max);
    let position = size(&moment.position);
    let sizes = PerQuantity::of(|quantity| match quantity {
        Quantity::Position => position,
        Quantity::Velocity => size(&moment.velocity),
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => size(&moment.angular_velocity),
        Quantity::AngularMomentum => size(&moment.angular_momentum),
        Quantity::BodyPoint => position + system.body.extent(),
    });
    largest.zip(sizes).map(|(largest, size)| DIFFERENCE * largest + ROUNDING * size)
}

/// The difference of two moments, quantity by quantity; of orientations, that of the matrices as an angle.
fn apart(system: &System, a: &Moment, b: &Moment) -> PerQuantity<f64> {
    let vector = |a: &[DoubleDouble; 3], b: &[DoubleDouble; 3]| {
        Vector3::from(std::array::from_fn::<f64, 3, _>(|i| (a[i] - b[i]).high))
    };
    let columns: [Vector3<f64>; 3] = std::array::from_fn(|i| vector(&a.axes[i], &b.axes[i]));
    let turn = Matrix3::from_columns(&columns);
    let shift = vector(&a.position, &b.position);
    let body = &system.body;
    let farthest = body.points.iter().map(|p| p.position - body.center);
    let point =
        farthest.map(|x| rotation::length(&(shift + turn * x))).fold(rotation::length(&shift), f64::max);
    let size = |a, b| rotation::length(&vector(a, b));
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position => rotation::length(&shift),
        Quantity::Velocity => size(&a.velocity, &b.velocity),
        // |R − R'|_F = 2 √2 sin(θ/2).
        Quantity::Orientation => turn.norm() / 2f64.sqrt(),
        Quantity::AngularVelocity => size(&a.angular_velocity, &b.angular_velocity),
        Quantity::AngularMomentum => size(&a.angular_momentum, &b.angular_momentum),
        Quantity::BodyPoint if body.points.is_empty() => {
            rotation::length(&shift) + turn.norm() * body.extent()
        }
        Quantity::BodyPoint => point,
    })
}

impl Motion {
    /// Digits that every quantity has of the largest that it has been, or of what it comes to in such a scene, before its error bound reaches half a unit in the last
    /// one; a quantity that is nothing but rounding of others has none of its own, and is left out.
    pub fn certain_digits(&self, system: &System) -> usize {
        let size = |v: &[DoubleDouble; 3]| v.iter().map(|x| x.high * x.high).sum::<f64>().sqrt();
        let extent = system.body.extent();
        // A body that comes to rest keeps the error, but not the size.
        let mut sizes = self.scales;
        let ratios = self.moments.iter().flat_map(|moment| {
            let now = PerQuantity::of(|quantity| match quantity {
                Quantity::Position => size(&moment.position).max(extent),
                Quantity::Velocity => size(&moment.velocity).max(extent * size(&moment.angular_velocity)),
                Quantity::Orientation => 1.0,
                Quantity::AngularVelocity => size(&moment.angular_velocity),
                Quantity::AngularMomentum => size(&moment.angular_momentum),
                // It is made of position and orientation.
                Quantity::BodyPoint => 0.0,
            });
            sizes = now.max(sizes);
            sizes.zip(moment.error).into_iter().map(|(_, pair)| pair)
        });
        let worst =
            ratios.filter(|(size, _)| *size > 0.0).map(|(size, error)| error / size).fold(0.0, f64::max);
        if worst == 0.0 { MOST_DIGITS } else { (-(2.0 * worst).log10()).floor().max(0.0) as usize }
            .min(MOST_DIGITS)
    }
}

impl Moment {
    /// Bound of the error of a quantity.
    pub fn bound(&self, quantity: Quantity) -> f64 {
        self.error[quantity]
    }

    /// The same, rounded to f64.
    pub fn snapshot(&self) -> Snapshot {
        let rounded = |v: &[DoubleDouble; 3]| Vector3::new(v[0].to_f64(), v[1].to_f64(), v[2].to_f64());
        let axes = Matrix3::from_columns(&self.axes.each_ref().map(rounded));
        Snapshot {
            time: self.time,
            position: rounded(&self.position),
            velocity: rounded(&self.velocity),
            orientation: rotation::from_matrix(&axes),
            angular_velocity: rounded(&self.angular_velocity),
            angular_momentum: rounded(&self.angular_momentum),
            stretch: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::scale::Scale;
    use super::super::taylor;
    use super::*;
    use crate::model::Spin;
    use crate::model::body::{Body, MassPoint};
    use crate::model::forces::{Forces, Gravity, Ground, Law};
    use crate::rotation::Rotation;

    /// An uneven body dropped on a ground at this height [m], which it touches again and again or never.
    fn dropped(height: f64) -> System {
        let point = |mass, x, y, z| MassPoint { mass, position: Vector3::new(x, y, z) };
        let points = [
            point(0.25, 0.125, 0.0, -0.0625),
            point(0.125, -0.125, 0.0625, -0.0625),
            point(0.25, 0.0, -0.125, 0.0),
            point(0.375, -0.03125, 0.03125, 0.125),
        ];
        let normal = Vector3::z();
        let ground =
            Ground { normal, height, stiffness: 1500.0, damping: 2.0, friction: 0.25, slip_velocity: 0.125 };
        let gravity = Gravity { acceleration: Vector3::new(0.0, 0.0, -9.75) };
        let body = Body::from_points(&points, None).expect("a body").0;
        let laws = vec![Law::Gravity(gravity), Law::Ground(ground)];
        let (start, spin) = (Vector3::new(0.0, 0.0, 0.75), Spin::Velocity(Vector3::new(1.0, 3.0, -2.0)));
        System::new(body, laws, start, Rotation::identity(), Vector3::zeros(), spin).expect("a system")
    }

    #[test]
    fn a_body_whose_terms_overflow_is_refused_and_does_not_run_on() {
        let mut system = dropped(0.0);
        let mut points = system.body.points.clone();
        points[2].mass = 1e150;
        system.body = Body::from_points(&points, None).expect("a body").0;
        assert!(matches!(solve(&system, &[2.0], AFFORDABLE), Err(SolverError::NotFinite { .. })));
    }

    #[test]
    fn other_orders_and_steps_agree_within_both_bounds_across_contacts_too() {
        let others = [Control { order: 30, tolerance: 1e-32 }, Control { order: 44, tolerance: 1e-33 }];
        let times: Vec<f64> = (1..=16).map(|j| f64::from(j) / 8.0).collect();
        for height in [0.0, -1e3] {
            let system = dropped(height);
            let usual = solve(&system, &times, AFFORDABLE).expect("a motion");
            let other = compared(&system, &times, AFFORDABLE, &others).expect("a motion");
            assert_eq!(usual.switches, other.switches);
            assert_eq!(usual.switches > 4, height == 0.0, "{}", usual.switches);
            assert_ne!(usual.runs, other.runs);
            for (a, b) in usual.moments.iter().zip(&other.moments) {
                let apart = apart(&system, a, b);
                for (quantity, apart) in apart {
                    let bound = a.error[quantity] + b.error[quantity];
                    assert!(apart <= bound, "{height}, {} s, {quantity:?}: {apart:e}", a.time);
                }
            }
        }
    }

    /// The quaternion of a body without forces at 1 s, in units whose second is so many of the scene's own.
    fn turned(second: f64) -> Vec<f64> {
        let system = System { forces: Forces::default(), ..dropped(0.0) };
        let own = Scale::of(&system, 1.0);
        let (time, speed, momentum) = (own.time * second, own.speed * second, own.momentum * second);
        let problem = Problem::in_units(&system, Scale { time, speed, momentum, ..own }, 0.0);
        let course = taylor::along(&problem, 0.0, &[1.0], &CONTROLS[0], AFFORDABLE).expect("a run");
        let first = problem.quaternion.expect("it turns");
        course.states[0][first..first + 4].iter().map(|x| x.to_f64()).collect()
    }

    #[test]
    fn a_series_whose_last_terms_leave_the_range_of_f64_goes_no_further_than_it_may() {
        let expected = turned(1.0);
        // 2^-30 to the 38th power is 1e-343.
        for second in [0.5f64.powi(20), 0.5f64.powi(30), 0.5f64.powi(40)] {
            assert_eq!(turned(second), expected, "{second}");
        }
    }
}
