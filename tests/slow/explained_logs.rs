//! A thousand logs with one known change, and a thousand right ones.

use crate::changed_logs::{false_alarms, tally};
use crate::mutated_logs::mutate;

#[test]
fn of_a_thousand_changed_logs_95_in_100_are_named_rightly_and_one_in_200_wrongly() {
    let (rightly, wrongly, others) = tally(1000);
    assert!(rightly >= 950 && wrongly <= 5, "{rightly} rightly, {wrongly} wrongly\n{}", others.join("\n"));
}

#[test]
fn a_thousand_right_logs_get_no_hint() {
    assert_eq!(false_alarms(1000), Vec::<String>::new());
}

#[test]
fn twenty_thousand_mutated_logs_are_read_or_refused() {
    let refused = mutate(20_000);
    assert!((10_000..20_000).contains(&refused), "{refused}");
}
