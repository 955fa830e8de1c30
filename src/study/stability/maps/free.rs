//! The free body: how large a step it bears, over every shape that masses can have, and what becomes of its spin up to a whole
//! turn a step.

use nalgebra::{Matrix3, Vector3};

use super::{Grid, linear};
use crate::model::body::Body;
use crate::model::{Snapshot, Spin, System};
use crate::record::stability::{Map, MapCurve};
use crate::rotation::Rotation;
use crate::simulate::{Contestant, Outcome, Plan};
use crate::study::ensemble::{Ensemble, Member};
use crate::study::stability::{ENERGY_KEPT, Failure};

/// Steps of a run.
const STEPS: u64 = 200;
/// Steps of a run that is classed.
const CLASSED_STEPS: u64 = 400;
/// Radians a step that are tried, from small to large: a step below an edge must have been tried and found good.
const TURNS: usize = 20;
const SMALLEST: f64 = 0.04;
/// Bisections of the interval in which the edge was found.
const BISECTIONS: usize = 4;

/// A free body of these moments [kg m²], turning at 1 rad/s about this axis.
pub(super) fn spinning(moments: Vector3<f64>, axis: Vector3<f64>) -> Option<System> {
    let body = Body::from_inertia(1.0, Matrix3::from_diagonal(&moments), None, false).ok()?;
    let spin = Spin::Velocity(axis.normalize());
    System::new(body, vec![], Vector3::zeros(), Rotation::identity(), Vector3::zeros(), spin).ok()
}

/// Off every axis and every plane of symmetry.
fn generic() -> Vector3<f64> {
    Vector3::new(1.0, 0.8, 0.6)
}

/// What is kept of a run: energies, and where L points in body axes.
#[derive(Clone, Copy)]
pub(super) struct Kept {
    first: f64,
    pub last: f64,
    pub largest_change: f64,
    settled: Vector3<f64>,
    end: f64,
}

impl Kept {
    pub(super) fn new(end: f64) -> Kept {
        Kept { first: 0.0, last: 0.0, largest_change: 0.0, settled: Vector3::repeat(1.0), end }
    }

    pub(super) fn see(&mut self, state: &Snapshot) {
        let energy = 0.5 * state.angular_velocity.dot(&state.angular_momentum);
        if state.time == 0.0 {
            self.first = energy;
        }
        self.last = energy / self.first - 1.0;
        // Not f64::max, which would hide a NaN.
        if self.last.is_nan() || self.last.abs() > self.largest_change {
            self.largest_change = self.last.abs();
        }
        if state.time >= 0.75 * self.end {
            let momentum = state.orientation.inverse_transform_vector(&state.angular_momentum);
            self.settled = self.settled.inf(&(momentum.abs() / momentum.norm()));
        }
    }
}

/// Runs members of one step each [s] and hands over what was kept.
pub(super) fn run(contestant: &Contestant, members: Vec<(System, f64)>, steps: u64) -> Vec<(Kept, Outcome)> {
    let ends: Vec<f64> = members.iter().map(|(_, step)| step * steps as f64).collect();
    let plan = |step| Plan { step, steps, every: 1 };
    let members = members.into_iter().map(|(system, step)| Member { system, plan: plan(step) }).collect();
    Ensemble::new(contestant, members).fold(|index| Kept::new(ends[index]), Kept::see)
}

fn is_kept((kept, outcome): &(Kept, Outcome)) -> bool {
    outcome.broken.is_none() && kept.largest_change <= ENERGY_KEPT
}

/// The largest |Ω|h with the energy within 1 % over 200 steps, for every shape: moments over the largest.
pub(super) fn shapes(contestant: &Contestant, cells: usize) -> Option<Map> {
    contestant.refusal(&spinning(Vector3::new(0.5, 0.75, 1.0), generic())?).is_none().then_some(())?;
    let x = linear("smallest moment / largest", "1", 0.0, 1.0);
    let y = linear("middle moment / largest", "1", 0.5, 1.0);
    let mut map = Grid { x, y, cells }.fill(|middle, smallest| {
        let systems: Vec<Option<System>> = smallest
            .iter()
            .map(|small| {
                let physical = *small <= middle && small + middle >= 1.0;
                physical.then(|| spinning(Vector3::new(*small, middle, 1.0), generic())).flatten()
            })
            .collect();
        row_of_limits(contestant, &systems)
    });
    map.title = "Free body: the largest step that keeps the energy".to_owned();
    map.what = format!(
        "largest |Ω|h with the energy within 1 % over {STEPS} steps, every smaller one tried included"
    );
    map.unit = "rad".to_owned();
    map.curves = vec![
        MapCurve { name: "flat bodies".to_owned(), x: vec![0.0, 0.5], y: vec![1.0, 0.5] },
        MapCurve { name: "oblate bodies".to_owned(), x: vec![0.5, 1.0], y: vec![0.5, 1.0] },
    ];
    Some(map)
}

fn row_of_limits(contestant: &Contestant, systems: &[Option<System>]) -> (Vec<Option<f64>>, u64) {
    let largest = std::f64::consts::TAU;
    let ratio = (largest / SMALLEST).powf(1.0 / (TURNS - 1) as f64);
    let mut taken = 0;
    // Of each cell: the largest good turn so far, and the smallest bad one.
    let mut edges: Vec<Option<(f64, Option<f64>)>> =
        systems.iter().map(|system| system.as_ref().map(|_| (0.0, None))).collect();
    let mut try_at = |edges: &mut Vec<Option<(f64, Option<f64>)>>,
                      next: &dyn Fn(f64, Option<f64>) -> Option<f64>| {
        let asked: Vec<(usize, f64)> = edges
            .iter()
            .enumerate()
            .filter_map(|(index, edge)| {
                edge.and_then(|(good, bad)| next(good, bad)).map(|turn| (index, turn))
            })
            .collect();
        let members =
            asked.iter().filter_map(|(index, turn)| Some((systems[*index].clone()?, *turn))).collect();
        for ((index, turn), end) in asked.iter().zip(run(contestant, members, STEPS)) {
            taken += end.1.steps;
            let Some((good, bad)) = &mut edges[*index] else { continue };
            if is_kept(&end) { *good = *turn } else { *bad = Some(*turn) }
        }
    };
    for rung in 0..TURNS {
        let turn = SMALLEST * ratio.powi(rung as i32);
        try_at(&mut edges, &|_, bad| bad.is_none().then_some(turn));
    }
    for _ in 0..BISECTIONS {
        try_at(&mut edges, &|good, bad| Some((good.max(SMALLEST / 4.0) * bad?).sqrt()));
    }
    (edges.into_iter().map(|edge| edge.map(|(good, _)| good)).collect(), taken)
}

/// What becomes of a free body's spin: classes over |Ω|h up to a whole turn a step and over shapes from a rod's neighbour to a
/// sphere.
pub(super) fn spin_step(contestant: &Contestant, cells: usize) -> Option<Map> {
    let shape = |small: f64| Vector3::new(small, (1.0 + small) / 2.0, 1.0);
    contestant.refusal(&spinning(shape(0.5), generic())?).is_none().then_some(())?;
    let x = linear("step |Ω|h", "rad", 0.0, std::f64::consts::TAU);
    let y = linear("smallest moment / largest, the third halfway", "1", 1.0 / 3.0, 1.0);
    let mut map = Grid { x, y, cells }.fill(|small, turns| {
        let members: Vec<_> =
            turns.iter().filter_map(|turn| Some((spinning(shape(small), generic())?, *turn))).collect();
        let ends = run(contestant, members, CLASSED_STEPS);
        let taken = ends.iter().map(|end| end.1.steps).sum();
        (ends.iter().map(|end| Some(class(end) as f64)).collect(), taken)
    });
    map.title = "Free body: what becomes of its spin".to_owned();
    map.what = format!("class after {CLASSED_STEPS} steps; none: energy within 1 %");
    map.classes = Failure::CLASSES.iter().map(|class| (*class).to_owned()).collect();
    let half = std::f64::consts::PI;
    map.curves =
        vec![MapCurve { name: "|Ω|h = π".to_owned(), x: vec![half, half], y: vec![1.0 / 3.0, 1.0] }];
    Some(map)
}

/// Index into [`Failure::CLASSES`].
fn class(end: &(Kept, Outcome)) -> usize {
    let (kept, outcome) = end;
    let index = |class: &str| Failure::CLASSES.iter().position(|name| *name == class).unwrap_or(0);
    if let Some(broken) = &outcome.broken {
        return index(Failure::of_break(broken.step, &broken.why).class());
    }
    if !kept.largest_change.is_finite() {
        return index("NaN or overflow");
    }
    if kept.largest_change <= ENERGY_KEPT {
        return 0;
    }
    // Moments rise with the axis in this map.
    let settled = (0..3).find(|axis| kept.settled[*axis] >= 0.995);
    match settled {
        Some(0) => index("settles on the smallest axis"),
        Some(1) => index("settles on the middle axis"),
        Some(_) => index("settles on the largest axis"),
        None if kept.last > 0.0 => index("energy grows"),
        None => index("energy decays"),
    }
}
