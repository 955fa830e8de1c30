//! The curves of a study of stability: limits beside theory, energy over many steps, and the law of the energy.

use crate::record::SchemeRow;
use crate::record::stability::{LimitStatus, LinearLimit, LongRun, Meaning, Stability};
use crate::report::survey;

use super::axis::Axis;
use super::legend::{self, Entry, Sign};
use super::palette::{GRID, GUIDE, INK, Look, Marker, Palette, SOFT};
use super::panel::{self, Frame, Panel};
use super::render::{self, Fault};
use super::sketch::{Anchor, Place, Sketch, Type};

const MARGIN: f64 = 30.0;
const TOP: f64 = 170.0;
/// Names of schemes and of panels.
const NAME: Type = Type::plain(26.0, INK);
/// Height of a scheme's line.
const LINE: f64 = 34.0;
/// Change of the energy that is drawn as none.
const LEAST_CHANGE: f64 = 1e-17;

/// File name and PNG of every picture that the study holds something for.
///
/// # Errors
/// The bundled typeface cannot be read, or the backend fails.
pub(in crate::report) fn pictures(study: &Stability) -> Result<Vec<(&'static str, Vec<u8>)>, Fault> {
    super::font::register().map_err(|why| Fault(why.into()))?;
    let all = [
        ("limits.png", limits(study)),
        ("long-runs.png", long_runs(&study.long_runs)),
        ("energy-law.png", energy_law(study)),
    ];
    all.into_iter()
        .filter_map(|(name, sketch)| Some((name, sketch?)))
        .map(|(name, sketch)| Ok((name, render::png(&sketch)?)))
        .collect()
}

/// h·ω of every scheme on the spring-held body, measured and by theory, beside the radians a step that a free body and a top bear.
fn limits(study: &Stability) -> Option<Sketch> {
    let schemes = survey::distinct(study.linear.iter().map(|row| row.scheme.as_str()));
    if schemes.is_empty() {
        return None;
    }
    let height = TOP + LINE * schemes.len() as f64 + 260.0;
    let mut sketch = Sketch::new(2600.0, height, "Largest usable steps of every scheme".into());
    let subtitle = "left: linear stability of the spring-held body, h·ω; right: radians a step within 0.1 rad, within 1 % of energy, and bounded";
    panel::headline(&mut sketch, "Largest usable steps", subtitle);
    let bottom = height - 190.0;
    let names = 530.0;
    let scenes = survey::distinct(study.limits.iter().map(|row| row.scene.as_str()));
    let shown: Vec<&str> = SHOWN.into_iter().filter(|scene| scenes.contains(scene)).collect();
    let width = (2600.0 - names - MARGIN) / (shown.len() + 1) as f64;
    let frame = |index: usize| {
        let left = names + width * index as f64;
        Frame { left, top: TOP + 30.0, right: left + width - 50.0, bottom }
    };
    let row = |index: usize| TOP + 30.0 + LINE * (index as f64 + 0.8);
    for (index, scheme) in schemes.iter().enumerate() {
        sketch.text(scheme, (names - 20.0, row(index)), Anchor::End, NAME);
    }
    draw_linear(&mut sketch, &study.linear, &schemes, frame(0), &row);
    for (index, scene) in shown.iter().enumerate() {
        draw_scene(&mut sketch, study, scene, &schemes, frame(index + 1), &row);
    }
    let look = |marker, ink| Sign::Scheme(Look { ink, text: ink, marker, dash: &[] });
    let entries = [
        Entry::new(Sign::Filled, "spring-held body: measured"),
        Entry::new(Sign::Cross, "theory"),
        Entry::new(look(MEANINGS[2].1, ink(2)), "within 0.1 rad"),
        Entry::new(look(MEANINGS[1].1, ink(1)), "energy within 1 %"),
        Entry::new(look(MEANINGS[0].1, ink(0)), "bounded; hollow: at every step tried"),
    ];
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, height - 80.0, 2500.0);
    Some(sketch)
}

/// Scenes of the picture of limits, where the study holds them.
const SHOWN: [&str; 3] = ["free-asymmetric", "dzhanibekov", "heavy-asymmetric-top"];
/// The meanings of usable and their markers.
const MEANINGS: [(Meaning, Marker); 3] = [
    (Meaning::Bounded, Marker::Square),
    (Meaning::Energy, Marker::Triangle),
    (Meaning::Orientation, Marker::Disc),
];

fn ink(meaning: usize) -> plotters::style::RGBColor {
    super::palette::COLOURS[meaning]
}

fn draw_linear(
    sketch: &mut Sketch,
    rows: &[LinearLimit],
    schemes: &[&str],
    frame: Frame,
    row: &dyn Fn(usize) -> f64,
) {
    let panel = Panel { frame, x: Axis::logarithmic(-1.3, 1.9, 4), y: Axis::linear(0.0, 1.0, 2) };
    ground(sketch, &panel, schemes.len(), row);
    for (index, scheme) in schemes.iter().enumerate() {
        let Some(limit) = rows.iter().find(|row| row.scheme == *scheme) else { continue };
        if let Some(theory) = limit.theory_h_omega {
            sketch.cross((panel.across(theory.log10()), row(index)), 9.0, GUIDE);
        }
        match limit.h_omega {
            Some(measured) => {
                sketch.marker(Marker::Disc, (panel.across(measured.log10()), row(index)), 8.0, INK, true);
            }
            None => {
                let note = if limit.failure.starts_with("stable") { "stable" } else { "unstable" };
                sketch.text(note, (frame.left + 10.0, row(index)), Anchor::Start, Type::plain(22.0, SOFT));
            }
        }
    }
    finish(sketch, &panel, "spring-held body", "h·ω");
}

fn draw_scene(
    sketch: &mut Sketch,
    study: &Stability,
    scene: &str,
    schemes: &[&str],
    frame: Frame,
    row: &dyn Fn(usize) -> f64,
) {
    let panel = Panel { frame, x: Axis::logarithmic(-3.2, 1.1, 4), y: Axis::linear(0.0, 1.0, 2) };
    ground(sketch, &panel, schemes.len(), row);
    for (index, scheme) in schemes.iter().enumerate() {
        for (meaning, (word, marker)) in MEANINGS.iter().enumerate() {
            let mine = study
                .limits
                .iter()
                .find(|one| one.scene == scene && one.scheme == *scheme && one.meaning == *word);
            let Some((limit, radians)) = mine.and_then(|limit| Some((limit, limit.radians_per_step?))) else {
                continue;
            };
            let place = (panel.across(radians.log10()), row(index));
            sketch.marker(*marker, place, 9.0, ink(meaning), limit.status == LimitStatus::Limit);
        }
    }
    finish(sketch, &panel, scene, "radians a step");
}

fn ground(sketch: &mut Sketch, panel: &Panel, rows: usize, row: &dyn Fn(usize) -> f64) {
    for index in 0..rows {
        let y = row(index);
        sketch.line(vec![(panel.frame.left, y), (panel.frame.right, y)], GRID, 1.0);
    }
    for (value, _) in &panel.x.labels {
        let x = panel.across(*value);
        sketch.line(vec![(x, panel.frame.top), (x, panel.frame.bottom)], GRID, 2.0);
    }
}

fn finish(sketch: &mut Sketch, panel: &Panel, title: &str, axis: &str) {
    let Frame { left, top, right, bottom } = panel.frame;
    sketch.outline((left, top), (right, bottom), SOFT, 2.0);
    panel.label_x(sketch, axis);
    panel.title(sketch, title);
}

/// Energy against the number of steps, a panel a scene.
fn long_runs(runs: &[LongRun]) -> Option<Sketch> {
    let scenes = survey::distinct(runs.iter().map(|run| run.scene.as_str()));
    if scenes.is_empty() {
        return None;
    }
    let card = |run: &LongRun| SchemeRow { name: run.scheme.clone(), look: run.look, ..SchemeRow::default() };
    let cards: Vec<SchemeRow> = runs.iter().map(card).collect();
    let palette = Palette::of_schemes(survey::distinct(runs.iter().map(|run| run.scheme.as_str())), &cards);
    let mut entries: Vec<Entry> = palette
        .schemes()
        .iter()
        .map(|scheme| Entry::new(Sign::Scheme(palette.look(scheme)), *scheme))
        .collect();
    entries.push(Entry::new(Sign::Guide, "roundings: u √n and u n"));
    let width = 2600.0;
    let strip = legend::height(&entries, width - 2.0 * MARGIN - 20.0);
    let height = TOP + 1000.0 + strip + 60.0;
    let mut sketch = Sketch::new(width, height, "Energy of a free body over many steps".into());
    let turn = runs[0].radians_per_step;
    let subtitle =
        format!("|relative change of the rotational energy| against the number of steps, {turn} rad a step");
    panel::headline(&mut sketch, "Energy over many steps", &subtitle);
    let all = Frame { left: MARGIN, top: TOP, right: width - MARGIN, bottom: TOP + 1000.0 };
    for (index, scene) in scenes.iter().enumerate() {
        let frame = all.cell((scenes.len(), 1), index).inside(110.0, 50.0, 20.0, 110.0);
        draw_long(&mut sketch, runs, scene, &palette, frame);
    }
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, height - strip - MARGIN, width - 2.0 * MARGIN - 20.0);
    Some(sketch)
}

fn draw_long(sketch: &mut Sketch, runs: &[LongRun], scene: &str, palette: &Palette, frame: Frame) {
    let most = runs.iter().map(|run| run.steps.max(10)).max().unwrap_or(10) as f64;
    let panel =
        Panel { frame, x: Axis::logarithmic(0.0, most.log10(), 9), y: Axis::logarithmic(-17.0, 1.0, 10) };
    panel.draw_grid(sketch);
    let rounding = f64::EPSILON.log10() - 2f64.log10();
    for power in [0.5, 1.0] {
        let end = (most.log10(), rounding + power * most.log10());
        sketch.dashes(panel.place(0.0, rounding), panel.place(end.0, end.1), GUIDE, 3.0);
    }
    for run in runs.iter().filter(|run| run.scene == scene) {
        let look = palette.look(&run.scheme);
        let places: Vec<Place> = run
            .at_step
            .iter()
            .zip(&run.energy_change)
            .map(|(n, change)| {
                panel.place((*n as f64).log10(), change.abs().clamp(LEAST_CHANGE, 10.0).log10())
            })
            .collect();
        sketch.stroke(places.clone(), look.ink, 3.0, look.dash);
        for place in places.iter().step_by(8) {
            sketch.marker(look.marker, *place, 8.0, look.ink, true);
        }
    }
    panel.draw_frame(sketch);
    panel.label_y(sketch);
    panel.label_x(sketch, "steps n");
    panel.title(sketch, scene);
}

/// Measured drift rates as points over the line of the law.
fn energy_law(study: &Stability) -> Option<Sketch> {
    let rates: Vec<_> =
        study.energy_law.iter().filter(|rate| rate.measured_w > 0.0 && rate.law_w > 0.0).collect();
    let (first, last) = (rates.first()?, rates.last()?);
    let mut sketch = Sketch::new(1500.0, 1150.0, "Measured drift rate of the energy and the law".into());
    let subtitle = format!("{} in {}: dE/dt = h³ β⁴ l⁶ sin²θ cos⁴θ / (8A)", first.scheme, first.scene);
    panel::headline(&mut sketch, "Peskin's law of the energy", &subtitle);
    let frame = Frame { left: 170.0, top: TOP + 60.0, right: 1460.0, bottom: 940.0 };
    let logs = |value: f64| value.log10();
    let panel = Panel {
        frame,
        x: Axis::logarithmic(logs(last.step_s) - 0.1, logs(first.step_s) + 0.1, 6),
        y: Axis::logarithmic(logs(last.law_w) - 0.3, logs(first.law_w) + 0.3, 8),
    };
    panel.draw_grid(&mut sketch);
    let look = Palette::new(vec![first.scheme.as_str()]).look(&first.scheme);
    let law: Vec<Place> = rates.iter().map(|rate| panel.place(logs(rate.step_s), logs(rate.law_w))).collect();
    sketch.dashed(&law, GUIDE, 4.0);
    for rate in &rates {
        sketch.marker(
            look.marker,
            panel.place(logs(rate.step_s), logs(rate.measured_w)),
            11.0,
            look.ink,
            true,
        );
    }
    panel.draw_frame(&mut sketch);
    panel.label_y(&mut sketch);
    panel.label_x(&mut sketch, "step h [s]");
    panel.title(&mut sketch, "dE/dt [W]");
    let entries = [Entry::new(Sign::Scheme(look), "measured"), Entry::new(Sign::Guide, "the law")];
    legend::draw(&mut sketch, &entries, 170.0, 1060.0, 1200.0);
    Some(sketch)
}
