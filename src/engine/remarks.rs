//! What is odd about the answers of an engine, though the protocol allows it.

use super::precision::Precision;
use super::reply::States;

/// Units in the last place by which rounding may put a quaternion off unit length: half of one in each of its four components, and as much
/// in the program's own normalisation.
const ROUNDING: f64 = 4.0;

/// The oddest of what was seen so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Oddest {
    /// Largest distance of the length of a quaternion from one.
    off_unit: f64,
    /// Steps of the longest run that took 0 ns.
    timeless: u64,
    /// Evaluations and steps of the run with the fewest evaluations a step that is below one.
    fewest: Option<(u64, u64)>,
}

impl Oddest {
    /// Takes in a run of so many steps.
    pub fn add(&mut self, states: &States, steps: u64) {
        self.off_unit = self.off_unit.max(states.off_unit);
        if states.nanoseconds == Some(0) {
            self.timeless = self.timeless.max(steps);
        }
        let a_step = |(evaluations, steps): (u64, u64)| evaluations as f64 / steps as f64;
        let own = (states.evaluations, steps);
        let is_below = |least: f64| states.evaluations > 0 && a_step(own) < least;
        if is_below(self.fewest.map_or(1.0, a_step)) {
            self.fewest = Some(own);
        }
    }

    /// A sentence each, of numbers of this precision.
    pub fn remarks(&self, precision: &Precision) -> Vec<String> {
        let off = (self.off_unit > ROUNDING * precision.unit()).then(|| {
            format!(
                "its quaternions are off unit length by up to {:.1e} and were normalised: normalise them in each step",
                self.off_unit
            )
        });
        let timeless = (self.timeless > 0).then(|| {
            format!(
                "a run of {} steps took 0 ns by its clock: take a finer one, or leave elapsed_ns out",
                self.timeless
            )
        });
        let fewest = self.fewest.map(|(evaluations, steps)| {
            format!(
                "{evaluations} evaluations in {steps} steps are less than one a step: count the forces, or leave evaluations out"
            )
        });
        [off, timeless, fewest].into_iter().flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn remarks(off_unit: f64, nanoseconds: Option<u64>, evaluations: u64) -> usize {
        let precision: Precision = [0.1, 0.2, 1.0 / 3.0].into_iter().collect();
        let states = States { states: Vec::new(), nanoseconds, evaluations, precision, off_unit };
        let mut oddest = Oddest::default();
        oddest.add(&states, 10);
        oddest.remarks(&precision).len()
    }

    #[test]
    fn quaternions_off_unit_length_no_time_and_half_an_evaluation_are_remarked() {
        assert_eq!(remarks(f64::EPSILON, Some(1), 10), 0);
        assert_eq!(remarks(1e-9, Some(1), 10), 1);
        assert_eq!(remarks(0.0, Some(0), 10), 1);
        assert_eq!(remarks(0.0, Some(1), 5), 1);
        // What an engine does not say is not odd.
        assert_eq!(remarks(0.0, None, 0), 0);
        assert_eq!(remarks(1e-9, Some(0), 5), 3);
    }
}
