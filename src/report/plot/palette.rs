//! Colours and markers: a scheme has the same ones in every picture.
//!
//! The colours are Okabe and Ito's, which stay apart for every kind of colour vision; a marker says the same
//! again without colour.

use plotters::style::RGBColor;

use super::sketch::Place;

/// Text and frames.
pub(super) const INK: RGBColor = RGBColor(0x22, 0x26, 0x2b);
/// Text of second rank.
pub(super) const SOFT: RGBColor = RGBColor(0x5c, 0x64, 0x6e);
/// Guide lines.
pub(super) const GUIDE: RGBColor = RGBColor(0x9a, 0xa2, 0xab);
/// Grid lines.
pub(super) const GRID: RGBColor = RGBColor(0xe6, 0xe9, 0xec);
/// The band of a floor or of a claim.
pub(super) const BAND: RGBColor = RGBColor(0xdd, 0xe1, 0xe5);
/// Curves over a map, on a rim of [`INK`].
pub(super) const OVER: RGBColor = RGBColor(0xff, 0xff, 0xff);
/// The ground of a panel that has words only.
pub(super) const NOTE: RGBColor = RGBColor(0xf5, 0xf6, 0xf7);

/// Okabe and Ito's colours, in the order that schemes take them.
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

const MARKERS: [Marker; 5] =
    [Marker::Disc, Marker::Square, Marker::Triangle, Marker::Diamond, Marker::TriangleDown];

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
}

/// The look of every scheme of the records.
pub(super) struct Palette<'a> {
    schemes: Vec<&'a str>,
}

impl<'a> Palette<'a> {
    /// Looks for these schemes, in this order.
    pub(super) fn new(schemes: Vec<&'a str>) -> Palette<'a> {
        Palette { schemes }
    }

    /// The schemes, in their order.
    pub(super) fn schemes(&self) -> &[&'a str] {
        &self.schemes
    }

    /// A scheme's look. Past 8 schemes the colours come again, with other markers.
    pub(super) fn look(&self, scheme: &str) -> Look {
        let index = self.schemes.iter().position(|name| *name == scheme).unwrap_or(self.schemes.len());
        let ink = COLOURS[index % COLOURS.len()];
        Look { ink, text: darker(ink), marker: MARKERS[index % MARKERS.len()] }
    }
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
