//! What a scheme reaches in an arithmetic: errors and rounding against the step.

use serde::{Deserialize, Serialize};

use crate::words::words;

words! {
    /// What the smallest error of a ladder says.
    Reach {
        /// Rounding: a smaller step does not make the error smaller.
        #[default]
        Rounding = "rounding",
        /// The error still falls at the smallest steps that were run.
        Falling = "still-falling",
        /// The error stays where it is, and rounding is far smaller: the scheme converges to another motion.
        OtherMotion = "another-motion",
        /// No run came to its end.
        Broken = "broken",
    }
}

words! {
    /// How rounding grows with the number of steps n.
    GrowsAs {
        /// Roundings that add up at random.
        #[default]
        Root = "√n",
        /// Roundings of one sign.
        Linear = "n",
        /// The interval of the exponent holds both.
        Either = "√n or n",
        /// It lies below 1/2.
        Slower = "slower than √n",
        /// It lies between both.
        Between = "between √n and n",
        /// It lies above 1.
        Faster = "faster than n",
    }
}

/// Exponent q of a rounding that grows as n^q.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    /// q.
    pub exponent: f64,
    /// Twice its standard error.
    pub uncertainty: f64,
    /// The law that the interval of both allows.
    pub law: GrowsAs,
}

impl Growth {
    /// With the law that q ± uncertainty allows.
    pub fn new(exponent: f64, uncertainty: f64) -> Growth {
        let holds = |q: f64| (exponent - q).abs() <= uncertainty;
        let law = match (holds(0.5), holds(1.0)) {
            (true, false) => GrowsAs::Root,
            (false, true) => GrowsAs::Linear,
            (true, true) => GrowsAs::Either,
            _ if exponent < 0.5 => GrowsAs::Slower,
            _ if exponent < 1.0 => GrowsAs::Between,
            _ => GrowsAs::Faster,
        };
        Growth { exponent, uncertainty, law }
    }
}

/// A scheme in a scene, in one arithmetic, at a ladder of steps.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PrecisionRow {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// `f32`, `f64` or `double-double`, whose errors are truncation alone.
    pub arithmetic: String,
    /// Smallest error of the ladder [rad].
    pub smallest_error_rad: Option<f64>,
    /// The step where it stands [s].
    pub at_step_s: Option<f64>,
    /// What it says; `None` for double-double.
    pub reach: Option<Reach>,
    /// How rounding grows; `None` where too few runs show rounding.
    pub growth: Option<Growth>,
    /// The runs, step falling.
    pub runs: Vec<PrecisionRun>,
}

/// A run of a ladder.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PrecisionRun {
    /// Number of steps.
    pub steps: u64,
    /// h [s].
    pub step_s: f64,
    /// Largest angle to the reference over the run [rad]; `None` where the run broke.
    pub error_rad: Option<f64>,
    /// Largest angle to the same run in an arithmetic of more digits [rad]; `None` where there is none.
    pub rounding_rad: Option<f64>,
}
