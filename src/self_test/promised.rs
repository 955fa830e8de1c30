//! Claims that the scheme does not keep.

use super::planted::{FREE, Plant, Row};
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};

/// An order that is too high shows in the times of flips, too.
const FLIPS: &[&str] = &["free-asymmetric", "mujoco-middle-axis", "dzhanibekov"];

/// Claims that are not kept.
pub(super) const CLAIMS: &[Row] = &[
    ("first order claimed for the second", Plant::Claims("peskin-rk2", &[Claim::Order(1)]), FREE),
    (
        "third order claimed for the second",
        Plant::Claims("peskin-rk2", &[Claim::Order(3), Claim::FlipTimes]),
        FLIPS,
    ),
    (
        "second order claimed for the first",
        Plant::Claims("euler", &[Claim::Order(2), Claim::FlipTimes]),
        FLIPS,
    ),
    (
        "fourth order claimed for the third",
        Plant::Claims("peskin-rk3", &[Claim::Order(4), Claim::FlipTimes]),
        FLIPS,
    ),
    ("first order claimed for none", Plant::Claims("semi-implicit-euler-no-gyro", &[Claim::Order(1)]), FREE),
    (
        "order without torque claimed too high",
        Plant::Claims("peskin-rk2", &[Claim::Order(2), Claim::OrderWithoutTorque(4), Claim::FlipTimes]),
        FLIPS,
    ),
    (
        "orientation claimed exact without torque",
        Plant::Claims("peskin-rk2", &[Claim::Order(2), Claim::Exact(Quantity::Orientation, When::NoTorque)]),
        &["free-asymmetric"],
    ),
    (
        "position claimed exact under a constant force",
        Plant::Claims("euler", &[Claim::Order(1), Claim::Exact(Quantity::Position, When::ConstantForce)]),
        &["osrf-boxes-complex", "nasa-check-case-2"],
    ),
    (
        "angular momentum claimed exact by a rule that loses it",
        Plant::Claims(
            "semi-implicit-euler-no-gyro",
            &[Claim::Exact(Quantity::AngularMomentum, When::NoTorque)],
        ),
        &["free-asymmetric"],
    ),
    (
        "rate of the energy claimed of second order",
        Plant::Claims("peskin-rk2", &[Claim::Energy(EnergyOfFreeBody::GrowsSecularly { rate_order: 2 })]),
        &["free-asymmetric"],
    ),
    (
        "energy claimed bounded",
        Plant::Claims("peskin-rk2", &[Claim::Energy(EnergyOfFreeBody::Bounded)]),
        &["free-asymmetric"],
    ),
    (
        "energy claimed constant",
        Plant::Claims("strang-rotations", &[Claim::Energy(EnergyOfFreeBody::Constant)]),
        &["free-asymmetric"],
    ),
    (
        "energy claimed to fall",
        Plant::Claims("peskin-rk2", &[Claim::Energy(EnergyOfFreeBody::Falls)]),
        &["free-asymmetric"],
    ),
    (
        "one evaluation claimed for two",
        Plant::Claims("peskin-rk2", &[Claim::Order(2), Claim::Evaluations(1)]),
        FREE,
    ),
    (
        "three evaluations claimed for two",
        Plant::Claims("peskin-rk2", &[Claim::Order(2), Claim::Evaluations(3)]),
        FREE,
    ),
    (
        "an implicit equation claimed for none",
        Plant::Claims("peskin-rk2", &[Claim::Order(2), Claim::Solves(1)]),
        FREE,
    ),
    ("claimed reversible", Plant::Claims("peskin-rk2", &[Claim::Order(2), Claim::Reversible]), FREE),
    ("claimed symplectic", Plant::Claims("implicit-midpoint", &[Claim::Order(2), Claim::Symplectic]), FREE),
    ("claimed rigid without being so", Plant::Claims("rk2-linear", &[Claim::Order(2), Claim::Rigid]), FREE),
    (
        "vertical momentum claimed constant",
        Plant::Claims("implicit-midpoint", &[Claim::Order(2), Claim::VerticalMomentum]),
        &["heavy-asymmetric-top", "kovalevskaya"],
    ),
    (
        "flip times claimed of a rule that does not flip",
        Plant::Claims("semi-implicit-euler-no-gyro", &[Claim::Order(1), Claim::FlipTimes]),
        &["dzhanibekov", "mujoco-middle-axis"],
    ),
];
