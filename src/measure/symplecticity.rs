//! Whether one step is symplectic: its derivative D leaves the canonical two-form where it was.
//!
//! Displacements of a state are (φ, δL, δx, δv): turned by φ (world axes), L and the translation changed. The canonical
//! one-form of the rotation is θ = L·φ, that of the translation M v·dx, and the two-form is ω = −dθ. Turns about world axes do not
//! commute, [φ₁, φ₂] = −φ₁ × φ₂, which gives the last term of
//!
//! ```text
//! (1)  ω(1, 2) = φ₁·δL₂ − φ₂·δL₁ − L·(φ₁ × φ₂) + M (δx₁·δv₂ − δx₂·δv₁)
//! (2)  D = derivative of one step, by differences at ±ε and ±2ε: error ε⁴/30, and 1.5 rounding units over ε
//! (3)  defect = max |ω(D e_i, D e_j) at the end − ω(e_i, e_j) at the start|, over the action of the motion
//! ```
//!
//! A scheme of the list is differentiated in double-double, with ε = 1e-6: both errors are below 1e-24. What f64 rounds off is no part of it.
//! A program is differentiated in f64, with ε = 1e-3.
//!
//! Source: the canonical form of T*SO(3) in world axes, Marsden and Ratiu, Introduction to Mechanics and Symmetry.

use nalgebra::Vector3;

use super::{Rung, copies, steady_rung};
use crate::arithmetic::{DoubleDouble, Real};
use crate::model::body::Shape;
use crate::model::{Quantity, Snapshot, Start, System, sizes};
use crate::record::Symplecticity;
use crate::rotation;
use crate::simulate::{Arithmetic, Contestant, Form, Plan};

/// Radians turned by the step, at most.
const TURN: f64 = 0.5;
/// ε in f64, where both errors are about as large, …
const DISPLACEMENT: f64 = 1e-3;

/// … and in another arithmetic: displacements are this part of what changes Ω by itself.
fn displacement<T: Real>() -> f64 {
    DISPLACEMENT * (T::UNIT / f64::EPSILON).powf(0.2)
}

/// A displacement of a state, or the difference of two.
#[derive(Clone, Copy, Debug)]
struct Displacement<T: Real = f64> {
    turn: Vector3<T>,
    momentum: Vector3<T>,
    position: Vector3<T>,
    velocity: Vector3<T>,
}

/// Differentiates one step; `None` where the motion has no canonical form that is known here: rods and
/// points, forces without potential or with a velocity in them, a body at rest.
pub fn symplecticity(contestant: &Contestant, system: &System, rungs: &[Rung]) -> Option<Symplecticity> {
    let momentum = rotation::length(&system.start.angular_momentum);
    let spin = 2.0 * rotational_energy(system) / momentum;
    if system.body.shape != Shape::Extended
        || !system.forces.conservative()
        || system.forces.read_velocity()
        || !(spin > 0.0 && spin.is_finite())
    {
        return None;
    }
    let step = steady_rung(contestant, system, rungs, 1)?.step.min(TURN / spin);
    // What turn, and what change of L over |L|, changes Ω by no more than itself in a body of unlike moments.
    let unit = (system.body.moments.min() * spin / momentum).min(1.0);
    let directions = directions(system, spin, unit);
    let of = |start: &System| defect(contestant, start, &directions, step);
    let own = of(system)?;
    let end = contestant.run(system, Form::Least, &Plan { step, steps: 1, every: 1 }).states;
    let copies = copies::starts(system, &end, f64::EPSILON, false);
    let off = copies.iter().map(|copy| of(copy).map_or(f64::INFINITY, |defect| (defect - own).abs()));
    let over = momentum * unit * unit; // (3)
    // A rounding of the position at least, over its displacement: copies on the same grid of numbers round alike.
    let reach = sizes(system, &end)[Quantity::Position];
    let of_position = if system.body.pivoted {
        0.0
    } else {
        f64::EPSILON * reach / (DISPLACEMENT * (momentum / (system.body.mass * spin)).sqrt() * unit)
    };
    let rounding = (off.fold(0.0, super::larger) / over).max(of_position);
    if !contestant.runs_in_double_double() {
        return Some(Symplecticity { step, defect: own / over, unit, rounding, double_double: false });
    }
    let precise = System::<DoubleDouble>::of(system).ok()?;
    let directions: Vec<_> = directions.iter().map(Displacement::of).collect();
    let own = defect(contestant, &precise, &directions, step)?;
    // The condition of the step is that of f64; its unit over ε is that of the arithmetic.
    let finer = DoubleDouble::UNIT / displacement::<DoubleDouble>() / (f64::EPSILON / DISPLACEMENT);
    Some(Symplecticity { step, defect: own / over, unit, rounding: rounding * finer, double_double: true })
}

/// The largest change of the form by a step; `None` where a step breaks.
fn defect<T: Arithmetic>(
    contestant: &Contestant,
    system: &System<T>,
    directions: &[Displacement<T>],
    step: f64,
) -> Option<f64> {
    let plan = Plan { step, steps: 1, every: 1 };
    let one_step = |system: &System<T>| {
        let mut end = None;
        let outcome = contestant.stream_in(system, Form::Least, &plan, &mut |state| end = Some(*state));
        end.filter(|_| outcome.broken.is_none())
    };
    let end = one_step(system)?;
    let size = T::of(displacement::<T>());
    let mut derivative = Vec::with_capacity(directions.len());
    for direction in directions {
        let moved = |by: f64| {
            let displaced = displaced(system, &direction.scaled(size * by));
            one_step(&displaced).map(|state| apart(&state, &end))
        };
        let (near, back) = (moved(1.0)?, moved(-1.0)?);
        let (far, far_back) = (moved(2.0)?, moved(-2.0)?);
        let (once, twice) = (near.minus(&back).scaled(T::of(8.0)), far.minus(&far_back)); // (2)
        derivative.push(once.minus(&twice).scaled(T::one() / (size * 12.0)));
    }
    // A pivot holds the translation: it is no coordinate.
    let mass = if system.body.pivoted { T::zero() } else { system.body.mass };
    let mut defect: f64 = 0.0;
    for (i, first) in directions.iter().enumerate() {
        for (j, second) in directions.iter().enumerate().skip(i + 1) {
            let before = form(mass, &system.start.angular_momentum, first, second);
            let after = form(mass, &end.angular_momentum, &derivative[i], &derivative[j]);
            defect = super::larger(defect, (after - before).to_f64().abs());
        }
    }
    Some(defect)
}

/// ω.
fn form<T: Real>(mass: T, momentum: &Vector3<T>, a: &Displacement<T>, b: &Displacement<T>) -> T {
    a.turn.dot(&b.momentum) - b.turn.dot(&a.momentum) - momentum.dot(&a.turn.cross(&b.turn))
        + mass * (a.position.dot(&b.velocity) - b.position.dot(&a.velocity)) // (1)
}

impl<T: Real> Displacement<T> {
    fn of(displacement: &Displacement) -> Displacement<T> {
        Displacement {
            turn: displacement.turn.map(T::of),
            momentum: displacement.momentum.map(T::of),
            position: displacement.position.map(T::of),
            velocity: displacement.velocity.map(T::of),
        }
    }

    fn zero() -> Displacement<T> {
        let zero = Vector3::zeros();
        Displacement { turn: zero, momentum: zero, position: zero, velocity: zero }
    }

    fn scaled(&self, by: T) -> Displacement<T> {
        Displacement {
            turn: self.turn * by,
            momentum: self.momentum * by,
            position: self.position * by,
            velocity: self.velocity * by,
        }
    }

    fn minus(&self, other: &Displacement<T>) -> Displacement<T> {
        Displacement {
            turn: self.turn - other.turn,
            momentum: self.momentum - other.momentum,
            position: self.position - other.position,
            velocity: self.velocity - other.velocity,
        }
    }
}

/// ½ Ω·L at the start [J].
fn rotational_energy(system: &System) -> f64 {
    let momentum = system.start.orientation.inverse_transform_vector(&system.start.angular_momentum);
    0.5 * momentum.dot(&(system.body.inverse_inertia() * momentum))
}

/// `unit` radians about each axis, so much of |L| along each, and where the body is not held, a length and a velocity whose action is of the size
/// of |L|.
fn directions(system: &System, spin: f64, unit: f64) -> Vec<Displacement> {
    let momentum = rotation::length(&system.start.angular_momentum);
    let length = (momentum / (system.body.mass * spin)).sqrt() * unit;
    let zero = Displacement::zero();
    let mut directions = Vec::new();
    for axis in 0..3 {
        let along = Vector3::ith(axis, 1.0);
        directions.push(Displacement { turn: along * unit, ..zero });
        directions.push(Displacement { momentum: along * (unit * momentum), ..zero });
        if !system.body.pivoted {
            directions.push(Displacement { position: along * length, ..zero });
            directions.push(Displacement { velocity: along * (length * spin), ..zero });
        }
    }
    directions
}

fn displaced<T: Real>(system: &System<T>, by: &Displacement<T>) -> System<T> {
    let change = Start {
        position: by.position,
        velocity: by.velocity,
        angular_momentum: by.momentum,
        orientation: system.start.orientation,
    };
    system.displaced(&by.turn, &change)
}

fn apart<T: Real>(state: &Snapshot<T>, from: &Snapshot<T>) -> Displacement<T> {
    Displacement {
        turn: (state.orientation * from.orientation.inverse()).scaled_axis(),
        momentum: state.angular_momentum - from.angular_momentum,
        position: state.position - from.position,
        velocity: state.velocity - from.velocity,
    }
}
