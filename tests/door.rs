//! The door: what a user of the crate and of the program meets first.

use std::fs;
use std::path::Path;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path)
}

/// Modules of the command line that several subcommands may use.
const SHARED: [&str; 5] = ["exit", "output", "progress", "select", "Failure"];

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
