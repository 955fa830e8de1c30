//! Numbers by chance, the same for the same seed on every machine.

use nalgebra::Vector3;

/// Binary digits of the numbers of a dyadic scene.
const DIGITS: i32 = 10;

/// A stream of numbers: SplitMix64, Steele, Lea and Flood 2014.
pub(super) struct Draw {
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
