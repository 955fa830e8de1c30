//! Logs with one known change, of bodies and starts drawn by chance, and right logs: how many are named rightly, and how many wrongly?

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use polhode::internals::log::{Change, Request, judge_text};
use polhode::internals::ode::dop853;
use polhode::model::{Snapshot, System};
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form, Plan};

/// SplitMix64 (Steele, Lea, Flood 2014).
pub struct Chance(u64);

impl Chance {
    pub fn of(seed: u64) -> Chance {
        Chance(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def1)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    fn sign(&mut self) -> f64 {
        if self.next() & 1 == 0 { 1.0 } else { -1.0 }
    }

    fn vector(&mut self, low: f64, high: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.between(low, high) * self.sign())
    }

    fn turn(&mut self) -> UnitQuaternion<f64> {
        UnitQuaternion::from_scaled_axis(self.vector(0.2, 1.2))
    }

    fn normal(&mut self) -> f64 {
        (-2.0 * self.between(1e-12, 1.0).ln()).sqrt() * (TAU * self.between(0.0, 1.0)).cos()
    }
}

/// The changes that are made, with what each is named by.
pub const CHANGES: [(&str, Change); 33] = [
    ("w in degrees", Change::Unit),
    ("w in turns a minute", Change::Unit),
    ("x in centimetres", Change::Unit),
    ("x and v in millimetres", Change::Unit),
    ("v in feet", Change::Unit),
    ("t in milliseconds", Change::Unit),
    ("t in microseconds", Change::Unit),
    ("w negated", Change::Sign),
    ("vz negated", Change::Sign),
    ("qy negated", Change::Sign),
    ("scalar last", Change::ScalarLast),
    ("conjugated", Change::Convention),
    ("w in body axes", Change::Convention),
    ("v in body axes", Change::BodyVelocity),
    ("world turned", Change::TurnedWorld),
    ("world permuted", Change::PermutedWorld),
    ("axes mirrored", Change::PermutedBoth),
    ("body turned", Change::BodyAxes),
    ("other body point", Change::BodyPoint),
    ("shift in time", Change::Shift),
    ("a row late", Change::Row),
    ("w a row late", Change::Row),
    ("late start", Change::Shift),
    ("other start", Change::Start),
    ("products negated", Change::Inertia),
    ("moments in another order", Change::Inertia),
    ("v times 1.3", Change::Scale),
    ("x offset", Change::Offset),
    ("w clipped", Change::Clipped),
    ("w wrapped", Change::Wrapped),
    ("noise", Change::Noise),
    ("a scheme", Change::Scheme),
    ("no gyroscopic term", Change::Equations),
];

/// A scene and a log of it.
struct Drawn {
    scene: Scene,
    system: System,
    times: Vec<f64>,
}

fn draw(chance: &mut Chance, fast: bool) -> Drawn {
    let second = Vector3::new(chance.between(0.2, 0.5), chance.between(0.7, 1.0), chance.between(1.3, 2.0));
    let moments = Vector3::new(second.y + second.z, second.z + second.x, second.x + second.y);
    let axes = chance.turn().to_rotation_matrix().into_inner();
    let inertia: Matrix3<f64> = axes * Matrix3::from_diagonal(&moments) * axes.transpose();
    let inertia = (inertia + inertia.transpose()) * 0.5;
    let spin = if fast { chance.vector(3.5, 5.0) } else { chance.vector(0.5, 2.0) };
    let (velocity, position) = (chance.vector(0.5, 2.0), chance.vector(0.2, 1.0));
    let q = chance.turn();
    let gravity = if chance.below(2) == 0 {
        ""
    } else {
        "[[forces]]\nlaw = \"gravity\"\nacceleration = [0, 0, -9.81]\n"
    };
    let duration = chance.between(2.0, 6.0);
    let row = |k: usize| format!("[{:?}, {:?}, {:?}]", inertia[(k, 0)], inertia[(k, 1)], inertia[(k, 2)]);
    let vector = |v: Vector3<f64>| format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z);
    let text = format!(
        "name = \"drawn\"\nduration = {duration:?}\n[body]\nmass = 2.0\ninertia = [{}, {}, {}]\n[initial]\nposition = {}\n\
         orientation = [{:?}, {:?}, {:?}, {:?}]\nvelocity = {}\nangular_velocity = {}\n{gravity}",
        row(0),
        row(1),
        row(2),
        vector(position),
        q.w,
        q.i,
        q.j,
        q.k,
        vector(velocity),
        vector(spin)
    );
    let scene = Scene::parse(&text, "drawn.toml").expect("a scene");
    let count = 60 + chance.below(200);
    let times = (0..=count).map(|n| duration * n as f64 / count as f64).collect();
    Drawn { system: scene.system.clone(), scene, times }
}

fn solved(system: &System, times: &[f64]) -> Vec<Snapshot> {
    dop853::solve(system, times, dop853::TOLERANCE).expect("solved").states
}

/// The same body with another inertia.
fn with_inertia(drawn: &Drawn, change: impl Fn(&Matrix3<f64>) -> Matrix3<f64>) -> Vec<Snapshot> {
    let body = &drawn.system.body;
    let other = polhode::model::body::Body::from_inertia(body.mass, change(&body.inertia), None, true)
        .expect("a body");
    let start = &drawn.system.start;
    let spin = start.orientation
        * (body.inverse_inertia() * start.orientation.inverse_transform_vector(&start.angular_momentum));
    let laws = drawn.system.forces.laws().to_vec();
    let spin = polhode::model::Spin::Velocity(spin);
    let system =
        System::new(other, laws, start.position, start.orientation, start.velocity, spin).expect("a system");
    solved(&system, &drawn.times)
}

type Row = [f64; 14];

fn row(state: &Snapshot) -> Row {
    let (x, q, v, w) = (state.position, state.orientation, state.velocity, state.angular_velocity);
    [state.time, x.x, x.y, x.z, q.w, q.i, q.j, q.k, v.x, v.y, v.z, w.x, w.y, w.z]
}

/// The states of a log whose motion is changed.
fn states(name: &str, drawn: &Drawn, chance: &mut Chance) -> Vec<Snapshot> {
    let (system, times) = (&drawn.system, &drawn.times);
    let spacing = times[1];
    let moved = |shift: f64| {
        let later: Vec<f64> = std::iter::once(0.0).chain(times.iter().map(|t| t + shift)).collect();
        let states = solved(system, &later);
        states[1..].iter().zip(times).map(|(state, time)| Snapshot { time: *time, ..*state }).collect()
    };
    match name {
        "shift in time" => moved(spacing * chance.between(0.2, 0.8)),
        "late start" => moved(times[times.len() - 1] * chance.between(0.2, 0.4)),
        "other start" => {
            let mut start = solved(system, &[0.0])[0];
            start.orientation = chance.turn() * start.orientation;
            start.position += chance.vector(0.5, 1.0);
            start.velocity += chance.vector(0.5, 1.0);
            start.angular_velocity += chance.vector(0.3, 0.6);
            let own = start.orientation.inverse_transform_vector(&start.angular_velocity);
            start.angular_momentum = start.orientation * (system.body.inertia * own);
            solved(&system.started_at(&start), times)
        }
        "products negated" => with_inertia(drawn, |i| Matrix3::from_diagonal(&i.diagonal()) * 2.0 - i),
        "moments in another order" => with_inertia(drawn, |i| {
            let mut other = *i;
            (other[(0, 0)], other[(1, 1)], other[(2, 2)]) = (i[(1, 1)], i[(2, 2)], i[(0, 0)]);
            other
        }),
        "a scheme" => {
            let names = ["peskin-rk2", "semi-implicit-euler-explicit-gyro", "rk4-quaternion", "lie-verlet"];
            let name = names[chance.below(names.len())];
            let all = Contestant::all();
            let scheme = all.iter().find(|c| c.card.name == name).expect("a scheme");
            let plan = Plan { step: spacing, steps: times.len() as u64 - 1, every: 1 };
            let mut states = scheme.run(system, Form::Least, &plan).states;
            states.iter_mut().zip(times).for_each(|(state, time)| state.time = *time);
            states
        }
        "no gyroscopic term" => {
            let truth = solved(system, times);
            polhode::internals::study::cause::Cause::NoGyroscopicTerm
                .motion(system, &truth)
                .expect("a motion")
        }
        _ => solved(system, times),
    }
}

/// Changes of a row by itself.
fn change_row(name: &str, row: &mut Row, made: &Made) {
    let mut scale = |columns: std::ops::Range<usize>, by: f64| row[columns].iter_mut().for_each(|x| *x *= by);
    match name {
        "w in degrees" => scale(11..14, 180.0 / PI),
        "w in turns a minute" => scale(11..14, 30.0 / PI),
        "x in centimetres" => scale(1..4, 100.0),
        "x and v in millimetres" => {
            scale(1..4, 1000.0);
            scale(8..11, 1000.0);
        }
        "v in feet" => scale(8..11, 1.0 / 0.3048),
        "t in milliseconds" => scale(0..1, 1e3),
        "t in microseconds" => scale(0..1, 1e6),
        "w negated" => scale(11..14, -1.0),
        "vz negated" => scale(10..11, -1.0),
        "qy negated" => scale(6..7, -1.0),
        "scalar last" => row[4..8].rotate_left(1),
        "conjugated" => scale(5..8, -1.0),
        "v times 1.3" => scale(8..11, 1.3),
        "x offset" => (0..3).for_each(|k| row[1 + k] += made.vector[k]),
        "w clipped" => row[11..14].iter_mut().for_each(|w| *w = w.clamp(-made.limit, made.limit)),
        "w wrapped" => row[11..14].iter_mut().for_each(|w| *w -= TAU * (*w / TAU).round()),
        "axes mirrored" => {
            scale(3..4, -1.0);
            scale(10..11, -1.0);
            scale(5..7, -1.0);
            scale(11..13, -1.0);
        }
        _ => {}
    }
}

/// Changes of a state by itself.
fn change_state(name: &str, state: &mut Snapshot, made: &Made) {
    let turned = |state: &mut Snapshot, turn: &UnitQuaternion<f64>| {
        state.position = turn * state.position;
        state.velocity = turn * state.velocity;
        state.angular_velocity = turn * state.angular_velocity;
        state.orientation = turn * state.orientation;
    };
    match name {
        "w in body axes" => {
            state.angular_velocity = state.orientation.inverse_transform_vector(&state.angular_velocity);
        }
        "v in body axes" => state.velocity = state.orientation.inverse_transform_vector(&state.velocity),
        "world turned" => turned(state, &made.turn),
        "world permuted" => {
            turned(state, &UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI / 2.0));
        }
        "body turned" => state.orientation *= made.turn,
        "other body point" => state.position += state.orientation * made.vector,
        _ => {}
    }
}

/// What a change is made with.
struct Made {
    turn: UnitQuaternion<f64>,
    vector: Vector3<f64>,
    limit: f64,
}

fn written(rows: &[Row], digits: usize) -> String {
    let mut text = "t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n".to_owned();
    for row in rows {
        for (k, value) in row.iter().enumerate() {
            let comma = if k == 0 { "" } else { "," };
            write!(text, "{comma}{value:.digits$e}").expect("written");
        }
        text.push('\n');
    }
    text
}

/// What a log was named by.
#[derive(Clone, Debug, PartialEq)]
pub enum Named {
    Rightly,
    Wrongly(Vec<String>),
    Not,
}

/// A log with the change of this name, judged.
pub fn changed(seed: u64, name: &str, expected: Change) -> Named {
    let mut chance = Chance::of(seed);
    let drawn = draw(&mut chance, name == "w wrapped");
    let made = Made { turn: chance.turn(), vector: chance.vector(0.2, 0.8), limit: 0.0 };
    let mut states = states(name, &drawn, &mut chance);
    let largest = states.iter().map(|s| s.angular_velocity.amax()).fold(0.0, f64::max);
    let made = Made { limit: largest * chance.between(0.6, 0.9), ..made };
    states.iter_mut().for_each(|state| change_state(name, state, &made));
    let mut rows: Vec<Row> = states.iter().map(row).collect();
    rows.iter_mut().for_each(|row| change_row(name, row, &made));
    let late = |columns: std::ops::Range<usize>, rows: &mut [Row]| {
        for k in (1..rows.len()).rev() {
            let before = rows[k - 1];
            rows[k][columns.clone()].copy_from_slice(&before[columns.clone()]);
        }
    };
    match name {
        "a row late" => late(1..14, &mut rows),
        "w a row late" => late(11..14, &mut rows),
        "noise" => {
            let size = 10f64.powf(chance.between(-5.0, -2.0));
            rows.iter_mut().for_each(|row| row[1..].iter_mut().for_each(|x| *x += size * chance.normal()));
        }
        _ => {}
    }
    let digits = if name == "a scheme" { 16 } else { 8 + chance.below(8) };
    judged(&written(&rows, digits), &drawn.scene, Some(expected))
}

/// A right log, judged: solved to rounding or by a good scheme, to some digits.
pub fn right(seed: u64) -> Named {
    let mut chance = Chance::of(seed);
    let drawn = draw(&mut chance, false);
    let mut states = solved(&drawn.system, &drawn.times);
    let names =
        ["rk4-quaternion", "peskin-rk4", "peskin-rk2", "gauss-legendre-4", "strang-rotations", "lie-verlet"];
    if chance.below(2) == 0 {
        let name = names[chance.below(names.len())];
        let all = Contestant::all();
        let scheme = all.iter().find(|c| c.card.name == name).expect("a scheme");
        let parts = 10;
        let steps = parts * (drawn.times.len() as u64 - 1);
        let plan = Plan { step: drawn.times[1] / parts as f64, steps, every: parts };
        states = scheme.run(&drawn.system, Form::Least, &plan).states;
    }
    let rows: Vec<Row> = states
        .iter()
        .zip(&drawn.times)
        .map(|(state, time)| row(&Snapshot { time: *time, ..*state }))
        .collect();
    judged(&written(&rows, 5 + chance.below(12)), &drawn.scene, None)
}

fn judged(text: &str, scene: &Scene, expected: Option<Change>) -> Named {
    let judgement = judge_text(text, scene, &Request::default()).expect("a trajectory");
    let named = &judgement.explanations;
    if named.iter().any(|explanation| Some(explanation.change) == expected) {
        return Named::Rightly;
    }
    let hints: Vec<String> =
        named.iter().filter(|e| !e.is_remark()).map(|e| format!("{:?}: {}", e.change, e.words)).collect();
    if hints.is_empty() { Named::Not } else { Named::Wrongly(hints) }
}
