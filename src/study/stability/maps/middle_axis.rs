//! Growth of a small wobble about the middle axis, against λ = Ω₂ √((I₂ − I₁)(I₃ − I₂)/(I₁ I₃)).

use nalgebra::Vector3;

use super::free::spinning;
use super::{Grid, linear, logarithmic};
use crate::model::Snapshot;
use crate::record::stability::Map;
use crate::simulate::{Contestant, Plan};
use crate::study::ensemble::{Ensemble, Member};
use crate::study::stability::theory;

/// Size of the wobble at the start.
const WOBBLE: f64 = 1e-7;
/// e-foldings of a run, by theory.
const FOLDINGS: f64 = 8.0;
/// Most steps of a run.
const MOST_STEPS: f64 = 4000.0;
/// Deviation from λ that is drawn as none.
const SMALLEST_OFF: f64 = 1e-6;
/// Smallest moment over the largest.
const SMALLEST: f64 = 0.6;

/// Sizes of the wobble at half of a run and at its end.
struct Wobble {
    half: f64,
    at_half: Option<(f64, f64)>,
    last: (f64, f64),
}

impl Wobble {
    fn see(&mut self, state: &Snapshot) {
        let momentum = state.orientation.inverse_transform_vector(&state.angular_momentum);
        let size = (momentum.x.powi(2) + momentum.z.powi(2)).sqrt() / momentum.norm();
        self.last = (state.time, size);
        if state.time >= self.half && self.at_half.is_none() {
            self.at_half = Some(self.last);
        }
    }

    /// Growth rate over the second half [1/s].
    fn rate(&self) -> Option<f64> {
        let (time, size) = self.at_half?;
        (self.last.0 > time && size > 0.0).then(|| (self.last.1 / size).ln() / (self.last.0 - time))
    }
}

pub(super) fn map(contestant: &Contestant, cells: usize) -> Option<Map> {
    let moments = |part: f64| [SMALLEST, SMALLEST + (1.0 - SMALLEST) * part, 1.0];
    let system = |part: f64| spinning(Vector3::from(moments(part)), Vector3::new(WOBBLE, 1.0, -WOBBLE));
    contestant.refusal(&system(0.5)?).is_none().then_some(())?;
    let x = logarithmic("step |Ω|h", "rad", 0.02, std::f64::consts::PI);
    let y = linear("(I₂ − I₁)/(I₃ − I₁) at I₁/I₃ = 0.6", "1", 0.0, 1.0);
    let mut map = Grid { x, y, cells }.fill(|part, turns| {
        let theory = theory::middle_axis_growth(moments(part), 1.0);
        let plan = |turn: f64| {
            let steps = (FOLDINGS / (theory * turn)).clamp(8.0, MOST_STEPS).ceil() as u64;
            Plan { step: turn, steps, every: (steps / 16).max(1) }
        };
        let plans: Vec<Plan> = turns.iter().map(|turn| plan(*turn)).collect();
        let members =
            plans.iter().filter_map(|plan| Some(Member { system: system(part)?, plan: *plan })).collect();
        let begin = |index: usize| {
            let plan: &Plan = &plans[index];
            Wobble { half: 0.5 * plan.step * plan.steps as f64, at_half: None, last: (0.0, 0.0) }
        };
        let ends = Ensemble::new(contestant, members).fold(begin, Wobble::see);
        let taken = ends.iter().map(|end| end.1.steps).sum();
        let off = |rate: f64| (rate / theory - 1.0).abs().max(SMALLEST_OFF).log10();
        (ends.iter().map(|(wobble, _)| wobble.rate().map(off)).collect(), taken)
    });
    map.title = "Tumbling: growth of a wobble about the middle axis".to_owned();
    map.what =
        format!("log₁₀ |measured rate / λ − 1|, λ = Ω₂ √((I₂−I₁)(I₃−I₂)/(I₁I₃)), {FOLDINGS} e-foldings");
    map.edge = Some(-2.0);
    Some(map)
}
