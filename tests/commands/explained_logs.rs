//! Logs with one known change are named; right ones get no hint. `tests/slow` judges a thousand of each.

use crate::changed_logs::CHANGES;
use crate::tallied_logs::{false_alarms, tally};

#[test]
fn every_known_change_is_named_and_none_wrongly() {
    let count = CHANGES.len() as u64;
    let tally = tally(count);
    assert!(tally.rightly + 1 >= count && tally.wrongly == 0, "{tally}\n{}", tally.others.join("\n"));
}

#[test]
fn right_logs_get_no_hint() {
    assert_eq!(false_alarms(40), Vec::<String>::new());
}
