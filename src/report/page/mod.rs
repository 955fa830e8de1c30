//! What the HTML and the Markdown report say: every number already in print, with its unit and uncertainty.

mod costs;
mod findings;
mod precision;
mod rankings;
mod reasons;
mod scene;
mod stability;
mod tables;

use serde::Serialize;

use crate::record::{ClaimName, Machine, Records, Verdict};

use super::engines;
use super::number;
use super::plot::{Group, Subject};
use super::published;
use super::ranking::Work;
use super::survey::{self, Outcome};

/// A picture that was drawn.
pub(super) struct Figure {
    /// What it shows.
    pub subject: Subject,
    /// The PNG in base 64, where it stands in the page itself.
    pub data: Option<String>,
}

/// The whole report.
#[derive(Serialize)]
pub(super) struct Page {
    version: String,
    made_at: String,
    machine: String,
    complete: bool,
    verdict_count: usize,
    tally: Vec<Count>,
    findings: Vec<String>,
    reasons: Vec<reasons::Reason>,
    broken_runs: Vec<tables::BrokenRun>,
    schemes: Vec<tables::Scheme>,
    overview: Option<FigureView>,
    order_schemes: Vec<String>,
    orders: Vec<tables::SceneOrders>,
    drift_figure: Option<FigureView>,
    drifts: Vec<tables::DriftRow>,
    overall: Vec<rankings::Overall>,
    engines: Option<engines::Section>,
    published: Option<published::Section>,
    cheapest: Vec<FigureView>,
    costs: Option<costs::Costs>,
    scaling: Option<FigureView>,
    precision: Option<precision::Precision>,
    stability: Option<stability::Section>,
    scenes: Vec<scene::Scene>,
}

/// How many verdicts have an outcome.
#[derive(Serialize)]
struct Count {
    class: &'static str,
    words: &'static str,
    count: usize,
}

/// A picture as the templates see it.
#[derive(Serialize)]
pub(super) struct FigureView {
    file: String,
    caption: String,
    /// What a link to it says.
    word: &'static str,
    /// Whether it shows errors of runs.
    errors: bool,
    /// The same for a narrow screen.
    narrow: Option<Box<FigureView>>,
    /// The PNG in base 64, where it is no file.
    data: Option<String>,
}

/// A verdict in print.
#[derive(Serialize)]
struct VerdictRow {
    class: &'static str,
    outcome: &'static str,
    scene: String,
    anchor: String,
    scheme: String,
    claim: &'static str,
    quantity: String,
    measured: String,
    detail: String,
    known: Option<String>,
}

impl VerdictRow {
    fn new(verdict: &Verdict) -> VerdictRow {
        let outcome = Outcome::of(verdict);
        VerdictRow {
            class: outcome.class(),
            outcome: outcome.words(),
            scene: verdict.scene.clone(),
            anchor: survey::file_stem(&verdict.scene),
            scheme: verdict.scheme.clone(),
            claim: verdict.claim.word(),
            quantity: verdict.quantity.clone(),
            measured: measured(verdict),
            detail: verdict.detail.clone(),
            known: verdict.known_deviation.clone(),
        }
    }
}

/// What was measured, with its interval; the detail of the verdict says the unit.
fn measured(verdict: &Verdict) -> String {
    let Some(value) = verdict.measured else { return number::NONE.into() };
    match (verdict.low, verdict.high) {
        (Some(low), Some(high)) if verdict.claim == ClaimName::Order => {
            number::order(Some(value), Some(low), Some(high))
        }
        (Some(low), Some(high)) if low < high => {
            let [value, low, high] = [value, low, high].map(|number| number::significant(number, 4));
            format!("{value} [{low}, {high}]")
        }
        _ => number::significant(value, 4),
    }
}

/// Composes the report from the records and the pictures drawn from them. `main` is the records without the schemes that stand
/// apart.
pub(super) fn compose(records: &Records, main: &Records, figures: &[Figure]) -> Page {
    let (order_schemes, orders) = tables::scene_orders(main);
    Page {
        version: records.polhode.clone(),
        made_at: records.made_at.clone(),
        machine: machine_words(&records.machine),
        complete: records.complete,
        verdict_count: records.verdicts.len(),
        tally: tally(records),
        findings: findings::findings(records, main),
        reasons: reasons::reasons(&records.verdicts),
        broken_runs: tables::broken_runs(records),
        schemes: records.schemes.iter().map(|row| tables::Scheme::new(records, row)).collect(),
        overview: figure(
            figures,
            &Subject::Overview,
            "Errors and measured orders of every scene and scheme.",
        ),
        order_schemes,
        orders,
        drift_figure: figure(
            figures,
            &Subject::DriftRates,
            "Drift rate of the rotational energy against the step.",
        ),
        drifts: main.drifts.iter().map(tables::DriftRow::new).collect(),
        overall: rankings::overall(records),
        engines: engines::Section::new(records, figures),
        published: published::Section::new(&records.published),
        cheapest: cheapest(figures),
        costs: costs::Costs::new(records),
        scaling: figure(figures, &Subject::Scaling, "Cost of a step against the mass points of the body."),
        precision: precision::Precision::new(main, figures),
        stability: stability::Section::new(records, figures),
        scenes: survey::scenes(records)
            .into_iter()
            .map(|name| scene::Scene::new(main, figures, name, rankings::Ranking::new(records, name)))
            .collect(),
    }
}

/// How many verdicts have each outcome.
fn tally(records: &Records) -> Vec<Count> {
    let counts = survey::tally(records.verdicts.iter()).into_iter();
    counts.map(|(outcome, count)| Count { class: outcome.class(), words: outcome.words(), count }).collect()
}

/// The verdicts that a reader must see, the worst first.
fn attention<'a>(verdicts: impl Iterator<Item = &'a Verdict>) -> Vec<VerdictRow> {
    let mut rows: Vec<&Verdict> = verdicts.filter(|verdict| Outcome::of(verdict).needs_attention()).collect();
    rows.sort_by_key(|verdict| Outcome::of(verdict));
    rows.into_iter().map(VerdictRow::new).collect()
}

/// What an error costs, by time and by count.
fn cheapest(figures: &[Figure]) -> Vec<FigureView> {
    let caption = "The cheapest scheme of each family for an error below each power of ten.";
    let works = [Work::Nanoseconds, Work::Evaluations].into_iter();
    works.filter_map(|work| figure(figures, &Subject::Cheapest(work), caption)).collect()
}

pub(super) fn figure(figures: &[Figure], subject: &Subject, caption: &str) -> Option<FigureView> {
    let drawn = figures.iter().find(|figure| figure.subject == *subject)?;
    let errors = matches!(subject, Subject::Convergence(_) | Subject::WorkPrecision(..));
    let (file, data) = (subject.file_name(), drawn.data.clone());
    let narrow = match subject {
        Subject::Overview => figure(figures, &Subject::NarrowOverview, caption).map(Box::new),
        _ => None,
    };
    Some(FigureView { file, caption: caption.into(), word: word(subject), errors, narrow, data })
}

fn word(subject: &Subject) -> &'static str {
    match subject {
        Subject::Convergence(_) => "errors",
        Subject::Invariants(_) => "against time",
        Subject::WorkPrecision(_, _, Group::Rotation) => "cost of the rotation",
        Subject::WorkPrecision(..) => "cost of the position",
        _ => "picture",
    }
}

pub(super) fn machine_words(machine: &Machine) -> String {
    let threads =
        if machine.threads > 0 { number::counted(machine.threads, "thread") } else { String::new() };
    let parts = [&machine.os, &machine.architecture, &machine.processor, &threads];
    let known: Vec<&str> = parts.into_iter().map(String::as_str).filter(|part| !part.is_empty()).collect();
    if known.is_empty() { "an unknown machine".into() } else { known.join(", ") }
}
