//! A case whose every number is made up: perfect but for what a test changes.

use std::sync::Arc;

use polhode::gates::{self, Baseline};
use polhode::internals::campaign::setting;
use polhode::model::{PerQuantity, Quantity};
use polhode::record::{
    ClaimName, Evidence, Ladder, Order, Records, Ruling, Rung, SceneRow, Setting, Verdict,
};
use polhode::schemes::Claim;

use crate::common;

/// Runs of a ladder.
pub const RUNS: usize = 8;
/// Sample times [s].
pub const TIMES: [f64; 4] = [2.0, 4.0, 6.0, 8.0];
/// Distance of a copy from its run, in every quantity.
pub const ROUNDING: f64 = 1e-12;
/// An error is at its rounding up to thirty times that of the copies. The steps of a run, 1024 at most, round by less: 1024 u = 2.3e-13.
pub const FLOOR: f64 = 30.0 * ROUNDING;

/// A scheme in a scene, and what is on record of it.
#[derive(Clone)]
pub struct Made {
    pub evidence: Evidence,
    pub baseline: Baseline,
}

/// Components of a quantity at one time.
fn components(quantity: Quantity) -> usize {
    match quantity {
        Quantity::Orientation => 9,
        Quantity::BodyPoint => 0,
        _ => 3,
    }
}

/// h of a run [s].
pub fn step(run: usize) -> f64 {
    0.5f64.powi(run as i32)
}

/// A run of so many steps over eight seconds, without errors at so many times.
pub fn rung(steps: u64, times: usize) -> Rung {
    Rung {
        step: TIMES[3] / steps as f64,
        steps,
        errors: PerQuantity::of(|quantity| vec![0.0; components(quantity) * times]),
        rounding: PerQuantity::of(|_| vec![ROUNDING; times]),
        ..Rung::default()
    }
}

/// The errors h to a power of the runs, of size one at the first.
pub fn power(order: f64) -> [f64; RUNS] {
    std::array::from_fn(|run| step(run).powf(order))
}

impl Made {
    /// In a built-in scene, a scheme with these claims and runs of 8 to 1024 steps, without errors.
    pub fn new(scene: &str, claims: &[Claim]) -> Made {
        let evidence = Evidence {
            scene: scene.to_owned(),
            scheme: "made-up".to_owned(),
            known_as: "made-up".to_owned(),
            model: "free".to_owned(),
            // No made-up scene is generic.
            setting: Setting { generic: false, not_for_order: None, ..setting(&common::scene(scene)) },
            claims: claims.to_vec(),
            ladder: Ladder {
                times: TIMES.to_vec(),
                sizes: PerQuantity::all(1.0),
                arithmetic: f64::EPSILON,
                arms: vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                rungs: (0..RUNS).map(|run| rung(8 << run, TIMES.len())).collect(),
                ..Ladder::default()
            },
            ..Evidence::default()
        };
        Made { evidence, baseline: Baseline::default() }
    }

    /// An error of the first component of a quantity, by step and time.
    pub fn with(mut self, quantity: Quantity, error: impl Fn(f64, f64) -> f64) -> Made {
        for rung in &mut self.evidence.ladder.rungs {
            for (vector, time) in rung.errors[quantity].chunks_mut(components(quantity)).zip(TIMES) {
                vector[0] = error(rung.step, time);
            }
        }
        self
    }

    /// The same of the runs in their order, alike at all times, with the distance of the copies of every run.
    pub fn with_errors(mut self, quantity: Quantity, errors: &[f64], rounding: f64) -> Made {
        self.evidence.ladder.rungs.truncate(errors.len());
        for rung in &mut self.evidence.ladder.rungs {
            rung.rounding[quantity].fill(rounding);
        }
        self.with(quantity, |h, _| errors[(1.0 / h).log2().round() as usize])
    }

    /// An error h to a power in every quantity, without rounding.
    pub fn of_order(scene: &str, claims: &[Claim], order: f64) -> Made {
        let set = |quantity: &Quantity| components(*quantity) > 0;
        let all = Quantity::ALL.into_iter().filter(set);
        all.fold(Made::new(scene, claims), |made, quantity| {
            made.with_errors(quantity, &power(order), ROUNDING)
        })
    }

    /// Breaks a run.
    pub fn broken(mut self, run: usize) -> Made {
        let Rung { step, steps, .. } = self.evidence.ladder.rungs[run];
        let why = Some("not finite".to_owned());
        self.evidence.ladder.rungs[run] = Rung { step, steps, broken: why, ..Rung::default() };
        self
    }

    /// Puts constants on record, or errors by h, of a quantity of a scheme in a scene of this content.
    pub fn recorded(mut self, row: Recorded) -> Made {
        let scene = SceneRow { name: "there".to_owned(), content: row.content, ..SceneRow::default() };
        let order = Order {
            scene: "there".to_owned(),
            scheme: row.scheme.clone(),
            quantity: row.quantity.name().to_owned(),
            constant: row.constant,
            ..Order::default()
        };
        let run = |(step, error): (f64, f64)| {
            let mut rung = Rung { step, ..rung(1, TIMES.len()) };
            rung.rounding = PerQuantity::of(|_| vec![0.0; TIMES.len()]);
            rung.errors[row.quantity].iter_mut().step_by(components(row.quantity)).for_each(|x| *x = error);
            rung
        };
        let mut evidence =
            Evidence { scheme: row.scheme.clone(), known_as: row.scheme.clone(), ..self.evidence.clone() };
        evidence.setting.content.clone_from(&scene.content);
        evidence.ladder.rungs = row.errors.into_iter().map(run).collect();
        let records = Records {
            scenes: vec![scene],
            orders: vec![order],
            evidence: vec![Arc::new(evidence)],
            ..Records::default()
        };
        self.baseline = Baseline::from_records(&records);
        self
    }

    /// Puts it on record as it is.
    pub fn put_on_record(mut self) -> Made {
        let evidence = vec![Arc::new(self.evidence.clone())];
        self.baseline = Baseline::from_records(&Records { evidence, ..Records::default() });
        self
    }

    /// Every verdict.
    pub fn judge(&self) -> Vec<Verdict> {
        gates::judge(&self.evidence, &self.baseline)
    }

    /// The one verdict on a quantity of a claim.
    pub fn verdict(&self, claim: ClaimName, quantity: &str) -> Verdict {
        let mut found: Vec<Verdict> =
            self.judge().into_iter().filter(|v| v.claim == claim && v.quantity == quantity).collect();
        assert_eq!(found.len(), 1, "{claim:?} {quantity}: {found:#?}");
        found.remove(0)
    }

    /// Its ruling.
    pub fn ruling(&self, claim: ClaimName, quantity: &str) -> Ruling {
        self.verdict(claim, quantity).verdict
    }

    /// The quantities that a claim has a verdict on.
    pub fn quantities(&self, claim: ClaimName) -> Vec<String> {
        self.judge().into_iter().filter(|v| v.claim == claim).map(|v| v.quantity).collect()
    }
}

/// A row on record.
pub struct Recorded {
    pub content: String,
    pub scheme: String,
    pub quantity: Quantity,
    pub constant: Option<f64>,
    pub errors: Vec<(f64, f64)>,
}

impl Recorded {
    /// An empty case.
    pub fn of(made: &Made, quantity: Quantity) -> Recorded {
        let (content, scheme) = (made.evidence.setting.content.clone(), made.evidence.scheme.clone());
        Recorded { content, scheme, quantity, constant: None, errors: Vec::new() }
    }
}

/// What stands beside the ruling.
pub fn numbers(verdict: &Verdict) -> [Option<f64>; 3] {
    [verdict.measured, verdict.low, verdict.high]
}
