//! One picture of everything: the errors of all scenes against the step, and every measured order beside the
//! claimed ones.

use crate::record::{OrderStatus, Records};
use crate::report::survey::{self, Outcome};

use super::legend::{self, Entry, Sign};
use super::overview_panels as panels;
use super::palette::Palette;
use super::panel::{self, Frame};
use super::sketch::Sketch;

const WIDTH: f64 = 2800.0;
const TOP: f64 = 220.0;
const MARGIN: f64 = 40.0;
/// Height of a scene's row.
const ROW: f64 = 46.0;
/// The quantities that stand for a scene, the first that has an order.
const QUANTITIES: [&str; 2] = ["orientation-end", "body-point-end"];

/// The picture; `None` where no order was fitted.
pub(super) fn sketch(records: &Records, palette: &Palette) -> Option<Sketch> {
    let fitted = |quantity: &&str| {
        records
            .orders
            .iter()
            .any(|row| row.quantity == survey::base(quantity) && row.status == OrderStatus::Decided)
    };
    let quantity = QUANTITIES.into_iter().find(fitted)?;
    let scenes = ordered_scenes(records);
    let body = (ROW * scenes.len() as f64 + 40.0).clamp(900.0, 1900.0);
    let entries = entries(palette, quantity);
    let room = WIDTH - 2.0 * MARGIN;
    let strip = legend::height(&entries, room);
    let height = TOP + body + 120.0 + strip + MARGIN;
    let mut sketch =
        Sketch::new(WIDTH, height, "Measured order of accuracy of every scheme and scene".into());
    panel::headline(
        &mut sketch,
        "Measured order of accuracy of rigid-body schemes",
        &subtitle(records, &scenes),
    );
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom: TOP + body };
    let errors = Frame { left: all.left + 110.0, right: 1270.0, ..all };
    let orders = Frame { left: 1850.0, right: all.right - 10.0, ..all };
    panels::draw_errors(&mut sketch, records, palette, (&scenes, quantity), errors);
    panels::draw_orders(&mut sketch, records, palette, (&scenes, quantity), orders);
    legend::draw(&mut sketch, &entries, MARGIN, height - strip - MARGIN / 2.0, room);
    Some(sketch)
}

/// The scenes in which some order was fitted.
fn ordered_scenes(records: &Records) -> Vec<&str> {
    let fitted = |scene: &&str| {
        records.orders.iter().any(|row| row.scene == **scene && row.status == OrderStatus::Decided)
    };
    let set_apart =
        |scene: &&str| records.scenes.iter().any(|row| row.name == **scene && row.not_for_order.is_some());
    survey::scenes(records).into_iter().filter(|scene| fitted(scene) && !set_apart(scene)).collect()
}

fn subtitle(records: &Records, scenes: &[&str]) -> String {
    let counts = survey::tally(records.verdicts.iter());
    let shown: Vec<_> =
        counts.into_iter().filter(|(outcome, _)| *outcome != Outcome::NotApplicable).collect();
    let others = survey::scenes(records).len().saturating_sub(scenes.len());
    let apart = if others == 0 { String::new() } else { format!(" · {others} more scenes carry no order") };
    format!("verdicts: {} · {} scenes with an order{apart}", survey::tally_words(&shown), scenes.len())
}

fn entries(palette: &Palette, quantity: &str) -> Vec<Entry> {
    let schemes = palette.schemes().iter();
    let mut entries: Vec<Entry> =
        schemes.map(|scheme| Entry::new(Sign::Scheme(palette.look(scheme)), *scheme)).collect();
    entries.push(Entry::new(Sign::Guide, "guide of whole slope"));
    entries.push(Entry::new(Sign::Band, "claimed order ± 0.15"));
    let words = survey::quantity_words(quantity);
    entries.push(Entry::new(Sign::Filled, format!("large: {words}; small: other quantities")));
    entries
}
