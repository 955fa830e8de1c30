//! Help on one screen: `--help` of a subcommand is a line an option, `polhode help NAME` has the examples and the rest.

use std::io::IsTerminal;

use clap::{Arg, ArgAction, ColorChoice, Command};

/// What `polhode` alone prints first.
const BEGIN: &str = "\
How accurate, how stable and how fast is a time-stepping scheme for a rigid body, and how do you know?

To begin with:
  polhode report                                      the whole report, into reports/latest
  polhode gate --scheme 'engine:python3 engine.py'    your engine: exit code 0 only if every claim holds
  polhode advise kovalevskaya --tolerance 1e-4        which scheme and which step for a tolerance
";

/// Width of help.
const WIDTH: usize = 100;

/// The screen of `polhode` alone: three commands to begin with, and the names of all.
pub(super) fn screen(command: &Command) -> String {
    let mut text = format!("{BEGIN}\nCommands:\n");
    let mut line = " ".to_owned();
    for name in command.get_subcommands().map(Command::get_name) {
        if line.len() + 1 + name.len() > WIDTH {
            text += &format!("{line}\n");
            " ".clone_into(&mut line);
        }
        line += &format!(" {name}");
    }
    text + &format!(
        "{line}\n\npolhode --help says what each does, polhode help NAME gives its options and examples.\n"
    )
}

/// The parser, with help that fits a screen.
pub(super) fn arranged(command: Command) -> Command {
    let command = command.disable_help_flag(true).arg(flag()).help_template(TEMPLATE);
    command.mut_subcommands(of_subcommand)
}

/// A line a command: the options of all of them stand in `polhode help NAME`.
const TEMPLATE: &str = "{about}\n{usage-heading} {usage}\n\n{subcommands}{after-help}";

fn flag() -> Arg {
    Arg::new("help").short('h').long("help").action(ArgAction::HelpShort).help("Print this")
}

fn of_subcommand(command: Command) -> Command {
    let examples = command.get_after_help().map(ToString::to_string);
    let name = command.get_name().to_owned();
    let command = match examples {
        Some(examples) => {
            command.after_help(format!("Examples and details: polhode help {name}")).after_long_help(examples)
        }
        None => command,
    };
    command.disable_help_flag(true).arg(flag()).mut_subcommands(of_subcommand)
}

/// When to colour, as the user says it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Colour {
    /// On a terminal, unless NO_COLOR is set
    #[default]
    Auto,
    Always,
    Never,
}

impl Colour {
    /// Whether text on stdout is coloured. See no-color.org.
    pub(super) fn colours(self) -> bool {
        let unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        match self {
            Colour::Always => true,
            Colour::Never => false,
            Colour::Auto => !unwanted && std::io::stdout().is_terminal(),
        }
    }

    /// The same for help and for errors of usage, which the parser prints before any option is read.
    pub(super) fn of_words(words: &[std::ffi::OsString]) -> ColorChoice {
        let given = words.iter().position(|word| word == "--color").and_then(|place| words.get(place + 1));
        let joined = words.iter().find_map(|word| word.to_str()?.strip_prefix("--color="));
        match given.and_then(|word| word.to_str()).or(joined) {
            Some("always") => ColorChoice::Always,
            Some("never") => ColorChoice::Never,
            _ => ColorChoice::Auto,
        }
    }
}
