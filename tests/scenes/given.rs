//! Texts that the tests share, and what they do with them.

use polhode::model::Snapshot;
use polhode::scenes::{Fault, Scene, SceneError};

pub const HEAD: &str = "name = \"user-scene\"\nduration = 5.0\n";
pub const POINTS: &str = "[body]\npoints = [\n  { mass = 1.0, position = [1.0, 0.0, 0.5] },\n  { mass = 2.0, position = [0.0, 1.0, 0.0] },\n  { mass = 0.5, position = [-1.0, 0.25, 1.0] },\n]\n";
pub const INERTIA: &str = "[body]\nmass = 2.0\ninertia = [1.0, 2.0, 2.5]\n";
pub const ROD: &str = "[body]\npoints = [ { mass = 1.0, position = [1.0, 0.0, 0.0] }, { mass = 1.0, position = [-1.0, 0.0, 0.0] } ]\n";
pub const SINGLE: &str = "[body]\npoints = [ { mass = 1.0, position = [1.0, 2.0, 3.0] } ]\n";

/// A text, and the line, key and part of the message that it must be refused with.
pub struct Bad {
    pub text: String,
    pub line: usize,
    pub key: &'static str,
    pub says: &'static str,
}

/// A bad body after the head: its first line is line 3.
pub fn body(text: &str, line: usize, key: &'static str, says: &'static str) -> Bad {
    Bad { text: format!("{HEAD}{text}\n"), line, key, says }
}

/// A bad start of the three-point body: `[initial]` is line 9.
pub fn initial(text: &str, line: usize, key: &'static str, says: &'static str) -> Bad {
    Bad { text: format!("{HEAD}{POINTS}[initial]\n{text}\n"), line, key, says }
}

/// A bad law after a good one on the three-point body: its header is line 12, its name line 13.
pub fn law(text: &str, line: usize, key: &'static str, says: &'static str) -> Bad {
    let good = "[[forces]]\nlaw = \"gravity\"\nacceleration = [0, 0, -9.81]\n";
    Bad { text: format!("{HEAD}{POINTS}{good}[[forces]]\n{text}\n"), line, key, says }
}

/// A bad head before a good body.
pub fn head(text: &str, line: usize, key: &'static str, says: &'static str) -> Bad {
    Bad { text: format!("{text}\n{INERTIA}"), line, key, says }
}

pub fn assert_refused(cases: &[Bad]) {
    for bad in cases {
        match Scene::parse(&bad.text, "user.toml") {
            Err(SceneError::Content { faults, .. }) => {
                let right = |fault: &&Fault| {
                    let says = format!("{}: {}", fault.message, fault.advice).contains(bad.says);
                    fault.key == bad.key && fault.line == bad.line && says
                };
                let found = faults.iter().find(right);
                assert!(found.is_some(), "{}\nno {} '{}' in {faults:#?}", bad.text, bad.key, bad.says);
            }
            Err(other) => panic!("{}: {other}", bad.text),
            Ok(_) => panic!("not refused:\n{}", bad.text),
        }
    }
}

pub fn parse(text: &str) -> Scene {
    Scene::parse(text, "user.toml").unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// State of a system at t = 0.
pub fn start_of(scene: &Scene) -> Snapshot {
    let start = &scene.system.start;
    let body_momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    Snapshot {
        time: 0.0,
        position: start.position,
        velocity: start.velocity,
        orientation: start.orientation,
        angular_velocity: start.orientation * (scene.system.body.inverse_inertia() * body_momentum),
        angular_momentum: start.angular_momentum,
        stretch: 0.0,
    }
}

/// Every law once, with as few keys as it may have or with all of them.
pub const EVERY_LAW: &str = r#"
name = "every-law"
duration = 5

[body]
points = [
  { mass = 1, position = [1, 0, 0.5] },
  { mass = 2.0, position = [0.0, 1.0, 0.0] },
  { mass = 0.5, position = [-1.0, 0.25, 1.0] },
]

[[forces]]
law = "gravity"
acceleration = [0, 0, -9.81]
[[forces]]
law = "spring"
point = 2
anchor = [0, 0, 3]
stiffness = 1_00.0
damping = 0.5
rest_length = 1.0
[[forces]]
law = "spring"
at = [0.5, 0.5, 0.5]
stiffness = 0x10
[[forces]]
law = "drag"
coefficient = 0.1
[[forces]]
law = "central-gravity"
mu = 8.0
[[forces]]
law = "lorentz"
charge = [1, -2.0, 0.5]
magnetic = [0, 0.5, 2]
[[forces]]
law = "torque"
axes = "body"
sine = [0, 0, 1]
frequency = 2
[[forces]]
law = "dipole"
moment = [0, 0, 1]
field = [0, 0.1, 0]
[[forces]]
law = "gravity-gradient"
mu_over_r3 = 1.0
direction = [3, 0, 4]
[[forces]]
law = "ground"
stiffness = 1.0e4
friction = 0.5
[[forces]]
law = "rotational-damping"
coefficients = [0.1, 0.2, 0.3]
[[forces]]
law = "wheels"
momentum = [0.5, 0, 1]
[[forces]]
law = "orbiting-dipole"
moment = [0, 0, 1]
field_cosine = [0, 0.1, 0]
frequency = 2
[[forces]]
law = "mass-center-gravity"
mu = 8.0
[[forces]]
law = "torque-pulse"
axes = "world"
torque = [0, 0, 1]
end = 2
"#;
