//! The table of a law's parameters: names, units, defaults and examples, and how each looks in another world.

use super::argument::{Argument, Kind};

/// A parameter of a law.
#[derive(Debug)]
pub struct Parameter {
    /// Its name, as in a scene file.
    pub key: &'static str,
    /// What it is, in words.
    pub what: &'static str,
    /// Its unit; for a word, the words that it may be.
    pub unit: &'static str,
    /// What it consists of.
    pub kind: Kind,
    /// How it looks in another world.
    pub nature: Nature,
    /// The value where a scene gives none; none where a scene has to give one.
    pub default: Option<Argument>,
    /// A value that does something.
    pub example: Argument,
}

impl Parameter {
    /// The keys of a mass point and of a place on the body, either of which says where a law holds.
    pub const PLACES: [&'static str; 2] = ["point", "at"];

    /// The keys of a scene file that may give it: one, or one of [`PLACES`](Parameter::PLACES).
    pub fn keys(&self) -> &[&'static str] {
        match self.kind {
            Kind::Attachment => &Parameter::PLACES,
            _ => std::slice::from_ref(&self.key),
        }
    }

    /// The key of this argument.
    pub(crate) fn key_of(&self, argument: &Argument) -> &'static str {
        match argument {
            Argument::Attachment(super::Attachment::Point(_)) => Parameter::PLACES[0],
            Argument::Attachment(super::Attachment::At(_)) => Parameter::PLACES[1],
            _ => self.key,
        }
    }

    /// Whether a scene gives a direction of any length, and the law takes a unit vector.
    pub fn is_direction(&self) -> bool {
        matches!(self.nature, Nature::Direction | Nature::Axis)
    }
}

/// What a parameter is: how it looks in a world that is turned, mirrored, shifted or has other units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nature {
    /// A number, or one of each point.
    Number(Dimension),
    /// A vector in world axes. A mirror changes its sign where its power of length is odd.
    World(Dimension),
    /// A vector in body axes, or a place on the body.
    Body(Dimension),
    /// A vector in the axes that the law names.
    Stated(Dimension),
    /// A place in the world.
    Place,
    /// A unit vector in world axes; a mirror changes its sign.
    Direction,
    /// A unit vector in world axes that something turns about; a mirror does not change its sign.
    Axis,
    /// The distance of a plane from the origin of the world, along the direction that is the law's parameter before it.
    Height,
    /// A time at which the law sets in or ends.
    Jump,
    /// A word, the same in every world.
    Word,
}

/// Powers of mass, length and time. A charge has none, and its fields those of the force on a unit charge; a magnetic moment has
/// those of a torque, and its field none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// None.
    Pure,
    /// m.
    Length,
    /// s.
    Time,
    /// 1/s.
    Frequency,
    /// m/s.
    Velocity,
    /// m/s².
    Acceleration,
    /// kg m/s².
    Force,
    /// kg m²/s².
    Torque,
    /// kg m²/s, of rotational damping too.
    AngularMomentum,
    /// kg/s² of a spring.
    Stiffness,
    /// kg/s of a damper and of a magnetic force.
    Damping,
    /// m³/s² of central gravity.
    Central,
    /// 1/s² of a gradient of gravity.
    Gradient,
}

impl Dimension {
    /// Powers of mass, of length and of 1/time.
    pub const fn powers(self) -> [i32; 3] {
        match self {
            Dimension::Pure => [0, 0, 0],
            Dimension::Length => [0, 1, 0],
            Dimension::Time => [0, 0, -1],
            Dimension::Frequency => [0, 0, 1],
            Dimension::Velocity => [0, 1, 1],
            Dimension::Acceleration => [0, 1, 2],
            Dimension::Force => [1, 1, 2],
            Dimension::Torque => [1, 2, 2],
            Dimension::AngularMomentum => [1, 2, 1],
            Dimension::Stiffness => [1, 0, 2],
            Dimension::Damping => [1, 0, 1],
            Dimension::Central => [0, 3, 2],
            Dimension::Gradient => [0, 0, 2],
        }
    }
}

impl Nature {
    /// Powers of mass, length and time.
    pub const fn dimension(self) -> Dimension {
        match self {
            Nature::Number(dimension)
            | Nature::World(dimension)
            | Nature::Body(dimension)
            | Nature::Stated(dimension) => dimension,
            Nature::Place | Nature::Height => Dimension::Length,
            Nature::Jump => Dimension::Time,
            Nature::Direction | Nature::Axis | Nature::Word => Dimension::Pure,
        }
    }
}

/// The words that the tables are written in.
pub(super) mod row {
    use nalgebra::{Matrix3, Vector3};

    pub use super::Dimension::*;
    pub use super::Nature::*;
    use crate::model::forces::{Argument, Attachment, PerPoint, TorqueAxes};

    /// No default: a scene has to give the parameter.
    pub const REQUIRED: Option<Argument> = None;

    /// Zero where a scene gives nothing.
    pub const ZERO: Option<Argument> = Some(number(0.0));
    /// A zero vector where a scene gives nothing.
    pub const ZEROS: Option<Argument> = Some(vector(0.0, 0.0, 0.0));

    pub const fn number(value: f64) -> Argument {
        Argument::Number(value)
    }

    pub const fn vector(x: f64, y: f64, z: f64) -> Argument {
        Argument::Vector(Vector3::new(x, y, z))
    }

    pub const fn diagonal(x: f64, y: f64, z: f64) -> Argument {
        Argument::Matrix(Matrix3::new(x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z))
    }

    pub const fn each(value: f64) -> Argument {
        Argument::PerPoint(PerPoint::Same(value))
    }

    pub const fn point(index: usize) -> Argument {
        Argument::Attachment(Attachment::Point(index))
    }

    pub const fn axes(axes: TorqueAxes) -> Argument {
        Argument::Axes(axes)
    }
}

/// Declares the structure of a law by its table of parameters. A row is
///
/// ```text
/// /// What it is.
/// key: type ["unit"] = nature, default, example;
/// ```
///
/// and a field without a row cannot be written.
macro_rules! parameters {
    (
        $(#[$doc:meta])*
        pub struct $law:ident {$(
            #[doc = $what:literal]
            $key:ident: $type:ty [$unit:literal] = $nature:expr, $default:expr, $example:expr;
        )*}
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $law<T: Real = f64> {$(
            #[doc = concat!($what, " [", $unit, "].")]
            pub $key: $type,
        )*}

        impl<T: Real> $law<T> {
            pub(super) const PARAMETERS: &'static [Parameter; [$(stringify!($key)),*].len()] = {
                #[allow(clippy::wildcard_imports, reason = "the words that tables are written in")]
                use crate::model::forces::parameter::row::*;
                &[$(Parameter {
                    key: stringify!($key),
                    what: $what.trim_ascii(),
                    unit: $unit,
                    kind: <$type as Field<T>>::KIND,
                    nature: $nature,
                    default: $default,
                    example: $example,
                }),*]
            };

            /// The law with these arguments.
            pub(super) fn build<E>(
                mut argument: impl FnMut(&'static Parameter) -> Result<Argument<T>, E>,
            ) -> Result<$law<T>, E> {
                let [$($key),*] = Self::PARAMETERS;
                Ok($law { $($key: Field::<T>::from_argument(argument($key)?)),* })
            }

            /// The arguments, in the order of the table.
            pub(super) fn arguments(&self) -> Vec<(&'static Parameter, Argument<T>)> {
                let [$($key),*] = Self::PARAMETERS;
                vec![$(($key, Field::<T>::to_argument(&self.$key))),*]
            }

            /// The same law with its arguments changed.
            pub(super) fn map<U: Real>(
                &self,
                mut change: impl FnMut(&'static Parameter, Argument<T>) -> Argument<U>,
            ) -> $law<U> {
                let [$($key),*] = Self::PARAMETERS;
                $law {$(
                    $key: Field::<U>::from_argument(change($key, Field::<T>::to_argument(&self.$key))),
                )*}
            }
        }
    };
}

pub(super) use parameters;
