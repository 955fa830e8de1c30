//! Colours, markers and dashes: a scheme has the same ones in every picture.
//!
//! The colours are Okabe and Ito's, which stay apart for every kind of colour vision; marker and dash say the same
//! again without colour. Any two of the first 35 looks differ in colour, or in marker and dash.

use plotters::style::RGBColor;

use super::sketch::{Dash, Place};
use crate::record::SchemeRow;

/// Text and frames.
pub(super) const INK: RGBColor = RGBColor(0x22, 0x26, 0x2b);
/// Text of second rank.
pub(super) const SOFT: RGBColor = RGBColor(0x5c, 0x64, 0x6e);
/// Guide lines.
pub(super) const GUIDE: RGBColor = RGBColor(0x9a, 0xa2, 0xab);
/// Grid lines.
pub(super) const GRID: RGBColor = RGBColor(0xe6, 0xe9, 0xec);
/// Lines of schemes that are not named.
pub(super) const PALE: RGBColor = RGBColor(0xc3, 0xc9, 0xd0);
/// The band of a floor or of a claim.
pub(super) const BAND: RGBColor = RGBColor(0xdd, 0xe1, 0xe5);
/// Curves over a map, on a rim of [`INK`].
pub(super) const OVER: RGBColor = RGBColor(0xff, 0xff, 0xff);
/// The ground of a panel that has words only.
pub(super) const NOTE: RGBColor = RGBColor(0xf5, 0xf6, 0xf7);

/// Okabe and Ito's colours, in the order that schemes take them; yellow is too light for a line.
pub(super) const COLOURS: [RGBColor; 8] = [
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xcc, 0x79, 0xa7),
    RGBColor(0xe6, 0x9f, 0x00),
    RGBColor(0x56, 0xb4, 0xe9),
    RGBColor(0x00, 0x00, 0x00),
    RGBColor(0xf0, 0xe4, 0x42),
];

/// Colours of lines.
const LINES: usize = 7;
const MARKERS: [Marker; 5] =
    [Marker::Disc, Marker::Square, Marker::Triangle, Marker::Diamond, Marker::TriangleDown];
const DASHES: [Dash; 5] = [&[], &[15.0, 8.0], &[4.0, 8.0], &[24.0, 8.0, 4.0, 8.0], &[30.0, 14.0]];
/// Looks that main schemes keep for themselves.
const KEPT: usize = 12;

/// The sign that stands for a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Marker {
    /// A disc.
    Disc,
    /// A square.
    Square,
    /// A triangle on its base.
    Triangle,
    /// A square on its corner.
    Diamond,
    /// A triangle on its tip.
    TriangleDown,
}

impl Marker {
    /// The corners of the marker; `None` for a disc.
    pub(super) fn corners(self, (x, y): Place, radius: f64) -> Option<Vec<Place>> {
        let at = |corners: &[(f64, f64)]| {
            Some(corners.iter().map(|(right, down)| (x + right * radius, y + down * radius)).collect())
        };
        match self {
            Marker::Disc => None,
            Marker::Square => at(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
            Marker::Triangle => at(&[(0.0, -1.25), (1.1, 0.75), (-1.1, 0.75)]),
            Marker::Diamond => at(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)]),
            Marker::TriangleDown => at(&[(0.0, 1.25), (1.1, -0.75), (-1.1, -0.75)]),
        }
    }

    /// How much smaller the white inside of the hollow marker is, so that every rim looks as wide.
    pub(super) fn rim(self) -> f64 {
        match self {
            Marker::Disc | Marker::Square => 4.0,
            Marker::Diamond => 4.6,
            Marker::Triangle | Marker::TriangleDown => 6.0,
        }
    }
}

/// Colour and marker of a scheme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    /// Colour of lines and markers.
    pub ink: RGBColor,
    /// Darker colour for text, so that light colours stay readable.
    pub text: RGBColor,
    /// Marker.
    pub marker: Marker,
    /// Dashes of lines.
    pub dash: Dash,
}

/// The look of every scheme of the records.
pub(super) struct Palette<'a> {
    schemes: Vec<&'a str>,
    /// The number of the look of each.
    numbers: Vec<usize>,
}

impl<'a> Palette<'a> {
    /// Looks for these names, in this order.
    pub(super) fn new(schemes: Vec<&'a str>) -> Palette<'a> {
        Palette { numbers: (0..schemes.len()).collect(), schemes }
    }

    /// Looks for schemes: those that their cards name, and others for schemes without one.
    pub(super) fn of_schemes(schemes: Vec<&'a str>, cards: &[SchemeRow]) -> Palette<'a> {
        let mut free = if cards.iter().any(|card| card.look.is_some()) { KEPT.. } else { 0.. };
        let own = |name: &str| cards.iter().find(|card| card.name == name).and_then(|card| card.look);
        let number = |name: &&str| own(name).or_else(|| free.next()).unwrap_or_default();
        Palette { numbers: schemes.iter().map(number).collect(), schemes }
    }

    /// The schemes, in their order.
    pub(super) fn schemes(&self) -> &[&'a str] {
        &self.schemes
    }

    /// A scheme's look.
    pub(super) fn look(&self, scheme: &str) -> Look {
        let index = self.schemes.iter().position(|name| *name == scheme);
        look(index.map_or(self.schemes.len(), |index| self.numbers[index]))
    }
}

/// The look of a number: past 7 the colours come again, with other dashes and markers.
fn look(number: usize) -> Look {
    let ink = COLOURS[number % LINES];
    let (marker, dash) = (MARKERS[number % MARKERS.len()], DASHES[number / LINES % DASHES.len()]);
    Look { ink, text: darker(ink), marker, dash }
}

fn darker(RGBColor(red, green, blue): RGBColor) -> RGBColor {
    let part = |value: u8| (f64::from(value) * 0.78) as u8;
    RGBColor(part(red), part(green), part(blue))
}

/// A colour mixed with white: 1 keeps it, 0 is white.
pub(super) fn tint(RGBColor(red, green, blue): RGBColor, strength: f64) -> RGBColor {
    let part = |value: u8| (255.0 - (255.0 - f64::from(value)) * strength).round() as u8;
    RGBColor(part(red), part(green), part(blue))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_differ_in_colour_or_in_marker_and_dash() {
        for one in 0..LINES * DASHES.len() {
            for other in 0..one {
                let (a, b) = (look(one), look(other));
                assert!(a.ink != b.ink || (a.marker != b.marker && a.dash != b.dash), "{other} and {one}");
            }
        }
    }

    #[test]
    fn a_main_scheme_keeps_its_look_whatever_stands_beside_it_and_others_take_none_of_theirs() {
        let card = |name: &str, look| SchemeRow { name: name.into(), look, ..SchemeRow::default() };
        let cards = [card("mine", None), card("euler", Some(1)), card("peskin-rk2", Some(0))];
        let palette = Palette::of_schemes(vec!["mine", "euler", "peskin-rk2"], &cards);
        assert_eq!(palette.look("euler"), look(1));
        assert_eq!(palette.look("peskin-rk2"), look(0));
        assert_eq!(palette.look("mine"), look(KEPT));
    }
}
