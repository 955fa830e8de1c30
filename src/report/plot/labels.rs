//! Labels beside a panel, at the ends of its curves: each as near as it can be to its curve, none over another.

use super::palette::{GUIDE, Look};
use super::panel::Frame;
use super::sketch::{Anchor, Place, Sketch, Type};

/// A label and the end of the curve that it belongs to.
#[derive(Clone, Debug)]
pub(super) struct Label {
    /// The words.
    pub words: String,
    /// The last point of the curve.
    pub end: Place,
    /// The look of the curve.
    pub look: Look,
}

const EM: f64 = 28.0;
const LEADING: f64 = 38.0;
/// From the frame to the words; the leader lines run here.
const LEADER: f64 = 34.0;

/// Width of the column that the labels need.
pub(super) fn column_width<'a>(words: impl Iterator<Item = &'a str>) -> f64 {
    words.map(|words| Type::plain(EM, super::palette::INK).width(words)).fold(0.0, f64::max) + LEADER + 8.0
}

/// Draws the labels right of the frame, with grey dots from each curve to its label: no line of data is dotted grey.
pub(super) fn draw(sketch: &mut Sketch, frame: Frame, labels: Vec<Label>) {
    for (label, y) in placed(frame, labels) {
        let from = (label.end.0 + 14.0, label.end.1);
        let knee = (frame.right + 10.0, y);
        let places = vec![from, knee, (frame.right + LEADER - 6.0, y)];
        sketch.stroke(places, GUIDE, 2.0, &[2.0, 7.0]);
        write(sketch, frame, &label, y);
    }
}

fn write(sketch: &mut Sketch, frame: Frame, label: &Label, y: f64) {
    let face = Type::plain(EM, label.look.text);
    sketch.text(&label.words, (frame.right + LEADER, y), Anchor::Start, face);
}

/// The labels from top to bottom, and the height of each.
fn placed(frame: Frame, mut labels: Vec<Label>) -> Vec<(Label, f64)> {
    labels.sort_by(|a, b| a.end.1.total_cmp(&b.end.1));
    // More labels than lines fit beside the panel: the legend and the tables still name every scheme.
    labels.truncate(((frame.bottom - frame.top) / LEADING) as usize);
    let wanted: Vec<f64> = labels.iter().map(|label| label.end.1).collect();
    let heights = spread(&wanted, frame.top, frame.bottom, LEADING);
    labels.into_iter().zip(heights).collect()
}

/// Moves ordered heights apart until neighbours are `gap` apart, each as near as can be to where it was, all
/// between `top` and `bottom`.
fn spread(wanted: &[f64], top: f64, bottom: f64, gap: f64) -> Vec<f64> {
    // Heights that touch move as one block about the mean of their wishes: (sum of wishes, count).
    let mut blocks: Vec<(f64, usize)> = Vec::new();
    let first = |(sum, count): (f64, usize)| {
        let length = gap * (count - 1) as f64;
        let mean = sum / count as f64;
        (mean - length / 2.0).max(top + gap / 2.0).min(bottom - gap / 2.0 - length)
    };
    for height in wanted {
        let mut block = (*height, 1);
        while let Some(above) = blocks.last().copied() {
            if first(above) + gap * above.1 as f64 <= first(block) {
                break;
            }
            blocks.pop();
            block = (above.0 + block.0, above.1 + block.1);
        }
        blocks.push(block);
    }
    let places = |block: (f64, usize)| (0..block.1).map(move |n| first(block) + gap * n as f64);
    blocks.into_iter().flat_map(places).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_that_collide_are_moved_apart_and_stay_in_the_frame() {
        assert_eq!(spread(&[100.0, 300.0], 0.0, 400.0, 40.0), [100.0, 300.0]);
        assert_eq!(spread(&[100.0, 100.0], 0.0, 400.0, 40.0), [80.0, 120.0]);
        assert_eq!(spread(&[0.0, 0.0], 0.0, 400.0, 40.0), [20.0, 60.0]);
        assert_eq!(spread(&[399.0, 400.0, 400.0], 0.0, 400.0, 40.0), [300.0, 340.0, 380.0]);
    }
}
