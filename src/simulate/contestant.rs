//! What is put under test, and on which form of a scene it runs.

use std::borrow::Cow;
use std::sync::Arc;

use super::dispatch::{InAny, run_in_body_axes, run_on_any_model, run_on_points};
use super::limits::Limits;
use super::precision::{Arithmetic, Precision};
use super::{InBodyAxes, OnAnyModel, OnPoints, Outcome, Plan, Program, Trajectory, substeps};
use crate::arithmetic::{DoubleDouble, Single};
use crate::claim::Claim;
use crate::model::{AnyModel, Broken, Snapshot, System, SystemError};
use crate::schemes::{self, Card, PointScheme, Scheme, SideBySide, TurningScheme, Visitor};

/// Which form of a scene is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The least model that determines the motion and that the scheme runs on.
    Least,
    /// Every mass point.
    Points,
}

impl Form {
    /// The model of a scene.
    ///
    /// # Errors
    /// The body has no point form.
    #[doc(hidden)]
    pub fn model(self, system: &System) -> Result<AnyModel, SystemError> {
        match self {
            Form::Least => Ok(system.least()),
            Form::Points => system.points(),
        }
    }
}

/// Most steps of a run of a scheme …
const MOST_STEPS: u64 = 1 << 21;
/// … and of a foreign program, whose steps may cost a thousand times more.
const MOST_FOREIGN_STEPS: u64 = 1 << 15;

type Refusal = dyn Fn(&System) -> Option<String> + Send + Sync;
type Who = dyn Fn() -> Program + Send + Sync;
pub(super) type Run = dyn Fn(&System, Form, &Plan, &mut dyn FnMut(&Snapshot)) -> Outcome + Send + Sync;

/// Something under test: a scheme of this or another crate, or a program of its own.
#[derive(Clone)]
pub struct Contestant {
    /// What it says of itself.
    pub card: Card,
    run: Arc<Run>,
    limits: Limits,
    refusal: Option<Arc<Refusal>>,
    program: Option<Arc<Who>>,
    most_steps: u64,
    side_by_side: Option<SideBySide>,
    pub(super) other_arithmetics: Option<Arc<dyn InAny>>,
}

impl Contestant {
    /// A scheme of any crate.
    pub fn new<S: Scheme>(scheme: S) -> Contestant {
        let other_arithmetics: Arc<dyn InAny> = Arc::new(OnAnyModel(scheme.clone()));
        let card = scheme.card();
        let run = move |system: &System, form, plan: &Plan, store: &mut dyn FnMut(&Snapshot)| {
            run_on_any_model(&scheme, system, form, plan, store)
        };
        Contestant {
            side_by_side: S::SIDE_BY_SIDE,
            other_arithmetics: Some(other_arithmetics),
            ..Contestant::within(Limits::NONE, card, Arc::new(run))
        }
    }

    fn within(limits: Limits, card: Card, run: Arc<Run>) -> Contestant {
        Contestant {
            card,
            run,
            limits,
            refusal: None,
            program: None,
            most_steps: MOST_STEPS,
            side_by_side: None,
            other_arithmetics: None,
        }
    }

    /// A scheme in body axes, of any crate.
    pub fn turning<S: TurningScheme>(scheme: S) -> Contestant {
        let limits = Limits {
            points: false,
            velocity_forces: S::TAKES_VELOCITY_FORCES,
            rods: S::TAKES_RODS,
            plates: S::TAKES_PLATES,
            keeps_momentum: S::KEEPS_MOMENTUM,
            ..Limits::NONE
        };
        let other_arithmetics: Arc<dyn InAny> = Arc::new(InBodyAxes(scheme.clone()));
        let card = scheme.card();
        let run = move |system: &System, form, plan: &Plan, store: &mut dyn FnMut(&Snapshot)| {
            run_in_body_axes(&scheme, system, form, plan, store)
        };
        Contestant {
            other_arithmetics: Some(other_arithmetics),
            ..Contestant::within(limits, card, Arc::new(run))
        }
    }

    /// A scheme for the mass points alone, of any crate.
    pub fn points<S: PointScheme>(scheme: S) -> Contestant {
        let limits = Limits { reduced: false, ..Limits::NONE };
        let other_arithmetics: Arc<dyn InAny> = Arc::new(OnPoints(scheme.clone()));
        let card = scheme.card();
        let run = move |system: &System, form, plan: &Plan, store: &mut dyn FnMut(&Snapshot)| {
            run_on_points(&scheme, system, form, plan, store)
        };
        Contestant {
            other_arithmetics: Some(other_arithmetics),
            ..Contestant::within(limits, card, Arc::new(run))
        }
    }

    /// The scheme's form for many free bodies side by side, if it has one.
    pub fn side_by_side(&self) -> Option<SideBySide> {
        self.side_by_side
    }

    /// Name of the model that stands for a scene in its least form.
    pub fn model(&self, system: &System) -> &'static str {
        match system.least() {
            _ if self.needs_points() => "points",
            AnyModel::Free(_) if !self.limits.keeps_momentum => "torque",
            AnyModel::Falling(_) if !self.limits.keeps_momentum => "forced",
            least => least.name(),
        }
    }

    /// A program that brings a model of its own. `run` steps a scene in a form by a plan and hands over the first
    /// state, every K-th and the last.
    pub fn foreign(
        card: Card,
        run: impl Fn(&System, Form, &Plan, &mut dyn FnMut(&Snapshot)) -> Outcome + Send + Sync + 'static,
    ) -> Contestant {
        Contestant::within(Limits::NONE, card, Arc::new(run))
    }

    /// A program that is asked for whole runs and brings a body of its own; it may know scenes that it cannot take,
    /// with the reason.
    pub fn engine(
        card: Card,
        refusal: impl Fn(&System) -> Option<String> + Send + Sync + 'static,
        run: impl Fn(&System, &Plan, &mut dyn FnMut(&Snapshot)) -> Outcome + Send + Sync + 'static,
    ) -> Contestant {
        let limits = Limits { points: false, ..Limits::NONE };
        let run = move |system: &System, _: Form, plan: &Plan, store: &mut dyn FnMut(&Snapshot)| {
            run(system, plan, store)
        };
        let most_steps = MOST_FOREIGN_STEPS;
        Contestant {
            refusal: Some(Arc::new(refusal)),
            most_steps,
            ..Contestant::within(limits, card, Arc::new(run))
        }
    }

    /// The scheme in `parts` equal parts of every step: what engines call substeps. `None` where it chooses its own
    /// steps, or where a step is one part.
    ///
    /// A step costs `parts` times as much; an error of order p is parts⁻ᵖ of the scheme's own at the same h. Its
    /// promises are the scheme's, with the counts of work multiplied.
    pub fn substepped(&self, parts: u32) -> Option<Contestant> {
        if parts < 2 || self.card.tolerance_exponent() > 0 {
            return None;
        }
        let run = Arc::clone(&self.run);
        let within = move |system: &System, form: Form, plan: &Plan, store: &mut dyn FnMut(&Snapshot)| {
            substeps::run(&*run, system, form, plan, parts, store)
        };
        Some(Contestant {
            card: substeps::card(&self.card, parts),
            run: Arc::new(within),
            limits: self.limits,
            refusal: self.refusal.clone(),
            program: self.program.clone(),
            side_by_side: None,
            other_arithmetics: None,
            most_steps: self.most_steps / u64::from(parts),
        })
    }

    /// The scheme in an arithmetic, with states handed over as the nearest f64. `None` for a program or a solver of another
    /// crate, which runs in f64 alone.
    pub fn at(&self, precision: Precision) -> Option<Contestant> {
        match precision {
            Precision::F64 => Some(self.clone()),
            Precision::F32 => self.within_arithmetic::<Single>(),
            Precision::DoubleDouble => self.within_arithmetic::<DoubleDouble>(),
        }
    }

    fn within_arithmetic<T: Arithmetic>(&self) -> Option<Contestant> {
        self.other_arithmetics.as_ref()?;
        let scheme = self.clone();
        let run = move |system: &System, form: Form, plan: &Plan, store: &mut dyn FnMut(&Snapshot)| {
            match System::<T>::of(system) {
                Ok(own) => T::stream(&scheme, &own, form, plan, &mut |state| store(&state.nearest())),
                Err(error) => Outcome::none(Broken::Refused(error.to_string().into())),
            }
        };
        Some(Contestant { run: Arc::new(run), side_by_side: None, other_arithmetics: None, ..self.clone() })
    }

    /// The same, and who the program is.
    pub fn by(self, program: impl Fn() -> Program + Send + Sync + 'static) -> Contestant {
        Contestant { program: Some(Arc::new(program)), ..self }
    }

    /// The same, held to an order in the place of what it claims.
    pub fn claiming(self, order: u32) -> Contestant {
        let of_order = |claim: &&Claim| matches!(claim, Claim::Order(_) | Claim::OrderWithoutTorque(_));
        let others = self.card.claims.iter().filter(|claim| !of_order(claim)).copied();
        let claims: Vec<Claim> = others.chain([Claim::Order(order)]).collect();
        Contestant { card: Card { claims: claims.leak(), ..self.card }, ..self }
    }

    /// Who the foreign program is, where it is one.
    pub fn program(&self) -> Option<Program> {
        self.program.as_ref().map(|program| program())
    }

    /// What it is, for a row that is kept: a scheme by its name, which the running program holds; a foreign program by its command line, its
    /// answer to hello and the content of its files.
    pub(crate) fn identity(&self) -> String {
        let name = self.card.name.to_owned();
        self.program().map_or(name.clone(), |program| {
            let Program { name: own, version, integrator, files, .. } = program;
            format!("{:?}", (name, own, version, integrator, files))
        })
    }

    /// Why the scheme cannot take a scene, if it cannot.
    pub fn refusal(&self, system: &System) -> Option<Cow<'static, str>> {
        if let Some(refusal) = &self.refusal {
            return refusal(system).map(Cow::Owned);
        }
        self.limits.refusal(system).map(Cow::Borrowed)
    }

    /// Whether it is a program of its own, whose ladders end sooner.
    pub fn is_foreign(&self) -> bool {
        self.refusal.is_some()
    }

    /// Whether it is a program outside this process, which tells how long its steps took by a clock of its own.
    pub fn has_own_clock(&self) -> bool {
        self.is_foreign() && !self.chooses_steps()
    }

    /// Whether it chooses its own steps: the step that it is given stands for a tolerance.
    pub fn chooses_steps(&self) -> bool {
        self.card.tolerance_exponent() > 0
    }

    /// Most steps that a run of a ladder may have.
    pub fn most_steps(&self) -> u64 {
        self.most_steps
    }

    /// Whether the scheme runs on the mass points alone.
    pub fn needs_points(&self) -> bool {
        !self.limits.reduced
    }

    /// Whether the scheme runs on the mass points.
    pub fn takes_points(&self) -> bool {
        self.limits.points
    }

    /// The schemes of the list.
    pub fn all() -> Vec<Contestant> {
        struct Collect;
        impl Visitor for Collect {
            type Output = Contestant;
            fn visit<S: Scheme>(&self, scheme: S) -> Contestant {
                Contestant::new(scheme)
            }
            fn visit_turning<S: TurningScheme>(&self, scheme: S) -> Contestant {
                Contestant::turning(scheme)
            }
            fn visit_points<S: PointScheme>(&self, scheme: S) -> Contestant {
                Contestant::points(scheme)
            }
        }
        schemes::visit_all(&Collect)
    }

    /// The solvers that choose their own steps, where the crate is built with them.
    pub fn adaptive() -> Vec<Contestant> {
        #[cfg(feature = "solvers")]
        return super::adaptive::contestants();
        #[cfg(not(feature = "solvers"))]
        Vec::new()
    }

    /// The schemes of the list and the solvers that choose their own steps.
    pub fn everyone() -> Vec<Contestant> {
        Contestant::all().into_iter().chain(Contestant::adaptive()).collect()
    }

    /// The main schemes of the list, in the order of [`schemes::MAIN`].
    pub fn main() -> Vec<Contestant> {
        let all = Contestant::all();
        let named = |name: &&str| all.iter().find(|c| c.card.name == *name).cloned();
        schemes::MAIN.iter().filter_map(named).collect()
    }

    /// Runs and hands every stored state to `store` as it comes: constant memory, however long the run.
    pub fn stream(
        &self,
        system: &System,
        form: Form,
        plan: &Plan,
        store: &mut dyn FnMut(&Snapshot),
    ) -> Outcome {
        (self.run)(system, form, plan, store)
    }

    /// Whether it runs in other arithmetics than f64: a scheme, not a program.
    pub fn runs_in_double_double(&self) -> bool {
        self.other_arithmetics.is_some()
    }

    /// Runs in an arithmetic other than f64. The step is the time that the plan covers over its steps, in that arithmetic.
    ///
    /// A program and a solver of another crate run in f64 alone.
    pub fn stream_in<T: Arithmetic>(
        &self,
        system: &System<T>,
        form: Form,
        plan: &Plan,
        store: &mut dyn FnMut(&Snapshot<T>),
    ) -> Outcome {
        T::stream(self, system, form, plan, store)
    }

    /// Runs in an arithmetic and keeps the stored states.
    pub fn run_in<T: Arithmetic>(
        &self,
        system: &System<T>,
        form: Form,
        plan: &Plan,
    ) -> (Vec<Snapshot<T>>, Outcome) {
        let mut states = Vec::new();
        let outcome = self.stream_in(system, form, plan, &mut |state| states.push(*state));
        (states, outcome)
    }

    /// Runs and keeps the stored states.
    pub fn run(&self, system: &System, form: Form, plan: &Plan) -> Trajectory {
        let mut states = Vec::with_capacity((plan.steps / plan.every.max(1) + 2).min(1 << 20) as usize);
        let outcome = self.stream(system, form, plan, &mut |snapshot| states.push(*snapshot));
        Trajectory { states, outcome }
    }
}
