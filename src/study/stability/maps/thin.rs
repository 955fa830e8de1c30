//! Thin bodies, to moments of 1 : 1 : 1e-6.

use nalgebra::Vector3;

use super::free::{run, spinning};
use super::grid::curve;
use super::{Grid, logarithmic};
use crate::record::stability::Map;
use crate::simulate::Contestant;
use crate::study::stability::{ENERGY_KEPT, theory};

/// Steps of a cell.
const STEPS: u64 = 400;
/// Change of the energy below which it is rounding.
const ROUNDING: f64 = 1e-16;

pub(super) fn map(contestant: &Contestant, cells: usize) -> Option<Map> {
    let system = |thin: f64| spinning(Vector3::new(1.0, 1.0, thin), Vector3::new(1.0, 0.0, 1.0));
    contestant.refusal(&system(0.5)?).is_none().then_some(())?;
    let x = logarithmic("step |Ω|h", "rad", 0.01, std::f64::consts::TAU);
    let y = logarithmic("smallest moment / largest", "1", 1e-6, 1.0);
    let mut map = Grid { x, y, cells }.fill(|thin, turns| {
        let members = turns.iter().filter_map(|turn| Some((system(thin)?, *turn))).collect();
        let ends = run(contestant, members, STEPS);
        let taken = ends.iter().map(|end| end.1.steps).sum();
        let value = |change: f64| change.max(ROUNDING).log10();
        (ends.iter().map(|(kept, _)| Some(value(kept.largest_change))).collect(), taken)
    });
    map.title = "Thin body: energy lost or won".to_owned();
    map.what = format!("log₁₀ of the largest change of energy in {STEPS} steps; spin at 45° to the axis");
    map.edge = Some(ENERGY_KEPT.log10());
    if contestant.card.name == "peskin-rk2" {
        // N h dE/dt = N h⁴ r, with r the law at h = 1, reaches 1 % of E there.
        let law = |thin: f64| {
            let system = system(thin)?;
            let spin = Vector3::new(1.0, 0.0, 1.0).normalize();
            let energy = 0.5 * spin.dot(&(system.body.inertia * spin));
            Some((ENERGY_KEPT * energy / (STEPS as f64 * theory::energy_rate(&system, 1.0)?)).powf(0.25))
        };
        map.curves.push(curve("1 % by the h³ law", &map, law));
        // A step errs by (|Ω|h)³ in where L points in the body, which is (|Ω|h)³ I₃/I₁ of the small part of L along the thin axis.
        // The power is that; the factor ¼ is read off the map.
        map.curves
            .push(curve("(|Ω|h)³ = I₁/4I₃, the 4 fitted", &map, |thin| Some((thin / 4.0).cbrt())));
    }
    Some(map)
}
