//! Claims against those on record.

use polhode::model::Quantity;
use polhode::record::ClaimName::ClaimsOnRecord;
use polhode::record::Ruling::{self, Fail, Pass};
use polhode::schemes::{Claim, When};

use super::case::{Made, numbers};

const EXACT: Claim = Claim::Exact(Quantity::AngularMomentum, When::NoTorque);

/// The ruling on claims against others on record.
fn ruling(known: &[Claim], now: &[Claim]) -> (Ruling, [Option<f64>; 3]) {
    let recorded = Made::new("free-asymmetric", known).put_on_record();
    let mut made = Made::new("free-asymmetric", now);
    made.baseline = recorded.baseline;
    let verdict = made.verdict(ClaimsOnRecord, "claims");
    (verdict.verdict, numbers(&verdict))
}

#[test]
fn a_claim_on_record_that_is_no_longer_made_fails() {
    let known = [Claim::Order(2), EXACT, Claim::Reversible];
    for (now, expected, kept) in [
        (&known[..], Pass, 3.0),
        (&[Claim::Reversible, EXACT, Claim::Order(2), Claim::Rigid], Pass, 3.0),
        // An order that is higher contains the one on record.
        (&[Claim::Order(3), EXACT, Claim::Reversible], Pass, 3.0),
        (&[Claim::Order(1), EXACT, Claim::Reversible], Fail, 2.0),
        (&[Claim::OrderWithoutTorque(2), EXACT, Claim::Reversible], Fail, 2.0),
        (&[Claim::Order(2), Claim::Exact(Quantity::Velocity, When::NoTorque), Claim::Reversible], Fail, 2.0),
        (&[Claim::Order(2)], Fail, 1.0),
        (&[], Fail, 0.0),
    ] {
        assert_eq!(ruling(&known, now), (expected, [Some(kept), Some(3.0), None]), "{now:?}");
    }
}

#[test]
fn without_claims_on_record_there_is_no_verdict() {
    let mut made = Made::new("free-asymmetric", &[EXACT]);
    assert!(made.judge().iter().all(|verdict| verdict.claim != ClaimsOnRecord));
    made.baseline = Made::new("free-asymmetric", &[]).put_on_record().baseline;
    assert!(made.judge().iter().all(|verdict| verdict.claim != ClaimsOnRecord));
}
