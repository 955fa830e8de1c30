//! Vectors and rotation matrices of values on a tape.

use std::ops::{Add, Sub};

use nalgebra::Vector3;

use super::double_double::DoubleDouble;
use super::sheet::{Node, Sheet};

/// Three values: a vector.
#[derive(Clone, Copy)]
pub(super) struct Triple<'a>(pub [Node<'a>; 3]);

impl<'a> Triple<'a> {
    pub(super) fn constant(sheet: &'a Sheet, v: &Vector3<f64>) -> Triple<'a> {
        Triple([v.x, v.y, v.z].map(|x| sheet.constant(x)))
    }

    pub(super) fn zero(sheet: &'a Sheet) -> Triple<'a> {
        Triple::constant(sheet, &Vector3::zeros())
    }

    pub(super) fn variable(sheet: &'a Sheet) -> Triple<'a> {
        Triple(std::array::from_fn(|_| sheet.variable()))
    }

    pub(super) fn scaled(self, factor: impl Into<DoubleDouble>) -> Triple<'a> {
        let factor = factor.into();
        Triple(self.0.map(|x| x.times(factor)))
    }

    pub(super) fn times(self, factor: Node<'a>) -> Triple<'a> {
        Triple(self.0.map(|x| x * factor))
    }

    pub(super) fn dot(self, other: Triple<'a>) -> Node<'a> {
        let [a, b] = [self.0, other.0];
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    pub(super) fn cross(self, other: Triple<'a>) -> Triple<'a> {
        let [a, b] = [self.0, other.0];
        Triple([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])
    }
}

impl<'a> Add for Triple<'a> {
    type Output = Triple<'a>;

    fn add(self, other: Triple<'a>) -> Triple<'a> {
        Triple(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl<'a> Sub for Triple<'a> {
    type Output = Triple<'a>;

    fn sub(self, other: Triple<'a>) -> Triple<'a> {
        Triple(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }
}

/// Three columns: a matrix from body axes to world axes.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a>(pub [Triple<'a>; 3]);

impl<'a> Columns<'a> {
    /// R of a unit quaternion (w, x, y, z).
    pub(super) fn of_quaternion(q: [Node<'a>; 4]) -> Columns<'a> {
        let [w, x, y, z] = q;
        let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
        let double = |a: Node<'a>| a.times(2.0);
        let (wx, wy, wz) = (double(w * x), double(w * y), double(w * z));
        let (xy, xz, yz) = (double(x * y), double(x * z), double(y * z));
        Columns([
            Triple([ww + xx - yy - zz, xy + wz, xz - wy]),
            Triple([xy - wz, ww - xx + yy - zz, yz + wx]),
            Triple([xz + wy, yz - wx, ww - xx - yy + zz]),
        ])
    }

    /// R v.
    pub(super) fn times(self, v: Triple<'a>) -> Triple<'a> {
        let [a, b, c] = self.0;
        a.times(v.0[0]) + b.times(v.0[1]) + c.times(v.0[2])
    }

    /// Rᵀ v.
    pub(super) fn transposed_times(self, v: Triple<'a>) -> Triple<'a> {
        Triple(self.0.map(|column| column.dot(v)))
    }

    /// R v of a constant.
    pub(super) fn of(self, v: [DoubleDouble; 3]) -> Triple<'a> {
        let [a, b, c] = self.0;
        a.scaled(v[0]) + b.scaled(v[1]) + c.scaled(v[2])
    }

    /// R [ω]×, which takes a place in the body to its velocity: its columns are Ω × those of R.
    pub(super) fn turning(self, spin: Triple<'a>) -> Columns<'a> {
        Columns(self.0.map(|column| spin.cross(column)))
    }
}
