//! Stored solutions are what they were, and belong to their scene.

use polhode::internals::reference::{Reference, ReferenceError, StoredError, stored};

use crate::common::{scene, stored_of};

#[test]
fn a_corrupted_stored_file_is_refused() {
    let (_, text) = stored::FILES[0];
    assert!(stored::Stored::parse(text).is_ok());
    let digit = text.find("\"L\"").map(|i| i + text[i..].find('.').expect("a number") + 1).expect("L");
    let mut corrupted = text.to_owned();
    let other = if &text[digit..=digit] == "7" { "8" } else { "7" };
    corrupted.replace_range(digit..=digit, other);
    assert!(matches!(stored::Stored::parse(&corrupted), Err(StoredError::Checksum { .. })));
    let older = text.replace("polhode/solution/1", "polhode/solution/0");
    assert!(matches!(stored::Stored::parse(&older), Err(StoredError::Schema { .. })));
    assert!(matches!(stored::Stored::parse(&text[..900]), Err(StoredError::Syntax { .. })));
    assert_eq!(stored::find("no such scene"), Ok(None));
}

#[test]
fn a_stored_solution_of_another_system_is_refused() {
    let mut slower = scene("free-asymmetric").system;
    slower.start.angular_momentum.z = 2.25;
    let refused = Reference::of(&slower, 8.0, 4, Some(&stored_of("free-asymmetric")));
    assert!(matches!(refused, Err(ReferenceError::OtherSystem { .. })), "{refused:?}");
    let refused = Reference::of(&slower, 8.0, 4, Some(&stored_of("dzhanibekov")));
    assert!(matches!(refused, Err(ReferenceError::Stored(StoredError::Body { .. }))), "{refused:?}");
}
