//! The command line of an example: options for output, exit codes, progress.

use crate::describe::{Cost, describe};
use crate::{Headline, Result};
use clap::{Args, Parser};
use indicatif::{ProgressBar, ProgressStyle};
use signorini::Error as LibraryError;
use std::io::{IsTerminal, Write};
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
        let probe = directory.join(".signorini-write-probe");
        std::fs::write(&probe, "")
            .and_then(|()| std::fs::remove_file(&probe))
            .map_err(|e| LibraryError::file(directory, e))?;
        Ok(Some(directory))
    }

    /// Finds places that cannot be written before the work, not after it.
    fn check(&self) -> Result<()> {
        self.directory()?;
        let Some(file) = self.values.as_deref() else {
            return Ok(());
        };
        let opened = std::fs::OpenOptions::new().create(true).append(true).open(file);
        opened.map(drop).map_err(|e| LibraryError::file(file, e).into())
    }
}

/// Options of an example that carry an [`Output`].
pub trait HasOutput {
    /// The output options.
    fn output(&self) -> &Output;

    /// How long a run takes at default size.
    fn cost() -> Cost {
        Cost::default()
    }
}

/// Parses the command line, runs the example and prints its headline.
pub fn main<O: Parser + HasOutput>(run: impl FnOnce(&O) -> Result<Headline>) -> ExitCode {
    let options = match parse::<O>() {
        Ok(options) => options,
        Err(error) => return report_usage(&error),
    };
    if options.output().describe {
        let _ = writeln!(std::io::stdout(), "{}", describe::<O>());
        return ExitCode::SUCCESS;
    }
    match show(&options, run) {
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
    output.check()?;
    let headline = run(options)?;
    if let Some(file) = output.values.as_deref() {
        std::fs::write(file, headline.json()).map_err(|e| LibraryError::file(file, e))?;
    }
    let text = if output.json { headline.json_lines() } else { headline.to_string() };
    // A closed pipe (`| head`) is the reader's choice, not a failure.
    let _ = std::io::stdout().write_all(text.as_bytes());
    Ok(headline.exit_code())
}

/// The options of the command line; a value may be a negative number, so that `--nu -0.1` is answered by what
/// it means.
fn parse<O: Parser>() -> std::result::Result<O, clap::Error> {
    let command = O::command().mut_args(|argument| {
        let takes_value = argument.get_action().takes_values();
        argument.allow_negative_numbers(takes_value)
    });
    O::from_arg_matches(&command.try_get_matches()?)
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

/// A progress bar over `steps`, drawn only on a terminal.
pub fn progress(steps: u64) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(steps);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}
