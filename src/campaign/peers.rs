//! Foreign programs beside one another and beside the schemes of the list, at equal steps.

use std::slice;

use crate::engine::compare::{self, Peers};
use crate::journal::{self, Journal};
use crate::record::Records;
use crate::scenes::Scene;
use crate::simulate::Contestant;

/// Puts into the records how the foreign programs among `contestants` stand at equal steps; nothing where there are none.
/// `progress` is called as (done, of all).
pub fn add_peers(
    records: &mut Records,
    scenes: &[Scene],
    contestants: &[Contestant],
    journal: Option<&Journal>,
    progress: &(dyn Fn(usize, usize) + Sync),
) {
    if contestants.iter().all(|contestant| contestant.program().is_none()) {
        return;
    }
    let others = Contestant::all();
    let known_as: Vec<String> = contestants.iter().map(Contestant::identity).collect();
    for (index, scene) in scenes.iter().enumerate() {
        let measure = || {
            let Peers { rows, twins } =
                compare::compare(slice::from_ref(scene), contestants, &others, &|_, _| ());
            (rows, twins)
        };
        let key = ("peers", &scene.name, scene.content(), &known_as);
        let (rows, twins) = journal::row(journal, &key, measure).unwrap_or_default();
        records.peers.extend(rows);
        records.twins.extend(twins);
        progress(index + 1, scenes.len());
    }
}
