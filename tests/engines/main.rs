//! Foreign engines from outside: one that behaves, and every way of not behaving that could be thought of.

#![cfg(unix)]

#[path = "../common/mod.rs"]
mod common;

mod behaving;
mod budget;
mod contract;
mod mended;
mod misbehaving;
mod peers;
mod stage;
