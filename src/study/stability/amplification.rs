//! How a scheme acts on one mode of a linear problem, from its own steps in double-double.
//!
//! A body of 1 kg at rest, on a spring or under drag, is displaced by ±ε and stepped. Its displacement after n steps is
//!
//! ```text
//! (1)  x_n = (x_n(+ε) − x_n(−ε)) / 2ε                            central differences, ε = 1e-10
//! (2)  x_{n+m} = c_0 x_n + … + c_{m−1} x_{n+m−1}
//! ```
//!
//! and obeys the recurrence (2) of as many terms as the scheme has numbers in memory: two for a scheme of one step. The roots of (2)
//! are the factors by which a step multiplies the modes. The shortest recurrence that all steps obey is solved for.
//!
//! Source of (2): Prony's method. The laws are linear in the displacement where the body does not turn, so that (1) has no
//! truncation error; where it turns the error is ε², far below what a recurrence is held to.

use nalgebra::{Complex, DMatrix, DVector, Matrix3, Vector3};

use crate::arithmetic::{DoubleDouble, Real};
use crate::model::body::Body;
use crate::model::forces::{Attachment, Drag, Law, PerPoint, Spring};
use crate::model::{Broken, Snapshot, Spin, System};
use crate::rotation::turn;
use crate::simulate::{Contestant, Form, Plan};

/// ε [m].
const DISPLACEMENT: f64 = 1e-10;
/// Most terms of a recurrence: position and velocity at four steps.
const MOST_TERMS: usize = 8;
/// Steps that a recurrence must predict besides those that it is made of.
const PREDICTED: usize = 2;
/// Relative error of a prediction that counts as none: far above the unit of double-double, far below what is asked of a growth.
const PREDICTS: f64 = 1e-14;
/// First steps that a recurrence of more than two terms leaves out: in them a multistep scheme starts, and modes die that never matter.
const START: usize = 12;
/// Relative difference of two factors that counts as none: a factor that rounding makes is another one a step later.
const ALIKE: f64 = 1e-6;

/// A linear problem of frequency 1 rad/s or of rate 1/s, so that a = h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// x'' = −x − 2 ζ x'.
    Oscillation {
        /// ζ.
        zeta: f64,
    },
    /// The same of the angle of a body on a pivot.
    Turning {
        /// ζ.
        zeta: f64,
    },
    /// x'' = −x'.
    Decay,
}

/// What a step does to a mode at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amplification {
    /// The factor by which it grows.
    pub factor: f64,
    /// Terms of the recurrence.
    pub terms: usize,
}

impl Amplification {
    /// What it is, in words.
    pub fn words(self) -> String {
        match self.terms {
            0..=2 => "spectral radius of a step".to_owned(),
            terms => format!("largest root of a recurrence of {terms} terms"),
        }
    }
}

impl Mode {
    /// The body, displaced by so much.
    fn system(self, displacement: f64) -> Option<System<DoubleDouble>> {
        let turns = matches!(self, Mode::Turning { .. });
        let body = Body::from_inertia(1.0, Matrix3::identity(), turns.then(Vector3::zeros), false).ok()?;
        let lever = if turns { Vector3::x() } else { Vector3::zeros() };
        let law = match self {
            Mode::Oscillation { zeta } | Mode::Turning { zeta } => Law::Spring(Spring {
                attachment: Attachment::At(lever),
                anchor: lever,
                stiffness: 1.0,
                damping: 2.0 * zeta,
                rest_length: 0.0,
            }),
            Mode::Decay => Law::Drag(Drag { coefficient: PerPoint::Same(1.0 / body.points.len() as f64) }),
        };
        let (position, angle) = if turns { (0.0, displacement) } else { (displacement, 0.0) };
        let (position, angle) = (Vector3::x() * position, Vector3::z() * angle);
        let (velocity, spin) = (position * 0.5, Spin::Velocity(angle * 0.5));
        let system = System::new(body, vec![law], position, turn(&angle), velocity, spin).ok()?;
        System::of(&system).ok()
    }

    /// What follows the mode: a position, or under drag a velocity, since a position does not decay.
    fn seen(self, state: &Snapshot<DoubleDouble>) -> DoubleDouble {
        match self {
            Mode::Oscillation { .. } => state.position.x,
            Mode::Turning { .. } => state.orientation.as_ref().coords.z,
            Mode::Decay => state.velocity.x,
        }
    }

    /// How a step of a = ωh acts; `None` where the scheme does not take the problem, or its iteration does not end.
    pub fn amplification(self, contestant: &Contestant, a: f64) -> Option<Amplification> {
        [(0, 1..=2), (START, 1..=MOST_TERMS), (3 * START, 1..=MOST_TERMS)].into_iter().find_map(
            |(from, terms)| {
                let steps = from + 2 * terms.end() + PREDICTED;
                match self.displacements(contestant, a, steps)? {
                    None => Some(Amplification { factor: f64::INFINITY, terms: 0 }),
                    Some(x) => terms.into_iter().find_map(|terms| recurrence(&x[from..], terms)),
                }
            },
        )
    }

    /// (1); inside, `None` where the numbers grow out of range.
    fn displacements(
        self,
        contestant: &Contestant,
        a: f64,
        steps: usize,
    ) -> Option<Option<Vec<DoubleDouble>>> {
        let plan = Plan { step: a, steps: steps as u64, every: 1 };
        let run = |displacement: f64| {
            let system = self.system(displacement)?;
            let (states, outcome) = contestant.run_in(&system, Form::Least, &plan);
            match outcome.broken.map(|broken| broken.why) {
                None => Some(Some(states)),
                Some(Broken::NotFinite) => Some(None),
                Some(_) => None,
            }
        };
        let (Some(plus), Some(minus)) = (run(DISPLACEMENT)?, run(-DISPLACEMENT)?) else { return Some(None) };
        let difference = plus.iter().zip(&minus).map(|(p, m)| self.seen(p) - self.seen(m));
        Some(Some(difference.map(|x| x / (2.0 * DISPLACEMENT)).collect()))
    }

    /// The largest a = ωh up to which no step grows by more than `allowed` (relative), found by bisection after a scan, and how the
    /// scheme acts there; `None` where the smallest a tried, 1e-3, already grows, and where an iteration ends before a mode grows.
    pub fn limit(self, contestant: &Contestant, allowed: f64) -> Option<(f64, Amplification)> {
        let grown = |a: f64| {
            let one = self.amplification(contestant, a)?;
            Some((one.factor.is_nan() || one.factor > 1.0 + allowed, one))
        };
        // Coarse steps first show an iteration that does not end.
        let mut coarse = 1e-3;
        while !grown(coarse)?.0 {
            coarse *= 1.5;
            if coarse > 1e3 {
                return None;
            }
        }
        let (mut low, mut high) = (1e-3, 1e-3);
        let (grows, mut at_low) = grown(low)?;
        if grows {
            return None;
        }
        while !grown(high)?.0 {
            low = high;
            high *= 1.02;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match grown(middle)? {
                (true, _) => high = middle,
                (false, one) => (low, at_low) = (middle, one),
            }
        }
        Some((low, at_low))
    }
}

/// The limit of the oscillation of a body that turns and is displaced at once; `None` also where a scheme steps turns and displacements
/// by different rules, so that every mixture has another limit.
pub fn limit_of_a_body(zeta: f64, contestant: &Contestant, allowed: f64) -> Option<(f64, Amplification)> {
    let (displaced, turned) = (Mode::Oscillation { zeta }, Mode::Turning { zeta });
    let limit = displaced.limit(contestant, allowed)?;
    let factor = |mode: Mode, part: f64| Some(mode.amplification(contestant, limit.0 * part)?.factor);
    let same = [0.99, 1.01].into_iter().all(|part| match (factor(displaced, part), factor(turned, part)) {
        (Some(a), Some(b)) => alike(a, b),
        _ => true,
    });
    same.then_some(limit)
}

fn alike(a: f64, b: f64) -> bool {
    (a - b).abs() <= ALIKE * a
}

/// (2) with so many terms, if it predicts every step and a step later has the same largest root.
fn recurrence(x: &[DoubleDouble], terms: usize) -> Option<Amplification> {
    let coefficients = coefficients(x, terms)?;
    let holds = x.windows(terms + 1).all(|window| {
        let (known, next) = (&window[..terms], window[terms]);
        let predicted: DoubleDouble = known.iter().zip(&coefficients).map(|(x, c)| *x * *c).sum();
        let size = window.iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
        (predicted - next).to_f64().abs() <= PREDICTS * size
    });
    if !holds {
        return None;
    }
    let later = self::coefficients(&x[1..], terms)?;
    let [factor, later] = [coefficients, later].map(|one| largest_root(one.as_slice()));
    alike(factor, later).then_some(Amplification { factor, terms })
}

/// (2) solved on the first steps.
fn coefficients(x: &[DoubleDouble], terms: usize) -> Option<DVector<DoubleDouble>> {
    let hankel = DMatrix::from_fn(terms, terms, |i, j| x[i + j]);
    hankel.lu().solve(&DVector::from_fn(terms, |i, _| x[i + terms]))
}

/// The largest modulus of the roots of rᵐ = c_0 + … + c_{m−1} rᵐ⁻¹.
fn largest_root(c: &[DoubleDouble]) -> f64 {
    if let [c0] = c {
        return c0.to_f64().abs();
    }
    if let [c0, c1] = c {
        // In closed form, since a double root would lose half the digits.
        let (half, determinant) = (*c1 * 0.5, -*c0);
        let square = half * half - determinant;
        let root = num_traits::Signed::abs(&square).to_f64().sqrt();
        return if square.to_f64() < 0.0 { determinant.to_f64().sqrt() } else { half.to_f64().abs() + root };
    }
    let m = c.len();
    let companion = DMatrix::from_fn(m, m, |i, j| match i {
        0 => c[m - 1 - j].to_f64(),
        _ => f64::from(u8::from(i == j + 1)),
    });
    companion.complex_eigenvalues().iter().map(|root: &Complex<f64>| root.norm()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::super::theory::peskin_condition;
    use super::*;

    fn limit(scheme: &str, mode: Mode, allowed: f64) -> f64 {
        let contestant = Contestant::all().into_iter().find(|c| c.card.name == scheme).expect("in the list");
        mode.limit(&contestant, allowed).expect("stable somewhere").0
    }

    fn damped(zeta: f64) -> Mode {
        Mode::Oscillation { zeta }
    }

    #[test]
    fn the_condition_of_the_note_s_scheme_is_that_of_its_steps() {
        for zeta in [0.05, 0.155, 0.62, 0.9, 1.5, 3.0] {
            let limit = limit("peskin-rk2", damped(zeta), 0.0);
            assert!(
                peskin_condition(limit * 0.999, zeta) < 0.0 && peskin_condition(limit * 1.001, zeta) > 0.0,
                "{zeta}"
            );
        }
    }

    #[test]
    fn the_note_s_scheme_bears_the_largest_step_at_the_damping_that_its_condition_says() {
        // The left side of (2) of `theory` is least in ζ at ζ = (a² + 2)/(4a), where it is zero for 2a⁴ = (a² + 2)²: a² = 2/(√2 − 1). The
        // point a = 2.135, ζ = 0.62 was measured: it is on the curve to the 0.3 % that runs agree to, and before its end.
        let tip = (2.0 / (2f64.sqrt() - 1.0)).sqrt();
        let damping = (tip * tip + 2.0) / (4.0 * tip);
        assert!(peskin_condition(tip, damping).abs() < 1e-12);
        assert!((tip - 2.1974).abs() < 1e-4 && (damping - 0.7769).abs() < 1e-4);
        let at = |zeta| limit("peskin-rk2", damped(zeta), 0.0);
        assert!((at(0.62) / 2.135 - 1.0).abs() < 3e-3);
        // A tip is one: a little to either side of it the step is smaller.
        let [below, here, above] = [damping - 0.01, damping, damping + 0.01].map(at);
        assert!((here - tip).abs() < 1e-4 && below < here && above < here, "{below} {here} {above}");
    }

    #[test]
    fn textbook_limits_come_out_of_the_steps() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 2e-3 * b, "{a} {b}");
        let free = |scheme| limit(scheme, damped(0.0), 1e-12);
        near(free("strang-symmetric"), 2.0);
        // Imaginary axis of the classical methods: √3 and 2√2.
        near(free("peskin-rk3"), 3f64.sqrt());
        near(free("rk4-quaternion"), 8f64.sqrt());
        near(free("yoshida-4"), 1.573);
        near(limit("course-notes-euler", damped(0.5), 1e-12), 2.0 * (1.25f64.sqrt() - 0.5));
        // Negative real axis: z = −1 for AB2 and −6/11 for AB3.
        for (scheme, known) in [("adams-bashforth-2", 1.0), ("adams-bashforth-3", 6.0 / 11.0), ("euler", 2.0)]
        {
            near(limit(scheme, Mode::Decay, 1e-9), known);
        }
        // The same of the fast mode beside a slow one, λ = −(ζ + √(ζ² − 1)) ω.
        for (scheme, known) in [("adams-bashforth-2", 1.0), ("adams-bashforth-3", 6.0 / 11.0), ("euler", 2.0)]
        {
            near(limit(scheme, damped(50.0), 1e-12) * (50.0 + 2499f64.sqrt()), known);
        }
    }
}
