//! The outline of a link: the box around its shapes, and the uniform solid that fills them.
//!
//! With the box [lo, hi] and the centre of mass c, the variance of mass along an axis is at most (hi − c)(c − lo): Bhatia and Davis 2000.
//! So I_xx ≤ m L_x with L_x = (hi_y − c_y)(c_y − lo_y) + (hi_z − c_z)(c_z − lo_z), a limit for mass inside the outline and no guess.

use nalgebra::{Matrix3, Vector3};

use super::link::Link;
use super::solid::{Part, Solid, compose};

/// The uniform solid of 1 kg.
#[derive(Clone, Debug)]
pub(super) struct Uniform {
    /// Centre of mass [m], axes of the link.
    pub center: Vector3<f64>,
    /// About the centre [m²].
    pub tensor: Matrix3<f64>,
    /// Sum of the tensors of the parts about their own centres [m²].
    pub parts: Matrix3<f64>,
    /// [m³].
    pub volume: f64,
}

/// The outline of a link, axes of the link.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    low: Vector3<f64>,
    high: Vector3<f64>,
    /// Whether it is made of primitives only.
    pub exact: bool,
    /// `None` where the shapes have no volume.
    pub uniform: Option<Uniform>,
}

impl Outline {
    /// `None` for a link without primitive shapes.
    pub fn of(link: &Link) -> Option<Outline> {
        let all = || link.solids.iter().chain(&link.drawn);
        all().next()?;
        let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        for solid in all() {
            let half = solid.half_size();
            low = low.inf(&(solid.pose.position - half));
            high = high.sup(&(solid.pose.position + half));
        }
        // A body collides and is drawn in the same place: one of the two is its matter.
        let matter = if link.solids.is_empty() { &link.drawn } else { &link.solids };
        Some(Outline { low, high, exact: link.meshes == 0, uniform: Uniform::of(matter) })
    }

    /// The largest share of m L along the axes; `None` where the centre of mass is outside.
    pub fn fill(&self, mass: f64, center: &Vector3<f64>, tensor: &Matrix3<f64>) -> Option<f64> {
        let variance = (self.high - center).component_mul(&(center - self.low));
        if variance.iter().any(|v| *v < 0.0) {
            return None;
        }
        let share = |axis: usize| {
            let limit = variance.sum() - variance[axis];
            let moment = tensor[(axis, axis)];
            if moment == 0.0 { 0.0 } else { moment / (mass * limit) }
        };
        Some((0..3).map(share).fold(f64::NEG_INFINITY, f64::max))
    }

    /// Length of the diagonal of the box [m].
    pub fn size(&self) -> f64 {
        (self.high - self.low).norm()
    }
}

impl Uniform {
    fn of(solids: &[Solid]) -> Option<Uniform> {
        let volume: f64 = solids.iter().map(|solid| solid.shape.volume()).sum();
        if !(volume > 0.0 && volume.is_finite()) {
            return None;
        }
        let parts: Vec<Part> =
            solids.iter().map(|solid| solid.of_mass(solid.shape.volume() / volume)).collect();
        let (_, center, tensor) = compose(&parts);
        let own = parts.iter().map(|part| part.tensor * part.mass).sum();
        Some(Uniform { center, tensor, parts: own, volume })
    }
}
