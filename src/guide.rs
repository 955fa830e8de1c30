//! A guide in three sections: gate your own scheme, write your own scene, read the records.
//!
//! # Gate your own scheme
//!
//! A test needs neither the program nor its solvers and pictures. In `Cargo.toml`:
//!
//! ```toml
//! [dev-dependencies]
//! polhode = { version = "0.1", default-features = false }
//!
//! [profile.test]
//! opt-level = 2
//! ```
//!
//! Optimized, an assertion takes a second or two; without optimization it takes a minute.
//!
//! A scheme is a type that implements [`Scheme`](super::schemes::Scheme). Its step is written in two verbs of a model.
//! [`rates`](super::model::Model::rates) evaluates the forces and returns Ω, U_cm, F/M and τ at a state.
//! [`advance`](super::model::Model::advance) holds rates for a time, and turns the body by the exact rotation. Rates add, and they
//! are scaled by numbers. States that a step needs in between are borrowed from the workspace; `STATES` is their number.
//!
//! ```
//! use polhode::prelude::*;
//!
//! /// Heun's rule: the mean of the rates at both ends of the step.
//! #[derive(Clone, Copy)]
//! struct Heun;
//!
//! impl Scheme for Heun {
//!     fn card(&self) -> Card {
//!         Card::new("my-heun", &[Claim::Order(2), Claim::Evaluations(2)])
//!     }
//!
//!     const STATES: usize = 1;
//!
//!     fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
//!         let [end] = work.buffers();
//!         let k0 = model.rates(t, from)?;
//!         model.advance(from, h, &k0, end);
//!         let k1 = model.rates(t + h, end)?;
//!         model.advance(from, h, &((k0 + k1) / 2.0), to);
//!         Ok(())
//!     }
//! }
//!
//! // In a function under #[test]:
//! assert_order(&Heun, 2);
//!
//! // Every claim of the card, not the order alone:
//! let scenes = vec![Scene::find("free-asymmetric")?];
//! let records = Campaign::of(scenes, vec![Contestant::new(Heun)]).run();
//! assert_eq!(polhode::gates::exit_code(&records.verdicts), 0);
//! # Ok::<(), polhode::scenes::SceneError>(())
//! ```
//!
//! [`assert_order`](super::assert_order) runs the scheme at a ladder of steps in four scenes: a free body, a top on a pivot, a body
//! on springs, and a body with drag. The order must be the asserted one in six quantities, at the end of a run and as the largest
//! error over it. Otherwise the test fails with a summary and the details:
//!
//! ```text
//! my-heun: order 1.00 measured, 2 claimed, in 21 of 21 quantities
//!   free-asymmetric, orientation-end: fail: slope 0.998 [0.993, 1.003] over 6 rungs, below the band: 1.85 … 2.15
//!   …
//! ```
//!
//! A scheme that lives in body axes implements [`TurningScheme`](super::schemes::TurningScheme) and is asserted by
//! [`assert_order_in_body_axes`](super::assert_order_in_body_axes). [`assert_order_in`](super::assert_order_in) takes the scenes, by
//! name or as files.
//!
//! # Your own scene
//!
//! A scene is a TOML file: a body, its start, the forces on it, and the duration of a run. Units are SI units and radians. Vectors are
//! in world axes unless a key says body. Every fault of a file is reported with its line, its key and what to write instead.
//!
//! ```
//! use polhode::prelude::*;
//! use polhode::schemes::PeskinRk2;
//!
//! let text = r#"
//!     name = "my-body"
//!     duration = 2.0
//!
//!     [body]
//!     mass = 2.0
//!     inertia = [1.0, 2.0, 2.5]        # or points = [{ mass = 1.0, position = [0.5, 0.0, 0.0] }, …]
//!
//!     [initial]
//!     angular_velocity = [0.1, 2.0, 0.1]
//!
//!     [[forces]]
//!     law = "gravity"
//!     acceleration = [0.0, 0.0, -9.81]
//! "#;
//! let scene = Scene::parse(text, "my-body.toml")?; // or Scene::find("my-body.toml")
//!
//! // 200 steps of 0.01 s, with ten states kept.
//! let plan = Plan::over(scene.duration, 200, 10);
//! let run = Contestant::new(PeskinRk2).run(&scene.system, Form::Least, &plan);
//! let last = run.states.last().expect("a run has states");
//! assert!((last.position.z + 0.5 * 9.81 * last.time.powi(2)).abs() < 1e-12);
//! # Ok::<(), polhode::scenes::SceneError>(())
//! ```
//!
//! [`scenes::built_in`](super::scenes::built_in) has all scenes of the list; `polhode list scenes` prints them. `polhode list forces`
//! prints a block to paste for each law, and `polhode list forces --schema` the JSON Schema of a scene file.
//!
//! # Read the records
//!
//! All that is measured and judged is in one value, [`Records`](super::record::Records). A
//! [`Campaign`](super::campaign::Campaign) returns it, a [`Survey`](super::campaign::Survey) returns it with costs, and
//! `polhode gate --json FILE` and `polhode report` write it as `records.json`.
//! [`Records::read`](super::record::Records::read) reads such a file. A value that does not exist is `None`, never a NaN.
//!
//! In the file the lists `errors`, `rounding` and the values of `series` are packed text. Its first character is the code: `5` is
//! followed by four characters a number, `2` by two, `*` by eleven; `.` is a zero and `,` ends a list. The characters are digits in
//! base 64 (`A–Z a–z 0–9 - _`), the highest first. Code `5` is ((e + 70) · 90000 + m − 10000) · 2 + sign for ± m · 10ᵉ, code `2` is
//! (e + 34) · 90 + m − 10, and `*` is the bits of the f64.
//!
//! ```
//! use polhode::prelude::*;
//! use polhode::schemes::{Euler, PeskinRk2};
//!
//! let scenes = vec![Scene::find("kovalevskaya")?];
//! let contestants = vec![Contestant::new(PeskinRk2), Contestant::new(Euler)];
//! let records = Campaign::of(scenes, contestants).run(); // or Records::read(Path::new("records.json"))?
//!
//! // The measured order of one quantity, with its bounds.
//! for row in records.orders.iter().filter(|row| row.quantity == "orientation") {
//!     if let (Some(order), Some(low), Some(high)) = (row.order, row.low, row.high) {
//!         println!("{} in {}: {order:.3} [{low:.3}, {high:.3}]", row.scheme, row.scene);
//!     }
//! }
//!
//! // The error against the step, in the unit of the row.
//! let errors = records.measurements.iter().filter(|row| row.scheme == "euler" && row.metric == "position-end");
//! let errors: Vec<(f64, Option<f64>)> = errors.map(|row| (row.step_s, row.value)).collect();
//! assert!(errors.len() > 4);
//!
//! // Claims that do not hold, with the reason.
//! let failed = records.verdicts.iter().filter(|verdict| verdict.verdict == Ruling::Fail);
//! for verdict in failed {
//!     println!("{} {} {}: {}", verdict.scheme, verdict.claim, verdict.quantity, verdict.detail);
//! }
//! # Ok::<(), polhode::scenes::SceneError>(())
//! ```
//!
//! With the feature `cli`, which is on by default, `polhode::write_report(&records, "reports/mine")` draws the records: one HTML page,
//! the same in Markdown, pictures, and the records beside them. `examples/my_scheme.rs` does so for a user's scheme.
