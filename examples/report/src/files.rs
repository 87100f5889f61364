//! Atomic writing of files: under another name in the same directory, then renamed; devices and
//! pipes directly.

use crate::{Error, Result};
use std::path::{Path, PathBuf};

/// Writes the file; a device or a pipe is written to directly.
///
/// # Errors
/// [`Error::File`] with the message of the system; nothing is left behind.
pub(crate) fn write_whole(path: &Path, text: &str) -> Result<()> {
    let failed = |error: std::io::Error| Error::file(path, error);
    if path.exists() && !path.is_file() {
        return std::fs::write(path, text).map_err(failed);
    }
    let part = part_of(path);
    std::fs::write(&part, text).and_then(|()| std::fs::rename(&part, path)).map_err(|error| {
        let _ = std::fs::remove_file(&part);
        failed(error)
    })
}

/// Checks, before the computation, that a file can be written.
///
/// # Errors
/// [`Error::File`] with the message of the system.
pub(crate) fn require_writable(path: &Path) -> Result<()> {
    let failed = |error: std::io::Error| Error::file(path, error);
    if path.exists() {
        return std::fs::OpenOptions::new().append(true).open(path).map(drop).map_err(failed);
    }
    let part = part_of(path);
    std::fs::write(&part, "").and_then(|()| std::fs::remove_file(&part)).map_err(failed)
}

/// Beside the file, under a name that no other process takes.
fn part_of(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}.part", std::process::id()))
}
