//! What every example shares: the options `--json` and `--out`, exit codes, and a progress bar.
//!
//! An example is one function `run(&Options) -> signorini::Result<Headline>` and a `main` of one line. Exit codes:
//! 0 the statement is confirmed, 1 it is not, 2 bad input (one clear line on stderr).

pub mod poincare;
mod rates;

pub use rates::{RateOptions, RateScene, rates};

use clap::{Args, Parser};
use indicatif::{ProgressBar, ProgressStyle};
use signorini::report::Headline;
use signorini::{Error, Result};
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Where the outcome goes.
#[derive(Debug, Clone, Default, Args)]
pub struct Output {
    /// Print one JSON object per row instead of the table
    #[arg(long)]
    pub json: bool,
    /// Write figures (SVG) into this directory
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write the whole outcome as one JSON object into this file (read by the book)
    #[arg(long, value_name = "FILE")]
    pub values: Option<PathBuf>,
}

impl Output {
    /// The directory for figures, created if need be; `None` when no figure was asked for.
    ///
    /// # Errors
    /// [`Error::File`] when it cannot be created or written.
    pub fn directory(&self) -> Result<Option<&Path>> {
        let Some(directory) = self.out.as_deref() else {
            return Ok(None);
        };
        std::fs::create_dir_all(directory).map_err(|e| Error::file(directory, e))?;
        let probe = directory.join(".signorini-write-probe");
        std::fs::write(&probe, "")
            .and_then(|()| std::fs::remove_file(&probe))
            .map_err(|e| Error::file(directory, e))?;
        Ok(Some(directory))
    }

    /// Finds places that cannot be written before the work, not after it.
    fn check(&self) -> Result<()> {
        self.directory()?;
        let Some(file) = self.values.as_deref() else {
            return Ok(());
        };
        let opened = std::fs::OpenOptions::new().create(true).append(true).open(file);
        opened.map(drop).map_err(|e| Error::file(file, e))
    }

    /// Writes the whole outcome where `--values` asks for it.
    fn record(&self, headline: &Headline) -> Result<()> {
        let Some(file) = self.values.as_deref() else {
            return Ok(());
        };
        std::fs::write(file, headline.json()).map_err(|e| Error::file(file, e))
    }
}

/// Options of an example that carry an [`Output`].
pub trait HasOutput {
    /// The output options.
    fn output(&self) -> &Output;
}

/// Parses the command line, runs the example and prints its headline.
pub fn main<O: Parser + HasOutput>(run: impl FnOnce(&O) -> Result<Headline>) -> ExitCode {
    let options = match parse::<O>() {
        Ok(options) => options,
        Err(error) => return report_usage(&error),
    };
    let json = options.output().json;
    let outcome = options.output().check().and_then(|()| run(&options));
    match outcome.and_then(|headline| options.output().record(&headline).map(|()| headline)) {
        Ok(headline) => {
            let text = if json { headline.table.json_rows().join("\n") + "\n" } else { headline.to_string() };
            // A closed pipe (`| head`) is the reader's choice, not a failure.
            let _ = std::io::stdout().write_all(text.as_bytes());
            if headline.verdict.is_confirmed() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// The options of the command line; a value may be a negative number, so that `--nu -0.1` is answered by what it means.
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
