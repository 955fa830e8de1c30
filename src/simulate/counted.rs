//! A model that counts what is asked of it, at no cost that could be measured.

use std::cell::Cell;

use nalgebra::{Quaternion, Vector3};

use super::Outcome;
use crate::model::{Broken, Model, Pointwise, Rotational, Shortcut, Snapshot, Turning};
use crate::rotation::Rotation;

/// A model that counts the evaluations of its rates and the implicit equations solved on it.
pub(super) struct Counted<'a, M> {
    model: &'a M,
    evaluations: Cell<u64>,
    solves: Cell<u64>,
    iterations: Cell<u64>,
}

impl<'a, M> Counted<'a, M> {
    pub(super) fn new(model: &'a M) -> Counted<'a, M> {
        Counted { model, evaluations: Cell::new(0), solves: Cell::new(0), iterations: Cell::new(0) }
    }

    /// Goes on with another model of the same body.
    pub(super) fn switch(&mut self, model: &'a M) {
        self.model = model;
    }

    /// Puts what was counted into an outcome.
    pub(super) fn tell(&self, outcome: &mut Outcome) {
        outcome.evaluations = self.evaluations.get();
        outcome.solves = self.solves.get();
        outcome.iterations = self.iterations.get();
    }
}

impl<M: Model> Model for Counted<'_, M> {
    type Real = M::Real;
    type State = M::State;
    type Rates = M::Rates;

    fn start(&self) -> M::State {
        self.model.start()
    }

    #[inline(always)]
    fn rates(&self, t: M::Real, state: &M::State) -> Result<M::Rates, Broken> {
        self.evaluations.set(self.evaluations.get() + 1);
        self.model.rates(t, state)
    }

    #[inline(always)]
    fn advance(&self, from: &M::State, s: M::Real, rates: &M::Rates, into: &mut M::State) {
        self.model.advance(from, s, rates, into);
    }

    #[inline(always)]
    fn shortcut(&self, of: Shortcut, step: M::Real, steps: u64, state: &mut M::State) -> Option<u64> {
        let taken = self.model.shortcut(of, step, steps, state)?;
        self.evaluations.set(self.evaluations.get() + taken * of.evaluations());
        Some(taken)
    }

    fn is_finite(&self, state: &M::State) -> bool {
        self.model.is_finite(state)
    }

    fn observe(&self, t: M::Real, state: &M::State) -> Result<Snapshot<M::Real>, Broken> {
        self.model.observe(t, state)
    }

    #[inline(always)]
    fn solved(&self, iterations: u32) {
        self.solves.set(self.solves.get() + 1);
        self.iterations.set(self.iterations.get() + u64::from(iterations));
    }
}

impl<M: Turning> Turning for Counted<'_, M> {
    #[inline(always)]
    fn rotational(&self) -> &Rotational<M::Real> {
        self.model.rotational()
    }

    #[inline(always)]
    fn attitude(&self, state: &M::State) -> Rotation<M::Real> {
        self.model.attitude(state)
    }

    #[inline(always)]
    fn momentum(&self, state: &M::State) -> Vector3<M::Real> {
        self.model.momentum(state)
    }

    #[inline(always)]
    fn place(&self, state: &mut M::State, attitude: Rotation<M::Real>, momentum: Vector3<M::Real>) {
        self.model.place(state, attitude, momentum);
    }

    #[inline(always)]
    fn rates_at_stage(
        &self,
        t: M::Real,
        held: (&M::State, M::Real, &M::Rates),
        q: (&Quaternion<M::Real>, M::Real),
        stage: &mut M::State,
    ) -> Result<(M::Rates, Quaternion<M::Real>), Broken> {
        self.evaluations.set(self.evaluations.get() + 1);
        self.model.rates_at_stage(t, held, q, stage)
    }

    #[inline(always)]
    fn spin_of(&self, rates: &M::Rates) -> Vector3<M::Real> {
        self.model.spin_of(rates)
    }

    #[inline(always)]
    fn torque_of(&self, rates: &M::Rates) -> Vector3<M::Real> {
        self.model.torque_of(rates)
    }

    #[inline(always)]
    fn kick(&self, state: &mut M::State, s: M::Real, rates: &M::Rates) {
        self.model.kick(state, s, rates);
    }

    #[inline(always)]
    fn drift(&self, state: &mut M::State, s: M::Real) {
        self.model.drift(state, s);
    }

    #[inline(always)]
    fn apart(&self, a: &M::State, b: &M::State) -> M::Real {
        self.model.apart(a, b)
    }

    #[inline(always)]
    fn reads_velocity(&self) -> bool {
        self.model.reads_velocity()
    }
}

impl<M: Pointwise> Pointwise for Counted<'_, M> {
    #[inline(always)]
    fn advance_straight(
        &self,
        from: &M::State,
        s: M::Real,
        rates: &M::Rates,
        at: &M::State,
        into: &mut M::State,
    ) {
        self.model.advance_straight(from, s, rates, at, into);
    }

    #[inline(always)]
    fn rates_on_levers(&self, t: M::Real, state: &M::State, levers: &M::State) -> Result<M::Rates, Broken> {
        self.evaluations.set(self.evaluations.get() + 1);
        self.model.rates_on_levers(t, state, levers)
    }
}
