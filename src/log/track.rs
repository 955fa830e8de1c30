//! The reference at any time of a log.
//!
//! A short log is compared at its own times, each the end of a step of dop853. For a long one dop853 ends a
//! step at equally spaced nodes, and between them a polynomial of degree 9 through the ten nearest is taken.
//! The spacing is halved until the polynomial through every other node misses the nodes between by less than
//! [`CLOSE`] of each quantity; with twice as many nodes it then does better still. What it misses by is part of
//! the uncertainty that is stated.

use nalgebra::{Quaternion, Vector3};

use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::ode::dop853;
use crate::reference::{Reference, ReferenceError};
use crate::rotation::{self, Rotation};

/// Most times that are solved for one by one.
const ONE_BY_ONE: usize = 4096;
/// Nodes of a polynomial.
const DEGREE: usize = 10;
/// Binomial weights (−1)ʲ C(9, j) of equally spaced nodes.
const WEIGHTS: [f64; DEGREE] = [1.0, -9.0, 36.0, -84.0, 126.0, -126.0, 84.0, -36.0, 9.0, -1.0];
/// Error of interpolation, over the size of a quantity, that is close enough.
const CLOSE: f64 = 1e-11;
/// Most nodes.
const MOST_NODES: usize = 1 << 16;
/// Samples that the reference's own uncertainty is taken at.
const SAMPLES: usize = 64;

/// X, U, Ω, L, q.
type Numbers = [f64; 16];

enum Kind {
    /// Times and states, increasing.
    Solved(Vec<Snapshot>),
    /// States at multiples of a spacing [s].
    Nodes(Vec<Numbers>, f64),
}

/// The exact motion, as far as it is known.
pub(super) struct Track {
    kind: Kind,
    /// What it may be wrong by: of the reference and of the interpolation.
    pub uncertainty: PerQuantity<f64>,
    /// How it was made.
    pub source: String,
}

impl Track {
    /// The motion at `times` [s], which are not negative.
    pub fn of(system: &System, times: &[f64]) -> Result<Track, ReferenceError> {
        let last = times.iter().copied().fold(0.0, f64::max);
        if last == 0.0 {
            let states = dop853::solve(system, &[0.0], dop853::TOLERANCE)?.states;
            let source = "the start itself".to_owned();
            return Ok(Track { kind: Kind::Solved(states), uncertainty: PerQuantity::all(0.0), source });
        }
        // The states below are those of dop853, and so is the uncertainty.
        let reference = Reference::of_solvers(system, last, SAMPLES)?;
        let uncertainty = reference.largest_uncertainty();
        if times.len() <= ONE_BY_ONE && times.windows(2).all(|pair| pair[0] < pair[1]) {
            let states = dop853::solve(system, times, dop853::TOLERANCE)?.states;
            let source = "dop853 at every time of the log".to_owned();
            return Ok(Track { kind: Kind::Solved(states), uncertainty, source });
        }
        Track::of_nodes(system, last, &reference)
    }

    fn of_nodes(system: &System, last: f64, reference: &Reference) -> Result<Track, ReferenceError> {
        let fastest =
            reference.states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
        let mut count = ((last * fastest * 8.0) as usize).clamp(256, MOST_NODES / 4).next_power_of_two();
        loop {
            count *= 2;
            let spacing = last / count as f64;
            let times: Vec<f64> = (0..=count).map(|j| j as f64 * spacing).collect();
            let states = dop853::solve(system, &times, dop853::TOLERANCE)?.states;
            let nodes: Vec<Numbers> = states.iter().map(numbers).collect();
            let (missed, close) = missed(system, &states, &nodes);
            if close || count >= MOST_NODES {
                let orientation = missed[Quantity::Orientation];
                let uncertainty = reference.largest_uncertainty().zip(missed);
                return Ok(Track {
                    kind: Kind::Nodes(nodes, spacing),
                    uncertainty: uncertainty.map(|(reference, missed)| reference + missed),
                    source: format!(
                        "dop853 at {count} nodes, between them polynomials of degree 9, good to {orientation:.1e} rad"
                    ),
                });
            }
        }
    }

    /// The motion from 0 to `last` [s] at any time.
    pub fn dense(system: &System, last: f64) -> Result<Track, ReferenceError> {
        let reference = Reference::of_solvers(system, last, SAMPLES)?;
        Track::of_nodes(system, last, &reference)
    }

    /// Some states of the motion, from its start to its end.
    pub fn samples(&self) -> Vec<Snapshot> {
        match &self.kind {
            Kind::Solved(states) => states.iter().copied().step_by((states.len() / SAMPLES).max(1)).collect(),
            Kind::Nodes(nodes, spacing) => {
                let stride = (nodes.len() / SAMPLES).max(1);
                let state = |(index, numbers): (usize, &Numbers)| snapshot(index as f64 * spacing, numbers);
                nodes.iter().enumerate().step_by(stride).map(state).collect()
            }
        }
    }

    /// The last time that [`Track::truth`] is good for [s].
    pub fn last(&self) -> f64 {
        match &self.kind {
            Kind::Solved(states) => states.last().map_or(0.0, |state| state.time),
            Kind::Nodes(nodes, spacing) => (nodes.len() - 1) as f64 * spacing,
        }
    }

    /// The motion at any time of a track of nodes.
    pub fn truth(&self, time: f64) -> Snapshot {
        self.at(0, time)
    }

    /// The motion at a row of the log: its index among the times, and its time [s].
    pub fn at(&self, index: usize, time: f64) -> Snapshot {
        match &self.kind {
            Kind::Solved(states) => states[index.min(states.len() - 1)],
            Kind::Nodes(nodes, spacing) => snapshot(time, &interpolate(nodes, time / spacing)),
        }
    }
}

/// By how much polynomials through every other node miss the nodes between, and whether that is close enough.
fn missed(system: &System, states: &[Snapshot], nodes: &[Numbers]) -> (PerQuantity<f64>, bool) {
    let coarse: Vec<Numbers> = nodes.iter().copied().step_by(2).collect();
    let (mut missed, mut sizes) = (PerQuantity::all(0.0), PerQuantity::all(0.0));
    for (index, state) in states.iter().enumerate() {
        sizes = sizes.max(PerQuantity::of(|quantity| match quantity {
            Quantity::Position | Quantity::BodyPoint => {
                rotation::length(&state.position) + system.body.extent()
            }
            Quantity::Velocity => rotation::length(&state.velocity),
            Quantity::Orientation => 1.0,
            Quantity::AngularVelocity => rotation::length(&state.angular_velocity),
            Quantity::AngularMomentum => rotation::length(&state.angular_momentum),
        }));
        if index % 2 == 1 {
            let between = snapshot(state.time, &interpolate(&coarse, index as f64 / 2.0));
            missed = missed.max(difference(&system.body, &between, state));
        }
    }
    (missed, missed.zip(sizes).values().all(|(missed, size)| *missed <= CLOSE * size))
}

fn numbers(state: &Snapshot) -> Numbers {
    let q = state.orientation;
    let mut numbers = [0.0; 16];
    let vectors = [&state.position, &state.velocity, &state.angular_velocity, &state.angular_momentum];
    for (index, value) in vectors.into_iter().flatten().chain(&[q.w, q.i, q.j, q.k]).enumerate() {
        numbers[index] = *value;
    }
    numbers
}

fn snapshot(time: f64, n: &Numbers) -> Snapshot {
    Snapshot {
        time,
        position: Vector3::new(n[0], n[1], n[2]),
        velocity: Vector3::new(n[3], n[4], n[5]),
        angular_velocity: Vector3::new(n[6], n[7], n[8]),
        angular_momentum: Vector3::new(n[9], n[10], n[11]),
        orientation: Rotation::new_normalize(Quaternion::new(n[12], n[13], n[14], n[15])),
        stretch: 0.0,
    }
}

/// The value at `place`, in spacings from the first node, by the barycentric formula.
fn interpolate(nodes: &[Numbers], place: f64) -> Numbers {
    let first = ((place.floor() as isize) - (DEGREE as isize / 2 - 1))
        .clamp(0, (nodes.len() - DEGREE) as isize) as usize;
    let (mut sum, mut total) = ([0.0; 16], 0.0);
    for (j, weight) in WEIGHTS.iter().enumerate() {
        let away = place - (first + j) as f64;
        if away == 0.0 {
            return nodes[first + j];
        }
        let share = weight / away;
        total += share;
        for (s, value) in sum.iter_mut().zip(&nodes[first + j]) {
            *s += share * value;
        }
    }
    sum.map(|s| s / total)
}
