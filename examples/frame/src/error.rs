//! What an example may fail with: the library's error (files among them), a figure, or options that do not
//! fit.

/// Result with the frame's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Why an example has no outcome.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The library refused the question.
    #[error(transparent)]
    Library(#[from] signorini::Error),
    /// A figure could not be drawn.
    #[error("figure: {reason}")]
    Figure {
        /// What went wrong.
        reason: String,
    },
    /// An option that does not fit, alone or together with another.
    #[error("{0}")]
    Option(String),
}

impl From<fractional_sobolev::Error> for Error {
    fn from(error: fractional_sobolev::Error) -> Self {
        Self::Library(error.into())
    }
}
