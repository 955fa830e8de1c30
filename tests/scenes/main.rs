//! The scene format as a user meets it: what is read, and how what is wrong is told.

#[path = "../common/mod.rs"]
mod common;

mod built_in;
mod format;
mod fuzz;
mod given;
mod malformed;
mod refused_bodies;
mod refused_forces;
mod tables;
mod user_scenes;
