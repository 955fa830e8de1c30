//! The names that programs give to columns, and the units in them.
//!
//! A name is cut into words at signs and at capitals; a unit in brackets or among the words is taken out; the last word, or the last
//! letter, is the component; what is left says the quantity. Formats that have names of their own (EuRoC, AirSim, 42, Basilisk, the NASA
//! check cases, MuJoCo, Drake, ROS) are covered by these words.

use super::names::{without_bracket, words_of};
use super::units::{factor, take_units};

/// A quantity that a column may be of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Time,
    Position,
    Quaternion,
    Velocity,
    Spin,
    /// Angles in the order of a sequence.
    Angles,
    /// Angles about named axes: roll, pitch, yaw.
    Roll,
    /// Modified Rodrigues parameters.
    Sigma,
    /// MuJoCo's coordinates of a free joint.
    Qpos,
    /// Its velocities.
    Qvel,
}

/// Which component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Component {
    Only,
    /// 0 to 2 for x, y, z.
    Axis(usize),
    /// The scalar of a quaternion.
    Scalar,
    /// A number, whose base the other columns decide.
    Digit(usize),
}

/// What a name says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meaning {
    pub kind: Kind,
    pub component: Component,
    /// SI units in the unit that the name states.
    pub unit: Option<f64>,
    /// Whether it says that an angular velocity is in body axes.
    pub in_body_axes: bool,
    /// Whether the last number of a quaternion is its scalar, wherever the numbers count from: the names of 42.
    pub scalar_last: bool,
}

pub(super) const TIMES: [&str; 10] =
    ["t", "time", "timestamp", "timestamps", "stamp", "simtime", "elapsed", "seconds", "secs", "sec"];
const ABOUT_TIME: [&str; 9] = ["sim", "unix", "utc", "epoch", "header", "field", "ros", "simulation", "abs"];
/// Words of columns that are no state: a bias, an acceleration, a force.
const OTHERS: [&str; 23] = [
    "bias",
    "acc",
    "accel",
    "acceleration",
    "a",
    "cov",
    "covariance",
    "std",
    "var",
    "err",
    "error",
    "force",
    "torque",
    "cmd",
    "ref",
    "des",
    "desired",
    "target",
    "mag",
    "alpha",
    "qacc",
    "gravity",
    "momentum",
];
const SPINS: [&str; 15] = [
    "w",
    "frameangvel",
    "omega",
    "om",
    "angvel",
    "gyro",
    "angular",
    "wbn",
    "wn",
    "wb",
    "spin",
    "angrate",
    "rotvel",
    "rates",
    "angv",
];
const VELOCITIES: [&str; 13] = [
    "v",
    "framelinvel",
    "qvel",
    "vel",
    "velocity",
    "linvel",
    "linear",
    "twist",
    "u",
    "speed",
    "vn",
    "vcm",
    "velo",
];
const POSITIONS: [&str; 19] = [
    "p",
    "framepos",
    "qpos",
    "xipos",
    "xpos",
    "pos",
    "position",
    "trans",
    "translation",
    "r",
    "loc",
    "location",
    "com",
    "cm",
    "xcm",
    "t",
    "pn",
    "rn",
    "coordinate",
];
pub(super) const QUATERNIONS: [&str; 15] = [
    "q",
    "xquat",
    "quat",
    "framequat",
    "quaternion",
    "orientation",
    "rot",
    "rotation",
    "attitude",
    "att",
    "qbn",
    "qn",
    "qb",
    "ori",
    "ep",
];

/// What a name says; `None` where it is not known.
pub(super) fn meaning(name: &str) -> Option<Meaning> {
    let (bare, bracket) = without_bracket(name);
    let mut words = words_of(bare);
    let mut units: Vec<String> = bracket.map(words_of).unwrap_or_default();
    take_units(&mut words, &mut units);
    let (stem, component) = split(&words)?;
    let has = |known: &[&str]| stem.iter().any(|word| known.contains(&word.as_str()));
    // EuRoC writes b_w for a bias; the b at the end of omega_BN_B is its axes.
    if has(&OTHERS) || stem.len() > 1 && stem[0] == "b" {
        return None;
    }
    let kind = kind(&stem, component)?;
    let (kind, component) = match (kind, component) {
        (Kind::Roll, Component::Only) => return None,
        other => other,
    };
    let unit = factor(kind, &units);
    let from_sensor = has(&["rs", "bn", "body", "gyro", "wbn", "imu", "rates", "b", "qvel"]);
    let in_body_axes = kind == Kind::Qvel || kind == Kind::Spin && from_sensor;
    Some(Meaning { kind, component, unit, in_body_axes, scalar_last: has(&["qbn", "qn"]) })
}

/// The quantity of a stem with a component.
fn kind(stem: &[String], component: Component) -> Option<Kind> {
    let has = |known: &[&str]| stem.iter().any(|word| known.contains(&word.as_str()));
    if component == Component::Only {
        let known = |word: &String| TIMES.contains(&word.as_str()) || ABOUT_TIME.contains(&word.as_str());
        return (has(&TIMES) && stem.iter().all(known)).then_some(Kind::Time);
    }
    if has(&["sigma", "mrp"]) {
        return Some(Kind::Sigma);
    }
    let numbered = matches!(component, Component::Digit(_));
    if numbered && has(&["qpos"]) {
        return Some(Kind::Qpos);
    }
    if numbered && has(&["qvel"]) {
        return Some(Kind::Qvel);
    }
    if has(&["euler", "eul", "rpy", "ypr"]) {
        return Some(if numbered { Kind::Angles } else { Kind::Roll });
    }
    if has(&SPINS) || has(&["ang", "body", "rotational"]) && has(&["rate", "velocity", "vel"]) {
        return (component != Component::Scalar || has(&QUATERNIONS))
            .then_some(if component == Component::Scalar { Kind::Quaternion } else { Kind::Spin });
    }
    if has(&QUATERNIONS) {
        return Some(Kind::Quaternion);
    }
    if component == Component::Scalar {
        return None;
    }
    if has(&["roll"]) {
        return Some(Kind::Roll);
    }
    if has(&VELOCITIES) {
        return Some(Kind::Velocity);
    }
    (stem.is_empty() || has(&POSITIONS)).then_some(Kind::Position)
}

/// The words before the component, and the component. A name of axes, as roll, is its own stem.
fn split(words: &[String]) -> Option<(Vec<String>, Component)> {
    let (last, before) = words.split_last()?;
    let mut stem = before.to_vec();
    if let Some(axis) = named_axis(last) {
        stem.push("roll".to_owned());
        return Some((stem, Component::Axis(axis)));
    }
    if words.len() == 1 && TIMES.contains(&last.as_str()) {
        return Some((words.to_vec(), Component::Only));
    }
    if let Some(component) = component(last) {
        return Some((stem, component));
    }
    let at = last.len() - last.chars().next_back().map_or(0, char::len_utf8);
    let (head, tail) = last.split_at(at);
    let known = [
        &SPINS[..],
        &VELOCITIES,
        &POSITIONS,
        &QUATERNIONS,
        &["sigma", "mrp", "euler", "eul", "qpos", "qvel"],
    ];
    match component(tail) {
        Some(component) if known.iter().any(|known| known.contains(&head)) => {
            stem.push(head.to_owned());
            Some((stem, component))
        }
        _ => Some((words.to_vec(), Component::Only)),
    }
}

fn named_axis(word: &str) -> Option<usize> {
    [["roll", "phi", "bank"], ["pitch", "theta", "elevation"], ["yaw", "psi", "heading"]]
        .iter()
        .position(|names| names.contains(&word))
}

fn component(word: &str) -> Option<Component> {
    match word {
        "x" | "i" => Some(Component::Axis(0)),
        "y" | "j" => Some(Component::Axis(1)),
        "z" | "k" => Some(Component::Axis(2)),
        "w" | "s" | "real" => Some(Component::Scalar),
        _ if word.len() == 1 => word.parse().ok().map(Component::Digit),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::Component::{Axis, Digit, Only, Scalar};
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn names_of_many_programs_are_known() {
        let cases = [
            ("t", Kind::Time, Only),
            ("#timestamp [ns]", Kind::Time, Only),
            ("TimeStamp", Kind::Time, Only),
            ("time_ms", Kind::Time, Only),
            ("header.stamp", Kind::Time, Only),
            ("p_RS_R_x [m]", Kind::Position, Axis(0)),
            ("q_RS_w []", Kind::Quaternion, Scalar),
            ("v_RS_R_z [m s^-1]", Kind::Velocity, Axis(2)),
            ("w_RS_S_x [rad s^-1]", Kind::Spin, Axis(0)),
            ("POS_X", Kind::Position, Axis(0)),
            ("Q_W", Kind::Quaternion, Scalar),
            ("tx", Kind::Position, Axis(0)),
            ("qbn4", Kind::Quaternion, Digit(4)),
            ("wbn_1", Kind::Spin, Digit(1)),
            ("sigma_BN[0]", Kind::Sigma, Digit(0)),
            ("omega_BN_B_2", Kind::Spin, Digit(2)),
            ("r_BN_N[1]", Kind::Position, Digit(1)),
            ("eulerAngle_deg_Yaw", Kind::Roll, Axis(2)),
            ("bodyAngularRateWrtEi_deg_s_Roll", Kind::Spin, Axis(0)),
            ("gePosition_ft_X", Kind::Position, Axis(0)),
            ("feVelocity_ft_s_Z", Kind::Velocity, Axis(2)),
            ("qpos_3", Kind::Qpos, Digit(3)),
            ("qvel[5]", Kind::Qvel, Digit(5)),
            ("$world_body_qw", Kind::Quaternion, Scalar),
            ("body_wx", Kind::Spin, Axis(0)),
            ("wx [deg/s]", Kind::Spin, Axis(0)),
            ("twist.angular.x", Kind::Spin, Axis(0)),
            ("twist.linear.y", Kind::Velocity, Axis(1)),
            ("pose.orientation.w", Kind::Quaternion, Scalar),
            ("posX", Kind::Position, Axis(0)),
            ("angular_velocity_z", Kind::Spin, Axis(2)),
            ("pitch", Kind::Roll, Axis(1)),
            ("framepos_x", Kind::Position, Axis(0)),
            ("frameangvel_2", Kind::Spin, Digit(2)),
            ("xquat_3", Kind::Quaternion, Digit(3)),
            ("qpos_x", Kind::Position, Axis(0)),
            ("qpos_qw", Kind::Quaternion, Scalar),
            ("qvel_y", Kind::Velocity, Axis(1)),
            ("qvel_wz", Kind::Spin, Axis(2)),
            ("x", Kind::Position, Axis(0)),
        ];
        for (name, kind, component) in cases {
            let found = meaning(name).map(|found| (found.kind, found.component));
            assert_eq!(found, Some((kind, component)), "{name}");
        }
        for name in [
            "b_w_RS_S_x [rad s^-1]",
            "a_RS_S_x [m s^-2]",
            "comment",
            "ax",
            "altitudeMsl_ft",
            "speedOfSound_ft_s",
        ] {
            assert_eq!(meaning(name), None, "{name}");
        }
        assert_eq!(meaning("wx [deg/s]").and_then(|found| found.unit), Some(PI / 180.0));
        assert_eq!(meaning("time_ms").and_then(|found| found.unit), Some(1e-3));
        assert_eq!(meaning("gePosition_ft_X").and_then(|found| found.unit), Some(0.3048));
    }
}
