//! The force laws once more, on a tape: written from their formulas, not from the code that schemes run.
//!
//! Every mass point and every spring is visited; a place x in the body stands at R x from the origin and moves with
//! U + [Ω]× R x. Angles ωt enter as pairs cos ωt, sin ωt, two variables of the equations. The ground is in
//! [`super::contact`].

use nalgebra::Vector3;

use super::contact::Contacts;
use super::double_double::DoubleDouble;
use super::matter::Matter;
use super::scale::Scale;
use super::sheet::{Node, Sheet};
use super::triple::{Columns, Triple};
use crate::model::System;
use crate::model::forces::{
    Attachment, Dipole, GravityGradient, Law, Lorentz, OrbitingDipole, PerPoint, RotationalDamping, Spring,
    Torque, TorqueAxes, TorquePulse, Wheels,
};

/// cos ωt and sin ωt.
#[derive(Clone, Copy)]
pub(super) struct Phase<'a> {
    pub rate: DoubleDouble,
    pub cosine: Node<'a>,
    pub sine: Node<'a>,
}

/// A force and its torque about the origin, world axes.
#[derive(Clone, Copy)]
pub(super) struct Load<'a> {
    pub force: Triple<'a>,
    pub torque: Triple<'a>,
}

/// The body in motion, in units of the tape.
#[derive(Clone, Copy)]
pub(super) struct Motion<'a> {
    pub sheet: &'a Sheet,
    pub system: &'a System,
    pub scale: &'a Scale,
    pub matter: &'a Matter,
    /// Takes body axes to world axes.
    pub axes: Columns<'a>,
    /// Takes a place in the body to its velocity about the origin.
    pub turning: Columns<'a>,
    pub origin: Triple<'a>,
    pub velocity: Triple<'a>,
    /// Ω.
    pub spin: Triple<'a>,
}

/// The angular rate that a law turns with [rad/s], and 0 where it does not depend on time.
pub(super) fn rate(law: &Law) -> DoubleDouble {
    match law {
        Law::Lorentz(lorentz) if !lorentz.is_static() => lorentz.frequency.into(),
        Law::Torque(torque) => torque.frequency.into(),
        Law::GravityGradient(gradient) => length(&gradient.normal) * gradient.rate.into(),
        Law::OrbitingDipole(dipole) => dipole.frequency.into(),
        Law::Gravity(_) | Law::Spring(_) | Law::Drag(_) | Law::CentralGravity(_) => DoubleDouble::ZERO,
        Law::Lorentz(_) | Law::Dipole(_) | Law::Ground(_) => DoubleDouble::ZERO,
        Law::RotationalDamping(_) | Law::Wheels(_) | Law::MassCenterGravity(_) => DoubleDouble::ZERO,
        Law::TorquePulse(_) => DoubleDouble::ZERO,
    }
}

fn length(v: &Vector3<f64>) -> DoubleDouble {
    let square = |x: f64| DoubleDouble::from(x) * DoubleDouble::from(x);
    (square(v.x) + square(v.y) + square(v.z)).sqrt()
}

impl<'a> Motion<'a> {
    /// What `law` does; `phase` turns at its [`rate`].
    pub(super) fn load(
        &self,
        law: &Law,
        phase: Option<Phase<'a>>,
        contacts: &mut Contacts<'a, '_>,
    ) -> Load<'a> {
        let none = Triple::zero(self.sheet);
        let torque = |torque| Load { force: none, torque };
        match law {
            Law::Gravity(gravity) => {
                let weight = self.constant(&gravity.acceleration, [0, 1, -2]).scaled(self.matter.mass);
                let torque = self.axes.of(self.matter.center).cross(weight);
                Load { force: weight, torque }
            }
            Law::Spring(spring) => self.spring(spring),
            Law::Drag(drag) => self.on_points(|motion, k, x| {
                let coefficient = motion.scale.plain(drag.coefficient.at(k), [1, 0, -1]);
                motion.velocity_of(x).scaled(-coefficient)
            }),
            Law::CentralGravity(central) => self.on_points(|motion, k, x| {
                let mass = motion.scale.plain(motion.system.body.points[k].mass, [1, 0, 0]);
                let place = motion.origin + motion.arm(x);
                motion.attraction(central.mu, &central.center, place).scaled(mass)
            }),
            Law::MassCenterGravity(central) => {
                let arm = self.axes.of(self.matter.center);
                let pull = self.attraction(central.mu, &central.center, self.origin + arm);
                let force = pull.scaled(self.matter.mass);
                Load { force, torque: arm.cross(force) }
            }
            Law::Lorentz(lorentz) => self.lorentz(lorentz, phase),
            Law::Torque(law) => torque(self.torque(law, phase)),
            Law::Dipole(dipole) => torque(self.dipole(dipole)),
            Law::OrbitingDipole(dipole) => torque(self.orbiting_dipole(dipole, phase)),
            Law::TorquePulse(pulse) => torque(self.pulse(pulse)),
            Law::RotationalDamping(damping) => torque(self.damping(damping)),
            Law::Wheels(wheels) => torque(self.wheels(wheels)),
            Law::GravityGradient(gradient) => torque(self.gradient(gradient, phase)),
            Law::Ground(ground) => self.ground(ground, contacts),
        }
    }

    fn constant(&self, v: &Vector3<f64>, dimension: [i32; 3]) -> Triple<'a> {
        Triple::constant(self.sheet, &v.map(|x| self.scale.plain(x, dimension)))
    }

    /// A place in the body [m] from the origin, world axes, in units.
    pub(super) fn arm(&self, x: &Vector3<f64>) -> Triple<'a> {
        self.axes.of(self.place(x))
    }

    fn place(&self, x: &Vector3<f64>) -> [DoubleDouble; 3] {
        [x.x, x.y, x.z].map(|x| self.scale.plain(x, [0, 1, 0]).into())
    }

    pub(super) fn velocity_of(&self, x: &Vector3<f64>) -> Triple<'a> {
        self.velocity + self.turning.of(self.place(x))
    }

    fn acting_at(&self, x: &Vector3<f64>, force: Triple<'a>) -> Load<'a> {
        Load { force, torque: self.arm(x).cross(force) }
    }

    pub(super) fn on_points(
        &self,
        mut force: impl FnMut(&Self, usize, &Vector3<f64>) -> Triple<'a>,
    ) -> Load<'a> {
        let none = Triple::zero(self.sheet);
        let mut load = Load { force: none, torque: none };
        for (k, point) in self.system.body.points.iter().enumerate() {
            let one = self.acting_at(&point.position, force(self, k, &point.position));
            load = Load { force: load.force + one.force, torque: load.torque + one.torque };
        }
        load
    }

    /// −k (|d| − rest) d/|d| − c U.
    fn spring(&self, spring: &Spring) -> Load<'a> {
        let x = match &spring.attachment {
            Attachment::Point(index) => self.system.body.points[*index].position,
            Attachment::At(position) => *position,
        };
        let stiffness = self.scale.plain(spring.stiffness, [1, 0, -2]);
        let damping = self.scale.plain(spring.damping, [1, 0, -1]);
        let d = self.origin + self.arm(&x) - self.constant(&spring.anchor, [0, 1, 0]);
        let mut pull = d.scaled(-stiffness);
        if spring.rest_length != 0.0 {
            let rest = self.sheet.constant(self.scale.plain(spring.rest_length, [0, 1, 0]) * stiffness);
            pull = pull + d.times(rest / d.dot(d).sqrt());
        }
        if damping != 0.0 {
            pull = pull - self.velocity_of(&x).scaled(damping);
        }
        self.acting_at(&x, pull)
    }

    /// −μ d/|d|³.
    fn attraction(&self, mu: f64, center: &Vector3<f64>, place: Triple<'a>) -> Triple<'a> {
        let d = place - self.constant(center, [0, 1, 0]);
        let square = d.dot(d);
        let mu = self.sheet.constant(-self.scale.plain(mu, [0, 3, -2]));
        d.times(mu / (square * square.sqrt()))
    }

    /// q (E + E_c cos ωt + E_s sin ωt + U × B).
    fn lorentz(&self, lorentz: &Lorentz, phase: Option<Phase<'a>>) -> Load<'a> {
        let field = |v| self.constant(v, [1, 1, -2]);
        let electric = oscillating(
            [field(&lorentz.electric), field(&lorentz.electric_cosine), field(&lorentz.electric_sine)],
            phase,
        );
        let magnetic = self.constant(&lorentz.magnetic, [1, 0, -1]);
        self.on_points(|motion, k, x| {
            let charge = match &lorentz.charge {
                PerPoint::Same(charge) => *charge,
                PerPoint::Each(charges) => charges[k],
            };
            (electric + motion.velocity_of(x).cross(magnetic)).scaled(charge)
        })
    }

    fn torque(&self, law: &Torque, phase: Option<Phase<'a>>) -> Triple<'a> {
        let part = |v| self.constant(v, [1, 2, -2]);
        let torque = oscillating([part(&law.constant), part(&law.cosine), part(&law.sine)], phase);
        match law.axes {
            TorqueAxes::World => torque,
            TorqueAxes::Body => self.axes.times(torque),
        }
    }

    /// A constant, or nothing: a tape holds for the time between two jumps.
    fn pulse(&self, pulse: &TorquePulse) -> Triple<'a> {
        let acts = pulse.start == f64::NEG_INFINITY && pulse.end == f64::INFINITY;
        match pulse.axes {
            _ if !acts => Triple::zero(self.sheet),
            TorqueAxes::World => self.constant(&pulse.torque, [1, 2, -2]),
            TorqueAxes::Body => self.in_body(&pulse.torque, [1, 2, -2]),
        }
    }

    /// m × B.
    fn dipole(&self, dipole: &Dipole) -> Triple<'a> {
        self.in_body(&dipole.moment, [1, 2, -2]).cross(Triple::constant(self.sheet, &dipole.field))
    }

    /// m × (B₀ + B_c cos ωt + B_s sin ωt).
    fn orbiting_dipole(&self, dipole: &OrbitingDipole, phase: Option<Phase<'a>>) -> Triple<'a> {
        let parts = [dipole.field, dipole.field_cosine, dipole.field_sine];
        let field = oscillating(parts.map(|part| Triple::constant(self.sheet, &part)), phase);
        self.in_body(&dipole.moment, [1, 2, -2]).cross(field)
    }

    /// −Σ c_j (Ω·R e_j), with c_j = R C e_j, column by column.
    fn damping(&self, damping: &RotationalDamping) -> Triple<'a> {
        let column = |j: usize| self.in_body(&damping.coefficients.column(j).into(), [1, 2, -1]);
        let part = |j: usize| column(j).times(self.axes.0[j].dot(self.spin));
        (part(0) + part(1) + part(2)).scaled(-1.0)
    }

    /// −Ω × R h.
    fn wheels(&self, wheels: &Wheels) -> Triple<'a> {
        self.spin.cross(self.in_body(&wheels.momentum, [1, 2, -1])).scaled(-1.0)
    }

    /// A vector of the body, world axes, in units.
    fn in_body(&self, v: &Vector3<f64>, dimension: [i32; 3]) -> Triple<'a> {
        self.axes.of([v.x, v.y, v.z].map(|x| self.scale.plain(x, dimension).into()))
    }

    /// 3 μ/r³ r̂ × I r̂, with r̂ = a (a·r̂₀) + (r̂₀ − a (a·r̂₀)) cos + a × r̂₀ sin, turning about a.
    fn gradient(&self, gradient: &GravityGradient, phase: Option<Phase<'a>>) -> Triple<'a> {
        let normal = Triple::constant(self.sheet, &gradient.normal);
        let axis = normal.scaled(DoubleDouble::ONE / length(&gradient.normal));
        let start = Triple::constant(self.sheet, &gradient.direction);
        let along = axis.times(axis.dot(start));
        let direction = oscillating([along, start - along, axis.cross(start)], phase);
        let body_direction = self.axes.transposed_times(direction);
        let columns = self.matter.inertia.map(|row| Triple(row.map(|x| self.sheet.constant(x))));
        let turned = Columns(columns).times(body_direction);
        let strength = DoubleDouble::from(3.0) * self.scale.plain(gradient.mu_over_r3, [0, 0, -2]).into();
        self.axes.times(body_direction.cross(turned)).scaled(strength)
    }
}

/// constant + cosine cos ωt + sine sin ωt; at rest, the first two.
fn oscillating<'a>(parts: [Triple<'a>; 3], phase: Option<Phase<'a>>) -> Triple<'a> {
    let [constant, cosine, sine] = parts;
    match phase {
        Some(phase) => constant + cosine.times(phase.cosine) + sine.times(phase.sine),
        None => constant + cosine,
    }
}
