//! A model that counts what is asked of it, at no cost that could be measured.

use std::cell::Cell;

use nalgebra::{Quaternion, Vector3};

use super::Outcome;
use crate::model::{Broken, Model, Pointwise, Rotational, Snapshot, Turning};
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

    /// Puts what was counted into an outcome.
    pub(super) fn tell(&self, outcome: &mut Outcome) {
        outcome.evaluations = self.evaluations.get();
        outcome.solves = self.solves.get();
        outcome.iterations = self.iterations.get();
    }
}

impl<M: Model> Model for Counted<'_, M> {
    type State = M::State;
    type Rates = M::Rates;

    fn start(&self) -> M::State {
        self.model.start()
    }

    #[inline(always)]
    fn rates(&self, t: f64, state: &M::State) -> Result<M::Rates, Broken> {
        self.evaluations.set(self.evaluations.get() + 1);
        self.model.rates(t, state)
    }

    #[inline(always)]
    fn advance(&self, from: &M::State, s: f64, rates: &M::Rates, into: &mut M::State) {
        self.model.advance(from, s, rates, into);
    }

    fn is_finite(&self, state: &M::State) -> bool {
        self.model.is_finite(state)
    }

    fn observe(&self, t: f64, state: &M::State) -> Result<Snapshot, Broken> {
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
    fn rotational(&self) -> &Rotational {
        self.model.rotational()
    }

    #[inline(always)]
    fn attitude(&self, state: &M::State) -> Rotation {
        self.model.attitude(state)
    }

    #[inline(always)]
    fn momentum(&self, state: &M::State) -> Vector3<f64> {
        self.model.momentum(state)
    }

    #[inline(always)]
    fn place(&self, state: &mut M::State, attitude: Rotation, momentum: Vector3<f64>) {
        self.model.place(state, attitude, momentum);
    }

    #[inline(always)]
    fn rates_at_stage(
        &self,
        t: f64,
        held: (&M::State, f64, &M::Rates),
        q: (&Quaternion<f64>, f64),
        stage: &mut M::State,
    ) -> Result<(M::Rates, Quaternion<f64>), Broken> {
        self.evaluations.set(self.evaluations.get() + 1);
        self.model.rates_at_stage(t, held, q, stage)
    }

    #[inline(always)]
    fn spin_of(&self, rates: &M::Rates) -> Vector3<f64> {
        self.model.spin_of(rates)
    }

    #[inline(always)]
    fn torque_of(&self, rates: &M::Rates) -> Vector3<f64> {
        self.model.torque_of(rates)
    }

    #[inline(always)]
    fn kick(&self, state: &mut M::State, s: f64, rates: &M::Rates) {
        self.model.kick(state, s, rates);
    }

    #[inline(always)]
    fn drift(&self, state: &mut M::State, s: f64) {
        self.model.drift(state, s);
    }

    #[inline(always)]
    fn apart(&self, a: &M::State, b: &M::State) -> f64 {
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
        s: f64,
        rates: &M::Rates,
        at: &M::State,
        into: &mut M::State,
    ) {
        self.model.advance_straight(from, s, rates, at, into);
    }

    #[inline(always)]
    fn rates_on_levers(&self, t: f64, state: &M::State, levers: &M::State) -> Result<M::Rates, Broken> {
        self.evaluations.set(self.evaluations.get() + 1);
        self.model.rates_on_levers(t, state, levers)
    }
}
