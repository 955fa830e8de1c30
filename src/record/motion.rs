//! A motion to be shown: the turning body against time, as the truth has it and as a scheme does at a step.

use serde::{Deserialize, Serialize};

use super::findings::even;
use super::packed;

/// The turning of a body in a scene, seen from its principal axes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Motion {
    /// Scene.
    pub scene: String,
    /// Scheme; empty for the truth.
    pub scheme: String,
    /// Time step [s]; 0 for the truth.
    pub step_s: f64,
    /// Principal moments of the body about its origin [kg m²].
    pub moments: [f64; 3],
    /// Times [s], in files the last one and the number of equal intervals.
    #[serde(with = "even")]
    pub time_s: Vec<f64>,
    /// Quaternions (w, x, y, z) that take principal axes to world axes, one after the other.
    #[serde(with = "packed::list")]
    pub turn: Vec<f64>,
    /// Ω in principal axes [rad/s], one after the other.
    #[serde(with = "packed::list")]
    pub spin: Vec<f64>,
}

impl Motion {
    /// The quaternions.
    pub fn turns(&self) -> impl Iterator<Item = &[f64]> {
        self.turn.chunks_exact(4)
    }

    /// The angular velocities [rad/s].
    pub fn spins(&self) -> impl Iterator<Item = &[f64]> {
        self.spin.chunks_exact(3)
    }

    /// The rotational energy ½ Σ Iᵢ Ωᵢ² at each time [J].
    pub fn energies(&self) -> Vec<f64> {
        let energy = |spin: &[f64]| {
            let of = |(moment, w): (&f64, &f64)| 0.5 * moment * w * w;
            self.moments.iter().zip(spin).map(of).sum()
        };
        self.spins().map(energy).collect()
    }
}
