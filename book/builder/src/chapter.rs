//! A chapter of the book.

use std::path::PathBuf;

/// A chapter as written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Page {
    /// File, as a reader of the repository names it.
    pub file: PathBuf,
    /// Name of the built page, `x.html`.
    pub html: String,
    /// Markdown with formulas and directives.
    pub text: String,
}
