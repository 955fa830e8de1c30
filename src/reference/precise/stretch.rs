//! A stretch of a motion on which no contact is made or lost, as a Taylor series, and where it ends.
//!
//! What must be above zero for a contact to hold is a series too. Its first term tells whether it is above zero after the start,
//! its changes of sign when the stretch ends. What ended the stretch before is zero at the start to a rounding of the terms that
//! it was the sum of, and so is all else that made or lost its contact at the same moment.

use super::crossings::Polynomial;
use super::double_double::DoubleDouble;
use super::problem::{Branch, Problem};
use super::tape::Series;

/// Part of a depth or a push that is the rounding of what it is the difference of.
const NEGLIGIBLE: f64 = 64.0 * DoubleDouble::ROUNDING;

/// A moment at which a contact is made or lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Switch {
    /// After the start of the stretch.
    pub after: DoubleDouble,
    contact: usize,
    guard: usize,
}

/// The terms of a guard are no numbers of f64.
#[derive(Debug)]
pub(super) struct Overflow;

/// A branch of the equations and its series.
pub(super) struct Stretch {
    touching: Vec<bool>,
    branch: Branch,
    pub series: Series,
    order: usize,
    /// What of each guard is no more than rounding at the start.
    zero: Vec<Vec<f64>>,
}

impl Stretch {
    /// The branch in which nothing touches, before a start that is exact.
    pub(super) fn new(problem: &Problem, order: usize) -> Stretch {
        Stretch::of(problem, Vec::new(), order, Vec::new())
    }

    fn of(problem: &Problem, mut touching: Vec<bool>, order: usize, mut zero: Vec<Vec<f64>>) -> Stretch {
        let branch = problem.branch(&touching);
        touching.resize(branch.contacts.len(), false);
        zero.resize_with(branch.contacts.len(), || vec![0.0; 2]);
        let series = branch.tape.series(order);
        Stretch { touching, branch, series, order, zero }
    }

    /// Multiply-adds of a step.
    pub(super) fn work(&self) -> f64 {
        (self.branch.tape.products() * self.order * self.order / 2).max(1) as f64
    }

    /// Number of points that may touch.
    pub(super) fn contacts(&self) -> usize {
        self.touching.len()
    }

    /// Develops `state` in the branch that it goes on in; the number of contacts made or lost, and nothing where none of
    /// so many branches as there are contacts is the one.
    pub(super) fn develop(&mut self, problem: &Problem, state: &[DoubleDouble]) -> Option<usize> {
        let mut switched = 0;
        // A force that sets in may push another point off: then once more.
        for _ in 0..self.contacts() + 2 {
            self.series.develop(state);
            let after: Vec<bool> = (0..self.contacts()).map(|contact| self.touches_after(contact)).collect();
            let changed = after.iter().zip(&self.touching).filter(|(a, b)| a != b).count();
            if changed == 0 {
                return Some(switched);
            }
            switched += changed;
            *self = Stretch::of(problem, after, self.order, std::mem::take(&mut self.zero));
        }
        None
    }

    /// The variables at the end of a `stride` that a switch ended, or none did.
    pub(super) fn end(&mut self, stride: DoubleDouble, switch: Option<Switch>) -> Vec<DoubleDouble> {
        let contacts = self.branch.contacts.iter();
        let size = |(place, size): &(usize, f64)| {
            let terms = Polynomial::size(&self.series.coefficients(*place), stride.high);
            if switch.is_some() { NEGLIGIBLE * (size + terms) } else { 0.0 }
        };
        self.zero = contacts.map(|guards| guards.iter().map(size).collect()).collect();
        if let Some(Switch { contact, guard, .. }) = switch {
            self.zero[contact][guard] = f64::INFINITY;
        }
        self.series.state(stride)
    }

    /// A guard of a contact until `end`; nothing where it is zero throughout.
    fn polynomial(&self, contact: usize, guard: usize, end: f64) -> Option<Polynomial> {
        let (place, size) = self.branch.contacts[contact][guard];
        let coefficients = self.series.coefficients(place);
        let negligible = NEGLIGIBLE * (size + coefficients[0].high.abs());
        Polynomial::reduced(&coefficients, self.zero[contact][guard], end, negligible)
    }

    fn guards(&self, contact: usize) -> std::ops::Range<usize> {
        0..self.branch.contacts[contact].len()
    }

    fn touches_after(&self, contact: usize) -> bool {
        let positive = |guard| self.polynomial(contact, guard, 1.0).is_some_and(|p| p.starts_positive());
        self.guards(contact).all(positive)
    }

    /// The first contact that is made or lost before `end`.
    pub(super) fn first_switch(&self, end: f64) -> Result<Option<Switch>, Overflow> {
        let switches = (0..self.contacts()).filter_map(|contact| self.switch(contact, end).transpose());
        let switches = switches.collect::<Result<Vec<Switch>, Overflow>>()?;
        Ok(switches.into_iter().min_by(|a, b| compare(a.after, b.after)))
    }

    fn switch(&self, contact: usize, end: f64) -> Result<Option<Switch>, Overflow> {
        let polynomials = self.guards(contact).map(|guard| self.polynomial(contact, guard, end));
        let Some(polynomials) = polynomials.collect::<Option<Vec<Polynomial>>>() else { return Ok(None) };
        if !polynomials.iter().all(Polynomial::is_finite) {
            return Err(Overflow);
        }
        let mut positive: Vec<bool> = polynomials.iter().map(Polynomial::starts_positive).collect();
        let crossings = |(guard, p): (usize, &Polynomial)| {
            p.crossings().into_iter().map(move |after| Switch { after, contact, guard })
        };
        let mut crossings: Vec<Switch> = polynomials.iter().enumerate().flat_map(crossings).collect();
        crossings.sort_by(|a, b| compare(a.after, b.after));
        Ok(crossings.into_iter().find(|switch| {
            positive[switch.guard] = !positive[switch.guard];
            positive.iter().all(|positive| *positive) != self.touching[contact]
        }))
    }
}

fn compare(a: DoubleDouble, b: DoubleDouble) -> std::cmp::Ordering {
    a.high.total_cmp(&b.high).then(a.low.total_cmp(&b.low))
}
