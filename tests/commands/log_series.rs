//! Errors against time and deviations of several logs.

use std::fs;

use polhode::internals::log::{Judgement, Request, judge_text};
use polhode::model::Quantity;

use crate::common::program::{code, polhode, scratch, stderr, stdout};
use crate::mutated_logs::{STILL, still};

/// Rows of a body that turns about z by an angle over time: 0, 0.1, … 2 s.
fn log(angle: impl Fn(f64) -> f64) -> String {
    let row = |k: u32| {
        let t = f64::from(k) / 10.0;
        let half = 0.5 * angle(t);
        format!("{t},{},0,0,{}\n", half.cos(), half.sin())
    };
    (0..=20).map(row).fold("t,qw,qx,qy,qz\n".to_owned(), |text, row| text + &row)
}

/// The scene turns by t.
fn fast(t: f64) -> f64 {
    t + 0.01 * t
}

#[test]
fn errors_of_every_row_are_written_and_drawn() {
    let folder = scratch();
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    fs::write(path("still.toml"), STILL).expect("written");
    fs::write(path("log.csv"), log(fast)).expect("written");
    let (csv, png) = (path("errors.csv"), path("errors.png"));
    let scene = path("still.toml");
    let output = polhode(&["judge", &path("log.csv"), "--scene", &scene, "--errors", &csv, "--plot", &png]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let text = fs::read_to_string(csv).expect("errors");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let column = names.iter().position(|name| *name == "orientation_rad").expect("a column");
    for (k, line) in lines.clone().enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        let error: f64 = cells[column].parse().expect("a number");
        // An angle of quaternions of 17 digits is good to a few roundings of one.
        assert!((error - 0.001 * k as f64).abs() < 1e-14, "{line}");
        assert_eq!(cells[names.iter().position(|name| *name == "position_m").expect("a column")], "");
    }
    assert_eq!(lines.count(), 21);
    assert!(fs::read(png).expect("a picture").starts_with(b"\x89PNG"));
}

#[test]
fn deviations_of_two_logs_are_split_into_what_grows_and_what_stays() {
    let request = Request { series: true, ..Request::default() };
    let judged = |angle: &dyn Fn(f64) -> f64| -> Judgement {
        judge_text(&log(angle), &still(), &request).expect("a judgement")
    };
    let (exact, fast) = (judged(&|t| t), judged(&fast));
    let bumpy = judged(&|t| t + if (t - 1.0).abs() < 0.01 { 0.005 } else { 0.0 });
    let apart = |a: &Judgement, b: &Judgement| {
        a.series.deviation(&b.series, &still().system, Quantity::Orientation).expect("a deviation")
    };
    let grown = apart(&exact, &fast);
    assert_eq!(grown.times, 21);
    for (found, right) in [(grown.largest, 0.02), (grown.secular, 0.02), (grown.bounded, 0.0)] {
        assert!((found - right).abs() < 1e-13, "{grown:?}");
    }
    // One of 21 times in the middle: the line is its mean, 0.005/21.
    let stayed = apart(&exact, &bumpy);
    for (found, right) in
        [(stayed.largest, 0.005), (stayed.secular, 0.0), (stayed.bounded, 0.005 * 20.0 / 21.0)]
    {
        assert!((found - right).abs() < 1e-13, "{stayed:?}");
    }
    assert!(exact.series.deviation(&fast.series, &still().system, Quantity::Position).is_none());
}

#[test]
fn several_logs_are_compared_in_pairs_and_have_no_one_picture() {
    let folder = scratch();
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    fs::write(path("still.toml"), STILL).expect("written");
    let names = ["a.csv", "b.csv", "c.csv"];
    for name in names {
        fs::write(path(name), log(fast)).expect("written");
    }
    let [a, b, c] = names.map(path);
    let scene = path("still.toml");
    let output = polhode(&["judge", &a, &b, &c, "--scene", &scene]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let pairs = |first: &str, second: &str| {
        let row = |line: &&str| line.split_whitespace().take(3).eq([first, second, "orientation"]);
        stdout(&output).lines().filter(row).count()
    };
    assert_eq!([pairs("a.csv", "b.csv"), pairs("a.csv", "c.csv"), pairs("b.csv", "c.csv")], [1, 1, 1]);
    let png = path("errors.png");
    assert_eq!(code(&polhode(&["judge", &a, &b, "--scene", &scene, "--plot", &png])), 64);
}
