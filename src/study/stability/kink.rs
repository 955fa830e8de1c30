//! The order of a scheme across a bounce: a ground that is touched and left is a force with a kink, or with a jump where the
//! ground has a damper, and no scheme keeps its order across either.
//!
//! A body is dropped from many heights, so that the moment of touching falls anywhere within a step. The order between halvings
//! of h is log₂ of |x(h) − x(h/2)| / |x(h/2) − x(h/4)|, x the place of the centre of mass after one bounce, and its median is what is
//! told.

use nalgebra::Vector3;

use crate::model::forces::{Gravity, Ground, Law};
use crate::model::{Spin, System};
use crate::record::stability::KinkOrder;
use crate::rotation::Rotation;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Plan};
use crate::study::ensemble::{Ensemble, Member};

/// Scene that lends its body.
const SCENE: &str = "bouncing-body";
/// Drops.
const DROPS: usize = 64;
/// Duration of a drop with one bounce [s].
pub(super) const DURATION: f64 = 0.5;
/// Spin of the dropped body [rad/s].
const SPIN: Vector3<f64> = Vector3::new(1.0, 3.0, -2.0);
/// Steps of the coarsest of three runs.
const STEPS: u64 = 512;

/// The body of the bouncing scene, dropped from a height of its centre [m] with this spin [rad/s] on a ground of this stiffness [N/m]
/// and damping [N s/m].
pub(super) fn drop_from(height: f64, spin: Vector3<f64>, stiffness: f64, damping: f64) -> Option<System> {
    let scene = Scene::find(SCENE).ok()?;
    let laws = vec![
        Law::Gravity(Gravity { acceleration: Vector3::new(0.0, 0.0, -9.81) }),
        Law::Ground(Ground {
            normal: Vector3::z(),
            height: 0.0,
            stiffness,
            damping,
            friction: 0.0,
            slip_velocity: 1.0,
        }),
    ];
    let spin = Spin::Velocity(spin);
    let position = Vector3::new(0.0, 0.0, height);
    System::new(scene.system.body, laws, position, Rotation::identity(), Vector3::zeros(), spin).ok()
}

/// Height of the centre over the lowest point of that body, as it is dropped [m].
pub(super) fn clearance() -> Option<f64> {
    let body = Scene::find(SCENE).ok()?.system.body;
    Some(-body.points.iter().map(|point| point.position.z).fold(f64::INFINITY, f64::min))
}

/// Orders of a scheme across a bounce for many systems, from so many coarsest steps of this length [s]; `None` where a run broke or
/// a difference vanished. Second: the steps that were taken.
pub(super) fn orders(
    contestant: &Contestant,
    systems: &[System],
    step: f64,
    steps: u64,
) -> (Vec<Option<f64>>, u64) {
    let members = systems.iter().flat_map(|system| {
        [1, 2, 4].map(|times| {
            let plan = Plan { step: step / times as f64, steps: steps * times, every: steps * times };
            Member { system: system.clone(), plan }
        })
    });
    let ensemble = Ensemble::new(contestant, members.collect());
    let ends = ensemble.fold(|_| Vector3::zeros(), |end, state| *end = state.position);
    let taken = ends.iter().map(|(_, outcome)| outcome.steps).sum();
    let order = |runs: &[(Vector3<f64>, crate::simulate::Outcome)]| {
        if runs.iter().any(|(_, outcome)| outcome.broken.is_some()) {
            return None;
        }
        let (first, second) = ((runs[0].0 - runs[1].0).norm(), (runs[1].0 - runs[2].0).norm());
        (first > 0.0 && second > 0.0).then(|| (first / second).log2())
    };
    (ends.chunks_exact(3).map(order).collect(), taken)
}

/// The order of a scheme across a bounce.
pub fn kink_order(contestant: &Contestant) -> KinkOrder {
    KinkOrder {
        scheme: contestant.card.name.to_owned(),
        claimed: contestant.card.order(),
        elastic: median_order(contestant, 0.0),
        damped: median_order(contestant, 4.0),
    }
}

fn median_order(contestant: &Contestant, damping: f64) -> Option<f64> {
    let height = |n: usize| 0.4 + 0.05 * n as f64 / DROPS as f64;
    let systems: Vec<System> =
        (0..DROPS).filter_map(|n| drop_from(height(n), SPIN, 2000.0, damping)).collect();
    if systems.iter().any(|system| contestant.refusal(system).is_some()) {
        return None;
    }
    let (orders, _) = orders(contestant, &systems, DURATION / STEPS as f64, STEPS);
    median(orders.into_iter().flatten().collect())
}

/// The middle one of these numbers.
pub(super) fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}
