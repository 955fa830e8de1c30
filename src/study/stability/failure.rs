//! How a run fails: classes, each with what it measured.

use std::fmt;

use crate::model::Broken;

/// Principal axes by their moment of inertia.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The axis of the smallest moment.
    Smallest,
    /// The axis of the middle moment.
    Middle,
    /// The axis of the largest moment.
    Largest,
}

impl Axis {
    /// The word in records.
    pub fn word(self) -> &'static str {
        match self {
            Axis::Smallest => "smallest",
            Axis::Middle => "middle",
            Axis::Largest => "largest",
        }
    }
}

/// How a run fails.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// A state is NaN or infinite, or past the range in which energies can be formed.
    NotFinite {
        /// The step.
        step: u64,
    },
    /// An implicit equation was not solved.
    SolveFails {
        /// The step.
        step: u64,
        /// What was left of it.
        residual: f64,
    },
    /// Something else broke the run.
    Breaks {
        /// The step.
        step: u64,
        /// Why.
        why: String,
    },
    /// The body is no longer rigid.
    LosesRigidity {
        /// Largest change of a length, relative.
        stretch: f64,
    },
    /// The body flips where the truth does not, or not where it does.
    WrongFlips {
        /// Flips of the run.
        run: usize,
        /// Flips of the truth.
        truth: usize,
        /// Largest difference of a flip time, over the time between flips; 0 where their number differs.
        late: f64,
    },
    /// The spin has settled on a principal axis, where the truth has not.
    WrongAxis {
        /// Which.
        axis: Axis,
    },
    /// The energy grows.
    EnergyGrows {
        /// Mean growth a step, over the scale of the energy, or logarithmic once it has grown tenfold.
        per_step: f64,
    },
    /// The energy falls.
    EnergyDecays {
        /// Mean fall a step, over the scale of the energy.
        per_step: f64,
    },
    /// The truth comes to rest and the run does not, or elsewhere.
    WrongEquilibrium {
        /// Angle from the true one [rad].
        angle: f64,
    },
    /// None of these: the run follows a motion of the right kind at the wrong time.
    OutOfPhase {
        /// Largest angle from the truth [rad].
        angle: f64,
    },
}

impl Failure {
    /// The failure of a run that broke.
    pub fn of_break(step: u64, why: &Broken) -> Failure {
        match why {
            Broken::NotFinite => Failure::NotFinite { step },
            Broken::NoConvergence { residual, .. } => Failure::SolveFails { step, residual: *residual },
            other => Failure::Breaks { step, why: other.to_string() },
        }
    }

    /// The class, in few words.
    pub fn class(&self) -> &'static str {
        match self {
            Failure::NotFinite { .. } => "NaN or overflow",
            Failure::SolveFails { .. } => "implicit solve fails",
            Failure::Breaks { .. } => "breaks",
            Failure::LosesRigidity { .. } => "loses rigidity",
            Failure::WrongFlips { .. } => "wrong flips",
            Failure::WrongAxis { axis: Axis::Smallest } => "settles on the smallest axis",
            Failure::WrongAxis { axis: Axis::Middle } => "settles on the middle axis",
            Failure::WrongAxis { axis: Axis::Largest } => "settles on the largest axis",
            Failure::EnergyGrows { .. } => "energy grows",
            Failure::EnergyDecays { .. } => "energy decays",
            Failure::WrongEquilibrium { .. } => "wrong equilibrium",
            Failure::OutOfPhase { .. } => "out of phase",
        }
    }

    /// The classes of a map, in the order of their numbers from 1 on; 0 is a run that does not fail.
    pub const CLASSES: [&'static str; 12] = [
        "none",
        "out of phase",
        "energy grows",
        "energy decays",
        "settles on the smallest axis",
        "settles on the middle axis",
        "settles on the largest axis",
        "wrong flips",
        "wrong equilibrium",
        "loses rigidity",
        "implicit solve fails",
        "NaN or overflow",
    ];
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let class = self.class();
        match self {
            Failure::NotFinite { step } => write!(f, "{class} in step {step}"),
            Failure::SolveFails { step, residual } => {
                write!(f, "{class} in step {step}: residual {residual:.1e}")
            }
            Failure::Breaks { step, why } => write!(f, "{class} in step {step}: {why}"),
            Failure::LosesRigidity { stretch } => write!(f, "{class}: lengths change by {stretch:.1e}"),
            Failure::WrongFlips { run, truth, late } if run == truth => {
                write!(f, "{class}: {late:.2} of the time between flips off")
            }
            Failure::WrongFlips { run, truth, .. } => write!(f, "{class}: {run} instead of {truth}"),
            Failure::WrongAxis { .. } => write!(f, "{class}"),
            Failure::EnergyGrows { per_step } => write!(f, "{class} by {per_step:.1e} a step"),
            Failure::EnergyDecays { per_step } => write!(f, "{class} by {per_step:.1e} a step"),
            Failure::WrongEquilibrium { angle } => write!(f, "{class}: {angle:.2} rad off"),
            Failure::OutOfPhase { angle } => write!(f, "{class}: {angle:.2} rad off"),
        }
    }
}
