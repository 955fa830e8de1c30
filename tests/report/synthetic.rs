//! Records that no campaign wrote: the size of a real one, and every kind of trouble that it may have.

use std::sync::Arc;

use polhode::record::{
    ClaimName, Drift, DriftClass, Machine, Measurement, Order, OrderStatus, Records, ReferenceRow, Ruling,
    RunStatus, SCHEMA, SceneRow, SchemeRow, Series, Verdict,
};

/// Scenes in the whole.
pub const SCENES: usize = 30;
const LADDER: i32 = 9;
const QUANTITIES: [(&str, &str); 6] = [
    ("position", "m"),
    ("velocity", "m/s"),
    ("orientation", "rad"),
    ("angular-velocity", "rad/s"),
    ("angular-momentum", "kg m²/s"),
    ("body-point", "m"),
];

/// A reproducible number between 0 and 1, different for every name.
fn chance(seed: &str) -> f64 {
    let hash = seed.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    let mixed = (hash ^ (hash >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    ((mixed ^ (mixed >> 32)) >> 11) as f64 / (1u64 << 53) as f64
}

fn scheme_rows() -> Vec<SchemeRow> {
    let card = |name: &str, title: &str, order, evaluations| SchemeRow {
        name: name.into(),
        title: title.into(),
        family: "exact rotations".into(),
        order,
        evaluations,
        claims: vec![format!("order {order} in every quantity"), "L constant without torque".into()],
        source: "peskin2021, steps (1)–(8)".into(),
        apart: false,
        look: None,
        fails_where: Some("spring-held body: from h·ω = 1.256 on (energy grows)".into()),
    };
    vec![
        card("peskin-rk2", "Peskin's two-stage scheme", 2, 2),
        card("euler", "Euler with exact rotations", 1, 1),
    ]
}

/// Every third scene is free (position, velocity and L exact), every seventh carries no order, every tenth breaks.
fn scene_row(index: usize) -> SceneRow {
    let free = index.is_multiple_of(3);
    SceneRow {
        file: String::new(),
        name: format!("scene-{index:02}"),
        content: format!("{index:02}"),
        title: format!("Scene {index}: a body <turned> by \"springs\" & gravity"),
        why: "position-dependent forces | what an order test on a free body cannot see".into(),
        duration_s: 8.0,
        model: if free { "free" } else { "forced" }.into(),
        points: 4,
        laws: if free { vec![] } else { vec!["gravity".into(), "spring".into()] },
        not_for_order: (index % 7 == 5).then(|| "the motion is chaotic: errors saturate".into()),
        references: vec![ReferenceRow {
            source: "dop853".into(),
            detail: "tolerance 1e-15".into(),
            role: "run".into(),
            disagreement_rad: Some(3.1e-13),
        }],
        reduction_difference: Some(4.4e-14),
        reduction_speedup: Some(2.31),
    }
}

/// The error that a scheme of this order makes: saturating at large steps, with a hump, above a floor.
fn error(scene: usize, order: u32, quantity: &str, step: f64) -> f64 {
    let size = 10f64.powf(2.0 * chance(&format!("{scene} {quantity}")) - 1.0);
    let hump = 1.0 + 60.0 * chance(&format!("hump {scene}")) * step * step;
    let raw = size * step.powi(order as i32) * hump;
    let floor = 1e-9 * chance(&format!("floor {scene} {quantity}")).powi(4) + 2e-13;
    raw / (1.0 + raw / 2.0) + floor * chance(&format!("{scene} {quantity} {step}"))
}

fn is_exact(scene: usize, quantity: &str) -> bool {
    scene.is_multiple_of(3) && ["position", "velocity", "angular-momentum"].contains(&quantity) || scene == 12
}

fn measurement(scene: usize, scheme: &SchemeRow, rung: i32, metric: &str, unit: &str) -> Measurement {
    let step_s = 0.25 / 2f64.powi(rung);
    Measurement {
        scene: format!("scene-{scene:02}"),
        scheme: scheme.name.clone(),
        model: "forced".into(),
        step_s,
        steps: (8.0 / step_s) as u64,
        metric: metric.into(),
        unit: unit.into(),
        uncertainty: Some(2e-13),
        status: RunStatus::Ok,
        force_evaluations: 1024,
        nanoseconds_per_step: Some(90.0 + 10.0 * chance(&format!("{rung}"))),
        ..Measurement::default()
    }
}

fn ladder(scene: usize, scheme: &SchemeRow, quantity: &str, unit: &str) -> Vec<Measurement> {
    let metric = format!("{quantity}-end");
    let mut rows: Vec<Measurement> =
        (0..LADDER).map(|rung| measurement(scene, scheme, rung, &metric, unit)).collect();
    for row in &mut rows {
        if scene % 10 == 4 && row.step_s > 0.1 {
            row.status = RunStatus::Broken;
            row.why = Some("not finite at step 12, t = 3 s".into());
        } else if is_exact(scene, quantity) {
            row.value = Some(3e-16 * chance(&format!("{scene} {quantity} {}", row.step_s)));
        } else {
            row.value = Some(error(scene, scheme.order, quantity, row.step_s));
        }
    }
    rows
}

fn order(scene: usize, scheme: &SchemeRow, quantity: &str, unit: &str, rows: &[Measurement]) -> Order {
    let exact = is_exact(scene, quantity);
    let unsettled = scene == 8 && quantity == "velocity";
    let used: Vec<f64> =
        rows.iter().filter(|row| row.step_s < 0.1 && row.value > Some(1e-8)).map(|r| r.step_s).collect();
    let measured = f64::from(scheme.order) + 0.04 * (chance(&format!("{scene} {quantity}")) - 0.5);
    let decided = !exact && !unsettled && used.len() > 2;
    let status = match (exact, unsettled, decided) {
        (true, ..) => OrderStatus::Exact,
        (_, true, _) => OrderStatus::Undecided,
        (.., true) => OrderStatus::Decided,
        _ => OrderStatus::TooFew,
    };
    Order {
        scene: format!("scene-{scene:02}"),
        scheme: scheme.name.clone(),
        quantity: quantity.into(),
        order: decided.then_some(measured),
        low: decided.then_some(measured - 0.012),
        high: decided.then_some(measured + 0.012),
        r: decided.then_some(0.008),
        until_s: decided.then_some(8.0),
        constant: decided.then_some(0.3),
        rungs_used: used.len(),
        rungs_dropped: rows.len() - used.len(),
        steps_used_s: if decided { used } else { vec![] },
        floor: Some(if exact {
            1e-15
        } else {
            1e-9 * chance(&format!("floor {scene} {quantity}")).powi(4) + 2e-13
        }),
        unit: unit.into(),
        status,
        why: (status != OrderStatus::Decided).then(|| format!("{status}: slopes 1.5 to 2.2")),
    }
}

fn verdict(scene: usize, scheme: &SchemeRow, claim: ClaimName, order: &Order) -> Verdict {
    let (ruling, detail) = match order.status {
        OrderStatus::Decided if scene == 9 => {
            (Ruling::Fail, "order 2.00 ± 0.01 outside 1 ± 0.15: 100 % wrong,\nsee the ladder")
        }
        OrderStatus::Decided => (Ruling::Pass, "inside the band"),
        OrderStatus::Exact => (Ruling::NotApplicable, "exact: no order there"),
        _ if scene % 10 == 4 => (Ruling::Broken, "not finite at step 12, t = 3 s"),
        _ => (Ruling::Inconclusive, "slopes do not settle: 1.5 to 2.2"),
    };
    Verdict {
        rule: claim.word().into(),
        scene: order.scene.clone(),
        scheme: scheme.name.clone(),
        claim,
        quantity: order.quantity.clone(),
        verdict: ruling,
        measured: order.order,
        low: order.low,
        high: order.high,
        detail: detail.into(),
        known_deviation: (scene == 9 && scheme.order == 1).then(|| "known since 2021".into()),
    }
}

fn series(scene: usize, scheme: &SchemeRow) -> Vec<Series> {
    let quantities = [
        ("rotational-energy", "1", 1e-4),
        ("total-energy", "1", 2e-5),
        ("angular-momentum-magnitude", "1", if scene.is_multiple_of(3) { 0.0 } else { 1e-6 }),
        ("angular-momentum-direction", "rad", if scene.is_multiple_of(3) { 0.0 } else { 1e-7 }),
    ];
    let size = if scheme.order == 1 { 100.0 } else { 1.0 };
    let one = |(quantity, unit, scale): (&str, &str, f64)| {
        let time_s: Vec<f64> = (0..=1000).map(|n| f64::from(n) * 0.008).collect();
        let value = time_s
            .iter()
            .map(|t| size * scale * (t + 3.0 * (5.0 * t + scene as f64).sin() * (t / 8.0)))
            .collect();
        Series {
            scene: format!("scene-{scene:02}"),
            scheme: scheme.name.clone(),
            step_s: 0.0078125,
            quantity: quantity.into(),
            unit: unit.into(),
            time_s,
            value,
        }
    };
    quantities.into_iter().map(one).collect()
}

fn drift(scene: usize, scheme: &SchemeRow) -> Drift {
    let power = f64::from(scheme.order) + 1.0;
    Drift {
        scene: format!("scene-{scene:02}"),
        scheme: scheme.name.clone(),
        quantity: "rotational-energy".into(),
        class: DriftClass::Secular,
        rate_order: Some(power),
        low: Some(power - 0.01),
        high: Some(power + 0.01),
        rate: Some(3.2e-7),
        step_s: Some(0.25 / 256.0),
        level: Some(4.1e-6),
        unit: "1".into(),
    }
}

/// The rows that one scheme adds on one scene.
fn add(records: &mut Records, scene: usize, scheme: &SchemeRow) {
    let carries_order = scene % 7 != 5;
    for (quantity, unit) in QUANTITIES {
        let rows = ladder(scene, scheme, quantity, unit);
        if carries_order {
            let order = order(scene, scheme, quantity, unit, &rows);
            records.verdicts.push(verdict(scene, scheme, ClaimName::Order, &order));
            records.orders.push(order);
        }
        records.measurements.extend(rows.into_iter().map(Arc::new));
    }
    for rung in 0..LADDER {
        let mut row = measurement(scene, scheme, rung, "rotational-energy-drift-rate", "1/s");
        let sign = if scene % 4 == 1 { -1.0 } else { 1.0 };
        let size = 10f64.powf(2.0 * chance(&format!("drift {scene}")) - 2.0);
        row.value = (scene.is_multiple_of(2)).then(|| sign * size * row.step_s.powi(scheme.order as i32 + 1));
        records.measurements.push(row.into());
    }
    if scene.is_multiple_of(2) {
        records.drifts.push(drift(scene, scheme));
    }
    records.series.extend(series(scene, scheme).into_iter().map(Arc::new));
}

/// Records of the size and the kinds of trouble that a campaign has.
pub fn synthetic() -> Records {
    let mut records = Records {
        schema: SCHEMA.into(),
        polhode: "0.1.0".into(),
        machine: Machine {
            os: "linux".into(),
            architecture: "x86_64".into(),
            processor: "".into(),
            threads: 2,
        },
        made_at: "2021-09-22T00:00:00Z".into(),
        complete: true,
        scenes: (0..SCENES).map(scene_row).collect(),
        schemes: scheme_rows(),
        ..Records::default()
    };
    for scene in 0..SCENES {
        for scheme in scheme_rows() {
            add(&mut records, scene, &scheme);
        }
    }
    records
}

/// The records of some scenes alone.
pub fn few(scenes: &[usize]) -> Records {
    let mut records = synthetic();
    let names: Vec<String> = scenes.iter().map(|scene| format!("scene-{scene:02}")).collect();
    records.scenes.retain(|row| names.contains(&row.name));
    records.measurements.retain(|row| names.contains(&row.scene));
    records.orders.retain(|row| names.contains(&row.scene));
    records.drifts.retain(|row| names.contains(&row.scene));
    records.verdicts.retain(|row| names.contains(&row.scene));
    records.series.retain(|row| names.contains(&row.scene));
    records
}
