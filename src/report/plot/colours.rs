//! The colours of a finished picture by number: a chart has a dozen colours and their mixtures along its edges.

use std::collections::HashMap;

use super::palette::{COLOURS, GRID, GUIDE, INK, LINES, PALE, SOFT};

/// Colours of a chart: two pixels in a byte make it a third smaller than 64 colours, and the eye sees no difference.
pub(super) const FEW: usize = 16;
/// Colours of a chart of many schemes: those take more than half of the few.
const SOME: usize = 18;
/// Colours that are left for edges at the least.
const LEFT: usize = 2;
/// Colours of a table whose cells have many: fewer compress better than the 256 that a byte can name.
const MANY: usize = 64;
/// Pixels whose colour is not among them, at the most; where more are not, the picture is a map of many colours.
const REST: f64 = 0.1;

/// Squared distance that no two colours have.
const FAR: i64 = 1 << 20;

/// Pixels as numbers of colours.
pub(super) struct Named {
    /// Red, green and blue of each colour.
    pub palette: Vec<u8>,
    /// The number of the colour of each pixel.
    pub pixels: Vec<u8>,
}

type Colour = [u8; 3];

/// The pixels by number, of few colours where they are enough. `None` where many are not.
pub(super) fn named(pixels: &[u8]) -> Option<Named> {
    let (all, _) = pixels.as_chunks::<3>();
    let mut counts: HashMap<Colour, usize> = HashMap::new();
    all.iter().for_each(|colour| *counts.entry(*colour).or_default() += 1);
    let mut colours: Vec<(Colour, usize)> = counts.into_iter().collect();
    colours.sort_by_key(|(colour, count)| (std::cmp::Reverse(*count), *colour));
    let covers = |most: &usize| {
        let kept: usize = colours.iter().take(*most).map(|(_, count)| count).sum();
        kept as f64 >= (1.0 - REST) * all.len() as f64
    };
    let inks = colours.iter().filter(|(colour, _)| is_ink(colour)).count();
    let enough = |most: &usize| *most >= inks + LEFT && covers(most);
    let (palette, numbers) = chosen(&colours, [FEW, SOME, MANY].into_iter().find(enough)?)?;
    let numbers: HashMap<Colour, u8> = colours.iter().map(|(colour, _)| *colour).zip(numbers).collect();
    Some(Named { palette: palette.concat(), pixels: all.iter().map(|colour| numbers[colour]).collect() })
}

/// So many of the colours, and the number of the nearest for each. The most frequent one, those of schemes and of text come first, however few pixels
/// they have; each other in turn is the one that is missed the most: by its pixels times the fourth power of its distance from those before, since an
/// eye forgives many pixels that are a little off.
fn chosen(colours: &[(Colour, usize)], most: usize) -> Option<(Vec<Colour>, Vec<u8>)> {
    let first = colours.first()?.0;
    let mut wanted = colours.iter().map(|(colour, _)| *colour).filter(|one| *one != first && is_ink(one));
    let mut palette: Vec<Colour> = Vec::new();
    let mut nearest = vec![(FAR, 0); colours.len()];
    let mut next = Some(first);
    while let Some(chosen) = next.filter(|_| palette.len() < most) {
        let number = palette.len() as u8;
        palette.push(chosen);
        for ((own, _), near) in colours.iter().zip(&mut nearest) {
            *near = (*near).min((distance(own, &chosen), number));
        }
        let missed = |index: &usize| nearest[*index].0.pow(2) * colours[*index].1 as i64;
        let worst = (0..colours.len()).max_by_key(missed).filter(|worst| missed(worst) > 0);
        next = wanted.next().or(worst.map(|worst| colours[worst].0));
    }
    Some((palette, nearest.into_iter().map(|(_, number)| number).collect()))
}

/// Whether it is the colour of a scheme, or of text and rules.
fn is_ink(colour: &Colour) -> bool {
    let lines = LINES.iter().map(|(ink, _)| ink);
    let inks = lines.chain(&COLOURS).chain(&[INK, SOFT, GUIDE, GRID, PALE]);
    inks.into_iter().any(|ink| [ink.0, ink.1, ink.2] == *colour)
}

fn distance(a: &Colour, b: &Colour) -> i64 {
    a.iter().zip(b).map(|(a, b)| (i64::from(*a) - i64::from(*b)).pow(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frequent_colour_is_kept_and_a_rare_one_becomes_the_nearest() {
        let mut pixels = Vec::new();
        for level in 0..FEW as u8 {
            (0..100).for_each(|_| pixels.extend([10 * level, 0, 0]));
        }
        pixels.extend([100, 1, 0]);
        let named = named(&pixels).expect("as many colours and one more");
        let colour = |index: usize| {
            let number = usize::from(named.pixels[index]);
            &named.palette[3 * number..3 * number + 3]
        };
        assert_eq!(named.palette.len(), 3 * FEW);
        assert_eq!(colour(0), [0, 0, 0]);
        assert_eq!(colour(100 * FEW), [100, 0, 0]);
    }

    #[test]
    fn the_colour_of_a_scheme_is_kept_however_few_pixels_it_has() {
        let green = [COLOURS[2].0, COLOURS[2].1, COLOURS[2].2];
        let mut pixels: Vec<u8> = green.to_vec();
        for level in 0..FEW as u8 {
            (0..1000).for_each(|_| pixels.extend([16 * level, 16 * level, 255]));
        }
        let named = named(&pixels).expect("few colours");
        let number = usize::from(named.pixels[0]);
        assert_eq!(named.palette[3 * number..3 * number + 3], green);
    }

    #[test]
    fn a_picture_of_many_colours_keeps_them_all() {
        let pixels: Vec<u8> = (0..600u16).flat_map(|n| [n as u8, (n >> 4) as u8, (n >> 8) as u8]).collect();
        assert!(named(&pixels).is_none());
    }
}
