//! Solvers that choose their own steps, put under test beside the schemes: two of our own, and what a user gets from a library
//! of ordinary differential equations.
//!
//! Those of a library are given the Euler equations of [`Equations`]; all are given a tolerance in place of a step. So that they climb the same ladder
//! as everybody, a step h stands for a tolerance:
//!
//! ```text
//! (1)  tolerance = (h/τ)ⁿ, kept between 1e-13 and 0.1
//! ```
//!
//! with τ the time unit of the scene and n one above the order of the method, five at most, so that six halvings of h stay
//! between the bounds: the step that the error control settles at is then
//! about in proportion to h, and so is the cost to 1/h. They claim no order in h but that the error follows the tolerance.
//! Every stored time ends a step, and nothing is interpolated, but for `taylor`, whose polynomials are as good between steps.

use std::cell::RefCell;

use diffsol::{NalgebraLU, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector};

use super::{Card, dormand_prince_8, taylor};
use crate::claim::Claim;
use crate::interrupt;
use crate::model::System;
use crate::ode::equations::{DIMENSION, Equations, State};
use crate::ode::run::{self, MOST_EVALUATIONS, Run};
use crate::ode::units::Units;
use crate::ode::{SolverError, dop853, tsit45};

type Matrix = diffsol::NalgebraMat<f64>;

/// Bounds of the tolerance: below, no solver here gets better; above, none is of use.
const TOLERANCES: (f64, f64) = (1e-13, 0.1);
/// Displacement for the derivatives of the equations, in units of the scene; central differences leave its square.
const DISPLACEMENT: f64 = 1e-6;

type Solve = fn(&System, &[f64], f64) -> Result<Run, SolverError>;

/// A solver that chooses its own steps, and what it says of itself.
#[derive(Clone, Debug)]
pub struct Adaptive {
    /// What it says of itself.
    pub card: Card,
    /// Why it cannot take a system, if it cannot.
    pub refusal: fn(&System) -> Option<String>,
    solve: Solve,
}

impl Adaptive {
    /// The solvers under test.
    pub const ALL: [Adaptive; 7] = [
        Adaptive {
            refusal: taylor::refusal,
            ..Adaptive::new(
                "taylor",
                "Taylor series by recurrences, order and steps chosen by tolerance",
                "jorba2005",
                &[Claim::FollowsTolerance(5)],
                taylor::solve,
            )
        },
        Adaptive::new(
            "tsit45",
            "Tsitouras' order 5, steps chosen by tolerance (diffsol)",
            "tsitouras2011",
            &[Claim::FollowsTolerance(5)],
            tsit45::solve,
        ),
        Adaptive::new(
            "dop853",
            "Dormand and Prince's order 8, steps chosen by tolerance (differential-equations)",
            "hairer1993",
            &[Claim::FollowsTolerance(5)],
            dop853::solve,
        ),
        Adaptive::new(
            "dormand-prince-8",
            "Dormand and Prince's order 8 in body axes, steps chosen by tolerance",
            "hairer1993",
            &[Claim::FollowsTolerance(5)],
            dormand_prince_8::solve,
        ),
        Adaptive::new(
            "bdf",
            "backward differences of orders 1 to 5, both chosen by tolerance (diffsol)",
            "shampine1997",
            &[Claim::FollowsTolerance(4)],
            bdf,
        ),
        Adaptive::new(
            "esdirk34",
            "ESDIRK of order 3, steps chosen by tolerance (diffsol)",
            "jorgensen2018",
            &[Claim::FollowsTolerance(4)],
            esdirk34,
        ),
        Adaptive::new(
            "tr-bdf2",
            "trapezoidal rule and BDF2, steps chosen by tolerance (diffsol)",
            "hosea1996",
            &[Claim::FollowsTolerance(3)],
            tr_bdf2,
        ),
    ];

    const fn new(
        name: &'static str,
        title: &'static str,
        source: &'static str,
        claims: &'static [Claim],
        solve: Solve,
    ) -> Adaptive {
        Adaptive { card: Card { name, title, family: "adaptive", source, claims }, refusal: |_| None, solve }
    }

    /// The states at increasing `times` [s], the last of which ends the run, for the tolerance that a step `h` [s] stands for.
    ///
    /// # Errors
    /// The solver gives no solution.
    pub fn solve(&self, system: &System, times: &[f64], h: f64) -> Result<Run, SolverError> {
        let duration = times.last().copied().unwrap_or_default();
        let unit = Units::of(system, duration).time;
        let tolerance = (h / unit).powi(self.card.tolerance_exponent() as i32); // (1)
        (self.solve)(system, times, tolerance.clamp(TOLERANCES.0, TOLERANCES.1))
    }
}

/// Declares a solver of diffsol that asks for derivatives of the equations.
macro_rules! implicit {
    ($method:ident, $name:literal) => {
        fn $method(system: &System, times: &[f64], tolerance: f64) -> Result<Run, SolverError> {
            let equations = run::checked(system, times, $name)?;
            let refused = |time: f64, reason: String| SolverError::NoConvergence {
                method: $name,
                time,
                evaluations: equations.evaluations(),
                reason,
            };
            let start = equations.start();
            let derivative = Derivative::new(&equations);
            let problem = OdeBuilder::<Matrix>::new()
                .rtol(tolerance)
                .atol([tolerance])
                .rhs_implicit(
                    |y: &[f64], _: &[f64], s, rate: &mut [f64]| equations.rate(s, y, rate),
                    |y: &[f64], _: &[f64], s, v: &[f64], into: &mut [f64]| derivative.along(s, y, v, into),
                )
                .init(move |_: &[f64], _, y: &mut [f64]| y.copy_from_slice(&start), DIMENSION)
                .build()
                .map_err(|error| refused(0.0, error.to_string()))?;
            let method =
                problem.$method::<NalgebraLU<f64>>().map_err(|error| refused(0.0, error.to_string()))?;
            outputs(&equations, method, times).map_err(|(time, reason)| refused(time, reason))
        }
    };
}

implicit!(bdf, "bdf");
implicit!(esdirk34, "esdirk34");
implicit!(tr_bdf2, "tr-bdf2");

/// The derivative of the equations along a direction, by central differences.
struct Derivative<'a> {
    equations: &'a Equations<'a>,
    /// A displaced state, and the rates there.
    buffers: RefCell<(State, State)>,
}

impl<'a> Derivative<'a> {
    fn new(equations: &'a Equations<'a>) -> Derivative<'a> {
        Derivative { equations, buffers: RefCell::new(([0.0; DIMENSION], [0.0; DIMENSION])) }
    }

    fn along(&self, s: f64, y: &[f64], v: &[f64], into: &mut [f64]) {
        let mut buffers = self.buffers.borrow_mut();
        let (displaced, back) = &mut *buffers;
        let length = v.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        if length == 0.0 {
            into.fill(0.0);
            return;
        }
        let by = DISPLACEMENT / length;
        let mut rate_at = |sign: f64, rate: &mut [f64]| {
            for (place, (y, v)) in displaced.iter_mut().zip(y.iter().zip(v)) {
                *place = y + sign * by * v;
            }
            self.equations.rate(s, displaced.as_slice(), rate);
        };
        rate_at(1.0, into);
        rate_at(-1.0, back.as_mut_slice());
        for (forward, back) in into.iter_mut().zip(back.iter()) {
            *forward = (*forward - back) / (2.0 * by);
        }
    }
}

/// Takes a solver from output to output; where it fails, the time that it has reached and what it says.
fn outputs<'p, E, S>(equations: &Equations, mut method: S, times: &[f64]) -> Result<Run, (f64, String)>
where
    E: OdeEquations<T = f64> + 'p,
    S: OdeSolverMethod<'p, E>,
{
    let mut states = Vec::with_capacity(times.len());
    for time in times {
        if *time > 0.0 {
            let fault = |why: String| (*time, why);
            method.set_stop_time(time / equations.units().time).map_err(|e| fault(e.to_string()))?;
            while !matches!(
                method.step().map_err(|e| fault(e.to_string()))?,
                OdeSolverStopReason::TstopReached
            ) {
                if equations.evaluations() > MOST_EVALUATIONS {
                    return Err(fault(format!("more than {MOST_EVALUATIONS} evaluations")));
                }
                if interrupt::requested() {
                    return Err(fault("interrupted".to_owned()));
                }
            }
        }
        let mut reached = [0.0; DIMENSION];
        for (index, value) in reached.iter_mut().enumerate() {
            *value = method.state().y.get_index(index);
        }
        if !reached.iter().all(|x| x.is_finite()) {
            return Err((*time, "the state is not finite".to_owned()));
        }
        states.push(equations.observe(*time, &reached));
    }
    Ok(Run { states, evaluations: equations.evaluations() })
}
