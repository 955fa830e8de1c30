//! Step × stiffness and step × damping of the spring-held body at rest.

use super::grid::{curve, edge_off, measured_edge};
use super::{Grid, linear, logarithmic};
use crate::record::stability::Map;
use crate::scenes::Scene;
use crate::simulate::Contestant;
use crate::study::stability::theory;
use crate::study::stability::{Bench, Growth, NO_GROWTH};

/// Steps of a cell.
const STEPS: u64 = 600;
/// Growth a step beyond which a cell is as good as broken, and decay beyond which it is as good as dead.
const RANGE: f64 = 0.5;
/// Damping of the map over the stiffness [N s/m].
const DAMPING: f64 = 8.0;
/// Stiffness of the map over the damping [N/m].
const STIFFNESS: f64 = 1024.0;

const WHAT: &str = "logarithmic growth a step of a small displacement";

fn bench(stiffness: f64, damping: f64) -> Option<Bench> {
    Bench::of(&Scene::find(crate::study::stability::LINEAR_SCENES[0]).ok()?.system)?
        .changed(stiffness, damping)
}

/// Growth of every bench at its step [s].
fn row(contestant: &Contestant, members: &[(Bench, f64)]) -> (Vec<Option<f64>>, u64) {
    let growths = Bench::growths(contestant, members, STEPS);
    let values = growths.into_iter().map(|growth| match growth {
        Growth::Rate(rate) => Some(rate.clamp(-RANGE, RANGE)),
        Growth::Broke(_) => Some(RANGE),
    });
    (values.collect(), STEPS * members.len() as u64)
}

/// The limit a(ζ) of a scheme without growth.
fn limit(contestant: &Contestant, zeta: f64) -> Option<f64> {
    Some(theory::limit_of_a_body(zeta, contestant, 1e-9)?.0)
}

pub(super) fn stiffness(contestant: &Contestant, cells: usize) -> Option<Map> {
    contestant.refusal(&bench(STIFFNESS, DAMPING)?.system).is_none().then_some(())?;
    let x = logarithmic("step h", "s", 2e-3, 0.5);
    let y = logarithmic("stiffness k", "N/m", 1e1, 1e5);
    let mut map = Grid { x, y, cells }.fill(|k, steps| {
        let members: Vec<_> = steps.iter().filter_map(|h| Some((bench(k, DAMPING)?, *h))).collect();
        row(contestant, &members)
    });
    let theory = |k: f64| {
        let bench = bench(k, DAMPING)?;
        limit(contestant, bench.zeta).map(|a| a / bench.omega)
    };
    add_edge(&mut map, "Spring-held body: step and stiffness");
    add_theory(&mut map, theory);
    map.what = format!("{WHAT}, c = {DAMPING} N s/m");
    Some(map)
}

pub(super) fn damping(contestant: &Contestant, cells: usize) -> Option<Map> {
    let mut map = measured_damping(contestant, cells)?;
    add_theory(&mut map, |zeta| limit(contestant, zeta));
    Some(map)
}

/// The map of step and damping without its theory, which takes far longer than its cells.
pub(super) fn measured_damping(contestant: &Contestant, cells: usize) -> Option<Map> {
    let one = bench(STIFFNESS, DAMPING)?;
    contestant.refusal(&one.system).is_none().then_some(())?;
    let x = linear("step h·ω", "1", 0.0, 3.0);
    let y = linear("damping ζ", "1", 0.0, 1.6);
    let per_zeta = DAMPING / one.zeta;
    let mut map = Grid { x, y, cells }.fill(|zeta, steps| {
        let members: Vec<_> = steps
            .iter()
            .filter_map(|a| {
                let bench = bench(STIFFNESS, zeta * per_zeta)?;
                let step = a / bench.omega;
                Some((bench, step))
            })
            .collect();
        row(contestant, &members)
    });
    add_edge(&mut map, "Spring-held body: step and damping");
    map.what = format!("{WHAT}, k = {STIFFNESS} N/m");
    Some(map)
}

fn add_edge(map: &mut Map, title: &str) {
    map.title = title.to_owned();
    map.edge = Some(0.0);
    let measured = measured_edge(map, NO_GROWTH);
    map.curves.push(measured);
}

fn add_theory(map: &mut Map, theory: impl Fn(f64) -> Option<f64>) {
    let drawn = curve("linear theory", map, &theory);
    if !drawn.x.is_empty() {
        map.edge_off_theory = edge_off(map, NO_GROWTH, &theory);
        map.curves.insert(0, drawn);
    }
}
