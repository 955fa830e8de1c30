//! The spring-held body at rest: a small displacement of it grows or dies, and linear theory says from which step on.
//!
//! Body and spring are those of a scene; its other forces and its spin are left out, so that the point hangs at its anchor and
//! every scheme meets the same linear problem. The growth a step is read from the energy: the largest over the last half of the
//! run against the largest over the half before it.

use nalgebra::Vector3;

use super::failure::Failure;
use super::theory;
use crate::model::forces::{Attachment, Law, Spring};
use crate::model::{Snapshot, Spin, System};
use crate::rotation::Rotation;
use crate::simulate::{Contestant, Form, Outcome, Plan};
use crate::study::ensemble::{Ensemble, Member};

/// Displacement [m]: so small that the motion is linear to its square, so large that rounding is nothing to it.
const DISPLACEMENT: [f64; 3] = [1e-3, 0.3e-3, 0.5e-3];
/// Energy over its start below which the displacement has died, and what follows is of no interest: implicit schemes, whose
/// iterations end by relative changes, no longer end them at rest.
const DIED: f64 = 1e-8;
/// Energy over its start below which it is dying, if the run breaks then.
const DYING: f64 = 0.1;
/// Energy over its start above which it has grown for good: further on the motion is no longer linear.
const GROWN: f64 = 1e4;
/// Growth a step that counts as none: a displacement then takes 1e4 steps to grow e-fold.
pub const NO_GROWTH: f64 = 1e-4;
/// Steps of a run.
const STEPS: u64 = 2_000;
/// Smallest and largest h·ω tried.
const RANGE: (f64, f64) = (0.02, 64.0);
/// Ratio of successive steps of the scan, and to which the bisection closes in.
const SCAN: f64 = 1.25;
/// Closeness of the bisection.
const CLOSE: f64 = 1.0005;

/// A body held by one spring and damper, at rest.
#[derive(Clone, Debug)]
pub struct Bench {
    /// The body at rest, a little displaced.
    pub system: System,
    /// ω of the stiffest mode [rad/s].
    pub omega: f64,
    /// ζ of that mode.
    pub zeta: f64,
}

/// What became of a small displacement.
#[derive(Clone, Debug, PartialEq)]
pub enum Growth {
    /// Its logarithmic growth a step.
    Rate(f64),
    /// The run broke before it had grown or died.
    Broke(Failure),
}

impl Growth {
    /// Whether the displacement does not grow.
    pub fn is_stable(&self) -> bool {
        matches!(self, Growth::Rate(rate) if *rate <= NO_GROWTH)
    }
}

/// Energies of the displacement as a run goes on.
#[derive(Clone, Copy, Debug)]
pub struct Amplitude {
    first: f64,
    /// Largest over the second quarter and over the second half of the run.
    before: f64,
    last: f64,
    half: f64,
    latest: f64,
    seen: u64,
    died: Option<u64>,
    grown: Option<u64>,
}

impl Amplitude {
    /// Of a run that ends at `end` [s].
    pub fn new(end: f64) -> Amplitude {
        Amplitude {
            first: 0.0,
            before: 0.0,
            last: 0.0,
            half: end / 2.0,
            latest: 0.0,
            seen: 0,
            died: None,
            grown: None,
        }
    }

    /// Takes the energy after the next step; the first is that of the start.
    pub fn push(&mut self, time: f64, energy: f64) {
        if self.seen == 0 {
            self.first = energy;
        }
        if energy <= DIED * self.first && self.grown.is_none() {
            self.died.get_or_insert(self.seen);
        }
        if energy >= GROWN * self.first && self.died.is_none() {
            self.grown.get_or_insert(self.seen);
        }
        self.seen += 1;
        self.latest = energy;
        let window = if time >= self.half {
            &mut self.last
        } else if time >= self.half / 2.0 {
            &mut self.before
        } else {
            // What dies in the first quarter is not the mode that lasts.
            return;
        };
        *window = window.max(energy);
    }

    /// What became of it in a run of so many steps. The energy goes as the square of the displacement.
    pub fn growth(&self, steps: u64, outcome: &Outcome) -> Growth {
        if let Some(died) = self.died {
            return Growth::Rate(DIED.ln() / (2 * died.max(1)) as f64);
        }
        if let Some(grown) = self.grown {
            return Growth::Rate(GROWN.ln() / (2 * grown.max(1)) as f64);
        }
        if let Some(broken) = &outcome.broken {
            let failure = Failure::of_break(broken.step, &broken.why);
            // An iteration that ends by relative changes cannot end near rest: by then the displacement was dying.
            return match failure {
                Failure::SolveFails { .. } if self.latest <= DYING * self.first => {
                    Growth::Rate((self.latest / self.first).ln() / (2 * self.seen.max(1)) as f64)
                }
                failure => Growth::Broke(failure),
            };
        }
        // The largest of a growing energy stand at the ends of the two windows, half a run apart.
        let rate = (self.last / self.before).ln() / steps as f64;
        if rate.is_finite() { Growth::Rate(rate) } else { Growth::Broke(Failure::NotFinite { step: steps }) }
    }
}

impl Bench {
    /// The body and the first spring of a scene; `None` where it has none, or the spring has a rest length.
    pub fn of(system: &System) -> Option<Bench> {
        let spring = system.forces.laws().iter().find_map(|law| match law {
            Law::Spring(spring) if spring.rest_length == 0.0 => Some(spring.clone()),
            _ => None,
        })?;
        (!system.body.pivoted).then(|| Bench::with(system, spring))?
    }

    /// The same body on a spring of another stiffness [N/m] and damping [N s/m].
    pub fn changed(&self, stiffness: f64, damping: f64) -> Option<Bench> {
        let spring = self.system.forces.laws().iter().find_map(|law| match law {
            Law::Spring(spring) => Some(Spring { stiffness, damping, ..spring.clone() }),
            _ => None,
        })?;
        Bench::with(&self.system, spring)
    }

    fn with(system: &System, spring: Spring) -> Option<Bench> {
        let arm = match &spring.attachment {
            Attachment::Point(index) => system.body.points[*index].position,
            Attachment::At(position) => *position,
        };
        let at_rest = |position| {
            let laws = vec![Law::Spring(spring.clone())];
            let spin = Spin::Velocity(Vector3::zeros());
            System::new(system.body.clone(), laws, position, Rotation::identity(), Vector3::zeros(), spin)
                .ok()
        };
        let still = at_rest(spring.anchor - arm)?;
        let stiffest = theory::mobilities(&still, &arm).max();
        let omega = (spring.stiffness * stiffest).sqrt();
        Some(Bench {
            system: at_rest(spring.anchor - arm + Vector3::from(DISPLACEMENT))?,
            omega,
            zeta: spring.damping * stiffest / (2.0 * omega),
        })
    }

    /// Growth of the displacement at a step h = a/ω.
    pub fn growth(&self, contestant: &Contestant, a: f64, steps: u64) -> Growth {
        let plan = Plan { step: a / self.omega, steps, every: 1 };
        let mut amplitude = Amplitude::new(plan.step * steps as f64);
        let energy = Energy::of(&self.system);
        let outcome = contestant.stream(&self.system, Form::Least, &plan, &mut |state| {
            amplitude.push(state.time, energy.at(state));
        });
        amplitude.growth(steps, &outcome)
    }

    /// The largest stable h·ω with what happens above it: a scan up from small steps, then bisection.
    pub fn limit(&self, contestant: &Contestant) -> (Option<f64>, Option<Growth>) {
        let (mut low, mut high) = (RANGE.0, RANGE.0);
        let mut above = self.growth(contestant, low, STEPS);
        if !above.is_stable() {
            return (None, Some(above));
        }
        while above.is_stable() {
            low = high;
            high *= SCAN;
            if high > RANGE.1 {
                return (None, None);
            }
            above = self.growth(contestant, high, STEPS);
        }
        while high / low > CLOSE {
            let middle = (low * high).sqrt();
            let growth = self.growth(contestant, middle, STEPS);
            if growth.is_stable() {
                low = middle;
            } else {
                high = middle;
                above = growth;
            }
        }
        (Some(low), Some(above))
    }

    /// Growth for many benches and steps at once, each of them [s].
    pub fn growths(contestant: &Contestant, members: &[(Bench, f64)], steps: u64) -> Vec<Growth> {
        let plan = |step: f64| Plan { step, steps, every: 1 };
        let ensemble = Ensemble::new(
            contestant,
            members
                .iter()
                .map(|(bench, h)| Member { system: bench.system.clone(), plan: plan(*h) })
                .collect(),
        );
        let begin = |index: usize| {
            let (bench, h) = &members[index];
            (Amplitude::new(h * steps as f64), Energy::of(&bench.system))
        };
        let ends = ensemble.fold(begin, |(amplitude, energy), state| {
            amplitude.push(state.time, energy.at(state));
        });
        ends.iter().map(|((amplitude, _), outcome)| amplitude.growth(steps, outcome)).collect()
    }
}

/// Energy of the oscillation of the point that is held, ½ (u²/μ + k s²): a slow turn about the anchor, which no spring resists and
/// no damper stops, is none of it.
#[derive(Clone, Debug)]
struct Energy {
    /// 1/μ [kg].
    mass: f64,
    arm: Vector3<f64>,
    anchor: Vector3<f64>,
    stiffness: f64,
}

impl Energy {
    fn of(system: &System) -> Energy {
        let spring = system.forces.laws().iter().find_map(|law| match law {
            Law::Spring(spring) => Some(spring),
            _ => None,
        });
        let (arm, anchor, stiffness) = spring.map_or((Vector3::zeros(), Vector3::zeros(), 0.0), |spring| {
            let arm = match &spring.attachment {
                Attachment::Point(index) => system.body.points[*index].position,
                Attachment::At(position) => *position,
            };
            (arm, spring.anchor, spring.stiffness)
        });
        let mass = 1.0 / theory::mobilities(system, &arm).max();
        Energy { mass, arm, anchor, stiffness }
    }

    fn at(&self, state: &Snapshot) -> f64 {
        let arm = state.orientation * self.arm;
        let stretch = state.position + arm - self.anchor;
        let velocity = state.velocity + state.angular_velocity.cross(&arm);
        0.5 * (self.mass * velocity.norm_squared() + self.stiffness * stretch.norm_squared())
    }
}
