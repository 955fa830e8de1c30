//! The note as written: every mass point is rotated, and I is summed anew at every stage. O(K) a step.
//!
//! Points that carry a force but no mass, and the tips of the body axes where a law needs them, ride along
//! behind the mass points.

use nalgebra::{Matrix3, Vector3};

use super::body::Shape;
use super::forced::Motion;
use super::forces::{Cloud, Forces, Load};
use super::system::Start;
use super::{Broken, Model, Pointwise, Snapshot, finite};
use crate::rotation;

/// Every mass point.
#[derive(Clone, Debug)]
pub struct PointCloud {
    pub(super) start: Start,
    pub(super) forces: Forces,
    pub(super) masses: Vec<f64>,
    /// X̃ of mass points, then of markers, then of the tips of the body axes where needed [m], body axes.
    pub(super) arms: Vec<Vector3<f64>>,
    pub(super) mass: f64,
    /// Whether the last three arms are the tips of the body axes.
    pub(super) has_axes: bool,
    pub(super) shape: Shape,
    /// Position of the pivot [m], world.
    pub(super) pivot: Option<Vector3<f64>>,
}

/// State of the points.
#[derive(Debug, PartialEq)]
pub struct PointState {
    arms: Vec<Vector3<f64>>,
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    momentum: Vector3<f64>,
}

impl Clone for PointState {
    fn clone(&self) -> PointState {
        PointState { arms: self.arms.clone(), ..*self }
    }

    /// Into the buffer that is there: a derived one would allocate another.
    fn clone_from(&mut self, other: &PointState) {
        self.arms.clone_from(&other.arms);
        (self.position, self.velocity, self.momentum) = (other.position, other.velocity, other.momentum);
    }
}

impl PointState {
    /// X̃ of every mass point, then of every marker [m], world.
    pub fn arms(&self) -> &[Vector3<f64>] {
        &self.arms
    }
}

impl PointCloud {
    /// I = Σ M (|X̃|² E − X̃ X̃ᵀ) [kg m²], world.
    fn inertia(&self, arms: &[Vector3<f64>]) -> Matrix3<f64> {
        let (mut squares, mut products) = (Vector3::zeros(), Vector3::zeros());
        for (x, mass) in arms.iter().zip(&self.masses) {
            let weighted = x * *mass;
            squares += weighted.component_mul(x);
            products += Vector3::new(weighted.y * x.z, weighted.z * x.x, weighted.x * x.y);
        }
        Matrix3::new(
            squares.y + squares.z,
            -products.z,
            -products.y,
            -products.z,
            squares.z + squares.x,
            -products.x,
            -products.y,
            -products.x,
            squares.x + squares.y,
        )
    }

    /// I Ω = L solved for Ω. A rod turns with L/s, s = Σ M |X̃|²; a single point does not turn.
    fn spin(&self, state: &PointState, inertia: &Matrix3<f64>) -> Result<Vector3<f64>, Broken> {
        match self.shape {
            Shape::Point => Ok(Vector3::zeros()),
            Shape::Rod { .. } => {
                let farthest =
                    state.arms[..self.masses.len()].iter().fold(Vector3::zeros(), |a: Vector3<f64>, b| {
                        if b.norm_squared() > a.norm_squared() { *b } else { a }
                    });
                let direction = farthest / rotation::length(&farthest);
                let across = state.momentum - direction * direction.dot(&state.momentum);
                Ok(across / (inertia.trace() / 2.0))
            }
            Shape::Extended => solve(inertia, &state.momentum),
        }
    }

    fn cloud<'a>(
        &'a self,
        state: &'a PointState,
        levers: &'a PointState,
        spin: Vector3<f64>,
        inertia: Matrix3<f64>,
    ) -> Cloud<'a> {
        let axes = match state.arms[..] {
            [.., x, y, z] if self.has_axes => Matrix3::from_columns(&[x, y, z]),
            _ => Matrix3::identity(),
        };
        let center = if self.pivot.is_some() { self.center_arm(state) } else { Vector3::zeros() };
        Cloud {
            arms: &state.arms,
            levers: &levers.arms,
            masses: &self.masses,
            origin: self.pivot.unwrap_or(state.position),
            velocity: if self.pivot.is_some() { Vector3::zeros() } else { state.velocity },
            spin,
            mass: self.mass,
            inertia,
            center,
            axes,
        }
    }

    /// X_cm, U_cm and L of `advance`.
    fn advance_sums(&self, from: &PointState, s: f64, rates: &Motion, into: &mut PointState) {
        into.momentum = from.momentum + rates.torque * s;
        if self.pivot.is_none() {
            into.position = from.position + rates.velocity * s;
            into.velocity = from.velocity + rates.acceleration * s;
        }
    }

    fn center_arm(&self, state: &PointState) -> Vector3<f64> {
        state.arms.iter().zip(&self.masses).map(|(arm, mass)| arm * (*mass / self.mass)).sum()
    }

    /// Largest change of a distance between mass points, or from the origin, over the largest distance. Beyond
    /// 32 points each is compared with its successor only.
    fn stretch(&self, arms: &[Vector3<f64>]) -> f64 {
        let count = self.masses.len();
        let reach = if count <= 32 { count } else { 2 };
        let mut largest: f64 = 0.0;
        let mut extent: f64 = 0.0;
        for first in 0..count {
            extent = extent.max(self.arms[first].norm());
            largest = largest.max((arms[first].norm() - self.arms[first].norm()).abs());
            for second in first + 1..count.min(first + reach) {
                let before = (self.arms[first] - self.arms[second]).norm();
                let now = (arms[first] - arms[second]).norm();
                extent = extent.max(before);
                largest = largest.max((now - before).abs());
            }
        }
        if extent == 0.0 { 0.0 } else { largest / extent }
    }
}

impl Model for PointCloud {
    type State = PointState;
    type Rates = Motion;

    fn start(&self) -> PointState {
        PointState {
            arms: self.arms.iter().map(|arm| self.start.orientation * arm).collect(),
            position: self.start.position,
            velocity: self.start.velocity,
            momentum: self.start.angular_momentum,
        }
    }

    fn rates(&self, t: f64, state: &PointState) -> Result<Motion, Broken> {
        self.rates_on_levers(t, state, state)
    }

    fn advance(&self, from: &PointState, s: f64, rates: &Motion, into: &mut PointState) {
        let change = rotation::change_of_turn(&(rates.spin * s));
        for (after, before) in into.arms.iter_mut().zip(&from.arms) {
            *after = before + change * before;
        }
        self.advance_sums(from, s, rates, into);
    }

    fn is_finite(&self, state: &PointState) -> bool {
        state.arms.iter().all(|arm| finite(&[arm]))
            && finite(&[&state.position, &state.velocity, &state.momentum])
    }

    fn observe(&self, t: f64, state: &PointState) -> Result<Snapshot, Broken> {
        let spin = self.spin(state, &self.inertia(&state.arms))?;
        let count = self.masses.len();
        let (position, velocity) = match self.pivot {
            Some(pivot) => {
                let arm = self.center_arm(state);
                (pivot + arm, spin.cross(&arm))
            }
            None => (state.position, state.velocity),
        };
        Ok(Snapshot {
            time: t,
            position,
            velocity,
            orientation: rotation::best_fit(&self.arms[..count], &state.arms[..count], &self.masses),
            angular_velocity: spin,
            angular_momentum: state.momentum,
            stretch: self.stretch(&state.arms),
        })
    }
}

impl Pointwise for PointCloud {
    fn advance_straight(
        &self,
        from: &PointState,
        s: f64,
        rates: &Motion,
        at: &PointState,
        into: &mut PointState,
    ) {
        let turned = rates.spin * s;
        for ((after, before), arm) in into.arms.iter_mut().zip(&from.arms).zip(&at.arms) {
            *after = before + turned.cross(arm);
        }
        self.advance_sums(from, s, rates, into);
    }

    fn rates_on_levers(&self, t: f64, state: &PointState, levers: &PointState) -> Result<Motion, Broken> {
        let inertia = self.inertia(&state.arms);
        let spin = self.spin(state, &inertia)?;
        let load = if self.forces.laws().is_empty() {
            Load::default()
        } else {
            self.forces.load_on_points(t, &self.cloud(state, levers, spin, inertia))
        };
        Ok(Motion {
            spin,
            velocity: state.velocity,
            acceleration: load.force / self.mass,
            torque: load.torque,
        })
    }
}

/// Solves a symmetric positive system by L Lᵀ, scaled by the trace so that no product leaves the range of f64.
fn solve(inertia: &Matrix3<f64>, momentum: &Vector3<f64>) -> Result<Vector3<f64>, Broken> {
    let scale = inertia.trace();
    let factors = (inertia / scale).cholesky().ok_or(Broken::Singular)?;
    Ok(factors.solve(&(momentum / scale)))
}
