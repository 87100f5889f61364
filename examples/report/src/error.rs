//! The error type of the examples.

/// A result whose error type is [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// The error of an example that has no outcome: a one-line message and exit code 2.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// An error of the library.
    #[error(transparent)]
    Library(#[from] signorini::Error),
    /// An option that is invalid or incompatible with another one.
    #[error("{0}")]
    Option(String),
    /// A file that could not be read or written.
    #[error("{path}: {reason}")]
    File {
        /// The file.
        path: String,
        /// The message of the system.
        reason: String,
    },
}

impl Error {
    /// The error for the option `name`, with the reason `what`.
    pub fn option(name: &str, what: &str) -> Self {
        Self::Option(format!("--{}: {what}", name.replace('_', "-")))
    }

    /// Checks a condition on an option.
    ///
    /// # Errors
    /// [`Error::Option`] with the reason if the condition does not hold.
    pub fn unless(condition: bool, name: &str, what: &str) -> Result<()> {
        if condition { Ok(()) } else { Err(Self::option(name, what)) }
    }

    /// The error for a file, with the message of the system.
    pub fn file(path: &std::path::Path, reason: impl ToString) -> Self {
        Self::File { path: path.display().to_string(), reason: reason.to_string() }
    }
}

impl From<fractional_sobolev::Error> for Error {
    fn from(error: fractional_sobolev::Error) -> Self {
        Self::Library(error.into())
    }
}
