//! Motions in closed form, found by what a system is: the first of these that fits.
//!
//! | form | what moves | functions |
//! |---|---|---|
//! | `lagrange_top` | a symmetric body under gravity, on a pivot on its axis | Jacobi's, third-kind integrals |
//! | `translation` | a centre of mass under uniform gravity, or a point on linear springs with drag | parabola, exponentials |
//! | `rod`, `sphere` | spin about a fixed axis | sine, cosine |
//! | `symmetric` | two equal moments: two steady rotations | sine, cosine |
//! | `gyrostat` | the same with wheels on the axis of symmetry | sine, cosine |
//! | `separatrix` | exactly on the separatrix | tanh, sech, arctan |
//! | `asymmetric` | any other free body, near the separatrix too | Jacobi's, the phase of a third-kind integral |
//!
//! A free or falling body is a translation and a rotation that do not see each other. All are evaluated in f64: the
//! error is a few rounding units times 1 + |Ω| t, times what the motion makes of a rounding. How much that is, is
//! measured: the forms are evaluated again with moments, angular momentum and velocity a rounding off in several
//! directions, and twice the largest difference is the uncertainty: the directions are few.

mod asymmetric;
mod gyrostat;
mod lagrange_top;
mod rod;
mod separatrix;
mod sphere;
mod symmetric;
mod top_roots;
mod translation;

use nalgebra::Vector3;

use super::nudge::{DIRECTIONS, nudged};
use crate::model::body::Shape;
use crate::model::forces::Law;
use crate::model::{PerQuantity, Snapshot, System, difference};
use crate::rotation::{self, Rotation};

/// A motion in closed form at some times.
#[derive(Clone, Debug, PartialEq)]
pub struct Closed {
    /// What was found.
    pub name: String,
    /// One for each time.
    pub states: Vec<Snapshot>,
    /// What the roundings of each may come to, largest so far.
    pub uncertainty: Vec<PerQuantity<f64>>,
}

/// The motion of `system` at `times` [s]; `None` where no closed form fits, or it is not finite.
pub fn solve(system: &System, times: &[f64]) -> Option<Closed> {
    let form = Form::of(system)?;
    let states: Vec<Snapshot> = times.iter().map(|t| form.at(system, *t)).collect();
    let finite = |s: &Snapshot| s.angular_velocity.iter().chain(&s.position).all(|x| x.is_finite());
    if !states.iter().all(finite) {
        return None;
    }
    let nudged: Vec<(System, Form)> = DIRECTIONS
        .iter()
        .filter_map(|signs| {
            let system = nudged(system, signs);
            Form::of(&system).map(|form| (system, form))
        })
        .collect();
    let mut largest = PerQuantity::all(0.0);
    let uncertainty = states.iter().map(|state| {
        for (other, form) in &nudged {
            let apart = difference(&system.body, state, &form.at(other, state.time));
            largest = apart.map(|apart| 2.0 * apart).max(largest);
        }
        largest
    });
    Some(Closed { name: form.name(), uncertainty: uncertainty.collect(), states: states.clone() })
}

/// A rotation in closed form.
enum Turn {
    Point,
    Rod,
    Sphere,
    Symmetric,
    Gyrostat(gyrostat::Gyrostat),
    Separatrix(separatrix::Separatrix),
    Asymmetric,
}

enum Form {
    Top(Box<lagrange_top::Top>),
    Apart(translation::Translation, Turn),
}

impl Form {
    fn of(system: &System) -> Option<Form> {
        let laws = system.forces.laws();
        let gravity = gravity(laws);
        if system.body.pivoted {
            let gravity = gravity?;
            let still = gravity == Vector3::zeros() || system.body.center == Vector3::zeros();
            let turning = || Some(Form::Apart(translation::Translation::Held, Turn::of(system)));
            return if still {
                turning()
            } else {
                lagrange_top::Top::of(system, &gravity).map(Box::new).map(Form::Top)
            };
        }
        match (gravity, system.body.shape) {
            (Some(gravity), _) => {
                Some(Form::Apart(translation::Translation::Falling(gravity), Turn::of(system)))
            }
            (None, Shape::Point) => {
                translation::on_springs(system).map(|moving| Form::Apart(moving, Turn::Point))
            }
            (None, _) => {
                let without: Vec<Law> =
                    laws.iter().filter(|law| !matches!(law, Law::Wheels(_))).cloned().collect();
                let gravity = self::gravity(&without)?;
                let turn = Turn::Gyrostat(gyrostat::Gyrostat::of(system)?);
                Some(Form::Apart(translation::Translation::Falling(gravity), turn))
            }
        }
    }

    fn name(&self) -> String {
        match self {
            Form::Top(_) => "symmetric heavy top, by Jacobi's functions".to_owned(),
            Form::Apart(translation, turn) => match (translation.name(), turn.name()) {
                (name, "") | ("", name) => name.to_owned(),
                (translation, turn) => format!("{turn}; {translation}"),
            },
        }
    }

    fn at(&self, system: &System, t: f64) -> Snapshot {
        match self {
            Form::Top(top) => top.at(system, t),
            Form::Apart(translation, turn) => {
                let (orientation, angular_velocity) = turn.at(system, t);
                let (position, velocity) = translation.at(system, &orientation, &angular_velocity, t);
                let angular_momentum = match turn {
                    Turn::Gyrostat(_) => {
                        let own = orientation.inverse_transform_vector(&angular_velocity);
                        orientation * (system.body.inertia * own)
                    }
                    _ => system.start.angular_momentum,
                };
                let stretch = 0.0;
                Snapshot {
                    time: t,
                    position,
                    velocity,
                    orientation,
                    angular_velocity,
                    angular_momentum,
                    stretch,
                }
            }
        }
    }
}

/// The sum of uniform gravities [m/s²], where there is no other law.
fn gravity(laws: &[Law]) -> Option<Vector3<f64>> {
    laws.iter().map(|law| if let Law::Gravity(law) = law { Some(law.acceleration) } else { None }).sum()
}

impl Turn {
    fn of(system: &System) -> Turn {
        let body = &system.body;
        match body.shape {
            Shape::Point => return Turn::Point,
            Shape::Rod { .. } => return Turn::Rod,
            Shape::Extended => {}
        }
        let [a, b, c] = body.moments.into();
        if a == b && b == c {
            return Turn::Sphere;
        }
        if a == b || b == c || c == a {
            return Turn::Symmetric;
        }
        separatrix::Separatrix::of(system).map_or(Turn::Asymmetric, Turn::Separatrix)
    }

    fn name(&self) -> &'static str {
        match self {
            Turn::Point => "",
            Turn::Rod => "free rod, by a steady rotation",
            Turn::Sphere => "free sphere, by a steady rotation",
            Turn::Symmetric => "free symmetric body, by two steady rotations",
            Turn::Gyrostat(_) => "symmetric body with wheels on its axis, by two steady rotations",
            Turn::Separatrix(_) => "free body on the separatrix, by tanh and sech",
            Turn::Asymmetric => "free asymmetric body, by Jacobi's functions",
        }
    }

    /// Orientation and Ω [rad/s] at `t` [s].
    fn at(&self, system: &System, t: f64) -> (Rotation, Vector3<f64>) {
        let start = system.start.orientation;
        let orientation = match self {
            Turn::Point => return (start, Vector3::zeros()),
            Turn::Gyrostat(gyrostat) => return gyrostat.at(system, t),
            Turn::Rod => rod::turn(system, t) * start,
            Turn::Sphere => sphere::turn(system, t) * start,
            Turn::Symmetric => symmetric::turned(system, t),
            Turn::Separatrix(separatrix) => separatrix.turned(system, t),
            Turn::Asymmetric => asymmetric::turned(system, t),
        };
        if let Turn::Rod = self {
            return (orientation, rod::spin(system));
        }
        let principal = orientation * system.body.principal;
        let momentum = principal.inverse_transform_vector(&system.start.angular_momentum);
        (orientation, principal * momentum.component_div(&system.body.moments))
    }
}

/// The orientation that a turn Q in principal axes leads to.
fn after(system: &System, turn: &Rotation) -> Rotation {
    let principal = system.body.principal;
    rotation::renormalized(system.start.orientation * principal * turn * principal.inverse())
}

/// L in principal axes at t = 0 [kg m²/s].
fn principal_momentum(system: &System) -> Vector3<f64> {
    let principal = system.start.orientation * system.body.principal;
    principal.inverse_transform_vector(&system.start.angular_momentum)
}
