//! Logs with one known change are named; right ones get no hint. `tests/slow` judges a thousand of each.

use crate::changed_logs::{CHANGES, false_alarms, tally};

#[test]
fn every_known_change_is_named_and_none_wrongly() {
    let count = CHANGES.len() as u64;
    let (rightly, wrongly, others) = tally(count);
    assert!(rightly + 1 >= count && wrongly == 0, "{rightly} of {count}\n{}", others.join("\n"));
}

#[test]
fn right_logs_get_no_hint() {
    assert_eq!(false_alarms(40), Vec::<String>::new());
}
