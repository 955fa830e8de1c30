//! Numbers by chance, the same for the same seed on every machine.

use nalgebra::Vector3;

use crate::model::body::{Body, Shape};

/// Binary digits of the numbers of a dyadic scene.
const DIGITS: i32 = 10;

/// A stream of numbers: SplitMix64, Steele, Lea and Flood 2014.
#[derive(Debug)]
pub(crate) struct Draw {
    state: u64,
    /// Whether numbers have ten binary digits.
    pub dyadic: bool,
}

impl Draw {
    /// The stream of a scene.
    pub fn of(seed: u64, number: u64) -> Draw {
        let mut draw = Draw { state: seed, dyadic: false };
        draw.state = draw.bits() ^ number;
        draw.dyadic = draw.chance(0.5);
        draw
    }

    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 0.5f64.powi(53)
    }

    /// True this often.
    pub fn chance(&mut self, part: f64) -> bool {
        self.unit() < part
    }

    /// 0 … count − 1.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// A number as a scene has it.
    pub fn number(&self, value: f64) -> f64 {
        if !self.dyadic || value == 0.0 {
            return value;
        }
        let unit = f64::from(DIGITS - 1 - value.abs().log2().floor() as i32).exp2();
        (value * unit).round() / unit
    }

    /// Evenly between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let value = low + (high - low) * self.unit();
        self.number(value)
    }

    /// Between two positive numbers, evenly in their logarithm.
    pub fn logarithmic(&mut self, low: f64, high: f64) -> f64 {
        let value = low * (high / low).powf(self.unit());
        self.number(value)
    }

    /// Of this length or a little off it, in any direction.
    pub fn vector(&mut self, length: f64) -> Vector3<f64> {
        loop {
            let within = Vector3::from_fn(|_, _| 2.0 * self.unit() - 1.0);
            let norm = within.norm();
            if norm > 0.1 && norm <= 1.0 {
                return (within * (length / norm)).map(|x| self.number(x));
            }
        }
    }
}

/// A unit body and its start, for which laws are drawn: with a rate of about one they change its motion.
#[derive(Debug)]
pub(crate) struct Surroundings<'a> {
    /// The body.
    pub body: &'a Body,
    /// The origin of the body, in the frame of the scene's points.
    pub origin: Vector3<f64>,
    /// Where the centre of mass starts.
    pub position: Vector3<f64>,
    /// How it starts to move, where it does.
    pub velocity: Option<Vector3<f64>>,
    /// Radians that the fastest motion turns through, at most.
    pub radians: f64,
}

impl Surroundings<'_> {
    /// A place in the frame of the scene, near a mass point; on its line for a rod.
    pub fn place(&self, draw: &mut Draw) -> Vector3<f64> {
        let points = &self.body.points;
        let place = self.origin + points[draw.below(points.len())].position * draw.between(0.5, 1.5);
        if self.body.shape == Shape::Extended { place.map(|x| draw.number(x)) } else { place }
    }

    /// A moment of inertia between the smallest that is not zero and the largest, and that smallest one; `None` where nothing turns.
    pub fn moments(&self) -> Option<(f64, f64)> {
        let moments = self.body.moments;
        let smallest = moments.iter().copied().filter(|m| *m > 0.0).fold(f64::INFINITY, f64::min);
        smallest.is_finite().then(|| ((smallest * moments.max()).sqrt(), smallest))
    }

    /// The direction of a rod.
    pub fn rod(&self) -> Option<Vector3<f64>> {
        if let Shape::Rod { direction } = self.body.shape { Some(direction) } else { None }
    }
}
