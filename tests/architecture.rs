//! Dependencies between modules point one way; no other edge than these is allowed.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A module and those it may use.
const EDGES: &[(&str, &[&str])] = &[
    ("interrupt", &[]),
    ("number", &[]),
    ("rotation", &["number"]),
    ("regression", &[]),
    ("record", &[]),
    ("elliptic", &[]),
    ("free_rotor", &["elliptic", "rotation"]),
    ("model", &["number", "rotation"]),
    ("claim", &["model"]),
    ("schemes", &["claim", "free_rotor", "model", "rotation"]),
    ("reference", &["elliptic", "free_rotor", "interrupt", "model", "rotation"]),
    ("scenes", &["model", "rotation", "reference"]),
    ("simulate", &["claim", "interrupt", "model", "rotation", "schemes"]),
    ("ensemble", &["interrupt", "model", "number", "rotation", "scenes", "schemes", "simulate"]),
    ("sweep", &["ensemble", "interrupt", "model", "reference", "scenes", "simulate"]),
    ("adaptive", &["claim", "interrupt", "model", "reference", "schemes", "simulate"]),
    ("cost", &["interrupt", "model", "scenes", "schemes", "simulate"]),
    ("peers", &["interrupt", "model", "record", "reference", "rotation", "scenes", "simulate"]),
    ("metrics", &["claim", "model", "reference", "regression", "rotation", "simulate"]),
    (
        "advice",
        &["cost", "interrupt", "metrics", "model", "reference", "rotation", "scenes", "schemes", "simulate"],
    ),
    (
        "stability",
        &[
            "claim",
            "ensemble",
            "interrupt",
            "metrics",
            "model",
            "record",
            "reference",
            "regression",
            "rotation",
            "scenes",
            "simulate",
        ],
    ),
    (
        "gates",
        &[
            "claim",
            "metrics",
            "model",
            "record",
            "reference",
            "regression",
            "rotation",
            "schemes",
            "stability",
        ],
    ),
    (
        "campaign",
        &[
            "claim",
            "cost",
            "gates",
            "interrupt",
            "metrics",
            "model",
            "record",
            "reference",
            "regression",
            "rotation",
            "scenes",
            "schemes",
            "simulate",
            "stability",
        ],
    ),
    ("engine", &["claim", "interrupt", "model", "reference", "rotation", "scenes", "schemes", "simulate"]),
    ("judge", &["model", "record", "reference", "rotation", "scenes"]),
    ("assertion", &["campaign", "claim", "gates", "record", "scenes", "schemes", "simulate"]),
    (
        "self_test",
        &[
            "campaign",
            "claim",
            "gates",
            "interrupt",
            "metrics",
            "model",
            "record",
            "reference",
            "regression",
            "rotation",
            "scenes",
            "schemes",
            "simulate",
        ],
    ),
    ("report", &["record"]),
    (
        "cli",
        &[
            "adaptive",
            "advice",
            "campaign",
            "claim",
            "engine",
            "gates",
            "interrupt",
            "judge",
            "metrics",
            "model",
            "peers",
            "record",
            "reference",
            "report",
            "scenes",
            "schemes",
            "self_test",
            "simulate",
            "sweep",
            "stability",
        ],
    ),
];

fn sources(path: &Path, found: &mut Vec<String>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).expect("a folder") {
            sources(&entry.expect("an entry").path(), found);
        }
    } else if path.extension().is_some_and(|ending| ending == "rs") {
        found.push(fs::read_to_string(path).expect("text"));
    }
}

fn used_modules(name: &str) -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut texts = Vec::new();
    for place in [root.join(format!("{name}.rs")), root.join(name)] {
        if place.exists() {
            sources(&place, &mut texts);
        }
    }
    assert!(!texts.is_empty(), "module {name} has no source");
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    texts
        .iter()
        .flat_map(|text| text.match_indices("crate::").map(|(at, word)| &text[at + word.len()..]))
        .map(|rest| rest.chars().take_while(|c| is_name(*c)).collect::<String>())
        .filter(|module| module != name && !module.is_empty())
        .collect()
}

#[test]
fn dependencies_point_one_way() {
    for (module, allowed) in EDGES {
        for used in used_modules(module) {
            assert!(
                allowed.contains(&used.as_str()),
                "{module} uses {used}, which the design does not allow"
            );
        }
    }
}

#[test]
fn every_module_stands_in_the_table_and_in_the_order_of_dependency() {
    let library = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).expect("text");
    let declared: Vec<&str> =
        library.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')).collect();
    for (index, module) in declared.iter().enumerate() {
        let (_, allowed) = EDGES.iter().find(|(name, _)| name == module).expect("a row for every module");
        for used in *allowed {
            let place = declared.iter().position(|name| name == used).expect("declared");
            assert!(place < index, "{module} stands before {used}, which it uses");
        }
    }
    assert_eq!(declared.len(), EDGES.len());
}

#[test]
fn a_scheme_sees_no_scene_no_reference_and_no_gate() {
    let used = used_modules("schemes");
    for examiner in ["scenes", "reference", "metrics", "gates", "campaign", "simulate"] {
        assert!(!used.contains(examiner), "schemes use {examiner}");
    }
}
