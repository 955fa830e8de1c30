//! How the cost of a step grows with the mass points of the body.

use nalgebra::Vector3;

use crate::interrupt;
use crate::model::body::{Body, MassPoint};
use crate::model::forces::{Drag, Law, PerPoint};
use crate::model::{Spin, System};
use crate::record::{Grows, Records, ScalingRow};
use crate::rotation::Rotation;
use crate::simulate::{Contestant, Form};
use crate::study::cost::{self, Course};

/// Time that each size is timed for [s].
const SECONDS: f64 = 0.02;
/// h [s]: the bodies turn about a rad/s.
const STEP: f64 = 0.01;
/// Most mass points, and of a full report: there a run holds some hundred megabytes.
const MOST_POINTS: usize = 100_000;
const MOST_POINTS_IN_FULL: usize = 1_000_000;
/// The sizes that costs are measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sizes {
    /// Up to 100,000 mass points.
    Usual,
    /// Up to 1,000,000 mass points.
    Full,
}

/// Measures how cost grows and puts it into the records. To be called while nothing else runs.
pub(super) fn add_scaling(records: &mut Records, sizes: Sizes) {
    let most = match sizes {
        Sizes::Usual => MOST_POINTS,
        Sizes::Full => MOST_POINTS_IN_FULL,
    };
    if let Some(first) = Contestant::main().first() {
        records.scaling.extend(with_points(first, most));
    }
}

/// A helix of equal mass points: no two moments equal, nothing aligned. One point alone does not turn, two are a rod.
fn cloud(count: usize, drag: bool) -> Option<System> {
    let point = |k: usize| {
        let angle = 0.7 * k as f64;
        let height = 2.0 * k as f64 / count as f64;
        MassPoint { mass: 1.0 / count as f64, position: Vector3::new(angle.cos(), 0.5 * angle.sin(), height) }
    };
    let points: Vec<MassPoint> = (0..count).map(point).collect();
    let (body, center) = Body::from_points(&points, None).ok()?;
    let laws = if drag {
        vec![Law::Drag(Drag { coefficient: PerPoint::Same(0.1 / count as f64) })]
    } else {
        Vec::new()
    };
    let spin = Spin::Velocity(Vector3::new(0.3, -0.5, 0.8));
    System::new(body, laws, center, Rotation::identity(), Vector3::zeros(), spin).ok()
}

/// Cost of a step against the number of mass points: free and under drag on every point, as points and reduced.
fn with_points(contestant: &Contestant, most: usize) -> Vec<ScalingRow> {
    let mut rows = Vec::new();
    let mut count = 1;
    while count <= most && !interrupt::requested() {
        for (drag, load) in [(false, "free"), (true, "drag")] {
            let Some(system) = cloud(count, drag) else { continue };
            let course = |form| Course { contestant, system: &system, form, step: STEP, seconds: SECONDS };
            let costs = cost::measure(&[course(Form::Points), course(Form::Least)]);
            for (form, cost) in ["points", "reduced"].into_iter().zip(costs) {
                rows.extend(cost.map(|cost| ScalingRow {
                    what: Grows::Points,
                    scheme: contestant.card.name.to_owned(),
                    form: format!("{form}, {load}"),
                    threads: 1,
                    size: count as u64,
                    value: cost.nanoseconds_per_step,
                    unit: "ns/step".to_owned(),
                }));
            }
        }
        count = if count < 4 { count * 2 } else { next(count) };
    }
    rows
}

/// The next size: about √10 times as many, so that powers of ten are among them.
fn next(count: usize) -> usize {
    let power = 10usize.pow((count as f64).log10().floor() as u32);
    if count < 3 * power { 3 * power } else { 10 * power }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_one_and_three_times_the_powers_of_ten() {
        assert_eq!([4, 10, 30, 100].map(next), [10, 30, 100, 300]);
    }

    #[test]
    fn bodies_of_every_size_are_bodies() {
        for count in [1, 2, 4, 10, 30] {
            for drag in [false, true] {
                assert_eq!(cloud(count, drag).expect("a system").body.points.len(), count);
            }
        }
    }
}
