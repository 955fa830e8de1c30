//! The likeliest cause of a run that converges to another motion than the truth.
//!
//! A hypothesis is a motion: the truth, reported in another way, or the solution of equations with one thing changed. The one that explains
//! the finest run, to what separates it from the run before, is named; none is named otherwise.

use nalgebra::{Matrix3, Quaternion, Vector3};

use crate::model::forces::{Cloud, Forces, Law, PerPoint};
use crate::model::{Placed, Snapshot, System, difference};
use crate::rotation::{self, Rotation};

/// Part of the error that a hypothesis may leave.
const LEFT: f64 = 0.01;
/// What a hypothesis may leave besides, over what separates the two finest runs.
const AS_THE_RUNS: f64 = 3.0;
/// What the integration of a hypothesis may leave, over the size of a quantity: steps of [`TURN`] leave 1e-9 a radian or less.
const INTEGRATED: f64 = 1e-6;
/// Radians turned in a step of the integration.
const TURN: f64 = 0.02;
/// Most steps of it.
const MOST_STEPS: f64 = 2e5;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// What a program may have done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// Ω is in body axes.
    SpinInBodyAxes,
    /// Ω is in degrees a second.
    SpinInDegrees,
    /// Orientations take world axes to body axes.
    Conjugated,
    /// The last orientation alone does.
    LastConjugated,
    /// Quaternions have the scalar last.
    ScalarLast,
    /// States are one sample late.
    Late,
    /// The equations have no gyroscopic term.
    NoGyroscopicTerm,
    /// The products of inertia have the other sign.
    Products,
    /// Torques are about the origin of the world.
    TorqueAboutOrigin,
    /// Forces are not divided by the mass.
    NotOverMass,
    /// Velocities of points leave out Ω × X̃.
    PointsDoNotTurn,
    /// Velocities of points have −Ω × X̃.
    PointsTurnBackwards,
    /// Drag grows with the square of the speed.
    QuadraticDrag,
    /// Drag is multiplied by the mass of the point.
    DragTimesMass,
    /// Fields are taken to stand in body axes.
    FieldInBodyAxes,
}

impl Cause {
    /// All of them, those that change the output first.
    pub const ALL: [Cause; 15] = [
        Cause::SpinInBodyAxes,
        Cause::SpinInDegrees,
        Cause::Conjugated,
        Cause::LastConjugated,
        Cause::ScalarLast,
        Cause::Late,
        Cause::NoGyroscopicTerm,
        Cause::Products,
        Cause::TorqueAboutOrigin,
        Cause::NotOverMass,
        Cause::PointsDoNotTurn,
        Cause::PointsTurnBackwards,
        Cause::QuadraticDrag,
        Cause::DragTimesMass,
        Cause::FieldInBodyAxes,
    ];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Cause::SpinInBodyAxes => "angular velocities are in body axes",
            Cause::SpinInDegrees => "angular velocities are in degrees a second",
            Cause::Conjugated => "quaternions are conjugated: they take world axes to body axes",
            Cause::LastConjugated => "the last quaternion alone is conjugated",
            Cause::ScalarLast => "quaternions have the scalar last",
            Cause::Late => "states are told one sample late",
            Cause::NoGyroscopicTerm => "the equations have no gyroscopic term",
            Cause::Products => "the products of inertia have the other sign",
            Cause::TorqueAboutOrigin => "torques are taken about the origin of the world",
            Cause::NotOverMass => "forces are not divided by the mass",
            Cause::PointsDoNotTurn => "velocities of points leave out the rotation",
            Cause::PointsTurnBackwards => "velocities of points have the rotation with the other sign",
            Cause::QuadraticDrag => "drag grows with the square of the speed",
            Cause::DragTimesMass => "drag is multiplied by the mass of the point",
            Cause::FieldInBodyAxes => "fields are taken to stand in body axes",
        }
    }

    /// The motion that a program with this fault shows at the times of the truth; `None` where nothing would be changed.
    pub fn motion(self, system: &System, truth: &[Snapshot]) -> Option<Vec<Snapshot>> {
        let told = |change: &dyn Fn(&Snapshot) -> Snapshot| Some(truth.iter().map(change).collect());
        let tell = |s: &Snapshot, orientation: Rotation, spin: Vector3<f64>| {
            let momentum = orientation * (system.body.inertia * orientation.inverse_transform_vector(&spin));
            Snapshot { orientation, angular_velocity: spin, angular_momentum: momentum, ..*s }
        };
        let law = |wanted: fn(&Law) -> bool| system.forces.laws().iter().any(wanted);
        match self {
            Cause::SpinInBodyAxes => {
                told(&|s| tell(s, s.orientation, s.orientation.inverse_transform_vector(&s.angular_velocity)))
            }
            Cause::SpinInDegrees => told(&|s| tell(s, s.orientation, s.angular_velocity / DEGREE)),
            Cause::Conjugated => told(&|s| tell(s, s.orientation.inverse(), s.angular_velocity)),
            Cause::LastConjugated => {
                let mut states = truth.to_vec();
                let last = states.last_mut()?;
                *last = tell(last, last.orientation.inverse(), last.angular_velocity);
                Some(states)
            }
            Cause::ScalarLast => told(&|s| {
                let q = s.orientation;
                let moved = Rotation::new_unchecked(Quaternion::new(q.i, q.j, q.k, q.w));
                tell(s, moved, s.angular_velocity)
            }),
            Cause::Late => {
                let before = truth.iter().take(1).chain(truth).take(truth.len());
                Some(before.zip(truth).map(|(s, now)| Snapshot { time: now.time, ..*s }).collect())
            }
            Cause::NoGyroscopicTerm => Wrong { cause: self, system }.motion(truth),
            Cause::Products => {
                let inertia = system.body.inertia;
                let off = inertia - Matrix3::from_diagonal(&inertia.diagonal());
                (off.amax() > 0.0).then(|| Wrong { cause: self, system }.motion(truth)).flatten()
            }
            Cause::QuadraticDrag | Cause::DragTimesMass if !law(|law| matches!(law, Law::Drag(_))) => None,
            Cause::FieldInBodyAxes if !law(|law| matches!(law, Law::Lorentz(_) | Law::Dipole(_))) => None,
            _ if system.forces.laws().is_empty() => None,
            _ => Wrong { cause: self, system }.motion(truth),
        }
    }
}

/// The cause that explains `states`, the finest run, whose next coarser one is `before`, at the times of the truth.
pub fn likeliest_cause(
    system: &System,
    truth: &[Snapshot],
    states: &[Snapshot],
    before: &[Snapshot],
) -> Option<Cause> {
    if states.len() != truth.len() || before.len() != truth.len() {
        return None;
    }
    let sizes = crate::model::sizes(system, truth);
    let distance = |a: &[Snapshot], b: &[Snapshot]| {
        let mut largest = 0.0f64;
        for (a, b) in a.iter().zip(b) {
            for (quantity, apart) in difference(&system.body, a, b) {
                let size = if sizes[quantity] > 0.0 { sizes[quantity] } else { 1.0 };
                largest = largest.max(apart / size);
            }
        }
        largest
    };
    let (error, runs) = (distance(states, truth), distance(states, before));
    let allowed = (AS_THE_RUNS * runs + INTEGRATED).min(LEFT * error);
    let left = |cause: &Cause| Some((*cause, distance(states, &cause.motion(system, truth)?)));
    let explained = Cause::ALL.iter().filter_map(left).filter(|(_, left)| *left <= allowed);
    explained.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(cause, _)| cause)
}

/// The Euler equations in body axes with one fault.
struct Wrong<'a> {
    cause: Cause,
    system: &'a System,
}

/// X of the origin, U of the origin, q as plain numbers, ω in body axes.
#[derive(Clone, Copy)]
struct State {
    origin: Vector3<f64>,
    velocity: Vector3<f64>,
    turn: Quaternion<f64>,
    spin: Vector3<f64>,
}

impl State {
    fn moved(&self, s: f64, rate: &State) -> State {
        State {
            origin: self.origin + rate.origin * s,
            velocity: self.velocity + rate.velocity * s,
            turn: self.turn + rate.turn * s,
            spin: self.spin + rate.spin * s,
        }
    }
}

impl Wrong<'_> {
    fn inertia(&self) -> Matrix3<f64> {
        let inertia = self.system.body.inertia;
        if self.cause == Cause::Products {
            return Matrix3::from_diagonal(&inertia.diagonal()) * 2.0 - inertia;
        }
        inertia
    }

    /// The motion at the times of the truth, by the classical Runge–Kutta method.
    fn motion(&self, truth: &[Snapshot]) -> Option<Vec<Snapshot>> {
        let (start, inverse) = (&self.system.start, self.inertia().try_inverse()?);
        let own = self.system.body.inverse_inertia();
        let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
        let pivoted = self.system.body.pivoted;
        let mut state = State {
            origin: self.system.origin(),
            velocity: if pivoted { Vector3::zeros() } else { start.velocity },
            turn: start.orientation.into_inner(),
            spin: own * momentum,
        };
        let fastest = truth.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
        let fastest = fastest.max(self.system.forces.fastest_clock());
        let mut placed = Placed::new(self.system);
        let (mut states, mut time) = (Vec::with_capacity(truth.len()), 0.0);
        for wanted in truth {
            let stretch = wanted.time - time;
            let steps = (stretch * fastest / TURN).ceil().clamp(1.0, MOST_STEPS / truth.len() as f64);
            let h = stretch / steps;
            for n in 0..if stretch > 0.0 { steps as u64 } else { 0 } {
                let t = time + n as f64 * h;
                let k1 = self.rate(t, &state, &inverse, &mut placed);
                let k2 = self.rate(t + h / 2.0, &state.moved(h / 2.0, &k1), &inverse, &mut placed);
                let k3 = self.rate(t + h / 2.0, &state.moved(h / 2.0, &k2), &inverse, &mut placed);
                let k4 = self.rate(t + h, &state.moved(h, &k3), &inverse, &mut placed);
                state = state.moved(h / 6.0, &k1).moved(h / 3.0, &k2).moved(h / 3.0, &k3).moved(h / 6.0, &k4);
            }
            time = wanted.time;
            states.push(self.observe(time, &state)?);
        }
        Some(states)
    }

    fn observe(&self, time: f64, state: &State) -> Option<Snapshot> {
        let orientation = Rotation::try_new(state.turn, 0.0)?;
        let (spin, arm) = (orientation * state.spin, orientation * self.system.body.center);
        Some(Snapshot {
            time,
            position: state.origin + arm,
            velocity: state.velocity + spin.cross(&arm),
            orientation,
            angular_velocity: spin,
            // A harness that knows the body makes L of what the program tells.
            angular_momentum: orientation * (self.system.body.inertia * state.spin),
            stretch: 0.0,
        })
    }

    fn rate(&self, t: f64, state: &State, inverse: &Matrix3<f64>, placed: &mut Placed) -> State {
        let orientation = Rotation::new_normalize(state.turn);
        let spin = state.spin;
        let (force, torque) = self.load(t, state, &orientation, placed);
        let mass = if self.cause == Cause::NotOverMass { 1.0 } else { self.system.body.mass };
        let gyroscopic = match self.cause {
            Cause::NoGyroscopicTerm => Vector3::zeros(),
            _ => spin.cross(&(self.inertia() * spin)),
        };
        let pivoted = self.system.body.pivoted;
        State {
            origin: if pivoted { Vector3::zeros() } else { state.velocity },
            velocity: if pivoted { Vector3::zeros() } else { force / mass },
            turn: state.turn * Quaternion::from_imag(spin * 0.5),
            spin: inverse * (orientation.inverse_transform_vector(&torque) - gyroscopic),
        }
    }

    /// F [N] and τ [N m], world.
    fn load(
        &self,
        t: f64,
        state: &State,
        orientation: &Rotation,
        placed: &mut Placed,
    ) -> (Vector3<f64>, Vector3<f64>) {
        if self.system.forces.laws().is_empty() {
            return (Vector3::zeros(), Vector3::zeros());
        }
        placed.turn(self.system, orientation);
        let turning = match self.cause {
            Cause::PointsDoNotTurn => Vector3::zeros(),
            Cause::PointsTurnBackwards => -(orientation * state.spin),
            _ => orientation * state.spin,
        };
        let cloud = placed.cloud(state.origin, state.velocity, turning);
        let changed = self.forces(&cloud, orientation);
        let load = changed.as_ref().unwrap_or(&self.system.forces).load_on_points(t, &cloud);
        let about = if self.cause == Cause::TorqueAboutOrigin { state.origin } else { Vector3::zeros() };
        (load.force, load.torque + about.cross(&load.force))
    }

    /// The laws, where the fault changes them.
    fn forces(&self, cloud: &Cloud, orientation: &Rotation) -> Option<Forces> {
        let points = &self.system.body.points;
        let each = |factor: &dyn Fn(usize) -> f64, of: &PerPoint| {
            PerPoint::Each((0..points.len()).map(|k| of.at(k) * factor(k)).collect())
        };
        let speed = |k: usize| rotation::length(&(cloud.velocity + cloud.spin.cross(&cloud.arms.at(k))));
        let change = |law: &Law| {
            let mut law = law.clone();
            match (&mut law, self.cause) {
                (Law::Drag(drag), Cause::QuadraticDrag) => drag.coefficient = each(&speed, &drag.coefficient),
                (Law::Drag(drag), Cause::DragTimesMass) => {
                    drag.coefficient = each(&|k| points[k].mass, &drag.coefficient);
                }
                (Law::Lorentz(lorentz), Cause::FieldInBodyAxes) => {
                    lorentz.magnetic = orientation * lorentz.magnetic
                }
                (Law::Dipole(dipole), Cause::FieldInBodyAxes) => dipole.field = orientation * dipole.field,
                _ => {}
            }
            law
        };
        let changes =
            matches!(self.cause, Cause::QuadraticDrag | Cause::DragTimesMass | Cause::FieldInBodyAxes);
        changes
            .then(|| Forces::new(self.system.forces.laws().iter().map(change).collect(), &self.system.body))
    }
}
