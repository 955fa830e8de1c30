//! Stiff drag: every point of a body of equal masses has the same drag, so that translation and rotation both die at c/m.

use nalgebra::Vector3;

use super::grid::{curve, edge_off};
use super::{Grid, logarithmic};
use crate::model::body::{Body, MassPoint};
use crate::model::forces::{Drag, Law, PerPoint};
use crate::model::{Snapshot, Spin, System};
use crate::record::stability::Map;
use crate::rotation::Rotation;
use crate::simulate::{Contestant, Plan};
use crate::study::ensemble::{Ensemble, Member};
use crate::study::stability::bench::Amplitude;
use crate::study::stability::theory::Mode;
use crate::study::stability::{Growth, NO_GROWTH};

/// Steps of a cell.
const STEPS: u64 = 400;

fn dragged(rate: f64) -> Option<System> {
    let at = |x, y, z| MassPoint { mass: 1.0, position: Vector3::new(x, y, z) };
    let points = [at(1.0, 0.0, 0.0), at(-0.5, 0.75, 0.0), at(0.0, -0.5, 0.5), at(-0.25, 0.0, -1.0)];
    let (body, center) = Body::from_points(&points, None).ok()?;
    let laws = vec![Law::Drag(Drag { coefficient: PerPoint::Same(rate) })];
    // So slow that the gyroscopic terms are nothing to the drag, however weak.
    let spin = Spin::Velocity(Vector3::new(1e-6, 2e-6, -1e-6));
    System::new(body, laws, center, Rotation::identity(), Vector3::new(1e-6, 0.0, 2e-6), spin).ok()
}

fn energy(system: &System, state: &Snapshot) -> f64 {
    system.kinetic_energy(state)
}

pub(super) fn map(contestant: &Contestant, cells: usize) -> Option<Map> {
    contestant.refusal(&dragged(1.0)?).is_none().then_some(())?;
    let x = logarithmic("step h", "s", 1e-4, 1.0);
    let y = logarithmic("drag c/m", "1/s", 1.0, 1e4);
    let mut map = Grid { x, y, cells }.fill(|rate, steps| {
        let plan = |step: &f64| Plan { step: *step, steps: STEPS, every: 1 };
        let Some(system) = dragged(rate) else { return (vec![None; steps.len()], 0) };
        let members = steps.iter().map(|step| Member { system: system.clone(), plan: plan(step) }).collect();
        let begin = |index: usize| Amplitude::new(steps[index] * STEPS as f64);
        let see =
            |amplitude: &mut Amplitude, state: &Snapshot| amplitude.push(state.time, energy(&system, state));
        let ends = Ensemble::new(contestant, members).fold(begin, see);
        let taken = ends.iter().map(|end| end.1.steps).sum();
        let value = |growth| match growth {
            Growth::Rate(rate) => rate.clamp(-0.5, 0.5),
            Growth::Broke(_) => 0.5,
        };
        (ends.iter().map(|(amplitude, end)| Some(value(amplitude.growth(STEPS, end)))).collect(), taken)
    });
    map.title = "Stiff drag: step and drag".to_owned();
    map.what = "logarithmic growth a step of the speed; every point has the drag c".to_owned();
    map.edge = Some(0.0);
    if let Some((limit, _)) = Mode::Decay.limit(contestant, 1e-9) {
        map.edge_off_theory = edge_off(&map, NO_GROWTH, |rate| Some(limit / rate));
        map.curves.push(curve(&format!("h c/m = {limit:.3}"), &map, |rate| Some(limit / rate)));
    }
    Some(map)
}
