//! The speed targets as one table: `cargo bench --bench table`.
//!
//! Ratios are worth more than nanoseconds, so that all rows are measured in one process, in turn, in short blocks; a
//! row is the minimum over its blocks. The first row stands twice: what its two figures differ by is noise.

use std::cell::Cell;
use std::time::{Duration, Instant};

use nalgebra::Vector3;
use polhode::internals::arithmetic::Registers;
use polhode::internals::rotation::{self, Rotation};
use polhode::internals::study::ensemble::{Ensemble, Member};
use polhode::model::body::{Body, MassPoint};
use polhode::model::forces::{Attachment, Drag, Gravity, Law, PerPoint, Spring};
use polhode::model::{Spin, System};
use polhode::simulate::{Contestant, Form, Plan};

/// How long every row is measured.
const FOR: Duration = Duration::from_millis(400);
/// Length of a block.
const BLOCK: Duration = Duration::from_micros(60);
/// Bodies of the batch, how many of them a block takes, and for how many steps.
const BODIES: usize = 10_000;
const BODIES_OF_A_BLOCK: usize = 80;
const BATCH_STEPS: u64 = 500;

/// A row: what is timed gives nanoseconds for one unit, from a number of steps.
struct Row {
    name: String,
    target: &'static str,
    /// Steps a unit: 1, or 1 over the number of points.
    share: f64,
    run: Box<dyn Fn(u64) -> f64>,
    steps: u64,
    best: f64,
    spent: Duration,
}

fn row(name: &str, target: &'static str, share: f64, run: impl Fn(u64) -> f64 + 'static) -> Row {
    Row {
        name: name.to_owned(),
        target,
        share,
        run: Box::new(run),
        steps: 16,
        best: f64::INFINITY,
        spent: Duration::ZERO,
    }
}

/// Nanoseconds a step of a scheme on a system.
fn steps(scheme: &str, system: System, form: Form) -> impl Fn(u64) -> f64 + 'static {
    let contestant =
        Contestant::all().into_iter().find(|c| c.card.name == scheme).expect("a scheme of the list");
    move |steps| {
        let plan = Plan { step: 0.01, steps, every: steps };
        let outcome = contestant.stream(&system, form, &plan, &mut |state| {
            std::hint::black_box(state);
        });
        assert!(outcome.broken.is_none());
        outcome.nanoseconds as f64 / steps as f64
    }
}

fn system(points: &[MassPoint], laws: Vec<Law>) -> System {
    let (body, center) = Body::from_points(points, None).expect("a body");
    let spin = Spin::Velocity(Vector3::new(0.3, -0.5, 0.8));
    System::new(body, laws, center, Rotation::identity(), Vector3::new(0.1, 0.2, 0.3), spin)
        .expect("a system")
}

/// A helix of equal mass points: no two moments equal, nothing aligned.
fn helix(count: usize) -> Vec<MassPoint> {
    let point = |k: usize| {
        let (angle, height) = (0.7 * k as f64, 2.0 * k as f64 / count as f64);
        MassPoint { mass: 1.0, position: Vector3::new(angle.cos(), 0.5 * angle.sin(), height) }
    };
    (0..count).map(point).collect()
}

fn spring() -> Law {
    Law::Spring(Spring {
        attachment: Attachment::Point(0),
        anchor: Vector3::new(1.0, 0.5, 0.25),
        stiffness: 10.0,
        damping: 0.1,
        rest_length: 0.5,
    })
}

fn gravity_and_drag() -> Vec<Law> {
    let gravity = Gravity { acceleration: Vector3::new(0.0, 0.0, -9.81) };
    vec![Law::Gravity(gravity), Law::Drag(Drag { coefficient: PerPoint::Same(0.1) })]
}

/// Nanoseconds a body-step of many free bodies.
fn batch(registers: Registers) -> impl Fn(u64) -> f64 + 'static {
    let contestant = Contestant::all().into_iter().find(|c| c.card.name == "peskin-rk2").expect("a scheme");
    let plan = Plan { step: 0.01, steps: BATCH_STEPS, every: BATCH_STEPS };
    let body = system(&helix(5), Vec::new());
    let member = |k: usize| {
        let mut system = body.clone();
        system.start.orientation = rotation::turn(&(Vector3::new(0.1, 0.2, -0.3) * k as f64));
        Member { system, plan: Plan { step: plan.step * (1.0 + 1e-5 * k as f64), ..plan } }
    };
    let members: Vec<Member> = (0..BODIES).map(member).collect();
    let blocks: Vec<Vec<Member>> = members.chunks(BODIES_OF_A_BLOCK).map(<[Member]>::to_vec).collect();
    let next = Cell::new(0);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    move |_| {
        let block = &blocks[next.get()];
        next.set((next.get() + 1) % blocks.len());
        let ensemble = Ensemble::new(&contestant, block.clone()).in_registers(registers);
        let (ends, elapsed) = pool.install(|| {
            let before = Instant::now();
            let ends = ensemble.fold(|_| 0.0, |sum, state| *sum += state.time);
            (ends, before.elapsed().as_nanos() as f64)
        });
        std::hint::black_box(ends);
        elapsed / (block.len() as u64 * BATCH_STEPS) as f64
    }
}

fn rows() -> Vec<Row> {
    let five = helix(5);
    let free = system(&five, Vec::new());
    let least = Form::Least;
    let mut rows = vec![
        row("Peskin, free body, reduced", "40", 1.0, steps("peskin-rk2", free.clone(), least)),
        row("the same again", "", 1.0, steps("peskin-rk2", free.clone(), least)),
        row("Euler-only, free body, reduced", "", 1.0, steps("euler", free.clone(), least)),
        row(
            "Peskin, one spring, reduced",
            "150",
            1.0,
            steps("peskin-rk2", system(&five, vec![spring()]), least),
        ),
        row(
            "Peskin, gravity and drag on 5 points, reduced",
            "150",
            1.0,
            steps("peskin-rk2", system(&five, gravity_and_drag()), least),
        ),
        row("rk4-quaternion, free body", "Boost's", 1.0, steps("rk4-quaternion", free.clone(), least)),
        row("exact-rotor, free body", "400", 1.0, steps("exact-rotor", free, least)),
    ];
    for (count, target) in [(4, "120"), (64, ""), (1024, "3 a point"), (16_384, "3 a point"), (1 << 20, "")] {
        let share = if count < 1000 { 1.0 } else { 1.0 / count as f64 };
        let name = format!("Peskin, {count} points as written{}", if share < 1.0 { ", a point" } else { "" });
        rows.push(row(
            &name,
            target,
            share,
            steps("peskin-rk2", system(&helix(count), Vec::new()), Form::Points),
        ));
    }
    for registers in Registers::all() {
        let name = format!("Peskin, {BODIES} free bodies, {} registers", registers.name());
        let wide = registers.name().starts_with("AVX");
        rows.push(row(&name, if wide { "8" } else { "20" }, 1.0, batch(registers)));
    }
    rows
}

fn main() {
    // `cargo test` runs benches too, with this argument: then nothing is measured.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let mut rows = rows();
    while rows.iter().any(|row| row.spent < FOR) {
        for row in rows.iter_mut().filter(|row| row.spent < FOR) {
            let before = Instant::now();
            let cost = (row.run)(row.steps);
            let elapsed = before.elapsed();
            row.spent += elapsed;
            row.best = row.best.min(cost * row.share);
            if elapsed < BLOCK && row.steps < 1 << 16 {
                row.steps *= 2;
            }
        }
    }
    println!("| what | ns | at most |\n|---|---|---|");
    for row in &rows {
        println!("| {} | {:.2} | {} |", row.name, row.best, row.target);
    }
}
