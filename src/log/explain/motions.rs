//! Changes of the motion itself: another start, another inertia, other equations, the steps of a known scheme.

use nalgebra::{Matrix3, Matrix3x6, Matrix6, SymmetricEigen, Vector3};

use super::fits::autonomous;
use super::repairs::turned;
use super::{Case, Change, LEFT, Part, Parts, SMALL, Tried};
use crate::model::body::Body;
use crate::model::forces::Law;
use crate::model::{Snapshot, Spin, System};
use crate::ode::dop853;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};
use crate::study::cause::Cause;

/// Rows that another motion is held against.
const FEWEST: usize = 3;
/// Steps of a scheme that are compared with the log.
const STEPS: usize = 200;
/// How far a spacing may be from the mean, over it, in a log of equal steps.
const EQUAL: f64 = 1e-6;
/// Eigenvalue of the tensors that conserve L over the next, squared errors, below which there is one such tensor.
const ALONE: f64 = LEFT * LEFT;
/// Schemes that are named together.
const NAMED: usize = 3;

pub(super) fn tried(case: &Case) -> Vec<Tried> {
    if case.rows.len() < FEWEST {
        return Vec::new();
    }
    let mut tried = inertias(case);
    tried.extend(equations(case));
    tried.extend(start(case));
    tried
}

/// What is left against a motion of another system at the times of the rows.
fn against(case: &Case, system: &System, from: f64) -> Option<f64> {
    let times: Vec<f64> = case.truth.iter().map(|truth| truth.time - from).collect();
    if times.first().is_none_or(|first| *first < 0.0) || times.windows(2).any(|pair| pair[1] <= pair[0]) {
        return None;
    }
    let run = dop853::solve(system, &times, dop853::TOLERANCE.max(1e-12)).ok()?;
    Some(case.residual(&case.states, &run.states))
}

/// The motion from the first row on.
pub(super) fn start(case: &Case) -> Vec<Tried> {
    let (state, truth) = (&case.states[0], &case.truth[0]);
    if case.rows.len() < FEWEST || !(autonomous(case.system()) || truth.time == 0.0) {
        return Vec::new();
    }
    let started = case.system().started_at(&case.reader.start(case.row(0), truth));
    let Some(left) = against(case, &started, truth.time) else { return Vec::new() };
    let mut words = "the first row is not the scene's start".to_owned();
    if case.parts().has(Part::Orientation) {
        let turn = truth.orientation.inverse() * state.orientation;
        words += &format!(": it is turned by {}, body axes", turned(&turn));
    }
    words += "; --from-log starts the reference there";
    vec![Tried { change: Change::Start, words, left }]
}

/// Whether the body may be replaced by one of another inertia: no law holds on to its points.
fn replaceable(system: &System) -> bool {
    let bound = |law: &Law| !law.is_torque() && law.uniform_acceleration().is_none();
    !system.body.pivoted && !system.forces.laws().iter().any(bound)
}

fn with_inertia(system: &System, inertia: Matrix3<f64>) -> Option<System> {
    let body = Body::from_inertia(system.body.mass, inertia, None, true).ok()?;
    let start = &system.start;
    let own = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let spin = start.orientation * (system.body.inverse_inertia() * own);
    let laws = system.forces.laws().to_vec();
    System::new(body, laws, start.position, start.orientation, start.velocity, Spin::Velocity(spin)).ok()
}

fn inertias(case: &Case) -> Vec<Tried> {
    const ORDERS: [[usize; 3]; 5] = [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let system = case.system();
    if !replaceable(system) {
        return Vec::new();
    }
    let own = system.body.inertia;
    let (diagonal, products) = (own.diagonal(), Vector3::new(own[(0, 1)], own[(0, 2)], own[(1, 2)]));
    let names = ["Ixy", "Ixz", "Iyz"];
    let mut changed: Vec<(String, Matrix3<f64>)> = Vec::new();
    if products.amax() > 0.0 {
        for signs in 1..8usize {
            let sign = |k: usize| if signs >> k & 1 == 1 { -1.0 } else { 1.0 };
            let flipped: Vec<&str> = (0..3).filter(|k| sign(*k) < 0.0).map(|k| names[k]).collect();
            let of = Vector3::from_fn(|k, _| products[k] * sign(k));
            changed.push((format!("{} of the other sign", flipped.join(", ")), tensor(&diagonal, &of)));
        }
        for order in ORDERS {
            let of = Vector3::from_fn(|k, _| products[order[k]]);
            let words = format!("{} in the place of Ixy, Ixz, Iyz", order.map(|k| names[k]).join(", "));
            changed.push((words, tensor(&diagonal, &of)));
        }
        changed.push(("no products of inertia".to_owned(), tensor(&diagonal, &Vector3::zeros())));
    }
    for order in ORDERS {
        let of = Vector3::from_fn(|k, _| diagonal[order[k]]);
        let words =
            format!("{} in the place of Ixx, Iyy, Izz", order.map(|k| ["Ixx", "Iyy", "Izz"][k]).join(", "));
        changed.push((words, tensor(&of, &products)));
    }
    changed.retain(|(_, inertia)| (inertia - own).amax() > SMALL * own.amax());
    changed.extend(conserving(case).map(|inertia| (format!("the inertia {}", numbers(&inertia)), inertia)));
    let motion = |(words, inertia): (String, Matrix3<f64>)| {
        let left = against(case, &with_inertia(system, inertia)?, 0.0)?;
        Some(Tried { change: Change::Inertia, words: format!("the body of the log has {words}"), left })
    };
    changed.into_iter().filter_map(motion).collect()
}

fn tensor(diagonal: &Vector3<f64>, products: &Vector3<f64>) -> Matrix3<f64> {
    let [xy, xz, yz] = [products[0], products[1], products[2]];
    Matrix3::new(diagonal[0], xy, xz, xy, diagonal[1], yz, xz, yz, diagonal[2])
}

fn numbers(inertia: &Matrix3<f64>) -> String {
    let row = |k: usize| format!("[{:.6}, {:.6}, {:.6}]", inertia[(k, 0)], inertia[(k, 1)], inertia[(k, 2)]);
    format!("[{}, {}, {}] (to a factor)", row(0), row(1), row(2))
}

/// The tensor under which L is constant in the log, with the trace of the scene's: the eigenvector of the least eigenvalue of the
/// scatter of R I Rᵀ Ω, which is linear in I.
fn conserving(case: &Case) -> Option<Matrix3<f64>> {
    let both = Parts::of(&[Part::Orientation, Part::Spin]);
    if !case.system().torque_free() || !case.parts().covers(both) {
        return None;
    }
    let of = |state: &Snapshot| -> Matrix3x6<f64> {
        let b = state.orientation.inverse_transform_vector(&state.angular_velocity);
        let rows = Matrix3x6::new(
            b.x, 0.0, 0.0, b.y, b.z, 0.0, //
            0.0, b.y, 0.0, b.x, 0.0, b.z, //
            0.0, 0.0, b.z, 0.0, b.x, b.y,
        );
        rotation::axes(&state.orientation) * rows
    };
    let count = case.states.len() as f64;
    let mean = case.states.iter().map(of).sum::<Matrix3x6<f64>>() / count;
    let scatter: Matrix6<f64> = case
        .states
        .iter()
        .map(|state| {
            let off = of(state) - mean;
            off.transpose() * off
        })
        .sum();
    let eigen = SymmetricEigen::new(scatter);
    let mut order: Vec<usize> = (0..6).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    if eigen.eigenvalues[order[0]].abs() > ALONE * eigen.eigenvalues[order[1]] {
        return None;
    }
    let p = eigen.eigenvectors.column(order[0]);
    let found = tensor(&Vector3::new(p[0], p[1], p[2]), &Vector3::new(p[3], p[4], p[5]));
    Some(found * (case.system().body.inertia.trace() / found.trace()))
}

/// The equations of motion with one thing changed, as programs under test are held against them.
fn equations(case: &Case) -> Vec<Tried> {
    let changes_equations = |cause: &&Cause| {
        !matches!(
            cause,
            Cause::SpinInBodyAxes
                | Cause::SpinInDegrees
                | Cause::Conjugated
                | Cause::LastConjugated
                | Cause::ScalarLast
                | Cause::Late
                | Cause::Products
        )
    };
    let tried = |cause: &Cause| {
        let motion = cause.motion(case.system(), &case.truth)?;
        let left = case.residual(&case.states, &motion);
        Some(Tried { change: Change::Equations, words: cause.words().to_owned(), left })
    };
    let mut all: Vec<Tried> = Cause::ALL.iter().filter(changes_equations).filter_map(tried).collect();
    all.extend(without_forces(case));
    all
}

fn without_forces(case: &Case) -> Option<Tried> {
    let system = case.system();
    if system.body.pivoted || system.forces.laws().is_empty() {
        return None;
    }
    let start = &system.start;
    let spin = Spin::Momentum(start.angular_momentum);
    let body = system.body.clone();
    let free = System::new(body, Vec::new(), start.position, start.orientation, start.velocity, spin).ok()?;
    let left = against(case, &free, 0.0)?;
    Some(Tried { change: Change::Equations, words: "no force acts in the log".to_owned(), left })
}

/// The schemes whose steps are the rows of the log.
pub(super) fn scheme(case: &Case) -> Option<Tried> {
    let rows = &case.log().rows;
    let rows = &rows[..rows.len().min(STEPS + 1).min(case.log().block)];
    let (first, last) = (rows.first()?, rows.last()?);
    let step = (last.time() - first.time()) / (rows.len().max(2) - 1) as f64;
    let even = |pair: &[super::Row]| (pair[1].time() - pair[0].time() - step).abs() <= EQUAL * step;
    let whole = rows.iter().all(|row| row.parts == case.parts());
    if rows.len() < FEWEST || first.time() != 0.0 || !whole || !rows.windows(2).all(even) {
        return None;
    }
    let truth: Vec<Snapshot> = rows.iter().map(|row| case.track.truth(row.time())).collect();
    let states: Vec<Snapshot> =
        rows.iter().zip(&truth).map(|(row, truth)| case.reader.snapshot(row, Some(truth))).collect();
    let before = case.residual(&states, &truth);
    let steps = rows.len() as u64 - 1;
    let plan = Plan { step, steps, every: 1 };
    let left = |contestant: &Contestant| {
        if contestant.refusal(case.system()).is_some() || contestant.chooses_steps() {
            return None;
        }
        let run = contestant.run(case.system(), Form::Least, &plan);
        (run.states.len() == states.len())
            .then(|| (case.residual(&states, &run.states), contestant.card.name))
    };
    let mut fits: Vec<(f64, &str)> = Contestant::all().iter().filter_map(left).collect();
    fits.retain(|(left, _)| *left <= LEFT * before);
    fits.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (best, _) = *fits.first()?;
    let names: Vec<&str> =
        fits.iter().take_while(|fit| fit.0 <= 3.0 * best.max(1e-13)).take(NAMED).map(|fit| fit.1).collect();
    let words = format!("the rows are the steps of {} with h = {step} s", names.join(" or "));
    // The whole log has the same error: what is left of it is the same part.
    Some(Tried { change: Change::Scheme, words, left: best })
}
