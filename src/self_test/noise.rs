//! Noise from a seed, the same on every machine.

/// A stream of numbers: SplitMix64, Steele, Lea and Flood 2014.
pub struct Noise(u64);

impl Noise {
    /// The stream of a seed.
    pub fn of(seed: u64) -> Noise {
        Noise(seed)
    }

    /// Evenly in (0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((z ^ (z >> 31)) >> 11) as f64 + 0.5) * 0.5f64.powi(53)
    }

    /// Normally, with deviation one: Box and Muller 1958.
    pub fn normal(&mut self) -> f64 {
        let (radius, angle) = ((-2.0 * self.unit().ln()).sqrt(), std::f64::consts::TAU * self.unit());
        radius * angle.cos()
    }
}
