//! Dependencies between modules point one way; no other edge than these is allowed.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A module and those it may use.
const EDGES: &[(&str, &[&str])] = &[
    ("interrupt", &[]),
    ("arithmetic", &[]),
    ("rotation", &["arithmetic"]),
    ("record", &[]),
    ("model", &["arithmetic", "rotation"]),
    ("ode", &["model", "rotation"]),
    ("claim", &["model", "record"]),
    ("schemes", &["claim", "interrupt", "model", "ode", "rotation"]),
    ("reference", &["interrupt", "model", "ode", "rotation"]),
    ("scenes", &["model", "rotation"]),
    ("simulate", &["claim", "interrupt", "model", "rotation", "schemes"]),
    ("measure", &["claim", "model", "ode", "record", "reference", "rotation", "simulate"]),
    ("gates", &["claim", "measure", "model", "record", "reference", "rotation", "schemes"]),
    (
        "study",
        &[
            "arithmetic",
            "interrupt",
            "measure",
            "model",
            "ode",
            "record",
            "reference",
            "rotation",
            "scenes",
            "schemes",
            "simulate",
        ],
    ),
    (
        "engine",
        &["claim", "interrupt", "model", "ode", "record", "rotation", "scenes", "schemes", "simulate"],
    ),
    (
        "campaign",
        &[
            "claim",
            "engine",
            "gates",
            "interrupt",
            "measure",
            "model",
            "record",
            "reference",
            "rotation",
            "scenes",
            "schemes",
            "simulate",
            "study",
        ],
    ),
    ("assertion", &["campaign", "claim", "gates", "record", "scenes", "schemes", "simulate"]),
    ("log", &["model", "ode", "record", "reference", "rotation", "scenes"]),
    (
        "self_test",
        &[
            "campaign",
            "claim",
            "gates",
            "interrupt",
            "measure",
            "model",
            "record",
            "reference",
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
            "campaign",
            "claim",
            "engine",
            "gates",
            "interrupt",
            "log",
            "measure",
            "model",
            "ode",
            "record",
            "reference",
            "report",
            "scenes",
            "schemes",
            "self_test",
            "simulate",
            "study",
        ],
    ),
    ("prelude", &["assertion", "campaign", "model", "record", "report", "scenes", "schemes", "simulate"]),
    ("guide", &[]),
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
    let declared: Vec<&str> = library
        .lines()
        .map(|line| line.strip_prefix("pub ").unwrap_or(line))
        .filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(';'))
        .collect();
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
    for examiner in ["scenes", "reference", "measure", "gates", "campaign", "simulate"] {
        assert!(!used.contains(examiner), "schemes use {examiner}");
    }
}
