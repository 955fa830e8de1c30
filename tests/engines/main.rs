//! Foreign engines from outside: one that behaves, and every way of not behaving that could be thought of.

#![cfg(unix)]

mod behaving;
mod misbehaving;
mod peers;
mod stage;
