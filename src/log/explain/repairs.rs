//! Changes without a parameter: units, signs, conventions, permuted axes, a shift by a row.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Vector3};

use super::{Case, Change, Part, Parts, Tried, VECTORS, column, vector, with_vector};
use crate::log::Convention;
use crate::log::Sequence;
use crate::model::Snapshot;
use crate::rotation::{self, Rotation};

const LENGTHS: [(f64, &str); 5] = [
    (0.01, "centimetres"),
    (0.001, "millimetres"),
    (0.3048, "feet"),
    (0.0254, "inches"),
    (1000.0, "kilometres"),
];
const SPEEDS: [(f64, &str); 6] = [
    (0.01, "centimetres a second"),
    (0.001, "millimetres a second"),
    (0.3048, "feet a second"),
    (0.0254, "inches a second"),
    (1000.0, "kilometres a second"),
    (1.0 / 3.6, "kilometres an hour"),
];
const SPINS: [(f64, &str); 3] =
    [(PI / 180.0, "degrees per second"), (PI / 30.0, "turns per minute"), (2.0 * PI, "turns per second")];
const TIMES: [(f64, &str); 4] = [
    (1e-3, "milliseconds: --time-unit ms"),
    (1e-6, "microseconds: --time-unit us"),
    (1e-9, "nanoseconds: --time-unit ns"),
    (60.0, "minutes: --time-unit min"),
];

pub(super) fn tried(case: &Case) -> Vec<Tried> {
    let mut tried = Vec::new();
    units(case, &mut tried);
    signs(case, &mut tried);
    if case.parts().has(Part::Orientation) {
        orientations(case, &mut tried);
    }
    permuted(case, &mut tried);
    rows(case, &mut tried);
    tried
}

fn units(case: &Case, tried: &mut Vec<Tried>) {
    let named = [
        (Part::Position, &LENGTHS[..], "positions are in"),
        (Part::Velocity, &SPEEDS, "velocities are in"),
        (Part::Spin, &SPINS, "angular velocities are in"),
    ];
    for (part, names, what) in named {
        for (unit, name) in names.iter().filter(|_| case.parts().has(part)) {
            let left = case.after(|state| with_vector(part, state, vector(part, state) * *unit));
            tried.push(Tried { change: Change::Unit, words: format!("{what} {name}"), left });
        }
    }
    if case.parts().covers(Parts::of(&[Part::Position, Part::Velocity])) {
        for (unit, name) in LENGTHS {
            let left = case.after(|state| Snapshot {
                position: state.position * unit,
                velocity: state.velocity * unit,
                ..*state
            });
            let words = format!("positions are in {name}, velocities in {name} a second");
            tried.push(Tried { change: Change::Unit, words, left });
        }
    }
    for (unit, name) in TIMES {
        let left = case.at_times(Parts::of(&Part::ALL), |place| Some(case.row(place).time() * unit));
        tried.push(Tried { change: Change::Unit, words: format!("times are in {name}"), left });
    }
}

fn signs(case: &Case, tried: &mut Vec<Tried>) {
    for part in VECTORS.into_iter().filter(|part| case.parts().has(*part)) {
        let left = case.after(|state| with_vector(part, state, -vector(part, state)));
        let word = if part == Part::Spin { "w" } else { part.word() };
        tried.push(Tried { change: Change::Sign, words: format!("the sign of {word} is turned"), left });
        for k in 0..3 {
            let left = case.after(|state| {
                let mut value = vector(part, state);
                value[k] = -value[k];
                with_vector(part, state, value)
            });
            let words = format!("the sign of {} is turned", column(part, k));
            tried.push(Tried { change: Change::Sign, words, left });
        }
    }
}

fn orientations(case: &Case, tried: &mut Vec<Tried>) {
    let declared = case.reader.declared;
    for convention in Convention::ALL {
        let left = case.read_anew(convention, true);
        let also =
            if convention == declared { String::new() } else { format!(", with {}", convention.words()) };
        let words = format!("quaternions are x, y, z, w: write the scalar into qw{also}");
        tried.push(Tried { change: Change::ScalarLast, words, left });
        if convention != declared {
            let words = format!("the log is written as {}", convention.words());
            tried.push(Tried { change: Change::Convention, words, left: case.read_anew(convention, false) });
        }
    }
    for k in 0..3 {
        let left = case.after(|state| {
            let mut q = state.orientation.into_inner();
            q.coords[k] = -q.coords[k];
            case.with_orientation(state, Rotation::new_normalize(q))
        });
        let words = format!("the sign of {} is turned", ["qx", "qy", "qz"][k]);
        tried.push(Tried { change: Change::Sign, words, left });
    }
    if case.parts().has(Part::Velocity) {
        let left = case.after(|state| Snapshot { velocity: state.orientation * state.velocity, ..*state });
        tried.push(Tried {
            change: Change::BodyVelocity,
            words: "velocities are in body axes".to_owned(),
            left,
        });
    }
    if let Some(read) = case.log().reading.sequence {
        angles(case, read, tried);
    }
}

/// Euler angles of another sequence, of another unit, or one with the other sign.
fn angles(case: &Case, read: Sequence, tried: &mut Vec<Tried>) {
    let after = |change: &dyn Fn([f64; 3]) -> Rotation| {
        case.after(|state| case.with_orientation(state, change(read.angles(&state.orientation))))
    };
    for sequence in Sequence::all().flat_map(|sequence| [sequence, sequence.other_way()]) {
        let by_axis = read.of_three_axes() && sequence.of_three_axes() && case.log().reading.has(17);
        let left = after(&|angles| {
            let angle = |place: usize| {
                if by_axis { angles[read.place_of(sequence.axis(place))] } else { angles[place] }
            };
            sequence.rotation([0, 1, 2].map(angle))
        });
        let words = format!("Euler angles have the sequence {sequence}: --euler {sequence}");
        tried.push(Tried { change: Change::Sequence, words, left });
    }
    let left = after(&|angles| read.rotation(angles.map(f64::to_degrees)));
    let words = "Euler angles are in radians, and were read in degrees".to_owned();
    tried.push(Tried { change: Change::Unit, words, left });
    for place in 0..3 {
        let left = after(&|mut angles| {
            angles[place] = -angles[place];
            read.rotation(angles)
        });
        let axis = ["x", "y", "z"][read.axis(place)];
        let words = format!("the sign of the Euler angle about {axis} is turned");
        tried.push(Tried { change: Change::Sign, words, left });
    }
}

/// The 48 permutations of axes with signs.
fn permutations() -> impl Iterator<Item = Matrix3<f64>> {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    (0..48).map(|n| {
        let (order, signs) = (ORDERS[n / 8], n % 8);
        let sign = |row: usize| if signs >> row & 1 == 0 { 1.0 } else { -1.0 };
        Matrix3::from_fn(|row, column| if order[row] == column { sign(row) } else { 0.0 })
    })
}

fn permuted(case: &Case, tried: &mut Vec<Tried>) {
    for to in permutations().filter(|to| *to != Matrix3::identity()) {
        let (sign, back) = (to.determinant(), to.transpose());
        let written = written(&to);
        let moved = |state: &Snapshot, orientation: Rotation| Snapshot {
            position: back * state.position,
            velocity: back * state.velocity,
            angular_velocity: back * state.angular_velocity * sign,
            orientation,
            ..*state
        };
        let kind = if sign < 0.0 { "mirrored" } else { "permuted" };
        let left = case.after(|state| {
            let axes = rotation::axes(&state.orientation);
            moved(state, rotation::from_matrix(&(back * axes * to)))
        });
        let words = format!("axes of world and body are {kind}: x, y, z of the log are {written}");
        let change =
            if case.parts().has(Part::Orientation) { Change::PermutedBoth } else { Change::PermutedWorld };
        tried.push(Tried { change, words, left });
        let left = case.after(|state| Snapshot {
            orientation: state.orientation,
            angular_velocity: state.angular_velocity,
            ..moved(state, state.orientation)
        });
        let words = format!("axes of positions and velocities are {kind}: x, y, z of the log are {written}");
        tried.push(Tried { change: Change::PermutedWorld, words, left });
        if sign > 0.0 && case.parts().has(Part::Orientation) {
            let turn = rotation::from_matrix(&back);
            let left = case.after(|state| moved(state, turn * state.orientation));
            let words = format!("world axes are permuted: x, y, z of the log are {written}");
            tried.push(Tried { change: Change::PermutedWorld, words, left });
            let left = case.after(|state| Snapshot { orientation: state.orientation * turn, ..*state });
            let words = format!(
                "body axes are permuted: the body of the scene is turned by {}",
                turned(&turn.inverse())
            );
            tried.push(Tried { change: Change::BodyAxes, words, left });
        }
    }
}

/// The axes of the scene that are x, y, z of the log.
fn written(to: &Matrix3<f64>) -> String {
    let axis = |row: usize| {
        let column = to.row(row).iamax_full().1;
        format!("{}{}", if to[(row, column)] < 0.0 { "-" } else { "" }, ["x", "y", "z"][column])
    };
    [0, 1, 2].map(axis).join(", ")
}

/// A turn as an angle about an axis.
pub(super) fn turned(turn: &Rotation) -> String {
    let vector: Vector3<f64> = rotation::vector_of(turn);
    let angle = rotation::length(&vector);
    let axis = if angle > 0.0 { vector / angle } else { vector };
    format!("{angle:.6} rad about ({:.4}, {:.4}, {:.4})", axis.x, axis.y, axis.z)
}

/// All quantities, or one of several, are those of the row before or after.
fn rows(case: &Case, tried: &mut Vec<Tried>) {
    let log = case.log();
    let all = Parts::of(&Part::ALL);
    let several = case.parts().each().count() > 1;
    for (by, word) in [(-1isize, "before"), (1, "after")] {
        let time = |place: usize| {
            let own = case.rows[place];
            let other = own.checked_add_signed(by)?;
            let neighbours = own / log.block == other / log.block;
            log.rows.get(other).filter(|_| neighbours).map(|row| row.time())
        };
        let words = format!("every row holds the state of the row {word}");
        tried.push(Tried { change: Change::Row, words, left: case.at_times(all, time) });
        for part in case.parts().each().filter(|_| several) {
            let words = format!("the {} of every row is that of the row {word}", part.word());
            tried.push(Tried { change: Change::Row, words, left: case.at_times(Parts::of(&[part]), time) });
        }
    }
}
