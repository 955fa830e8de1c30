//! A bounce on an elastic ground: the order between halvings of h, over the moment of touching within the step.
//!
//! The body falls without spin, so that its lowest points touch at the time √(2 d/g) of their depth d of fall: height and step are
//! chosen so that this is any part of a step after a whole number of them.

use nalgebra::Vector3;

use super::{Grid, linear, logarithmic};
use crate::model::System;
use crate::record::stability::Map;
use crate::simulate::Contestant;
use crate::stability::kink::{self, clearance, drop_from};

/// Stiffness of the ground [N/m].
const STIFFNESS: f64 = 2000.0;
/// Time of the fall, about [s].
const FALL: f64 = 0.28;
/// Orders of the colour scale.
const HIGHEST: f64 = 5.0;

pub(super) fn map(contestant: &Contestant, cells: usize) -> Option<Map> {
    let clearance = clearance()?;
    let drop = |fall: f64| drop_from(clearance + 0.5 * 9.81 * fall * fall, Vector3::zeros(), STIFFNESS, 0.0);
    contestant.refusal(&drop(FALL)?).is_none().then_some(())?;
    let x = linear("moment of touching, in steps", "1", 0.0, 1.0);
    let y = logarithmic("step h", "s", 5e-4, 8e-3);
    let mut map = Grid { x, y, cells }.fill(|step, parts| {
        let whole = (FALL / step).round();
        let systems: Vec<System> = parts.iter().filter_map(|part| drop((whole + part) * step)).collect();
        let steps = (kink::DURATION / step).round() as u64;
        let (orders, taken) = kink::orders(contestant, &systems, step, steps);
        (orders.into_iter().map(|order| order.map(|order| order.clamp(0.0, HIGHEST))).collect(), taken)
    });
    map.title = "Bounce: the order across a kink".to_owned();
    map.what = format!("order between halvings of h of the place after a bounce, {STIFFNESS} N/m, no damper");
    map.edge = Some(f64::from(contestant.card.order()));
    Some(map)
}
