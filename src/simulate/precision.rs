//! The arithmetic of a run, chosen when the program runs.

use super::{Contestant, Form, Outcome, Plan};
use crate::arithmetic::{DoubleDouble, Real, Single};
use crate::model::{Broken, Snapshot, System};

/// The arithmetic of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// 16 digits: what users run.
    #[default]
    F64,
    /// 7 digits: what games and GPUs run.
    F32,
    /// 31 digits: what f64 cannot show.
    DoubleDouble,
}

impl Precision {
    /// All, in the order of their names on the command line.
    pub const ALL: [Precision; 3] = [Precision::F64, Precision::F32, Precision::DoubleDouble];

    /// The arithmetic of this name.
    pub fn named(name: &str) -> Option<Precision> {
        Precision::ALL.into_iter().find(|precision| precision.name() == name)
    }

    /// The name on the command line and in records.
    pub fn name(self) -> &'static str {
        match self {
            Precision::F64 => f64::NAME,
            Precision::F32 => Single::NAME,
            Precision::DoubleDouble => DoubleDouble::NAME,
        }
    }
}

/// An arithmetic that contestants run in.
pub trait Arithmetic: Real {
    /// Runs a contestant in it.
    fn stream(
        contestant: &Contestant,
        system: &System<Self>,
        form: Form,
        plan: &Plan,
        store: &mut dyn FnMut(&Snapshot<Self>),
    ) -> Outcome;
}

/// Of a contestant that runs in f64 alone.
fn refused(contestant: &Contestant) -> Outcome {
    let name = contestant.card.name;
    Outcome::none(Broken::Refused(format!("{name} runs in f64 only").into()))
}

impl Arithmetic for f64 {
    fn stream(
        contestant: &Contestant,
        system: &System,
        form: Form,
        plan: &Plan,
        store: &mut dyn FnMut(&Snapshot),
    ) -> Outcome {
        contestant.stream(system, form, plan, store)
    }
}

impl Arithmetic for Single {
    fn stream(
        contestant: &Contestant,
        system: &System<Single>,
        form: Form,
        plan: &Plan,
        store: &mut dyn FnMut(&Snapshot<Single>),
    ) -> Outcome {
        match &contestant.other_arithmetics {
            Some(runs) => runs.single(system, form, plan, store),
            None => refused(contestant),
        }
    }
}

impl Arithmetic for DoubleDouble {
    fn stream(
        contestant: &Contestant,
        system: &System<DoubleDouble>,
        form: Form,
        plan: &Plan,
        store: &mut dyn FnMut(&Snapshot<DoubleDouble>),
    ) -> Outcome {
        match &contestant.other_arithmetics {
            Some(runs) => runs.double_double(system, form, plan, store),
            None => refused(contestant),
        }
    }
}
