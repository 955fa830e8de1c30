//! Scene files and command lines with random changes. A command that takes one ends with an exit code that the interfaces list, and without a
//! panic; one that works for long ends when it is interrupted.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use polhode::scenes::{FILES, Scene};
use tempfile::TempDir;

use crate::changed_logs::Chance;
use crate::common::pieces::PIECES;
use crate::common::program::scratch;

/// The exit codes of the interfaces.
const LISTED: [i32; 8] = [0, 1, 2, 64, 65, 69, 74, 130];
/// Time after which a command is interrupted. It is a guard against a command that hangs, and no bound of its speed.
const PATIENCE: Duration = Duration::from_secs(10);
/// Time after which an interrupted command hangs.
const HANGS: Duration = Duration::from_secs(20);
/// Scene files of more bytes are left out: most of their changes are of one kind.
const LONGEST: usize = 6000;
/// A scene that can be read is judged, too, once in so many.
const JUDGED: usize = 8;

/// A command that works as it stands, and options of it with values that it takes, separated by `|`.
const COMMANDS: [(&str, &str); 22] = [
    (
        "report free-rod --scheme euler",
        "--brief --capsule=c.json --format=markdown|json --from=now.json|scene.toml --full --out=o --resume --single-file --svg --force",
    ),
    (
        "gate free-rod --scheme euler",
        "--baseline=now.json|b.json --budget=0.1|5 --format=json --from=now.json|scene.toml --github --json=j.json --junit=j.xml --markdown=m.md --sarif=s.sarif --benchmark=b.json --order=1|12 --resume --verbose --force",
    ),
    (
        "bless free-rod --scheme euler --reason why",
        "--baseline=b.json|now.json --by=me --format=json --from=now.json|scene.toml --force",
    ),
    ("init", "--schema --force"),
    ("compare euler peskin-rk2 free-rod", "--all --format=text|csv|json|markdown|latex --scene=free-sphere"),
    ("compare now.json now.json", "--all --format=json"),
    (
        "run free-rod --scheme euler",
        "--duration=0.5|1e-300|3 --every=1|1000 --format=json|csv --model=least|points --out=o.json --plot=p.png --precision=f32|double-double --step=0.01|7|1e300 --steps=1|1000 --force",
    ),
    (
        "advise free-rod --scheme euler --tolerance 1e-2",
        "--duration=0.5|3 --format=text|json --precision=f32 --quantity=orientation|position|velocity --top=1|100",
    ),
    ("expect free-rod --scheme euler --step 0.05", "--format=json --quantity=orientation|position"),
    (
        "sweep free-rod --scheme euler --vary step=0.1:0.2:2",
        "--errors=always|never --format=json --out=f.csv --plot=p.png --quantity=orientation --resume --show=euler --step=0.1 --vary=duration=1:2:3|initial.angular_momentum.2=1:1e300:2:log --force",
    ),
    ("engine new --language c", "--out=e.c --language=python|julia --force"),
    ("engine check /no/such/program", "--contract --format=json"),
    (
        "stability free-rod --scheme euler --cells 2 --long 10 --out o",
        "--cells=1|3 --format=json|svg --long=1|100 --resume --force",
    ),
    (
        "judge log.csv --scene free-rod",
        "--angle-unit=deg|rad --angular-velocity=world|body --as-found --columns=t=t --errors=e.csv --format=json --from-log --json=j.json --plot=p.png --quantity=orientation --quaternion=world-to-body --time-unit=ms --tolerance=1e-2",
    ),
    ("inspect scene.toml", "--format=json --out=o.toml --verbose"),
    (
        "reference free-rod --digits 5",
        "--digits=1|30 --every=1 --format=text|json|csv --out=r.json --times=0,1|1e-300 --force",
    ),
    ("replay now.json", "--jobs=1 --format=json"),
    ("self-test --print 1", "--extreme --seed=7 --print=0|99999999999 --format=json"),
    ("list schemes", "--format=json --schema"),
    ("scene show scene.toml", "--quiet"),
    ("scene new mine", "--from=free-rod"),
    ("completions bash", "--man=o"),
];

/// Options of every command.
const EVERYWHERE: &str = "--jobs=1|2 --quiet --color=always|never --config=c.toml --engine-timeout=1 --engine-memory=100 --input-limit=1 --scene=free-rod|scene.toml --scheme=euler|peskin-rk2";

/// Values that few options take.
const VALUES: [&str; 34] = [
    "",
    "0",
    "-1",
    "NaN",
    "inf",
    "1e999",
    "1e308",
    "1e-320",
    "18446744073709551616",
    "0.1",
    "abc",
    "ß日本",
    "\u{202e}",
    "'",
    "a b",
    "--",
    "=",
    "a=b",
    "no/such/file",
    "no/such/folder/x.json",
    ".",
    "/dev/null",
    "/dev/zero",
    "/dev/full",
    "engine:",
    "engine:/no/such",
    "engine:'",
    "substepped-0-euler",
    "substepped-99999999999-euler",
    "step=1:0:0",
    "step=nan:1:3",
    "\n",
    "{}",
    "1,2,3",
];

/// A folder with a scene, a log, settings of few steps and records.
pub fn stage() -> TempDir {
    let folder = scratch();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    write("scene.toml", &Scene::text("free-rod").expect("a built-in scene"));
    write("log.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n0.1,1,0,0,0\n");
    write("c.toml", "[[ladders]]\ncoarsest = 8\nfinest = 64\n");
    let gate = words("gate free-rod --scheme euler --config c.toml --quiet --json now.json");
    assert_eq!(ended(folder.path(), &gate, b""), 0);
    folder
}

fn words(line: &str) -> Vec<String> {
    line.split_whitespace().map(str::to_owned).collect()
}

/// Runs a command to its end, or to its end after an interrupt. Returns its exit code, which is a listed one. `scene` is shown where it is not.
fn ended(folder: &Path, arguments: &[String], scene: &[u8]) -> i32 {
    let context = || format!("{arguments:?}\n{}", String::from_utf8_lossy(scene));
    let log = folder.join("stderr.txt");
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .current_dir(folder)
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(File::create(&log).expect("a log"))
        .spawn()
        .expect("the program runs");
    let begun = Instant::now();
    let mut interrupted = false;
    let status = loop {
        if let Some(status) = child.try_wait().expect("a status") {
            break status;
        }
        if begun.elapsed() > PATIENCE && !interrupted {
            let id = child.id().to_string();
            assert!(Command::new("kill").args(["-INT", &id]).status().expect("kill runs").success());
            interrupted = true;
        }
        if begun.elapsed() > PATIENCE + HANGS {
            child.kill().expect("killed");
            panic!("{} hangs", context());
        }
        std::thread::sleep(Duration::from_millis(1));
    };
    let said = String::from_utf8_lossy(&fs::read(&log).expect("a log")).into_owned();
    let code = status.code().unwrap_or_else(|| panic!("{}: {status}", context()));
    assert!(LISTED.contains(&code) && !said.contains("panicked at"), "{}: {code}: {said}", context());
    assert!(code != 130 || interrupted, "{arguments:?}");
    code
}

/// A built-in scene with one to three changes: a number is another one, some bytes are others, or a line goes or comes twice.
fn scene(texts: &[&str], chance: &mut Chance) -> Vec<u8> {
    let mut text = texts[chance.below(texts.len())].as_bytes().to_vec();
    for _ in 0..1 + chance.below(3) {
        let piece = PIECES[chance.below(PIECES.len())].bytes();
        match chance.below(10) {
            0..5 => {
                let numbers: Vec<(usize, usize)> = numbers(&text);
                if let Some((start, end)) = numbers.get(chance.below(numbers.len().max(1))) {
                    text.splice(start..end, piece);
                }
            }
            5..8 => {
                let start = chance.below(text.len() + 1);
                let end = (start + chance.below(12)).min(text.len());
                text.splice(start..end, piece);
            }
            other => {
                let mut lines: Vec<Vec<u8>> = text.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
                let line = lines.remove(chance.below(lines.len()));
                if other == 8 {
                    let place = chance.below(lines.len() + 1);
                    lines.insert(place, line.clone());
                    lines.insert(place, line);
                }
                text = lines.join(&b'\n');
            }
        }
    }
    text
}

/// Where numbers stand in a text.
fn numbers(text: &[u8]) -> Vec<(usize, usize)> {
    let is_part = |byte: &u8| byte.is_ascii_digit() || b".-".contains(byte);
    let mut found = Vec::new();
    let mut start = 0;
    while let Some(first) = text[start..].iter().position(is_part).map(|place| start + place) {
        let end =
            text[first..].iter().position(|byte| !is_part(byte)).map_or(text.len(), |place| first + place);
        found.push((first, end));
        start = end;
    }
    found
}

/// Shows, runs and judges so many mutated scenes. Returns how many could be read.
pub fn take_mutated_scenes(count: usize, seed: u64) -> usize {
    let folder = stage();
    let texts: Vec<&str> = FILES.iter().map(|(_, text)| *text).filter(|text| text.len() < LONGEST).collect();
    let mut chance = Chance::of(seed);
    let mut read = 0;
    for _ in 0..count {
        let text = scene(&texts, &mut chance);
        fs::write(folder.path().join("mutated.toml"), &text).expect("written");
        let take = |line: &str| ended(folder.path(), &words(line), &text);
        if take("scene show mutated.toml") != 0 {
            continue;
        }
        read += 1;
        take("run mutated.toml --steps 3");
        if read % JUDGED == 1 {
            take("gate mutated.toml --scheme euler --config c.toml --quiet");
        }
    }
    read
}

/// A command line with one to three options more, some of them without a value, with a wrong one or given twice, and now and then with a word
/// that is another one, missing or elsewhere.
fn line(chance: &mut Chance) -> Vec<String> {
    let (command, options) = COMMANDS[chance.below(COMMANDS.len())];
    let own: Vec<&str> = options.split(' ').collect();
    let shared: Vec<&str> = EVERYWHERE.split(' ').collect();
    let mut line = words(command);
    for _ in 0..1 + chance.below(3) {
        let list = if chance.below(8) > 0 { &own } else { &shared };
        let (name, values) = split(list[chance.below(list.len())]);
        let wrong = VALUES[chance.below(VALUES.len())].to_owned();
        let right = values.map(|values| values[chance.below(values.len())].to_owned());
        let given = match chance.below(16) {
            0 => vec![name],
            1 | 2 => vec![format!("{name}={wrong}")],
            3 => vec![name, wrong],
            _ => std::iter::once(name).chain(right).collect(),
        };
        let often = if chance.below(20) == 0 { 2 } else { 1 };
        line.extend(std::iter::repeat_n(given, often).flatten());
    }
    let place = 1 + chance.below(line.len() - 1);
    match chance.below(20) {
        0 | 1 => line[place] = VALUES[chance.below(VALUES.len())].to_owned(),
        2 => drop(line.remove(place)),
        3 => line.rotate_right(place),
        _ => {}
    }
    line
}

/// `--format=json|csv` as its name and its values.
fn split(option: &str) -> (String, Option<Vec<&str>>) {
    match option.split_once('=') {
        Some((name, values)) => (name.to_owned(), Some(values.split('|').collect())),
        None => (option.to_owned(), None),
    }
}

/// Runs so many mutated command lines, each in a new folder. Returns how many of them did their work.
pub fn take_mutated_lines(count: usize, seed: u64) -> usize {
    let stage = stage();
    let mut chance = Chance::of(seed);
    let works = |line: Vec<String>| {
        let folder = scratch();
        for name in ["scene.toml", "log.csv", "c.toml", "now.json"] {
            fs::copy(stage.path().join(name), folder.path().join(name)).expect("copied");
        }
        matches!(ended(folder.path(), &line, b""), 0..=2)
    };
    (0..count).filter(|_| works(line(&mut chance))).count()
}
