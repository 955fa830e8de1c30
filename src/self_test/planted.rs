//! Defects outside the scheme: in the force laws, at the start of a run, and in what a run shows. A right scheme runs; everything
//! around it is bent.

use nalgebra::{Matrix3, Vector3};

use crate::claim::Claim;
use crate::model::forces::{Forces, Law, OrbitingDipole, TorqueAxes, TorquePulse};
use crate::model::{PerQuantity, Snapshot, System};
use crate::reference::Reference;
use crate::rotation;
use crate::schemes::{PeskinRk2, Scheme};
use crate::simulate::Contestant;

/// How a defect is planted.
#[derive(Clone, Copy)]
pub(super) enum Plant {
    /// A flaw of the copy of the scheme.
    Scheme(super::flaw::Flaw),
    /// Another scheme in the place of one, under its name.
    Other(fn() -> Contestant),
    /// The scheme runs under other laws than those that it is judged in.
    Law(fn(&mut Law)),
    /// It starts elsewhere.
    Start(fn(&mut System)),
    /// What a run shows is not its state.
    Shown(fn(&mut Snapshot, &System)),
    /// Claims of the scheme of this name that it does not keep, in the place of those that they exclude.
    Claims(&'static str, &'static [Claim]),
    /// The reference is another motion.
    Reference(fn(&mut Reference)),
    /// Errors are measured wrongly.
    Metric(Measure),
}

impl Plant {
    /// Name of the scheme that it pretends to be.
    pub fn scheme(&self) -> &'static str {
        match self {
            Plant::Other(contestant) => contestant().card.name,
            Plant::Claims(name, _) => name,
            _ => PeskinRk2.card().name,
        }
    }
}

/// Error vectors of a run, measured wrongly.
pub(super) type Measure = fn(&super::measured::Seen) -> PerQuantity<Vec<f64>>;

/// A defect outside the scheme: its name, how it is planted, and the scenes that show it.
pub(super) type Row = (&'static str, Plant, &'static [&'static str]);

const SPRINGS: &[&str] = &["tether-springs", "lagrange-top-pivot-spring"];
const FIELDS: &[&str] = &["charged-body-in-fields", "time-dependent-field"];
const FALL: &[&str] = &["gravity-drag", "kovalevskaya"];
const WHEELS: &[&str] = &["gyrostat", "gyrostat-axial"];
const DAMPED: &[&str] = &["damped-tumble"];
const MAGNET: &[&str] = &["magnetic-satellite"];
const PULSES: &[&str] = &["thruster-pulse", "thruster-pulse-between-steps"];
const ORBITS: &[&str] = &["satellite-circular-orbit"];
/// Scenes whose body starts turned against the world.
const TURNED: &[&str] = &["satellite-gravity-gradient", "charged-body-in-fields"];
pub(super) const FREE: &[&str] = &["free-asymmetric", "tether-springs"];

/// Laws that are not those of the scene.
pub(super) const LAWS: &[Row] = &[
    (
        "spring without damping",
        Plant::Law(|law| spring(law, |s| s.damping = 0.0)),
        &["lagrange-top-pivot-spring", "tether-springs"],
    ),
    ("spring that is slack at a length", Plant::Law(|law| spring(law, |s| s.rest_length += 0.125)), SPRINGS),
    ("spring stiffer by a thousandth", Plant::Law(|law| spring(law, |s| s.stiffness *= 1.001)), SPRINGS),
    ("spring that pushes", Plant::Law(|law| spring(law, |s| s.stiffness = -s.stiffness)), SPRINGS),
    (
        "spring anchored at the origin",
        Plant::Law(|law| spring(law, |s| s.anchor = Vector3::zeros())),
        SPRINGS,
    ),
    ("gravity turned over", Plant::Law(|law| gravity(law, -1.0)), FALL),
    ("gravity of 9.81 told as 9.8", Plant::Law(|law| gravity(law, 9.8 / 9.81)), FALL),
    ("gravity dropped", Plant::Law(|law| gravity(law, 0.0)), FALL),
    ("drag doubled", Plant::Law(drag_doubled), &["gravity-drag"]),
    ("drag that drives", Plant::Law(drag_driving), &["gravity-drag"]),
    (
        "cross product of the magnetic force swapped",
        Plant::Law(|law| lorentz(law, |l| l.magnetic = -l.magnetic)),
        FIELDS,
    ),
    ("electric field dropped", Plant::Law(|law| lorentz(law, |l| l.electric = Vector3::zeros())), FIELDS),
    (
        "field frozen at its start",
        Plant::Law(|law| lorentz(law, |l| l.frequency = 0.0)),
        &["time-dependent-field"],
    ),
    ("sine of the field told as its cosine", Plant::Law(sine_for_cosine), &["time-dependent-field"]),
    ("central gravity a hundredth stronger", Plant::Law(central_stronger), &["gravity-gradient"]),
    ("gravity gradient without its factor 3", Plant::Law(gradient_third), &["satellite-gravity-gradient"]),
    ("gravity gradient along a fixed direction", Plant::Law(gradient_fixed), &["satellite-gravity-gradient"]),
    ("moment of the dipole turned over", Plant::Law(dipole_over), &["dipole-in-field"]),
    (
        "frequency in hertz",
        Plant::Law(|law| lorentz(law, |l| l.frequency *= std::f64::consts::TAU)),
        &["time-dependent-field"],
    ),
    ("gravity gradient turning backwards", Plant::Law(gradient_backwards), &["satellite-gravity-gradient"]),
    (
        "torque of body axes taken in world axes",
        Plant::Law(torque_in_world),
        &["spinning-coin", "sciml-rigidbody-wpd"],
    ),
    ("wheels dropped", Plant::Law(|law| wheels(law, 0.0)), WHEELS),
    ("wheels turning backwards", Plant::Law(|law| wheels(law, -1.0)), WHEELS),
    ("wheels slower by a thousandth", Plant::Law(|law| wheels(law, 0.999)), WHEELS),
    ("rotational damping that drives", Plant::Law(|law| damping(law, |c| *c = -*c)), DAMPED),
    (
        "rotational damping without products",
        Plant::Law(|law| damping(law, |c| *c = Matrix3::from_diagonal(&c.diagonal()))),
        DAMPED,
    ),
    ("rotational damping dropped", Plant::Law(|law| damping(law, |c| *c = Matrix3::zeros())), DAMPED),
    ("field of the orbit frozen at its start", Plant::Law(|law| orbit(law, |o| o.frequency = 0.0)), MAGNET),
    ("field of the orbit turning backwards", Plant::Law(|law| orbit(law, |o| o.frequency *= -1.0)), MAGNET),
    (
        "field of the orbit turning once an orbit",
        Plant::Law(|law| orbit(law, |o| o.frequency /= 2.0)),
        MAGNET,
    ),
    ("pulse shorter by a hundredth of a second", Plant::Law(|law| pulse(law, |p| p.end -= 0.01)), PULSES),
    ("pulse that does not end", Plant::Law(|law| pulse(law, |p| p.end = f64::INFINITY)), PULSES),
    (
        "pulse of world axes taken in body axes",
        Plant::Law(|law| pulse(law, |p| p.axes = TorqueAxes::Body)),
        PULSES,
    ),
    ("pull on the centre of mass a hundredth stronger", Plant::Law(|law| pull(law, 1.01)), ORBITS),
    ("pull on the centre of mass that pushes", Plant::Law(|law| pull(law, -1.0)), ORBITS),
];

/// Starts that are not those of the scene.
pub(super) const STARTS: &[Row] = &[
    (
        "orientation at the start left out",
        Plant::Start(|s| s.start.orientation = rotation::Rotation::identity()),
        TURNED,
    ),
    ("angular momentum taken for angular velocity", Plant::Start(momentum_for_spin), FREE),
    (
        "velocity at the start left out",
        Plant::Start(|s| s.start.velocity = Vector3::zeros()),
        &["gravity-drag", "tether-springs", "charged-body-in-fields"],
    ),
    ("angular momentum at the start in body axes", Plant::Start(momentum_in_body), TURNED),
    ("principal moments in another order", Plant::Start(moments_in_other_order), FREE),
    ("degrees for radians", Plant::Start(|s| s.start.angular_momentum *= 180.0 / std::f64::consts::PI), FREE),
    ("spin of the other hand", Plant::Start(|s| s.start.angular_momentum = -s.start.angular_momentum), FREE),
    ("velocity in km/h", Plant::Start(|s| s.start.velocity *= 3.6), &["tether-springs"]),
    ("length in feet", Plant::Start(|s| s.start.position /= 0.3048), &["tether-springs"]),
    ("mass in another unit", Plant::Start(|s| s.body.mass *= 1.0 / 0.453_592_37), &["tether-springs"]),
];

/// Runs that do not show their state.
pub(super) const SHOWN: &[Row] = &[
    ("orientation told as world to body", Plant::Shown(|s, _| s.orientation = s.orientation.inverse()), FREE),
    (
        "angular velocity in body axes",
        Plant::Shown(|s, _| s.angular_velocity = s.orientation.inverse_transform_vector(&s.angular_velocity)),
        FREE,
    ),
    (
        "angular momentum in body axes",
        Plant::Shown(|s, _| s.angular_momentum = s.orientation.inverse_transform_vector(&s.angular_momentum)),
        FREE,
    ),
    (
        "angular momentum for angular velocity",
        Plant::Shown(|s, _| s.angular_velocity = s.angular_momentum),
        FREE,
    ),
    (
        "angular velocity in degrees a second",
        Plant::Shown(|s, _| s.angular_velocity *= 180.0 / std::f64::consts::PI),
        FREE,
    ),
    (
        "position and velocity swapped",
        Plant::Shown(|s, _| std::mem::swap(&mut s.position, &mut s.velocity)),
        &["tether-springs"],
    ),
    ("position in centimetres", Plant::Shown(|s, _| s.position *= 100.0), &["tether-springs"]),
    ("angular momentum about the world's origin", Plant::Shown(momentum_about_origin), &["tether-springs"]),
    ("position of a point for the centre of mass", Plant::Shown(point_for_center), &["tether-springs"]),
    ("quaternion told x, y, z, w", Plant::Shown(scalar_last), FREE),
    ("numbers in single precision", Plant::Shown(single), FREE),
    ("a velocity that is not a number", Plant::Shown(|s, _| s.velocity.x = f64::NAN), FREE),
    ("an infinite angular velocity", Plant::Shown(|s, _| s.angular_velocity.z = f64::INFINITY), FREE),
    ("kinetic for angular velocity: twice too large", Plant::Shown(|s, _| s.angular_velocity *= 2.0), FREE),
    ("time of the step before", Plant::Shown(a_step_late), FREE),
];

fn spring(law: &mut Law, change: fn(&mut crate::model::forces::Spring)) {
    if let Law::Spring(spring) = law {
        change(spring);
    }
}

fn gravity(law: &mut Law, factor: f64) {
    if let Law::Gravity(gravity) = law {
        gravity.acceleration *= factor;
    }
}

fn lorentz(law: &mut Law, change: fn(&mut crate::model::forces::Lorentz)) {
    if let Law::Lorentz(lorentz) = law {
        change(lorentz);
    }
}

fn drag_doubled(law: &mut Law) {
    if let Law::Drag(drag) = law {
        drag.coefficient = drag.coefficient.scaled(2.0);
    }
}

fn drag_driving(law: &mut Law) {
    if let Law::Drag(drag) = law {
        drag.coefficient = drag.coefficient.scaled(-1.0);
    }
}

fn sine_for_cosine(law: &mut Law) {
    lorentz(law, |l| std::mem::swap(&mut l.electric_sine, &mut l.electric_cosine));
}

fn central_stronger(law: &mut Law) {
    if let Law::CentralGravity(central) = law {
        central.mu *= 1.01;
    }
}

fn gradient_third(law: &mut Law) {
    if let Law::GravityGradient(gradient) = law {
        gradient.mu_over_r3 /= 3.0;
    }
}

fn gradient_fixed(law: &mut Law) {
    if let Law::GravityGradient(gradient) = law {
        gradient.rate = 0.0;
    }
}

fn gradient_backwards(law: &mut Law) {
    if let Law::GravityGradient(gradient) = law {
        gradient.rate = -gradient.rate;
    }
}

fn dipole_over(law: &mut Law) {
    if let Law::Dipole(dipole) = law {
        dipole.moment = -dipole.moment;
    }
}

fn torque_in_world(law: &mut Law) {
    if let Law::Torque(torque) = law {
        torque.axes = TorqueAxes::World;
    }
}

fn wheels(law: &mut Law, factor: f64) {
    if let Law::Wheels(wheels) = law {
        wheels.momentum *= factor;
    }
}

fn damping(law: &mut Law, change: fn(&mut Matrix3<f64>)) {
    if let Law::RotationalDamping(damping) = law {
        change(&mut damping.coefficients);
    }
}

fn orbit(law: &mut Law, change: fn(&mut OrbitingDipole)) {
    if let Law::OrbitingDipole(dipole) = law {
        change(dipole);
    }
}

fn pulse(law: &mut Law, change: fn(&mut TorquePulse)) {
    if let Law::TorquePulse(pulse) = law {
        change(pulse);
    }
}

fn pull(law: &mut Law, factor: f64) {
    if let Law::MassCenterGravity(gravity) = law {
        gravity.mu *= factor;
    }
}

/// The system under other laws.
pub(super) fn under(system: &System, change: fn(&mut Law)) -> System {
    let mut laws = system.forces.laws().to_vec();
    laws.iter_mut().for_each(change);
    let mut other = system.clone();
    other.forces = Forces::new(laws, &other.body);
    other
}

fn momentum_for_spin(system: &mut System) {
    let turned = system.start.orientation.inverse_transform_vector(&system.start.angular_momentum);
    system.start.angular_momentum = system.start.orientation * (system.body.inertia * turned);
}

fn momentum_in_body(system: &mut System) {
    let start = &mut system.start;
    start.angular_momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
}

fn moments_in_other_order(system: &mut System) {
    system.body.moments = system.body.moments.yzx();
}

fn momentum_about_origin(shown: &mut Snapshot, system: &System) {
    shown.angular_momentum += shown.position.cross(&(shown.velocity * system.body.mass));
}

fn point_for_center(shown: &mut Snapshot, system: &System) {
    if let Some(point) = system.body.points.first() {
        shown.position += shown.orientation * point.position;
    }
}

fn scalar_last(shown: &mut Snapshot, _: &System) {
    let q = shown.orientation;
    shown.orientation = rotation::Rotation::new_normalize(nalgebra::Quaternion::new(q.i, q.j, q.k, q.w));
}

fn single(shown: &mut Snapshot, _: &System) {
    let round = |v: Vector3<f64>| v.map(|x| f64::from(x as f32));
    shown.angular_velocity = round(shown.angular_velocity);
    shown.angular_momentum = round(shown.angular_momentum);
    shown.position = round(shown.position);
}

/// As if the state were that of 10 ms before.
fn a_step_late(shown: &mut Snapshot, _: &System) {
    shown.orientation = rotation::turn(&(shown.angular_velocity * -0.01)) * shown.orientation;
    shown.position -= shown.velocity * 0.01;
}
