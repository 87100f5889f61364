//! Files are written whole or not at all: under another name in the same directory, then renamed, so that an
//! interrupted run leaves what was there before.

use crate::{Error, Result};
use std::path::{Path, PathBuf};

/// Writes the file; what is there and is no plain file (a device, a pipe) is written to as it stands.
///
/// # Errors
/// [`Error::File`] with what the system said; nothing is left behind.
pub(crate) fn write_whole(path: &Path, text: &str) -> Result<()> {
    let failed = |error: std::io::Error| Error::file(path, error);
    if path.exists() && !path.is_file() {
        return std::fs::write(path, text).map_err(failed);
    }
    let part = part_of(path);
    std::fs::write(&part, text).and_then(|()| std::fs::rename(&part, path)).map_err(|error| {
        // What the system said about the file matters, not that its part was never made.
        let _ = std::fs::remove_file(&part);
        failed(error)
    })
}

/// Finds a place that cannot be written before the work, not after it.
///
/// # Errors
/// [`Error::File`] with what the system said.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_a_failure_leaves_the_old_one() {
        let directory = std::env::temp_dir().join(format!("signorini-files-{}", std::process::id()));
        std::fs::create_dir_all(directory.join("inner")).unwrap();
        let path = directory.join("values.json");
        write_whole(&path, "old").unwrap();
        write_whole(&path, "new").unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "new");
        assert!(write_whole(&directory.join("inner"), "x").is_err());
        assert!(write_whole(&directory.join("none/values.json"), "x").is_err());
        assert!(require_writable(&directory).is_err());
        assert!(require_writable(&directory.join("none/values.json")).is_err());
        require_writable(&directory.join("later.json")).unwrap();
        let left: Vec<_> = std::fs::read_dir(&directory).unwrap().map(|e| e.unwrap().file_name()).collect();
        assert_eq!(left.len(), 2, "{left:?}");
        if Path::new("/dev/full").exists() {
            assert!(write_whole(Path::new("/dev/full"), "x").is_err());
        }
        std::fs::remove_dir_all(&directory).unwrap();
    }
}
