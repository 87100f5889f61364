//! The command line of an example: exit codes, memory.

use crate::describe::describe;
use crate::files::write_whole;
use crate::memory::physical;
use crate::progress::SignOfLife;
use crate::{Error, HasOutput, Headline, Result};
use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Command, Parser};
use std::any::TypeId;
use std::io::Write;
use std::process::ExitCode;

/// Parses the command line, runs the example and prints its headline.
pub fn main<O: Parser + HasOutput>(run: impl FnOnce(&O) -> Result<Headline>) -> ExitCode {
    let matches = match command::<O>().try_get_matches() {
        Ok(matches) => matches,
        Err(error) => return report_usage(&error),
    };
    let options = match O::from_arg_matches(&matches) {
        Ok(options) => options,
        Err(error) => return report_usage(&error),
    };
    if options.output().describe {
        let _ = writeln!(std::io::stdout(), "{}", describe::<O>());
        return ExitCode::SUCCESS;
    }
    let given = require_finite(&O::command(), &matches).and_then(|()| require_effect(&options, &matches));
    match given.and_then(|()| show(&options, run)) {
        Ok(code) => ExitCode::from(code),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Runs the example, writes what was asked for and returns the exit code.
fn show<O: HasOutput>(options: &O, run: impl FnOnce(&O) -> Result<Headline>) -> Result<u8> {
    let output = options.output();
    options.check()?;
    announce_memory(options.memory())?;
    output.check()?;
    let sign = SignOfLife::new();
    let headline = run(options)?;
    drop(sign);
    if let Some(file) = output.values.as_deref() {
        write_whole(file, &headline.json())?;
    }
    let text = if output.json { headline.json_lines() } else { headline.to_string() };
    // A closed pipe (`| head`) is the reader's choice, not a failure.
    let _ = std::io::stdout().write_all(text.as_bytes());
    Ok(headline.exit_code())
}

/// The command line of an example; a value may be a negative number, so that `--nu -0.1` is answered by what
/// it means.
fn command<O: Parser>() -> Command {
    O::command().mut_args(|argument| {
        let takes_value = argument.get_action().takes_values();
        argument.allow_negative_numbers(takes_value)
    })
}

/// Numbers are finite: nothing that is asked of an example has a meaning at NaN or beyond binary64.
fn require_finite(command: &Command, matches: &ArgMatches) -> Result<()> {
    let is_number = |argument: &&Arg| argument.get_value_parser().type_id() == TypeId::of::<f64>();
    for argument in command.get_arguments().filter(is_number) {
        let values = matches.get_many::<f64>(argument.get_id().as_str()).into_iter().flatten();
        if let Some(value) = values.copied().find(|value| !value.is_finite()) {
            let name = argument.get_long().unwrap_or_default();
            return Err(Error::Option(format!("--{name} {value} is not a finite number")));
        }
    }
    Ok(())
}

/// An option that was given has an effect.
fn require_effect<O: HasOutput>(options: &O, matches: &ArgMatches) -> Result<()> {
    let is_given = |name: &str| matches.value_source(name) == Some(ValueSource::CommandLine);
    match options.without_effect().into_iter().find(|(name, _)| is_given(name)) {
        Some((name, when)) => {
            Err(Error::Option(format!("--{} has no effect {when}", name.replace('_', "-"))))
        }
        None => Ok(()),
    }
}

/// `--help` and `--version` go to stdout; anything else is one line on stderr.
fn report_usage(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() {
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    let text = error.to_string();
    eprintln!("{}", text.lines().next().unwrap_or("error: bad command line"));
    ExitCode::from(2)
}

/// Says what a run will need where that is above a gigabyte.
///
/// # Errors
/// [`Error::Option`] above the memory of the machine, before anything is computed.
pub fn announce_memory(bytes: f64) -> Result<()> {
    let (needed, there) = (bytes / 1e9, physical() / 1e9);
    if needed > there {
        let what =
            format!("this takes about {needed:.1e} GB of memory, more than the {there:.1} GB there are");
        return Err(Error::Option(what));
    }
    if needed > 1.0 {
        eprintln!("this takes about {needed:.1} GB of memory");
    }
    Ok(())
}
