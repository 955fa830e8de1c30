//! Scripts that play engines.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use crate::common::program::scratch;

/// What a script says to hello where it says the right thing.
pub const HELLO: &str = r#"read -r line; echo '{"polhode":1,"name":"script","forces":[]}'"#;

/// An answer to the question with id 1 for a run of one step.
pub const ANSWER: &str = r#"{"id":1,"states":[{"step":0,"position":[0.5,-1,2],"orientation":[1,0,0,0],"velocity":[0,0,0],"angular_velocity":[0,0,1]},{"step":1,"position":[1,2,3],"orientation":[0,1,0,0],"velocity":[4,5,6],"angular_velocity":[7,8,9]}],"elapsed_ns":4000,"evaluations":3}"#;

pub struct Stage {
    folder: tempfile::TempDir,
}

impl Stage {
    pub fn new() -> Stage {
        Stage { folder: scratch() }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_default()
    }

    /// A scheme that is played by a script; `$here` in it is a folder of its own.
    pub fn script(&self, text: &str) -> String {
        let path = self.path("engine.sh");
        fs::write(&path, format!("here='{}'\n{text}\n", self.folder.path().display())).expect("written");
        format!("engine:sh '{}'", path.display())
    }
}

/// Whether a process runs, or becomes nothing within a second.
pub fn runs(process: &str) -> bool {
    let since = Instant::now();
    while since.elapsed() < Duration::from_secs(1) {
        // A zombie of somebody else's still has a file, but no command line.
        let command = fs::read(format!("/proc/{}/cmdline", process.trim())).unwrap_or_default();
        if command.is_empty() {
            return false;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    true
}

/// The engine of the examples, built where this test was asked for alone.
pub fn example() -> &'static str {
    static PATH: OnceLock<String> = OnceLock::new();
    PATH.get_or_init(|| {
        let folder = Path::new(env!("CARGO_BIN_EXE_polhode")).parent().expect("a folder");
        let path = folder.join("examples").join("engine");
        if !path.exists() {
            let mut cargo = Command::new(env!("CARGO"));
            cargo.args(["build", "--example", "engine"]);
            if !cfg!(debug_assertions) {
                cargo.arg("--release");
            }
            assert!(cargo.status().expect("cargo runs").success());
        }
        path.to_string_lossy().into_owned()
    })
}
