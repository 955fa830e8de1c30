//! Every file of Rust is built and seen by `cargo fmt`, and every scheme stands in the list.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::sources::{self, File};

/// Files of `src/schemes` that are no scheme: what schemes share, cards, and solvers that choose their steps.
const NO_SCHEME: [&str; 24] = [
    "accelerations",
    "adaptive",
    "body_form",
    "card",
    "cayley",
    "collocation",
    "composed",
    "dormand_prince_8",
    "equations",
    "families",
    "fields",
    "iteration",
    "loads",
    "multipliers",
    "preprocessing",
    "pulls",
    "semi_implicit",
    "small",
    "series",
    "splitting",
    "substepped",
    "trees",
    "vector_form",
    "mod",
];

/// Where laws are named one by one: their own files, the reference and the Taylor series with their transcriptions, special cases that a study or a
/// measurement is about, and defects.
const LAWS_BY_NAME: [&str; 12] = [
    "src/campaign/scaling.rs",
    "src/measure/invariants.rs",
    "src/model/forces",
    "src/reference",
    "src/schemes/taylor",
    "src/self_test/planted.rs",
    "src/study/cause.rs",
    "src/study/stability/amplification.rs",
    "src/study/stability/bench.rs",
    "src/study/stability/kink.rs",
    "src/study/stability/maps/drag.rs",
    "src/study/stability/theory.rs",
];

/// A path without `..` in it.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        if part.as_os_str() == ".." {
            plain.pop();
        } else {
            plain.push(part);
        }
    }
    plain
}

/// A file and all those that its `mod` lines lead to. A macro that writes such lines hides the files from
/// `cargo fmt`.
fn follow(path: &Path, is_root: bool, met: &mut BTreeSet<PathBuf>) {
    met.insert(path.to_owned());
    let folder = path.parent().expect("a folder");
    let inside =
        if is_root || path.ends_with("mod.rs") { folder.to_owned() } else { path.with_extension("") };
    for module in File::read(&sources::root().join(path)).declared() {
        let places = match module.path {
            Some(given) => vec![plain(&folder.join(given))],
            None => {
                vec![inside.join(format!("{}.rs", module.name)), inside.join(&module.name).join("mod.rs")]
            }
        };
        let place = places.iter().find(|place| sources::root().join(place).exists());
        follow(place.expect("a file for every module"), false, met);
    }
}

#[test]
fn every_file_is_reached_by_plain_mod_lines() {
    let mut met = BTreeSet::new();
    for root in ["src/lib.rs", "src/main.rs"] {
        follow(Path::new(root), true, &mut met);
    }
    let all = || ["src", "tests", "benches", "examples"].into_iter().flat_map(sources::of);
    for file in all().filter(|file| !file.path.starts_with("src")) {
        let depth = file.path.components().count();
        if depth == 2 || (depth == 3 && file.path.ends_with("main.rs")) {
            follow(&file.path, true, &mut met);
        }
    }
    let lost: Vec<PathBuf> = all().map(|file| file.path).filter(|path| !met.contains(path)).collect();
    assert!(lost.is_empty(), "no plain mod line leads to {lost:?}");
    assert!(met.len() > 200);
}

/// The module and the type of every entry of the list.
fn listed(text: &str) -> Vec<(String, String)> {
    let (_, list) = text.split_once("\nlist! {\n").expect("the list");
    let (list, _) = list.split_once("\n}").expect("its end");
    let entries = list.lines().filter_map(|line| line.trim().trim_end_matches([',', ';']).split_once("::"));
    // The values of a scheme with parameters stand behind it in brackets.
    let name = |scheme: &str| scheme.split(' ').next().unwrap_or_default().to_owned();
    entries.map(|(module, scheme)| (module.to_owned(), name(scheme))).collect()
}

/// `StrangRotations` of `strang_rotations`.
fn type_of(module: &str) -> String {
    let capital = |part: &str| part[..1].to_uppercase() + &part[1..];
    module.split('_').map(capital).collect()
}

#[test]
fn every_scheme_file_stands_in_the_list() {
    let files = sources::of("src/schemes");
    let module = files.iter().find(|file| file.path.ends_with("schemes/mod.rs")).expect("mod.rs");
    let list = listed(&module.text);
    let names: BTreeSet<String> = files
        .iter()
        .map(|file| file.path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    let mut expected: BTreeSet<String> = NO_SCHEME.iter().map(|name| (*name).to_owned()).collect();
    for (module, scheme) in &list {
        assert_eq!(*scheme, type_of(module));
        assert!(expected.insert(module.clone()), "{module} stands twice, or is no scheme");
    }
    let odd: Vec<&String> = names.symmetric_difference(&expected).collect();
    assert!(odd.is_empty(), "only in src/schemes, or only in its list: {odd:?}");
    assert!(list.len() >= 44);
}

#[test]
fn no_other_file_names_a_law() {
    let names_a_law = |text: &str| {
        text.split("Law::").skip(1).any(|rest| {
            let name: String = rest.chars().take_while(|c| c.is_ascii_alphanumeric()).collect();
            // `Law::ALL` and `Law::NAMES` are lists, `Law::build` is a function.
            name.starts_with(|c: char| c.is_ascii_uppercase())
                && name.contains(|c: char| c.is_ascii_lowercase())
        })
    };
    let mut met = BTreeSet::new();
    for file in sources::of("src").iter().filter(|file| names_a_law(&file.text)) {
        let allowed = LAWS_BY_NAME.iter().find(|place| file.path.starts_with(place));
        met.insert(allowed.unwrap_or_else(|| panic!("{} names a law", file.path.display())));
    }
    assert_eq!(met.len(), LAWS_BY_NAME.len() - 1, "a place names no law: {met:?}");
}
