//! Where the parts of a book are.

use std::path::{Path, PathBuf};

/// Where the parts of a book are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layout {
    /// The repository; faults name files relative to it.
    pub repository: PathBuf,
    /// The book: `book.toml`, `src`, `generated`, `allowed-decimals.txt`.
    pub book: PathBuf,
}

impl Layout {
    /// The layout of a repository that keeps its book in `book`.
    pub fn of(repository: &Path) -> Self {
        Self { repository: repository.to_owned(), book: repository.join("book") }
    }

    /// Where the committed data of the examples is.
    pub fn generated(&self) -> PathBuf {
        self.book.join("generated")
    }

    /// Where what large runs computed is kept.
    pub fn large(&self) -> PathBuf {
        self.generated().join("large")
    }
}
