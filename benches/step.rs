//! Wall-clock cost of a step: every scheme on every model, and Peskin's scheme on 4 to 16,384 mass points.
//! `cargo bench --bench step -- rk4` measures the rows whose name holds a word.
//!
//! A bench is not a test: nothing depends on these numbers.

mod common;

use std::time::Duration;

use common::{Row, contestant, measure, steps};
use nalgebra::Vector3;
use polhode::internals::rotation::Rotation;
use polhode::model::body::{Body, MassPoint};
use polhode::model::{Spin, System};
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form};

/// How long every row is measured.
const FOR: Duration = Duration::from_millis(100);

/// A scene for every model; the step turns each by about a hundredth of a radian.
const SCENES: [(&str, f64); 6] = [
    ("free-asymmetric", 0.01),
    ("nasa-check-case-2", 0.015),
    ("dipole-in-field", 0.001),
    ("kovalevskaya", 0.005),
    ("tether-springs", 0.005),
    ("gravity-drag", 0.005),
];

fn models() -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, step) in SCENES {
        let system = Scene::find(name).expect("built in").system;
        for contestant in Contestant::all() {
            if contestant.refusal(&system).is_none() {
                let title = format!("{}, {} ({name})", contestant.card.name, system.least().name());
                rows.push(Row::new(title, steps(contestant, system.clone(), Form::Least, step)));
            }
        }
    }
    rows
}

/// A helix of equal mass points: no two moments equal, nothing aligned.
fn cloud(count: usize) -> System {
    let points: Vec<MassPoint> = (0..count)
        .map(|k| {
            let angle = 0.7 * k as f64;
            let height = 2.0 * k as f64 / count as f64;
            MassPoint { mass: 1.0, position: Vector3::new(angle.cos(), 0.5 * angle.sin(), height) }
        })
        .collect();
    let (body, center) = Body::from_points(&points, None).expect("a body");
    let spin = Spin::Velocity(Vector3::new(0.3, -0.5, 0.8));
    System::new(body, Vec::new(), center, Rotation::identity(), Vector3::zeros(), spin).expect("a system")
}

fn points() -> impl Iterator<Item = Row> {
    [4, 64, 1024, 16_384].into_iter().map(|count| {
        let run = steps(contestant("peskin-rk2"), cloud(count), Form::Points, 0.01);
        Row::new(format!("peskin-rk2, {count} points as written"), run)
    })
}

fn main() {
    if common::is_test() {
        return;
    }
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let mut rows = models();
    rows.extend(points());
    rows.retain(|row| words.iter().all(|word| row.name.contains(word.as_str())));
    measure(&mut rows, FOR);
    println!("| what | ns a step |\n|---|---|");
    for row in &rows {
        println!("| {} | {:.1} |", row.name, row.best);
    }
}
