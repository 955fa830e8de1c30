//! What was measured: numbers of single runs, fitted orders, drifts, and quantities against time.

use serde::{Deserialize, Serialize};

use super::{packed, to_digits};
use crate::words::words;

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
    /// What the runs of a scheme say of an order.
    OrderStatus {
        /// An order is decided.
        #[serde(alias = "fitted")]
        Decided = "decided",
        /// Every error is at its rounding.
        Exact = "exact",
        /// The runs converge to another motion.
        Elsewhere = "elsewhere",
        /// The rule falls for no order.
        #[default]
        #[serde(alias = "unsettled")]
        Undecided = "undecided",
        /// Too few errors stand clear of rounding.
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

/// The order of convergence of one quantity.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Order {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Quantity: `orientation`, `position`, …
    pub quantity: String,
    /// log₂ of the ratio of two errors that decide the order; `None` where none is decided.
    pub order: Option<f64>,
    /// Lower bound of it, p − log₂(1 + r).
    pub low: Option<f64>,
    /// Upper bound of it, p − log₂(1 − r).
    pub high: Option<f64>,
    /// ‖e_k − 2ᵖ e_{k+1}‖/‖e_k‖ of the runs that decide it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub r: Option<f64>,
    /// The latest time that is decided [s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until_s: Option<f64>,
    /// Leading error constant C = e/hᵖ for h → 0, in `unit`/sᵖ.
    pub constant: Option<f64>,
    /// Runs that decide it.
    pub rungs_used: usize,
    /// Runs left out: at rounding, before the asymptotic range, or broken.
    pub rungs_dropped: usize,
    /// The steps of the runs that decide it [s], in files the first one and their number where each is half of the one before.
    #[serde(default, skip_serializing_if = "Vec::is_empty", with = "halved")]
    pub steps_used_s: Vec<f64>,
    /// Errors below this do not count at the finest step: rounding and the uncertainty of the truth, in `unit`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub floor: Option<f64>,
    /// Unit of the error.
    #[serde(default)]
    pub unit: String,
    /// What the ladder says.
    #[serde(default)]
    pub status: OrderStatus,
    /// Reason, where no order is decided.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
}

/// What five digits of two errors leave undecided of a constant, relative: three times half a unit of the last.
const OF_DIGITS: f64 = 1.5e-5;

impl Order {
    /// What the constant may be wrong by, relative: it is extrapolated from two runs that differ from a power of h by r, which leaves about r²
    /// of it undecided.
    pub fn constant_uncertainty(&self) -> Option<f64> {
        self.r.filter(|_| self.constant.is_some()).map(|r| r * r + OF_DIGITS)
    }
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
    /// Lower bound of `rate_order`.
    pub low: Option<f64>,
    /// Upper bound of `rate_order`.
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
    /// Quantity: `rotational-energy`, `total-energy`, `angular-momentum-magnitude`, … as a change from the start where the motion conserves
    /// it; `rotational-energy-error`, … as an error against the reference where a torque changes it.
    pub quantity: String,
    /// Unit of `value`; `1` for relative changes.
    pub unit: String,
    /// Times [s], in files the last one and the number of equal intervals.
    #[serde(with = "even")]
    pub time_s: Vec<f64>,
    /// Values at those times.
    #[serde(with = "packed::list")]
    pub value: Vec<f64>,
}

/// Steps, each half of the one before: a division by two is exact.
mod halved {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(untagged)]
    enum Steps {
        Halved { from: f64, runs: usize },
        Listed(Vec<f64>),
    }

    fn steps(from: f64, runs: usize) -> Vec<f64> {
        std::iter::successors(Some(from), |step| Some(step / 2.0)).take(runs).collect()
    }

    pub fn serialize<S: Serializer>(listed: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
        if let [from, _, ..] = *listed
            && steps(from, listed.len()) == listed
        {
            return Steps::Halved { from, runs: listed.len() }.serialize(serializer);
        }
        listed.serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
        Ok(match Steps::deserialize(deserializer)? {
            // A number of runs that no ladder has would take all memory.
            Steps::Halved { runs, .. } if runs > super::MOST_RUNS => {
                return Err(serde::de::Error::custom("more steps than a ladder has"));
            }
            Steps::Halved { from, runs } => steps(from, runs),
            Steps::Listed(listed) => listed,
        })
    }
}

/// Runs of a ladder in a file, at the most.
const MOST_RUNS: usize = 64;

/// Digits of a time in a series.
pub(crate) const TIME_DIGITS: usize = 7;

/// Times at equal intervals from 0, rounded to [`TIME_DIGITS`].
pub(super) mod even {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::{TIME_DIGITS, to_digits};

    #[derive(Serialize, Deserialize)]
    #[serde(untagged)]
    enum Times {
        Even { to: f64, intervals: usize },
        Listed(Vec<f64>),
    }

    fn times(to: f64, intervals: usize) -> Vec<f64> {
        let time = |index: usize| to_digits(to * index as f64 / intervals as f64, TIME_DIGITS);
        (0..=intervals).map(time).collect()
    }

    pub fn serialize<S: Serializer>(listed: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
        if let [_, .., to] = *listed
            && times(to, listed.len() - 1) == listed
        {
            return Times::Even { to, intervals: listed.len() - 1 }.serialize(serializer);
        }
        listed.serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
        Ok(match Times::deserialize(deserializer)? {
            Times::Even { to, intervals } => times(to, intervals),
            Times::Listed(listed) => listed,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Order;

    #[test]
    fn steps_that_halve_are_written_as_two_numbers_and_others_one_by_one() {
        let order = |steps: &[f64]| Order { steps_used_s: steps.to_vec(), ..Order::default() };
        for (steps, words) in [
            (&[0.3, 0.15, 0.075][..], r#""steps_used_s":{"from":0.3,"runs":3}"#),
            (&[0.3, 0.1], r#""steps_used_s":[0.3,0.1]"#),
            (&[0.3], r#""steps_used_s":[0.3]"#),
        ] {
            let text = serde_json::to_string(&order(steps)).expect("JSON");
            assert!(text.contains(words), "{text}");
            assert_eq!(serde_json::from_str::<Order>(&text).expect("an order"), order(steps));
        }
        assert!(!serde_json::to_string(&order(&[])).expect("JSON").contains("steps_used_s"));
    }
}
