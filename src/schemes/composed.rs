//! Symmetric compositions of a symmetric scheme: the base's step taken with steps γ₁ h, γ₂ h, …, γ₂ h, γ₁ h.
//!
//! (1)  s ← base(t + c h, γ h, s),  c ← c + γ       for every γ in turn
//!
//! What the base hands on from step to step goes from sub-step to sub-step as well.

use super::{Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Turning};

/// One step of `base` composed; `half` holds γ₁, γ₂, … up to the middle one, and the others mirror them. The last state of the workspace
/// is the composition's own.
pub(super) fn composed<M: Turning, S: TurningScheme>(
    base: &S,
    half: &[M::Real],
    model: &M,
    Step { t, h, from, to, work }: Step<M>,
) -> Result<(), Broken> {
    let Some(mut now) = work.states.pop() else {
        unreachable!("a workspace has as many states as the scheme asks for")
    };
    now.clone_from(from);
    let mirrored = half.iter().rev().skip(1);
    let (mut c, mut result) = (M::Real::of(0.0), Ok(()));
    for gamma in half.iter().chain(mirrored) {
        result = base
            .step(model, Step { t: t + c * h, h: *gamma * h, from: &now, to: &mut *to, work: &mut *work }); // (1)
        if result.is_err() {
            break;
        }
        std::mem::swap(&mut now, to);
        c += *gamma; // (1)
    }
    std::mem::swap(&mut now, to);
    work.states.push(now);
    result
}

/// Declares a composition of a symmetric scheme.
macro_rules! composition {
    ($(#[$doc:meta])* $scheme:ident of $base:ident by $half:path, $card:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $scheme;

        impl $crate::schemes::TurningScheme for $scheme {
            fn card(&self) -> $crate::schemes::Card {
                $card
            }

            const STATES: usize = $crate::schemes::$base::STATES + 1;
            const TAKES_VELOCITY_FORCES: bool = $crate::schemes::$base::TAKES_VELOCITY_FORCES;
            const TAKES_RODS: bool = $crate::schemes::$base::TAKES_RODS;

            fn step<M: $crate::model::Turning>(
                &self,
                model: &M,
                step: $crate::schemes::Step<M>,
            ) -> Result<(), $crate::model::Broken> {
                $crate::schemes::composed::composed(&$crate::schemes::$base, &$half(), model, step)
            }
        }
    };
}
pub(super) use composition;

#[cfg(test)]
mod tests {
    use super::super::{
        ExactRotor6, ExactRotor8, KahanLi6, KahanLi8, StrangSymmetric6, StrangSymmetric8, Suzuki4, Yoshida4,
        kahan_li_6, kahan_li_8, suzuki_4, yoshida_4,
    };
    use super::*;
    use crate::arithmetic::DoubleDouble;

    /// Σ γᵏ for odd k below the order, over Σ |γ|ᵏ, and how far Σ γ is from 1.
    fn worst_of_the_power_sums<T: Real>(half: &[T], order: i32) -> f64 {
        let all = || half.iter().chain(half.iter().rev().skip(1)).copied();
        let ones = (all().sum::<T>() - 1.0).to_f64().abs();
        (3..order).step_by(2).fold(ones, |worst, power| {
            let sum: T = all().map(|gamma| gamma.powi(power)).sum();
            let size: T = all().map(|gamma| gamma.abs().powi(power)).sum();
            worst.max((sum / size).to_f64().abs())
        })
    }

    fn satisfies_the_power_sums(
        scheme: &impl TurningScheme,
        half: &[f64],
        precise: &[DoubleDouble],
        digits: f64,
    ) {
        let order = scheme.card().order() as i32;
        // Each of up to 17 powers is good to power × u/2 of its size, which is below 5.
        assert!(
            worst_of_the_power_sums(half, order) < f64::from(order) * f64::EPSILON,
            "{}",
            scheme.card().name
        );
        assert!(worst_of_the_power_sums(precise, order) < digits, "{}", scheme.card().name);
        assert_eq!(scheme.card().evaluations() as usize, 2 * half.len() - 1);
    }

    #[test]
    fn the_coefficients_satisfy_the_power_sums_of_their_order() {
        satisfies_the_power_sums(&Yoshida4, &yoshida_4::half(), &yoshida_4::half(), 1e-30);
        satisfies_the_power_sums(&Suzuki4, &suzuki_4::half(), &suzuki_4::half(), 1e-30);
        // Twenty digits are printed.
        let (six, precise) = (kahan_li_6::half(), kahan_li_6::half());
        satisfies_the_power_sums(&KahanLi6, &six, &precise, 1e-19);
        satisfies_the_power_sums(&StrangSymmetric6, &six, &precise, 1e-19);
        satisfies_the_power_sums(&ExactRotor6, &six, &precise, 1e-19);
        let (eight, precise) = (kahan_li_8::half(), kahan_li_8::half());
        satisfies_the_power_sums(&KahanLi8, &eight, &precise, 1e-18);
        satisfies_the_power_sums(&StrangSymmetric8, &eight, &precise, 1e-18);
        satisfies_the_power_sums(&ExactRotor8, &eight, &precise, 1e-18);
    }
}
