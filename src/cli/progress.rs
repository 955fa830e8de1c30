//! Progress on stderr.

use indicatif::{ProgressBar, ProgressStyle};

use crate::campaign::Task;

/// Does work that calls (done, of all) after each piece, beside a bar with the time left. There is no bar where `quiet`, or where
/// stderr is no terminal.
pub(super) fn with_bar<T>(
    quiet: bool,
    what: &'static str,
    work: impl FnOnce(&(dyn Fn(usize, usize) + Sync)) -> T,
) -> T {
    let bar = bar(quiet, what);
    let result = work(&|done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    result
}

/// The same for a survey, whose tasks have a bar each, one after the other.
pub(super) fn with_tasks<T>(quiet: bool, work: impl FnOnce(&(dyn Fn(Task, usize, usize) + Sync)) -> T) -> T {
    let bar = bar(quiet, "");
    let result = work(&|task, done, all| {
        if task == Task::Timing && done == 0 && !quiet {
            bar.suspend(|| eprintln!("polhode: timing steps, one thread"));
        }
        bar.set_prefix(task.word());
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    result
}

fn bar(quiet: bool, what: &'static str) -> ProgressBar {
    if quiet {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{prefix} {wide_bar} {pos}/{len}, {eta} left");
    ProgressBar::new(0).with_prefix(what).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
