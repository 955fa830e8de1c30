//! What moves, and under what: bodies, forces, and the models that keep no more than a scene needs.
//!
//! A **model** knows a body under forces and offers two verbs; schemes are written in them alone:
//! `rates` asks where Ω, U_cm, F/M and τ come from at a state, `advance` holds such rates for a time.
//!
//! | model | a scene with | keeps | Peskin's steps that remain |
//! |---|---|---|---|
//! | `Free` | neither force nor torque | orientation | (1) (5) |
//! | `Falling` | uniform gravity only | translation; rotation as if free | (1)–(3) (5)–(7) |
//! | `Rotor` | a pivot, or torques only | orientation and L | (1) (4) (5) (8) |
//! | `Forced` | forces on points | everything | all |
//! | `PointCloud` | `--model points` | every mass point | all, O(K) |

mod arms;
pub mod body;
pub(crate) mod change;
pub(crate) mod copies;
mod falling;
mod forced;
pub mod forces;
pub(crate) mod free;
mod least;
pub(crate) mod moving_axes;
mod placed;
mod point_cloud;
pub(crate) mod retold;
mod rotor;
mod snapshot;
pub(crate) mod system;
mod turning;

use std::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::{Quaternion, Vector3};

use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};

pub(crate) use crate::quantity::larger;
pub use crate::quantity::{PerQuantity, Quantity};
pub(crate) use change::Change;
pub(crate) use copies::sizes;
pub(crate) use falling::Falling;
pub(crate) use forced::Forced;
pub use forced::Motion;
pub(crate) use free::Free;
pub(crate) use least::Least;
pub(crate) use placed::Placed;
pub(crate) use point_cloud::PointCloud;
pub(crate) use rotor::Rotor;
pub use snapshot::{Snapshot, difference};
pub(crate) use system::AnyModel;
pub use system::{Carried, Rotational, Spin, Start, System, SystemError};

/// A run that cannot go on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Broken {
    /// A state holds NaN or infinity.
    #[error("the state is no longer finite")]
    NotFinite,
    /// The mass points of a body that has none were asked for.
    #[error("no positive masses have this body's inertia: it has no point form")]
    NoPointForm,
    /// A scheme in body axes was given the mass points.
    #[error("the scheme lives in body axes and does not run on mass points")]
    NeedsAttitude,
    /// A scheme for the mass points was given a reduced model.
    #[error("the scheme runs on the mass points alone")]
    NeedsPoints,
    /// An implicit equation was not solved.
    #[error(
        "no convergence after {iterations} iterations: residual {residual:.1e} where {tolerance:.0e} is asked"
    )]
    NoConvergence {
        /// Iterations made.
        iterations: u32,
        /// What was left.
        residual: f64,
        /// What was asked for.
        tolerance: f64,
    },
    /// The user asked for the end.
    #[error("interrupted")]
    Interrupted,
    /// A foreign program broke the run, or broke itself.
    #[error("{0}")]
    Foreign(Box<str>),
    /// A foreign program cannot take the scene.
    #[error("{0}")]
    Refused(Box<str>),
    /// I Ω = L has no solution.
    #[error("the inertia summed over the points is singular: I Ω = L has no solution")]
    Singular,
}

/// How the parts of a state change: a vector space, so that stages combine.
pub trait Rates<T: Real>:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// The rates times a number of the arithmetic, which a factor in f64 would round.
    fn scaled(self, factor: T) -> Self;

    /// The parts one by one, for schemes that combine them in ways of their own; zero where the model keeps none.
    fn motion(self) -> Motion<T>;

    /// Rates of these parts, as far as the model keeps them.
    fn of(motion: Motion<T>) -> Self;
}

/// Declares rates: vectors that are added and scaled part by part.
macro_rules! rates {
    ($(#[$doc:meta])* $rates:ident { $($(#[$part_doc:meta])* $part:ident),* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $rates<T: Real = f64> {
            $($(#[$part_doc])* pub $part: Vector3<T>,)*
        }

        impl<T: Real> Default for $rates<T> {
            #[inline]
            fn default() -> $rates<T> {
                $rates { $($part: $crate::rotation::zero(),)* }
            }
        }

        impl<T: Real> std::ops::Add for $rates<T> {
            type Output = $rates<T>;

            #[inline]
            fn add(self, other: $rates<T>) -> $rates<T> {
                $rates { $($part: self.$part + other.$part,)* }
            }
        }

        impl<T: Real> std::ops::Sub for $rates<T> {
            type Output = $rates<T>;

            #[inline]
            fn sub(self, other: $rates<T>) -> $rates<T> {
                $rates { $($part: self.$part - other.$part,)* }
            }
        }

        impl<T: Real> std::ops::Neg for $rates<T> {
            type Output = $rates<T>;

            #[inline]
            fn neg(self) -> $rates<T> {
                $rates { $($part: -self.$part,)* }
            }
        }

        impl<T: Real> std::ops::Mul<f64> for $rates<T> {
            type Output = $rates<T>;

            #[inline]
            fn mul(self, factor: f64) -> $rates<T> {
                $rates { $($part: self.$part.map(|x| x * factor),)* }
            }
        }

        impl<T: Real> std::ops::Div<f64> for $rates<T> {
            type Output = $rates<T>;

            #[inline]
            fn div(self, divisor: f64) -> $rates<T> {
                $rates { $($part: self.$part.map(|x| x / divisor),)* }
            }
        }

        impl<T: Real> $crate::model::Rates<T> for $rates<T> {
            #[inline]
            fn scaled(self, factor: T) -> $rates<T> {
                $rates { $($part: self.$part * factor,)* }
            }

            #[inline]
            fn motion(self) -> $crate::model::Motion<T> {
                let mut motion = $crate::model::Motion::default();
                $(motion.$part = self.$part;)*
                motion
            }

            #[inline]
            fn of(motion: $crate::model::Motion<T>) -> $rates<T> {
                $rates { $($part: motion.$part,)* }
            }
        }
    };
}
use rates;

/// Schemes whose step a model may compute in a cheaper form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shortcut {
    /// Peskin's two stages.
    PeskinRk2,
    /// The classical Runge–Kutta method on the quaternion.
    Rk4Quaternion,
}

impl Shortcut {
    /// Evaluations of the rates in a step.
    pub fn evaluations(self) -> u64 {
        match self {
            Shortcut::PeskinRk2 => 2,
            Shortcut::Rk4Quaternion => 4,
        }
    }
}

/// A body under forces, as a scheme sees it.
pub trait Model {
    /// The arithmetic.
    type Real: Real;
    /// What the model keeps of the motion.
    type State: Clone;
    /// Ω, and as far as the model keeps them U_cm, F/M and τ.
    type Rates: Rates<Self::Real>;

    /// The state at t = 0.
    fn start(&self) -> Self::State;

    /// The model between the jumps of its laws, each with the time that it ends at [s], the last without an end; none where no law
    /// jumps.
    fn pieces(&self) -> Vec<(Self::Real, Self)>
    where
        Self: Sized,
    {
        Vec::new()
    }

    /// Rates at a state: I Ω = L solved for Ω, forces and torques summed.
    ///
    /// # Errors
    /// Ω does not exist.
    fn rates(&self, t: Self::Real, state: &Self::State) -> Result<Self::Rates, Broken>;

    /// Holds `rates` for a time `s` [s] from `from`: X̃ turned by the exact R(Ω, s), X_cm + s U, U_cm + s F/M,
    /// L + s τ. Writes into `into`, a buffer made once a run.
    fn advance(&self, from: &Self::State, s: Self::Real, rates: &Self::Rates, into: &mut Self::State);

    /// Whether every number of a state is finite.
    fn is_finite(&self, state: &Self::State) -> bool;

    /// A state as every model shows it.
    ///
    /// # Errors
    /// Ω does not exist.
    fn observe(&self, t: Self::Real, state: &Self::State) -> Result<Snapshot<Self::Real>, Broken>;

    /// Takes steps of a scheme in place, where the model has a form of it that costs less and whose states differ from those of
    /// the scheme's page by rounding alone. How many were taken before one that the page has to take; `None` where the model has no such
    /// form at this step.
    #[inline(always)]
    fn shortcut(
        &self,
        _of: Shortcut,
        _step: Self::Real,
        _steps: u64,
        _state: &mut Self::State,
    ) -> Option<u64> {
        None
    }

    /// Told by a scheme that it has solved an implicit equation, in so many iterations: work that a harness counts.
    fn solved(&self, _iterations: u32) {}
}

/// A model that turns about principal axes: what schemes in body axes ask for. The mass points are none.
///
/// An attitude takes principal axes to world axes. `advance` moves everything by its rates; `kick` and `drift` are
/// its two halves without the rotation, for splittings and for schemes that turn the body by a rule of their own.
pub trait Turning: Model {
    /// Principal moments and their inverses.
    fn rotational(&self) -> &Rotational<Self::Real>;

    /// The attitude of a state.
    fn attitude(&self, state: &Self::State) -> Rotation<Self::Real>;

    /// L of a state [kg m²/s], world.
    fn momentum(&self, state: &Self::State) -> Vector3<Self::Real>;

    /// Puts attitude and L into a state; a model whose L is constant keeps its own.
    fn place(&self, state: &mut Self::State, attitude: Rotation<Self::Real>, momentum: Vector3<Self::Real>);

    /// Rates at a stage of a scheme that keeps the attitude as plain numbers, and how far they take these in a time: `rates`
    /// held for a time `s` [s] from `from`, but for the attitude, which is q/|q|; `(q, time)` gives time · q̇ = time/2 Ω q.
    /// `stage` is a buffer.
    ///
    /// # Errors
    /// Ω does not exist.
    #[inline(always)]
    fn rates_at_stage(
        &self,
        t: Self::Real,
        (from, s, rates): (&Self::State, Self::Real, &Self::Rates),
        (q, time): (&Quaternion<Self::Real>, Self::Real),
        stage: &mut Self::State,
    ) -> Result<(Self::Rates, Quaternion<Self::Real>), Broken> {
        self.advance(from, s, rates, stage);
        let momentum = self.momentum(stage);
        self.place(stage, rotation::unit(q), momentum);
        let rates = self.rates(t, stage)?;
        Ok((rates, rotation::rate_of(&self.spin_of(&rates), q) * time))
    }

    /// Ω of rates [rad/s], world.
    fn spin_of(&self, rates: &Self::Rates) -> Vector3<Self::Real>;

    /// τ of rates [N m], world.
    fn torque_of(&self, rates: &Self::Rates) -> Vector3<Self::Real>;

    /// U_cm + s F/M and L + s τ, where the model keeps them; positions and attitude stay.
    fn kick(&self, state: &mut Self::State, s: Self::Real, rates: &Self::Rates);

    /// X_cm + s U_cm with the state's own U_cm, where the model keeps it; all else stays.
    fn drift(&self, state: &mut Self::State, s: Self::Real);

    /// How far two states are apart, each part over its own size: the largest of the parts. Ends an iteration.
    fn apart(&self, a: &Self::State, b: &Self::State) -> Self::Real;

    /// Whether a force depends on a velocity, which a splitting into kicks and drifts cannot take.
    fn reads_velocity(&self) -> bool;
}

/// The mass points, as schemes see them that ask more of them than to be turned.
pub trait Pointwise: Model {
    /// `advance` without a rotation: every point of `from` goes straight, by s Ω × X̃ with the X̃ that it has in `at`.
    fn advance_straight(
        &self,
        from: &Self::State,
        s: Self::Real,
        rates: &Self::Rates,
        at: &Self::State,
        into: &mut Self::State,
    );

    /// Rates whose forces are those of `state`, with torques about the lever arms of `levers`.
    ///
    /// # Errors
    /// Ω does not exist.
    fn rates_on_levers(
        &self,
        t: Self::Real,
        state: &Self::State,
        levers: &Self::State,
    ) -> Result<Self::Rates, Broken>;
}

fn finite<T: Real>(vectors: &[&Vector3<T>]) -> bool {
    vectors.iter().all(|v| v.iter().all(|x| x.is_finite()))
}
