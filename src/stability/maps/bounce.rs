//! A bounce on an elastic ground: the order between halvings of h, over the height of the drop, which moves the moment of touching
//! within the step.

use super::{Grid, linear, logarithmic};
use crate::model::System;
use crate::record::stability::Map;
use crate::simulate::Contestant;
use crate::stability::kink::{self, drop_from};

/// Stiffness of the ground [N/m].
const STIFFNESS: f64 = 2000.0;
/// Orders of the colour scale.
const HIGHEST: f64 = 5.0;

pub(super) fn map(contestant: &Contestant, cells: usize) -> Option<Map> {
    contestant.refusal(&drop_from(0.4, STIFFNESS, 0.0)?).is_none().then_some(())?;
    let x = linear("height of the drop", "m", 0.40, 0.41);
    let y = logarithmic("step h", "s", 2e-3, 8e-3);
    let mut map = Grid { x, y, cells }.fill(|step, heights| {
        let steps = (kink::DURATION / step).ceil() as u64;
        let systems: Vec<System> =
            heights.iter().filter_map(|height| drop_from(*height, STIFFNESS, 0.0)).collect();
        let (orders, taken) = kink::orders(contestant, &systems, &vec![steps; systems.len()]);
        (orders.into_iter().map(|order| order.map(|order| order.clamp(0.0, HIGHEST))).collect(), taken)
    });
    map.title = "Bounce: the order across a kink".to_owned();
    map.what = format!("order between halvings of h of the place after a bounce, {STIFFNESS} N/m, no damper");
    map.edge = Some(f64::from(contestant.card.order()));
    Some(map)
}
