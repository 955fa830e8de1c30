//! Scenes drawn by chance, from a seed: what nobody has chosen, and so what nobody has chosen well.
//!
//! Scenes of the family [`Family::Ordinary`] have numbers of a moderate size. The other families are extreme in one respect each.
//!
//! A scene is drawn as the text of a scene file, so that whatever it shows can be shown again. Its numbers are those of a
//! unit body (size, mass and rate of about one) told in units that lie up to four powers of ten apart. Half of the scenes have
//! numbers of ten binary digits and units that are powers of two.

mod bodies;
mod family;
mod laws;

use super::{Scene, SceneError};
use crate::model::forces::draw::{Draw, Surroundings};
use bodies::Drawn;
pub use family::Family;

/// Radians that the fastest motion of a scene turns through, at least and at most.
const RADIANS: (f64, f64) = (3.0, 60.0);

/// What numbers of a unit scene are told in.
#[derive(Clone, Copy, Debug)]
struct Units {
    mass: f64,
    length: f64,
    time: f64,
}

impl Units {
    fn draw(draw: &mut Draw) -> Units {
        let mut unit = |most: f64| {
            let unit = draw.logarithmic(1.0 / most, most);
            if draw.dyadic { unit.log2().round().exp2() } else { unit }
        };
        Units { mass: unit(1e3), length: unit(1e2), time: unit(1e2) }
    }

    fn velocity(&self) -> f64 {
        self.length / self.time
    }

    fn acceleration(&self) -> f64 {
        self.velocity() / self.time
    }

    fn force(&self) -> f64 {
        self.mass * self.acceleration()
    }

    fn inertia(&self) -> f64 {
        self.mass * self.length * self.length
    }
}

/// The text of the scene of this number in a family.
pub fn text(family: Family, seed: u64, number: u64) -> String {
    let mut draw = Draw::of(seed, number);
    let units = family.units(Units::draw(&mut draw));
    let body = family.body(&mut draw);
    let start = family.start(body.start(&mut draw), &body, &units, &mut draw);
    let around = Surroundings {
        body: &body.body,
        origin: body.origin(),
        position: start.position.unwrap_or_default(),
        velocity: start.velocity,
        radians: RADIANS.1,
    };
    let forces = if family == Family::Tumbling { laws::Mix::none() } else { laws::draw(&mut draw, &around) };
    let fastest = forces.rate + start.rate;
    let radians = draw.logarithmic(RADIANS.0, RADIANS.1) * family.longer();
    let duration = draw.number(radians / fastest.max(1e-3)) * units.time;
    let kink = match forces.kink {
        true => "not_for_order = \"a force has a kink or a jump: no scheme keeps its order across it\"\n",
        false => "",
    };
    format!(
        "name = \"{family}-{seed}-{number}\"\ntitle = \"{}\"\nduration = {duration:?}\n{kink}\n[body]\n{}\n[initial]\n{}{}",
        title(&body, &forces),
        body.text(&units),
        start.text(&units),
        forces.text(&units),
    )
}

fn title(body: &Drawn, forces: &laws::Mix) -> String {
    let laws = match forces.names().join(", ") {
        none if none.is_empty() => "no force".to_owned(),
        names => names,
    };
    format!("{} under {laws}", body.words())
}

/// The scene of this number in a family.
///
/// # Errors
/// The text is no scene, which a test rules out for the first thousand of the ordinary ones.
pub fn scene(family: Family, seed: u64, number: u64) -> Result<Scene, SceneError> {
    Scene::parse(&text(family, seed, number), &format!("{family}-{seed}-{number}.toml"))
}
