//! The door: what a user of the crate and of the program meets first.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path)
}

/// Modules of the command line that several subcommands may use.
const SHARED: [&str; 8] = ["config", "exit", "measured", "output", "progress", "resume", "select", "Failure"];

#[test]
fn no_subcommand_uses_the_file_of_another_one() {
    let declared = read("src/cli/mod.rs");
    let modules = declared.lines().filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(';'));
    for module in modules.filter(|module| !SHARED.contains(module)) {
        let file = format!("src/cli/{module}.rs");
        let single = Path::new(env!("CARGO_MANIFEST_DIR")).join(&file).exists();
        let text = if single { read(&file) } else { read(&format!("src/cli/{module}/mod.rs")) };
        let used = text.lines().filter_map(|line| line.strip_prefix("use super::"));
        for path in used {
            let names: Vec<&str> = match path.strip_prefix('{') {
                Some(list) => list.trim_end_matches(['}', ';']).split(", ").collect(),
                None => path.split(&[':', ';'][..]).take(1).collect(),
            };
            for name in names {
                assert!(SHARED.contains(&name), "{module} uses {name}");
            }
        }
    }
}

#[test]
fn the_readme_quotes_the_example_to_the_letter() {
    let example = read("examples/my_scheme.rs");
    let (_, code) = example.split_once("\n\n").expect("a heading and the code");
    assert!(read("README.md").contains(&format!("```rust\n{code}```\n")));
}

#[test]
fn every_path_in_the_documents_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for document in ["README.md", "CHANGELOG.md", "references/METHODOLOGY.md"] {
        let folder = root.join(document).parent().expect("a folder").to_owned();
        let text = read(document);
        let linked = text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
        for path in linked.filter(|path| !path.starts_with("http")) {
            assert!(folder.join(path).exists(), "{document}: {path}");
        }
        let quoted = text.split('`').skip(1).step_by(2);
        let places = ["src/", "references/", "tests/", "examples/", "reports/published/"];
        for path in quoted.filter(|path| places.iter().any(|place| path.starts_with(place))) {
            assert!(root.join(path).exists(), "{document}: {path}");
        }
    }
}

#[test]
fn a_crate_that_asserts_an_order_builds_at_most_forty_crates() {
    let arguments =
        ["tree", "--no-default-features", "--edges", "normal,build", "--prefix", "none", "--offline"];
    let mut cargo = std::process::Command::new(env!("CARGO"));
    let output = cargo.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let crates: BTreeSet<&str> = text.lines().map(|line| line.trim_end_matches(" (*)")).collect();
    assert!(crates.len() > 5 && crates.len() <= 40, "{} crates", crates.len());
}
