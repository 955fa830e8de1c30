//! `polhode inspect` held against values of readers that share no code with it, and against files that are no robots.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use polhode::internals::inspect::InspectError;
use serde_json::Value;

use crate::common::program::{code, polhode, scratch, stderr, stdout};

fn robots() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("references/robots")
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect("a file")).expect("JSON")
}

fn inspect(path: &Path, options: &[&str]) -> Output {
    polhode(&[&["inspect", &path.to_string_lossy()], options].concat())
}

/// A file of `text` and its inspection.
fn inspected(name: &str, text: &str) -> Output {
    let folder = scratch();
    let path = folder.path().join(name);
    fs::write(&path, text).expect("written");
    inspect(&path, &[])
}

/// What an inspection and what is expected differ by.
#[derive(Default)]
struct Tally {
    files: usize,
    bodies: usize,
    impossible: usize,
    /// Largest relative difference of masses, centres of mass and tensors.
    largest: f64,
    wrong: Vec<String>,
}

impl Tally {
    fn expect(&mut self, what: &str, expected: &Value, found: &Value) {
        if expected != found {
            self.wrong.push(format!("{what}: expected {expected}, found {found}"));
        }
    }

    /// Two lists of numbers, relative to their largest one.
    fn near(&mut self, what: &str, expected: &[f64], found: &[f64], tolerance: f64) -> f64 {
        let scale = expected.iter().fold(0.0f64, |a, b| a.max(b.abs()));
        let off = expected.iter().zip(found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let relative = if scale > 0.0 { off / scale } else { off };
        if relative > tolerance || relative.is_nan() || expected.len() != found.len() {
            self.wrong.push(format!("{what}: expected {expected:?}, found {found:?}"));
        }
        relative
    }

    fn file(&mut self, root: &Path, name: &str, expected: &Value) {
        let output = inspect(&root.join(name), &["--format", "json"]);
        let Ok(found) = serde_json::from_str::<Value>(&stdout(&output)) else {
            self.wrong.push(format!("{name}: {}", stderr(&output)));
            return;
        };
        self.files += 1;
        self.expect(name, &expected["format"], &found["format"]);
        let (bodies, others) = (list(&expected["bodies"]), list(&found["bodies"]));
        assert_eq!(bodies.len(), others.len(), "{name}");
        for (body, other) in bodies.iter().zip(others) {
            self.body(&format!("{name} {}", body["name"]), body, other, expected);
        }
        let repairable = !list(&expected["repairs"]).is_empty() && expected["verdicts"]["rounding"].is_null();
        let cannot = ["impossible", "suspect"].iter().any(|word| !expected["verdicts"][word].is_null());
        assert_eq!(code(&output), i32::from(repairable || cannot), "{name}");
    }

    fn body(&mut self, what: &str, body: &Value, found: &Value, file: &Value) {
        for key in ["name", "verdict", "findings", "outline"] {
            self.expect(&format!("{what} {key}"), &body[key], &found[key]);
        }
        // Of the one mesh whose vertices are in the file the expected values are MuJoCo's own, and their source is named so.
        if body["source"] != "inline mesh (MuJoCo)" {
            self.expect(&format!("{what} source"), &body["source"], &found["source"]);
        }
        self.bodies += usize::from(body["source"] != "none");
        self.impossible += usize::from(found["verdict"] == "impossible");
        // Centres of mass and tensors are printed with 12 digits: half a unit is 5e-12 of the largest at most.
        for (key, other) in
            [("mass", "mass_kg"), ("com", "com_m"), ("tensor_link_axes", "tensor_link_axes_kg_m2")]
        {
            if !body[key].is_null() {
                let off =
                    self.near(&format!("{what} {key}"), &numbers(&body[key]), &numbers(&found[other]), 5e-12);
                self.largest = self.largest.max(off);
            }
        }
        // These are printed with six digits.
        for (key, other) in [
            ("fill", "fill"),
            ("uniform_ratio", "uniform_ratio"),
            ("printed_resolution", "printed_resolution_kg_m2"),
        ] {
            if !body[key].is_null() {
                self.near(&format!("{what} {key}"), &numbers(&body[key]), &numbers(&found[other]), 5e-6);
            }
        }
        if body["verdict"] == "impossible" {
            let sorted = |value: &Value| {
                let mut lines = list(value).to_vec();
                lines.sort_by_key(Value::to_string);
                Value::from(lines)
            };
            self.expect(
                &format!("{what} changes"),
                &sorted(&body["single_changes"]),
                &sorted(&found["single_changes"]),
            );
        }
        let compiled = &body["after_compiler"];
        // Moments below zero are no body that a compiler changes: MuJoCo refuses broken/05.
        if !compiled.is_null() && body["principal"][0].as_f64() > Some(0.0) {
            let after = &found["after_compiler"];
            self.near(
                &format!("{what} compiled"),
                &numbers(&compiled["mass"]),
                &numbers(&after["mass_kg"]),
                5e-12,
            );
            self.near(
                &format!("{what} compiled"),
                &numbers(&compiled["principal"]),
                &numbers(&after["principal_kg_m2"]),
                5e-12,
            );
        }
        self.repair(what, body, found, file);
    }

    fn repair(&mut self, what: &str, body: &Value, found: &Value, file: &Value) {
        let given = &found["repair"];
        let Some(repair) = list(&file["repairs"]).iter().find(|repair| repair["body"] == body["name"]) else {
            // Without an expected one, only a solid that is called one of many may be offered.
            if !given.is_null() && (given["unique"] == true || given["kind"] != "tensor-from-outline") {
                self.wrong.push(format!("{what}: an invented repair {given}"));
            }
            return;
        };
        self.expect(&format!("{what} repair"), &repair["kind"], &given["kind"]);
        self.expect(&format!("{what} unique"), &repair["unique"], &given["unique"]);
        let tensors =
            [&repair["tensor_after_link_axes"], &given["tensor_after_link_axes_kg_m2"]].map(numbers);
        // Expected is the exact outline; the files print six digits of it.
        self.near(&format!("{what} tensor"), &tensors[0], &tensors[1], 1e-5);
        if !repair["mass_after"].is_null() {
            self.near(
                &format!("{what} mass"),
                &numbers(&repair["mass_after"]),
                &numbers(&given["mass_after_kg"]),
                1e-5,
            );
        }
        if !repair["com_after"].is_null() {
            self.near(
                &format!("{what} centre"),
                &numbers(&repair["com_after"]),
                &numbers(&given["com_after_m"]),
                1e-12,
            );
        }
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// The numbers of a number, a list or an object in the order of its keys.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        Value::Object(entries) => entries.values().flat_map(numbers).collect(),
        other => vec![other.as_f64().unwrap_or(f64::NAN)],
    }
}

fn hold(root: &Path, folder: &str) -> Tally {
    let expected = json(&root.join("expected.json"));
    let mut tally = Tally::default();
    for (name, file) in expected["files"].as_object().expect("files") {
        if file["folder"] == folder && name != "controls/rejected-by-mujoco.mjcf.xml" {
            tally.file(root, name, file);
        }
    }
    tally
}

#[test]
fn every_broken_file_has_its_verdict_and_its_one_repair_or_none() {
    let tally = hold(&robots(), "broken");
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    assert_eq!((tally.files, tally.bodies, tally.impossible), (25, 39, 13));
}

#[test]
fn controls_are_read_in_every_form_and_nothing_is_held_against_them() {
    let tally = hold(&robots(), "controls");
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    assert_eq!((tally.files, tally.bodies, tally.impossible), (6, 24, 1));
    let refused = inspect(&robots().join("controls/rejected-by-mujoco.mjcf.xml"), &[]);
    assert_eq!(code(&refused), 65);
    assert!(stderr(&refused).contains(".xml:4:"), "{}", stderr(&refused));
}

#[test]
#[ignore = "needs files of others: tests/robots/run"]
fn robots_of_others() {
    let root = PathBuf::from(std::env::var("POLHODE_ROBOTS").expect("POLHODE_ROBOTS names a folder"));
    let tally = hold(&root, "real");
    let Tally { files, bodies, impossible, largest, .. } = tally;
    println!("{files} files, {bodies} bodies, {impossible} impossible; values within {largest:.1e}");
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    assert_eq!((files, bodies, impossible), (36, 475, 5));
}

#[test]
fn a_scene_is_written_for_each_body_that_can_exist_and_is_read_again() {
    let folder = scratch();
    let out = folder.path().join("scenes");
    let robot = robots().join("broken/02-kilogram-square-millimetre.urdf");
    let options = ["--out", &*out.to_string_lossy(), "--format", "json"];
    let first = inspect(&robot, &options);
    assert_eq!(code(&first), 1, "{}", stderr(&first));
    let entries = fs::read_dir(&out).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = entries.map(|name| name.to_string_lossy().into_owned()).collect();
    names.sort();
    assert_eq!(
        names,
        ["02-kilogram-square-millimetre-arm-repaired.toml", "02-kilogram-square-millimetre-base.toml"]
    );
    let repaired = out.join(&names[0]);
    let again = inspect(&repaired, &["--format", "json"]);
    assert_eq!(code(&again), 0, "{}", stderr(&again));
    let read: Value = serde_json::from_str(&stdout(&again)).expect("JSON");
    let found: Value = serde_json::from_str(&stdout(&first)).expect("JSON");
    assert_eq!(
        read["bodies"][0]["tensor_link_axes_kg_m2"],
        found["bodies"][1]["repair"]["tensor_after_link_axes_kg_m2"]
    );
    let run = polhode(&["run", &repaired.to_string_lossy(), "--scheme", "peskin-rk2", "--steps", "10"]);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    // The same once more changes nothing; a file of another origin is kept.
    assert_eq!(code(&inspect(&robot, &options)), 1);
    fs::write(&repaired, "mine").expect("written");
    assert_eq!(code(&inspect(&robot, &options)), 74);
    assert_eq!(fs::read_to_string(&repaired).expect("a file"), "mine");
}

#[test]
fn a_scene_file_is_judged_where_a_run_would_refuse_it() {
    let scene =
        |inertia: &str| format!("name = \"a\"\nduration = 1.0\n[body]\nmass = 1.0\ninertia = {inertia}\n");
    for (inertia, expected) in [
        ("[1.0, 2.0, 2.5]", 0),
        ("[[1.0, 0.1, 0.0], [0.1, 1.0, 0.0], [0.0, 0.0, 1.5]]", 0),
        ("[0.5, 2.0, 3.0]", 1),
        ("[[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.5]]", 1),
        ("[[1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.0, 0.0, 1.5]]", 65),
        ("\"heavy\"", 65),
    ] {
        assert_eq!(code(&inspected("a.toml", &scene(inertia))), expected, "{inertia}");
    }
    assert_eq!(code(&polhode(&["inspect", "references/scenes/kovalevskaya.toml"])), 0);
}

#[test]
fn files_that_are_no_robots_are_refused_with_their_line() {
    let bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE robot [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\">]>\n<robot><link name=\"&b;\"/></robot>";
    let deep = format!("<mujoco><worldbody>{}", "<body>".repeat(200_000));
    let closed = format!(
        "<mujoco><worldbody>{}{}</worldbody></mujoco>",
        "<body>".repeat(50_000),
        "</body>".repeat(50_000)
    );
    let xacro = "<robot>\n<link name=\"a\">\n<inertial>\n<mass value=\"${m}\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" \
                 izz=\"1\"/></inertial></link></robot>";
    for (text, words) in [
        ("", "not XML"),
        ("solid cube", "not XML"),
        ("<robot>\n<link name=\"a\">\n</robot>", ":3: not XML"),
        ("<html/>", "begins no robot"),
        (bomb, "document type"),
        (&deep, "not XML"),
        (&closed, "nested deeper"),
        (xacro, "<mass>: '${m}' is an expression of xacro"),
        ("<robot>\n<link/></robot>", "<link>: has no name"),
        ("<mujoco><include/></mujoco>", "has no file"),
    ] {
        let output = inspected("robot.urdf", text);
        assert_eq!(code(&output), 65, "{words}: {}", stderr(&output));
        assert!(stderr(&output).contains(words), "{words}: {}", stderr(&output));
    }
    assert_eq!(code(&inspected("robot.urdf", "<robot/>")), 2);
    assert_eq!(code(&polhode(&["inspect", "no-such-file.urdf"])), 74);
    assert_eq!(code(&polhode(&["inspect"])), 64);
}

/// Eight faults in every format: each with its line, in the order of the file.
#[test]
fn all_faults_of_a_file_are_said_at_once() {
    let urdf = "<robot name=\"r\">\n<link>\n<inertial>\n<mass value=\"heavy\"/>\n<inertia ixx=\"1\" ixy=\"0\" ixz=\"zero\" iyy=\"1\" izz=\"1\"/>\n\
                <origin xyz=\"0 0\"/>\n</inertial>\n</link>\n<link name=\"b\">\n<inertial/>\n<collision><geometry>\n<box/>\n</geometry></collision>\n\
                <visual><geometry>\n<sphere radius=\"wide\"/>\n</geometry></visual></link></robot>";
    let sdf = "<sdf version=\"1.6\"><model name=\"m\">\n<link>\n<inertial>\n<mass>heavy</mass>\n<pose>0 0 0</pose>\n<inertia>\n<ixx>a</ixx>\n\
               <iyy>b</iyy></inertia></inertial></link>\n<link name=\"b\"><collision name=\"c\"><geometry>\n<cylinder/>\n</geometry></collision></link>\n\
               </model><world><physics>\n<max_step_size>fast</max_step_size></physics></world></sdf>";
    let mjcf = "<mujoco>\n<compiler boundmass=\"a\"/>\n<compiler eulerseq=\"abc\"/>\n<option integrator=\"leapfrog\"/>\n<worldbody>\n<body>\n\
                <inertial diaginertia=\"1 2\" pos=\"0 0\"/>\n<geom type=\"star\" size=\"1\"/>\n<geom type=\"box\" size=\"1\"/>\n<composite/>\n</body></worldbody></mujoco>";
    let cases: [(&str, &str, &[usize]); 3] = [
        ("a.urdf", urdf, &[2, 4, 5, 5, 6, 10, 10, 12, 15]),
        ("a.sdf", sdf, &[2, 4, 5, 7, 8, 10, 13]),
        ("a.xml", mjcf, &[2, 3, 4, 7, 7, 7, 8, 9, 10]),
    ];
    for (name, text, lines) in cases {
        let folder = scratch();
        let path = folder.path().join(name);
        fs::write(&path, text).expect("written");
        let Err(InspectError::Content { faults, .. }) = polhode::internals::inspect::inspect(&path) else {
            panic!("{name} was read");
        };
        let found: Vec<usize> = faults.iter().map(|fault| fault.line).collect();
        assert_eq!(found, lines, "{name}: {faults:#?}");
        let output = inspect(&path, &[]);
        assert_eq!(code(&output), 65);
        for line in lines {
            assert!(stderr(&output).contains(&format!("{name}:{line}:")), "{line}: {}", stderr(&output));
        }
    }
}

#[test]
fn a_fault_in_an_included_file_is_said_with_both_places() {
    let folder = scratch();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    write("main.xml", "<mujoco>\n<include file=\"more.xml\"/>\n</mujoco>");
    write(
        "more.xml",
        "<mujoco><worldbody>\n\n<body><geom type=\"box\" size=\"1\"/></body></worldbody></mujoco>",
    );
    let output = inspect(&folder.path().join("main.xml"), &[]);
    let said = stderr(&output);
    assert!(
        code(&output) == 65 && said.contains("main.xml:2:") && said.contains("line 3 of more.xml"),
        "{said}"
    );
}

/// Fields of a megabyte and ten thousand faults: a short message.
#[test]
fn long_fields_and_many_faults_make_short_messages() {
    let long = "9".repeat(1 << 20);
    let link =
        |mass: &str| format!("<link name=\"a\"><inertial><mass value=\"{mass}\"/></inertial></link>\n");
    let many = link("x").repeat(10_000);
    for robot in [link(&long), link(&format!("{long}x")), link(&"1 ".repeat(1 << 19)), many] {
        let output = inspected("robot.urdf", &format!("<robot>\n{robot}</robot>"));
        assert_eq!(code(&output), 65);
        assert!(stderr(&output).len() < 20_000, "{}", stderr(&output).len());
    }
    let named = format!("<robot><link name=\"{long}\"/></robot>");
    assert_eq!(code(&inspected("robot.urdf", &named)), 2);
}

#[test]
fn an_included_file_is_read_once_and_a_circle_ends() {
    let folder = scratch();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    let geom = "<geom type=\"sphere\" size=\"0.1\"/>";
    write("main.xml", "<mujoco><include file=\"more.xml\"/><include file=\"absent.xml\"/></mujoco>");
    write("more.xml", &format!("<mujoco><worldbody><body name=\"ball\">{geom}</body></worldbody></mujoco>"));
    let output = inspect(&folder.path().join("main.xml"), &[]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(stdout(&output).contains("1 possible") && stdout(&output).contains("absent.xml is not there"));
    write("more.xml", "<mujoco><include file=\"main.xml\"/></mujoco>");
    let output = inspect(&folder.path().join("main.xml"), &[]);
    assert_eq!(code(&output), 65);
    assert!(stderr(&output).contains("included twice"), "{}", stderr(&output));
}

/// A byte, a number or a whole piece of a file changed, by a generator of fixed seed.
fn mutated(text: &[u8], state: &mut u64) -> Vec<u8> {
    let mut draw = |below: usize| {
        // Knuth's MMIX constants.
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 33) as usize % below.max(1)
    };
    let mut bytes = text.to_vec();
    for _ in 0..=draw(4) {
        let (at, to) = (draw(bytes.len()), draw(bytes.len()));
        // A value that stays one: most of what is left after it is still XML.
        let value = bytes.iter().skip(at).position(|byte| *byte == b'"').map(|away| at + away + 1);
        match draw(10) {
            0 => bytes[at] = b"<>/\"'=&0-e.\0"[draw(12)],
            1 => drop(bytes.drain(at.min(to)..at.max(to))),
            2 => bytes.extend_from_within(at.min(to)..),
            3 => bytes.insert(at, b"<>/\"'=&0-e. "[draw(12)]),
            4 => drop(bytes.splice(at..at, *b"1e999 nan -0 ")),
            5..9 => {
                let text: &[u8] = [&b"-"[..], b"1e308", b"nan", b"1e-300 ", b"0 ", b"x"][draw(6)];
                let value = value.unwrap_or(at).min(bytes.len());
                drop(bytes.splice(value..value, text.iter().copied()));
            }
            _ => bytes.swap(at, to),
        }
        if bytes.is_empty() {
            bytes.push(b'<');
        }
    }
    bytes
}

#[test]
fn two_thousand_mutated_files_end_in_a_verdict_or_an_error() {
    let folder = scratch();
    let files: Vec<PathBuf> = ["broken", "controls"]
        .iter()
        .flat_map(|part| fs::read_dir(robots().join(part)).expect("a folder"))
        .map(|entry| entry.expect("an entry").path())
        .collect();
    let (mut state, mut read) = (19, 0);
    for round in 0..2000 {
        let file = &files[round % files.len()];
        let bytes = mutated(&fs::read(file).expect("a file"), &mut state);
        let path = folder.path().join(file.file_name().expect("a name"));
        fs::write(&path, &bytes).expect("written");
        let found = polhode::internals::inspect::inspect(&path);
        if let Err(error) = &found {
            assert!(error.to_string().lines().all(|line| line.len() < 1000), "{error}");
        }
        if let Ok(inspection) = found {
            read += 1;
            assert_eq!(
                inspection.summaries().len(),
                inspection.counts().iter().map(|(_, count)| count).sum::<usize>()
            );
            inspection.scenes();
            inspection.to_json();
        }
    }
    // Most mutations leave a file that is XML no more; some leave one that is read.
    assert!(read > 100 && read < 1900, "{read}");
}
