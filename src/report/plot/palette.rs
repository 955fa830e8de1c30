//! Colours, markers and dashes: a scheme has the same ones in every picture.
//!
//! Twelve looks have a colour each, on white and on a dark ground. Dash and marker say the same again without colour. The colours were
//! found by a search for the greatest distance between any two; the first three and those of maps are Okabe and Ito's.

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

/// Okabe and Ito's colours: areas of maps.
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

/// Colours of lines on white and on a dark ground, in the order that schemes take them.
pub(super) const LINES: [(RGBColor, RGBColor); KEPT] = [
    (RGBColor(0x00, 0x72, 0xb2), RGBColor(0x3f, 0xa7, 0xf0)),
    (RGBColor(0xd5, 0x5e, 0x00), RGBColor(0xf9, 0x8f, 0x50)),
    (RGBColor(0x00, 0x9e, 0x73), RGBColor(0x03, 0xde, 0xaa)),
    (RGBColor(0xb0, 0x79, 0xd5), RGBColor(0xb8, 0x35, 0xf3)),
    (RGBColor(0x4f, 0xa5, 0x08), RGBColor(0xba, 0xdf, 0x0e)),
    (RGBColor(0x85, 0x1c, 0x43), RGBColor(0xf6, 0x27, 0x9f)),
    (RGBColor(0x1d, 0x97, 0xbf), RGBColor(0x1d, 0xed, 0xff)),
    (RGBColor(0xbd, 0x30, 0x16), RGBColor(0xe6, 0x2d, 0x00)),
    (RGBColor(0xe9, 0x2d, 0x94), RGBColor(0xef, 0x77, 0xb9)),
    (RGBColor(0x45, 0x79, 0xec), RGBColor(0x7e, 0x7c, 0xfa)),
    (RGBColor(0x18, 0x6b, 0x09), RGBColor(0x00, 0xff, 0x00)),
    (RGBColor(0x77, 0x88, 0x37), RGBColor(0x50, 0xcb, 0x18)),
];

/// Looks of one dash, one after the other.
const OF_A_DASH: usize = 4;
const MARKERS: [Marker; 5] =
    [Marker::Disc, Marker::Square, Marker::Triangle, Marker::Diamond, Marker::TriangleDown];
const DASHES: [Dash; 5] = [&[], &[16.0, 8.0], &[24.0, 8.0, 5.0, 8.0], &[5.0, 8.0], &[36.0, 12.0]];
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

/// The look of a number: past twelve the colours come again, with other dashes and markers.
pub(super) fn look(number: usize) -> Look {
    let (ink, _) = LINES[number % KEPT];
    let (marker, dash) = (MARKERS[number % MARKERS.len()], DASHES[number / OF_A_DASH % DASHES.len()]);
    Look { ink, text: legible(ink), marker, dash }
}

impl Look {
    /// As pages take it: the colour on white, the colour on a dark ground and the dashes, with blanks between.
    pub(super) fn of_pages(&self) -> String {
        let dark = LINES.iter().find(|(ink, _)| *ink == self.ink).map_or(PALE, |(_, dark)| *dark);
        // A page draws lines half as wide as a picture.
        let dash: Vec<String> = self.dash.iter().map(|length| (length / 2.0).to_string()).collect();
        format!("{} {} {}", hexadecimal(self.ink), hexadecimal(dark), dash.join(","))
    }
}

fn hexadecimal(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// The least contrast of text with its ground (WCAG 2.2, criterion 1.4.3).
const OF_TEXT: f64 = 4.5;

/// The colour itself, or as much darker as text on white must be.
fn legible(ink: RGBColor) -> RGBColor {
    let part = |value: u8| (f64::from(value) * 0.95) as u8;
    let darker =
        |RGBColor(red, green, blue): &RGBColor| Some(RGBColor(part(*red), part(*green), part(*blue)));
    let mut shades = std::iter::successors(Some(ink), darker);
    shades.find(|shade| contrast(*shade, RGBColor(255, 255, 255)) >= OF_TEXT).unwrap_or(INK)
}

/// The contrast of two colours: 1 to 21 (WCAG 2.2).
fn contrast(one: RGBColor, other: RGBColor) -> f64 {
    let luminance = |colour: RGBColor| {
        let [red, green, blue] = linear(colour);
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    };
    let (one, other) = (luminance(one), luminance(other));
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

/// The parts of a colour as amounts of light (IEC 61966-2-1).
fn linear(RGBColor(red, green, blue): RGBColor) -> [f64; 3] {
    [red, green, blue].map(|part| {
        let part = f64::from(part) / 255.0;
        if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
    })
}

/// A colour mixed with white: 1 keeps it, 0 is white.
pub(super) fn tint(RGBColor(red, green, blue): RGBColor, strength: f64) -> RGBColor {
    let part = |value: u8| (255.0 - (255.0 - f64::from(value)) * strength).round() as u8;
    RGBColor(part(red), part(green), part(blue))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A colour in OKLab (Björn Ottosson, 2020), where equal distances look alike.
    fn oklab([red, green, blue]: [f64; 3]) -> [f64; 3] {
        let cones = [
            0.412_221_470_8 * red + 0.536_332_536_3 * green + 0.051_445_992_9 * blue,
            0.211_903_498_2 * red + 0.680_699_545_1 * green + 0.107_396_956_6 * blue,
            0.088_302_461_9 * red + 0.281_718_837_6 * green + 0.629_978_700_5 * blue,
        ];
        let [l, m, s] = cones.map(f64::cbrt);
        [
            0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
            1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
            0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
        ]
    }

    /// The light that an eye without red or without green cones takes a colour for (Machado, Oliveira and Fernandes, 2009, severity 1).
    const DICHROMATS: [[[f64; 3]; 3]; 2] = [
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    ];

    fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
        let [one, other] = [oklab(one), oklab(other)];
        (0..3).map(|n| (one[n] - other[n]).powi(2)).sum::<f64>().sqrt()
    }

    fn distance_for(eye: &[[f64; 3]; 3], one: [f64; 3], other: [f64; 3]) -> f64 {
        let seen = |light: [f64; 3]| {
            eye.map(|row| {
                row.iter().zip(light).map(|(part, light)| part * light).sum::<f64>().clamp(0.0, 1.0)
            })
        };
        distance(seen(one), seen(other))
    }

    /// Colours side by side look different where they are 0.02 apart in OKLab; a thin line far from its legend needs several times as much. Of the ten
    /// colours of Tableau, which most plots have for ten lines, the two nearest are 0.113 apart (brown and grey). It holds for one marker, too.
    const OF_ONE_DASH: f64 = 0.12;
    /// Where dash and marker differ, too.
    const OF_ANY_TWO: f64 = 0.09;
    /// Two of one dash, whose markers differ, in an eye with two kinds of cones: four times the least difference.
    const OF_ONE_DASH_TO_DICHROMATS: f64 = 0.08;
    /// The least contrast of a line with its ground (WCAG 2.2, criterion 1.4.11).
    const OF_A_LINE: f64 = 3.0;

    #[test]
    fn twelve_looks_differ_on_white_and_on_a_dark_ground() {
        for side in [|pair: &(RGBColor, RGBColor)| pair.0, |pair: &(RGBColor, RGBColor)| pair.1] {
            for one in 0..KEPT {
                for other in 0..one {
                    let [a, b] = [one, other].map(|number| linear(side(&LINES[number])));
                    let apart = distance(a, b);
                    assert!(apart >= OF_ANY_TWO, "{other} and {one}: {apart}");
                    // A picture of points has markers alone.
                    let [a_look, b_look] = [one, other].map(look);
                    if a_look.marker == b_look.marker {
                        assert!(apart >= OF_ONE_DASH, "{other} and {one}: {apart}");
                    }
                    if a_look.dash == b_look.dash {
                        assert!(a_look.marker != b_look.marker, "{other} and {one}");
                        assert!(apart >= OF_ONE_DASH, "{other} and {one}: {apart}");
                        for eye in &DICHROMATS {
                            let apart = distance_for(eye, a, b);
                            assert!(apart >= OF_ONE_DASH_TO_DICHROMATS, "{other} and {one}: {apart}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn lines_and_their_words_stand_out_from_the_ground() {
        // The grounds of pages in the dark: of the page, and of a view of the motion.
        let dark = [RGBColor(0x16, 0x19, 0x1c), RGBColor(0x1f, 0x23, 0x27)];
        let white = RGBColor(255, 255, 255);
        for (number, (on_white, on_dark)) in LINES.into_iter().enumerate() {
            assert!(contrast(on_white, white) >= OF_A_LINE, "{number}: {}", contrast(on_white, white));
            assert!(contrast(look(number).text, white) >= OF_TEXT, "{number}");
            for ground in dark {
                assert!(contrast(on_dark, ground) >= OF_A_LINE, "{number}: {}", contrast(on_dark, ground));
            }
        }
    }

    #[test]
    fn sixty_looks_differ_in_colour_or_in_marker_and_dash() {
        for one in 0..KEPT * DASHES.len() {
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
