//! Why an example has no outcome.

/// Result with the report's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Why an example has no outcome: exit code 2, one line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The library refused the question.
    #[error(transparent)]
    Library(#[from] signorini::Error),
    /// A picture could not be drawn.
    #[error("picture: {reason}")]
    Figure {
        /// What went wrong.
        reason: String,
    },
    /// An option that does not fit, alone or together with another.
    #[error("{0}")]
    Option(String),
    /// A file that could not be read or written.
    #[error("{path}: {reason}")]
    File {
        /// The file.
        path: String,
        /// What the system said.
        reason: String,
    },
}

impl Error {
    /// An option with what is wrong with it.
    pub fn option(name: &str, what: &str) -> Self {
        Self::Option(format!("--{}: {what}", name.replace('_', "-")))
    }

    /// Nothing where the condition holds.
    ///
    /// # Errors
    /// The option with what is wrong with it.
    pub fn unless(condition: bool, name: &str, what: &str) -> Result<()> {
        if condition { Ok(()) } else { Err(Self::option(name, what)) }
    }

    /// A file with what the system said.
    pub fn file(path: &std::path::Path, reason: impl ToString) -> Self {
        Self::File { path: path.display().to_string(), reason: reason.to_string() }
    }
}

impl From<fractional_sobolev::Error> for Error {
    fn from(error: fractional_sobolev::Error) -> Self {
        Self::Library(error.into())
    }
}
