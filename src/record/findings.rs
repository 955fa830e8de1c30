//! What was measured: numbers of single runs, fitted orders, drifts, and quantities against time.

use serde::{Deserialize, Serialize};

use super::words::words;

words! {
    /// What came of a run.
    RunStatus {
        /// It came to its end.
        #[default]
        Ok = "ok",
        /// It broke.
        Broken = "broken",
        /// The scheme cannot take the scene, or the metric does not apply.
        NotApplicable = "not-applicable",
    }
}

words! {
    /// What a ladder says of an order.
    OrderStatus {
        /// A slope was fitted.
        Fitted = "fitted",
        /// Every error is at its floor.
        Exact = "exact",
        /// No three successive slopes agree.
        #[default]
        Unsettled = "unsettled",
        /// Too few errors stand clear of their floors.
        TooFew = "too-few",
        /// The finest run broke.
        Broken = "broken",
    }
}

words! {
    /// How a conserved quantity changes.
    DriftClass {
        /// By rounding only.
        Exact = "exact",
        /// By an oscillation that does not grow with time.
        Bounded = "bounded",
        /// Steadily, at a rate that has an order in h.
        Secular = "secular",
        /// Faster than steadily, or without bound.
        Growing = "growing",
        /// None of these can be distinguished.
        #[default]
        Undecided = "undecided",
    }
}

/// One number of one run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Model that was run.
    pub model: String,
    /// Time step [s].
    pub step_s: f64,
    /// Steps taken.
    pub steps: u64,
    /// Metric, for example `orientation-end`.
    pub metric: String,
    /// Value in `unit`; `None` where the run broke or the metric does not apply.
    pub value: Option<f64>,
    /// Unit of `value` and `uncertainty`; `1` for pure numbers.
    pub unit: String,
    /// The larger of the reference's uncertainty and the measured rounding floor.
    pub uncertainty: Option<f64>,
    /// What came of the run.
    pub status: RunStatus,
    /// Reason, where the run is not whole.
    pub why: Option<String>,
    /// Evaluations of the forces in the whole run.
    pub force_evaluations: u64,
    /// Wall-clock cost of a step; differs from run to run.
    pub nanoseconds_per_step: Option<f64>,
}

/// The fitted order of convergence of one quantity.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Order {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Quantity with the place it is taken at: `orientation-end`, `position-max`, …
    pub quantity: String,
    /// Least-squares slope of log error against log step; `None` where no window was found.
    pub order: Option<f64>,
    /// Lower end of its 95 % confidence interval.
    pub low: Option<f64>,
    /// Upper end of its 95 % confidence interval.
    pub high: Option<f64>,
    /// Leading error constant C = e/hᵖ with the claimed order p, in `unit`/sᵖ.
    pub constant: Option<f64>,
    /// Rungs of the ladder inside the fitted window.
    pub rungs_used: usize,
    /// Rungs left out: near the floor, before the asymptotic range, or broken.
    pub rungs_dropped: usize,
    /// The steps inside the fitted window [s].
    #[serde(default)]
    pub steps_used_s: Vec<f64>,
    /// Errors below this are rounding or reference error, in `unit`.
    #[serde(default)]
    pub floor: Option<f64>,
    /// Unit of the error.
    #[serde(default)]
    pub unit: String,
    /// What the ladder says.
    #[serde(default)]
    pub status: OrderStatus,
    /// Reason, where no slope was fitted.
    #[serde(default)]
    pub why: Option<String>,
}

/// How a conserved quantity drifts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Drift {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Quantity: `rotational-energy`, `angular-momentum-magnitude`, …
    pub quantity: String,
    /// How it changes.
    pub class: DriftClass,
    /// For a secular drift: order in the step of its rate.
    pub rate_order: Option<f64>,
    /// Lower end of the 95 % confidence interval of `rate_order`.
    pub low: Option<f64>,
    /// Upper end of the 95 % confidence interval of `rate_order`.
    pub high: Option<f64>,
    /// Rate at the finest step that still shows one, in `unit`/s.
    pub rate: Option<f64>,
    /// The step that `rate` belongs to [s].
    pub step_s: Option<f64>,
    /// Largest deviation over the run at that step, in `unit`.
    pub level: Option<f64>,
    /// Unit of the quantity; `1` for relative changes.
    pub unit: String,
}

/// A quantity against time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Time step [s].
    pub step_s: f64,
    /// Quantity: `rotational-energy`, `total-energy`, `angular-momentum` (relative change of its magnitude), …
    pub quantity: String,
    /// Unit of `value`; `1` for relative changes.
    pub unit: String,
    /// Times [s].
    pub time_s: Vec<f64>,
    /// Values at those times.
    pub value: Vec<f64>,
}
