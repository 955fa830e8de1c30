//! Half kick, free flow, half kick: what the splittings of this directory share.
//!
//! (1)  L ← L + h/2 τ(t),  U_cm ← U_cm + h/2 F(t)/M
//! (2)  R ← R Q,  X_cm ← X_cm + h U_cm                    Q: the turn of the free body in principal axes
//! (3)  L ← L + h/2 τ(t+h),  U_cm ← U_cm + h/2 F(t+h)/M
//!
//! A scheme is a rule for Q. Forces see positions only, so that those of (3) are those of the next step's (1): they
//! are handed on, and a run of n steps evaluates them n + 1 times. L is kept in world axes, where (2) does not
//! touch it: L without torque, and L·g of a top, are exact whatever the rule is.

use nalgebra::Vector3;

use super::Step;
use crate::model::{Broken, Rotational, Turning};
use crate::rotation::{self, Rotation};

/// One step (1)–(3) with the rule `turn`: the turn of a free body in a time h, from L in principal axes.
#[inline]
pub(super) fn kick_turn_kick<M: Turning>(
    turn: impl Fn(&Rotational<M::Real>, &Vector3<M::Real>, M::Real) -> Result<Rotation<M::Real>, Broken>,
    model: &M,
    Step { t, h, from, to, work }: Step<M>,
) -> Result<(), Broken> {
    let first = match work.history.pop() {
        Some(rates) => rates,
        None => model.rates(t, from)?,
    };
    to.clone_from(from);
    model.kick(to, h / 2.0, &first); // (1)
    let (attitude, momentum) = (model.attitude(to), model.momentum(to));
    let q = turn(model.rotational(), &rotation::turned_back(&attitude, &momentum), h)?;
    model.place(to, rotation::renormalized(attitude * q), momentum); // (2)
    model.drift(to, h); // (2)
    let last = model.rates(t + h, to)?;
    model.kick(to, h / 2.0, &last); // (3)
    work.history.push(last);
    Ok(())
}

/// Declares a scheme that is (1)–(3) with a rule for the turn.
macro_rules! splitting {
    ($(#[$doc:meta])* $scheme:ident, $turn:path, $card:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $scheme;

        impl $crate::schemes::TurningScheme for $scheme {
            fn card(&self) -> $crate::schemes::Card {
                $card
            }

            const STATES: usize = 0;
            const TAKES_VELOCITY_FORCES: bool = false;
            const TAKES_RODS: bool = false;

            fn step<M: $crate::model::Turning>(
                &self,
                model: &M,
                step: $crate::schemes::Step<M>,
            ) -> Result<(), $crate::model::Broken> {
                $crate::schemes::splitting::kick_turn_kick($turn, model, step)
            }
        }
    };
}
pub(super) use splitting;
