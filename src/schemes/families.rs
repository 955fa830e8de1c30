//! What families of schemes promise, stated once.
//!
//! A card names its family and what is special: `claims![ROTATIONS; Order(2), Evaluations(2)]`. Inside the brackets the variants of
//! [`Claim`], [`Quantity`], [`When`] and [`EnergyOfFreeBody`] stand without a prefix. A card lists its claims in the order of
//! [`rank`], whatever the order in the brackets.
//!
//! [`Quantity`]: crate::claim::Quantity
//! [`When`]: crate::claim::When
//! [`EnergyOfFreeBody`]: crate::claim::EnergyOfFreeBody

use crate::claim::Claim;

/// Sums of forces and torques: U_cm changes by F/M and L by τ, each weighted and added as vectors.
pub(super) const MOMENTA: &[Claim] = claims![;
    Exact(Velocity, ConstantForce), Exact(AngularMomentum, NoTorque), VerticalMomentum, Equivariant,
];

/// X_cm follows its parabola under a constant force.
pub(super) const FLIGHT: &[Claim] =
    claims![; Exact(Velocity, ConstantForce), Exact(Position, ConstantForce), Equivariant];

/// Sums of forces and torques, with X_cm on its parabola.
pub(super) const BALLISTIC: &[Claim] = claims![FLIGHT; Exact(AngularMomentum, NoTorque), VerticalMomentum];

/// The body turns by exact rotations about spins in the world.
pub(super) const ROTATIONS: &[Claim] = claims![BALLISTIC;
    Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin), Rigid,
];

/// Euler's method with an exact rotation, and its variants.
pub(super) const EULERS: &[Claim] = claims![MOMENTA;
    Order(1), Exact(Position, NoForce), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin), Rigid,
];

/// A step with −h undoes a step with h.
pub(super) const SYMMETRIC: &[Claim] = claims![BALLISTIC; Rigid, Reversible];

/// One implicit equation a step, symmetric in time.
pub(super) const IMPLICIT: &[Claim] = claims![SYMMETRIC; Solves(1)];

/// Canonical maps of the phase space, symmetric in time.
pub(super) const CANONICAL: &[Claim] = claims![SYMMETRIC; Symplectic];

/// Half a kick, a canonical map of the free body, and half a kick.
pub(super) const KICKS: &[Claim] = claims![CANONICAL; Order(2), Evaluations(1)];

/// Rules of engines: velocities first, then positions by the new velocities.
pub(super) const ENGINES: &[Claim] =
    claims![; Exact(Velocity, ConstantForce), Exact(Position, NoForce), Rigid, Evaluations(1), Equivariant];

/// Place of a claim in a card: orders first, then what is exact, conserved and kept, then the work of a step.
const fn rank(claim: Claim) -> u8 {
    match claim {
        Claim::Order(_) => 0,
        Claim::OrderWithoutTorque(_) => 1,
        Claim::SolvesAnotherMotion => 2,
        Claim::FollowsTolerance(_) => 3,
        Claim::Exact(..) => 4,
        Claim::Energy(_) => 5,
        Claim::VerticalMomentum => 6,
        Claim::FlipTimes => 7,
        Claim::Rigid => 8,
        Claim::Reversible => 9,
        Claim::Symplectic => 10,
        Claim::Equivariant => 11,
        Claim::Evaluations(_) => 12,
        Claim::Solves(_) => 13,
    }
}

/// The claims of a family and those of one scheme, sorted by rank; claims of one rank keep their order.
pub(super) const fn joined<const N: usize>(family: &[Claim], own: &[Claim]) -> [Claim; N] {
    let mut all = [Claim::Rigid; N];
    let mut k = 0;
    while k < N {
        let claim = if k < family.len() { family[k] } else { own[k - family.len()] };
        let mut place = k;
        while place > 0 && rank(all[place - 1]) > rank(claim) {
            all[place] = all[place - 1];
            place -= 1;
        }
        all[place] = claim;
        k += 1;
    }
    all
}

/// The claims of a family, if one is named, and those of one scheme.
macro_rules! claims {
    (; $($own:tt)*) => { $crate::schemes::families::claims![&[]; $($own)*] };
    ($family:expr; $($claim:expr),* $(,)?) => {{
        #[allow(unused_imports, reason = "each card uses some of the names")]
        use $crate::claim::{Claim, Claim::*, EnergyOfFreeBody::*, Quantity::*, When::*};
        const COMMON: &[Claim] = $family;
        const OWN: &[Claim] = &[$($claim),*];
        const ALL: [Claim; COMMON.len() + OWN.len()] = $crate::schemes::families::joined(COMMON, OWN);
        &ALL
    }};
}
pub(super) use claims;
