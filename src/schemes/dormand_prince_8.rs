//! Dormand and Prince's method of order 8 in body axes, steps chosen by a tolerance.
//!
//! With y = (q, l, X_cm, U_cm), l = Rᵀ L in principal axes, f as `body_form` has it, ε the tolerance and n the number of parts of y:
//!
//! ```text
//! (1)  kᵢ = f(t + cᵢ h, y₀ + h Σ aᵢⱼ kⱼ),  cᵢ = Σ aᵢⱼ
//! (2)  y₁ = y₀ + h Σ bᵢ kᵢ, then q₁ over its length
//! (3)  e₅ = Σ eᵢ kᵢ of order 5, e₃ = Σ (bᵢ − b̂ᵢ) kᵢ of order 3, each part over ε times its size
//! (4)  e = h |e₅|²/√(n (|e₅|² + |e₃|²/100))
//! (5)  a step with e ≤ 1 is taken, and the next is 0.9 e^(−1/8) times as long, between a third and six times
//! ```
//!
//! A part of y has the size of its unit in the scene. Stored times end a step. It is dop853 on the least model of a scene, where an
//! evaluation costs what it costs in a scheme.
//!
//! Source: hairer1993, II.5 and II.10, and the code of its appendix; the digits are those of f64, checked by the order conditions.

use nalgebra::Vector3;

use super::body_form::{From, Slope, sum};
use crate::interrupt;
use crate::model::{AnyModel, Broken, Rates, System, Turning};
use crate::ode::SolverError;
use crate::ode::run::{self, MOST_EVALUATIONS, Run};
use crate::ode::units::Units;

const NAME: &str = "dormand-prince-8";
const STAGES: usize = 12;

type Row = &'static [(usize, f64)];

/// aᵢⱼ that are not zero.
const A: [Row; STAGES] = [
    &[],
    &[(0, 0.052_600_151_958_767_73)],
    &[(0, 0.019_725_056_984_537_9), (1, 0.059_175_170_953_613_7)],
    &[(0, 0.029_587_585_476_806_85), (2, 0.088_762_756_430_420_54)],
    &[(0, 0.241_365_134_159_266_7), (2, -0.884_549_479_328_286_1), (3, 0.924_834_003_261_792)],
    &[(0, 0.037_037_037_037_037_035), (3, 0.170_828_608_729_473_86), (4, 0.125_467_687_566_822_42)],
    &[(0, 0.037_109_375), (3, 0.170_252_211_019_544_05), (4, 0.060_216_538_980_455_96), (5, -0.017_578_125)],
    &[
        (0, 0.037_092_000_118_504_79),
        (3, 0.170_383_925_712_239_98),
        (4, 0.107_262_030_446_373_28),
        (5, -0.015_319_437_748_624_402),
        (6, 0.008_273_789_163_814_023),
    ],
    &[
        (0, 0.624_110_958_716_075_7),
        (3, -3.360_892_629_446_941_4),
        (4, -0.868_219_346_841_726),
        (5, 27.592_099_699_446_71),
        (6, 20.154_067_550_477_894),
        (7, -43.489_884_181_069_96),
    ],
    &[
        (0, 0.477_662_536_438_264_34),
        (3, -2.488_114_619_971_667_7),
        (4, -0.590_290_826_836_843),
        (5, 21.230_051_448_181_193),
        (6, 15.279_233_632_882_423),
        (7, -33.288_210_968_984_86),
        (8, -0.020_331_201_708_508_627),
    ],
    &[
        (0, -0.937_142_430_085_987_3),
        (3, 5.186_372_428_844_064),
        (4, 1.091_437_348_996_729_5),
        (5, -8.149_787_010_746_927),
        (6, -18.520_065_659_996_96),
        (7, 22.739_487_099_350_505),
        (8, 2.493_605_552_679_652_3),
        (9, -3.046_764_471_898_219_6),
    ],
    &[
        (0, 2.273_310_147_516_538),
        (3, -10.534_495_466_737_25),
        (4, -2.000_872_058_224_862_5),
        (5, -17.958_931_863_118_8),
        (6, 27.948_884_529_419_96),
        (7, -2.858_998_277_135_023_5),
        (8, -8.872_856_933_530_63),
        (9, 12.360_567_175_794_303),
        (10, 0.643_392_746_015_763_6),
    ],
];
/// bᵢ.
const B: Row = &[
    (0, 0.054_293_734_116_568_765),
    (5, 4.450_312_892_752_409),
    (6, 1.891_517_899_314_500_3),
    (7, -5.801_203_960_010_585),
    (8, 0.311_164_366_957_819_9),
    (9, -0.152_160_949_662_516_1),
    (10, 0.201_365_400_804_030_34),
    (11, 0.044_710_615_727_772_59),
];
/// b̂ᵢ.
const B_HAT: Row =
    &[(0, 0.244_094_488_188_976_4), (8, 0.733_846_688_281_611_8), (11, 0.022_058_823_529_411_766)];
/// eᵢ.
const E: Row = &[
    (0, 0.013_120_044_994_194_88),
    (5, -1.225_156_446_376_204_4),
    (6, -0.495_758_949_657_250_2),
    (7, 1.664_377_182_454_986_4),
    (8, -0.350_328_848_749_973_66),
    (9, 0.334_179_118_713_017_5),
    (10, 0.081_923_206_485_115_71),
    (11, -0.022_355_307_863_886_294),
];

/// Part of the step that (4) asks for.
const SAFETY: f64 = 0.9;
/// Bounds of the next step over the last one.
const CHANGE: (f64, f64) = (1.0 / 3.0, 6.0);
/// A last step up to a hundredth longer than wanted spares a sliver.
const SLIVER: f64 = 1.01;

/// The states at increasing `times` [s], from t = 0 on.
///
/// # Errors
/// [`SolverError`]: times that do not increase, a state that is not finite, too many evaluations.
pub fn solve(system: &System, times: &[f64], tolerance: f64) -> Result<Run, SolverError> {
    let last = run::increasing(times)?;
    let sizes = Sizes::of(system, &Units::of(system, if last > 0.0 { last } else { 1.0 }), tolerance);
    match system.least() {
        AnyModel::Free(model) => along(&model.with_momentum(), &sizes, times),
        AnyModel::Falling(model) => along(&model.with_momentum(), &sizes, times),
        AnyModel::Torque(model) | AnyModel::Pivot(model) => along(&model, &sizes, times),
        AnyModel::Forced(model) => along(&model, &sizes, times),
        AnyModel::Points(_) => Err(gave_up(0.0, 0, Broken::NeedsAttitude.to_string())),
    }
}

fn gave_up(time: f64, evaluations: usize, reason: String) -> SolverError {
    SolverError::NoConvergence { method: NAME, time, evaluations, reason }
}

/// What an error of each part is measured by: the tolerance times its unit; and the first step that is tried.
struct Sizes {
    length: f64,
    speed: f64,
    momentum: f64,
    turn: f64,
    parts: f64,
    first: f64,
}

impl Sizes {
    fn of(system: &System, units: &Units, tolerance: f64) -> Sizes {
        let moves = !system.body.pivoted && !system.constant_force().0;
        Sizes {
            length: tolerance * units.length,
            speed: tolerance * units.speed,
            momentum: tolerance * units.inertia * units.spin,
            turn: tolerance,
            parts: if moves { 13.0 } else { 7.0 },
            first: units.time * tolerance.powf(1.0 / 8.0),
        }
    }

    /// The sum of the squares of all parts over their sizes.
    fn squared<R: Rates<f64>>(&self, slope: &Slope<f64, R>) -> f64 {
        let part = |rate: &Vector3<f64>, size: f64| (rate / size).norm_squared();
        let motion = slope.rates.motion();
        part(&motion.velocity, self.length)
            + part(&motion.acceleration, self.speed)
            + part(&slope.gain, self.momentum)
            + (slope.turn / self.turn).norm_squared()
    }
}

/// Σ wⱼ kⱼ.
#[inline(always)]
fn weighted<R: Rates<f64>>(row: Row, k: &[Slope<f64, R>]) -> Slope<f64, R> {
    let term = |(j, weight): &(usize, f64)| (*weight, &k[*j]);
    sum(term(&row[0]), row[1..].iter().map(term))
}

/// A run on one model.
struct Stepper<'a, M: Turning<Real = f64>> {
    model: &'a M,
    sizes: &'a Sizes,
    state: M::State,
    next: M::State,
    stage: M::State,
    k: [Slope<f64, M::Rates>; STAGES],
    evaluations: usize,
}

impl<M: Turning<Real = f64>> Stepper<'_, M> {
    /// k₁ of the step that begins at the state.
    fn begin(&mut self, t: f64) -> Result<(), Broken> {
        self.evaluations += 1;
        self.k[0] = From::new(self.model, &self.state).slope(t)?;
        Ok(())
    }

    /// Tries a step from the state, where k₁ is known, and gives e (4); the end stands in `next`.
    fn attempt(&mut self, t: f64, h: f64) -> Result<f64, Broken> {
        let start = From::new(self.model, &self.state);
        for (i, row) in A.iter().enumerate().skip(1) {
            let c: f64 = row.iter().map(|(_, a)| a).sum();
            self.k[i] = start.stage(t + c * h, h, &weighted(row, &self.k), &mut self.stage)?; // (1)
        }
        self.evaluations += STAGES - 1;
        let mean = weighted(B, &self.k);
        start.go(h, &mean, &mut self.next); // (2)
        let five = self.sizes.squared(&weighted(E, &self.k)); // (3)
        let three = self.sizes.squared(&sum((1.0, &mean), [(-1.0, &weighted(B_HAT, &self.k))])); // (3)
        let under = self.sizes.parts * (five + 0.01 * three);
        Ok(if under > 0.0 { h * five / under.sqrt() } else { 0.0 }) // (4)
    }
}

/// Takes a model from stored time to stored time.
fn along<M: Turning<Real = f64>>(model: &M, sizes: &Sizes, times: &[f64]) -> Result<Run, SolverError> {
    let start = model.start();
    let (mut t, mut wanted) = (0.0, sizes.first);
    let mut states = Vec::with_capacity(times.len());
    let broken = |t: f64, evaluations: usize| move |why: Broken| gave_up(t, evaluations, why.to_string());
    let first = From::new(model, &start).slope(0.0).map_err(broken(0.0, 1))?;
    let mut stepper = Stepper {
        model,
        sizes,
        next: start.clone(),
        stage: start.clone(),
        state: start,
        k: [first; STAGES],
        evaluations: 1,
    };
    for time in times {
        while t < *time {
            let left = time - t;
            let last = wanted * SLIVER >= left;
            let h = if last { left } else { wanted };
            let error = stepper.attempt(t, h).map_err(broken(t, stepper.evaluations))?;
            if error.is_nan() || !model.is_finite(&stepper.next) {
                return Err(SolverError::NotFinite { method: NAME, time: t });
            }
            if stepper.evaluations > MOST_EVALUATIONS {
                let reason = format!("more than {MOST_EVALUATIONS} evaluations");
                return Err(gave_up(t, stepper.evaluations, reason));
            }
            if interrupt::requested() {
                return Err(SolverError::Interrupted);
            }
            let change = (SAFETY * error.powf(-1.0 / 8.0)).clamp(CHANGE.0, CHANGE.1); // (5)
            if error > 1.0 {
                wanted = h * change.min(1.0);
                if t + wanted <= t {
                    return Err(gave_up(t, stepper.evaluations, "the step vanishes".to_owned()));
                }
                continue;
            }
            // A stored time has cut the last step: what was wanted before stays.
            wanted = if last { (h * change).max(wanted) } else { h * change };
            t = if last { *time } else { t + h };
            std::mem::swap(&mut stepper.state, &mut stepper.next);
            stepper.begin(t).map_err(broken(t, stepper.evaluations))?;
        }
        states.push(model.observe(*time, &stepper.state).map_err(broken(t, stepper.evaluations))?);
    }
    Ok(Run { states, evaluations: stepper.evaluations })
}

#[cfg(test)]
mod tests {
    use super::super::trees::Tree;
    use super::*;

    fn filled(row: Row) -> [f64; STAGES] {
        let mut all = [0.0; STAGES];
        row.iter().for_each(|(j, x)| all[*j] = *x);
        all
    }

    #[test]
    fn the_tableau_has_order_8_and_its_estimates_orders_5_and_3() {
        let (a, b, e) = (A.map(filled), filled(B), filled(E));
        // Digits of f64, and sums of up to twelve terms whose size is in the measure.
        assert!(Tree::worst(8, &a, &b, 1.0) < 2e-15, "{:e}", Tree::worst(8, &a, &b, 1.0));
        assert!(Tree::worst(9, &a, &b, 1.0) > 1e-6, "not of order 9");
        assert!(Tree::worst(5, &a, &e, 0.0) < 2e-15, "{:e}", Tree::worst(5, &a, &e, 0.0));
        assert!(Tree::worst(6, &a, &e, 0.0) > 1e-6, "not of order 6");
        let hat = filled(B_HAT);
        let three: [f64; STAGES] = std::array::from_fn(|i| b[i] - hat[i]);
        assert!(Tree::worst(3, &a, &three, 0.0) < 2e-15, "{:e}", Tree::worst(3, &a, &three, 0.0));
        assert!(Tree::worst(4, &a, &three, 0.0) > 1e-6, "not of order 4");
    }
}
