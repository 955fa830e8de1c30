//! From a number to a colour that the eye orders as it orders the numbers.
//!
//! Viridis (Stéfan van der Walt, Nathaniel Smith and Eric Firing, 2015; released into the public domain, CC0): lightness rises
//! evenly from dark violet to yellow, so that the order survives in grey and for every kind of colour vision. Ten of its
//! colours at equal distances, and the straight line between neighbours.

use plotters::style::RGBColor;

use super::palette::COLOURS;

const VIRIDIS: [RGBColor; 10] = [
    RGBColor(0x44, 0x01, 0x54),
    RGBColor(0x48, 0x28, 0x78),
    RGBColor(0x3e, 0x4a, 0x89),
    RGBColor(0x31, 0x68, 0x8e),
    RGBColor(0x26, 0x82, 0x8e),
    RGBColor(0x1f, 0x9e, 0x89),
    RGBColor(0x35, 0xb7, 0x79),
    RGBColor(0x6d, 0xcd, 0x59),
    RGBColor(0xb4, 0xde, 0x2c),
    RGBColor(0xfd, 0xe7, 0x25),
];

/// The colour of a part of the range: 0 at the low end, 1 at the high end; what lies outside has the colour of that end.
pub(super) fn viridis(part: f64) -> RGBColor {
    let along = part.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let below = (along.floor() as usize).min(VIRIDIS.len() - 2);
    mix(VIRIDIS[below], VIRIDIS[below + 1], along - below as f64)
}

/// The colour of a part of a range with zero in its middle: blue below, white at the middle, vermilion above.
pub(super) fn diverging(part: f64) -> RGBColor {
    const WHITE: RGBColor = RGBColor(255, 255, 255);
    let away = (2.0 * part.clamp(0.0, 1.0) - 1.0).abs();
    mix(WHITE, if part < 0.5 { COLOURS[0] } else { COLOURS[1] }, away)
}

/// Luma of ITU-R BT.601: how light a colour is, of 255.
pub(super) fn luma(RGBColor(red, green, blue): RGBColor) -> f64 {
    0.299 * f64::from(red) + 0.587 * f64::from(green) + 0.114 * f64::from(blue)
}

fn mix(from: RGBColor, to: RGBColor, part: f64) -> RGBColor {
    let channel = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
    RGBColor(channel(from.0, to.0), channel(from.1, to.1), channel(from.2, to.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_rises_all_the_way() {
        for step in 0..100 {
            let (a, b) = (f64::from(step) / 100.0, f64::from(step + 1) / 100.0);
            assert!(luma(viridis(a)) < luma(viridis(b)), "{a}");
        }
    }

    #[test]
    fn ends_are_held_outside_the_range() {
        assert_eq!(viridis(-3.0), VIRIDIS[0]);
        assert_eq!(viridis(7.0), VIRIDIS[9]);
    }
}
