//! The command line of Polhode.
fn main() {}
