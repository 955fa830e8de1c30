//! The sleeping top: spin × step around Ω² = 4 M g l I₁/I₃².

use nalgebra::Vector3;

use super::{Grid, linear, logarithmic};
use crate::model::{Snapshot, Spin, System};
use crate::record::stability::{Map, MapCurve};
use crate::rotation::Rotation;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Plan};
use crate::study::ensemble::{Ensemble, Member};
use crate::study::stability::theory;

/// Scene that lends its top.
const SCENE: &str = "sleeping-top";
/// Tilt at the start [rad].
const TILT: f64 = 1e-3;
/// Duration of a run [s].
const DURATION: f64 = 0.5;
/// Growth of the tilt, log₁₀, that counts as fallen; where it begins to, and where the map ends.
const FALLEN: f64 = 1.0;

/// Largest tilt of the body's z axis from the vertical, by its sine.
struct Tilt(f64);

impl Tilt {
    fn see(&mut self, state: &Snapshot) {
        let axis = state.orientation * Vector3::z();
        let tilt = axis.x.hypot(axis.y).atan2(axis.z);
        if tilt.is_nan() || tilt > self.0 {
            self.0 = tilt;
        }
    }
}

pub(super) fn map(contestant: &Contestant, cells: usize) -> Option<Map> {
    let scene = Scene::find(SCENE).ok()?;
    let body = scene.system.body.clone();
    let gravity = 9.81;
    let critical = theory::sleeping_spin(
        body.mass * gravity * body.center.norm(),
        body.inertia[(0, 0)],
        body.inertia[(2, 2)],
    );
    let tilted = Rotation::from_scaled_axis(Vector3::x() * TILT);
    let system = |spin: f64| {
        let laws = scene.system.forces.laws().to_vec();
        let position = tilted * body.center;
        let spin = Spin::Velocity(tilted * Vector3::new(0.0, 0.0, spin));
        System::new(body.clone(), laws, position, tilted, Vector3::zeros(), spin).ok()
    };
    contestant.refusal(&scene.system).is_none().then_some(())?;
    let x = linear("spin / critical spin", "1", 0.3, 2.0);
    let y = logarithmic("step h", "s", 2e-4, 2e-2);
    let mut map = Grid { x, y, cells }.fill(|step, spins| {
        let steps = (DURATION / step).ceil() as u64;
        let plan = Plan { step, steps, every: (steps / 64).max(1) };
        let members =
            spins.iter().filter_map(|spin| Some(Member { system: system(spin * critical)?, plan })).collect();
        let ends = Ensemble::new(contestant, members).fold(|_| Tilt(0.0), Tilt::see);
        let taken = ends.iter().map(|end| end.1.steps).sum();
        let value = |tilt: f64| (tilt / TILT).log10().clamp(0.0, 3.5);
        (ends.iter().map(|(tilt, _)| Some(value(tilt.0))).collect(), taken)
    });
    map.title = "Sleeping top: spin and step".to_owned();
    map.what = format!(
        "log₁₀ of the growth of a tilt of {TILT} rad within {DURATION} s; critical spin {critical:.2} rad/s"
    );
    map.edge = Some(FALLEN);
    map.curves =
        vec![MapCurve {
            name: "Ω² = 4 M g l I₁/I₃²".to_owned(), x: vec![1.0, 1.0], y: vec![2e-4, 2e-2]
        }];
    Some(map)
}
