//! Euler angles of any sequence.
//!
//! A sequence is written as three axes: `ZYX` turns about the moving axes Z, Y, X one after the other, `zyx` about the fixed ones. Fixed
//! axes in reverse order are moving axes. The angles of a rotation follow Bernardes and Viollet, PLOS ONE 17 (2022) e0276302.

use std::f64::consts::PI;
use std::str::FromStr;

use nalgebra::{UnitQuaternion, Vector3};

use crate::rotation::Rotation;

/// Three axes, and whether they move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    axes: [usize; 3],
    moving: bool,
}

impl Sequence {
    /// Yaw, pitch, roll.
    pub const YAW_PITCH_ROLL: Sequence = Sequence { axes: [2, 1, 0], moving: true };

    /// Every sequence of moving axes; fixed axes are these in reverse order.
    pub fn all() -> impl Iterator<Item = Sequence> {
        let triples = (0..27).map(|n| [n / 9, n / 3 % 3, n % 3]);
        triples.filter(|[a, b, c]| a != b && b != c).map(|axes| Sequence { axes, moving: true })
    }

    /// Whether each axis stands in it once.
    pub fn of_three_axes(self) -> bool {
        self.axes[0] != self.axes[2]
    }

    /// The axis at a place.
    pub fn axis(self, place: usize) -> usize {
        self.axes[place]
    }

    /// The place of the turn about an axis.
    pub fn place_of(self, axis: usize) -> usize {
        self.axes.iter().position(|a| *a == axis).unwrap_or(0)
    }

    /// The same turns with the axes the other way, fixed for moving.
    pub fn other_way(self) -> Sequence {
        Sequence { moving: !self.moving, ..self }
    }

    /// The rotation by angles [rad], in the order of the sequence.
    pub fn rotation(self, angles: [f64; 3]) -> Rotation {
        let turn = |k: usize| UnitQuaternion::from_axis_angle(&Vector3::ith_axis(self.axes[k]), angles[k]);
        if self.moving { turn(0) * turn(1) * turn(2) } else { turn(2) * turn(1) * turn(0) }
    }

    /// The angles of a rotation [rad].
    pub fn angles(self, rotation: &Rotation) -> [f64; 3] {
        let [i, j, mut k] = if self.moving { [self.axes[2], self.axes[1], self.axes[0]] } else { self.axes };
        let proper = i == k;
        if proper {
            k = 3 - i - j;
        }
        let sign = if (j + 3 - i) % 3 == 1 { 1.0 } else { -1.0 };
        let (q, w) = (rotation.imag(), rotation.w);
        let [a, b, c, d] = if proper {
            [w, q[i], q[j], q[k] * sign]
        } else {
            [w - q[j], q[i] + q[k] * sign, q[j] + w, q[k] * sign - q[i]]
        };
        let (half_sum, half_difference) = (b.atan2(a), d.atan2(c));
        let mut angles =
            [half_sum - half_difference, 2.0 * c.hypot(d).atan2(a.hypot(b)), half_sum + half_difference];
        if !proper {
            angles[2] *= sign;
            angles[1] -= PI / 2.0;
        }
        if self.moving {
            angles.reverse();
        }
        angles
    }
}

impl std::fmt::Display for Sequence {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let names = if self.moving { ['X', 'Y', 'Z'] } else { ['x', 'y', 'z'] };
        self.axes.iter().try_for_each(|axis| write!(f, "{}", names[*axis]))
    }
}

impl FromStr for Sequence {
    type Err = String;

    fn from_str(text: &str) -> Result<Sequence, String> {
        Sequence::all()
            .flat_map(|sequence| [sequence, sequence.other_way()])
            .find(|sequence| sequence.to_string() == text)
            .ok_or("expected three axes as ZYX (moving) or zyx (fixed), no axis twice in a row".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sequence_gives_the_rotation_back() {
        for sequence in Sequence::all().flat_map(|sequence| [sequence, sequence.other_way()]) {
            let angles = [0.4, if sequence.of_three_axes() { -0.7 } else { 0.7 }, 1.9];
            let found = sequence.angles(&sequence.rotation(angles));
            // A few roundings: 4e-16 measured.
            assert!((0..3).all(|k| (found[k] - angles[k]).abs() < 1e-14), "{sequence}: {found:?}");
            assert_eq!(sequence.to_string().parse::<Sequence>(), Ok(sequence));
        }
        assert_eq!(Sequence::all().count(), 12);
    }
}
