//! From a scheme and a scene to a loop that is compiled for both: once a run, never in a step.

use super::{Form, InBodyAxes, OnAnyModel, OnPoints, Outcome, Plan, run};
use crate::model::{AnyModel, Broken, Snapshot, System};
use crate::schemes::{PointScheme, Scheme, TurningScheme};

pub(super) fn run_on_any_model<S: Scheme>(
    system: &System,
    form: Form,
    plan: &Plan,
    store: &mut dyn FnMut(&Snapshot),
) -> Outcome {
    match form.model(system) {
        Ok(AnyModel::Free(model)) => run::<OnAnyModel<S>, _>(&model, plan, store),
        Ok(AnyModel::Falling(model)) => run::<OnAnyModel<S>, _>(&model, plan, store),
        Ok(AnyModel::Torque(model) | AnyModel::Pivot(model)) => run::<OnAnyModel<S>, _>(&model, plan, store),
        Ok(AnyModel::Forced(model)) => run::<OnAnyModel<S>, _>(&model, plan, store),
        Ok(AnyModel::Points(model)) => run::<OnAnyModel<S>, _>(&model, plan, store),
        Err(_) => Outcome::none(Broken::NoPointForm),
    }
}

pub(super) fn run_in_body_axes<S: TurningScheme>(
    system: &System,
    form: Form,
    plan: &Plan,
    store: &mut dyn FnMut(&Snapshot),
) -> Outcome {
    match form.model(system) {
        Ok(AnyModel::Free(model)) if !S::KEEPS_MOMENTUM => {
            run::<InBodyAxes<S>, _>(&model.with_momentum(), plan, store)
        }
        Ok(AnyModel::Falling(model)) if !S::KEEPS_MOMENTUM => {
            run::<InBodyAxes<S>, _>(&model.with_momentum(), plan, store)
        }
        Ok(AnyModel::Free(model)) => run::<InBodyAxes<S>, _>(&model, plan, store),
        Ok(AnyModel::Falling(model)) => run::<InBodyAxes<S>, _>(&model, plan, store),
        Ok(AnyModel::Torque(model) | AnyModel::Pivot(model)) => run::<InBodyAxes<S>, _>(&model, plan, store),
        Ok(AnyModel::Forced(model)) => run::<InBodyAxes<S>, _>(&model, plan, store),
        Ok(AnyModel::Points(_)) => Outcome::none(Broken::NeedsAttitude),
        Err(_) => Outcome::none(Broken::NoPointForm),
    }
}

pub(super) fn run_on_points<S: PointScheme>(
    system: &System,
    _form: Form,
    plan: &Plan,
    store: &mut dyn FnMut(&Snapshot),
) -> Outcome {
    match system.points() {
        Ok(AnyModel::Points(model)) => run::<OnPoints<S>, _>(&model, plan, store),
        _ => Outcome::none(Broken::NoPointForm),
    }
}
