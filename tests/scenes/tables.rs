//! What the tables of the laws give: blocks to paste, and the schema of a scene file.

use std::path::PathBuf;

use polhode::model::forces::{Argument, Attachment, Kind, Law, Parameter};
use polhode::scenes::{Scene, block, schema};

use crate::given::{HEAD, POINTS, parse};

#[test]
fn every_block_parses_and_gives_the_example_of_every_parameter() {
    for law in &Law::ALL {
        let text = block(law);
        for key in law.parameters.iter().flat_map(|p| p.keys()) {
            assert!(text.contains(&format!("{key} = ")), "{key} in {text}");
        }
        let scene = parse(&format!("{HEAD}{POINTS}{text}"));
        assert_eq!(scene.system.forces.laws(), [law.example()], "{text}");
    }
    let all = Law::ALL.map(|law| block(&law)).concat();
    assert_eq!(parse(&format!("{HEAD}{POINTS}{all}")).system.forces.laws().len(), Law::ALL.len());
}

/// The table of a law with one line of its block left out, or in place of it another one.
fn without(law: usize, parameter: &Parameter, line: &str) -> String {
    let text = block(&Law::ALL[law]);
    let key = if parameter.kind == Kind::Attachment { Parameter::PLACES[0] } else { parameter.key };
    let kept = text.lines().filter(|l| !l.starts_with(&format!("{key} = ")));
    format!("{HEAD}{POINTS}{}\n{line}\n", kept.collect::<Vec<_>>().join("\n"))
}

#[test]
fn every_parameter_is_read_and_stands_for_itself() {
    for (index, law) in Law::ALL.iter().enumerate() {
        for (place, parameter) in law.parameters.iter().enumerate() {
            let read = |text: &str| Scene::parse(text, "user.toml");
            let left_out = read(&without(index, parameter, ""));
            match &parameter.default {
                None => assert!(left_out.is_err(), "{} of {}", parameter.key, law.name),
                Some(default) => {
                    let scene = left_out.expect("a default");
                    assert_eq!(
                        scene.system.forces.laws()[0].arguments()[place].1,
                        *default,
                        "{}",
                        parameter.key
                    );
                }
            }
            let (line, expected) = match parameter.kind {
                Kind::Number => (format!("{} = 0.75", parameter.key), Argument::Number(0.75)),
                Kind::Vector => {
                    let v = nalgebra::Vector3::new(0.0, -1.0, 0.0);
                    (format!("{} = [0, -1, 0]", parameter.key), Argument::Vector(v))
                }
                Kind::Matrix => {
                    let m = nalgebra::Matrix3::new(3.0, 1.0, 0.5, 1.0, 4.0, 0.25, 0.5, 0.25, 5.0);
                    let rows = "[[3, 1, 0.5], [1, 4, 0.25], [0.5, 0.25, 5]]";
                    (format!("{} = {rows}", parameter.key), Argument::Matrix(m))
                }
                Kind::Attachment => ("point = 2".to_owned(), Argument::Attachment(Attachment::Point(2))),
                Kind::PerPoint => {
                    let values = polhode::model::forces::PerPoint::Each(vec![1.0, 2.0, 3.0]);
                    (format!("{} = [1, 2, 3]", parameter.key), Argument::PerPoint(values))
                }
                Kind::Axes => continue,
            };
            let scene = read(&without(index, parameter, &line)).expect("a scene");
            assert_eq!(
                scene.system.forces.laws()[0].arguments()[place].1,
                expected,
                "{line} of {}",
                law.name
            );
        }
    }
}

#[test]
fn every_parameter_stands_in_the_schema() {
    let schema = schema();
    for law in &Law::ALL {
        let table = &schema["definitions"][law.name];
        let found: Vec<&String> = table["properties"].as_object().expect("properties").keys().collect();
        let mut keys: Vec<&str> = law.parameters.iter().flat_map(|p| p.keys().iter().copied()).collect();
        keys.push("law");
        keys.sort_unstable();
        assert_eq!(found, keys, "{}", law.name);
        let required: Vec<&str> =
            table["required"].as_array().expect("a list").iter().filter_map(|k| k.as_str()).collect();
        let is_required = |p: &&Parameter| p.default.is_none() && p.kind != Kind::Attachment;
        let expected = law.parameters.iter().filter(is_required).map(|p| p.key);
        assert_eq!(required, std::iter::once("law").chain(expected).collect::<Vec<_>>(), "{}", law.name);
    }
}

#[test]
fn the_schema_on_record_is_the_one_that_the_tables_give() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("references/scene.schema.json");
    let on_record = std::fs::read_to_string(path).expect("the schema");
    let made = format!("{:#}\n", schema());
    assert!(on_record == made, "polhode list forces --schema > references/scene.schema.json");
}
