//! Mass, centre of mass and inertia of a body, in double-double arithmetic and units of the scene.

use nalgebra::Vector3;

use super::double_double::DoubleDouble;
use super::scale::Scale;
use crate::model::body::{Body, inertia_of};

/// Three rows of three.
pub(super) type Rows = [[DoubleDouble; 3]; 3];

/// What of a body its motion depends on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Matter {
    pub mass: DoubleDouble,
    /// Centre of mass from the origin, body axes.
    pub center: [DoubleDouble; 3],
    /// About the origin, body axes.
    pub inertia: Rows,
}

/// x (1 + part).
pub(super) fn nudged(x: DoubleDouble, part: f64) -> DoubleDouble {
    x + x.scaled(part)
}

impl Matter {
    pub(super) fn of(body: &Body, scale: &Scale) -> Matter {
        // A body given by its inertia has mass points made for it, which have that inertia to rounding only.
        let given_by_points = !body.points.is_empty() && inertia_of(&body.points) == body.inertia;
        if given_by_points {
            return Matter::of_points(body, scale);
        }
        let inertia = scale.inertia(&body.inertia);
        let row = |i| std::array::from_fn(|j| DoubleDouble::from(inertia[(i, j)]));
        Matter {
            mass: scale.plain(body.mass, [1, 0, 0]).into(),
            center: [0, 1, 2].map(|i| scale.plain(body.center[i], [0, 1, 0]).into()),
            inertia: std::array::from_fn(row),
        }
    }

    fn of_points(body: &Body, scale: &Scale) -> Matter {
        let zero = DoubleDouble::ZERO;
        let (mut mass, mut first, mut inertia) = (zero, [zero; 3], [[zero; 3]; 3]);
        for point in &body.points {
            let m = DoubleDouble::from(scale.plain(point.mass, [1, 0, 0]));
            let x = [0, 1, 2].map(|i| DoubleDouble::from(scale.plain(point.position[i], [0, 1, 0])));
            mass += m;
            for i in 0..3 {
                first[i] += m * x[i];
                for j in 0..3 {
                    inertia[i][j] += -(m * x[i] * x[j]);
                    inertia[i][i] += m * x[j] * x[j];
                }
            }
        }
        // Without a pivot the origin is the centre of mass, to rounding of the places: it is taken at its word.
        let center = if body.pivoted { first.map(|x| x / mass) } else { [zero; 3] };
        Matter { mass, center, inertia }
    }

    /// The inertia off by `part` of itself, up and down in turn; it stays symmetric.
    pub(super) fn nudged(mut self, part: f64) -> Matter {
        for (i, row) in self.inertia.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = nudged(*entry, if (i + j) % 3 == 0 { part } else { -part });
            }
        }
        self
    }

    pub(super) fn inverse(&self) -> Rows {
        let entry = |i: usize, j: usize| self.inertia[i % 3][j % 3];
        let cofactor = |i: usize, j: usize| {
            entry(i + 1, j + 1) * entry(i + 2, j + 2) - entry(i + 1, j + 2) * entry(i + 2, j + 1)
        };
        let determinant = (0..3).fold(DoubleDouble::ZERO, |sum, j| sum + entry(0, j) * cofactor(0, j));
        std::array::from_fn(|i| std::array::from_fn(|j| cofactor(j, i) / determinant))
    }

    /// (E − d dᵀ)/s; d from the farthest mass point, which is known better than its direction.
    pub(super) fn inverse_of_rod(&self, body: &Body, direction: Vector3<f64>) -> Rows {
        let places = body.points.iter().map(|point| point.position);
        let farther = |a: Vector3<f64>, b: Vector3<f64>| if b.amax() > a.amax() { b } else { a };
        let far = places.fold(Vector3::zeros(), farther);
        let d: [f64; 3] = if far.amax() > 0.0 { far } else { direction }.into();
        let d = d.map(DoubleDouble::from);
        let square = d.iter().fold(DoubleDouble::ZERO, |sum, x| sum + *x * *x);
        let half = (self.inertia[0][0] + self.inertia[1][1] + self.inertia[2][2]).scaled(0.5);
        let one = |i, j| if i == j { DoubleDouble::ONE } else { DoubleDouble::ZERO };
        let entry = |i: usize, j: usize| (one(i, j) - d[i] * d[j] / square) / half;
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    }
}
