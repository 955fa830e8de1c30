//! Wall-clock cost of a step: every scheme on every model, and Peskin's scheme on 4 to 16,384 mass points.
//!
//! A bench is not a test: nothing depends on these numbers.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::Vector3;
use polhode::internals::rotation::Rotation;
use polhode::model::body::{Body, MassPoint};
use polhode::model::{Spin, System};
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form, Plan};

/// Steps of a measured run: far more than what it takes to begin one.
const STEPS: u64 = 1000;

fn run(contestant: &Contestant, system: &System, form: Form, step: f64) {
    let plan = Plan { step, steps: STEPS, every: STEPS };
    let outcome = contestant.stream(system, form, &plan, &mut |state| {
        std::hint::black_box(state);
    });
    assert!(outcome.broken.is_none(), "{}", contestant.card.name);
}

/// A scene for every model; the step turns each by about a hundredth of a radian.
const SCENES: [(&str, f64); 6] = [
    ("free-asymmetric", 0.01),
    ("nasa-check-case-2", 0.015),
    ("dipole-in-field", 0.001),
    ("kovalevskaya", 0.005),
    ("tether-springs", 0.005),
    ("gravity-drag", 0.005),
];

fn models(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("step");
    group.throughput(Throughput::Elements(STEPS));
    for (name, step) in SCENES {
        let scene = Scene::find(name).expect("built in");
        for contestant in Contestant::all() {
            if contestant.refusal(&scene.system).is_some() {
                continue;
            }
            let model = scene.system.least().name();
            let id = BenchmarkId::new(contestant.card.name, format!("{model} ({name})"));
            group.bench_function(id, |b| b.iter(|| run(&contestant, &scene.system, Form::Least, step)));
        }
    }
    group.finish();
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

fn points(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("points");
    let contestants = Contestant::all();
    let peskin = contestants.iter().find(|c| c.card.name == "peskin-rk2").expect("a scheme of the list");
    for count in [4, 64, 1024, 16_384] {
        let system = cloud(count);
        group.throughput(Throughput::Elements(STEPS * count as u64));
        group.bench_function(BenchmarkId::new("peskin-rk2", count), |b| {
            b.iter(|| run(peskin, &system, Form::Points, 0.01));
        });
    }
    group.finish();
}

criterion_group!(benches, models, points);
criterion_main!(benches);
