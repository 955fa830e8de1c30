//! `polhode reference`: digits, bounds, files, exit codes.

use std::fs;
use std::process::{Command, Stdio};

use polhode::internals::reference::Stored;

use crate::common::program::{code, polhode, scratch, stderr, stdout};
use crate::common::stored_of;

/// Exit code, standard output and standard error.
fn reference(arguments: &[&str]) -> (i32, String, String) {
    let output = polhode(&[&["reference"], arguments].concat());
    (code(&output), stdout(&output), stderr(&output))
}

#[test]
fn twenty_five_digits_are_printed_with_their_bounds() {
    let (code, text, talk) = reference(&["kovalevskaya", "--digits", "25"]);
    assert_eq!((code, talk.as_str()), (0, ""));
    for time in ["t = 1.5 s", "t = 3 s", "t = 4.5 s", "t = 6 s"] {
        assert!(text.contains(time), "{text}");
    }
    // L at T/4 and R₁₁, from the stored 40 digits.
    assert!(text.contains("0.271890492486011331504215"), "{text}");
    assert!(text.contains("-0.2796948377111119734740017"), "{text}");
    assert_eq!(text.matches("within").count(), 24);
}

#[test]
fn bounds_cover_the_digits_that_are_printed_and_a_quaternion_is_that_of_the_matrix() {
    let at = |digits: &str| {
        let times = ["kovalevskaya", "--times", "3,1.5", "--format", "json", "--digits", digits];
        let (code, text, _) = reference(&times);
        assert_eq!(code, 0);
        serde_json::from_str::<serde_json::Value>(&text).expect("JSON")
    };
    let (few, many) = (at("4"), at("25"));
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        let list = value.as_array().expect("numbers");
        list.iter()
            .flat_map(|one| one.as_array().cloned().unwrap_or(vec![one.clone()]))
            .filter_map(|x| x.as_f64())
            .collect()
    };
    let moments = |solution: &serde_json::Value| solution["moments"].as_array().expect("moments").clone();
    assert_eq!(
        moments(&few).iter().map(|one| one["time_s"].as_f64()).collect::<Vec<_>>(),
        [Some(1.5), Some(3.0)]
    );
    for (few, many) in moments(&few).iter().zip(&moments(&many)) {
        for key in ["position_m", "velocity_m_s", "rotation", "orientation_wxyz", "angular_velocity_rad_s"] {
            let within = few[format!("{key}_within")].as_f64().expect("a bound");
            let (a, b) = (numbers(&few[key]), numbers(&many[key]));
            assert!(a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= within), "{key}");
            assert!(within < 1e-3, "{key} {within}");
        }
        let (q, r) = (numbers(&many["orientation_wxyz"]), numbers(&many["rotation"]));
        let [w, x, y, z] = q[..] else { panic!("four") };
        let first = [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)];
        // Roundings of f64.
        assert!(first.iter().zip(&r).all(|(a, b)| (a - b).abs() < 1e-15), "{first:?} {r:?}");
    }
}

#[test]
fn a_solution_is_printed_at_equal_times_as_rows() {
    let (code, text, _) = reference(&["kovalevskaya", "--every", "0.5", "--format", "csv", "--digits", "10"]);
    assert_eq!(code, 0);
    // Twelve times of 3 + 3 + 9 + 4 + 3 + 3 numbers.
    assert_eq!(text.lines().count(), 1 + 12 * 25);
    for wrong in [["--every", "0"], ["--every", "1e-9"], ["--times", "0"], ["--times", "-1"]] {
        assert_eq!(reference(&[&["kovalevskaya"][..], &wrong].concat()).0, 64, "{wrong:?}");
    }
}

#[test]
fn a_body_on_the_ground_is_followed_from_touch_to_touch() {
    let (code, text, talk) = reference(&["bouncing-body", "--digits", "25"]);
    assert_eq!((code, talk.as_str()), (0, ""));
    assert!(text.contains("Contacts with the ground made or lost on the way: 12"), "{text}");
    // Height of the centre of mass at T, by a second program.
    assert!(text.contains("0.132219972136781549502573"), "{text}");
}

#[test]
fn a_file_is_written_that_is_the_stored_one() {
    let folder = scratch();
    let path = folder.path().join("dipole.json");
    let arguments = ["dipole-in-field", "--digits", "30", "--quiet", "--out", &path.to_string_lossy()];
    let (code, _, talk) = reference(&arguments);
    // One digit fewer than was asked for is certain.
    assert_eq!((code, talk.as_str()), (2, ""));
    let written = fs::read_to_string(&path).expect("written");
    let written = Stored::parse(&written).expect("sound");
    let stored = stored_of("dipole-in-field");
    assert_eq!((written.digits, &written.scene), (stored.digits, &stored.scene));
    assert_eq!(written, stored);
}

#[test]
fn what_is_mistyped_is_told_with_what_to_write_instead() {
    let (code, _, talk) = reference(&["kovalevskaia"]);
    assert!(code == 64 && talk.contains("did you mean kovalevskaya"), "{code} {talk}");
    for digits in ["0", "31", "many"] {
        let (code, _, talk) = reference(&["kovalevskaya", "--digits", digits]);
        assert!(code == 64 && talk.contains("from 1 to 30"), "{code} {talk}");
    }
    let (code, text, _) = reference(&["--help"]);
    assert!(code == 0 && text.contains("--digits"), "{text}");
    let (code, _, _) = reference(&["free-rod", "--out", "/dev/null/no/file.json"]);
    assert_eq!(code, 74);
}

#[cfg(unix)]
#[test]
fn an_interrupt_ends_a_long_solution() {
    let folder = scratch();
    let path = folder.path().join("long.toml");
    let text = "name = \"long\"\nduration = 1e6\n[body]\nmass = 1.0\ninertia = [1, 2, 2.5]\n\
                [initial]\nangular_velocity = [1, 1, 1]\n";
    fs::write(&path, text).expect("written");
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["reference", &path.to_string_lossy()])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program runs");
    std::thread::sleep(std::time::Duration::from_millis(700));
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill runs");
    assert!(killed.success());
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
}
