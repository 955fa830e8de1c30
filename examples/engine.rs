//! A foreign engine in Rust: a free rigid body under uniform gravity, by the classical Runge–Kutta method.
//!
//! ```sh
//! cargo build --release --example engine
//! polhode engine check target/release/examples/engine
//! ```
//!
//! It knows nothing of Polhode but its protocol: one JSON object a line on standard input and output.

use std::io::{BufRead, Write};
use std::time::Instant;

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use serde_json::{Value, json};

/// Position, velocity, orientation (body axes to world axes), angular velocity in body axes.
#[derive(Clone, Copy)]
struct State {
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    orientation: Quaternion<f64>,
    spin: Vector3<f64>,
}

struct Body {
    gravity: Vector3<f64>,
    inertia: Matrix3<f64>,
    inverse: Matrix3<f64>,
}

impl Body {
    /// The time derivative of a state.
    fn rates(&self, y: &State) -> State {
        State {
            position: y.velocity,
            velocity: self.gravity,
            orientation: y.orientation * Quaternion::from_imag(y.spin * 0.5),
            spin: self.inverse * (self.inertia * y.spin).cross(&y.spin),
        }
    }

    fn step(&self, h: f64, y: &State) -> State {
        let k1 = self.rates(y);
        let k2 = self.rates(&y.moved(h / 2.0, &k1));
        let k3 = self.rates(&y.moved(h / 2.0, &k2));
        let k4 = self.rates(&y.moved(h, &k3));
        y.moved(h / 6.0, &k1).moved(h / 3.0, &k2).moved(h / 3.0, &k3).moved(h / 6.0, &k4)
    }
}

impl State {
    fn moved(&self, s: f64, rates: &State) -> State {
        State {
            position: self.position + rates.position * s,
            velocity: self.velocity + rates.velocity * s,
            orientation: self.orientation + rates.orientation * s,
            spin: self.spin + rates.spin * s,
        }
    }

    fn told(&self, step: u64) -> Value {
        let q = UnitQuaternion::new_normalize(self.orientation);
        let spin = q * self.spin;
        json!({
            "step": step, "position": self.position.as_slice(), "orientation": [q.w, q.i, q.j, q.k],
            "velocity": self.velocity.as_slice(), "angular_velocity": spin.as_slice(),
        })
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_iterator(numbers(value))
}

/// The body of a request, or why it is refused.
fn body(request: &Value) -> Result<Body, String> {
    if !request["pivot"].is_null() {
        return Err("no pivot".to_owned());
    }
    let mut gravity = Vector3::zeros();
    for force in request["forces"].as_array().into_iter().flatten() {
        match force["law"].as_str() {
            Some("gravity") => gravity += vector(&force["acceleration"]),
            other => return Err(format!("no law '{}'", other.unwrap_or_default())),
        }
    }
    let entries: Vec<f64> =
        request["body"]["inertia"].as_array().into_iter().flatten().flat_map(numbers).collect();
    let inertia = Matrix3::from_row_slice(&entries);
    let inverse = inertia.try_inverse().ok_or("the inertia is singular: a rod or a point")?;
    Ok(Body { gravity, inertia, inverse })
}

fn run(request: &Value) -> Result<Value, String> {
    let body = body(request)?;
    let initial = &request["initial"];
    let [h, steps, every] = ["step", "steps", "every"].map(|key| request[key].as_f64().unwrap_or(1.0));
    let q = numbers(&initial["orientation"]);
    let orientation = UnitQuaternion::new_normalize(Quaternion::new(q[0], q[1], q[2], q[3]));
    let mut y = State {
        position: vector(&initial["position"]),
        velocity: vector(&initial["velocity"]),
        orientation: orientation.into_inner(),
        spin: orientation.inverse() * vector(&initial["angular_velocity"]),
    };
    let (steps, every) = (steps as u64, every as u64);
    let mut states = vec![y.told(0)];
    let began = Instant::now();
    for step in 1..=steps {
        y = body.step(h, &y);
        if step % every == 0 || step == steps {
            states.push(y.told(step));
        }
    }
    let elapsed = began.elapsed().as_nanos() as u64;
    Ok(json!({"states": states, "elapsed_ns": elapsed, "evaluations": 4 * steps}))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for line in std::io::stdin().lock().lines() {
        let request: Value = serde_json::from_str(&line?)?;
        let answer = match request["ask"].as_str() {
            Some("bye") => break,
            Some("hello") => json!({
                "polhode": 1, "name": "example", "version": "0.1", "scheme": "RK4", "order": 4, "forces": ["gravity"],
            }),
            _ => {
                let mut answer = run(&request).unwrap_or_else(|why| json!({"refused": why}));
                answer["id"] = request["id"].clone();
                answer
            }
        };
        println!("{answer}");
        std::io::stdout().flush()?;
    }
    Ok(())
}
