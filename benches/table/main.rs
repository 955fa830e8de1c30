//! The speed targets as one table: `cargo bench --bench table`.
//!
//! Ratios are worth more than nanoseconds, so that all rows are measured in one process, in turn, in short blocks; a
//! row is the minimum over its blocks. The first row stands twice: what its two figures differ by is noise.
//!
//! Beside a figure stands its bound: the longest chain of sums, products, quotients, roots and functions from one step to the next, each at
//! the latency that the same run measures ([`Timed`] finds the chain by taking the steps). Points are held against the memory: columns of
//! the same size are read and written in the same run.

mod bounds;

use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

use nalgebra::Vector3;
use polhode::internals::arithmetic::Registers;
use polhode::internals::rotation::{self, Rotation};
use polhode::internals::study::ensemble::{Ensemble, Member};
use polhode::model::body::{Body, MassPoint};
use polhode::model::forces::{Attachment, Drag, Gravity, Law, PerPoint, Spring};
use polhode::model::{Spin, System};
use polhode::scenes::Scene;
use polhode::simulate::{Contestant, Form, Plan, Precision};

use bounds::Bound;

/// h of every row [s].
const STEP: f64 = 0.01;
/// How long every row is measured.
const FOR: Duration = Duration::from_millis(400);
/// Length of a block.
const BLOCK: Duration = Duration::from_micros(60);
/// Bodies of the batch, how many of them a block takes, and for how many steps.
const BODIES: usize = 10_000;
const BODIES_OF_A_BLOCK: usize = 80;
const BATCH_STEPS: u64 = 500;

/// Points that no cache holds.
const MANY: usize = 1 << 20;
/// Over its bound a row of a main scheme needs no reason.
const NEAR: f64 = 1.3;

/// A row: what is timed gives nanoseconds for one unit, from a number of steps.
struct Row {
    name: String,
    target: &'static str,
    /// Steps a unit: 1, or 1 over the number of points.
    share: f64,
    run: Box<dyn Fn(u64) -> f64>,
    steps: u64,
    bound: Option<Bound>,
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
        bound: None,
        best: f64::INFINITY,
        spent: Duration::ZERO,
    }
}

/// Nanoseconds a step of a scheme on a system.
fn steps(scheme: &str, system: System, form: Form) -> impl Fn(u64) -> f64 + 'static {
    steps_of(self::scheme(scheme), system, form)
}

/// A scheme of the list.
fn scheme(name: &str) -> Contestant {
    Contestant::all().into_iter().find(|c| c.card.name == name).expect("a scheme of the list")
}

fn steps_of(contestant: Contestant, system: System, form: Form) -> impl Fn(u64) -> f64 + 'static {
    move |steps| {
        let plan = Plan { step: STEP, steps, every: steps };
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
    let contestant = scheme("peskin-rk2");
    let plan = Plan { step: STEP, steps: BATCH_STEPS, every: BATCH_STEPS };
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

/// One body at a time.
fn rows_of_one(free: &System) -> Vec<Row> {
    let one = |name: &str, target, scheme: &str, system: System| {
        row(name, target, 1.0, steps(scheme, system, Form::Least))
    };
    let five = helix(5);
    let precise = scheme("peskin-rk2").at(Precision::DoubleDouble).expect("every arithmetic");
    let (spring, drag) = (system(&five, vec![spring()]), system(&five, gravity_and_drag()));
    vec![
        one("Peskin, free body, reduced", "0.75 of plain C", "peskin-rk2", free.clone()),
        one("the same again", "", "peskin-rk2", free.clone()),
        one("Euler-only, free body, reduced", "", "euler", free.clone()),
        one("Peskin, one spring, reduced", "55", "peskin-rk2", spring),
        one("Peskin, gravity and drag on 5 points, reduced", "50", "peskin-rk2", drag),
        one("rk4-quaternion, free body", "0.95 of plain C", "rk4-quaternion", free.clone()),
        one("exact-rotor, free body", "400", "exact-rotor", free.clone()),
        row(
            "Peskin, free body, double-double",
            "35 of f64",
            1.0,
            steps_of(precise, free.clone(), Form::Least),
        ),
    ]
}

/// Bodies of many points, and many bodies.
fn rows_of_many() -> Vec<Row> {
    let mut rows = Vec::new();
    for (count, target) in [(4, "120"), (64, ""), (1024, "0.75"), (16_384, ""), (MANY, "memory/0.8")] {
        let share = if count < 1000 { 1.0 } else { 1.0 / count as f64 };
        let name = format!("Peskin, {count} points as written{}", if share < 1.0 { ", a point" } else { "" });
        let run = steps("peskin-rk2", system(&helix(count), Vec::new()), Form::Points);
        rows.push(row(&name, target, share, run));
    }
    let name = "memory: columns of as many points read and written, a point";
    rows.push(row(name, "", 1.0 / MANY as f64, memory()));
    for registers in Registers::all() {
        let name = format!("Peskin, {BODIES} free bodies, {} registers", registers.name());
        let target = match registers.name() {
            "AVX-512" => "2.5",
            "AVX2" => "5",
            _ => "11.2",
        };
        rows.push(row(&name, target, 1.0, batch(registers)));
    }
    rows
}

/// The main schemes, free and on a pivot, each with its bound.
fn rows_of_main(free: &System) -> Vec<Row> {
    let top = Scene::find("kovalevskaya").expect("built in").system;
    let mut rows = Vec::new();
    for (what, system) in [("free", free), ("on a pivot", &top)] {
        for (scheme, bound) in bounds::of_main(system) {
            let run = steps(scheme, system.clone(), Form::Least);
            rows.push(Row { bound: Some(bound), ..row(&format!("{scheme}, {what}"), "", 1.0, run) });
        }
    }
    rows
}

/// The columns that the two stages of a step of Peskin's scheme on points read and write, with a sum a number: nanoseconds a step.
fn memory() -> impl Fn(u64) -> f64 + 'static {
    let columns = RefCell::new(vec![vec![1.0f64; MANY]; 7]);
    move |_| {
        let mut columns = columns.borrow_mut();
        let [x, y, z, masses, a, b, c] = &mut columns[..] else { unreachable!("seven columns") };
        let before = Instant::now();
        for _ in 0..2 {
            let from = x.iter().zip(&*y).zip(&*z).zip(&*masses);
            let into = a.iter_mut().zip(&mut *b).zip(&mut *c);
            for ((((x, y), z), mass), ((a, b), c)) in from.zip(into) {
                (*a, *b, *c) = (x + mass, y + mass, z + mass);
            }
            std::hint::black_box((&mut *a, &mut *b, &mut *c));
        }
        before.elapsed().as_nanos() as f64
    }
}

/// Runs all rows in turn until each has had its time.
fn measure(rows: &mut [Row]) {
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
}

/// Why a step takes more than its chain.
fn reason(best: f64, bound: &Bound, rate: f64) -> String {
    let busy = bound.operations / rate;
    if best <= NEAR * bound.chain {
        String::new()
    } else if best <= NEAR * busy {
        format!("so many operations take {busy:.1} ns")
    } else {
        format!("operations {busy:.1} ns, the rest moves, stores and branches")
    }
}

fn main() {
    // `cargo test` runs benches too, with this argument: then nothing is measured.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let (latencies, rate) = (bounds::latencies(), bounds::rate());
    latencies.apply();
    println!("{latencies:.2?} ns, {rate:.2} sums and products a nanosecond\n");
    let free = system(&helix(5), Vec::new());
    let mut rows = rows_of_one(&free);
    rows.extend(rows_of_many());
    rows.extend(rows_of_main(&free));
    measure(&mut rows);
    println!("| what | ns | at most |\n|---|---|---|");
    for row in rows.iter().filter(|row| row.bound.is_none()) {
        println!("| {} | {:.2} | {} |", row.name, row.best, row.target);
    }
    println!("\n| what | ns | longest chain | over it | operations | reason |\n|---|---|---|---|---|---|");
    for (row, bound) in rows.iter().filter_map(|row| Some((row, row.bound?))) {
        let (name, best) = (&row.name, row.best);
        let Bound { chain, operations } = bound;
        let (over, reason) = (best / chain, reason(best, &bound, rate));
        println!("| {name} | {best:.1} | {chain:.1} | {over:.2} | {operations:.0} | {reason} |");
    }
}
