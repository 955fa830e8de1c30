//! Errors and drifts of a log, over all of its rows at once.

use nalgebra::{Quaternion, Vector3};
use rayon::prelude::*;

use super::file::{Log, Part, Row};
use super::hints::{Orientations, Sums};
use super::track::Track;
use super::{Convention, Finding, Value};
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::rotation::{self, Rotation};
use crate::scenes::Scene;

/// Rows that one thread takes at a time.
const CHUNK: usize = 1 << 13;
/// Length of a quaternion, less one, from which on it is told.
const UNIT: f64 = 1e-3;

/// Drifts: name, unit.
const DRIFTS: [(&str, &str); 3] =
    [("total-energy", "1"), ("angular-momentum-magnitude", "1"), ("angular-momentum-direction", "rad")];

pub(super) struct Measured {
    pub findings: Vec<Finding>,
    pub hints: Vec<String>,
    pub notes: Vec<String>,
    /// Whether the orientations, as they were declared, are the reference's.
    pub orientations_agree: bool,
}

/// What is gathered over the rows.
#[derive(Clone, Copy, Default)]
struct Gathered {
    errors: PerQuantity<f64>,
    drifts: [f64; 3],
    kinetic: f64,
    sums: [Sums; 3],
    orientations: Orientations,
    unit: f64,
    end: (PerQuantity<f64>, [f64; 3]),
}

struct Reader<'a> {
    log: &'a Log,
    system: &'a System,
    declared: Convention,
    track: Option<&'a Track>,
    first: Option<Conserved>,
}

/// Energy and angular momentum of a row.
#[derive(Clone, Copy)]
struct Conserved {
    kinetic: f64,
    potential: f64,
    momentum: Vector3<f64>,
}

pub(super) fn measure(
    log: &Log,
    scene: &Scene,
    track: Result<&Track, &String>,
    declared: Convention,
) -> Measured {
    let mut reader = Reader { log, system: &scene.system, declared, track: track.ok(), first: None };
    reader.first = Some(reader.conserved(&reader.snapshot(&log.rows[0], None)));
    let chunks: Vec<Gathered> = log
        .rows
        .par_chunks(CHUNK)
        .enumerate()
        .map(|(chunk, rows)| reader.gather(rows, chunk * CHUNK))
        .collect();
    let gathered = chunks.iter().fold(Gathered::default(), |all, chunk| all.joined(chunk));
    let mut hints = gathered.orientations.hints();
    for (sums, part) in gathered.sums.iter().zip([Part::Position, Part::Velocity, Part::Spin]) {
        hints.extend(sums.hints(part));
    }
    let mut notes = Vec::new();
    if gathered.unit > UNIT {
        notes.push(format!(
            "quaternions are off unit length by up to {:.2e} and were normalised",
            gathered.unit
        ));
    }
    let mut findings = errors(&reader, track, &gathered);
    findings.extend(drifts(&reader, &gathered));
    Measured { findings, hints, notes, orientations_agree: gathered.orientations.agree() }
}

fn errors(reader: &Reader, track: Result<&Track, &String>, gathered: &Gathered) -> Vec<Finding> {
    let finding = |quantity: Quantity| Finding {
        name: quantity.name(),
        unit: quantity.unit(),
        value: match track {
            Err(why) => Err(format!("no reference: {why}")),
            Ok(track) => reader.needs(parts_of(quantity)).map(|()| Value {
                end: gathered.end.0[quantity],
                max: gathered.errors[quantity],
                uncertainty: track.uncertainty[quantity],
            }),
        },
    };
    Quantity::ALL.into_iter().map(finding).collect()
}

fn parts_of(quantity: Quantity) -> &'static [Part] {
    match quantity {
        Quantity::Position => &[Part::Position],
        Quantity::Velocity => &[Part::Velocity],
        Quantity::Orientation => &[Part::Orientation],
        Quantity::AngularVelocity => &[Part::Spin],
        Quantity::AngularMomentum => &[Part::Orientation, Part::Spin],
        Quantity::BodyPoint => &[Part::Position, Part::Orientation],
    }
}

fn drifts(reader: &Reader, gathered: &Gathered) -> Vec<Finding> {
    let system = reader.system;
    let first = reader.first.map_or(0.0, |first| rotation::length(&first.momentum));
    let turning = |scale: f64| {
        if !system.torque_free() {
            return Err("a torque acts: L is not conserved".to_owned());
        }
        reader.needs(&[Part::Orientation, Part::Spin])?;
        if scale == 0.0 { Err("L is zero in the first row".to_owned()) } else { Ok(scale) }
    };
    let energy = if system.forces.conservative() {
        let translation: &[Part] = if system.body.pivoted { &[] } else { &[Part::Velocity] };
        let forces: &[Part] = if system.forces.laws().is_empty() { &[] } else { &[Part::Position] };
        let needed = [translation, forces, &[Part::Orientation, Part::Spin]].concat();
        let moves =
            if gathered.kinetic > 0.0 { Ok(gathered.kinetic) } else { Err("nothing moves".to_owned()) };
        reader.needs(&needed).and(moves)
    } else {
        Err("a law does not conserve the energy".to_owned())
    };
    let scales = [energy, turning(first), turning(first).map(|_| 1.0)];
    let rounding = f64::EPSILON;
    DRIFTS
        .iter()
        .zip(scales)
        .enumerate()
        .map(|(index, ((name, unit), scale))| Finding {
            name,
            unit,
            value: scale.map(|scale| Value {
                end: gathered.end.1[index] / scale,
                max: gathered.drifts[index] / scale,
                uncertainty: rounding,
            }),
        })
        .collect()
}

impl Reader<'_> {
    fn needs(&self, parts: &[Part]) -> Result<(), String> {
        let missing = |part: &&Part| !self.log.has(**part);
        let columns = |part: &Part| super::file::COLUMNS[part.columns()].join(", ");
        match parts.iter().find(missing) {
            Some(part) => Err(format!("it needs {}", columns(part))),
            None => Ok(()),
        }
    }

    fn gather(&self, rows: &[Row], from: usize) -> Gathered {
        let mut gathered = Gathered::default();
        for (index, row) in rows.iter().enumerate() {
            let truth = self.track.map(|track| track.at(from + index, row.time()));
            let state = self.snapshot(row, truth.as_ref());
            let mut errors = PerQuantity::all(0.0);
            if let Some(truth) = &truth {
                errors = difference(&self.system.body, &state, truth);
                gathered.hold(self, row, &state, truth);
            }
            let drifts = self.first.map_or([0.0; 3], |first| gathered.drift(&first, &self.conserved(&state)));
            gathered.hold_largest(errors, drifts);
            gathered.end = (errors, drifts);
        }
        gathered
    }

    /// A row as a state in world axes; what it does not have is the reference's.
    fn snapshot(&self, row: &Row, truth: Option<&Snapshot>) -> Snapshot {
        let zero = Vector3::zeros();
        let vector = |part, other: fn(&Snapshot) -> Vector3<f64>| {
            if self.log.has(part) { Vector3::from(row.numbers(part)) } else { truth.map_or(zero, other) }
        };
        let orientation = if self.log.has(Part::Orientation) {
            self.declared.orientation(row)
        } else {
            truth.map_or(Rotation::identity(), |truth| truth.orientation)
        };
        let written = vector(Part::Spin, |truth| truth.angular_velocity);
        let in_body_axes = self.declared.spin_in_body_axes && self.log.has(Part::Spin);
        let spin = if in_body_axes { orientation * written } else { written };
        let inertia = self.system.body.inertia;
        Snapshot {
            time: row.time(),
            position: vector(Part::Position, |truth| truth.position),
            velocity: vector(Part::Velocity, |truth| truth.velocity),
            orientation,
            angular_velocity: spin,
            angular_momentum: orientation * (inertia * orientation.inverse_transform_vector(&spin)),
            stretch: 0.0,
        }
    }

    fn conserved(&self, state: &Snapshot) -> Conserved {
        let conservative = !self.system.forces.laws().is_empty() && self.system.forces.conservative();
        let potential = if conservative { self.system.potential_energy(state) } else { None };
        Conserved {
            kinetic: self.system.kinetic_energy(state),
            potential: potential.unwrap_or(0.0),
            momentum: state.angular_momentum,
        }
    }
}

impl Gathered {
    fn drift(&mut self, first: &Conserved, now: &Conserved) -> [f64; 3] {
        self.kinetic = self.kinetic.max(now.kinetic);
        [
            (now.kinetic + now.potential - first.kinetic - first.potential).abs(),
            (rotation::length(&now.momentum) - rotation::length(&first.momentum)).abs(),
            rotation::angle_between_directions(&now.momentum, &first.momentum),
        ]
    }

    fn hold_largest(&mut self, errors: PerQuantity<f64>, drifts: [f64; 3]) {
        self.errors = self.errors.zip(errors).map(|(largest, error)| larger(largest, error));
        self.drifts = std::array::from_fn(|index| larger(self.drifts[index], drifts[index]));
    }

    /// Takes a row for the hints.
    fn hold(&mut self, reader: &Reader, row: &Row, state: &Snapshot, truth: &Snapshot) {
        self.sums[0].push(&state.position, &truth.position);
        self.sums[1].push(&state.velocity, &truth.velocity);
        self.sums[2].push(&state.angular_velocity, &truth.angular_velocity);
        if !reader.log.has(Part::Orientation) {
            return;
        }
        let [w, x, y, z] = row.numbers(Part::Orientation);
        let length = Quaternion::new(w, x, y, z).norm();
        self.unit = self.unit.max((length - 1.0).abs());
        let last = Rotation::new_normalize(Quaternion::new(z, w, x, y));
        let last = if reader.declared.world_to_body { last.inverse() } else { last };
        let squared = |q: &Rotation| rotation::angle_between(q, &truth.orientation).powi(2);
        self.orientations.add(&Orientations {
            written: squared(&state.orientation),
            scalar_last: squared(&last),
            inverted: squared(&state.orientation.inverse()),
            rows: 1.0,
        });
    }

    fn joined(mut self, other: &Gathered) -> Gathered {
        self.hold_largest(other.errors, other.drifts);
        self.kinetic = self.kinetic.max(other.kinetic);
        self.sums.iter_mut().zip(&other.sums).for_each(|(a, b)| a.add(b));
        self.orientations.add(&other.orientations);
        self.unit = self.unit.max(other.unit);
        self.end = other.end;
        self
    }
}

/// The larger one; NaN where the second is.
fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::NAN } else { a.max(b) }
}
