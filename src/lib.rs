//! Polhode: a verification and benchmark harness for rigid-body time-stepping schemes.
pub mod record;
pub mod report;
