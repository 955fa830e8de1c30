//! Polhode: a verification and benchmark harness for rigid-body time-stepping schemes.
pub mod claim;
pub mod model;
pub mod record;
pub mod rotation;
pub mod scenes;
pub mod schemes;
