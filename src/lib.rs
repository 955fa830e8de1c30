//! Polhode: a verification and benchmark harness for rigid-body time-stepping schemes.
pub mod claim;
pub mod model;
pub mod record;
pub mod reference;
pub mod rotation;
pub mod schemes;
pub mod simulate;
pub mod regression;
