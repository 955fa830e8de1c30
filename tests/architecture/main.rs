//! What the text of the crate must be: which room uses which, that every file is built and every scheme
//! listed, that sources stand in the bibliography.

#[path = "../common/mod.rs"]
mod common;

mod bibliography;
mod cards;
mod door;
mod lists;
mod rooms;
mod sources;
