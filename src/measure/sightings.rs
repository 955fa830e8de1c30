//! Runs as the rule of orders reads them: error vectors at the sample times, and how far copies of each run are from it.
//!
//! A copy starts a few units in the last place off: after its first step every rounding of it is another one (stochastic arithmetic;
//! Vignes' CESTAC is the published ancestor). A program that computes in single precision is moved by units of that.
//!
//! Every quantity is a vector in which errors add: the orientation stands as the rotation matrix over √2, whose difference has the
//! length of the angle where that is small, and the direction of a rod as itself.

use nalgebra::Vector3;

use super::cause::Cause;
use super::moved_starts::displaced;
use super::order::{Asked, CLEAR, Decision, Sighting, decide};
use crate::model::body::{Body, Shape};
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::reference::Reference;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan, Program, Trajectory};

/// Copies of every run.
const COPIES: usize = 3;
/// Units in the last place that a copy's start is off by.
const OFF: f64 = 4.0;
/// So many digits hold every double.
const ALL_DIGITS: usize = 16;

/// What the rule of orders says of a program under test.
#[derive(Clone, Debug)]
pub struct ByRule {
    /// Of each quantity.
    pub decisions: PerQuantity<Decision>,
    /// How far the first state is from the start of the scene, at most.
    pub start: PerQuantity<f64>,
    /// What the digits of the program allow it to be.
    pub allowed: PerQuantity<f64>,
    /// Size of each quantity over the motion.
    pub sizes: PerQuantity<f64>,
    /// What explains a run that converges to another motion.
    pub cause: Option<Cause>,
}

impl ByRule {
    /// Whether the program starts or ends elsewhere in any quantity.
    pub fn fails(&self) -> bool {
        let elsewhere = |decision: &Decision| matches!(decision, Decision::Elsewhere { .. });
        self.decisions.values().any(elsewhere)
            || self.start.iter().any(|(quantity, apart)| *apart > self.allowed[quantity])
    }
}

/// The runs of a contestant in a scene, quantity by quantity.
#[derive(Clone, Debug)]
pub(super) struct Sightings {
    times: Vec<f64>,
    runs: PerQuantity<Vec<Sighting>>,
    scales: PerQuantity<f64>,
    uncertainty: PerQuantity<f64>,
    unit: f64,
    /// Largest difference of a first state from the start of the scene.
    start: PerQuantity<f64>,
}

impl Sightings {
    /// None yet, of a motion whose first sample, its start, is left out.
    pub fn new(system: &System, reference: &Reference) -> Sightings {
        let runs = PerQuantity::of(|_| Vec::new());
        let uncertainty = reference.largest_uncertainty();
        let (scales, times) = (scales(system, &reference.states), reference.times[1..].to_vec());
        Sightings { times, runs, scales, uncertainty, unit: 0.0, start: PerQuantity::of(|_| 0.0) }
    }

    /// Takes in a run of a plan, with its copies.
    pub fn take_in(
        &mut self,
        contestant: &Contestant,
        (system, reference): (&System, &Reference),
        plan: &Plan,
        states: &[Snapshot],
    ) {
        let told = Told::by(contestant.program());
        self.unit = told.relative;
        if let (Some(first), Some(truth)) = (states.first(), reference.states.first()) {
            let apart = difference(&system.body, first, truth);
            self.start = PerQuantity::of(|quantity| self.start[quantity].max(apart[quantity]));
        }
        let copies: Vec<Trajectory> = (0..COPIES)
            .map(|way| displaced(system, &reference.states, way, OFF * told.arithmetic))
            .map(|start| contestant.run(&start, Form::Least, plan))
            .collect();
        for quantity in Quantity::ALL {
            let between = |a: &[Snapshot], b: &[Snapshot]| -> Vec<f64> {
                let pairs = a.iter().zip(b).skip(1);
                pairs.flat_map(|(a, b)| vector(&system.body, quantity, a, b)).collect()
            };
            let errors = between(states, &reference.states);
            let components = (errors.len() / self.times.len().max(1)).max(1);
            let mut rounding = vec![0.0f64; self.times.len()];
            for copy in &copies {
                let apart = between(&copy.states, states);
                for (largest, apart) in rounding.iter_mut().zip(apart.chunks(components)) {
                    *largest = largest.max(apart.iter().map(|x| x * x).sum::<f64>().sqrt());
                }
            }
            self.runs[quantity].push(Sighting { step: plan.step, steps: plan.steps, errors, rounding });
        }
    }

    /// What the rule says, and how far the first state is from the start.
    pub fn judged(&self, contestant: &Contestant) -> ByRule {
        let told = Told::by(contestant.program());
        let allowed = self.scales.map(|scale| CLEAR * (told.arithmetic + told.relative) * scale);
        ByRule { decisions: self.decisions(), start: self.start, allowed, sizes: self.scales, cause: None }
    }

    fn decisions(&self) -> PerQuantity<Decision> {
        PerQuantity::of(|quantity| {
            decide(&Asked {
                runs: &self.runs[quantity],
                times: &self.times,
                scale: self.scales[quantity],
                unit: self.unit,
                uncertainty: self.uncertainty[quantity],
            })
        })
    }
}

/// The difference of two moments in one quantity, as a vector in which errors add.
fn vector(body: &Body, quantity: Quantity, a: &Snapshot, b: &Snapshot) -> Vec<f64> {
    let of = |v: Vector3<f64>| vec![v.x, v.y, v.z];
    let turn =
        a.orientation.to_rotation_matrix().into_inner() - b.orientation.to_rotation_matrix().into_inner();
    match (quantity, &body.shape) {
        (Quantity::Position, _) => of(a.position - b.position),
        (Quantity::Velocity, _) => of(a.velocity - b.velocity),
        (Quantity::Orientation, Shape::Point) => vec![0.0],
        (Quantity::Orientation, Shape::Rod { direction }) => {
            of(turn * (direction / rotation::length(direction)))
        }
        (Quantity::Orientation, Shape::Extended) => {
            turn.iter().map(|x| x * std::f64::consts::FRAC_1_SQRT_2).collect()
        }
        (Quantity::AngularVelocity, _) => of(a.angular_velocity - b.angular_velocity),
        (Quantity::AngularMomentum, _) => of(a.angular_momentum - b.angular_momentum),
        (Quantity::BodyPoint, _) => {
            let shift = a.position - b.position;
            let ends = body.moments.map(|moment| (moment / body.mass).sqrt());
            (0..3).flat_map(|i| of(shift + turn * (body.principal * Vector3::ith(i, ends[i])))).collect()
        }
    }
}

/// Size of each quantity over the motion.
pub(super) fn scales(system: &System, motion: &[Snapshot]) -> PerQuantity<f64> {
    let largest = |value: fn(&Snapshot) -> f64| motion.iter().map(value).fold(0.0, f64::max);
    let (position, spin) =
        (largest(|s| rotation::length(&s.position)), largest(|s| rotation::length(&s.angular_velocity)));
    let extent = system.body.extent();
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position | Quantity::BodyPoint => position + extent,
        Quantity::Velocity => {
            largest(|s| rotation::length(&s.velocity)) + spin * rotation::length(&system.body.center)
        }
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => spin,
        Quantity::AngularMomentum => largest(|s| rotation::length(&s.angular_momentum)),
    })
}

/// In what units a program computes, and in what units it tells its states.
struct Told {
    /// Unit in the last place of its arithmetic, relative.
    arithmetic: f64,
    /// Half a unit in the last place that it prints, relative.
    relative: f64,
}

impl Told {
    fn by(program: Option<Program>) -> Told {
        let program = program.unwrap_or_default();
        if program.single_precision {
            return Told { arithmetic: f64::from(f32::EPSILON), relative: f64::from(f32::EPSILON) / 2.0 };
        }
        let few = program.digits > 0 && program.digits < ALL_DIGITS;
        let relative = if few { 0.5 * 10f64.powi(1 - program.digits as i32) } else { 0.0 };
        Told { arithmetic: f64::EPSILON, relative }
    }
}
