//! Which convention a log follows: dq/dt held against w under every one.
//!
//! Between two rows the relative rotation over their distance in time is the mean angular velocity: log(q₁
//! q₀*)/Δt in world axes, log(q₀* q₁)/Δt in body axes, where q takes body axes to world axes; a quaternion that
//! takes world axes to body axes is conjugated first. Under the right convention this is the mean of w to
//! O(Δt²). The factor between both is fitted too: where it is not one, a unit is.

use nalgebra::{Quaternion, Vector3};

use super::row::{Log, Part, Parts, Row};
use crate::rotation::{self, Rotation};

/// Pairs of rows that are looked at.
const PAIRS: usize = 20_000;
/// Radians turned between two rows, above which a pair says nothing.
const WIDEST_TURN: f64 = 1.0;
/// Fewest pairs that say something.
const FEWEST_PAIRS: usize = 3;
/// What may be left of the angular velocity, relative, under a convention that fits.
const FITS: f64 = 0.1;
/// How many times better than the others a convention must be to be the only one.
const BETTER: f64 = 4.0;
/// Remainder below which rounding or the log's own digits decide.
const NOTHING_LEFT: f64 = 1e-6;

/// How a log writes angular velocity and orientation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Convention {
    /// Whether w is in body axes; else in world axes.
    pub spin_in_body_axes: bool,
    /// Whether q takes world axes to body axes; else body axes to world axes.
    pub world_to_body: bool,
}

impl Convention {
    /// All four.
    pub const ALL: [Convention; 4] = [
        Convention { spin_in_body_axes: false, world_to_body: false },
        Convention { spin_in_body_axes: true, world_to_body: false },
        Convention { spin_in_body_axes: false, world_to_body: true },
        Convention { spin_in_body_axes: true, world_to_body: true },
    ];

    /// The options that name it.
    pub fn words(self) -> String {
        let spin = if self.spin_in_body_axes { "body" } else { "world" };
        let quaternion = if self.world_to_body { "world-to-body" } else { "body-to-world" };
        format!("--angular-velocity {spin} --quaternion {quaternion}")
    }

    /// Orientation from body axes to world axes.
    pub(super) fn orientation(self, row: &Row) -> Rotation {
        let [w, x, y, z] = row.numbers(Part::Orientation);
        let q = Rotation::new_normalize(Quaternion::new(w, x, y, z));
        if self.world_to_body { q.inverse() } else { q }
    }
}

/// How a convention fits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The convention.
    pub convention: Convention,
    /// s in dq/dt = s · ½ w q: one where the units are right.
    pub factor: f64,
    /// What is left of the angular velocity, relative.
    pub left: f64,
}

/// What the check says.
#[derive(Clone, Debug, PartialEq)]
pub enum FrameCheck {
    /// One convention fits.
    Follows(Fit),
    /// Several fit alike: the motion does not tell them apart.
    Alike(Vec<Fit>),
    /// None fits; the best.
    None(Fit),
    /// There is nothing to check.
    Nothing(&'static str),
}

/// Holds a log against every convention. `known` is the convention that
/// was declared, where the orientations under it are those of the reference; `fastest` the largest angular velocity of the reference
/// [rad/s], where there is one: a body that turns by more than a radian between two rows may show any turn.
pub(super) fn check(log: &Log, known: Option<Convention>, fastest: f64) -> FrameCheck {
    if !log.parts.covers(Parts::of(&[Part::Orientation, Part::Spin])) {
        return FrameCheck::Nothing("it needs qw, qx, qy, qz and wx, wy, wz");
    }
    let stride = (log.rows.len() / PAIRS).max(1);
    let says = |pair: &&[Row]| says_something(pair, fastest);
    let pairs: Vec<&[Row]> = log.pairs().step_by(stride).filter(says).collect();
    if pairs.len() < FEWEST_PAIRS {
        return FrameCheck::Nothing(
            "fewer than three pairs of rows are less than a radian apart: the rows are too far apart to check w",
        );
    }
    let fits = Convention::ALL.map(|convention| fit(convention, &pairs));
    if fits.iter().all(|fit| fit.factor == 0.0) {
        return FrameCheck::Nothing("the body does not turn");
    }
    choose(&fits, known)
}

/// With its sign turned, w fits one convention as well as it fits another without. Where the sense of the
/// quaternion is known the sign decides nothing; otherwise of each such pair the one with the sign as written
/// is meant.
fn choose(fits: &[Fit], known: Option<Convention>) -> FrameCheck {
    let meant = |fit: &Fit| {
        known.map_or(fit.factor > 0.0, |known| fit.convention.world_to_body == known.world_to_body)
    };
    let mut upright: Vec<Fit> = fits.iter().copied().filter(meant).collect();
    upright.sort_by(|a, b| a.left.total_cmp(&b.left));
    let Some(best) = upright.first().copied() else { return FrameCheck::None(fits[0]) };
    if best.left > FITS {
        return FrameCheck::None(best);
    }
    let close = |fit: &Fit| fit.left <= BETTER * best.left.max(NOTHING_LEFT) && fit.left <= FITS;
    upright.retain(close);
    if upright.len() == 1 { FrameCheck::Follows(best) } else { FrameCheck::Alike(upright) }
}

fn says_something(pair: &[Row], fastest: f64) -> bool {
    let both = Parts::of(&[Part::Orientation, Part::Spin]);
    let apart = pair[1].time() - pair[0].time();
    pair.iter().all(|row| row.parts.covers(both))
        && apart > 0.0
        && apart * fastest < WIDEST_TURN
        && rotation::length(&turn(pair, Convention::ALL[0])) < WIDEST_TURN
}

/// Rotation vector from the first row to the second [rad], in the axes of w under a convention.
fn turn(pair: &[Row], convention: Convention) -> Vector3<f64> {
    let (a, b) = (convention.orientation(&pair[0]), convention.orientation(&pair[1]));
    rotation::vector_of(&if convention.spin_in_body_axes { a.inverse() * b } else { b * a.inverse() })
}

/// Least squares of |Δ/Δt − s w̄|².
fn fit(convention: Convention, pairs: &[&[Row]]) -> Fit {
    let (mut moved, mut both, mut written) = (0.0, 0.0, 0.0);
    for pair in pairs {
        let rate = turn(pair, convention) / (pair[1].time() - pair[0].time());
        let mean = (pair[0].vector(Part::Spin) + pair[1].vector(Part::Spin)) * 0.5;
        moved += rate.norm_squared();
        both += rate.dot(&mean);
        written += mean.norm_squared();
    }
    if written == 0.0 || moved == 0.0 {
        return Fit { convention, factor: 0.0, left: 1.0 };
    }
    let left = ((moved - both * both / written).max(0.0) / moved).sqrt();
    Fit { convention, factor: both / written, left }
}
