//! The trait, the list, and one file a scheme; nothing else.
//!
//! A scheme is written in the two verbs of [`Model`] alone, or in those of [`Turning`] where it lives in body
//! axes. It sees no scene, no reference and no gate: it
//! cannot know that it is being examined.

// What schemes share.
mod accelerations;
#[cfg(feature = "solvers")]
pub(crate) mod adaptive;
mod body_form;
mod card;
mod cayley;
mod collocation;
mod composed;
#[cfg(feature = "solvers")]
pub(crate) mod dormand_prince_8;
mod families;
mod iteration;
mod multipliers;
mod preprocessing;
mod semi_implicit;
mod small;
mod splitting;
mod substepped;
#[cfg(feature = "solvers")]
pub(crate) mod taylor;
#[cfg(test)]
mod trees;
mod vector_form;

// The schemes, in the order of the list.
mod peskin_rk2;
mod euler;
mod peskin_heun;
mod peskin_ralston;
mod peskin_trapezoid;
mod peskin_cayley;
mod peskin_rk3;
mod peskin_rk4;
mod course_notes_euler;
mod substepped_4_euler;
mod crouch_grossman_3;
mod rkmk4;
mod magnus_4;
mod strang_rotations;
mod strang_symmetric;
mod exact_rotor;
mod no_squish;
mod rattle;
mod omelyan_leapfrog;
mod moser_veselov;
mod yoshida_4;
mod suzuki_4;
mod kahan_li_6;
mod kahan_li_8;
mod strang_symmetric_6;
mod strang_symmetric_8;
mod exact_rotor_6;
mod exact_rotor_8;
mod rk4_quaternion;
mod rk4_matrix;
mod cooper_verner_8;
mod semi_implicit_euler_no_gyro;
mod semi_implicit_euler_explicit_gyro;
mod semi_implicit_euler_implicit_gyro;
mod momentum_clamped_euler;
mod implicit_midpoint;
mod krysl_liemid;
mod krysl_liemid_ea;
mod simo_wong;
mod buss_augmented;
mod lie_verlet;
mod generalized_alpha;
mod generalized_alpha_constrained;
mod gauss_legendre_4;
mod gauss_legendre_6;
mod cf4;
mod adams_bashforth;
mod adams_bashforth_body;
mod euler_linear;
mod rk2_linear;
mod course_code_euler;

use crate::model::{Broken, Model, Pointwise, Shortcut, Turning};

pub use crate::claim::{Claim, EnergyOfFreeBody, When};
#[doc(no_inline)]
pub use crate::model::Quantity;
pub use card::Card;
pub(crate) use iteration::SOLVED_TO;

/// Rates of earlier steps that are kept without a further allocation.
const HISTORY: usize = 8;

/// Buffers that a scheme works in, made once a run.
#[derive(Clone, Debug)]
pub struct Workspace<M: Model> {
    /// States between those that a step goes from and to, and earlier ones for multistep schemes.
    pub states: Vec<M::State>,
    /// Rates of earlier steps, for multistep schemes, the latest last; empty when a run starts.
    pub history: Vec<M::Rates>,
}

impl<M: Model> Workspace<M> {
    /// Room for a scheme that declares so many states.
    pub fn new(start: &M::State, states: usize) -> Workspace<M> {
        Workspace { states: vec![start.clone(); states], history: Vec::with_capacity(HISTORY) }
    }

    /// Takes the content of another workspace of the same scheme.
    pub fn copy_from(&mut self, other: &Workspace<M>) {
        self.states.clone_from(&other.states);
        self.history.clone_from(&other.history);
    }

    /// The first `N` states, to be borrowed by name: `let [half] = work.buffers();`. They hold what the last step left in them.
    ///
    /// # Panics
    /// The scheme's `STATES` is less than `N`.
    pub fn buffers<const N: usize>(&mut self) -> &mut [M::State; N] {
        self.states.first_chunk_mut().expect("a scheme declares the states that it uses")
    }
}

/// A step from `t` to `t + h`, and the buffers that it works in.
pub struct Step<'a, M: Model> {
    /// t [s].
    pub t: M::Real,
    /// h [s].
    pub h: M::Real,
    /// The state at t.
    pub from: &'a M::State,
    /// The state at t + h, to be written.
    pub to: &'a mut M::State,
    /// Buffers and history.
    pub work: &'a mut Workspace<M>,
}

#[doc(hidden)]
/// Schemes whose step on a free body is also written for many bodies side by side (`ensemble`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SideBySide {
    /// [`Euler`].
    Euler,
    /// [`PeskinRk2`].
    PeskinRk2,
}

impl SideBySide {
    /// Evaluations of the rates in a step.
    pub fn evaluations(self) -> u64 {
        match self {
            SideBySide::Euler => 1,
            SideBySide::PeskinRk2 => 2,
        }
    }
}

/// A time-stepping scheme for every model.
pub trait Scheme: Clone + Send + Sync + 'static {
    /// What it says of itself.
    fn card(&self) -> Card;
    #[doc(hidden)]
    /// Its form for many bodies side by side, if it has one.
    const SIDE_BY_SIDE: Option<SideBySide> = None;
    #[doc(hidden)]
    /// Its name where a model may compute its step in a cheaper form.
    const SHORTCUT: Option<Shortcut> = None;
    /// States that a step needs besides those that it goes from and to.
    const STATES: usize;

    /// One step: reads `from`, writes `to`.
    ///
    /// # Errors
    /// The step cannot be made.
    fn step<M: Model>(&self, model: &M, step: Step<M>) -> Result<(), Broken>;
}

/// A scheme that lives in body axes: for every model but the mass points.
pub trait TurningScheme: Clone + Send + Sync + 'static {
    /// What it says of itself.
    fn card(&self) -> Card;
    #[doc(hidden)]
    /// Its name where a model may compute its step in a cheaper form.
    const SHORTCUT: Option<Shortcut> = None;
    /// States that a step needs besides those that it goes from and to.
    const STATES: usize;
    /// Whether forces may depend on velocities.
    const TAKES_VELOCITY_FORCES: bool;
    /// Whether the body may be a rod or a point, whose moments are not all above zero.
    const TAKES_RODS: bool;
    /// Whether the body may be flat, with a second moment of its mass that is zero.
    const TAKES_PLATES: bool = true;
    /// Whether L is constant without torque, so that a model may leave it out of the state.
    const KEEPS_MOMENTUM: bool = true;

    /// One step: reads `from`, writes `to`.
    ///
    /// # Errors
    /// The step cannot be made.
    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken>;
}

/// A scheme that asks more of the mass points than to be turned: for them alone.
pub trait PointScheme: Clone + Send + Sync + 'static {
    /// What it says of itself.
    fn card(&self) -> Card;
    /// States that a step needs besides those that it goes from and to.
    const STATES: usize;

    /// One step: reads `from`, writes `to`.
    ///
    /// # Errors
    /// The step cannot be made.
    fn step<M: Pointwise>(&self, model: &M, step: Step<M>) -> Result<(), Broken>;
}

/// Something to be done with a scheme whose type is known.
pub(crate) trait Visitor {
    /// What comes of it.
    type Output;
    /// Does it with a scheme for every model.
    fn visit<S: Scheme>(&self, scheme: S) -> Self::Output;
    /// Does it with a scheme in body axes.
    fn visit_turning<S: TurningScheme>(&self, scheme: S) -> Self::Output;
    /// Does it with a scheme for the mass points alone.
    fn visit_points<S: PointScheme>(&self, scheme: S) -> Self::Output;
}

macro_rules! list {
    (
        any: $($module:ident::$scheme:ident),* ;
        turning: $($turning_module:ident::$turning:ident $([$($parameter:ident),*])?),* ;
        points: $($points_module:ident::$points:ident),* ;
    ) => {
        $(pub use $module::$scheme;)*
        $(pub use $turning_module::$turning;)*
        $(pub use $points_module::$points;)*

        /// Calls the visitor with every scheme, in the order of the list.
        pub(crate) fn visit_all<V: Visitor>(visitor: &V) -> Vec<V::Output> {
            let mut all = vec![$(visitor.visit($scheme)),*];
            $(turning!(all, visitor, $turning $([$($parameter),*])?);)*
            $(all.push(visitor.visit_points($points));)*
            all
        }
    };
}

/// A scheme, or its values with these parameters.
macro_rules! turning {
    ($all:ident, $visitor:ident, $scheme:ident) => {
        $all.push($visitor.visit_turning($scheme));
    };
    ($all:ident, $visitor:ident, $scheme:ident [$($parameter:ident),*]) => {
        $($all.push($visitor.visit_turning($scheme::$parameter));)*
    };
}

/// The schemes that a report and a gate cover unless told otherwise: one or two of each family, and those that
/// engines use.
pub const MAIN: [&str; 12] = [
    "peskin-rk2",
    "euler",
    "semi-implicit-euler-no-gyro",
    "semi-implicit-euler-implicit-gyro",
    "rk4-quaternion",
    "buss-augmented",
    "krysl-liemid",
    "simo-wong",
    "implicit-midpoint",
    "strang-symmetric",
    "exact-rotor",
    "moser-veselov-4",
];

/// Number of the colour, marker and dash of a main scheme in every picture.
pub fn look(name: &str) -> Option<usize> {
    MAIN.iter().position(|main| *main == name)
}

list! {
    any:
    peskin_rk2::PeskinRk2,
    euler::Euler,
    peskin_heun::PeskinHeun,
    peskin_ralston::PeskinRalston,
    peskin_trapezoid::PeskinTrapezoid,
    peskin_cayley::PeskinCayley,
    peskin_rk3::PeskinRk3,
    peskin_rk4::PeskinRk4,
    course_notes_euler::CourseNotesEuler,
    substepped_4_euler::Substepped4Euler,
    crouch_grossman_3::CrouchGrossman3,
    rkmk4::Rkmk4,
    magnus_4::Magnus4;
    turning:
    strang_rotations::StrangRotations,
    strang_symmetric::StrangSymmetric,
    exact_rotor::ExactRotor,
    no_squish::NoSquish,
    rattle::Rattle,
    omelyan_leapfrog::OmelyanLeapfrog,
    moser_veselov::MoserVeselov [PLAIN, FOUR, SIX, EIGHT, TEN],
    yoshida_4::Yoshida4,
    suzuki_4::Suzuki4,
    kahan_li_6::KahanLi6,
    kahan_li_8::KahanLi8,
    strang_symmetric_6::StrangSymmetric6,
    strang_symmetric_8::StrangSymmetric8,
    exact_rotor_6::ExactRotor6,
    exact_rotor_8::ExactRotor8,
    rk4_quaternion::Rk4Quaternion,
    rk4_matrix::Rk4Matrix,
    cooper_verner_8::CooperVerner8,
    semi_implicit_euler_no_gyro::SemiImplicitEulerNoGyro,
    semi_implicit_euler_explicit_gyro::SemiImplicitEulerExplicitGyro,
    semi_implicit_euler_implicit_gyro::SemiImplicitEulerImplicitGyro,
    momentum_clamped_euler::MomentumClampedEuler,
    implicit_midpoint::ImplicitMidpoint,
    krysl_liemid::KryslLiemid,
    krysl_liemid_ea::KryslLiemidEa,
    simo_wong::SimoWong,
    buss_augmented::BussAugmented,
    lie_verlet::LieVerlet,
    generalized_alpha::GeneralizedAlpha [HALF],
    generalized_alpha_constrained::GeneralizedAlphaConstrained [NINE_TENTHS],
    gauss_legendre_4::GaussLegendre4,
    gauss_legendre_6::GaussLegendre6,
    cf4::Cf4,
    adams_bashforth::AdamsBashforth [TWO, THREE, FOUR, THREE_COLD, FOUR_COLD],
    adams_bashforth_body::AdamsBashforthBody [TWO, THREE, FOUR];
    points:
    euler_linear::EulerLinear,
    rk2_linear::Rk2Linear,
    course_code_euler::CourseCodeEuler;
}
