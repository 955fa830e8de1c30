//! The same run in other worlds: turned, mirrored, shifted, boosted, in other units of mass, length and time, and with the same
//! body described in another way (points in another order, one split in two, its inertia in place of them).
//!
//! A scheme that is a rule of mechanics and not of its coordinates gives the same motion to rounding. In units that are
//! powers of two every sum, product and root is the same but for the exponent, so that the numbers agree
//! to the last bit. (The exponents are multiples of four, so that roots of roots are exact too.)
//!
//! A scheme of the list runs in double-double, a program in f64. How a rounding grows is seen in copies in f64; its unit is that of the
//! arithmetic. Where roundings of f64 grow to the size of the motion, nothing is known of how far finer ones grow: the runs are in f64 there.

use nalgebra::Vector3;

use super::copies;
use super::reversal::worst;
use super::{BELOW, CLEAR, Rung, steady_rung};
use crate::arithmetic::{DoubleDouble, Real};
use crate::model::{Broken, Change, PerQuantity, Quantity, Snapshot, System, difference, retold, sizes};
use crate::record::OtherWorld;
use crate::rotation;
use crate::simulate::{Arithmetic, Contestant, Form, Plan};

/// Most steps of a run in f64 …
const STEPS: u64 = 256;
/// … and in double-double.
const PRECISE_STEPS: u64 = 16;

/// How the turned world is turned.
const TURN: Vector3<f64> = Vector3::new(0.9, -1.3, 0.4);

/// A world with its name.
struct World<T: Real> {
    name: &'static str,
    /// From the scene's own world to this one.
    change: Change<T>,
    /// The scene in it.
    system: System<T>,
    form: Form,
    /// h in it [s].
    step: f64,
    to_the_bit: bool,
}

/// Runs the scene in other worlds, in the first steps of the coarsest run that follows the truth however it rounds; empty where there is
/// none.
pub fn other_worlds(contestant: &Contestant, system: &System, rungs: &[Rung]) -> Vec<OtherWorld> {
    let precise = contestant.runs_in_double_double();
    let most = if precise { PRECISE_STEPS } else { STEPS };
    let Some(rung) = steady_rung(contestant, system, rungs, most) else { return Vec::new() };
    let compared = Compared {
        contestant,
        system,
        step: rung.step,
        steps: rung.steps.min(most),
        solves: rung.outcome.solves as f64 / rung.steps as f64,
    };
    let (of_least, sizes) = compared.rounding(Form::Least);
    let is_lost = Quantity::ALL.into_iter().any(|of| CLEAR * of_least[of] > BELOW * sizes[of]);
    if precise && !is_lost { compared.rows::<DoubleDouble>(of_least) } else { compared.rows::<f64>(of_least) }
}

/// A run that is made in every world.
struct Compared<'a> {
    contestant: &'a Contestant,
    system: &'a System,
    /// h [s].
    step: f64,
    steps: u64,
    /// Implicit equations a step.
    solves: f64,
}

impl Compared<'_> {
    /// `of_least` is the rounding of the least model in f64.
    fn rows<T: Arithmetic>(&self, of_least: PerQuantity<f64>) -> Vec<OtherWorld> {
        let Ok(system) = System::<T>::of(self.system) else { return Vec::new() };
        let Ok(own) = self.end(&system, Form::Least, self.step) else { return Vec::new() };
        let takes_points = self.contestant.takes_points();
        let own_of_points = if takes_points { self.end(&system, Form::Points, self.step).ok() } else { None };
        let of_points = own_of_points.map(|_| self.rounding(Form::Points).0);
        let row = |world: World<T>| {
            let (own, rounding) = match world.form {
                Form::Least => (own, of_least),
                Form::Points => (own_of_points?, of_points?),
            };
            Some(self.row(&world, &system, &own, rounding))
        };
        self.worlds(&system).into_iter().chain(self.descriptions(&system)).filter_map(row).collect()
    }

    /// How far the run in a world is off.
    fn row<T: Arithmetic>(
        &self,
        world: &World<T>,
        system: &System<T>,
        own: &Snapshot<T>,
        rounding: PerQuantity<f64>,
    ) -> OtherWorld {
        let mut row = OtherWorld {
            name: world.name.to_owned(),
            to_the_bit: world.to_the_bit,
            steps: self.steps,
            solves: (self.solves * self.steps as f64).round() as u64,
            double_double: T::UNIT < f64::UNIT,
            ..OtherWorld::default()
        };
        let other = self.end(&world.system, world.form, world.step);
        row.unsolved = matches!(other, Err(Some(Broken::NoConvergence { .. })));
        if let Ok(other) = other.map(|end| world.change.undo(&end)) {
            let off = if *own == other {
                PerQuantity::all(0.0)
            } else {
                difference(&system.body, own, &other).map(T::to_f64)
            };
            let rounding =
                self.shifted(rounding, &world.change).map(|rounding| rounding * (T::UNIT / f64::UNIT));
            (row.of_rounding, row.worst) = worst(off, rounding);
        }
        row
    }

    /// The end of the run, or why it breaks.
    fn end<T: Arithmetic>(
        &self,
        system: &System<T>,
        form: Form,
        step: f64,
    ) -> Result<Snapshot<T>, Option<Broken>> {
        let mut end = None;
        let plan = Plan { step, steps: self.steps, every: self.steps };
        let outcome = self.contestant.stream_in(system, form, &plan, &mut |state| end = Some(*state));
        match outcome.broken {
            Some(broken) => Err(Some(broken.why)),
            None => end.ok_or(None),
        }
    }

    /// What rounding does to the run in f64, and how large everything gets.
    fn rounding(&self, form: Form) -> (PerQuantity<f64>, PerQuantity<f64>) {
        let plan = Plan { step: self.step, steps: self.steps, every: 1 };
        let motion = self.contestant.run(self.system, form, &plan).states;
        let spread = copies::spread(self.contestant, (self.system, form), &plan, &motion);
        let sizes = sizes(self.system, &motion);
        (copies::rounding(&spread, &sizes, (f64::EPSILON, plan.steps)), sizes)
    }

    /// What larger positions and velocities in the other world round off besides.
    fn shifted<T: Real>(&self, mut rounding: PerQuantity<f64>, change: &Change<T>) -> PerQuantity<f64> {
        let per_step = f64::EPSILON * self.steps as f64;
        let boost = rotation::length(&change.boost).to_f64();
        let shift = rotation::length(&change.shift).to_f64() + boost * self.duration();
        rounding[Quantity::Position] += per_step * shift;
        rounding[Quantity::Velocity] += per_step * boost;
        rounding[Quantity::BodyPoint] += per_step * shift;
        rounding
    }

    /// The time that the run covers [s].
    fn duration(&self) -> f64 {
        self.step * self.steps as f64
    }

    /// The same body described in other ways, on the least model and on the points.
    fn descriptions<T: Real>(&self, system: &System<T>) -> Vec<World<T>> {
        let is_of_points = system.body.is_of_its_points();
        let described = |name, system: Option<System<T>>, form| {
            let (change, step) = (Change::none(), self.step);
            system.filter(|_| is_of_points).map(|system| World {
                name,
                change,
                system,
                form,
                step,
                to_the_bit: false,
            })
        };
        [
            described("permuted", retold::permuted(system), Form::Least),
            described("split", retold::split(system), Form::Least),
            described("by-inertia", retold::by_inertia(system), Form::Least),
            described("permuted-points", retold::permuted(system), Form::Points),
            described("split-points", retold::split(system), Form::Points),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// The changes that leave a scene's laws what they are. Shift and boost are of the size of the body and of its motion.
    fn worlds<T: Real>(&self, system: &System<T>) -> Vec<World<T>> {
        let vector = |x, y, z| Vector3::new(x, y, z).map(T::of);
        let changed = |name, change: Change<T>, step| World {
            name,
            change,
            system: change.apply(system),
            form: Form::Least,
            step,
            to_the_bit: false,
        };
        let rough = |name, change| changed(name, change, self.step);
        // The change of time is that of the step, which f64 rounds.
        let units = |name, mass: f64, length: f64, time: f64| {
            let step = self.step * time;
            let time = T::of(step * self.steps as f64) / self.duration();
            let (mass, length) = (T::of(mass), T::of(length));
            changed(name, Change { mass, length, time, ..Change::none() }, step)
        };
        let extent = system.body.extent();
        let mut worlds = vec![
            rough("turned", Change { turn: rotation::turn(&TURN.map(T::of)), ..Change::none() }),
            units("mirrored", 1.0, -1.0, 1.0),
            rough("shifted", Change { shift: vector(0.75, -1.25, 0.5) * extent, ..Change::none() }),
            World { to_the_bit: true, ..units("binary-units", 16.0, 0.0625, 256.0) },
            units("mass-1e10", 1e10, 1.0, 1.0),
            units("mass-1e-10", 1e-10, 1.0, 1.0),
            units("length-1e10", 1.0, 1e10, 1.0),
            units("length-1e-10", 1.0, 1e-10, 1.0),
            units("time-1e10", 1.0, 1.0, 1e10),
            units("time-1e-10", 1.0, 1.0, 1e-10),
        ];
        if Change::may_boost(system) {
            let boost = vector(-0.5, 1.0, 0.25) * (extent / self.duration());
            worlds.push(rough("boosted", Change { boost, ..Change::none() }));
        }
        worlds
    }
}
