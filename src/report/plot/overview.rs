//! One picture of everything: the errors of all scenes against the step, and every measured order beside the
//! claimed ones.

use crate::record::{Order, OrderStatus, Records};
use crate::report::number;
use crate::report::survey::{self, Outcome};

use super::key::{Key, Row};
use super::legend::{self, Entry, Sign};
use super::orders_panel;
use super::overview_panels as panels;
use super::palette::{Palette, SOFT};
use super::panel::{self, Frame};
use super::sketch::{Anchor, Sketch, Type};

const WIDTH: f64 = 3000.0;
const TOP: f64 = 220.0;
const MARGIN: f64 = 40.0;
/// Height of a scene's row.
const ROW: f64 = 46.0;
/// Between the right edge of the errors and the left edge of the orders: the names of the scenes.
const ERRORS_END: f64 = 1080.0;
const ORDERS_BEGIN: f64 = 1690.0;
/// The quantities that stand for a scene, the first that has an order.
const QUANTITIES: [&str; 2] = ["orientation-end", "body-point-end"];

/// The picture; `None` where no order was fitted.
pub(super) fn sketch(records: &Records, palette: &Palette) -> Option<Sketch> {
    let quantity = quantity(records)?;
    let scenes = ordered_scenes(records);
    let columns = columns(records, palette);
    let head = head(&columns);
    let body = head + (ROW * scenes.len() as f64 + 40.0).clamp(400.0, 2200.0);
    let entries = entries(quantity);
    let key = key(records, palette);
    let room = WIDTH - 2.0 * MARGIN;
    let bottom = TOP + body.max(900.0);
    let height = bottom + 130.0 + key.height(room) + legend::height(&entries, room) + MARGIN;
    let mut sketch =
        Sketch::new(WIDTH, height, "Measured order of accuracy of every scheme and scene".into());
    panel::headline(
        &mut sketch,
        "Measured order of accuracy of rigid-body schemes",
        &subtitle(records, &scenes),
    );
    let errors = Frame { left: MARGIN + 110.0, top: TOP, right: ERRORS_END, bottom };
    let orders = Frame { left: ORDERS_BEGIN, top: TOP + head, right: WIDTH - MARGIN, bottom };
    panels::draw_errors(&mut sketch, records, palette, (&scenes, quantity), errors);
    let names = orders_panel::NAME_ROOM;
    orders_panel::draw(&mut sketch, records, palette, (&scenes, &columns, quantity), (orders, names));
    key.draw(&mut sketch, MARGIN, bottom + 120.0, room);
    legend::draw(&mut sketch, &entries, MARGIN, bottom + 130.0 + key.height(room), room);
    Some(sketch)
}

/// Width of the picture for a narrow screen: its letters are 10 pixels high where it is 350 wide.
const NARROW: f64 = 960.0;
/// More schemes than this have no room on a narrow screen.
const MOST_NARROW: usize = 14;

/// The measured orders alone, for a narrow screen; `None` where no order was fitted, or many schemes have one.
pub(super) fn narrow(records: &Records, palette: &Palette) -> Option<Sketch> {
    const NAMES: f64 = 385.0;
    const NOTES: [&str; 5] = [
        "dot: measured order of the orientation; its line: the bounds",
        "grey: claimed order ± 0.15; a column reaches to ± 0.3",
        "hollow: beyond the column",
        "=: exact, the error is rounding at every step",
        "nothing: no order, or the scheme does not take the scene",
    ];
    const NOTE: Type = Type::plain(29.0, SOFT);
    let quantity = quantity(records)?;
    let (scenes, columns) = (ordered_scenes(records), columns(records, palette));
    if columns.len() > MOST_NARROW {
        return None;
    }
    let top = 100.0 + head(&columns);
    let bottom = top + ROW * scenes.len() as f64;
    let height = bottom + 120.0 + 44.0 * NOTES.len() as f64;
    let mut sketch = Sketch::new(NARROW, height, "Measured order of every scheme and scene".into());
    panel::headline(&mut sketch, "Measured orders", "");
    let frame = Frame { left: NAMES + 40.0, top, right: NARROW - 14.0, bottom };
    orders_panel::draw(&mut sketch, records, palette, (&scenes, &columns, quantity), (frame, NAMES));
    for (index, words) in NOTES.into_iter().enumerate() {
        sketch.text(words, (20.0, bottom + 130.0 + 44.0 * index as f64), Anchor::Start, NOTE);
    }
    Some(sketch)
}

/// The quantity that stands for a scene: the first of those in question that has an order.
fn quantity(records: &Records) -> Option<&'static str> {
    let decided = |quantity: &&str| {
        let own = |row: &Order| row.quantity == survey::base(quantity) && row.status == OrderStatus::Decided;
        records.orders.iter().any(own)
    };
    QUANTITIES.into_iter().find(decided)
}

/// Height of the names of schemes, which stand upright over their columns.
fn head(columns: &[(&str, u32)]) -> f64 {
    columns.iter().map(|(scheme, _)| panels::NAME.width(scheme)).fold(0.0, f64::max) + 20.0
}

/// The schemes that claim an order, each with it.
fn columns<'a>(records: &Records, palette: &Palette<'a>) -> Vec<(&'a str, u32)> {
    let column = |scheme: &&'a str| Some((*scheme, survey::claimed_order(records, scheme)?));
    palette.schemes().iter().filter_map(column).collect()
}

/// A row a scheme, with its claim and in how many scenes it was measured.
fn key(records: &Records, palette: &Palette) -> Key {
    let row = |scheme: &&str| {
        let claim =
            survey::claimed_order(records, scheme).map_or(number::NONE.into(), |order| order.to_string());
        Row { look: palette.look(scheme), name: (*scheme).into(), cells: vec![claim] }
    };
    Key { heads: vec!["claimed order".into()], rows: palette.schemes().iter().map(row).collect() }
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
    format!(
        "verdicts on these schemes: {} · {} scenes with an order{apart}",
        survey::tally_words(&shown),
        scenes.len()
    )
}

fn entries(quantity: &str) -> Vec<Entry> {
    let words = survey::quantity_words(quantity);
    vec![
        Entry::new(Sign::Guide, "slope of a whole order"),
        Entry::new(Sign::Band, "claimed order ± 0.15; a column reaches to ± 0.3"),
        Entry::new(
            Sign::Hollow,
            "beyond the column; nothing: no order, or the scheme does not take the scene",
        ),
        Entry::new(Sign::Filled, format!("large: {words}; small: other quantities")),
    ]
}
