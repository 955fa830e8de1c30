//! The end of engines whose caller is killed.
//!
//! An engine that reads the end of its input ends by itself. One that does not would go on for ever. A shell therefore waits beside the
//! engines for the end of this process, which it sees as the end of its input, and ends the groups that still run. It ends with this process
//! in any case.

use std::io::Write;
use std::process::{ChildStdin, Command, Stdio};
use std::sync::{LazyLock, Mutex};

use super::lock;

/// Reads `+ GROUP` and `- GROUP`, and kills what is left when there is no more to read.
const SCRIPT: &str = r#"
running=" "
while read -r sign group; do
    case $sign in
        +) running="$running$group " ;;
        -) running="${running%% $group *} ${running#* $group }" ;;
    esac
done
for group in $running; do kill -s KILL -- "-$group"; done
"#;

static SHELL: LazyLock<Mutex<Option<ChildStdin>>> = LazyLock::new(|| Mutex::new(start()));

fn start() -> Option<ChildStdin> {
    let mut command = Command::new("/bin/sh");
    // Out of the way: a terminal does not interrupt it, and no reader of this program's output waits for it.
    command.args(["-c", SCRIPT]).current_dir("/");
    command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null());
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    // Without a shell there is no guard, and engines run all the same.
    command.spawn().ok()?.stdin
}

/// Starts the shell, before the first engine is there.
pub(super) fn get_ready() {
    drop(lock(&SHELL));
}

/// A group of processes runs from now on.
pub(super) fn begin(group: u32) {
    write('+', group);
}

/// A group has ended.
pub(super) fn end(group: u32) {
    write('-', group);
}

fn write(sign: char, group: u32) {
    let mut shell = lock(&SHELL);
    let written = shell.as_mut().map(|shell| writeln!(shell, "{sign} {group}"));
    if let Some(Err(_)) = written {
        *shell = None;
    }
}
