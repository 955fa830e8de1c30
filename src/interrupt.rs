//! Whether the user wants the program to end: set once by Ctrl-C, read between chunks of work.

use std::sync::atomic::{AtomicBool, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// Whether the work should end early.
pub fn requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}

/// Asks the work to end early. Returns whether it was asked before.
pub fn request() -> bool {
    REQUESTED.swap(true, Ordering::Relaxed)
}
