//! A case whose every number is made up: perfect but for what a test changes.

use polhode::internals::gates::{self, Baseline, Case, Control};
use polhode::internals::measure::{
    self, EnergyDrift, Evidence, Flips, OtherWorld, Place, PointRun, QuantityLadder, Reading, Reversal, Rung,
    Symplecticity,
};
use polhode::model::{Broken, PerQuantity};
use polhode::record::stability::LinearLimit;
use polhode::record::{Ruling, Verdict};
use polhode::scenes::Scene;
use polhode::schemes::Card;
use polhode::schemes::{Claim, Quantity};
use polhode::simulate::{Break, Outcome};

use crate::common;

/// What a case borrows.
#[derive(Clone)]
pub struct Made {
    pub scene: Scene,
    pub not_for_order: Option<&'static str>,
    pub card: Card,
    pub evidence: Evidence,
    pub drift: Option<EnergyDrift>,
    pub points: Option<PointRun>,
    pub flips: Option<Flips>,
    pub reversal: Option<Reversal>,
    pub symplecticity: Option<Symplecticity>,
    pub other_worlds: Vec<OtherWorld>,
    pub baseline: Baseline,
    pub step_limit: Option<(LinearLimit, LinearLimit)>,
    pub control: Option<Control>,
}

/// Floor of every error.
pub const FLOOR: f64 = 1e-15;

fn readings(value: f64) -> PerQuantity<Reading> {
    PerQuantity::all(Reading { end: value, max: value })
}

/// A run of so many steps, an error everywhere, as far from the run before.
pub fn rung(step: f64, steps: u64, error: f64, moved: f64) -> Rung {
    Rung {
        step,
        steps,
        errors: readings(error),
        floors: readings(FLOOR),
        moved: readings(moved),
        readings: vec![None; measure::ALL.len()],
        outcome: Outcome { steps, ..Outcome::none_yet() },
    }
}

/// Breaks a run.
pub fn broken(mut rung: Rung) -> Rung {
    rung.outcome.broken = Some(Break { step: 1, time: rung.step, why: Broken::NotFinite });
    rung
}

impl Made {
    /// In a built-in scene, a scheme with these claims and six runs at halved steps, without errors.
    pub fn new(scene: &str, claims: &'static [Claim]) -> Made {
        Made {
            scene: common::scene(scene),
            not_for_order: None,
            card: Card { name: "made-up", title: "Made up", family: "test", source: "none", claims },
            evidence: Evidence {
                model: "free",
                rungs: (0..6).map(|k| rung(0.5f64.powi(k), 8 << k, 0.0, 0.0)).collect(),
                ladders: Vec::new(),
                giant_steps: Vec::new(),
                goes_on_in: None,
                by_rule: None,
            },
            drift: None,
            points: None,
            flips: None,
            reversal: None,
            symplecticity: None,
            other_worlds: Vec::new(),
            baseline: Baseline::default(),
            step_limit: None,
            control: None,
        }
    }

    /// A ladder of the quantity, at the end and over the run, of these errors at halved steps and one floor.
    pub fn with_errors(mut self, quantity: Quantity, errors: &[f64], floor: f64) -> Made {
        let rungs: Vec<_> = (0..).zip(errors).map(|(k, e)| (0.5f64.powi(k), *e, floor)).collect();
        let order = self.card.order();
        let ladders = Place::ALL.map(|place| QuantityLadder::of(quantity, place, rungs.clone(), order));
        self.evidence.ladders.extend(ladders);
        self
    }

    /// Every verdict.
    pub fn judge(&self) -> Vec<Verdict> {
        gates::judge(&self.case())
    }

    /// Whether the verdicts ask for a control.
    pub fn asks_for_control(&self) -> bool {
        gates::ask_for_control(&self.judge())
    }

    fn case(&self) -> Case<'_> {
        Case {
            not_for_order: self.not_for_order,
            drift: self.drift.as_ref(),
            points: self.points.as_ref(),
            flips: self.flips.as_ref(),
            reversal: self.reversal.as_ref(),
            symplecticity: self.symplecticity.as_ref(),
            other_worlds: &self.other_worlds,
            step_limit: self.step_limit.as_ref().map(|(stored, measured)| (stored, measured)),
            control: self.control.as_ref(),
            ..Case::of(&self.scene.name, &self.scene.system, &self.card, &self.evidence, &self.baseline)
        }
    }

    /// The one verdict on a quantity of a claim.
    pub fn verdict(&self, claim: &str, quantity: &str) -> Verdict {
        let mut found = self
            .judge()
            .into_iter()
            .filter(|v| v.claim.word() == claim && v.quantity == quantity)
            .collect::<Vec<_>>();
        assert_eq!(found.len(), 1, "{claim} {quantity}: {found:#?}");
        found.remove(0)
    }

    /// Its ruling.
    pub fn ruling(&self, claim: &str, quantity: &str) -> Ruling {
        self.verdict(claim, quantity).verdict
    }

    /// The quantities that a claim has a verdict on.
    pub fn quantities(&self, claim: &str) -> Vec<String> {
        self.judge().into_iter().filter(|v| v.claim.word() == claim).map(|v| v.quantity).collect()
    }
}

/// What stands beside the ruling.
pub fn numbers(verdict: &Verdict) -> [Option<f64>; 3] {
    [verdict.measured, verdict.low, verdict.high]
}
