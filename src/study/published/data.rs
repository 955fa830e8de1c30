//! The figures as the file says them.

use serde::Deserialize;

use super::PublishedError;
use crate::record::{Agreement, Sureness, last_digit};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    problem: Vec<Problem>,
}

/// A problem and its figures.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Problem {
    pub title: String,
    pub scene: String,
    pub source: String,
    #[serde(rename = "figure")]
    pub figures: Vec<Figure>,
}

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Measure {
    /// X_cm, or the place of `point`.
    Position,
    /// X_cm − X_cm(0).
    Displacement,
    /// U_cm, or the velocity of `point`.
    Velocity,
    /// Ω in world axes.
    AngularVelocity,
    /// Ω in body axes.
    BodyAngularVelocity,
    /// w, x, y, z, body axes to world axes, of the sign that is printed.
    Quaternion,
    /// The same for world axes to body axes.
    InverseQuaternion,
    /// Modified Rodrigues parameters tan(θ/4) of the axis, body axes to world axes.
    RodriguesParameters,
    /// |Ω| relative to an observed one, and the angles of Ω and of the three body axes to observed ones.
    Residuals,
    /// Kinetic and potential energy.
    Energy,
    /// Angle to a constant spin with the first Ω.
    AngleToSteadySpin,
    /// E/E(0).
    EnergyRatio,
    /// |L|.
    Momentum,
    /// |L − L(0)|.
    MomentumChange,
    /// E − E(0).
    EnergyChange,
    /// Largest |E − E(0)| over the run.
    EnergySwing,
    /// Largest |E − E(0)|/E(0), |L − L(0)|/|L(0)| and |X_cm − truth| over the run.
    LargestErrors,
    /// |X_cm − truth|.
    PositionError,
    /// |error of a component of X_cm − X_cm(0)| over its size.
    RelativeError,
    /// Least and largest error of a component of Ω in body axes from `from` to `time`.
    RateErrorExtremes,
    /// Period of a component of Ω in body axes.
    SpinPeriod,
    /// Time of a mean turn about L.
    PrecessionPeriod,
    /// Period of the tilt of the third body axis.
    NutationPeriod,
    /// Period of the angle to axes that turn about the third world axis at the speed `rate`.
    LibrationPeriod,
}

/// Orientation and spin that were observed.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Observation {
    /// Euler angles about z, x, z [deg].
    pub angles: [f64; 3],
    /// Ω in body axes [deg a unit of time].
    pub rates: [f64; 3],
}

/// A published figure: one quantity at one time, by one scheme.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Figure {
    pub quantity: String,
    pub measure: Measure,
    /// t, or the end of the run, or where a period is looked for [s].
    pub time: f64,
    /// Start of a window of time [s].
    #[serde(default)]
    pub from: f64,
    /// Components of the measure that are printed; all where there is none.
    #[serde(default)]
    pub components: Vec<usize>,
    /// What each number is divided by.
    #[serde(default)]
    pub scales: Vec<f64>,
    /// A point of the body, from the centre of mass in body axes [m].
    #[serde(default)]
    pub point: [f64; 3],
    pub observed: Option<Observation>,
    /// Component of Ω in body axes whose period or error is meant.
    pub rate_component: Option<usize>,
    /// Speed of turning axes [rad/s].
    pub rate: Option<f64>,
    /// The truth where there is none.
    pub scheme: Option<String>,
    #[serde(default)]
    pub steps: u64,
    pub unit: String,
    pub published: Vec<String>,
    pub ours: Vec<String>,
    /// Limits in `unit`; one unit of the last printed digit where there is neither this nor `within_part`.
    #[serde(default)]
    pub within: Option<f64>,
    /// Limits over the printed number.
    #[serde(default)]
    pub within_part: Option<f64>,
    #[serde(default = "printed_digits")]
    pub because: String,
    pub agreement: Agreement,
    pub sureness: Sureness,
    /// Where it differs from the problem's.
    pub source: Option<String>,
    /// Whether a number that is off is the run of a scheme.
    #[serde(default)]
    pub truncated: bool,
    #[serde(default)]
    pub note: String,
}

fn printed_digits() -> String {
    "one unit of the last printed digit".to_owned()
}

/// Printed numbers; `None` where one is none.
pub(super) fn numbers(texts: &[String]) -> Option<Vec<f64>> {
    texts.iter().map(|text| text.parse().ok()).collect()
}

impl Figure {
    /// Largest differences that agree.
    pub fn limits(&self, printed: &[f64]) -> Vec<f64> {
        let limit = |(text, value): (&String, &f64)| match (self.within, self.within_part) {
            (Some(within), _) => within,
            (None, Some(part)) => part * value.abs(),
            (None, None) => last_digit(text),
        };
        self.published.iter().zip(printed).map(limit).collect()
    }

    /// Who gives the number.
    pub fn by(&self) -> String {
        match &self.scheme {
            Some(scheme) => format!("{scheme}, {} steps", self.steps),
            None => "truth".to_owned(),
        }
    }

    /// Factor from rad to the unit.
    pub fn angle_unit(&self) -> f64 {
        if self.unit.starts_with("deg") { 180.0 / std::f64::consts::PI } else { 1.0 }
    }
}

/// All problems, in the order of the file.
pub(super) fn problems(figures: &str) -> Result<Vec<Problem>, PublishedError> {
    Ok(toml::from_str::<File>(figures)?.problem)
}
