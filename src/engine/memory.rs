//! How much memory an engine uses, itself and all that it has started; watched where the system tells it in files.

use std::fs;
use std::sync::atomic::{AtomicU64, Ordering};

use super::error::Fault;

/// Resident memory that an engine may use [MiB].
static MOST: AtomicU64 = AtomicU64::new(4096);
/// Generations of children that are looked at: a shell, an interpreter, its workers.
const GENERATIONS: usize = 4;

/// Sets how much memory an engine may use [MiB]; the default is 4096.
pub fn set_most_memory(mebibytes: u64) {
    MOST.store(mebibytes, Ordering::Relaxed);
}

/// A fault where a process and its descendants use more than they may.
pub(super) fn watch(process: u32) -> Result<(), Fault> {
    let (used, most) = (resident(process, GENERATIONS) / 1024, MOST.load(Ordering::Relaxed));
    if used > most { Err(Fault::Memory { used, most }) } else { Ok(()) }
}

/// Resident memory of a process and of what its first thread has started, and so on [KiB]; of those that have gone, none.
fn resident(process: u32, generations: usize) -> u64 {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap_or_default();
    let own: u64 = line.trim().trim_end_matches("kB").trim().parse().unwrap_or(0);
    if generations == 0 {
        return own;
    }
    let children = fs::read_to_string(format!("/proc/{process}/task/{process}/children")).unwrap_or_default();
    let of_child = |child: &str| child.parse().map_or(0, |child| resident(child, generations - 1));
    own + children.split_whitespace().map(of_child).sum::<u64>()
}
