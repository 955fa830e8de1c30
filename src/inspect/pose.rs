//! Places and axes of a file: the conventions of URDF, SDF and MJCF, turned into a position and a rotation matrix.

use nalgebra::{Matrix3, Quaternion, Unit, Vector3};

use super::element::{Element, Fault, finite};
use crate::rotation::{self, Rotation};

/// A frame in the axes of its link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    /// Origin [m].
    pub position: Vector3<f64>,
    /// Takes axes of the frame to axes of the link.
    pub axes: Matrix3<f64>,
}

impl Default for Pose {
    fn default() -> Pose {
        Pose { position: Vector3::zeros(), axes: Matrix3::identity() }
    }
}

impl Pose {
    /// A frame turned by a rotation.
    pub fn new(position: Vector3<f64>, rotation: &Rotation) -> Pose {
        Pose { position, axes: rotation::axes(rotation) }
    }

    /// A frame that is given in this frame.
    pub fn then(&self, inner: &Pose) -> Pose {
        Pose { position: self.position + self.axes * inner.position, axes: self.axes * inner.axes }
    }

    /// A tensor of the frame, in the axes of the link.
    pub fn turned(&self, tensor: &Matrix3<f64>) -> Matrix3<f64> {
        self.axes * tensor * self.axes.transpose()
    }
}

/// R = Rz(yaw) Ry(pitch) Rx(roll) [rad], the fixed axes of URDF and SDF.
pub(super) fn roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> Rotation {
    rotation::euler([yaw, pitch, roll], [2, 1, 0], true)
}

/// A rotation of w, x, y, z, of any length.
pub(super) fn quaternion(element: &Element, [w, x, y, z]: [f64; 4]) -> Result<Rotation, Fault> {
    let given = Quaternion::new(w, x, y, z);
    let length = given.norm();
    if !(length > 0.0 && length.is_finite()) {
        return Err(Fault::at(element, "a quaternion of length zero turns nothing: write 1 0 0 0"));
    }
    Ok(Rotation::new_normalize(given))
}

/// The `<origin xyz rpy>` inside an element of URDF.
pub(super) fn urdf(element: &Element) -> Result<Pose, Fault> {
    let Some(origin) = element.child("origin") else { return Ok(Pose::default()) };
    let of = |name: &str| origin.attribute(name).map_or(Ok([0.0; 3]), |text| finite::<3>(origin, text));
    Ok(Pose::new(of("xyz")?.into(), &roll_pitch_yaw(of("rpy")?)))
}

/// The `<pose>` inside an element of SDF: x y z roll pitch yaw, in degrees or as a quaternion where it says so.
pub(super) fn sdf(element: &Element) -> Result<Pose, Fault> {
    let Some(pose) = element.child("pose").filter(|pose| !pose.text().is_empty()) else {
        return Ok(Pose::default());
    };
    if pose.attribute("rotation_format") == Some("quat_xyzw") {
        let [px, py, pz, x, y, z, w] = finite::<7>(pose, pose.text())?;
        return Ok(Pose::new(Vector3::new(px, py, pz), &quaternion(pose, [w, x, y, z])?));
    }
    let [x, y, z, roll, pitch, yaw] = finite::<6>(pose, pose.text())?;
    let degrees = matches!(pose.attribute("degrees"), Some("true" | "1"));
    let angles = [roll, pitch, yaw].map(|angle| if degrees { angle.to_radians() } else { angle });
    Ok(Pose::new(Vector3::new(x, y, z), &roll_pitch_yaw(angles)))
}

/// The shortest rotation that takes z to `direction`.
pub(super) fn from_z(direction: &Vector3<f64>) -> Rotation {
    let Some(unit) = Unit::try_new(*direction, 0.0) else { return Rotation::identity() };
    Rotation::rotation_between(&Vector3::z(), &unit)
        .unwrap_or_else(|| rotation::turn(&(Vector3::x() * std::f64::consts::PI)))
}
