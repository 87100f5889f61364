//! Where the outcome of an example goes, and what an example says of its options.

use crate::Result;
use crate::files::require_writable;
use clap::Args;
use signorini::Error as LibraryError;
use std::path::{Path, PathBuf};

/// How long a run takes at default size on two cores.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cost {
    /// Below a second, a third of it for a single value: a slider may move it.
    Quick,
    /// Some seconds.
    #[default]
    Seconds,
    /// More than ten seconds.
    Long,
}

impl Cost {
    pub(crate) fn word(self) -> &'static str {
        match self {
            Cost::Quick => "quick",
            Cost::Seconds => "seconds",
            Cost::Long => "long",
        }
    }
}

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
    pub(crate) fn check(&self) -> Result<()> {
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
