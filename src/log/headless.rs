//! Files without a header: TUM's format, and an option to paste for others.

use nalgebra::Vector3;

use super::layout::{Separator, number};
use super::row::COLUMNS;

/// The columns of TUM's format.
pub(super) const TUM: &str = "t,x,y,z,qx,qy,qz,qw";
/// How far from one the length of four numbers may be that are taken for a quaternion.
const UNIT: f64 = 1e-2;
/// Columns in an option, at most.
const MOST: usize = 40;

/// Eight numbers between blanks, the last four of unit length.
pub(super) fn is_tum(separator: Separator, cells: &[&str]) -> bool {
    separator == Separator::Blanks && cells.len() == 8 && is_unit(&numbers(separator, cells)[4..])
}

/// What is wrong with a first row, and the option that reads it.
pub(super) fn refusal(separator: Separator, cells: &[&str]) -> String {
    let (row, count) = (numbers(separator, cells), cells.len());
    if count == 4 && is_unit(&row) {
        let columns = quaternion(&row).join(",");
        return format!(
            "there is no header, and 4 columns: a quaternion without a time; put the times before it and say --columns t,{columns}"
        );
    }
    if is_pose(&row) {
        return "there is no header, and 12 columns: a rotation matrix and a position without a time, as KITTI writes them; write \
                t,x,y,z,qw,qx,qy,qz"
            .to_owned();
    }
    if count < 4 {
        return format!(
            "there is no header, and {count} columns: a time and a quantity have four or more, as in --columns t,x,y,z"
        );
    }
    let columns = columns(&row).join(",");
    format!("there is no header, and {count} columns; say what they are, as in --columns {columns}")
}

/// The columns of a row by its four neighbours of unit length: a position before them, velocities after them.
fn columns(row: &[f64]) -> Vec<&'static str> {
    let count = row.len();
    let ends = [4, 1].into_iter().chain(2..count);
    let mut found = ends.filter(|at| at + 4 <= count).filter(|at| is_unit(&row[*at..at + 4]));
    let mut columns = vec!["-"; count];
    columns[0] = "t";
    match found.next() {
        Some(at) => {
            columns[at..at + 4].copy_from_slice(&quaternion(&row[at..at + 4]));
            if at >= 4 {
                columns[at - 3..at].copy_from_slice(&COLUMNS[1..4]);
            }
            match count - at - 4 {
                0..3 => {}
                3..6 => columns[at + 4..at + 7].copy_from_slice(&COLUMNS[11..14]),
                _ => columns[at + 4..at + 10].copy_from_slice(&COLUMNS[8..14]),
            }
        }
        None => columns[1..4].copy_from_slice(&COLUMNS[1..4]),
    }
    columns.truncate(MOST);
    columns
}

/// The scalar is the larger of both ends, as it is in a body that has hardly turned.
fn quaternion(q: &[f64]) -> [&'static str; 4] {
    if q[3].abs() > q[0].abs() { ["qx", "qy", "qz", "qw"] } else { ["qw", "qx", "qy", "qz"] }
}

fn numbers(separator: Separator, cells: &[&str]) -> Vec<f64> {
    cells.iter().map(|cell| number(cell, separator).unwrap_or(f64::NAN)).collect()
}

/// Three rows of a matrix whose first three columns are a rotation.
fn is_pose(row: &[f64]) -> bool {
    let axis = |k: usize| Vector3::new(row[4 * k], row[4 * k + 1], row[4 * k + 2]);
    let is_turned = || (axis(0).cross(&axis(1)) - axis(2)).norm() < UNIT;
    row.len() == 12 && (0..3).all(|k| (axis(k).norm() - 1.0).abs() < UNIT) && is_turned()
}

fn is_unit(q: &[f64]) -> bool {
    (q.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0).abs() < UNIT
}
