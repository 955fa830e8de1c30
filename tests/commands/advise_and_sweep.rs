//! The commands `advise` and `sweep` from outside.

use std::fs;

use crate::common::program::{code, json, polhode, scratch, stderr, stdout};

#[test]
fn advice_is_a_step_that_divides_the_duration_and_whose_run_meets_the_tolerance() {
    let schemes = ["--scheme", "peskin-rk2", "--scheme", "euler", "--scheme", "semi-implicit-euler-no-gyro"];
    let asked =
        [&["advise", "kovalevskaya", "--tolerance", "1e-3", "--format", "json"][..], &schemes].concat();
    let output = polhode(&asked);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let advice = json(&output);
    assert_eq!((&advice["schema"], &advice["quantity"]), (&"polhode/advice/1".into(), &"body-point".into()));
    let answers = advice["answers"].as_array().expect("answers");
    let of = |scheme: &str| answers.iter().find(|answer| answer["scheme"] == scheme).expect("an answer");
    let (peskin, euler) = (of("peskin-rk2"), of("euler"));
    for answer in [peskin, euler] {
        let (step, steps) = (answer["step_s"].as_f64().expect("h"), answer["steps"].as_f64().expect("steps"));
        assert!((step * steps - 6.0).abs() < 1e-12);
        // 0.8 of the tolerance, and not so much less that a far larger step would do.
        let error = answer["error"].as_f64().expect("an error");
        assert!((4e-4..=8e-4).contains(&error), "{answer}");
    }
    // C = 2.2 in the points at the end of this scene: 8e-4 = C h² gives 0.019 s, half of it for the largest over the run.
    let step = peskin["step_s"].as_f64().expect("h");
    assert!((0.009..0.02).contains(&step), "{step}");
    assert!(step > 10.0 * euler["step_s"].as_f64().expect("h"));
    assert_eq!(peskin["stable"], true);
    let evaluations = peskin["force_evaluations_per_s"].as_f64().expect("a count");
    assert!((evaluations * step - 2.0).abs() < 1e-12, "{evaluations}");
    let no_gyro = of("semi-implicit-euler-no-gyro");
    assert!(no_gyro["step_s"].is_null() && no_gyro["why"].as_str().is_some_and(|why| why.contains("error")));
}

#[test]
fn advice_that_cannot_be_given_has_exit_codes_of_its_own() {
    let advise = |more: &[&str]| {
        polhode(&[&["advise", "free-asymmetric", "--scheme", "semi-implicit-euler-no-gyro"], more].concat())
    };
    let output = advise(&["--tolerance", "1e-3"]);
    assert_eq!(code(&output), 1);
    assert!(
        String::from_utf8_lossy(&output.stdout).contains("No scheme that was asked meets this tolerance")
    );
    let output = advise(&["--tolerance", "1e-18"]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("ask for"), "{}", stderr(&output));
    let output = advise(&["--tolerance", "1e-3", "--quantity", "orientaton"]);
    assert_eq!(code(&output), 64);
    assert!(stderr(&output).contains("did you mean orientation, ") && stderr(&output).contains("body-point"));
    for tolerance in ["0", "-1", "nan"] {
        assert_eq!(code(&advise(&["--tolerance", tolerance])), 64, "{tolerance}");
    }
}

#[test]
fn advice_begins_with_a_sentence_and_shows_the_cheapest_in_plain_numbers() {
    let advise = |more: &[&str]| {
        let output = polhode(&[&["advise", "free-asymmetric", "--tolerance", "1e-2"][..], more].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("text")
    };
    let text = advise(&[]);
    let first = text.lines().next().expect("a line");
    assert!(
        first.starts_with("Take ") && first.contains(" with a step of ") && text.contains("asked for 0.01."),
        "{first}"
    );
    let table = text.split("Without an answer").next().expect("a table");
    let stable = table.split("Accurate for this long").next().expect("a table");
    let is_row = |line: &&str| {
        let mut words = line.trim_matches('│').split_whitespace();
        words.next().is_some_and(|word| word.parse::<u32>().is_ok()) && words.count() == 8
    };
    let rows: Vec<&str> = stable.lines().filter(is_row).collect();
    assert!(table.contains(" more: --top "), "{table}");
    assert_eq!(rows.len(), 10, "{stable}");
    // Names stand whole, to be copied.
    let all = polhode(&["list", "schemes"]);
    let known = stdout(&all);
    let is_whole = |row: &&str| {
        let name = row.trim_matches('│').split_whitespace().nth(1).expect("a name").trim_end_matches('*');
        known.lines().any(|line| line.split(' ').next() == Some(name))
    };
    let cut: Vec<_> = rows.iter().filter(|row| !is_whole(row)).collect();
    assert!(cut.is_empty(), "{cut:?}");
    assert!(table.lines().all(|line| line.chars().count() <= 130), "{table}");
    // The step of the sentence is a plain number.
    let step =
        first.split(" with a step of ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a step");
    assert!(!step.contains('e') && step.parse::<f64>().is_ok_and(|step| step > 0.0), "{step}");
    assert!(advise(&["--top", "3"]).lines().count() < text.lines().count());
}

#[test]
fn a_sweep_says_what_it_wrote_and_why_a_column_is_empty() {
    let folder = scratch();
    let path = folder.path().join("table.csv");
    let output = polhode(&[
        "sweep",
        "gravity-drag",
        "--vary",
        "body.scale=0.5:2:3",
        "--step",
        "0.37",
        "--out",
        &path.to_string_lossy(),
    ]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let said = stderr(&output);
    for word in
        ["under peskin-rk2", "which divides the duration", "the table is", "the picture is", "no energy: "]
    {
        assert!(said.contains(word), "{word}: {said}");
    }
}

#[test]
fn a_sweep_is_tidy_and_draws_a_map() {
    let folder = scratch();
    let path = folder.path().join("map.csv");
    let path_text = path.to_string_lossy().into_owned();
    let vary = ["--vary", "forces.0.stiffness=1:100:3:log", "--vary", "step=0.01:0.1:4:log"];
    let output = polhode(&[&["sweep", "tether-springs", "--quiet", "--out", &path_text][..], &vary].concat());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let text = fs::read_to_string(&path).expect("written");
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    assert_eq!(header[..4], ["scheme", "forces.0.stiffness", "step_asked_s", "step_s"]);
    let column = |name: &str| header.iter().position(|one| *one == name).expect("a column");
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 12);
    let number = |row: &[&str], name: &str| row[column(name)].parse::<f64>().expect("a number");
    for row in &rows {
        assert_eq!(row[column("status")], "ok");
        let (step, steps) = (number(row, "step_s"), number(row, "steps"));
        assert!((step * steps - 4.0).abs() < 1e-9);
        assert!((number(row, "step_asked_s") / step - 1.0).abs() < 0.02);
        assert_eq!(number(row, "force_evaluations"), 2.0 * steps);
    }
    // Second order: ten times the step makes about a hundred times the error, in every scene of the sweep.
    for scene in rows.chunks(4) {
        let ratio = number(&scene[3], "body_point_error_m") / number(&scene[0], "body_point_error_m");
        assert!((50.0..200.0).contains(&ratio), "{ratio}");
    }
    assert_eq!(&fs::read(path.with_extension("png")).expect("a picture")[1..4], b"PNG");
}

#[test]
fn a_sweep_over_bodies_that_cannot_be_has_rows_that_say_so() {
    let output = polhode(&["sweep", "free-asymmetric", "--quiet", "--vary", "body.points.0.mass=-1:1:3"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let text = String::from_utf8(output.stdout).expect("text");
    assert_eq!(text.matches("not-applicable").count(), 2, "{text}");
    assert!(text.contains("body.points[0].mass") && text.matches(",ok,").count() == 1, "{text}");
}

#[test]
fn a_key_that_a_sweep_does_not_know_is_told_with_those_that_there_are() {
    let output = polhode(&["sweep", "tether-springs", "--vary", "forces.0.stifness=1:2:3"]);
    assert_eq!(code(&output), 64);
    let text = stderr(&output);
    assert!(text.contains("did you mean forces.0.stiffness, ") && text.contains("body.scale"), "{text}");
    for wrong in ["step", "step=1:2", "step=1:2:3:4", "step=x:2:3"] {
        let output = polhode(&["sweep", "tether-springs", "--vary", wrong]);
        assert_eq!(code(&output), 64, "{wrong}");
        assert!(stderr(&output).contains("key=from:to:n"), "{wrong}");
    }
}

#[test]
fn advice_in_single_precision_is_its_own_and_names_what_it_reaches() {
    let advise = |tolerance: &str, precision: &str| {
        let schemes = ["--scheme", "rk4-quaternion", "--scheme", "peskin-rk2", "--scheme", "dop853"];
        let question = ["advise", "free-asymmetric", "--quantity", "orientation", "--tolerance", tolerance];
        polhode(&[&question[..], &["--precision", precision, "--format", "json"], &schemes].concat())
    };
    // Below what single precision reaches: 7e-7 by rk4-quaternion on the ladder of the report.
    let (single, double) = (advise("1e-7", "f32"), advise("1e-7", "f64"));
    assert_eq!((code(&single), code(&double)), (1, 0), "{}", stderr(&single));
    let single = json(&single);
    assert_eq!(single["precision"], "f32");
    let nearest = &single["answers"][0];
    assert_eq!(nearest["scheme"], "rk4-quaternion");
    let error = nearest["smallest_error"].as_f64().expect("an error");
    assert!((1e-7..5e-6).contains(&error), "{nearest}");
    assert!(nearest["smallest_error_step_s"].as_f64().is_some_and(|step| step > 0.01), "{nearest}");
    // Where both meet the tolerance the errors tell the arithmetics apart; truncation is the same to rounding.
    let found = |output| {
        let advice = json(&output);
        let answers = advice["answers"].as_array().expect("answers").clone();
        let of = |name: &str| answers.iter().find(|one| one["scheme"] == name).expect("an answer").clone();
        (of("rk4-quaternion"), of("dop853"))
    };
    let ((single, solver), (double, other)) = (found(advise("1e-4", "f32")), found(advise("1e-4", "f64")));
    let [a, b] = [&single, &double].map(|one| one["error"].as_f64().expect("an error"));
    assert!(a != b && (a - b).abs() < 1e-5, "{a:e} {b:e}");
    assert_eq!(solver["why"], "runs in f64 only");
    assert!(other["step_s"].is_number());
}
