//! The floor of an error: what rounding and the reference leave undecided.
//!
//! Rounding is measured twice. The start is moved a little in fixed directions, and the growth of the difference over the run says
//! what a rounding of each step becomes. n steps leave about √n roundings, but n of them where every step is the same and
//! rounds the same way: the rotation in a steady spin, the translation under a constant force. The rounding of h turns
//! the phase by u |Ω| T. Then the same run is made in turned worlds: the motion is the same, every rounding is another, and how far
//! they end from one another is what rounding does, however its parts add up. From the steps of that run to more of them it grows as the
//! root of their number or, where steps round alike for a while without being the same, as the number itself: the larger one is
//! taken, and where an error is clear of its floor by the one and not by the other, the runs are drawn anew at that very step.
//! More than n roundings, and what n solves of an implicit equation leave, there cannot be: beyond that a difference is a defect. A run
//! whose start is a few rounding units off has other roundings too, and no defect shows there but as one, so that it counts as it is.
//!
//! In steps of many radians a rounding within the step may grow by powers of the angle before the step is over. There the
//! whole rounding is measured: the same run in turned worlds differs from itself by nothing else.

use nalgebra::Vector3;

use super::drawn::Drawn;
use super::moved_starts::{DIRECTIONS, displaced, reach};
use super::{Reading, largest};
use crate::model::body::Shape;
use crate::model::{PerQuantity, Quantity, Snapshot, System};
use crate::reference::Reference;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Sizes of the displacements that measure how roundings grow, relative: the first that does not grow to the size of the motion.
const DISPLACEMENTS: [f64; 3] = [1e-7, 1e-10, 1e-13];
/// Part of the motion's size from which on a difference no longer grows as a small one would.
const SATURATED: f64 = 0.05;
/// Turned worlds that roundings are measured in: the largest of a few samples is too small as often as they are few.
pub(super) const TURNS: [Vector3<f64>; 5] = [
    Vector3::new(0.9, -1.3, 0.4),
    Vector3::new(-0.2, 0.7, 1.9),
    Vector3::new(2.1, 0.3, -0.8),
    Vector3::new(-1.1, -0.6, 0.5),
    Vector3::new(0.3, 1.6, -1.4),
];
/// What the iteration of an implicit equation may leave, relative.
pub(super) const SOLVED_TO: f64 = 1e-12;
/// Roundings of a step, at most, that are all of one sign: those of Ω = I⁻¹ L, of the rotation and of its product, some sums of three
/// each.
const A_STEP: f64 = 8.0;
/// Relative difference of two moments below which they are one.
const ONE_MOMENT: f64 = 1e-9;

/// What rounding does to the runs of a scheme in a scene.
pub(super) struct Rounding {
    growth: PerQuantity<Reading>,
    drawn: Drawn,
    solves_of_step: f64,
}

impl Rounding {
    /// Measured in the steps of a plan. `motion` says how large everything gets.
    pub fn measure(contestant: &Contestant, system: &System, motion: &[Snapshot], plan: &Plan) -> Rounding {
        let own = contestant.run(system, Form::Least, plan);
        Rounding {
            growth: growth_beside(contestant, system, motion, plan, &own.states),
            drawn: Drawn::of(contestant, system, motion, plan, &own.states),
            solves_of_step: own.outcome.solves as f64 / own.outcome.steps.max(1) as f64,
        }
    }

    /// Draws anew in the steps of another plan, which `own` is the run of.
    pub fn draw_again(
        &mut self,
        contestant: &Contestant,
        system: &System,
        motion: &[Snapshot],
        plan: &Plan,
        own: &[Snapshot],
    ) {
        self.drawn = Drawn::of(contestant, system, motion, plan, own);
    }

    /// Floors of a run of `steps` steps over `turned` radians, with roundings that add up as the law says from the run on that
    /// they were drawn in.
    pub fn floors(
        &self,
        system: &System,
        reference: &Reference,
        steps: u64,
        turned: f64,
        law: Adding,
    ) -> PerQuantity<Reading> {
        floors(system, reference, &self.growth, roundings(system, steps, turned))
            .zip(self.drawn_at(steps, law))
            .map(|(floor, drawn)| floor.or(drawn))
    }

    /// How many times larger a relative displacement of the start gets.
    pub fn growth(&self) -> &PerQuantity<Reading> {
        &self.growth
    }

    /// What rounding does to a run of so many steps, as it was drawn.
    pub fn drawn_at(&self, steps: u64, law: Adding) -> PerQuantity<Reading> {
        let more = steps as f64 / self.drawn.steps as f64;
        let more = if law == Adding::Alike { more.max(more.sqrt()) } else { more.sqrt() };
        let most = steps as f64 * (A_STEP * f64::EPSILON + self.solves_of_step * SOLVED_TO);
        PerQuantity::of(|quantity| {
            let (turned, shaken) = (&self.drawn.turned[quantity], &self.drawn.shaken[quantity]);
            let growth = &self.growth[quantity];
            Reading {
                end: (more * turned.end).min(most * growth.end).max(more * shaken.end),
                max: (more * turned.max).min(most * growth.max).max(more * shaken.max),
            }
        })
    }
}

/// How roundings of one step add to those of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Adding {
    /// As the root of their number: no two of them are alike.
    Unlike,
    /// As their number.
    Alike,
}

/// How many times larger a relative displacement of the start is at the end and at its largest, per quantity. `motion` says how
/// large everything gets.
pub(super) fn rounding_growth(
    contestant: &Contestant,
    system: &System,
    motion: &[Snapshot],
    plan: &Plan,
) -> PerQuantity<Reading> {
    let own = contestant.run(system, Form::Least, plan).states;
    growth_beside(contestant, system, motion, plan, &own)
}

/// The same beside a run that there is.
fn growth_beside(
    contestant: &Contestant,
    system: &System,
    motion: &[Snapshot],
    plan: &Plan,
    own: &[Snapshot],
) -> PerQuantity<Reading> {
    let mut grown = PerQuantity::all(Reading::ZERO);
    for displacement in DISPLACEMENTS {
        grown = PerQuantity::all(Reading::ZERO);
        let mut furthest: f64 = 0.0;
        for direction in 0..DIRECTIONS {
            let displaced = displaced(system, motion, direction, displacement);
            let moved = contestant.run(&displaced, Form::Least, plan);
            let by = largest(system, &moved.states, own);
            let (turned, shifted) = (by[Quantity::Orientation].max, by[Quantity::Position].max);
            furthest = furthest.max(turned).max(shifted / reach(system, motion));
            let growth = by.map(|by| Reading { end: by.end / displacement, max: by.max / displacement });
            grown = grown.zip(growth).map(|(grown, growth)| grown.or(growth));
        }
        if furthest < SATURATED {
            break;
        }
    }
    grown
}

/// What the roundings of `steps` steps over `turned` radians, of the body and of the forces' own clock, add up to, relative, for each
/// quantity. In a steady spin the part of
/// L across its axis is one more of them: the start is as steady as its numbers.
pub(super) fn roundings(system: &System, steps: u64, turned: f64) -> PerQuantity<f64> {
    let steps = steps as f64;
    let add = |alike: bool| f64::EPSILON * (if alike { steps } else { steps.sqrt() } + 0.5 * turned);
    let (constant_force, _) = system.constant_force();
    let steady = system.steady_spin();
    let across = if steady { across_the_axis(system) } else { 0.0 };
    let (translation, rotation) = (add(constant_force), add(steady) + across);
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position | Quantity::Velocity => translation,
        Quantity::Orientation | Quantity::AngularVelocity | Quantity::AngularMomentum => rotation,
        Quantity::BodyPoint => translation.max(rotation),
    })
}

/// Part of L across the principal axis that it is nearest to, over |L|; along axes of the same moment is not across.
fn across_the_axis(system: &System) -> f64 {
    let (body, start) = (&system.body, &system.start);
    let momentum = (start.orientation * body.principal).inverse_transform_vector(&start.angular_momentum);
    let length = rotation::length(&momentum);
    if body.shape != Shape::Extended || length == 0.0 {
        return 0.0;
    }
    let moment = body.moments[momentum.iamax()];
    let across = Vector3::from_fn(|axis, _| {
        let other = (body.moments[axis] - moment).abs() > ONE_MOMENT * moment;
        if other { momentum[axis] } else { 0.0 }
    });
    rotation::length(&across) / length
}

/// A rounding unit of the largest that each quantity is over the run. Of what has come to rest nothing finer can be asked: an
/// implicit equation, for one, is solved to a part of the state that it is solved in.
fn units(system: &System, reference: &Reference) -> PerQuantity<f64> {
    let largest = |value: fn(&Snapshot) -> f64| reference.states.iter().map(value).fold(0.0, super::larger);
    let position = largest(|s| rotation::length(&s.position));
    let sizes = PerQuantity::of(|quantity| match quantity {
        Quantity::Position => position,
        Quantity::Velocity => largest(|s| rotation::length(&s.velocity)),
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => largest(|s| rotation::length(&s.angular_velocity)),
        Quantity::AngularMomentum => largest(|s| rotation::length(&s.angular_momentum)),
        Quantity::BodyPoint => position + system.body.extent(),
    });
    sizes.map(|size| if size.is_finite() { f64::EPSILON * size } else { 0.0 })
}

/// The largest of the reference's uncertainty, what roundings become, and a rounding unit.
///
/// A body point is off by no more than the centre of mass and the body's size times the angle, and the two may have very different
/// roundings.
pub(super) fn floors(
    system: &System,
    reference: &Reference,
    growth: &PerQuantity<Reading>,
    roundings: PerQuantity<f64>,
) -> PerQuantity<Reading> {
    let last = reference.uncertainty[reference.uncertainty.len() - 1];
    let mut floors = *growth;
    let size = 2.0 * system.body.extent();
    let of_point = |place: fn(&Reading) -> f64| {
        let left = |quantity| place(&growth[quantity]) * roundings[quantity];
        let growth_of_turn = size * place(&growth[Quantity::Orientation]);
        let of_parts = left(Quantity::Position) + growth_of_turn * roundings[Quantity::Orientation];
        of_parts.min(left(Quantity::BodyPoint)) / roundings[Quantity::BodyPoint]
    };
    floors[Quantity::BodyPoint] =
        Reading { end: of_point(|reading| reading.end), max: of_point(|reading| reading.max) };
    let units = units(system, reference);
    PerQuantity::of(|quantity| {
        let (floor, rounding, unit) = (floors[quantity], roundings[quantity], units[quantity]);
        let largest = reference.uncertainty.iter().map(|u| u[quantity]).fold(0.0, f64::max);
        Reading {
            end: (floor.end * rounding).max(last[quantity]).max(unit),
            max: (floor.max * rounding).max(largest).max(unit),
        }
    })
}
