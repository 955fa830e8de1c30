//! Many bodies under one scheme: the same run at many steps, starts or parameters, for maps and sweeps.
//!
//! Members are independent; they are run in parallel and their results stand in their order, so that one thread or many give
//! the same numbers to the last bit. Free bodies, and tops under their weight, are stepped side by side under the
//! note's schemes, several in each register of the machine; they too give the numbers that each gives alone, to the last bit.

mod block;
mod lanes;

use rayon::prelude::*;

use crate::arithmetic::Registers;
use crate::interrupt;
use crate::model::{Broken, Snapshot, System};
use crate::schemes::SideBySide;
use crate::simulate::{Break, Contestant, Form, Outcome, Plan};
use block::{Body, Guest};
use lanes::Way;

/// Bodies that are run together: as many as fit the widest registers twice.
const TOGETHER: usize = 16;

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
    registers: Registers,
}

impl<'a> Ensemble<'a> {
    /// Runs of `contestant`.
    pub fn new(contestant: &'a Contestant, members: Vec<Member>) -> Ensemble<'a> {
        Ensemble { contestant, members, registers: Registers::widest() }
    }

    /// The same in other registers than the widest: the same numbers, at another cost.
    pub fn in_registers(self, registers: Registers) -> Ensemble<'a> {
        Ensemble { registers, ..self }
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
    ///
    /// A member that cannot be run beside others after all is begun anew, so `begin` may be called twice for it.
    pub fn fold<T: Send>(
        &self,
        begin: impl Fn(usize) -> T + Sync,
        see: impl Fn(&mut T, &Snapshot) + Sync,
    ) -> Vec<(T, Outcome)> {
        self.rows(begin, see, |_, kept, outcome| (kept, outcome))
    }

    /// The same, where `end` makes a row of each member as soon as it has run.
    pub fn rows<T: Send, R: Send>(
        &self,
        begin: impl Fn(usize) -> T + Sync,
        see: impl Fn(&mut T, &Snapshot) + Sync,
        end: impl Fn(usize, T, Outcome) -> R + Sync,
    ) -> Vec<R> {
        let (alone, blocks) = self.parties();
        let of_block = |(scheme, guests): &(SideBySide, Vec<Guest>)| {
            let indices = guests.iter().map(|guest| guest.index);
            let rows = block::run(*scheme, self.registers, guests, &begin, &see)
                .unwrap_or_else(|| indices.clone().map(|index| self.alone(index, &begin, &see)).collect());
            let rows = indices.zip(rows).map(|(index, (kept, outcome))| (index, end(index, kept, outcome)));
            rows.collect::<Vec<_>>()
        };
        let mut rows: Vec<(usize, R)> = blocks.par_iter().with_max_len(1).flat_map_iter(of_block).collect();
        let alone = alone.into_par_iter().with_max_len(1);
        rows.par_extend(alone.map(|index| {
            let (kept, outcome) = self.alone(index, &begin, &see);
            (index, end(index, kept, outcome))
        }));
        rows.sort_by_key(|(index, _)| *index);
        rows.into_iter().map(|(_, row)| row).collect()
    }

    /// A member by itself.
    fn alone<T>(
        &self,
        index: usize,
        begin: &impl Fn(usize) -> T,
        see: &impl Fn(&mut T, &Snapshot),
    ) -> (T, Outcome) {
        let member = &self.members[index];
        let mut kept = begin(index);
        if interrupt::requested() {
            let broken = Some(Break { step: 0, time: 0.0, why: Broken::Interrupted });
            return (kept, Outcome { broken, ..Outcome::none_yet() });
        }
        let outcome = self.contestant.stream(&member.system, Form::Least, &member.plan, &mut |snapshot| {
            see(&mut kept, snapshot);
        });
        (kept, outcome)
    }

    /// The members that run alone, and blocks of those that run side by side: of about the same number of steps.
    fn parties(&self) -> (Vec<usize>, Vec<(SideBySide, Vec<Guest<'_>>)>) {
        let (mut alone, mut guests) = (Vec::new(), Vec::new());
        let scheme = self.contestant.side_by_side();
        for (index, member) in self.members.iter().enumerate() {
            match scheme.zip(Body::of(&member.system)) {
                Some((scheme, body)) => guests.push((scheme, Guest { index, member, body })),
                None => alone.push(index),
            }
        }
        let way = |(scheme, guest): &(SideBySide, Guest)| guest.way(*scheme);
        guests.sort_by_key(|one| {
            (way(one) == Way::MovingAxes, one.1.member.plan.steps, one.1.member.plan.every)
        });
        let mut blocks: Vec<(SideBySide, Vec<Guest>)> = Vec::new();
        for (scheme, guest) in guests {
            match blocks.last_mut() {
                Some((_, block)) if block.len() < TOGETHER && block[0].way(scheme) == guest.way(scheme) => {
                    block.push(guest);
                }
                _ => blocks.push((scheme, vec![guest])),
            }
        }
        (alone, blocks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation;
    use crate::scenes::Scene;
    use crate::schemes::{Euler, PeskinHeun, PeskinRk2};
    use nalgebra::Vector3;

    /// Free bodies at steps, starts and lengths of their own.
    fn members() -> Vec<Member> {
        let system = Scene::find("free-asymmetric").expect("built in").system;
        let member = |k: usize| {
            let turn = Vector3::new(0.1, -0.2, 0.3) * k as f64;
            let mut system = system.clone();
            system.start.orientation = rotation::turn(&turn);
            let steps = [1, 10, 700, 10_000][k % 4];
            let every = [1, 3, 4000, 10_000][k / 4 % 4];
            Member { system, plan: Plan { step: 0.001 * (1 + k) as f64, steps, every } }
        };
        (0..37).map(member).collect()
    }

    fn agree(contestant: &Contestant, members: Vec<Member>) -> Vec<(Vec<Snapshot>, Outcome)> {
        let ensemble = Ensemble::new(contestant, members.clone());
        let rows =
            ensemble.fold(|_| Vec::new(), |states: &mut Vec<Snapshot>, snapshot| states.push(*snapshot));
        assert_eq!(rows.len(), members.len());
        for ((states, outcome), member) in rows.iter().zip(&members) {
            let alone = contestant.run(&member.system, Form::Least, &member.plan);
            assert_eq!(states, &alone.states);
            let nanoseconds = outcome.nanoseconds;
            assert_eq!(outcome, &Outcome { nanoseconds, ..alone.outcome });
        }
        rows
    }

    #[test]
    fn members_are_the_runs_that_they_stand_for_to_the_last_bit_and_in_their_order() {
        for contestant in [Contestant::new(PeskinRk2), Contestant::new(Euler)] {
            assert!(contestant.side_by_side().is_some());
            agree(&contestant, members());
        }
        // Tops, among free bodies and at steps of their own.
        let top = Scene::find("kovalevskaya").expect("built in").system;
        let mut tops = members();
        for k in 0..21 {
            let steps = [64, 256, 1000][k % 3];
            tops.push(Member { system: top.clone(), plan: Plan::over(1.0 + 0.1 * k as f64, steps, 5) });
        }
        agree(&Contestant::new(PeskinRk2), tops.clone());
        agree(&Contestant::new(Euler), tops);
        // A scheme and a scene that have no lanes.
        let heun = Contestant::new(PeskinHeun);
        assert!(heun.side_by_side().is_none());
        agree(&heun, members());
        let system = Scene::find("gravity-drag").expect("built in").system;
        let mut mixed = members();
        mixed.insert(3, Member { system, plan: Plan::over(1.0, 100, 4) });
        agree(&Contestant::new(PeskinRk2), mixed);
    }

    #[test]
    fn members_that_turn_far_or_break_are_run_alone() {
        let mut far = members();
        // 20 rad a step: beyond the series; and steps without end, whose angle is not finite.
        far[5].plan.step = 20.0;
        far[9].plan.step = 1e300;
        far[9].system.start.angular_momentum *= 1e300;
        let rows = agree(&Contestant::new(PeskinRk2), far);
        assert!(rows[9].1.broken.is_some() && rows[5].1.broken.is_none());
    }

    #[test]
    fn one_thread_and_many_give_the_same() {
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            let contestant = Contestant::new(PeskinRk2);
            let ensemble = Ensemble::new(&contestant, members());
            let rows = pool.install(|| ensemble.fold(|index| (index, None), |end, s| end.1 = Some(*s)));
            rows.into_iter().map(|(end, _)| end).collect::<Vec<_>>()
        };
        assert_eq!(run(1), run(3));
    }
}
