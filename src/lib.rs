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

pub mod campaign;
pub mod claim;
pub mod cli;
pub mod gates;
pub mod interrupt;
pub mod metrics;
pub mod model;
pub mod record;
pub mod reference;
pub mod regression;
pub mod report;
pub mod rotation;
pub mod scenes;
pub mod schemes;
pub mod simulate;
