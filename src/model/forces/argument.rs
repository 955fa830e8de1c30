//! Arguments: the values of a law's parameters, whatever their shapes.

use std::fmt;

use nalgebra::{Matrix3, Vector3};

use super::{Attachment, PerPoint, TorqueAxes};
use crate::arithmetic::Real;

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument<T: Real = f64> {
    /// A number.
    Number(T),
    /// Three numbers.
    Vector(Vector3<T>),
    /// A matrix, in body axes.
    Matrix(Matrix3<T>),
    /// One number for all mass points, or one each.
    PerPoint(PerPoint<T>),
    /// A mass point, or a place on the body.
    Attachment(Attachment<T>),
    /// World or body axes.
    Axes(TorqueAxes),
}

/// What an argument consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// Three numbers.
    Vector,
    /// Three numbers on the diagonal, or three rows of three.
    Matrix,
    /// One number for all mass points, or a list of one each.
    PerPoint,
    /// The index of a mass point under one key, or a place on the body under another.
    Attachment,
    /// A word for world axes or for body axes.
    Axes,
}

impl<T: Real> Argument<T> {
    /// The same argument with every number and every vector in it changed; of a matrix, every entry.
    pub(crate) fn map<U: Real>(
        self,
        number: impl Fn(T) -> U,
        vector: impl Fn(Vector3<T>) -> Vector3<U>,
    ) -> Argument<U> {
        match self {
            Argument::Number(value) => Argument::Number(number(value)),
            Argument::Vector(value) => Argument::Vector(vector(value)),
            Argument::Matrix(value) => Argument::Matrix(value.map(number)),
            Argument::PerPoint(PerPoint::Same(value)) => Argument::PerPoint(PerPoint::Same(number(value))),
            Argument::PerPoint(PerPoint::Each(values)) => {
                Argument::PerPoint(PerPoint::Each(values.into_iter().map(number).collect()))
            }
            Argument::Attachment(Attachment::Point(index)) => Argument::Attachment(Attachment::Point(index)),
            Argument::Attachment(Attachment::At(place)) => {
                Argument::Attachment(Attachment::At(vector(place)))
            }
            Argument::Axes(axes) => Argument::Axes(axes),
        }
    }
}

/// The argument as TOML writes it.
impl fmt::Display for Argument {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Argument::Number(value) | Argument::PerPoint(PerPoint::Same(value)) => write!(f, "{value:?}"),
            Argument::PerPoint(PerPoint::Each(values)) => write!(f, "{values:?}"),
            Argument::Vector(v) | Argument::Attachment(Attachment::At(v)) => {
                write!(f, "[{:?}, {:?}, {:?}]", v.x, v.y, v.z)
            }
            Argument::Matrix(m) => {
                let rows = [0, 1, 2].map(|i| format!("[{:?}, {:?}, {:?}]", m[(i, 0)], m[(i, 1)], m[(i, 2)]));
                write!(f, "[{}]", rows.join(", "))
            }
            Argument::Attachment(Attachment::Point(index)) => write!(f, "{index}"),
            Argument::Axes(axes) => write!(f, "\"{}\"", axes.word()),
        }
    }
}

/// A type that a parameter of a law may have.
pub(super) trait Field<T: Real>: Sized {
    /// The kind of its arguments.
    const KIND: Kind;

    /// As an argument.
    fn to_argument(&self) -> Argument<T>;

    /// From an argument.
    ///
    /// # Panics
    /// The argument has another kind: the tables of the laws rule that out.
    fn from_argument(argument: Argument<T>) -> Self;
}

macro_rules! fields {
    ($($type:ty: $kind:ident,)*) => {$(
        impl<T: Real> Field<T> for $type {
            const KIND: Kind = Kind::$kind;

            fn to_argument(&self) -> Argument<T> {
                Argument::$kind(self.clone())
            }

            fn from_argument(argument: Argument<T>) -> Self {
                match argument {
                    Argument::$kind(value) => value,
                    other => panic!("{other:?} where {:?} is expected", Kind::$kind),
                }
            }
        }
    )*};
}

fields! {
    T: Number,
    Vector3<T>: Vector,
    Matrix3<T>: Matrix,
    PerPoint<T>: PerPoint,
    Attachment<T>: Attachment,
    TorqueAxes: Axes,
}
