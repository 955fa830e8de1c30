//! The colours of a finished picture by number: a chart has a dozen colours and their mixtures along its edges.

use std::collections::HashMap;

/// Colours of a picture, of the 256 that a byte can name: a dozen and three mixtures of each with white along edges, and greys of letters. Fewer
/// compress better.
const MOST: usize = 64;
/// Pixels whose colour is not among them, at the most; where more are not, the picture is a map of many colours.
const REST: f64 = 0.1;

/// Pixels as numbers of colours.
pub(super) struct Named {
    /// Red, green and blue of each colour.
    pub palette: Vec<u8>,
    /// The number of the colour of each pixel.
    pub pixels: Vec<u8>,
}

type Colour = [u8; 3];

/// The pixels by number: the most frequent colours themselves, each rare one as the nearest of them. `None` where too many are rare.
pub(super) fn named(pixels: &[u8]) -> Option<Named> {
    let (all, _) = pixels.as_chunks::<3>();
    let mut counts: HashMap<Colour, usize> = HashMap::new();
    all.iter().for_each(|colour| *counts.entry(*colour).or_default() += 1);
    let mut by_count: Vec<(Colour, usize)> = counts.into_iter().collect();
    by_count.sort_by_key(|(colour, count)| (std::cmp::Reverse(*count), *colour));
    let (kept, rare) = by_count.split_at(by_count.len().min(MOST));
    let rest: usize = rare.iter().map(|(_, count)| count).sum();
    if rest as f64 > REST * all.len() as f64 {
        return None;
    }
    let mut numbers: HashMap<Colour, u8> =
        kept.iter().enumerate().map(|(number, (colour, _))| (*colour, number as u8)).collect();
    for (colour, _) in rare {
        let nearest = kept.iter().enumerate().min_by_key(|(_, (other, _))| distance(colour, other));
        numbers.insert(*colour, nearest.map_or(0, |(number, _)| number as u8));
    }
    Some(Named {
        palette: kept.iter().flat_map(|(colour, _)| *colour).collect(),
        pixels: all.iter().map(|colour| numbers[colour]).collect(),
    })
}

fn distance(a: &Colour, b: &Colour) -> i32 {
    a.iter().zip(b).map(|(a, b)| (i32::from(*a) - i32::from(*b)).pow(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frequent_colour_is_kept_and_a_rare_one_becomes_the_nearest() {
        let mut pixels = Vec::new();
        for level in 0..MOST as u8 {
            (0..100).for_each(|_| pixels.extend([2 * level, 0, 0]));
        }
        pixels.extend([100, 1, 0]);
        let named = named(&pixels).expect("as many colours and one more");
        let colour = |index: usize| {
            let number = usize::from(named.pixels[index]);
            &named.palette[3 * number..3 * number + 3]
        };
        assert_eq!(named.palette.len(), 3 * MOST);
        assert_eq!(colour(0), [0, 0, 0]);
        assert_eq!(colour(100 * MOST), [100, 0, 0]);
    }

    #[test]
    fn a_picture_of_many_colours_keeps_them_all() {
        let pixels: Vec<u8> = (0..600u16).flat_map(|n| [n as u8, (n >> 4) as u8, (n >> 8) as u8]).collect();
        assert!(named(&pixels).is_none());
    }
}
