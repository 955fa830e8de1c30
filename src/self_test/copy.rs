//! A copy of Peskin's scheme on mass points, written from the note in plain loops, with one place for each
//! flaw. It shares no code with the scheme under test but the force laws.

use super::flaw::Flaw;
use crate::interrupt;
use crate::model::forces::{Arms, Cloud, Load};
use crate::model::{Broken, Snapshot, System};
use crate::rotation;
use crate::schemes::Scheme;
use crate::simulate::{Break, Contestant, Form, Outcome, Plan};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

type V3 = Vector3<f64>;

#[derive(Clone)]
struct State {
    arms: Vec<V3>,
    position: V3,
    velocity: V3,
    momentum: V3,
}

struct Stage {
    spin: V3,
    force: V3,
    torque: V3,
}

struct Copy<'a> {
    system: &'a System,
    masses: Vec<f64>,
    body_arms: Vec<V3>,
    pivot: Option<V3>,
    start_inertia: Matrix3<f64>,
    start_arms: Vec<V3>,
    flaw: Flaw,
}

/// The copy with a flaw, under the name and the claims of the scheme that it pretends to be.
pub(super) fn contestant(flaw: Flaw) -> Contestant {
    Contestant::foreign(crate::schemes::PeskinRk2.card(), move |system, form, plan, store| {
        run(flaw, system, form, plan, store)
    })
}

fn run(flaw: Flaw, system: &System, _form: Form, plan: &Plan, store: &mut dyn FnMut(&Snapshot)) -> Outcome {
    let copy = Copy::new(system, flaw);
    let mut state = copy.start();
    let mut outcome = Outcome::none_yet();
    for n in 0..=plan.steps {
        if n.is_multiple_of(plan.every) || n == plan.steps {
            if interrupt::requested() {
                let (step, why) = (n + 1, Broken::Interrupted);
                outcome.broken = Some(Break { step, time: n as f64 * plan.step, why });
                return outcome;
            }
            store(&copy.observe(n as f64 * plan.step, &state));
        }
        if n < plan.steps && !(flaw == Flaw::LastStepDropped && n + 1 == plan.steps) {
            let late = if flaw == Flaw::ClockOneStepLate { plan.step } else { 0.0 };
            let long = if flaw == Flaw::StepALittleLong { 1.0 + 1e-4 } else { 1.0 };
            copy.step(n as f64 * plan.step - late, plan.step * long, &mut state);
            if flaw == Flaw::FirstStepTwice && n == 0 {
                copy.step(0.0, plan.step, &mut state);
            }
        }
    }
    let sum = state.momentum.sum() + state.position.sum() + state.arms.iter().map(|a| a.sum()).sum::<f64>();
    if !sum.is_finite() {
        let why = Broken::NotFinite;
        outcome.broken = Some(Break { step: plan.steps, time: 0.0, why });
    }
    outcome.steps = plan.steps;
    outcome.evaluations = 2 * plan.steps;
    outcome
}

impl<'a> Copy<'a> {
    fn new(system: &'a System, flaw: Flaw) -> Copy<'a> {
        let masses: Vec<f64> = system.body.points.iter().map(|p| p.mass).collect();
        let points = system.body.points.iter().map(|p| p.position);
        let body_arms: Vec<V3> = points.chain(system.forces.markers().iter().copied()).collect();
        let pivot = system.body.pivoted.then(|| system.origin());
        let (start_inertia, start_arms) = (Matrix3::zeros(), Vec::new());
        let mut copy = Copy { system, masses, body_arms, pivot, start_inertia, start_arms, flaw };
        copy.start_arms = copy.start().arms;
        copy.start_inertia = copy.inertia(&copy.start().arms);
        copy
    }

    fn start(&self) -> State {
        let start = &self.system.start;
        State {
            arms: self.body_arms.iter().map(|arm| start.orientation * arm).collect(),
            position: start.position,
            velocity: start.velocity,
            momentum: start.angular_momentum,
        }
    }

    fn inertia(&self, arms: &[V3]) -> Matrix3<f64> {
        let sign = if self.flaw == Flaw::InertiaWithWrongSign { 1.0 } else { -1.0 };
        let skipped = usize::from(self.flaw == Flaw::OneMassLeftOut);
        let mean = self.masses.iter().sum::<f64>() / self.masses.len() as f64;
        let mass = |m: &f64| if self.flaw == Flaw::EqualMasses { mean } else { *m };
        let inertia: Matrix3<f64> = arms
            .iter()
            .zip(&self.masses)
            .skip(skipped)
            .map(|(x, m)| (Matrix3::identity() * x.norm_squared() + x * x.transpose() * sign) * mass(m))
            .sum();
        if self.flaw == Flaw::DiagonalInertia {
            return Matrix3::from_diagonal(&inertia.diagonal());
        }
        inertia
    }

    fn spin(&self, inertia: &Matrix3<f64>, momentum: &V3) -> V3 {
        let inertia = if self.flaw == Flaw::InertiaFrozen { &self.start_inertia } else { inertia };
        let spin = inertia.lu().solve(momentum).unwrap_or_else(|| V3::repeat(f64::NAN));
        if self.flaw == Flaw::SpinReversed { -spin } else { spin }
    }

    /// Where Ω, F and τ come from.
    fn stage(&self, t: f64, state: &State, spin: V3) -> Stage {
        let (origin, velocity) = match self.pivot {
            Some(pivot) => (pivot, V3::zeros()),
            None => (state.position, state.velocity),
        };
        let spin_of_points = match self.flaw {
            Flaw::VelocityWithoutSpin => V3::zeros(),
            Flaw::VelocityWithWrongSign => -spin,
            _ => spin,
        };
        let cloud = Cloud {
            arms: Arms::Listed(&state.arms),
            levers: Arms::Listed(if self.flaw == Flaw::StaleLever { &self.start_arms } else { &state.arms }),
            masses: &self.masses,
            origin,
            velocity,
            spin: spin_of_points,
            mass: self.masses.iter().sum(),
            inertia: self.inertia(&state.arms),
            center: V3::zeros(),
            axes: Matrix3::identity(),
        };
        let Load { force, mut torque } = self.system.forces.load_on_points(t, &cloud);
        match self.flaw {
            Flaw::ArmFromWorldOrigin => torque += origin.cross(&force),
            Flaw::TorqueDropped => torque = V3::zeros(),
            Flaw::TorqueOfWrongSign => torque = -torque,
            _ => {}
        }
        Stage { spin, force, torque }
    }

    fn rotation(&self, spin: &V3, s: f64) -> Matrix3<f64> {
        let mut angle = spin.norm() * s;
        if self.flaw == Flaw::SinglePrecisionAngle {
            angle = f64::from(angle as f32);
        }
        if angle == 0.0 {
            return Matrix3::identity();
        }
        let axis = spin / spin.norm();
        let k = axis.cross_matrix();
        let exact = |angle: f64| Matrix3::identity() + k * angle.sin() + k * k * (1.0 - angle.cos());
        match self.flaw {
            Flaw::RotationTransposed => exact(angle).transpose(),
            Flaw::Cayley => exact(2.0 * (angle / 2.0).atan()),
            Flaw::SineOfAngle => exact(angle.sin()),
            Flaw::RotationToSecondOrder => Matrix3::identity() + k * angle + k * k * (angle * angle / 2.0),
            Flaw::IdentityBelowAThousandth if angle < 1e-3 => Matrix3::identity(),
            Flaw::AngleModuloPi => exact(angle % std::f64::consts::PI),
            Flaw::AngleClamped => exact(angle.min(std::f64::consts::PI)),
            _ => exact(angle),
        }
    }

    fn turned(&self, arms: &[V3], spin: &V3, s: f64) -> Vec<V3> {
        let rotation = self.rotation(spin, s);
        arms.iter().map(|arm| rotation * arm).collect()
    }

    fn step(&self, t: f64, h: f64, state: &mut State) {
        use Flaw as D;
        let d = self.flaw;
        let mass: f64 = match d {
            D::MassAsNumberOfPoints => self.masses.len() as f64,
            _ => self.masses.iter().sum(),
        };
        let over_mass = if d == D::ForceNotOverMass { 1.0 } else { mass };
        let inertia = self.inertia(&state.arms);
        let k0 = self.stage(t, state, self.spin(&inertia, &state.momentum));
        let half_angle = match d {
            D::HalfStageWithFullAngle => h,
            D::NoRotationInHalfStage => 0.0,
            _ => h / 2.0,
        };
        let half_drift = if d == D::PositionHalfWithFullStep { h } else { h / 2.0 };
        let half_kick = if d == D::VelocityHalfWithFullStep { h } else { h / 2.0 };
        let half = State {
            arms: self.turned(&state.arms, &k0.spin, half_angle), // (1)
            position: state.position + state.velocity * half_drift, // (2)
            velocity: state.velocity + k0.force * (half_kick / over_mass), // (3)
            momentum: state.momentum + k0.torque * if d == D::Step4WithFullStep { h } else { h / 2.0 }, // (4)
        };
        let half_inertia = if d == D::HalfSpinFromStartInertia { inertia } else { self.inertia(&half.arms) };
        let half_momentum = if d == D::HalfSpinFromStartMomentum { state.momentum } else { half.momentum };
        let half_time = match d {
            D::HalfStageForcesAtStart => t,
            D::HalfStageForcesAtEnd => t + h,
            _ => t + h / 2.0,
        };
        let k1 = self.stage(half_time, &half, self.spin(&half_inertia, &half_momentum));
        let spin = match d {
            D::SpinOfStartIn5 => k0.spin,
            D::SpinKeptForTwoSteps if (t / h).round() as u64 % 2 == 1 => k0.spin,
            D::HeunCorrector => self.heun_spin(t, h, state, &k0),
            _ => k1.spin,
        };
        let from = if d == D::Step5FromHalfPoints { &half.arms } else { &state.arms };
        let angle = if d == D::HalfAngleIn5 { h / 2.0 } else { h };
        let force = if d == D::ForceOfStartIn7 { k0.force } else { k1.force };
        let torque = if d == D::TorqueOfStartIn8 { k0.torque } else { k1.torque };
        let whole_kick = if d == D::HalfStepIn7 { h / 2.0 } else { h };
        let velocity = state.velocity + force * (whole_kick / over_mass); // (7)
        let drift = match d {
            D::VelocityOfStartIn6 => state.velocity,
            D::TrapezoidIn6 => (state.velocity + velocity) * 0.5,
            D::PositionTwice => half.velocity * (1.0 + h),
            D::DriftWithNewVelocity => velocity,
            _ => half.velocity,
        };
        let mut momentum = state.momentum + torque * if d == D::HalfStepIn8 { h / 2.0 } else { h }; // (8)
        if d == D::MomentumRenormalised {
            momentum *= state.momentum.norm() / momentum.norm();
        }
        let mut arms = self.turned(from, &spin, angle); // (5)
        if d == D::SinglePrecisionArms {
            arms.iter_mut().for_each(|arm| *arm = arm.map(|x| f64::from(x as f32)));
        }
        let position = state.position + drift * h; // (6)
        let energy = 0.5 * k0.spin.dot(&state.momentum);
        *state = State { arms, position, velocity, momentum };
        if d == D::EnergyProjection {
            let after = 0.5 * self.spin(&self.inertia(&state.arms), &state.momentum).dot(&state.momentum);
            state.momentum *= (energy / after).sqrt();
        }
    }

    /// The mean of Ω at the start and at the end of an Euler step.
    fn heun_spin(&self, _t: f64, h: f64, state: &State, k0: &Stage) -> V3 {
        let end = self.turned(&state.arms, &k0.spin, h);
        let momentum = state.momentum + k0.torque * h;
        (k0.spin + self.spin(&self.inertia(&end), &momentum)) * 0.5
    }

    fn observe(&self, t: f64, state: &State) -> Snapshot {
        let orientation: UnitQuaternion<f64> = rotation::best_fit(&self.body_arms, &state.arms, &self.masses);
        let spin = self.spin(&self.inertia(&state.arms), &state.momentum);
        let (position, velocity) = match self.pivot {
            Some(pivot) => {
                let total: f64 = self.masses.iter().sum();
                let center: V3 = state.arms.iter().zip(&self.masses).map(|(a, m)| a * (*m / total)).sum();
                (pivot + center, spin.cross(&center))
            }
            None => (state.position, state.velocity),
        };
        let stretch = state
            .arms
            .iter()
            .zip(&self.body_arms)
            .map(|(now, before)| (now.norm() - before.norm()).abs() / self.system.body.extent())
            .fold(0.0, f64::max);
        let angular_momentum = state.momentum;
        Snapshot {
            time: t,
            position,
            velocity,
            orientation,
            angular_velocity: spin,
            angular_momentum,
            stretch,
        }
    }
}
