//! Foreign programs beside one another and beside the schemes of the list, at equal steps.

use crate::engine::compare::{self, Peers};
use crate::record::Records;
use crate::scenes::Scene;
use crate::simulate::Contestant;

/// Puts into the records how the foreign programs among `contestants` stand at equal steps; nothing where there are none.
/// `progress` is called as (done, of all).
pub fn add_peers(
    records: &mut Records,
    scenes: &[Scene],
    contestants: &[Contestant],
    progress: &(dyn Fn(usize, usize) + Sync),
) {
    if contestants.iter().any(|contestant| contestant.program().is_some()) {
        let Peers { rows, twins } = compare::compare(scenes, contestants, &Contestant::all(), progress);
        (records.peers, records.twins) = (rows, twins);
    }
}
