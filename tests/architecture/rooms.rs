//! The rooms of the crate are those of its layout, and dependencies between them point one way.

use std::collections::BTreeSet;
use std::fs;

use crate::sources::{self, File};

/// The rooms of the layout.
const ROOMS: [&str; 19] = [
    "arithmetic",
    "campaign",
    "claim",
    "cli",
    "engine",
    "gates",
    "inspect",
    "log",
    "measure",
    "model",
    "record",
    "reference",
    "report",
    "rotation",
    "scenes",
    "schemes",
    "self_test",
    "simulate",
    "study",
];
/// What several rooms share, or a single function for users.
const HELPERS: [&str; 10] =
    ["assertion", "bounded", "fault", "guide", "interrupt", "journal", "ode", "prelude", "quantity", "words"];

/// A room and those it may use.
const EDGES: &[(&str, &[&str])] = &[
    ("bounded", &[]),
    ("fault", &[]),
    ("interrupt", &[]),
    ("journal", &["interrupt"]),
    ("words", &[]),
    ("quantity", &[]),
    ("claim", &["quantity", "words"]),
    ("arithmetic", &[]),
    ("rotation", &["arithmetic"]),
    ("record", &["bounded", "claim", "fault", "quantity", "words"]),
    ("model", &["arithmetic", "quantity", "rotation"]),
    ("ode", &["interrupt", "model", "rotation"]),
    ("schemes", &["arithmetic", "claim", "interrupt", "model", "ode", "rotation"]),
    ("reference", &["interrupt", "model", "ode", "rotation"]),
    ("scenes", &["bounded", "fault", "model", "rotation"]),
    ("simulate", &["arithmetic", "claim", "interrupt", "model", "rotation", "schemes"]),
    ("measure", &["arithmetic", "claim", "model", "ode", "record", "reference", "rotation", "simulate"]),
    ("gates", &["arithmetic", "claim", "measure", "model", "quantity", "record", "schemes"]),
    (
        "study",
        &[
            "arithmetic",
            "interrupt",
            "journal",
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
        &[
            "claim",
            "interrupt",
            "journal",
            "model",
            "ode",
            "record",
            "rotation",
            "scenes",
            "schemes",
            "simulate",
        ],
    ),
    (
        "campaign",
        &[
            "claim",
            "engine",
            "gates",
            "interrupt",
            "journal",
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
    ("inspect", &["bounded", "fault", "model", "rotation", "scenes"]),
    (
        "log",
        &[
            "bounded",
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
            "study",
            "words",
        ],
    ),
    (
        "self_test",
        &[
            "arithmetic",
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
    ("report", &["interrupt", "quantity", "record"]),
    (
        "cli",
        &[
            "arithmetic",
            "bounded",
            "campaign",
            "claim",
            "engine",
            "fault",
            "gates",
            "inspect",
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
    (
        "prelude",
        &[
            "arithmetic",
            "assertion",
            "campaign",
            "model",
            "record",
            "report",
            "scenes",
            "schemes",
            "simulate",
        ],
    ),
    ("guide", &["campaign", "model", "prelude", "record", "scenes", "schemes", "simulate"]),
];

/// A room of `study`, and the other rooms of `study` that it may use.
const STUDIES: &[(&str, &[&str])] = &[
    ("cause", &[]),
    ("cost", &[]),
    ("expect", &[]),
    ("precision", &[]),
    ("published", &[]),
    ("ensemble", &[]),
    ("advice", &["cost"]),
    ("stability", &["ensemble"]),
    ("sweep", &["ensemble"]),
];

/// What a scheme must not know: who examines it, and on what.
const EXAMINERS: [&str; 11] = [
    "scenes",
    "reference",
    "simulate",
    "measure",
    "gates",
    "campaign",
    "study",
    "record",
    "engine",
    "report",
    "self_test",
];

/// The other rooms that a room names.
fn used_rooms(room: &str) -> BTreeSet<String> {
    let files: Vec<File> = sources::of("src").into_iter().filter(|file| file.is_in(room)).collect();
    assert!(!files.is_empty(), "room {room} has no source");
    let mut used: BTreeSet<String> =
        files.iter().flat_map(|file| file.paths().into_iter().map(|path| path[0].clone())).collect();
    used.remove(room);
    // Links of the documentation name functions and types, too.
    used.retain(|name| ROOMS.contains(&name.as_str()) || HELPERS.contains(&name.as_str()));
    used
}

#[test]
fn the_rooms_are_those_of_the_layout() {
    let entries = fs::read_dir(sources::root().join("src")).expect("a folder");
    let mut found: BTreeSet<String> = entries
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("a name"))
        .map(|name| name.trim_end_matches(".rs").to_owned())
        .collect();
    for root in ["lib", "main"] {
        assert!(found.remove(root), "src/{root}.rs");
    }
    let expected: BTreeSet<String> = ROOMS.iter().chain(&HELPERS).map(|name| (*name).to_owned()).collect();
    let odd: Vec<&String> = found.symmetric_difference(&expected).collect();
    assert!(odd.is_empty(), "only in src, or only in the layout: {odd:?}");
}

#[test]
fn dependencies_point_one_way() {
    for (room, allowed) in EDGES {
        for used in used_rooms(room) {
            assert!(allowed.contains(&used.as_str()), "{room} uses {used}, which the design does not allow");
        }
    }
}

#[test]
fn every_module_stands_in_the_table_and_in_the_order_of_dependency() {
    let library = sources::of("src").into_iter().find(|file| file.path.ends_with("lib.rs")).expect("lib.rs");
    let declared: Vec<String> = library.declared().into_iter().map(|module| module.name).collect();
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
    let used = used_rooms("schemes");
    for examiner in EXAMINERS {
        assert!(ROOMS.contains(&examiner) && !used.contains(examiner), "schemes use {examiner}");
    }
}

#[test]
fn a_study_uses_no_other_studies_than_its_table_allows() {
    let mut met = BTreeSet::new();
    for file in sources::of("src").iter().filter(|file| file.is_in("study")) {
        let Some(own) = file.module.get(1) else { continue };
        met.insert(own.clone());
        let (_, allowed) = STUDIES.iter().find(|(name, _)| name == own).expect("a row for every study");
        for path in file.paths().iter().filter(|path| path[0] == "study") {
            let used = path.get(1).map_or("several studies at once", String::as_str);
            assert!(used == own || allowed.contains(&used), "{}: {own} uses {used}", file.path.display());
        }
    }
    assert_eq!(met.len(), STUDIES.len());
}
