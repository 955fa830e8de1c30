//! The findings of a self-test as JSON, schema polhode/self-test/1.

use serde_json::{Value, json};

use crate::self_test::random::{Finding, Findings as OfScenes, Tally};
use crate::self_test::{Findings, Outcome, power};

/// The schema of both forms; `kind` tells them apart.
const SCHEMA: &str = "polhode/self-test/1";

/// Every planted defect, and what caught it.
pub(super) fn of_defects(findings: &Findings) -> String {
    let defect = |outcome: &Outcome| {
        json!({
            "name": outcome.name,
            "place": outcome.place,
            "caught_by": outcome.caught_by,
            "scenes": outcome.scenes,
        })
    };
    let answer = json!({
        "schema": SCHEMA,
        "kind": "defects",
        "complete": findings.complete,
        "sound": findings.sound(),
        "defects": findings.outcomes.iter().map(defect).collect::<Vec<_>>(),
        "held_against_the_copy": findings.held_against_the_copy,
    });
    format!("{answer:#}\n")
}

/// Verdicts on correct schemes in random scenes, and on wrong orders where those were judged.
pub(super) fn of_scenes(seed: u64, findings: &OfScenes, wrong_orders: &[power::Row]) -> String {
    let schemes = findings.verdicts.iter().map(|(scheme, tally)| (scheme.clone(), counts(tally)));
    let answer = json!({
        "schema": SCHEMA,
        "kind": "random-scenes",
        "seed": seed,
        "scenes": findings.scenes,
        "without_reference": findings.without_reference,
        "complete": findings.complete,
        "sound": findings.sound(),
        "verdicts": schemes.collect::<serde_json::Map<String, Value>>(),
        "worst_of_a_scheme_in_a_scene": counts(&findings.gates),
        "against_correct_schemes": findings.against.iter().map(against).collect::<Vec<_>>(),
        "wrong_orders": wrong_orders.iter().map(wrong_order).collect::<Vec<_>>(),
    });
    format!("{answer:#}\n")
}

fn counts(tally: &Tally) -> Value {
    json!({
        "pass": tally.pass,
        "fail": tally.fail,
        "inconclusive": tally.inconclusive,
        "not_applicable": tally.not_applicable,
        "broken": tally.broken,
    })
}

fn against(finding: &Finding) -> Value {
    json!({ "family": finding.family.to_string(), "number": finding.number, "verdict": finding.verdict })
}

fn wrong_order(row: &power::Row) -> Value {
    json!({
        "name": row.name,
        "scenes": counts(&row.scenes),
        "quantities": counts(&row.quantities),
        "power": row.power(),
        "passed_in_scenes": row.passed,
    })
}
