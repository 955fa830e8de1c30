//! The note as written: every mass point is rotated, and I is summed anew at every stage. O(K) a step.
//!
//! Points that carry a force but no mass, and the tips of the body axes where a law needs them, ride along
//! behind the mass points.

use nalgebra::{Matrix3, Vector3};

use super::arms::{Columns, Sums, filled, turn};
use super::body::Shape;
use super::forced::Motion;
use super::forces::{Cloud, Forces, Load};
use super::system::{Start, System};
use super::{Broken, Model, Pointwise, Snapshot, finite};
use crate::arithmetic::Real;
use crate::arithmetic::Registers;
use crate::rotation;

/// Every mass point.
#[derive(Clone, Debug)]
pub struct PointCloud<T: Real = f64> {
    start: Start<T>,
    forces: Forces<T>,
    masses: Vec<T>,
    /// The masses, and zeros to the end of the columns.
    column_of_masses: Vec<T>,
    /// X̃ of mass points, then of markers, then of the tips of the body axes where needed [m], body axes.
    arms: Vec<Vector3<T>>,
    mass: T,
    inverse_mass: T,
    /// Whether the last three arms are the tips of the body axes.
    has_axes: bool,
    shape: Shape<T>,
    /// Position of the pivot [m], world.
    pivot: Option<Vector3<T>>,
    registers: Registers,
}

/// State of the points.
#[derive(Debug, PartialEq)]
pub struct PointState<T: Real = f64> {
    /// X̃ of every mass point, then of every marker, then of tips [m], world.
    arms: Columns<T>,
    /// Σ over these arms that I is made of.
    sums: Sums<T>,
    position: Vector3<T>,
    velocity: Vector3<T>,
    momentum: Vector3<T>,
}

impl<T: Real> Clone for PointState<T> {
    fn clone(&self) -> PointState<T> {
        PointState { arms: self.arms.clone(), ..*self }
    }

    /// Into the buffer that is there: a derived one would allocate another.
    fn clone_from(&mut self, other: &PointState<T>) {
        self.arms.clone_from(&other.arms);
        (self.sums, self.position, self.velocity, self.momentum) =
            (other.sums, other.position, other.velocity, other.momentum);
    }
}

impl<T: Real> PointCloud<T> {
    pub(super) fn new(system: &System<T>, arms: Vec<Vector3<T>>, has_axes: bool) -> PointCloud<T> {
        let masses: Vec<T> = system.body.points.iter().map(|p| p.mass).collect();
        let mut column_of_masses = masses.clone();
        column_of_masses.resize(arms.len(), T::zero());
        PointCloud {
            start: system.start,
            forces: system.forces.clone(),
            masses,
            column_of_masses: filled(column_of_masses),
            arms,
            mass: system.body.mass,
            inverse_mass: T::one() / system.body.mass,
            has_axes,
            shape: system.body.shape,
            pivot: system.body.pivoted.then(|| system.origin()),
            registers: Registers::widest(),
        }
    }

    /// I Ω = L solved for Ω. A rod turns with L/s, s = Σ M |X̃|²; a single point does not turn.
    #[inline(always)]
    fn spin(&self, state: &PointState<T>, inertia: &Matrix3<T>) -> Result<Vector3<T>, Broken> {
        match self.shape {
            Shape::Point => Ok(Vector3::zeros()),
            Shape::Rod { .. } => {
                let points = (0..self.masses.len()).map(|k| state.arms.at(k));
                let farther = |a: Vector3<T>, b: Vector3<T>| {
                    if b.norm_squared() > a.norm_squared() { b } else { a }
                };
                let farthest = points.fold(Vector3::zeros(), farther);
                let direction = farthest / rotation::length(&farthest);
                let across = state.momentum - direction * direction.dot(&state.momentum);
                Ok(across / (inertia.trace() / 2.0))
            }
            Shape::Extended => solve(inertia, &state.momentum),
        }
    }

    fn cloud<'a>(
        &'a self,
        state: &'a PointState<T>,
        levers: &'a PointState<T>,
        spin: Vector3<T>,
        inertia: Matrix3<T>,
    ) -> Cloud<'a, T> {
        let axes = if self.has_axes {
            let tips = self.arms.len() - 3;
            Matrix3::from_columns(&[0, 1, 2].map(|i| state.arms.at(tips + i)))
        } else {
            Matrix3::identity()
        };
        let center = if self.pivot.is_some() { self.center_arm(state) } else { Vector3::zeros() };
        Cloud {
            arms: state.arms.view(),
            levers: levers.arms.view(),
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
    fn advance_sums(&self, from: &PointState<T>, s: T, rates: &Motion<T>, into: &mut PointState<T>) {
        into.momentum = from.momentum + rates.torque * s;
        if self.pivot.is_none() {
            into.position = from.position + rates.velocity * s;
            into.velocity = from.velocity + rates.acceleration * s;
        }
    }

    fn center_arm(&self, state: &PointState<T>) -> Vector3<T> {
        let weighted = |(k, mass): (usize, &T)| state.arms.at(k) * (*mass / self.mass);
        self.masses.iter().enumerate().map(weighted).sum()
    }

    /// Largest change of a distance between mass points, or from the origin, over the largest distance. Beyond
    /// 32 points each is compared with its successor only.
    fn stretch(&self, arms: &Columns<T>) -> T {
        let count = self.masses.len();
        let reach = if count <= 32 { count } else { 2 };
        let mut largest = T::zero();
        let mut extent = T::zero();
        for first in 0..count {
            extent = extent.max(self.arms[first].norm());
            largest = largest.max((arms.at(first).norm() - self.arms[first].norm()).abs());
            for second in first + 1..count.min(first + reach) {
                let before = (self.arms[first] - self.arms[second]).norm();
                let now = (arms.at(first) - arms.at(second)).norm();
                extent = extent.max(before);
                largest = largest.max((now - before).abs());
            }
        }
        if extent == 0.0 { extent } else { largest / extent }
    }
}

impl<T: Real> Model for PointCloud<T> {
    type Real = T;
    type State = PointState<T>;
    type Rates = Motion<T>;

    fn start(&self) -> PointState<T> {
        let arms: Vec<_> = self.arms.iter().map(|arm| self.start.orientation * arm).collect();
        let arms = Columns::new(&arms);
        PointState {
            sums: Sums::of(&arms, &self.masses),
            arms,
            position: self.start.position,
            velocity: self.start.velocity,
            momentum: self.start.angular_momentum,
        }
    }

    fn pieces(&self) -> Vec<(T, PointCloud<T>)> {
        let in_piece =
            |(end, forces): &(T, Forces<T>)| (*end, PointCloud { forces: forces.clone(), ..self.clone() });
        self.forces.pieces().iter().map(in_piece).collect()
    }

    #[inline(always)]
    fn rates(&self, t: T, state: &PointState<T>) -> Result<Motion<T>, Broken> {
        self.rates_on_levers(t, state, state)
    }

    #[inline(always)]
    fn advance(&self, from: &PointState<T>, s: T, rates: &Motion<T>, into: &mut PointState<T>) {
        let change = rotation::change_of_turn(&rates.spin, s);
        into.sums = turn(self.registers, &change, &from.arms, &self.column_of_masses, &mut into.arms);
        self.advance_sums(from, s, rates, into);
    }

    fn is_finite(&self, state: &PointState<T>) -> bool {
        state.arms.is_finite() && finite(&[&state.position, &state.velocity, &state.momentum])
    }

    fn observe(&self, t: T, state: &PointState<T>) -> Result<Snapshot<T>, Broken> {
        let spin = self.spin(state, &state.sums.inertia())?;
        let count = self.masses.len();
        let points: Vec<_> = (0..count).map(|k| state.arms.at(k)).collect();
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
            orientation: rotation::best_fit(&self.arms[..count], &points, &self.masses),
            angular_velocity: spin,
            angular_momentum: state.momentum,
            stretch: self.stretch(&state.arms),
        })
    }
}

impl<T: Real> Pointwise for PointCloud<T> {
    fn advance_straight(
        &self,
        from: &PointState<T>,
        s: T,
        rates: &Motion<T>,
        at: &PointState<T>,
        into: &mut PointState<T>,
    ) {
        let turned = rates.spin * s;
        for k in 0..from.arms.len() {
            into.arms.set(k, &(from.arms.at(k) + turned.cross(&at.arms.at(k))));
        }
        into.sums = Sums::of(&into.arms, &self.masses);
        self.advance_sums(from, s, rates, into);
    }

    #[inline(always)]
    fn rates_on_levers(
        &self,
        t: T,
        state: &PointState<T>,
        levers: &PointState<T>,
    ) -> Result<Motion<T>, Broken> {
        let inertia = state.sums.inertia();
        let spin = self.spin(state, &inertia)?;
        let load = if self.forces.laws().is_empty() {
            Load::default()
        } else {
            self.forces.load_on_points(t, &self.cloud(state, levers, spin, inertia))
        };
        Ok(Motion {
            spin,
            velocity: state.velocity,
            acceleration: load.force * self.inverse_mass,
            torque: load.torque,
        })
    }
}

/// Solves a symmetric positive system by L D Lᵀ, in which no product of two moments occurs that could leave the range of
/// f64.
#[inline]
fn solve<T: Real>(inertia: &Matrix3<T>, momentum: &Vector3<T>) -> Result<Vector3<T>, Broken> {
    let [a, b, c] = [inertia.m11, inertia.m21, inertia.m31];
    let first = T::one() / a;
    let (l21, l31) = (b * first, c * first);
    let d = inertia.m22 - l21 * b;
    let e = inertia.m32 - l31 * b;
    let second = T::one() / d;
    let l32 = e * second;
    let f = inertia.m33 - l31 * c - l32 * e;
    if !(a > 0.0 && d > 0.0 && f > 0.0) {
        return Err(Broken::Singular);
    }
    let y = momentum.y - l21 * momentum.x;
    let z = (momentum.z - l31 * momentum.x - l32 * y) / f;
    let y = y * second - l32 * z;
    Ok(Vector3::new(momentum.x * first - l21 * y - l31 * z, y, z))
}
