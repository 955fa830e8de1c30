//! Commands that are killed while they write, and go on until they end.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};
use serde_json::Value;

use crate::common::program::{code, polhode_in, scratch, stderr};

/// A command that writes into the folder that it runs in.
pub struct Killed {
    pub arguments: Vec<&'static str>,
    /// The file that its rows stand beside.
    pub file: &'static str,
    /// Its exit code.
    pub code: i32,
}

/// A report, a gate, a study of stability and a sweep that take a second or two.
pub fn commands() -> [Killed; 4] {
    let of = |text: &'static str| text.split_whitespace().collect::<Vec<_>>();
    [
        Killed {
            arguments: of(
                "report free-asymmetric free-rod kovalevskaya --scheme euler --scheme peskin-rk2 --out .",
            ),
            file: "records.json",
            code: 0,
        },
        Killed {
            arguments: of(
                "gate free-asymmetric kovalevskaya dzhanibekov free-oblate free-rod --scheme euler --scheme peskin-rk2 --json now.json",
            ),
            file: "now.json",
            code: 0,
        },
        Killed {
            arguments: of(
                "stability free-asymmetric free-rod --scheme peskin-rk2 --scheme euler --cells 6 --long 20000 --out .",
            ),
            file: "stability.json",
            code: 0,
        },
        Killed {
            arguments: of(
                "sweep free-asymmetric --vary step=0.01:0.1:7 --vary initial.angular_momentum.2=1:2:5 --scheme euler --scheme rk4-quaternion --out f.csv",
            ),
            file: "f.csv",
            code: 0,
        },
    ]
}

impl Killed {
    /// What an unbroken run writes.
    pub fn unbroken(&self) -> Written {
        let folder = scratch();
        let output = polhode_in(folder.path(), &[&self.arguments[..], &["--quiet"]].concat());
        assert_eq!(code(&output), self.code, "{:?}: {}", self.arguments, stderr(&output));
        Written::of(folder.path(), self.file)
    }

    /// Kills it at moments that the bytes in its folder name, `often` of them on its way, until it ends before one, and compares what it has
    /// written. Returns the kills.
    pub fn killed_until_it_ends(&self, whole: &Written, often: u64, random: &mut TestRng) -> usize {
        let folder = scratch();
        for kills in 0.. {
            let more = random.next_u64() % (2 * whole.bytes / often);
            let mut child = self.spawn(folder.path());
            let end = bytes(folder.path()) + more;
            while bytes(folder.path()) < end && child.try_wait().expect("a status").is_none() {
                std::thread::sleep(Duration::from_micros(100));
            }
            let ended = child.try_wait().expect("a status");
            let _ = child.kill();
            child.wait().expect("it ends");
            self.is_readable(folder.path());
            if let Some(status) = ended {
                assert_eq!(status.code(), Some(self.code), "{:?}", self.arguments);
                let written = Written::of(folder.path(), self.file);
                assert!(written.files == whole.files, "{:?}: {:?}", self.arguments, written.files);
                assert!(written.text == whole.text, "{:?} differs after {kills} kills", self.arguments);
                return kills;
            }
        }
        unreachable!("it ends")
    }

    fn spawn(&self, folder: &Path) -> Child {
        Command::new(env!("CARGO_BIN_EXE_polhode"))
            .current_dir(folder)
            .args(&self.arguments)
            .args(["--resume", "--quiet"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program runs")
    }

    /// Every row but one that is cut can be read, a file that has its name is whole, and no file is left that is not of the command.
    fn is_readable(&self, folder: &Path) {
        let rows = fs::read(folder.join(format!("{}.rows", self.file))).unwrap_or_default();
        let end = rows.iter().rposition(|byte| *byte == b'\n').map_or(0, |last| last + 1);
        for line in String::from_utf8_lossy(&rows[..end]).lines() {
            serde_json::from_str::<Value>(line).unwrap_or_else(|error| panic!("{error}: {line}"));
        }
        for name in names(folder) {
            let temporary = name.contains(".polhode-") && name != ".polhode-manifest";
            assert!(!temporary, "{:?} leaves {name}", self.arguments);
            if name.ends_with(".json") {
                let text = fs::read_to_string(folder.join(&name)).expect("text");
                serde_json::from_str::<Value>(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
            }
        }
    }
}

/// What a command wrote, without times.
pub struct Written {
    text: String,
    files: BTreeSet<String>,
    bytes: u64,
}

impl Written {
    fn of(folder: &Path, file: &str) -> Written {
        let text = fs::read_to_string(folder.join(file)).expect("written");
        let text = match serde_json::from_str::<Value>(&text) {
            Ok(mut value) => {
                leave_times_out(&mut value);
                value.to_string()
            }
            Err(_) => text,
        };
        Written { text, files: names(folder), bytes: bytes(folder) }
    }
}

/// Times of the machine are measured anew.
fn leave_times_out(value: &mut Value) {
    const TIMES: [&str; 7] =
        ["made_at", "machine", "costs", "scaling", "seconds", "nanoseconds_per_step", "reduction_speedup"];
    match value {
        Value::Object(map) => {
            map.retain(|key, _| !TIMES.contains(&key.as_str()));
            map.values_mut().for_each(leave_times_out);
        }
        Value::Array(list) => list.iter_mut().for_each(leave_times_out),
        _ => {}
    }
}

/// The files in a folder and below, by their paths.
fn names(folder: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).expect("inside");
                found.insert(name.to_string_lossy().into_owned());
            }
        }
    }
    found
}

/// Bytes of these files.
fn bytes(folder: &Path) -> u64 {
    names(folder).iter().filter_map(|name| fs::metadata(folder.join(name)).ok()).map(|file| file.len()).sum()
}

/// Random numbers of a seed.
pub fn random(seed: u8) -> TestRng {
    TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32])
}
