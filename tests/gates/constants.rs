//! The error constants on record: references/constants.json.
//!
//! With `POLHODE_WRITE_CONSTANTS` set the file is written anew from all schemes in all built-in scenes.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use polhode::campaign::Campaign;
use polhode::gates::Baseline;
use polhode::internals::gates::Constants;
use polhode::model::{PerQuantity, Quantity};
use polhode::record::Records;
use polhode::scenes;
use polhode::simulate::Contestant;

fn file() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("references/constants.json")
}

fn constants() -> Constants {
    let text = fs::read_to_string(file()).expect("references/constants.json");
    serde_json::from_str(&text).expect("constants")
}

/// The constants of a campaign, to six digits, of the schemes that claim an order: no other scheme is held to its constants.
fn measured(records: &Records) -> Constants {
    let mut constants = Constants::default();
    for scene in &records.scenes {
        constants.entry(scene.name.clone()).or_default().content.clone_from(&scene.content);
    }
    let claims = |name: &str| records.schemes.iter().any(|scheme| scheme.name == name && scheme.order > 0);
    for order in records.orders.iter().filter(|order| claims(&order.scheme)) {
        let Some(constant) = order.constant else { continue };
        let quantity = Quantity::ALL.into_iter().find(|quantity| quantity.name() == order.quantity);
        let scene = constants.get_mut(&order.scene).expect("a scene");
        let row = scene.schemes.entry(order.scheme.clone()).or_insert(PerQuantity::all(None));
        row[quantity.expect("a quantity")] = format!("{constant:.5e}").parse().ok();
    }
    constants
}

fn json<T: serde::Serialize>(value: &T) -> String {
    serde_json::to_string(value).expect("JSON")
}

/// A scene a block, a scheme a line.
fn text(constants: &Constants) -> String {
    let scenes: Vec<String> = constants
        .iter()
        .map(|(name, scene)| {
            let schemes: Vec<String> = scene
                .schemes
                .iter()
                .map(|(scheme, row)| format!("   {}: {}", json(scheme), json(row)))
                .collect();
            let (name, content) = (json(name), json(&scene.content));
            format!(
                " {name}: {{\n  \"content\": {content},\n  \"schemes\": {{\n{}\n  }}\n }}",
                schemes.join(",\n")
            )
        })
        .collect();
    format!("{{\n{}\n}}\n", scenes.join(",\n"))
}

#[test]
fn the_constants_belong_to_the_built_in_scenes_as_they_are() {
    if std::env::var_os("POLHODE_WRITE_CONSTANTS").is_some() {
        let records = Campaign {
            baseline: Baseline::default(),
            ..Campaign::of(scenes::built_in(), Contestant::everyone())
        };
        fs::write(file(), text(&measured(&records.run()))).expect("written");
    }
    let constants = constants();
    let contents: BTreeMap<String, String> =
        scenes::built_in().into_iter().map(|scene| (scene.name.clone(), scene.content())).collect();
    for (name, scene) in &constants {
        assert_eq!(contents.get(name), Some(&scene.content), "{name}");
    }
    let kovalevskaya = &constants["kovalevskaya"].schemes;
    assert!(kovalevskaya["peskin-rk2"][Quantity::BodyPoint].is_some());
    assert!(!kovalevskaya.contains_key("dop853"));
    assert_eq!(text(&constants), fs::read_to_string(file()).expect("the file"));
}
