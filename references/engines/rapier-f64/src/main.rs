//! Rapier in double precision behind Polhode's protocol: a free body under gravity, without damping, sleeping and
//! contact, its inertia set exactly. Its rule with four substeps, as it comes, or with another number of them:
//!
//! ```sh
//! cargo build --release --locked --manifest-path references/engines/rapier-f64/Cargo.toml \
//!     --target-dir target/rapier-f64
//! polhode engine check "target/rapier-f64/release/rapier-f64 f64-4-substeps"
//! ```

use std::io::{BufRead, Write};
use std::time::Instant;

use rapier3d_f64::prelude::*;
use serde::Deserialize;
use serde_json::{Value, json};

/// The version of Rapier that Cargo.toml pins.
const VERSION: &str = "0.36.1";

/// What a run is asked for.
#[derive(Deserialize)]
struct Request {
    body: Body,
    pivot: Option<[f64; 3]>,
    initial: Initial,
    forces: Vec<Force>,
    step: f64,
    steps: u64,
    every: u64,
}

/// Body axes about the centre of mass.
#[derive(Deserialize)]
struct Body {
    mass: f64,
    inertia: [[f64; 3]; 3],
}

/// World axes.
#[derive(Deserialize)]
struct Initial {
    position: [f64; 3],
    orientation: [f64; 4],
    velocity: [f64; 3],
    angular_velocity: [f64; 3],
}

#[derive(Deserialize)]
struct Force {
    law: String,
    #[serde(default)]
    acceleration: [f64; 3],
}

/// The world of a request and the body in it, or why it is refused.
fn world(request: &Request, substeps: usize) -> Result<(PhysicsWorld, RigidBodyHandle), String> {
    if request.pivot.is_some() {
        return Err("no pivot".to_owned());
    }
    let mut gravity = Vector::ZERO;
    for force in &request.forces {
        match force.law.as_str() {
            "gravity" => gravity += Vector::from(force.acceleration),
            other => return Err(format!("no law '{other}'")),
        }
    }
    let mass = mass_properties(&request.body)?;
    let start = &request.initial;
    let [w, x, y, z] = start.orientation;
    let body = RigidBodyBuilder::dynamic()
        .pose(Pose::from_parts(Vector::from(start.position), Rotation::from_xyzw(x, y, z, w)))
        .linvel(Vector::from(start.velocity))
        .angvel(AngVector::from(start.angular_velocity))
        .additional_mass_properties(mass)
        .linear_damping(0.0)
        .angular_damping(0.0)
        .gyroscopic_forces_enabled(true)
        .allow_fast_rotation(true)
        .can_sleep(false);
    let mut world = PhysicsWorld { gravity, ..PhysicsWorld::default() };
    world.integration_parameters.dt = request.step;
    world.integration_parameters.num_solver_iterations = substeps;
    let handle = world.bodies.insert(body);
    Ok((world, handle))
}

fn mass_properties(body: &Body) -> Result<MassProperties, String> {
    let rows = Matrix::from_cols_array_2d(&body.inertia);
    let mass = MassProperties::with_inertia_matrix(Vector::ZERO, body.mass, rows);
    let moments = mass.principal_inertia();
    let (least, most) = (moments.min_element(), moments.max_element());
    if least.is_nan() || least <= 1e-12 * most {
        return Err("the inertia is singular: a rod or a point".to_owned());
    }
    if 2.0 * most > moments.element_sum() * (1.0 + 1e-12) {
        return Err("no positive masses have this inertia".to_owned());
    }
    Ok(mass)
}

fn state(step: u64, body: &RigidBody) -> Value {
    let (x, q, v, w) = (body.translation(), body.rotation(), body.linvel(), body.angvel());
    json!({
        "step": step, "position": x.to_array(), "orientation": [q.w, q.x, q.y, q.z],
        "velocity": v.to_array(), "angular_velocity": w.to_array(),
    })
}

fn run(request: &Request, substeps: usize) -> Result<Value, String> {
    let (mut world, handle) = world(request, substeps)?;
    let mut states = vec![state(0, &world.bodies[handle])];
    let mut spent = 0;
    let mut done = 0;
    while done < request.steps {
        let count = request.every.min(request.steps - done);
        let began = Instant::now();
        (0..count).for_each(|_| world.step());
        spent += began.elapsed().as_nanos() as u64;
        done += count;
        states.push(state(done, &world.bodies[handle]));
    }
    Ok(json!({"states": states, "elapsed_ns": spent, "evaluations": substeps as u64 * request.steps}))
}

fn answer(line: &str, scheme: &str, substeps: usize) -> Option<Value> {
    let asked: Value = serde_json::from_str(line).unwrap_or_default();
    match asked["ask"].as_str() {
        Some("bye") => None,
        Some("run") => {
            let id = asked["id"].clone();
            let mut answer = match serde_json::from_value::<Request>(asked) {
                Err(why) => json!({"failed": why.to_string()}),
                Ok(request) => run(&request, substeps).unwrap_or_else(|why| json!({"refused": why})),
            };
            answer["id"] = id;
            Some(answer)
        }
        _ => Some(json!({
            "polhode": 1, "name": "rapier", "version": VERSION, "scheme": scheme,
            "order": 1, "forces": ["gravity"], "precision": "double",
        })),
    }
}

fn main() -> std::io::Result<()> {
    let asked = std::env::args().nth(1).unwrap_or("f64-4-substeps".to_owned());
    let Some(substeps) = asked.split('-').nth(1).and_then(|count| count.parse().ok()).filter(|n| *n > 0)
    else {
        eprintln!("rapier-f64 has no scheme '{asked}': write f64-4-substeps, or another number");
        std::process::exit(64);
    };
    for line in std::io::stdin().lock().lines() {
        let Some(answer) = answer(&line?, &asked, substeps) else { break };
        println!("{answer}");
        std::io::stdout().flush()?;
    }
    Ok(())
}
