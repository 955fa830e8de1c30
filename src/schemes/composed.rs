//! Symmetric compositions of a symmetric scheme: the base's step taken with steps γ₁ h, γ₂ h, …, γ₂ h, γ₁ h.
//!
//! (1)  s ← base(t + c h, γ h, s),  c ← c + γ       for every γ in turn
//!
//! What the base hands on from step to step goes from sub-step to sub-step as well.

use std::marker::PhantomData;

use super::{Card, TurningScheme, Workspace};
use crate::model::{Broken, Turning};

/// The sub-steps of a composition.
pub trait Composition: 'static {
    /// The scheme that is composed: symmetric, of even order.
    type Base: TurningScheme;
    /// Array of the coefficients.
    type Half: AsRef<[f64]>;
    /// What the composition says of itself.
    const CARD: Card;

    /// γ₁, γ₂, … up to the middle one; the others mirror them.
    fn half() -> Self::Half;
}

/// A composition as a scheme.
#[derive(Clone, Copy, Debug)]
pub struct Composed<C>(PhantomData<C>);

impl<C: Composition> TurningScheme for Composed<C> {
    const CARD: Card = C::CARD;
    const STATES: usize = C::Base::STATES + 1;
    const TAKES_VELOCITY_FORCES: bool = C::Base::TAKES_VELOCITY_FORCES;
    const TAKES_RODS: bool = C::Base::TAKES_RODS;

    fn step<M: Turning>(
        model: &M,
        t: f64,
        h: f64,
        from: &M::State,
        to: &mut M::State,
        work: &mut Workspace<M>,
    ) -> Result<(), Broken> {
        let Some(mut now) = work.states.pop() else {
            unreachable!("a workspace has as many states as the scheme asks for")
        };
        now.clone_from(from);
        let half = C::half();
        let mirrored = half.as_ref().iter().rev().skip(1);
        let (mut c, mut result) = (0.0, Ok(()));
        for gamma in half.as_ref().iter().chain(mirrored) {
            result = C::Base::step(model, t + c * h, gamma * h, &now, to, work); // (1)
            if result.is_err() {
                break;
            }
            std::mem::swap(&mut now, to);
            c += gamma; // (1)
        }
        std::mem::swap(&mut now, to);
        work.states.push(now);
        result
    }
}

#[cfg(test)]
mod tests {
    use super::super::kahan_li_6::NineSteps;
    use super::super::kahan_li_8::SeventeenSteps;
    use super::super::suzuki_4::Fractal;
    use super::super::yoshida_4::TripleJump;
    use super::*;

    fn satisfies_the_power_sums<C: Composition>() {
        let half = C::half();
        let all = || half.as_ref().iter().chain(half.as_ref().iter().rev().skip(1));
        assert!((all().sum::<f64>() - 1.0).abs() < 1e-15, "{}", C::CARD.name);
        for power in (3..C::CARD.order() as i32).step_by(2) {
            // Each of up to 17 powers is good to power × u/2 of its size, which is below 5.
            let sum: f64 = all().map(|gamma| gamma.powi(power)).sum();
            let size: f64 = all().map(|gamma| gamma.abs().powi(power)).sum();
            assert!(sum.abs() < f64::from(power) * f64::EPSILON * size, "{} {power}: {sum:e}", C::CARD.name);
        }
        assert_eq!(C::CARD.evaluations() as usize, all().count());
    }

    #[test]
    fn the_coefficients_satisfy_the_power_sums_of_their_order() {
        satisfies_the_power_sums::<TripleJump>();
        satisfies_the_power_sums::<Fractal>();
        satisfies_the_power_sums::<NineSteps>();
        satisfies_the_power_sums::<SeventeenSteps>();
    }
}
