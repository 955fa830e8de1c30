//! A thousand logs with one known change, and a thousand right ones.

use crate::mutated_logs::mutate;
use crate::tallied_logs::{false_alarms, tally};

#[test]
fn of_a_thousand_changed_logs_95_in_100_are_named_rightly_and_one_in_200_wrongly() {
    let tally = tally(1000);
    println!("{tally}");
    assert!(tally.rightly >= 950 && tally.wrongly <= 5, "{tally}\n{}", tally.others.join("\n"));
}

#[test]
fn a_thousand_right_logs_get_no_hint() {
    let alarms = false_alarms(1000);
    println!("hints on right logs: {} of 1000", alarms.len());
    assert!(alarms.is_empty(), "{} of 1000\n{}", alarms.len(), alarms.join("\n"));
}

#[test]
fn twenty_thousand_mutated_logs_are_read_or_refused() {
    let refused = mutate(20_000);
    println!("mutated logs: {refused} of 20000 refused, the others judged without a false pass");
    assert!((10_000..20_000).contains(&refused), "{refused}");
}
