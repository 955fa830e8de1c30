//! Force laws by chance: none to five of them, with rates of about one on a unit body.

use nalgebra::Vector3;

use super::Units;
use super::bodies::{Drawn, Start, vector};
use super::draw::Draw;
use crate::model::body::Shape;
use crate::rotation;

/// What a law's numbers are told in.
#[derive(Clone, Copy)]
enum Kind {
    Pure,
    Length,
    Frequency,
    Velocity,
    Acceleration,
    Force,
    Torque,
    /// kg/s² of a spring, …
    Stiffness,
    /// … kg/s of a damper and of a magnetic force, …
    Damping,
    /// … m³/s² of central gravity.
    Central,
    /// 1/s² of a gradient of gravity.
    Gradient,
}

impl Kind {
    fn unit(self, units: &Units) -> f64 {
        match self {
            Kind::Pure => 1.0,
            Kind::Length => units.length,
            Kind::Frequency => 1.0 / units.time,
            Kind::Velocity => units.velocity(),
            Kind::Acceleration => units.acceleration(),
            Kind::Force => units.force(),
            Kind::Torque => units.force() * units.length,
            Kind::Stiffness => units.force() / units.length,
            Kind::Damping => units.mass / units.time,
            Kind::Central => units.length * units.length * units.acceleration(),
            Kind::Gradient => 1.0 / (units.time * units.time),
        }
    }
}

enum Value {
    Number(f64),
    List(Vec<f64>),
    Vector(Vector3<f64>),
    Index(usize),
    Word(&'static str),
}

/// A law with its numbers for a unit body.
struct Drafted {
    name: &'static str,
    rate: f64,
    keys: Vec<(&'static str, Kind, Value)>,
}

/// The laws of a scene.
pub(super) struct Mix {
    laws: Vec<Drafted>,
    /// Sum of the rates at which they change a motion.
    pub rate: f64,
    /// Whether a force has a kink.
    pub kink: bool,
}

impl Mix {
    pub fn names(&self) -> Vec<&'static str> {
        self.laws.iter().map(|law| law.name).collect()
    }

    pub fn text(&self, units: &Units) -> String {
        let mut text = String::new();
        for law in &self.laws {
            text += &format!("\n[[forces]]\nlaw = \"{}\"\n", law.name);
            for (key, kind, value) in &law.keys {
                let unit = kind.unit(units);
                let value = match value {
                    Value::Number(number) => format!("{:?}", number * unit),
                    Value::List(numbers) => {
                        format!("{:?}", numbers.iter().map(|x| x * unit).collect::<Vec<_>>())
                    }
                    Value::Vector(v) => vector(&(v * unit)),
                    Value::Index(index) => index.to_string(),
                    Value::Word(word) => format!("\"{word}\""),
                };
                text += &format!("{key} = {value}\n");
            }
        }
        text
    }
}

/// Draws the laws of a scene.
pub(super) fn draw(draw: &mut Draw, body: &Drawn, start: &Start) -> Mix {
    let count = match draw.unit() {
        x if x < 0.2 => 0,
        x if x < 0.5 => 1,
        x if x < 0.7 => 2,
        x if x < 0.85 => 3,
        x if x < 0.95 => 4,
        _ => 5,
    };
    let mut laws: Vec<Drafted> = Vec::new();
    while laws.len() < count {
        let law = match draw.below(9) {
            0 => Some(gravity(draw)),
            1 => Some(spring(draw, body, start)),
            2 => Some(drag(draw, body)),
            3 => Some(central_gravity(draw, start)),
            4 => Some(lorentz(draw, body)),
            5 => torque(draw, body),
            6 => dipole(draw, body),
            7 => Some(gravity_gradient(draw)),
            _ => draw.chance(0.4).then(|| ground(draw, start)),
        };
        laws.extend(
            law.filter(|law| law.name == "spring" || laws.iter().all(|other| other.name != law.name)),
        );
    }
    let (rate, kink) = (laws.iter().map(|law| law.rate).sum(), laws.iter().any(|law| law.name == "ground"));
    Mix { laws, rate, kink }
}

/// Where the centre of mass of a scene about starts.
fn position(start: &Start) -> Vector3<f64> {
    start.position.unwrap_or_default()
}

fn gravity(draw: &mut Draw) -> Drafted {
    let rate = draw.logarithmic(0.2, 1.0);
    let acceleration = draw.vector(rate * rate);
    let keys = vec![("acceleration", Kind::Acceleration, Value::Vector(acceleration))];
    Drafted { name: "gravity", rate, keys }
}

/// On a mass point, or near one.
fn spring(draw: &mut Draw, body: &Drawn, start: &Start) -> Drafted {
    let rate = draw.logarithmic(0.3, 2.0);
    let distance = draw.between(2.0, 4.0);
    let anchor = position(start) + draw.vector(distance);
    let anchor = anchor.map(|x| draw.number(x));
    let place = if draw.chance(0.6) {
        ("point", Kind::Pure, Value::Index(draw.below(body.points().len())))
    } else {
        ("at", Kind::Length, Value::Vector(body.place(draw)))
    };
    let mut keys = vec![
        place,
        ("anchor", Kind::Length, Value::Vector(anchor)),
        ("stiffness", Kind::Stiffness, Value::Number(draw.number(rate * rate))),
    ];
    if draw.chance(0.5) {
        let part = draw.logarithmic(0.02, 0.5);
        keys.push(("damping", Kind::Damping, Value::Number(draw.number(2.0 * part * rate))));
    }
    if draw.chance(0.3) {
        keys.push(("rest_length", Kind::Length, Value::Number(draw.between(0.5, 1.5))));
    }
    Drafted { name: "spring", rate, keys }
}

/// One coefficient for all points, or one each in proportion to nothing.
fn drag(draw: &mut Draw, body: &Drawn) -> Drafted {
    let rate = draw.logarithmic(0.03, 0.5);
    let lightest = body.points().iter().map(|p| p.mass).fold(f64::INFINITY, f64::min);
    let coefficient = if draw.chance(0.5) {
        Value::Number(draw.number(rate * lightest))
    } else {
        let each = |draw: &mut Draw, mass: f64| {
            let part = draw.between(0.2, 1.0);
            draw.number(rate * mass * part)
        };
        Value::List(body.points().iter().map(|p| each(draw, p.mass)).collect())
    };
    Drafted { name: "drag", rate, keys: vec![("coefficient", Kind::Damping, coefficient)] }
}

/// From so far, with a velocity across, or for so short that the body does not fall into the centre within the run: from rest
/// it takes 1.1 over the rate.
fn central_gravity(draw: &mut Draw, start: &Start) -> Drafted {
    let distance = draw.between(5.0, 9.0);
    let any = draw.vector(distance);
    let (rate, center, longest) = match start.velocity {
        Some(velocity) => {
            let across = velocity.cross(&any).normalize() * distance;
            let circular = rotation::length(&velocity) / distance;
            (circular * draw.between(0.8, 1.2), across, 10.0)
        }
        None => (draw.logarithmic(0.1, 0.5), any, 0.8),
    };
    let center = (position(start) + center).map(|x| draw.number(x));
    let mu = draw.number(rate * rate * distance.powi(3));
    let keys =
        vec![("mu", Kind::Central, Value::Number(mu)), ("center", Kind::Length, Value::Vector(center))];
    Drafted { name: "central-gravity", rate: rate * super::RADIANS.1 / longest, keys }
}

/// Charges in proportion to nothing, of both signs.
fn lorentz(draw: &mut Draw, body: &Drawn) -> Drafted {
    let charge = if draw.chance(0.3) {
        Value::Number(draw.between(-1.0, 1.0))
    } else {
        Value::List(body.points().iter().map(|p| draw.between(-1.0, 1.0) * p.mass).collect())
    };
    let mut keys = vec![("charge", Kind::Pure, charge)];
    let (mut rate, frequency) = (0.5, draw.logarithmic(0.3, 3.0));
    for key in ["electric", "electric_cosine", "electric_sine"] {
        if draw.chance(0.5) {
            keys.push((key, Kind::Force, Value::Vector(draw.vector(0.5))));
        }
    }
    keys.push(("frequency", Kind::Frequency, Value::Number(frequency)));
    if draw.chance(0.7) {
        let magnetic = draw.logarithmic(0.2, 2.0);
        keys.push(("magnetic", Kind::Damping, Value::Vector(draw.vector(magnetic))));
        rate += magnetic;
    }
    Drafted { name: "lorentz", rate: rate + frequency, keys }
}

/// Between the smallest moment that is not zero and the largest one; `None` where nothing turns.
fn middle_moment(body: &Drawn) -> Option<(f64, f64)> {
    let moments = body.body.moments;
    let smallest = moments.iter().copied().filter(|m| *m > 0.0).fold(f64::INFINITY, f64::min);
    smallest.is_finite().then(|| ((smallest * moments.max()).sqrt(), smallest))
}

fn torque(draw: &mut Draw, body: &Drawn) -> Option<Drafted> {
    let (moment, smallest) = middle_moment(body)?;
    let (rate, frequency) = (draw.logarithmic(0.2, 1.0), draw.logarithmic(0.3, 3.0));
    let size = rate * rate * moment;
    let rod = if let Shape::Rod { direction } = body.body.shape { Some(direction) } else { None };
    let axes = if rod.is_some() || draw.chance(0.5) { "body" } else { "world" };
    let amplitude = |draw: &mut Draw| {
        let any = draw.vector(size);
        rod.map_or(any, |direction| direction.cross(&any))
    };
    let mut keys = vec![("axes", Kind::Pure, Value::Word(axes))];
    for key in ["constant", "cosine", "sine"] {
        if draw.chance(0.6) {
            keys.push((key, Kind::Torque, Value::Vector(amplitude(draw))));
        }
    }
    keys.push(("frequency", Kind::Frequency, Value::Number(frequency)));
    Some(Drafted { name: "torque", rate: (size / smallest).sqrt() + frequency, keys })
}

fn dipole(draw: &mut Draw, body: &Drawn) -> Option<Drafted> {
    let (moment, smallest) = middle_moment(body)?;
    let rate = draw.logarithmic(0.3, 1.0);
    let size = rate * rate * moment;
    let moment = match body.body.shape {
        Shape::Rod { direction } => direction * size,
        _ => draw.vector(size),
    };
    let keys = vec![
        ("moment", Kind::Torque, Value::Vector(moment)),
        ("field", Kind::Pure, Value::Vector(draw.vector(1.0))),
    ];
    Some(Drafted { name: "dipole", rate: (size / smallest).sqrt(), keys })
}

fn gravity_gradient(draw: &mut Draw) -> Drafted {
    let rate = draw.logarithmic(0.2, 1.0);
    let direction = draw.vector(1.0);
    let mut keys = vec![
        ("mu_over_r3", Kind::Gradient, Value::Number(draw.number(rate * rate))),
        ("direction", Kind::Pure, Value::Vector(direction)),
    ];
    if draw.chance(0.7) {
        let normal = direction.cross(&draw.vector(1.0));
        if rotation::length(&normal) > 0.1 {
            keys.push(("normal", Kind::Pure, Value::Vector(normal)));
            keys.push(("rate", Kind::Frequency, Value::Number(draw.number(rate))));
        }
    }
    Drafted { name: "gravity-gradient", rate: 1.7 * rate, keys }
}

/// Below the body, stiff.
fn ground(draw: &mut Draw, start: &Start) -> Drafted {
    let rate = draw.logarithmic(2.0, 6.0);
    let height = draw.number(position(start).z - 1.5);
    let mut keys = vec![
        ("height", Kind::Length, Value::Number(height)),
        ("stiffness", Kind::Stiffness, Value::Number(draw.number(rate * rate))),
    ];
    if draw.chance(0.5) {
        keys.push(("damping", Kind::Damping, Value::Number(draw.number(0.2 * rate))));
    }
    if draw.chance(0.5) {
        keys.push(("friction", Kind::Pure, Value::Number(draw.between(0.1, 0.6))));
        keys.push(("slip_velocity", Kind::Velocity, Value::Number(0.125)));
    }
    Drafted { name: "ground", rate, keys }
}
