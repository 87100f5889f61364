//! The command line of an example: options for output, exit codes, memory.

use crate::describe::{Cost, describe};
use crate::files::{require_writable, write_whole};
use crate::memory::physical;
use crate::progress::SignOfLife;
use crate::{Error, Headline, Result};
use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Args, Command, Parser};
use signorini::Error as LibraryError;
use std::any::TypeId;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Where the outcome goes.
#[derive(Debug, Clone, Default, Args)]
pub struct Output {
    /// Print one JSON object per row and per finding instead of the table
    #[arg(long)]
    pub json: bool,
    /// Write figures (SVG) into this directory
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write the whole outcome as one JSON object into this file (read by the book)
    #[arg(long, value_name = "FILE")]
    pub values: Option<PathBuf>,
    /// Print what may be asked of this example as JSON, and compute nothing
    #[arg(long)]
    pub describe: bool,
}

impl Output {
    /// The directory for figures, created if need be; `None` when no figure was asked for.
    ///
    /// # Errors
    /// [`signorini::Error::File`] when it cannot be created or written.
    pub fn directory(&self) -> signorini::Result<Option<&Path>> {
        let Some(directory) = self.out.as_deref() else {
            return Ok(None);
        };
        std::fs::create_dir_all(directory).map_err(|e| LibraryError::file(directory, e))?;
        require_writable(&directory.join(".signorini-write-probe")).map_err(|error| match error {
            LibraryError::File { reason, .. } => LibraryError::file(directory, reason),
            other => other,
        })?;
        Ok(Some(directory))
    }

    /// Finds places that cannot be written before the work, not after it.
    fn check(&self) -> Result<()> {
        self.directory()?;
        Ok(self.values.as_deref().map_or(Ok(()), require_writable)?)
    }
}

/// Options of an example that carry an [`Output`].
pub trait HasOutput {
    /// The output options.
    fn output(&self) -> &Output;

    /// Options that have no effect as the others stand: their names, and when that is so.
    fn without_effect(&self) -> Vec<(&'static str, &'static str)> {
        Vec::new()
    }

    /// Finds options that do not go together, before the first computation.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<()> {
        Ok(())
    }

    /// About how many bytes a run takes; 0 where it says so itself, or needs no word.
    fn memory(&self) -> f64 {
        0.0
    }

    /// How long a run takes at default size.
    fn cost() -> Cost {
        Cost::default()
    }
}

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
