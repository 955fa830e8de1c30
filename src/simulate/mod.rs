//! Scene × scheme × step → trajectory and cost.
//!
//! Scheme and model are dispatched once a run; inside is a monomorphic loop without allocation. Times are
//! t = n h, never accumulated.

#[cfg(feature = "solvers")]
mod adaptive;
mod contestant;
mod substeps;
mod program;
mod counted;
mod dispatch;
mod limits;
mod precision;

use std::time::Instant;

use crate::arithmetic::Real;
use crate::interrupt;
use crate::model::{Broken, Model, Pointwise, Shortcut, Snapshot, Turning};
use crate::schemes::{PointScheme, Scheme, Step, TurningScheme, Workspace};

use counted::Counted;

pub use contestant::{Contestant, Form};
pub use precision::{Arithmetic, Precision};
pub use program::Program;

/// Steps between two checks that the state is finite.
const CHECKED_EVERY: u64 = 1024;

/// How a run is to be stepped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// h [s].
    pub step: f64,
    /// Number of steps.
    pub steps: u64,
    /// Steps between two stored states; the first and the last are stored too.
    pub every: u64,
}

impl Plan {
    /// A run over `duration` [s] in equal steps, with states stored at `samples` equal intervals of it.
    pub fn over(duration: f64, steps: u64, samples: u64) -> Plan {
        Plan { step: duration / steps as f64, steps, every: (steps / samples).max(1) }
    }

    /// h in the arithmetic of a run: the time that the plan covers over its steps. In f64 that is the step as stated.
    fn step_in<T: Real>(&self) -> T {
        if T::UNIT == f64::UNIT || self.steps == 0 {
            return T::of(self.step);
        }
        T::of(self.step * self.steps as f64) / self.steps as f64
    }
}

/// Where and why a run broke.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("broke in step {step}, at t = {time} s: {why}")]
pub struct Break {
    /// The step that broke, from 1.
    pub step: u64,
    /// Time at its end [s].
    pub time: f64,
    /// Why.
    pub why: Broken,
}

/// What a run cost, and whether it came to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Steps that were taken whole.
    pub steps: u64,
    /// Evaluations of the rates, and so of the forces.
    pub evaluations: u64,
    /// Implicit equations that were solved.
    pub solves: u64,
    /// Iterations that they took.
    pub iterations: u64,
    /// Wall-clock time of the run, with the storing of its states [ns].
    pub nanoseconds: u64,
    /// Why the run ended early, if it did.
    pub broken: Option<Break>,
}

impl Outcome {
    /// Why the scheme cannot take the scene, where a foreign program said so when it was asked.
    pub fn refusal(&self) -> Option<&str> {
        match &self.broken {
            Some(Break { why: Broken::Refused(reason), .. }) => Some(reason),
            _ => None,
        }
    }

    /// Of a run that cannot start.
    fn none(why: Broken) -> Outcome {
        Outcome { broken: Some(Break { step: 0, time: 0.0, why }), ..Outcome::none_yet() }
    }

    /// Before the first step.
    pub fn none_yet() -> Outcome {
        Outcome { steps: 0, evaluations: 0, solves: 0, iterations: 0, nanoseconds: 0, broken: None }
    }
}

/// A run with its stored states.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// The first state, every K-th and the last; those before the break where the run broke.
    pub states: Vec<Snapshot>,
    /// Cost and end.
    pub outcome: Outcome,
}

/// A step on a model: lets one loop drive schemes for every model and schemes in body axes.
trait Stepping<M: Model> {
    const STATES: usize;
    const SHORTCUT: Option<Shortcut>;

    fn step(&self, model: &M, step: Step<M>) -> Result<(), Broken>;
}

/// A scheme for every model.
struct OnAnyModel<S>(S);

impl<S: Scheme, M: Model> Stepping<M> for OnAnyModel<S> {
    const STATES: usize = S::STATES;
    const SHORTCUT: Option<Shortcut> = S::SHORTCUT;

    #[inline(always)]
    fn step(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        self.0.step(model, step)
    }
}

/// A scheme in body axes.
struct InBodyAxes<S>(S);

impl<S: TurningScheme, M: Turning> Stepping<M> for InBodyAxes<S> {
    const STATES: usize = S::STATES;
    const SHORTCUT: Option<Shortcut> = S::SHORTCUT;

    #[inline(always)]
    fn step(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        self.0.step(model, step)
    }
}

/// A scheme for the mass points alone.
struct OnPoints<S>(S);

impl<S: PointScheme, M: Pointwise> Stepping<M> for OnPoints<S> {
    const STATES: usize = S::STATES;
    const SHORTCUT: Option<Shortcut> = None;

    #[inline(always)]
    fn step(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        self.0.step(model, step)
    }
}

/// A run on its way, whatever scheme and model it is compiled for.
trait Drive<T: Real> {
    /// Steps from `from` to `to`, counted from the start of the run; where one fails, its number.
    fn advance(&mut self, from: u64, to: u64) -> Result<(), (u64, Broken)>;

    /// Keeps the present state to return to.
    fn keep(&mut self);

    /// Returns to the state that was kept.
    fn restore(&mut self);

    /// Whether every number of the present state is finite.
    fn is_finite(&self) -> bool;

    /// The present state, after `n` steps.
    fn observe(&self, n: u64) -> Result<Snapshot<T>, Broken>;

    /// Puts what was counted into an outcome.
    fn tell(&self, outcome: &mut Outcome);
}

/// The buffers of a run, made once.
struct Stepper<'a, S, M: Model> {
    model: Counted<'a, M>,
    step: M::Real,
    now: M::State,
    next: M::State,
    kept: M::State,
    work: Workspace<Counted<'a, M>>,
    kept_work: Workspace<Counted<'a, M>>,
    scheme: S,
    /// The model between the jumps of its laws, each with the step that it ends before; none where no law jumps.
    pieces: Vec<(u64, &'a M)>,
}

impl<'a, S: Stepping<Counted<'a, M>>, M: Model> Stepper<'a, S, M> {
    /// Takes the model that holds from a step on, and returns the step that it ends before. Rates that a scheme remembers are those
    /// before the jump: there it starts as a run does.
    fn enter(&mut self, n: u64) -> u64 {
        let Some(place) = self.pieces.iter().position(|(end, _)| n < *end) else { return u64::MAX };
        if self.pieces[..place].last().is_some_and(|(before, _)| *before == n) {
            self.work.history.clear();
        }
        let (end, model) = self.pieces[place];
        self.model.switch(model);
        end
    }

    /// Steps with one model.
    fn take(&mut self, mut from: u64, to: u64) -> Result<(), (u64, Broken)> {
        if let Some(of) = S::SHORTCUT {
            while let Some(taken) = self.model.shortcut(of, self.step, to - from, &mut self.now) {
                std::hint::black_box(&self.now);
                from += taken;
                if from == to {
                    return Ok(());
                }
                self.take_by_page(from, from + 1)?;
                from += 1;
            }
        }
        self.take_by_page(from, to)
    }

    /// The same, as the scheme's page says.
    fn take_by_page(&mut self, from: u64, to: u64) -> Result<(), (u64, Broken)> {
        // Places are exchanged, not states: those of a small model would be copied with every step.
        let (mut now, mut next) = (&mut self.now, &mut self.next);
        let mut result = Ok(());
        let mut taken = 0;
        for n in from..to {
            let t = self.step * n as f64;
            let step = Step { t, h: self.step, from: now, to: next, work: &mut self.work };
            if let Err(why) = self.scheme.step(&self.model, step) {
                result = Err((n + 1, why));
                break;
            }
            std::mem::swap(&mut now, &mut next);
            taken += 1;
        }
        if taken % 2 == 1 {
            std::mem::swap(&mut self.now, &mut self.next);
        }
        // The state is an output of the loop: without this a run that stores nothing could be deleted.
        std::hint::black_box(&self.now);
        result
    }
}

impl<'a, S: Stepping<Counted<'a, M>>, M: Model> Drive<M::Real> for Stepper<'a, S, M> {
    fn advance(&mut self, mut from: u64, to: u64) -> Result<(), (u64, Broken)> {
        while from < to {
            let end = self.enter(from).min(to);
            self.take(from, end)?;
            from = end;
        }
        Ok(())
    }

    fn keep(&mut self) {
        self.kept.clone_from(&self.now);
        self.kept_work.copy_from(&self.work);
    }

    fn restore(&mut self) {
        self.now.clone_from(&self.kept);
        self.work.copy_from(&self.kept_work);
    }

    fn is_finite(&self) -> bool {
        self.model.is_finite(&self.now)
    }

    fn observe(&self, n: u64) -> Result<Snapshot<M::Real>, Broken> {
        self.model.observe(self.step * n as f64, &self.now)
    }

    fn tell(&self, outcome: &mut Outcome) {
        self.model.tell(outcome);
    }
}

/// Steps and checks the result. Where it is not finite, the steps are taken again one by one to find the first that was not.
fn advance_checked<T: Real>(run: &mut dyn Drive<T>, from: u64, to: u64) -> Result<(), (u64, Broken)> {
    if to > from + 1 {
        run.keep();
        let result = run.advance(from, to);
        if result.is_ok() && run.is_finite() {
            return Ok(());
        }
        run.restore();
    }
    for n in from..to {
        run.advance(n, n + 1)?;
        if !run.is_finite() {
            return Err((n + 1, Broken::NotFinite));
        }
    }
    Ok(())
}

fn run<S, M: Model + 'static>(
    scheme: S,
    model: &M,
    plan: &Plan,
    store: &mut dyn FnMut(&Snapshot<M::Real>),
) -> Outcome
where
    S: for<'a> Stepping<Counted<'a, M>>,
{
    let (start, pieces) = (model.start(), model.pieces());
    let first_after = |end: M::Real| first_step_after(end.to_f64() / plan.step);
    let work = || Workspace::new(&start, <S as Stepping<Counted<M>>>::STATES);
    let mut stepper = Stepper::<S, M> {
        model: Counted::new(model),
        step: plan.step_in(),
        next: start.clone(),
        kept: start.clone(),
        kept_work: work(),
        work: work(),
        now: start,
        scheme,
        pieces: pieces.iter().map(|(end, piece)| (first_after(*end), piece)).collect(),
    };
    drive(&mut stepper, plan, store)
}

/// The first step of the piece that begins after so many steps: a step belongs to the piece that its middle lies in, and one whose middle ends a
/// piece to the next, in every unit of time.
fn first_step_after(steps: f64) -> u64 {
    let (middle, rounding) = (steps - 0.5, 4.0 * f64::EPSILON * steps);
    let nearest = middle.round();
    let first = if (middle - nearest).abs() <= rounding { nearest } else { middle.ceil() };
    first.max(0.0) as u64
}

/// Takes a run to its end, or to where it breaks.
fn drive<T: Real>(run: &mut dyn Drive<T>, plan: &Plan, store: &mut dyn FnMut(&Snapshot<T>)) -> Outcome {
    let begun = Instant::now();
    let mut outcome = Outcome::none_yet();
    let every = plan.every.max(1);
    let broke = |step: u64, why| Some(Break { step, time: step as f64 * plan.step, why });
    while outcome.broken.is_none() {
        if outcome.steps.is_multiple_of(every) || outcome.steps == plan.steps {
            match run.observe(outcome.steps) {
                Ok(snapshot) => store(&snapshot),
                Err(why) => outcome.broken = broke(outcome.steps, why),
            }
        }
        if outcome.steps == plan.steps || outcome.broken.is_some() {
            break;
        }
        if interrupt::requested() {
            outcome.broken = broke(outcome.steps + 1, Broken::Interrupted);
            break;
        }
        let stored_next = (outcome.steps / every + 1).saturating_mul(every);
        let target = plan.steps.min(stored_next).min(outcome.steps + CHECKED_EVERY);
        match advance_checked(run, outcome.steps, target) {
            Ok(()) => outcome.steps = target,
            Err((step, why)) => {
                outcome.steps = step - 1;
                outcome.broken = broke(step, why);
            }
        }
    }
    outcome.nanoseconds = begun.elapsed().as_nanos() as u64;
    run.tell(&mut outcome);
    outcome
}

#[cfg(test)]
mod tests {
    use super::first_step_after;

    #[test]
    fn a_piece_that_ends_in_the_middle_of_a_step_ends_before_it_however_that_is_rounded() {
        for steps in [5.5f64, 1000.5, 5.5 / 1e-10 * 1e-10] {
            assert_eq!([steps, steps.next_up(), steps.next_down()].map(first_step_after), [steps as u64; 3]);
        }
        assert_eq!([0.0, 0.5, 0.6, 1.0, 1.4, 1.6].map(first_step_after), [0, 0, 1, 1, 1, 2]);
    }
}
