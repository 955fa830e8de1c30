//! Many bodies under one scheme: the same run at many steps, starts or parameters, for maps and sweeps.
//!
//! Members are independent; they are run in parallel and their results stand in their order, so that one thread or many give
//! the same numbers to the last bit.

use rayon::prelude::*;

use crate::interrupt;
use crate::model::{Broken, Snapshot, System};
use crate::simulate::{Break, Contestant, Form, Outcome, Plan};

/// One of many runs.
#[derive(Clone, Debug)]
pub struct Member {
    /// Body, forces and start.
    pub system: System,
    /// Step, number of steps, and how often a state is seen.
    pub plan: Plan,
}

/// Many runs of one scheme.
pub struct Ensemble<'a> {
    contestant: &'a Contestant,
    members: Vec<Member>,
}

impl<'a> Ensemble<'a> {
    /// Runs of `contestant`.
    pub fn new(contestant: &'a Contestant, members: Vec<Member>) -> Ensemble<'a> {
        Ensemble { contestant, members }
    }

    /// Number of runs.
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// Runs all. `begin` makes what is kept of a member from its index; `see` is handed the first state, every K-th and the last.
    /// A run that breaks is a row like any other; where the user asks for the end, those that had not begun are broken by it.
    pub fn fold<T: Send>(
        &self,
        begin: impl Fn(usize) -> T + Sync,
        see: impl Fn(&mut T, &Snapshot) + Sync,
    ) -> Vec<(T, Outcome)> {
        let one = |(index, member): (usize, &Member)| {
            let mut kept = begin(index);
            if interrupt::requested() {
                let broken = Some(Break { step: 0, time: 0.0, why: Broken::Interrupted });
                return (kept, Outcome { broken, ..Outcome::none_yet() });
            }
            let outcome =
                self.contestant.stream(&member.system, Form::Least, &member.plan, &mut |snapshot| {
                    see(&mut kept, snapshot);
                });
            (kept, outcome)
        };
        self.members.par_iter().enumerate().map(one).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::Scene;
    use crate::schemes::PeskinRk2;

    #[test]
    fn members_are_the_runs_that_they_stand_for_in_their_order() {
        let contestant = Contestant::new::<PeskinRk2>();
        let system = Scene::find("free-asymmetric").expect("built in").system;
        let plans = [10, 100, 1000].map(|steps| Plan::over(8.0, steps, 1));
        let members = plans.iter().map(|plan| Member { system: system.clone(), plan: *plan }).collect();
        let ensemble = Ensemble::new(&contestant, members);
        let ends = ensemble.fold(|_| None, |end, snapshot| *end = Some(*snapshot));
        for ((end, outcome), plan) in ends.iter().zip(&plans) {
            let alone = contestant.run(&system, Form::Least, plan);
            assert_eq!(end.as_ref(), alone.states.last());
            assert_eq!(outcome.steps, plan.steps);
        }
    }
}
