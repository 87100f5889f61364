//! What can go wrong: faults in the book (file, line, offending text), and failures around it.

use std::fmt;
use std::path::{Path, PathBuf};

/// Something wrong in a source of the book, where, and the text that is wrong.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fault {
    /// The file, as a reader of the repository names it.
    pub file: PathBuf,
    /// The line, from 1.
    pub line: usize,
    /// What is wrong.
    pub what: String,
    /// The offending text.
    pub text: String,
}

impl Fault {
    /// A fault at a line of a file.
    pub fn new(file: &Path, line: usize, what: impl Into<String>, text: impl Into<String>) -> Self {
        Self { file: file.to_owned(), line, what: what.into(), text: text.into() }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.text.trim().replace('\n', " ");
        write!(f, "{}:{}: {}: `{text}`", self.file.display(), self.line, self.what)
    }
}

/// Why a book could not be built or checked.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The sources of the book are at fault; every fault found is listed.
    #[error("{}", list(.0))]
    Faults(Vec<Fault>),
    /// A file could not be read or written.
    #[error("{}: {source}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A JSON file of generated data could not be read.
    #[error("{}: {message}", .path.display())]
    Data {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        message: String,
    },
    /// A JSON file of generated data is none.
    #[error("{}:{line}: damaged: {message}", .path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        message: String,
    },
    /// An example could not be built or did not run.
    #[error("example {name}: {message}")]
    Example {
        /// The example, or `cargo build`.
        name: String,
        /// What it said.
        message: String,
    },
    /// The book could not be served.
    #[error("port {port}: {source}")]
    Server {
        /// The port asked for.
        port: u16,
        /// What the system said.
        source: std::io::Error,
    },
    /// mdBook refused the book.
    #[error("mdbook: {0}")]
    Mdbook(String),
}

fn list(faults: &[Fault]) -> String {
    faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

/// The result of everything here.
pub type Result<T> = std::result::Result<T, Error>;

/// Fails with the faults in the order of files and lines, unless there are none.
///
/// # Errors
/// [`Error::Faults`].
pub fn none_of(mut faults: Vec<Fault>) -> Result<()> {
    faults.sort();
    faults.dedup();
    if faults.is_empty() { Ok(()) } else { Err(Error::Faults(faults)) }
}

/// Reads a text file.
pub(crate) fn read(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).map_err(|source| Error::File { path: path.to_owned(), source })
}

/// Writes a file, making its directory.
pub(crate) fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<()> {
    let directory = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(directory)
        .and_then(|()| std::fs::write(path, content))
        .map_err(|source| Error::File { path: path.to_owned(), source })
}
