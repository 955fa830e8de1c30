//! Tables of checks as JSON, under the name of their schema.

use serde_json::Value;

use crate::common::program::{code, json, polhode, stderr};

#[test]
fn verdicts_in_random_scenes_are_counted_in_json() {
    let output = polhode(&["self-test", "--random", "2", "--seed", "3", "--quiet", "--format", "json"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let found = json(&output);
    assert_eq!((&found["schema"], &found["kind"]), (&"polhode/self-test/1".into(), &"random-scenes".into()));
    assert_eq!((&found["seed"], &found["scenes"]), (&3.into(), &2.into()));
    assert_eq!((&found["complete"], &found["sound"]), (&true.into(), &true.into()));
    let pass = |tally: &Value| tally["pass"].as_u64().expect("a count");
    assert!(found["verdicts"].as_object().expect("schemes").values().map(pass).sum::<u64>() > 0);
    assert!(!found["wrong_orders"].as_array().expect("rows").is_empty());
}
