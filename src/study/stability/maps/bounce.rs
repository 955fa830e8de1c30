//! A bounce on an elastic ground: the order between halvings of h, over the moments of touching and of leaving within a step.
//!
//! The body falls without spin, so that its lowest points touch at the time √(2 d/g) of their depth d of fall: the height is chosen
//! so that this is any part of a step after a whole number of them. The stiffness of the ground decides how long it is touched, and
//! so the moment of leaving.

use nalgebra::Vector3;

use super::{Grid, linear};
use crate::model::System;
use crate::record::stability::Map;
use crate::simulate::Contestant;
use crate::study::stability::kink::{self, clearance, drop_from};

/// h of the coarsest of three runs [s].
const STEP: f64 = 2e-3;
/// Steps of the fall, of that length, …
const FALL: f64 = 140.0;
/// … and of the run.
const STEPS: u64 = 200;
/// Stiffness of the ground [N/m].
const STIFFNESS: (f64, f64) = (2000.0, 2400.0);
/// Orders of the colour scale.
const HIGHEST: f64 = 5.0;

pub(super) fn map(contestant: &Contestant, cells: usize) -> Option<Map> {
    let clearance = clearance()?;
    let drop = |part: f64, stiffness: f64| {
        let fall = (FALL + part) * STEP;
        drop_from(clearance + 0.5 * 9.81 * fall * fall, Vector3::zeros(), stiffness, 0.0)
    };
    contestant.refusal(&drop(0.0, STIFFNESS.0)?).is_none().then_some(())?;
    let x = linear("moment of touching, in steps", "1", 0.0, 1.0);
    let y = linear("stiffness of the ground", "N/m", STIFFNESS.0, STIFFNESS.1);
    let mut map = Grid { x, y, cells }.fill(|stiffness, parts| {
        let systems: Vec<System> = parts.iter().filter_map(|part| drop(*part, stiffness)).collect();
        let (orders, taken) = kink::orders(contestant, &systems, STEP, STEPS);
        (orders.into_iter().map(|order| order.map(|order| order.clamp(0.0, HIGHEST))).collect(), taken)
    });
    map.title = "Bounce: the order across a kink".to_owned();
    map.what = format!("order between halvings of h = {STEP} s of the place after a bounce, no damper");
    map.edge = Some(f64::from(contestant.card.order()));
    Some(map)
}
