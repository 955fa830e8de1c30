//! A copy of an engine: a child process that is asked, waited for, watched and ended, whatever it does.
//!
//! Each of its three pipes has a thread of its own, so that none can block another: a child that reads nothing,
//! prints without end or writes megabytes of log stops nobody. A child leads a process group, so that what it
//! has started itself ends with it; [`super::guard`] ends it where this process is killed.

use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use serde_json::Value;

use super::error::Fault;
use super::{guard, lock, memory};
use crate::interrupt;

/// Time between two looks at the clock, the user and the memory.
const LOOK: Duration = Duration::from_millis(20);
/// Time that a child has to end by itself.
const FAREWELL: Duration = Duration::from_millis(500);
/// Lines that wait to be read: a child that prints without end is held up here.
const LINES: usize = 4;
/// Bytes that are kept of the end of the log.
const LOG_BYTES: usize = 4096;
/// Process groups of the children that run.
static RUNNING: Mutex<Vec<u32>> = Mutex::new(Vec::new());

/// Ends every child at once: for a program that is about to end without cleaning up.
pub fn end_all() {
    for group in lock(&RUNNING).drain(..) {
        kill_group(group);
        guard::end(group);
    }
}

enum Line {
    Text(Vec<u8>),
    TooLong(usize),
}

/// A running copy.
pub(super) struct Process {
    child: Child,
    requests: Option<Sender<Vec<u8>>>,
    replies: Receiver<Line>,
    most_bytes: Arc<AtomicUsize>,
    log: Arc<Mutex<Vec<u8>>>,
    log_reader: Option<JoinHandle<()>>,
}

impl Process {
    /// Starts a program.
    pub fn start(words: &[String]) -> Result<Process, Fault> {
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        guard::get_ready();
        let mut running = lock(&RUNNING);
        let mut child = command.spawn().map_err(|error| Fault::NotStarted {
            program: words[0].clone(),
            why: why_not(&words[0], &error),
        })?;
        guard::begin(child.id());
        running.push(child.id());
        drop(running);
        let (requests, to_write) = mpsc::channel();
        let (read, replies) = mpsc::sync_channel(LINES);
        let most_bytes = Arc::new(AtomicUsize::new(0));
        let log = Arc::new(Mutex::new(Vec::new()));
        if let Some(input) = child.stdin.take() {
            std::thread::spawn(move || write_lines(input, &to_write));
        }
        if let Some(output) = child.stdout.take() {
            let most = most_bytes.clone();
            std::thread::spawn(move || read_lines(output, &most, &read));
        }
        let log_reader = child.stderr.take().map(|errors| {
            let log = log.clone();
            std::thread::spawn(move || keep_tail(errors, &log))
        });
        Ok(Process { child, requests: Some(requests), replies, most_bytes, log, log_reader })
    }

    /// Sends a question without waiting.
    pub fn send(&self, request: &Value) {
        let mut line = request.to_string().into_bytes();
        line.push(b'\n');
        if let Some(requests) = &self.requests {
            // A writer that has gone means a child that has gone: the answer will say so.
            let _ = requests.send(line);
        }
    }

    /// Sends a question and waits for a line of at most `most_bytes`, for as long as `patience`.
    pub fn ask(&mut self, request: &Value, most_bytes: usize, patience: Duration) -> Result<Vec<u8>, Fault> {
        self.most_bytes.store(most_bytes, Ordering::Relaxed);
        self.send(request);
        self.listen(patience)
    }

    /// Waits for a line that is not blank.
    pub fn listen(&mut self, patience: Duration) -> Result<Vec<u8>, Fault> {
        let asked = Instant::now();
        loop {
            match self.replies.recv_timeout(LOOK.min(patience)) {
                Ok(Line::Text(line)) if !line.trim_ascii().is_empty() => return Ok(line),
                Ok(Line::TooLong(most)) => return Err(Fault::TooLong(most)),
                Err(RecvTimeoutError::Disconnected) => return Err(Fault::Ended(self.end_in_words())),
                Ok(Line::Text(_)) | Err(RecvTimeoutError::Timeout) => {}
            }
            if interrupt::requested() {
                return Err(Fault::Interrupted);
            }
            if asked.elapsed() >= patience {
                return Err(Fault::Late(patience));
            }
            memory::watch(self.child.id())?;
        }
    }

    /// A fault with the last line of the log; the child is ended.
    pub fn blame(mut self, fault: Fault) -> Fault {
        self.end();
        if matches!(fault, Fault::Interrupted) {
            return fault;
        }
        self.hear_the_log_out();
        let log = lock(&self.log).clone();
        let text = String::from_utf8_lossy(&log).into_owned();
        match text.lines().rev().find(|line| !line.trim().is_empty()) {
            Some(line) => {
                Fault::Logged { fault: Box::new(fault), log: line.trim().chars().take(200).collect() }
            }
            None => fault,
        }
    }

    /// Waits until the log of a child that has ended is read; not for one who has fled with it.
    fn hear_the_log_out(&self) {
        let since = Instant::now();
        while self.log_reader.as_ref().is_some_and(|reader| !reader.is_finished())
            && since.elapsed() < FAREWELL
        {
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    /// Says goodbye, gives the child a moment to end by itself, and ends it. Returns whether it ended by itself.
    pub fn dismiss(mut self, bye: &Value) -> bool {
        self.send(bye);
        self.close();
        self.ends_within(FAREWELL)
    }

    /// Closes the child's input once everything is written.
    pub fn close(&mut self) {
        self.requests = None;
    }

    /// Whether the child ends by itself within a time.
    pub fn ends_within(&mut self, time: Duration) -> bool {
        let since = Instant::now();
        loop {
            if !matches!(self.child.try_wait(), Ok(None)) {
                return true;
            }
            if since.elapsed() >= time {
                return false;
            }
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    fn end_in_words(&mut self) -> String {
        let ended = self.ends_within(FAREWELL / 2);
        match self.child.try_wait() {
            Ok(Some(status)) if ended => status.to_string(),
            _ => "it closed its output and still runs".to_owned(),
        }
    }

    /// Ends the child and all that it has started, and waits for it.
    fn end(&mut self) {
        self.close();
        let mut running = lock(&RUNNING);
        if let Some(index) = running.iter().position(|group| *group == self.child.id()) {
            running.swap_remove(index);
            kill_group(self.child.id());
            guard::end(self.child.id());
        }
        drop(running);
        // It may have ended already; then there is nothing to kill, only to wait for.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.end();
    }
}

/// What the system says, and what a command line of that kind wants instead.
fn why_not(program: &str, error: &std::io::Error) -> String {
    let path = Path::new(program);
    match path.extension().and_then(|ending| ending.to_str()) {
        _ if path.is_dir() => "it is a folder, and a command line begins with a program".to_owned(),
        Some("py" | "js" | "jl") if path.exists() => {
            format!("{error}: write its interpreter before it, as in 'python3 {program}'")
        }
        _ if path.exists() && !program.contains('/') => format!("{error}: write ./{program}"),
        _ => error.to_string(),
    }
}

#[cfg(unix)]
fn kill_group(leader: u32) {
    if let Some(group) = i32::try_from(leader).ok().and_then(rustix::process::Pid::from_raw) {
        // A group that has ended cannot be killed, and need not be.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
}

#[cfg(not(unix))]
fn kill_group(_leader: u32) {}

fn write_lines(mut input: ChildStdin, lines: &Receiver<Vec<u8>>) {
    for line in lines {
        if input.write_all(&line).and_then(|()| input.flush()).is_err() {
            return;
        }
    }
}

fn read_lines(output: ChildStdout, most_bytes: &AtomicUsize, lines: &mpsc::SyncSender<Line>) {
    let mut output = BufReader::with_capacity(1 << 16, output);
    let mut line = Vec::new();
    loop {
        let (taken, whole) = match output.fill_buf() {
            Err(_) | Ok([]) => break,
            Ok(bytes) => {
                let end = bytes.iter().position(|byte| *byte == b'\n');
                line.extend_from_slice(&bytes[..end.unwrap_or(bytes.len())]);
                (end.map_or(bytes.len(), |end| end + 1), end.is_some())
            }
        };
        output.consume(taken);
        let most = most_bytes.load(Ordering::Relaxed).max(LOG_BYTES);
        if line.len() > most {
            let _ = lines.send(Line::TooLong(most));
            return;
        }
        if whole && lines.send(Line::Text(std::mem::take(&mut line))).is_err() {
            return;
        }
    }
    // What stands after the last end of line is cut: whoever reads it will say so.
    if !line.is_empty() {
        let _ = lines.send(Line::Text(line));
    }
}

fn keep_tail(mut errors: ChildStderr, log: &Mutex<Vec<u8>>) {
    let mut chunk = [0; 1 << 14];
    while let Ok(count @ 1..) = errors.read(&mut chunk) {
        let mut log = lock(log);
        log.extend_from_slice(&chunk[..count]);
        let excess = log.len().saturating_sub(LOG_BYTES);
        log.drain(..excess);
    }
}
