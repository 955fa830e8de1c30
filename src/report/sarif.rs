//! The verdicts as SARIF 2.1.0, which code hosts show as alerts: a rule a claim, a result for each scheme in each scene that is not green.

use serde_json::{Value, json};

use crate::record::{ClaimName, Records};

use super::survey::{self, Outcome};
use super::text::{self, Remark};

/// What marks a file of this program.
pub const MARK: &str = "\"id\": \"polhode gate\"";

/// The verdicts as SARIF.
pub fn sarif(records: &Records) -> String {
    let rule =
        |claim: ClaimName| json!({"id": claim.word(), "shortDescription": {"text": claim.explained()}});
    let rules: Vec<Value> = ClaimName::ALL.into_iter().map(rule).collect();
    let results: Vec<Value> = text::remarks(records).iter().map(|remark| result(records, remark)).collect();
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "automationDetails": {"id": "polhode gate"},
            "results": results,
            "tool": {"driver": {"name": "polhode", "version": records.polhode, "rules": rules}},
        }],
    });
    format!("{log:#}\n")
}

fn result(records: &Records, remark: &Remark) -> Value {
    let level = match remark.outcome {
        Outcome::Fail | Outcome::Broken => "error",
        Outcome::Inconclusive => "warning",
        Outcome::KnownDeviation | Outcome::Pass | Outcome::NotApplicable => "note",
    };
    let file = survey::scene(records, remark.scene).map_or("", |scene| scene.file.as_str());
    let mut result = json!({
        "ruleId": remark.claim.word(),
        "level": level,
        "message": {"text": format!("{} in {}: {}", remark.scheme, remark.scene, remark.words)},
        "partialFingerprints": {"cell/v1": format!("{}/{}/{}", remark.scheme, remark.scene, remark.claim)},
    });
    if !file.is_empty() {
        let place = json!({"artifactLocation": {"uri": file}, "region": {"startLine": 1}});
        result["locations"] = json!([{"physicalLocation": place}]);
    }
    result
}
