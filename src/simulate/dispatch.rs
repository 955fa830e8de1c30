//! From a scheme and a scene to a loop that is compiled for both: once a run, never in a step.

use super::{Form, InBodyAxes, OnAnyModel, OnPoints, Outcome, Plan, run};
use crate::arithmetic::{DoubleDouble, Real, Single};
use crate::model::{AnyModel, Broken, Least, Snapshot, System};
use crate::schemes::{PointScheme, Scheme, TurningScheme};

pub(super) fn run_on_any_model<S: Scheme>(
    scheme: &S,
    system: &System,
    form: Form,
    plan: &Plan,
    store: &mut dyn FnMut(&Snapshot),
) -> Outcome {
    match form.model(system) {
        Ok(AnyModel::Free(model)) => run(OnAnyModel(scheme.clone()), &model, plan, store),
        Ok(AnyModel::Falling(model)) => run(OnAnyModel(scheme.clone()), &model, plan, store),
        Ok(AnyModel::Torque(model) | AnyModel::Pivot(model)) => {
            run(OnAnyModel(scheme.clone()), &model, plan, store)
        }
        Ok(AnyModel::Forced(model)) => run(OnAnyModel(scheme.clone()), &model, plan, store),
        Ok(AnyModel::Points(model)) => run(OnAnyModel(scheme.clone()), &model, plan, store),
        Err(_) => Outcome::none(Broken::NoPointForm),
    }
}

pub(super) fn run_in_body_axes<S: TurningScheme>(
    scheme: &S,
    system: &System,
    form: Form,
    plan: &Plan,
    store: &mut dyn FnMut(&Snapshot),
) -> Outcome {
    match form.model(system) {
        Ok(AnyModel::Free(model)) if !S::KEEPS_MOMENTUM => {
            run(InBodyAxes(scheme.clone()), &model.with_momentum(), plan, store)
        }
        Ok(AnyModel::Falling(model)) if !S::KEEPS_MOMENTUM => {
            run(InBodyAxes(scheme.clone()), &model.with_momentum(), plan, store)
        }
        Ok(AnyModel::Free(model)) => run(InBodyAxes(scheme.clone()), &model, plan, store),
        Ok(AnyModel::Falling(model)) => run(InBodyAxes(scheme.clone()), &model, plan, store),
        Ok(AnyModel::Torque(model) | AnyModel::Pivot(model)) => {
            run(InBodyAxes(scheme.clone()), &model, plan, store)
        }
        Ok(AnyModel::Forced(model)) => run(InBodyAxes(scheme.clone()), &model, plan, store),
        Ok(AnyModel::Points(_)) => Outcome::none(Broken::NeedsAttitude),
        Err(_) => Outcome::none(Broken::NoPointForm),
    }
}

pub(super) fn run_on_points<S: PointScheme>(
    scheme: &S,
    system: &System,
    _form: Form,
    plan: &Plan,
    store: &mut dyn FnMut(&Snapshot),
) -> Outcome {
    match system.points() {
        Ok(AnyModel::Points(model)) => run(OnPoints(scheme.clone()), &model, plan, store),
        _ => Outcome::none(Broken::NoPointForm),
    }
}

/// A run in an arithmetic whose runs are not timed: one compilation for all reduced models.
pub(super) trait InAny: Send + Sync {
    /// In single precision.
    fn single(&self, system: &System<Single>, form: Form, plan: &Plan, store: &mut Store<Single>) -> Outcome;

    /// In double-double.
    fn double_double(
        &self,
        system: &System<DoubleDouble>,
        form: Form,
        plan: &Plan,
        store: &mut Store<DoubleDouble>,
    ) -> Outcome;
}

/// What is handed the states of a run.
pub(super) type Store<'a, T> = dyn FnMut(&Snapshot<T>) + 'a;

/// Declares both arithmetics of a kind of scheme by its generic run.
macro_rules! in_any {
    ($kind:ident, $scheme:ident) => {
        impl<S: $scheme> InAny for $kind<S> {
            fn single(
                &self,
                system: &System<Single>,
                form: Form,
                plan: &Plan,
                store: &mut Store<Single>,
            ) -> Outcome {
                self.run_in(system, form, plan, store)
            }

            fn double_double(
                &self,
                system: &System<DoubleDouble>,
                form: Form,
                plan: &Plan,
                store: &mut Store<DoubleDouble>,
            ) -> Outcome {
                self.run_in(system, form, plan, store)
            }
        }
    };
}

in_any!(OnAnyModel, Scheme);
in_any!(InBodyAxes, TurningScheme);
in_any!(OnPoints, PointScheme);

impl<S: Scheme> OnAnyModel<S> {
    fn run_in<T: Real>(&self, system: &System<T>, form: Form, plan: &Plan, store: &mut Store<T>) -> Outcome {
        let scheme = OnAnyModel(self.0.clone());
        match (form, system.points()) {
            (Form::Least, _) => run(scheme, &Least::of(system), plan, store),
            (Form::Points, Ok(AnyModel::Points(model))) => run(scheme, &model, plan, store),
            (Form::Points, _) => Outcome::none(Broken::NoPointForm),
        }
    }
}

impl<S: TurningScheme> InBodyAxes<S> {
    fn run_in<T: Real>(&self, system: &System<T>, form: Form, plan: &Plan, store: &mut Store<T>) -> Outcome {
        if form == Form::Points {
            return Outcome::none(Broken::NeedsAttitude);
        }
        let least = Least::of(system);
        let least = if S::KEEPS_MOMENTUM { least } else { least.with_momentum() };
        run(InBodyAxes(self.0.clone()), &least, plan, store)
    }
}

impl<S: PointScheme> OnPoints<S> {
    fn run_in<T: Real>(&self, system: &System<T>, _form: Form, plan: &Plan, store: &mut Store<T>) -> Outcome {
        match system.points() {
            Ok(AnyModel::Points(model)) => run(OnPoints(self.0.clone()), &model, plan, store),
            _ => Outcome::none(Broken::NoPointForm),
        }
    }
}
