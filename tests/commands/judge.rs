//! `polhode judge` from outside: conventions, units, signs, gaps and bad files.

use std::fs;
use std::process::Output;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::internals::log::{Change, Request, judge_text};
use polhode::scenes::Scene;
use serde_json::Value;

use crate::common::program::{code, polhode, scratch, stderr, stdout};

const COLUMNS: [&str; 14] = ["t", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"];
const SCENE: &str = "free-asymmetric";

type Row = [f64; 14];

/// A run in `steps` steps by a scheme of fourth order, as rows.
fn run(scene: &str, steps: u64) -> Vec<Row> {
    let steps = steps.to_string();
    let output = polhode(&["run", scene, "--scheme", "rk4-quaternion", "--steps", &steps, "--format", "csv"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let csv = stdout(&output);
    let mut lines = csv.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let places = COLUMNS.map(|name| header.iter().position(|column| *column == name).expect("a column"));
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        places.map(|place| cells[place].parse().expect("a number"))
    };
    lines.map(row).collect()
}

fn csv(rows: &[Row]) -> String {
    let line = |row: &Row| row.map(|value| value.to_string()).join(",") + "\n";
    COLUMNS.join(",") + "\n" + &rows.iter().map(line).collect::<String>()
}

struct Judged {
    output: Output,
    records: Value,
}

impl Judged {
    fn said(&self) -> String {
        stdout(&self.output) + &stderr(&self.output)
    }

    fn value(&self, metric: &str) -> f64 {
        let rows = self.records["measurements"].as_array().expect("rows");
        let row = rows.iter().find(|row| row["metric"] == metric).expect("a row for the metric");
        row["value"].as_f64().unwrap_or(f64::NAN)
    }
}

fn judge_in(scene: &str, log: &str, options: &[&str]) -> Judged {
    let folder = scratch();
    let (path, json) = (folder.path().join("log.csv"), folder.path().join("records.json"));
    fs::write(&path, log).expect("written");
    let (path, json_name) = (path.to_string_lossy(), json.to_string_lossy());
    let output = polhode(&[&["judge", &path, "--scene", scene, "--json", &json_name], options].concat());
    let written = fs::read_to_string(&json).unwrap_or("null".to_owned());
    Judged { output, records: serde_json::from_str(&written).expect("JSON") }
}

fn judge(rows: &[Row], options: &[&str]) -> Judged {
    judge_in(SCENE, &csv(rows), options)
}

/// R v for q = (w, x, y, z).
fn turned(q: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let axis = [q[1], q[2], q[3]];
    let t = cross(axis, v).map(|x| 2.0 * x);
    let u = cross(axis, t);
    std::array::from_fn(|i| v[i] + q[0] * t[i] + u[i])
}

fn body_axes(rows: &mut [Row]) {
    for row in rows {
        let q = [row[4], -row[5], -row[6], -row[7]];
        let spin = turned(q, [row[11], row[12], row[13]]);
        row[11..].copy_from_slice(&spin);
    }
}

fn inverted(rows: &mut [Row]) {
    rows.iter_mut().for_each(|row| row[5..8].iter_mut().for_each(|x| *x = -*x));
}

#[test]
fn the_frame_check_names_the_convention_of_a_log_and_its_options_make_the_errors_small() {
    for (spin, quaternion) in [
        ("world", "body-to-world"),
        ("body", "body-to-world"),
        ("world", "world-to-body"),
        ("body", "world-to-body"),
    ] {
        let mut rows = run(SCENE, 1000);
        if spin == "body" {
            body_axes(&mut rows);
        }
        if quaternion == "world-to-body" {
            inverted(&mut rows);
        }
        let words = format!("follows --angular-velocity {spin} --quaternion {quaternion}");
        let unsaid = judge(&rows, &["--tolerance", "1"]);
        assert!(unsaid.said().contains(&words), "{}", unsaid.said());
        let expected = if (spin, quaternion) == ("world", "body-to-world") { 0 } else { 2 };
        assert_eq!(code(&unsaid.output), expected, "{}", unsaid.said());
        let found = judge(&rows, &["--as-found", "--tolerance", "1"]);
        assert_eq!(code(&found.output), 0, "{}", found.said());
        let said = judge(&rows, &["--angular-velocity", spin, "--quaternion", quaternion]);
        assert!(said.said().contains("as it was read") && !said.said().contains("hint"), "{}", said.said());
        // RK4 at h = 0.008 s, measured: 9.2e-12 rad, 1.4e-12 rad/s, energy 1.2e-13.
        assert!(said.value("orientation-max") < 2e-11 && said.value("orientation-max") > 5e-12);
        assert!(said.value("angular-velocity-max") < 3e-12 && said.value("total-energy-max") < 3e-13);
        assert!(said.value("angular-momentum-direction-max") < 1e-14);
    }
}

#[test]
fn a_steady_spin_does_not_tell_body_from_world() {
    let rows = run("slow-sphere", 100);
    let judged = judge_in("slow-sphere", &csv(&rows), &["--tolerance", "1e-9"]);
    assert_eq!(code(&judged.output), 0);
    assert!(judged.said().contains("does not tell apart"), "{}", judged.said());
}

#[test]
fn gaps_jumps_repeats_and_rows_that_are_not_finite_are_told_with_their_line() {
    let rows = run(SCENE, 1000);
    let told = |rows: &[Row], words: &[&str]| {
        let judged = judge(rows, &[]);
        assert_eq!(code(&judged.output), 0);
        words.iter().for_each(|word| assert!(judged.said().contains(word), "{word}: {}", judged.said()));
        // Whatever is odd, each row is still compared at its own time.
        assert!(judged.value("orientation-max") < 2e-11, "{words:?}");
    };
    told(&[&rows[..100], &rows[150..]].concat(), &["1 gaps", "line 102"]);
    told(&[&rows[..100], &rows[50..]].concat(), &["times go back", "line 102"]);
    told(&[&rows[..100], &rows[99..]].concat(), &["those of the row before", "line 102"]);
    let mut some = rows.clone();
    some[10][3] = f64::NAN;
    some[20][13] = f64::INFINITY;
    told(
        &some,
        &["1 of 1001 rows have no position", "line 12", "1 of 1001 rows have no angular velocity", "line 22"],
    );
    let negated: Vec<Row> = rows
        .iter()
        .enumerate()
        .map(|(k, row)| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            std::array::from_fn(|i| if (4..8).contains(&i) { sign * row[i] } else { row[i] })
        })
        .collect();
    told(&negated, &["as it was read"]);
}

#[test]
fn what_a_log_does_not_have_is_not_applicable() {
    let rows = run(SCENE, 100);
    let positions: String =
        rows.iter().map(|row| format!("{},{},{},{},x\n", row[0], row[1], row[2], row[3])).collect();
    let judged = judge_in(SCENE, &format!("t,x,y,z,comment\n{positions}"), &["--tolerance", "1"]);
    // The tolerance is about body points, which need an orientation.
    assert_eq!(code(&judged.output), 2, "{}", judged.said());
    assert!(judged.value("position-max") < 1e-13 && judged.value("orientation-max").is_nan());
    let judged = judge_in(
        SCENE,
        &format!("t,x,y,z,comment\n{positions}"),
        &["--tolerance", "1e-12", "--quantity", "position"],
    );
    assert_eq!(code(&judged.output), 0);
}

#[test]
fn a_tolerance_that_is_exceeded_is_1() {
    let rows = run(SCENE, 1000);
    assert_eq!(code(&judge(&rows, &["--tolerance", "1e-9", "--quantity", "orientation"]).output), 0);
    assert_eq!(code(&judge(&rows, &["--tolerance", "1e-12", "--quantity", "orientation"]).output), 1);
    assert_eq!(code(&judge(&rows, &["--tolerance", "-1"]).output), 64);
    assert_eq!(code(&judge(&rows, &["--tolerance", "1", "--quantity", "spin"]).output), 64);
}

#[test]
fn a_file_that_is_no_trajectory_is_65_with_its_line_and_one_that_is_not_there_74() {
    let whole = csv(&run(SCENE, 10));
    let header = COLUMNS.join(",");
    for (log, word) in [
        (String::new(), "log.csv:1: the file is empty"),
        (format!("{header}\n"), "log.csv:2: there is a header"),
        ("a,b\n1,2\n".to_owned(), "log.csv:1: there is no column t"),
        (header.replace(',', ";"), "log.csv:2: there is a header"),
        ("t\n1\n".to_owned(), "no whole quantity"),
        ("t,t,x,y,z\n1,2,3,4,5\n".to_owned(), "stands twice"),
        (whole.replacen("\n0,", "\nzero,", 1), "log.csv:2: column t holds 'zero'"),
        (format!("{header}\n0,1,2\n0,1\n"), "log.csv:2: the row has fewer columns"),
        ("t,x,y,z\n0,NaN,1,2\n1,,3,4\n".to_owned(), "log.csv:2: no row has finite numbers"),
        ("t,x,y,z\n-1,0,1,2\n".to_owned(), "before t = 0"),
    ] {
        let judged = judge_in(SCENE, &log, &[]);
        assert_eq!(code(&judged.output), 65, "{log}: {}", judged.said());
        assert!(judged.said().contains(word), "{log}: {}", judged.said());
    }
    assert_eq!(code(&polhode(&["judge", "/no/such/log.csv", "--scene", SCENE])), 74);
    assert_eq!(code(&polhode(&["judge", "log.csv"])), 64);
    let one = judge_in(SCENE, &(header.clone() + "\n" + whole.lines().nth(1).expect("a row") + "\n"), &[]);
    assert_eq!(code(&one.output), 0);
    assert!(one.said().contains("there is one row"), "{}", one.said());
    let start = header.clone() + "\n" + whole.lines().nth(1).expect("a row") + "\n";
    assert_eq!(code(&judge_in(SCENE, &start, &["--tolerance", "1"]).output), 2);
    let cut = judge_in(SCENE, &whole[..whole.len() - 150], &[]);
    assert_eq!(code(&cut.output), 0, "{}", cut.said());
    assert!(cut.said().contains("is cut"), "{}", cut.said());
}

#[test]
fn a_log_that_is_interpolated_has_the_errors_of_one_that_is_not() {
    for scene in ["free-asymmetric", "mujoco-free-box", "thin-body"] {
        let rows = run(scene, 8192);
        let thinned: Vec<Row> = rows.iter().step_by(8).copied().collect();
        let (long, short) = (judge_in(scene, &csv(&rows), &[]), judge_in(scene, &csv(&thinned), &[]));
        assert!(long.said().contains("polynomials") && short.said().contains("at every time"), "{scene}");
        for metric in ["position-end", "velocity-end", "orientation-end", "angular-velocity-end"] {
            let (a, b) = (long.value(metric), short.value(metric));
            let rows = long.records["measurements"].as_array().expect("rows");
            let row = rows.iter().find(|row| row["metric"] == metric).expect("a row");
            let uncertainty = row["uncertainty"].as_f64().expect("an uncertainty");
            assert!((a - b).abs() <= uncertainty, "{scene}, {metric}: {a:e} and {b:e} ± {uncertainty:e}");
        }
    }
}

/// Angular velocities in body axes turn along with an orientation that was misread.
#[test]
fn euler_angles_that_were_misread_are_named() {
    type Angles = fn(&UnitQuaternion<f64>) -> [f64; 3];
    let rows = run(SCENE, 400);
    let scene = Scene::find(SCENE).expect("a scene");
    let changes = |unit: &str, angles: Angles| {
        let line = |row: &Row| {
            let q = UnitQuaternion::new_normalize(Quaternion::new(row[4], row[5], row[6], row[7]));
            let rates = q.inverse_transform_vector(&Vector3::new(row[11], row[12], row[13]));
            let [yaw, pitch, roll] = angles(&q);
            format!("{},{yaw},{pitch},{roll},{},{},{}\n", row[0], rates.x, rates.y, rates.z)
        };
        let log = format!("t,yaw{unit},pitch{unit},roll{unit},p,q,r\n");
        let log = log + &rows.iter().map(line).collect::<String>();
        let judgement = judge_text(&log, &scene, &Request::default()).expect("a trajectory");
        judgement.explanations.iter().map(|one| one.change).collect::<Vec<_>>()
    };
    // About the moving axes Z, Y, X.
    let right: Angles = |q| {
        let (roll, pitch, yaw) = q.euler_angles();
        [yaw, pitch, roll]
    };
    let pitch_negated: Angles = |q| {
        let (roll, pitch, yaw) = q.euler_angles();
        [yaw, -pitch, roll]
    };
    // About X, Y, Z: those of the inverse with the other sign.
    let other_sequence: Angles = |q| {
        let (roll, pitch, yaw) = q.inverse().euler_angles();
        [-yaw, -pitch, -roll]
    };
    assert_eq!(changes("", right), []);
    assert_eq!(changes("", pitch_negated), [Change::Sign]);
    assert_eq!(changes("", other_sequence), [Change::Sequence]);
    assert_eq!(changes(" [deg]", right), [Change::Unit]);
}
