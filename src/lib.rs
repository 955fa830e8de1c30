//! Polhode: a verification and benchmark harness for rigid-body time-stepping schemes.
//!
//! ```text
//! scene ──► system (body + forces, the least model that the scene needs)
//!              │
//! scheme ──► simulate ──► trajectory ──► metrics ──► records (JSON/CSV on disk)
//!              ▲                            ▲             │
//!           reference (closed form, ODE) ───┘             ├──► gates ──► verdicts ──► exit code, JUnit
//!                                                         └──► report ──► PNG, HTML, Markdown
//! ```
//!
//! Modules stand in the order of dependency; a test reads their `use` lines and fails on any edge that goes the
//! other way.

pub mod interrupt;
pub mod number;
pub mod rotation;
pub mod elliptic;
pub mod free_rotor;
pub mod regression;
pub mod record;
pub mod model;
pub mod claim;
pub mod schemes;
pub mod reference;
pub mod scenes;
pub mod simulate;
pub mod ensemble;
pub mod sweep;
pub mod adaptive;
pub mod cost;
pub mod peers;
pub mod metrics;
pub mod advice;
pub mod stability;
pub mod gates;
pub mod campaign;
pub mod self_test;
pub mod engine;
pub mod judge;
pub mod assertion;
pub mod report;
pub mod cli;

pub use assertion::assert_order;
