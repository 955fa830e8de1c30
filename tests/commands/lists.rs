//! `polhode list forces` from outside.

use crate::common::program::{code, polhode, stderr, stdout};

#[test]
fn the_forces_are_listed_as_blocks_and_one_of_them_alone() {
    let all = polhode(&["list", "forces"]);
    assert_eq!(code(&all), 0, "{}", stderr(&all));
    let spring = polhode(&["list", "forces", "spring"]);
    assert_eq!(code(&spring), 0, "{}", stderr(&spring));
    assert!(stdout(&spring).contains("law = \"spring\"") && stdout(&all).contains(&stdout(&spring)));
    for wrong in
        [["list", "forces", "sprung"], ["list", "scenes", "kovalevskaya"], ["list", "claims", "--schema"]]
    {
        assert_eq!(code(&polhode(&wrong)), 64, "{wrong:?}");
    }
}

#[test]
fn the_schema_is_json() {
    let schema = polhode(&["list", "forces", "--schema"]);
    assert_eq!(code(&schema), 0, "{}", stderr(&schema));
    let schema: serde_json::Value = serde_json::from_str(&stdout(&schema)).expect("JSON");
    assert_eq!(schema["$schema"], "http://json-schema.org/draft-07/schema#");
}
