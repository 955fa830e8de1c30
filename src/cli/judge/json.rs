//! What was found about logs as JSON, schema polhode/judge/1.

use serde_json::{Value, json};

use super::{Pair, pairs};
use crate::log::{Explanation, Finding, Judgement, Verdict};
use crate::scenes::Scene;

/// Every log with its findings, hints and verdict, and the deviations of several.
pub(super) fn findings(judged: &[(String, Judgement)], verdicts: &[Verdict], scene: &Scene) -> String {
    let logs = judged.iter().enumerate().map(|(index, (name, one))| log(name, one, verdicts.get(index)));
    let answer = json!({
        "schema": "polhode/judge/1",
        "scene": scene.name,
        "logs": logs.collect::<Vec<_>>(),
        "deviations": pairs(judged, scene).iter().map(pair).collect::<Vec<_>>(),
    });
    format!("{answer:#}\n")
}

fn log(name: &str, judgement: &Judgement, verdict: Option<&Verdict>) -> Value {
    json!({
        "log": name,
        "rows": judgement.rows,
        "from_s": judgement.span.0,
        "to_s": judgement.span.1,
        "spacing_s": judgement.spacing,
        "reading": judgement.reading,
        "reference": judgement.reference.as_ref().ok(),
        "why_no_reference": judgement.reference.as_ref().err(),
        "frames": judgement.frames_in_words(),
        "read_as": judgement.declared.words(),
        "follows": judgement.contradicted().map(|convention| convention.words()),
        "findings": judgement.findings.iter().map(finding).collect::<Vec<_>>(),
        "hints": judgement.explanations.iter().map(explanation).collect::<Vec<_>>(),
        "notes": judgement.notes,
        "verdict": verdict.map(last),
    })
}

fn finding(finding: &Finding) -> Value {
    let value = finding.value.as_ref().ok();
    json!({
        "quantity": finding.name,
        "unit": finding.unit,
        "end": value.and_then(|value| value.end),
        "max": value.map(|value| value.max),
        "time_of_max_s": value.map(|value| value.time),
        "rows": value.map(|value| value.rows),
        "uncertainty": value.map(|value| value.uncertainty),
        "why": finding.value.as_ref().err(),
    })
}

fn explanation(explanation: &Explanation) -> Value {
    json!({
        "change": explanation.change,
        "words": explanation.words,
        "left": explanation.left,
        "before": explanation.before,
        "remark": explanation.is_remark(),
    })
}

fn last(verdict: &Verdict) -> Value {
    json!({
        "verdict": verdict.ruling,
        "quantity": verdict.quantity.name(),
        "unit": verdict.quantity.unit(),
        "limit": verdict.limit,
        "largest": verdict.largest.map(|largest| largest.0),
        "time_s": verdict.largest.map(|largest| largest.1),
        "words": verdict.in_words(),
    })
}

fn pair(pair: &Pair) -> Value {
    let Pair { log, other, quantity, apart } = pair;
    json!({
        "log": log,
        "other": other,
        "quantity": quantity.name(),
        "unit": quantity.unit(),
        "largest": apart.largest,
        "secular": apart.secular,
        "bounded": apart.bounded,
        "common_times": apart.times,
    })
}
