//! A system as equations on a tape, and what of a motion is read off them.
//!
//! ```text
//! (1) X' = U,  U' = F/M                   not with a pivot
//! (2) q' = ½ (0, Ω) ⊗ q,  Ω = R I⁻¹ Rᵀ L
//! (3) L' = τ                              about the origin, world axes
//! (4) c' = −ω s,  s' = ω c                cos and sin of every angle ωt that a law has
//! ```
//!
//! The system's own f64 numbers are taken as exact: of a body given by mass points their masses and places, of which
//! centre and inertia are summed anew, of one given by its inertia that; and the start, whose quaternion is brought to
//! length one. I⁻¹ is the cofactor inverse; of a rod along d it is (E − d dᵀ)/s with
//! s = ½ tr I; of a point 0. Without torque L is a constant, and stays so to the last digit. Against the equations
//! of the other references, which turn ω in body axes, this is a second transcription with other variables.

use nalgebra::Vector3;

use super::contact::{Contacts, Guard};
use super::double_double::DoubleDouble;
use super::laws::{self, Load, Motion, Phase};
use super::matter::{Matter, nudged};
use super::scale::Scale;
use super::sheet::{Node, Sheet};
use super::tape::Tape;
use super::triple::{Columns, Triple};
use crate::model::System;
use crate::model::body::{Body, Shape};
use crate::model::forces::Law;
use crate::rotation::Rotation;

/// Numbers that are read off a state: X_cm 3, U_cm 3, R column by column 9, Ω 3, L 3.
pub(super) const SHOWN: usize = 21;

/// A system as equations, and where it starts.
pub(super) struct Problem<'a> {
    system: &'a System,
    matter: Matter,
    nudge: f64,
    pub scale: Scale,
    /// What is shown of a state, in place of rates.
    pub shown: Tape,
    /// The variables at t = 0, in units.
    pub start: Vec<DoubleDouble>,
    /// Size of each variable, in units.
    pub sizes: Vec<f64>,
    /// Place of the quaternion among the variables.
    pub quaternion: Option<usize>,
}

/// The equations while the contacts with the ground are what they are.
pub(super) struct Branch {
    /// The rates.
    pub tape: Tape,
    /// What must be above zero for each contact to hold: places on the tape, and the size of what each is the
    /// difference of.
    pub contacts: Vec<Vec<(usize, f64)>>,
}

/// Variables as they are written on the sheet.
#[derive(Default)]
struct Variables {
    start: Vec<DoubleDouble>,
    sizes: Vec<f64>,
}

impl Variables {
    fn add(&mut self, values: &[DoubleDouble], size: f64) {
        self.start.extend(values);
        self.sizes.extend(values.iter().map(|_| size));
    }
}

impl<'a> Problem<'a> {
    /// The equations of `system` for a run of `duration` [s], with inertia and L off by `nudge` of themselves, and the
    /// place and velocity of a body on the ground.
    pub(super) fn of(system: &'a System, duration: f64, nudge: f64) -> Problem<'a> {
        Problem::in_units(system, Scale::of(system, duration), nudge)
    }

    /// The same in units that are given.
    pub(super) fn in_units(system: &'a System, scale: Scale, nudge: f64) -> Problem<'a> {
        let sheet = Sheet::default();
        let matter = Matter::of(&system.body, &scale).nudged(nudge);
        let mut variables = Variables::default();
        let place = Place::new(&sheet, system, &scale, &matter, &mut variables, nudge);
        let _ = phases(&sheet, system, &scale, &mut variables);
        let motion = place.motion(&sheet, system, &scale, &matter);
        let mut shown = (motion.origin + motion.axes.of(matter.center)).0.to_vec();
        shown.extend((motion.velocity + motion.turning.of(matter.center)).0);
        shown.extend(motion.axes.0.iter().flat_map(|column| column.0));
        shown.extend(place.spin.0.into_iter().chain(place.momentum.0));
        let (shown, quaternion) = (sheet.tape(&shown, &[]), place.quaternion);
        let Variables { start, sizes } = variables;
        Problem { system, matter, nudge, scale, shown, start, sizes, quaternion }
    }

    /// The equations of a piece of the motion between two jumps of the laws, with the same variables and units.
    pub(super) fn of_piece<'b>(&self, system: &'b System, state: &[DoubleDouble]) -> Problem<'b> {
        Problem { start: state.to_vec(), ..Problem::in_units(system, self.scale, self.nudge) }
    }

    /// The system that it is made of.
    pub(super) fn system(&self) -> &'a System {
        self.system
    }

    /// The equations with these contacts; none holds beyond the end of the list.
    pub(super) fn branch(&self, touching: &[bool]) -> Branch {
        let (sheet, mut variables) = (Sheet::default(), Variables::default());
        let Problem { system, matter, scale, .. } = self;
        let place = Place::new(&sheet, system, scale, matter, &mut variables, self.nudge);
        let phases = phases(&sheet, system, scale, &mut variables);
        let motion = place.motion(&sheet, system, scale, matter);
        let mut contacts = Contacts { touching, guards: Vec::new() };
        let load = total(&motion, &phases, &mut contacts);
        let mut rates = Vec::new();
        if !system.body.pivoted {
            rates.extend(motion.velocity.0);
            rates.extend(load.force.scaled(DoubleDouble::ONE / matter.mass).0); // (1)
        }
        if place.quaternion.is_some() {
            rates.extend(turning(place.attitude, place.spin)); // (2)
        }
        if place.momentum_varies {
            rates.extend(load.torque.0); // (3)
        }
        for phase in phases.iter().flatten() {
            rates.extend([-phase.sine.times(phase.rate), phase.cosine.times(phase.rate)]); // (4)
        }
        let watched: Vec<Node> = contacts.guards.iter().flatten().map(|guard| guard.node).collect();
        let placed = |guard: &Guard| (guard.node.place(), guard.size);
        let contacts = contacts.guards.iter().map(|guards| guards.iter().map(placed).collect()).collect();
        Branch { tape: sheet.tape(&rates, &watched), contacts }
    }

    /// Brings the quaternion among variables to length one: a rounding error that no rate sees would grow.
    pub(super) fn normalize(&self, state: &mut [DoubleDouble]) {
        let Some(first) = self.quaternion else { return };
        let q = &mut state[first..first + 4];
        let length = q.iter().fold(DoubleDouble::ZERO, |sum, x| sum + *x * *x).sqrt();
        q.iter_mut().for_each(|x| *x = *x / length);
    }
}

fn unit_quaternion(orientation: &Rotation) -> [DoubleDouble; 4] {
    let values = [orientation.w, orientation.i, orientation.j, orientation.k].map(DoubleDouble::from);
    let length = values.iter().fold(DoubleDouble::ZERO, |sum, x| sum + *x * *x).sqrt();
    values.map(|x| x / length)
}

fn total<'a>(motion: &Motion<'a>, phases: &[Option<Phase<'a>>], contacts: &mut Contacts<'a, '_>) -> Load<'a> {
    let none = Triple::zero(motion.sheet);
    let mut total = Load { force: none, torque: none };
    for (law, phase) in motion.system.forces.laws().iter().zip(phases) {
        let load = motion.load(law, *phase, contacts);
        total = Load { force: total.force + load.force, torque: total.torque + load.torque };
    }
    total
}

/// ½ (0, Ω) ⊗ q.
fn turning<'a>(q: [Node<'a>; 4], spin: Triple<'a>) -> [Node<'a>; 4] {
    let [w, x, y, z] = q;
    let [a, b, c] = spin.0.map(|x| x.times(0.5));
    [-(a * x + b * y + c * z), a * w + b * z - c * y, b * w + c * x - a * z, c * w + a * y - b * x]
}

/// One for each law.
fn phases<'a>(
    sheet: &'a Sheet,
    system: &System,
    scale: &Scale,
    variables: &mut Variables,
) -> Vec<Option<Phase<'a>>> {
    let laws = system.forces.laws().iter();
    laws.map(|law| phase(sheet, laws::rate(law).scaled(scale.time), variables)).collect()
}

fn phase<'a>(sheet: &'a Sheet, rate: DoubleDouble, variables: &mut Variables) -> Option<Phase<'a>> {
    (rate.high != 0.0).then(|| {
        variables.add(&[DoubleDouble::ONE, DoubleDouble::ZERO], 1.0);
        Phase { rate, cosine: sheet.variable(), sine: sheet.variable() }
    })
}

/// Where the body is, on the sheet.
struct Place<'a> {
    origin: Triple<'a>,
    velocity: Triple<'a>,
    attitude: [Node<'a>; 4],
    axes: Columns<'a>,
    spin: Triple<'a>,
    momentum: Triple<'a>,
    quaternion: Option<usize>,
    momentum_varies: bool,
}

impl<'a> Place<'a> {
    fn new(
        sheet: &'a Sheet,
        system: &System,
        scale: &Scale,
        matter: &Matter,
        variables: &mut Variables,
        nudge: f64,
    ) -> Place<'a> {
        let (body, start) = (&system.body, &system.start);
        let plain = |v: &Vector3<f64>, dimension| v.map(|x| scale.plain(x, dimension));
        let of = |v: Vector3<f64>| [v.x, v.y, v.z].map(DoubleDouble::from);
        let (mut origin, mut velocity) =
            (Triple::constant(sheet, &plain(&system.origin(), [0, 1, 0])), Triple::zero(sheet));
        if !body.pivoted {
            // When a point touches depends on where the body starts, to a rounding.
            let touches = system.forces.laws().iter().any(|law| matches!(law, Law::Ground(_)));
            let off = |v: Vector3<f64>| of(v).map(|x| if touches { nudged(x, nudge) } else { x });
            variables.add(&off(plain(&start.position, [0, 1, 0])), 1.0);
            variables.add(&off(plain(&start.velocity, [0, 1, -1])), scale.speed);
            (origin, velocity) = (Triple::variable(sheet), Triple::variable(sheet));
        }
        let values = unit_quaternion(&start.orientation);
        let turns = body.shape != Shape::Point;
        let quaternion = turns.then_some(variables.start.len());
        let attitude = if turns {
            variables.add(&values, 1.0);
            std::array::from_fn(|_| sheet.variable())
        } else {
            values.map(|x| sheet.constant(x))
        };
        let pushed = |law: &Law| !matches!(law, Law::Gravity(_));
        let momentum_varies = turns && (body.pivoted || system.forces.laws().iter().any(pushed));
        let [x, y, z] = of(plain(&start.angular_momentum, [1, 2, -1]));
        let values = [nudged(x, nudge), nudged(y, -nudge), nudged(z, nudge)];
        let momentum = if momentum_varies {
            variables.add(&values, scale.momentum);
            Triple::variable(sheet)
        } else {
            Triple(values.map(|x| sheet.constant(x)))
        };
        let axes = Columns::of_quaternion(attitude);
        let spin = spin(sheet, body, matter, axes, momentum);
        Place { origin, velocity, attitude, axes, spin, momentum, quaternion, momentum_varies }
    }

    fn motion(
        &self,
        sheet: &'a Sheet,
        system: &'a System,
        scale: &'a Scale,
        matter: &'a Matter,
    ) -> Motion<'a> {
        let Place { axes, origin, velocity, spin, .. } = *self;
        Motion { sheet, system, scale, matter, axes, turning: axes.turning(spin), origin, velocity, spin }
    }
}

/// Ω = R I⁻¹ Rᵀ L.
fn spin<'a>(
    sheet: &'a Sheet,
    body: &Body,
    matter: &Matter,
    axes: Columns<'a>,
    momentum: Triple<'a>,
) -> Triple<'a> {
    let inverse = match body.shape {
        Shape::Point => return Triple::zero(sheet),
        Shape::Rod { direction } => matter.inverse_of_rod(body, direction),
        Shape::Extended => matter.inverse(),
    };
    let [x, y, z] = axes.transposed_times(momentum).0;
    axes.times(Triple(inverse.map(|[a, b, c]| x.times(a) + y.times(b) + z.times(c))))
}
