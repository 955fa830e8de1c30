//! A link as a file describes it, before anything is judged.

use nalgebra::{Matrix3, Vector3};

use super::Stepping;
use super::pose::Pose;
use super::printed::Printed;
use super::solid::Solid;

/// Names of the six numbers, in the order in which [`Inertial`] keeps them.
pub(super) const SIX: [&str; 6] = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
/// Places of the moments and of the products among the six.
pub(super) const MOMENTS: [usize; 3] = [0, 3, 5];
pub(super) const PRODUCTS: [usize; 3] = [1, 2, 4];

/// Where the mass of a link comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Source {
    /// There is none.
    #[default]
    None,
    /// Numbers of the file.
    Explicit,
    /// Geoms of MJCF, by mass or density.
    Geoms,
    /// Collision shapes of SDF, by density.
    Auto,
}

impl Source {
    pub fn word(self) -> &'static str {
        match self {
            Source::None => "none",
            Source::Explicit => "explicit",
            Source::Geoms => "geoms",
            Source::Auto => "auto",
        }
    }
}

/// Mass and inertia as printed.
#[derive(Clone, Debug)]
pub(super) struct Inertial {
    /// [kg].
    pub mass: Printed,
    /// Tensor about the centre of mass, in the order of [`SIX`], axes of `pose` [kg m²].
    pub six: [Printed; 6],
    /// Centre of mass and axes.
    pub pose: Pose,
}

impl Inertial {
    /// Of computed numbers, in the axes of the link.
    pub fn computed(mass: f64, center: Vector3<f64>, tensor: &Matrix3<f64>) -> Inertial {
        Inertial {
            mass: Printed::computed(mass),
            six: six_of(tensor).map(Printed::computed),
            pose: Pose { position: center, ..Pose::default() },
        }
    }

    /// The six values.
    pub fn values(&self) -> [f64; 6] {
        std::array::from_fn(|i| self.six[i].value)
    }

    /// The tensor in the axes of the link.
    pub fn tensor(&self) -> Matrix3<f64> {
        self.pose.turned(&tensor_of(&self.values()))
    }
}

/// A tensor of the six.
pub(super) fn tensor_of(six: &[f64; 6]) -> Matrix3<f64> {
    let [xx, xy, xz, yy, yz, zz] = *six;
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

/// The six of a tensor.
pub(super) fn six_of(tensor: &Matrix3<f64>) -> [f64; 6] {
    [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|place| tensor[place])
}

/// A rigid link.
#[derive(Clone, Debug, Default)]
pub(super) struct Link {
    pub name: String,
    /// Line of the file, from 1.
    pub line: usize,
    pub source: Source,
    pub inertial: Option<Inertial>,
    /// `<inertial>` elements; the first counts.
    pub inertials: usize,
    /// Shapes that mass may fill: collision shapes, or all where the format makes no difference.
    pub solids: Vec<Solid>,
    /// Shapes that are drawn only.
    pub drawn: Vec<Solid>,
    /// Shapes whose size is not in the file: meshes, height maps.
    pub meshes: usize,
    /// What the compiler of the format makes of mass [kg] and principal moments [kg m²], where it changes them.
    pub compiled: Option<(f64, [f64; 3])>,
    /// Remarks.
    pub notes: Vec<String>,
}

/// All links of a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Robot {
    pub format: &'static str,
    pub links: Vec<Link>,
    pub stepping: Option<Stepping>,
    /// Remarks about the file.
    pub notes: Vec<String>,
}
