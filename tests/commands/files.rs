//! Nothing of the user's is lost: what is written where, what is in the way, and inputs without an end.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use crate::common::program::{code, polhode, scratch, stderr, stdout};

const RUN: [&str; 6] = ["run", "free-rod", "--scheme", "euler", "--steps", "10"];

fn run(more: &[&str]) -> Output {
    polhode(&[&RUN[..], more].concat())
}

#[test]
fn a_file_of_another_origin_is_kept_unless_forced_and_one_of_this_program_is_replaced() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let (file, scene) = (at("file"), ["--scene", "free-rod", "--scheme", "euler", "--quiet"]);
    let commands: [Vec<&str>; 8] = [
        [&RUN[..], &["--out", &file]].concat(),
        [&RUN[..], &["--format", "csv", "--out", &file]].concat(),
        [&["gate", "--json", &file][..], &scene].concat(),
        [&["gate", "--junit", &file][..], &scene].concat(),
        vec!["engine", "new", "--language", "python", "--out", &file],
        vec!["reference", "free-rod", "--digits", "5", "--out", &file],
        vec!["sweep", "free-rod", "--quiet", "--vary", "step=0.1:0.2:2", "--out", &file, "--force"],
        vec!["sweep", "free-rod", "--quiet", "--vary", "step=0.1:0.2:2", "--plot", &file],
    ];
    for command in commands {
        fs::write(&file, "my notes").expect("written");
        let forced = command.contains(&"--force");
        if !forced {
            let refused = polhode(&command);
            assert_eq!(code(&refused), 74, "{command:?}: {}", stderr(&refused));
            assert!(stderr(&refused).contains("--force"), "{}", stderr(&refused));
            assert_eq!(fs::read_to_string(&file).expect("kept"), "my notes", "{command:?}");
        }
        let replaced = polhode(&[&command[..], if forced { &[] } else { &["--force"] }].concat());
        assert_eq!(code(&replaced), 0, "{command:?}: {}", stderr(&replaced));
        // A file of the command itself is not in the way; a picture does not tell what it is of.
        if !command.contains(&"--plot") && !forced {
            let again = polhode(&command);
            assert_eq!(code(&again), 0, "{command:?}: {}", stderr(&again));
        }
    }
}

#[test]
fn a_mistyped_folder_is_found_before_measuring_and_is_not_made() {
    let folder = scratch();
    let missing = folder.path().join("no/such/file").to_string_lossy().into_owned();
    for command in [
        vec!["gate", "--scheme", "all", "--json", &missing],
        vec!["gate", "--scheme", "all", "--junit", &missing],
        vec!["run", "free-rod", "--scheme", "euler", "--steps", "100000000", "--out", &missing],
        vec!["reference", "kovalevskaya", "--out", &missing],
        vec!["engine", "new", "--language", "c", "--out", &missing],
        vec!["sweep", "free-rod", "--vary", "step=1e-6:2e-6:100", "--out", &missing],
    ] {
        let before = Instant::now();
        let output = polhode(&command);
        assert_eq!(code(&output), 74, "{command:?}: {}", stderr(&output));
        assert!(before.elapsed() < Duration::from_secs(2), "{command:?}: {:?}", before.elapsed());
        assert!(!folder.path().join("no").exists(), "{command:?}");
    }
}

#[test]
fn a_report_removes_and_overwrites_only_what_an_earlier_one_made() {
    let folder = scratch();
    let out = folder.path().join("report");
    fs::create_dir_all(out.join("plots")).expect("made");
    for name in ["plots/mine.png", "plots/overview.png", "notes.txt"] {
        fs::write(out.join(name), "mine").expect("written");
    }
    let report = |scene: &str| {
        let options = ["report", "--quiet", "--scheme", "euler", "--scene", scene, "--out"];
        let output = polhode(&[&options[..], &[&out.to_string_lossy()]].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
    };
    report("free-asymmetric");
    assert!(out.join("plots/free-asymmetric-convergence.png").exists());
    report("kovalevskaya");
    assert!(!out.join("plots/free-asymmetric-convergence.png").exists());
    assert!(out.join("plots/kovalevskaya-convergence.png").exists());
    for name in ["plots/mine.png", "plots/overview.png.kept", "notes.txt"] {
        assert_eq!(fs::read_to_string(out.join(name)).expect("kept"), "mine", "{name}");
    }
    let theirs = folder.path().join("theirs");
    fs::create_dir(&theirs).expect("made");
    fs::write(theirs.join("index.html"), "my page").expect("written");
    let before = Instant::now();
    let refused = polhode(&["report", "--quiet", "--out", &theirs.to_string_lossy()]);
    assert_eq!((code(&refused), before.elapsed() < Duration::from_secs(2)), (74, true));
    assert_eq!(fs::read_to_string(theirs.join("index.html")).expect("kept"), "my page");
}

#[test]
fn a_report_is_drawn_again_from_its_records_and_never_from_those_that_are_cut() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    let text = |name: &str| at(name).to_string_lossy().into_owned();
    let report = |arguments: &[&str]| polhode(&[&["report", "--quiet"], arguments].concat());
    let first = report(&["free-rod", "--scheme", "euler", "--out", &text("first")]);
    assert_eq!(code(&first), 0, "{}", stderr(&first));
    let records = text("first/records.json");
    let again = report(&["--from", &records, "--out", &text("again")]);
    assert_eq!(code(&again), 0, "{}", stderr(&again));
    for name in ["index.html", "pages/scene-free-rod.html", "records.json"] {
        let [one, other] = ["first", "again"].map(|out| fs::read(at(out).join(name)).expect("written"));
        assert!(one == other, "{name}");
    }
    let single = report(&["--from", &records, "--single-file", "--out", &text("single")]);
    assert_eq!(code(&single), 0, "{}", stderr(&single));
    assert!(at("single/index.html").exists() && !at("single/pages").exists());
    let whole = fs::read_to_string(&records).expect("written");
    let other = whole.replace("polhode/records/1", "polhode/records/0");
    for (name, text_of_it) in
        [("cut.json", &whole[..whole.len() / 2]), ("other.json", &other), ("empty.json", "")]
    {
        fs::write(at(name), text_of_it).expect("written");
        let refused = report(&["--from", &text(name), "--out", &text("refused")]);
        assert_eq!(code(&refused), 65, "{name}: {}", stderr(&refused));
        assert!(stderr(&refused).contains(name) && !at("refused").join("index.html").exists());
    }
}

#[test]
fn a_run_is_drawn_beside_its_states() {
    let folder = scratch();
    let picture = folder.path().join("run.png");
    let arguments =
        ["run", "dzhanibekov", "--quiet", "--format", "csv", "--plot", &picture.to_string_lossy()];
    let output = polhode(&arguments);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(stdout(&output).lines().count() > 100);
    assert!(fs::read(&picture).expect("written").starts_with(b"\x89PNG"));
    // A picture of this program is replaced, a file of another origin is kept.
    assert_eq!(code(&polhode(&arguments)), 0);
    fs::write(&picture, "another's").expect("written");
    assert_eq!(code(&polhode(&arguments)), 74);
    assert_eq!(fs::read(&picture).expect("kept"), b"another's");
}

#[test]
fn a_report_of_one_scene_has_a_folder_of_its_own() {
    let folder = scratch();
    let latest = folder.path().join("reports/latest");
    fs::create_dir_all(&latest).expect("made");
    fs::write(latest.join("index.html"), "the whole report").expect("written");
    let output = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["report", "--quiet", "free-rod", "--scheme", "euler"])
        .current_dir(folder.path())
        .output()
        .expect("the program runs");
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(folder.path().join("reports/free-rod_euler/index.html").exists());
    assert_eq!(fs::read_to_string(latest.join("index.html")).expect("kept"), "the whole report");
}

#[cfg(target_os = "linux")]
#[test]
fn devices_pipes_and_links_are_written_through() {
    use std::os::unix::fs::FileTypeExt;
    let full = run(&["--out", "/dev/full"]);
    assert_eq!(code(&full), 74, "{}", stderr(&full));
    assert!(Path::new("/dev/full").metadata().expect("there").file_type().is_char_device());
    let through = run(&["--out", "/dev/stdout"]);
    assert_eq!((code(&through), stdout(&through)), (0, stdout(&run(&[]))));
    let folder = scratch();
    let (real, link) = (folder.path().join("real.json"), folder.path().join("link.json"));
    std::os::unix::fs::symlink("real.json", &link).expect("a link");
    for _ in 0..2 {
        assert_eq!(code(&run(&["--out", &link.to_string_lossy()])), 0);
        assert!(link.is_symlink());
        assert_eq!(fs::read_to_string(&real).expect("written"), stdout(&through));
    }
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo runs").success());
    let reader =
        Command::new("cat").arg(&pipe).stdout(std::process::Stdio::piped()).spawn().expect("cat runs");
    assert_eq!(code(&run(&["--out", &pipe.to_string_lossy()])), 0);
    let read = reader.wait_with_output().expect("it ends");
    assert_eq!(String::from_utf8_lossy(&read.stdout), stdout(&through));
    assert!(pipe.metadata().expect("there").file_type().is_fifo());
}

#[cfg(target_os = "linux")]
#[test]
fn an_input_without_an_end_is_65_at_once() {
    for command in [
        vec!["run", "/dev/zero", "--scheme", "euler", "--steps", "4"],
        vec!["gate", "--scene", "/dev/zero"],
        vec!["judge", "/dev/zero", "--scene", "free-rod"],
        vec!["judge", "/dev/urandom", "--scene", "free-rod"],
        vec!["inspect", "/dev/zero"],
        vec!["inspect", "/dev/urandom"],
        vec!["gate", "--from", "/dev/zero"],
        vec!["gate", "--baseline", "/dev/zero"],
        vec!["sweep", "/dev/zero", "--vary", "step=1:2:2"],
    ] {
        let before = Instant::now();
        let output = polhode(&command);
        assert_eq!(code(&output), 65, "{command:?}: {}", stderr(&output));
        assert!(before.elapsed() < Duration::from_secs(1), "{command:?}: {:?}", before.elapsed());
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_that_no_program_writes_is_74() {
    let folder = scratch();
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo runs").success());
    let pipe = pipe.to_string_lossy();
    for command in [&["judge", &pipe, "--scene", "free-rod"][..], &["inspect", &pipe]] {
        let output = polhode(command);
        assert_eq!(code(&output), 74, "{command:?}: {}", stderr(&output));
    }
}
