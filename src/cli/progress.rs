//! Progress on stderr: a bar on a terminal, and a line at least every ten seconds without one.

use std::io::IsTerminal;
use std::sync::Mutex;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use crate::campaign::Task;

/// Time between two lines: below the ten seconds after which a build server may take a program for dead.
const BETWEEN_LINES: Duration = Duration::from_secs(9);

/// Time between two signs on a terminal that work goes on.
const BETWEEN_SIGNS: Duration = Duration::from_millis(200);

/// What is done, how much of it, and of how much.
type State = (&'static str, usize, usize);

/// Does work that calls (done, of all) after each piece, and shows how far it is unless `quiet`.
pub(super) fn with_bar<T>(
    quiet: bool,
    what: &'static str,
    work: impl FnOnce(&(dyn Fn(usize, usize) + Sync)) -> T,
) -> T {
    shown(quiet, what, |tell| work(&|done, all| tell((what, done, all))))
}

/// Does work that cannot say how far it is, and shows that it goes on unless `quiet`.
pub(super) fn with_word<T>(quiet: bool, what: &'static str, work: impl FnOnce() -> T) -> T {
    if quiet || !std::io::stderr().is_terminal() {
        return shown(quiet, what, |_| work());
    }
    let sign = ProgressBar::new_spinner().with_message(what);
    sign.enable_steady_tick(BETWEEN_SIGNS);
    let result = work();
    sign.finish_and_clear();
    result
}

/// The same for a survey, whose tasks have a bar each, one after the other.
pub(super) fn with_tasks<T>(quiet: bool, work: impl FnOnce(&(dyn Fn(Task, usize, usize) + Sync)) -> T) -> T {
    shown(quiet, "measuring", |tell| {
        work(&|task, done, all| {
            if task == Task::Timing && done == 0 && !quiet {
                eprintln!("polhode: timing steps, one thread");
            }
            tell((task.word(), done, all));
        })
    })
}

fn shown<T>(quiet: bool, what: &'static str, work: impl FnOnce(&(dyn Fn(State) + Sync)) -> T) -> T {
    if quiet {
        return work(&|_| ());
    }
    if !std::io::stderr().is_terminal() {
        return with_lines(BETWEEN_LINES, what, &|line| eprintln!("{line}"), work);
    }
    let style = ProgressStyle::with_template("{prefix} {wide_bar} {pos}/{len}, {eta} left");
    let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(0).with_prefix(what).with_style(style);
    let result = work(&|(what, done, all)| {
        bar.set_prefix(what);
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    result
}

/// Says how far the work is, again and again until it is done.
fn with_lines<T>(
    between: Duration,
    what: &'static str,
    say: &(dyn Fn(String) + Sync),
    work: impl FnOnce(&(dyn Fn(State) + Sync)) -> T,
) -> T {
    let state: Mutex<State> = Mutex::new((what, 0, 0));
    let read = || *state.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let tell = |now: State| *state.lock().unwrap_or_else(std::sync::PoisonError::into_inner) = now;
    std::thread::scope(|scope| {
        let (end, ended) = mpsc::channel::<()>();
        let lines = move || {
            while ended.recv_timeout(between) == Err(RecvTimeoutError::Timeout) {
                let (what, done, all) = read();
                let how_far = if all > 0 { format!(", {done} of {all}") } else { String::new() };
                say(format!("polhode: {what}{how_far}"));
            }
        };
        scope.spawn(lines);
        let result = work(&tell);
        drop(end);
        result
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_while_the_work_goes_on_and_say_how_far_it_is() {
        let (line, lines) = mpsc::channel();
        let line = Mutex::new(line);
        let say = |text: String| line.lock().expect("a sender").send(text).expect("a receiver");
        let said = with_lines(Duration::from_millis(1), "asking", &say, |tell| {
            // Waits for as long as it takes.
            let first = lines.iter().next();
            tell(("measuring", 3, 7));
            (first, lines.iter().find(|text| text.contains("measuring, 3 of 7")))
        });
        assert_eq!((said.0.as_deref(), said.1.is_some()), (Some("polhode: asking"), true));
    }
}
