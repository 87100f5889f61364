//! Text input files: reading with a size limit, and quotation in error messages that are one short line for
//! any content.

use crate::error::{Error, Result};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Largest file size: 2^30 bytes. Endless devices are rejected at this limit.
const LONGEST: u64 = 1 << 30;
/// Largest number of characters quoted.
const QUOTED: usize = 40;

/// The bytes of a file.
///
/// # Errors
/// [`Error::File`] with the message of the operating system, or for more than 2^30 bytes.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>> {
    let failed = |error: std::io::Error| Error::file(path, error);
    let mut bytes = Vec::new();
    File::open(path).map_err(failed)?.take(LONGEST + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > LONGEST {
        return Err(Error::file(path, "the file has more than 2^30 bytes"));
    }
    Ok(bytes)
}

/// The text of a file; bytes that are not UTF-8 become U+FFFD, so that the parser reports their line.
///
/// # Errors
/// As for [`read_bytes`].
pub(crate) fn read_text(path: &Path) -> Result<String> {
    Ok(match String::from_utf8(read_bytes(path)?) {
        Ok(text) => text,
        Err(error) => String::from_utf8_lossy(error.as_bytes()).into_owned(),
    })
}

/// The pairs of finite numbers in a text, one pair per line, with their line numbers from 1. Numbers are separated
/// by blanks or commas; `#` begins a comment, empty lines are skipped.
///
/// # Errors
/// [`Error::Syntax`] with the first line that does not contain a pair.
pub(crate) fn pairs(text: &str, format: &'static str) -> Result<Vec<(usize, [f64; 2])>> {
    let mut pairs = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let content = line.split('#').next().unwrap_or("");
        let mut words =
            content.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty());
        let fault = |what: &str| Error::Syntax {
            format,
            line: index + 1,
            reason: format!("expected two numbers, found {}{what}", quoted(content.trim())),
        };
        let number = |word: &str| word.parse::<f64>().map_err(|_| fault(""));
        let pair = match [words.next(), words.next(), words.next()] {
            [None, ..] => continue,
            [Some(first), Some(second), None] => [number(first)?, number(second)?],
            _ => return Err(fault("")),
        };
        if !pair.iter().all(|value| value.is_finite()) {
            return Err(fault(", which is not finite"));
        }
        pairs.push((index + 1, pair));
    }
    Ok(pairs)
}

/// The beginning of a word between quotation marks, without control characters.
pub(crate) fn quoted(word: &str) -> String {
    let more = if word.chars().nth(QUOTED).is_some() { "..." } else { "" };
    let shown: String = word.chars().take(QUOTED).flat_map(char::escape_debug).collect();
    format!("'{shown}{more}'")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_read_and_any_other_line_is_named() {
        let read = pairs("# x, u\r\n0 1\r\n\n 0.5,2 # middle\r\n", "samples").unwrap();
        assert_eq!(read, [(2, [0.0, 1.0]), (4, [0.5, 2.0])]);
        for bad in ["0", "0 1 2", "0 x", "0 nan", "0 1 x", "0 inf", "\u{fffd} 1"] {
            let refused = pairs(&format!("0 0\n{bad}\n"), "samples");
            assert!(matches!(refused, Err(Error::Syntax { line: 2, .. })), "{bad}: {refused:?}");
        }
    }

    #[test]
    fn what_is_quoted_is_short_and_plain() {
        assert_eq!(quoted("a\u{1b}[2J\n"), r"'a\u{1b}[2J\n'");
        assert_eq!(quoted(&"x".repeat(1 << 20)).len(), QUOTED + 5);
    }

    #[test]
    fn directories_and_devices_without_end_are_refused() {
        assert!(matches!(read_text(&std::env::temp_dir()), Err(Error::File { .. })));
        let endless = Path::new("/dev/zero");
        if endless.exists() {
            assert!(matches!(read_text(endless), Err(Error::File { .. })));
        }
    }
}
