//! Evidence without repetitions: what all schemes of a scene share, and what a scheme claims in every scene, stands in the first row that has it. A
//! reader takes what a row lacks from an earlier row of the same scene or scheme.

use std::collections::HashMap;
use std::sync::Arc;

use serde::de::Error as _;
use serde::ser::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

use super::Evidence;

/// Fields that rows share, by their paths, and what they share it by.
const SHARED: [(&[&str], &str); 8] = [
    (&["claims"], "scheme"),
    (&["setting"], "scene"),
    (&["ladder", "times"], "scene"),
    (&["ladder", "sizes"], "scene"),
    (&["ladder", "uncertainty"], "scene"),
    (&["ladder", "arms"], "scene"),
    (&["ladder", "arithmetic"], "scene"),
    (&["other_worlds", "name"], "scene"),
];

/// The last value of each field, by its number and what shares it.
pub(super) type Seen = HashMap<(usize, String), Value>;

fn key(row: &Value, index: usize) -> Option<(usize, String)> {
    Some((index, row.get(SHARED[index].1)?.as_str()?.to_owned()))
}

/// The object that holds a field, and the name of the field in it.
fn holder(row: &mut Value, index: usize) -> Option<(&mut serde_json::Map<String, Value>, &'static str)> {
    let (name, path) = SHARED[index].0.split_last()?;
    let inner = path.iter().try_fold(row, |value, step| value.get_mut(step))?;
    Some((inner.as_object_mut()?, name))
}

/// Leaves out what an earlier row has.
fn shorten(row: &mut Value, seen: &mut Seen) {
    for index in 0..SHARED.len() {
        let Some(key) = key(row, index) else { continue };
        let Some((inner, name)) = holder(row, index) else { continue };
        let Some(value) = inner.get(name) else { continue };
        if seen.get(&key) == Some(value) {
            inner.remove(name);
        } else {
            seen.insert(key, value.clone());
        }
    }
}

/// Puts in what an earlier row has.
pub(super) fn restore(row: &mut Value, seen: &mut Seen) {
    for index in 0..SHARED.len() {
        let Some(key) = key(row, index) else { continue };
        let Some((inner, name)) = holder(row, index) else { continue };
        match (inner.get(name), seen.get(&key)) {
            (Some(value), _) => drop(seen.insert(key, value.clone())),
            (None, Some(value)) => drop(inner.insert(name.to_owned(), value.clone())),
            (None, None) => {}
        }
    }
}

pub(super) fn serialize<S: Serializer>(rows: &[Arc<Evidence>], serializer: S) -> Result<S::Ok, S::Error> {
    let mut seen = Seen::new();
    let short = |row: &Arc<Evidence>| {
        let mut value = serde_json::to_value(row).map_err(S::Error::custom)?;
        shorten(&mut value, &mut seen);
        Ok(value)
    };
    rows.iter().map(short).collect::<Result<Vec<Value>, _>>()?.serialize(serializer)
}

pub(super) fn deserialize<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Vec<Arc<Evidence>>, D::Error> {
    let mut seen = Seen::new();
    let whole = |mut value: Value| {
        restore(&mut value, &mut seen);
        serde_json::from_value(value).map(Arc::new).map_err(D::Error::custom)
    };
    Vec::<Value>::deserialize(deserializer)?.into_iter().map(whole).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::Claim;
    use crate::record::{Ladder, OtherWorld, Records};

    fn row(scene: &str, scheme: &str, order: u32, end: f64) -> Arc<Evidence> {
        let ladder = Ladder { times: vec![end / 3.0, end], arms: vec![[0.1; 3]], ..Ladder::default() };
        let world = OtherWorld { name: "turned".into(), ..OtherWorld::default() };
        Arc::new(Evidence {
            scene: scene.into(),
            scheme: scheme.into(),
            claims: vec![Claim::Order(order)],
            ladder,
            other_worlds: if order > 1 { vec![world] } else { Vec::new() },
            ..Evidence::default()
        })
    }

    #[test]
    fn rows_come_back_whole_and_each_shared_value_is_written_once() {
        let evidence =
            vec![row("a", "x", 2, 1.0), row("a", "y", 1, 1.0), row("b", "x", 2, 7.0), row("b", "y", 3, 7.0)];
        let records = Records { evidence, ..Records::default() };
        let text = serde_json::to_string(&records).expect("JSON");
        assert_eq!(serde_json::from_str::<Records>(&text).expect("records"), records);
        // The claims of y differ between the scenes.
        assert_eq!((text.matches("\"claims\"").count(), text.matches("\"times\"").count()), (3, 2));
    }

    #[test]
    fn a_row_without_what_no_earlier_row_has_is_refused() {
        let records = Records { evidence: vec![row("a", "x", 2, 1.0)], ..Records::default() };
        let mut value = serde_json::to_value(&records).expect("JSON");
        value["evidence"][0]["ladder"].as_object_mut().expect("an object").remove("times");
        assert!(serde_json::from_value::<Records>(value).is_err());
    }
}
