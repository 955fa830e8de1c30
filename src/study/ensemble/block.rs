//! Members of an ensemble run together: free bodies and tops, each at its own step, side by side.

use std::time::Instant;

use nalgebra::{Quaternion, Vector3};

use super::Member;
use super::lanes::{self, Lane, Way};
use crate::arithmetic::Registers;
use crate::interrupt;
use crate::model::{AnyModel, Free, Rotor, Snapshot, System, Turning};
use crate::rotation::Rotation;
use crate::schemes::SideBySide;
use crate::simulate::Outcome;

/// Steps between two checks that the attitudes are finite.
const CHECKED_EVERY: u64 = 1024;

/// What runs side by side: bodies that only turn, free or with a pivot under their weight.
pub(super) enum Body {
    Free(Free),
    /// A top and its weight M g [N], world, and its centre of mass from the pivot [m], principal axes.
    Top(Rotor, Vector3<f64>, Vector3<f64>),
}

impl Body {
    /// The body of a system, if it is one of these.
    pub(super) fn of(system: &System) -> Option<Body> {
        match (system.least(), system.forces.laws()) {
            (AnyModel::Free(model), _) => Some(Body::Free(model)),
            (AnyModel::Pivot(model), [law]) => {
                let center = system.body.principal.inverse() * system.body.center;
                Some(Body::Top(model, law.uniform_acceleration()? * system.body.mass, center))
            }
            _ => None,
        }
    }
}

/// A member with its body.
pub(super) struct Guest<'a> {
    pub(super) index: usize,
    pub(super) member: &'a Member,
    pub(super) body: Body,
}

impl Guest<'_> {
    fn lane(&self) -> Lane {
        let step = self.member.plan.step;
        match &self.body {
            Body::Free(model) => {
                let lane = turning(model);
                let ahead = model.moving(step).seen_from(lane.attitude);
                Lane { step, ahead, largest: model.turns_little(step).unwrap_or(0.0), ..lane }
            }
            Body::Top(model, weight, center) => {
                Lane { step, weight: (*weight).into(), center: (*center).into(), ..turning(model) }
            }
        }
    }

    /// In which form the scheme steps the body.
    pub(super) fn way(&self, scheme: SideBySide) -> Way {
        match &self.body {
            Body::Free(model)
                if scheme == SideBySide::PeskinRk2 && model.turns_little(self.member.plan.step).is_some() =>
            {
                Way::MovingAxes
            }
            _ => Way::Page(scheme),
        }
    }

    fn every(&self) -> u64 {
        self.member.plan.every.max(1)
    }

    /// Whether the state after so many steps is one to be seen.
    fn shows(&self, step: u64) -> bool {
        let steps = self.member.plan.steps;
        step == steps || (step < steps && step.is_multiple_of(self.every()))
    }

    /// The next step after this one whose state is to be seen, if any.
    fn next(&self, step: u64) -> Option<u64> {
        let steps = self.member.plan.steps;
        (step < steps).then(|| steps.min((step / self.every() + 1).saturating_mul(self.every())))
    }

    fn observe(&self, step: u64, lane: &Lane) -> Option<Snapshot> {
        let t = step as f64 * self.member.plan.step;
        match &self.body {
            Body::Free(model) => observe(model, t, lane),
            Body::Top(model, ..) => observe(model, t, lane),
        }
    }
}

/// What a lane needs of a body that turns.
fn turning<M: Turning<Real = f64>>(model: &M) -> Lane {
    let start = model.start();
    let q = model.attitude(&start);
    Lane {
        attitude: [q.w, q.i, q.j, q.k],
        momentum: model.momentum(&start).into(),
        inverse_moments: model.rotational().inverse_moments.into(),
        ..Lane::default()
    }
}

fn observe<M: Turning<Real = f64>>(model: &M, t: f64, lane: &Lane) -> Option<Snapshot> {
    let [w, x, y, z] = lane.attitude;
    let mut state = model.start();
    model.place(&mut state, Rotation::new_unchecked(Quaternion::new(w, x, y, z)), lane.momentum.into());
    model.observe(t, &state).ok()
}

/// Runs all of them, which step in one form; `None` where one has to run alone: it turned by more than a radian in a step, or broke, or the
/// user asked for the end.
pub(super) fn run<T>(
    scheme: SideBySide,
    registers: Registers,
    guests: &[Guest],
    begin: &impl Fn(usize) -> T,
    see: &impl Fn(&mut T, &Snapshot),
) -> Option<Vec<(T, Outcome)>> {
    let way = guests.first()?.way(scheme);
    let mut lanes: Vec<Lane> = guests.iter().map(Guest::lane).collect();
    let mut kept: Vec<T> = guests.iter().map(|guest| begin(guest.index)).collect();
    let mut nanoseconds = vec![0.0; guests.len()];
    let mut now = 0;
    loop {
        for ((guest, lane), kept) in guests.iter().zip(&lanes).zip(&mut kept) {
            if guest.shows(now) {
                see(kept, &guest.observe(now, lane)?);
            }
        }
        let Some(next) = guests.iter().filter_map(|guest| guest.next(now)).min() else { break };
        let target = next.min(now + CHECKED_EVERY);
        let before = Instant::now();
        let within = lanes::advance(registers, way, target - now, &mut lanes);
        let running = guests.iter().filter(|guest| guest.member.plan.steps > now).count();
        let share = before.elapsed().as_nanos() as f64 / running as f64;
        for (guest, nanoseconds) in guests.iter().zip(&mut nanoseconds) {
            *nanoseconds += if guest.member.plan.steps > now { share } else { 0.0 };
        }
        let finite =
            lanes.iter().all(|lane| lane.attitude.iter().chain(&lane.momentum).all(|part| part.is_finite()));
        if !within || !finite || interrupt::requested() {
            return None;
        }
        now = target;
    }
    let outcome = |(guest, nanoseconds): (&Guest, f64)| {
        let steps = guest.member.plan.steps;
        let evaluations = steps * scheme.evaluations();
        Outcome { steps, evaluations, nanoseconds: nanoseconds as u64, ..Outcome::none_yet() }
    };
    Some(kept.into_iter().zip(guests.iter().zip(nanoseconds).map(outcome)).collect())
}
