//! Checks, before any allocation, that the required memory does not exceed the physical memory.

use super::Error;
use std::sync::OnceLock;

/// Number of bytes up to which no check is made.
const SMALL: f64 = (1u64 << 28) as f64;

/// Memory that is assumed if the system does not report it.
const UNKNOWN: f64 = (8u64 << 30) as f64;

/// The physical memory in bytes: from `/proc/meminfo`, or 8 GiB on systems without it. It is read once.
pub(crate) fn physical() -> f64 {
    static BYTES: OnceLock<f64> = OnceLock::new();
    *BYTES.get_or_init(|| {
        let text = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
        total_of(&text).unwrap_or(UNKNOWN)
    })
}

/// The number of bytes in the line `MemTotal: 16314464 kB`.
fn total_of(text: &str) -> Option<f64> {
    let line = text.lines().find(|line| line.starts_with("MemTotal:"))?;
    Some(1024.0 * line.split_whitespace().nth(1)?.parse::<f64>().ok()?)
}

/// Returns an error if `count` items of `bytes` bytes each exceed the machine's memory.
///
/// # Errors
/// [`Error::TooLarge`] with this `name`.
pub(crate) fn require_memory(name: &'static str, count: usize, bytes: usize) -> Result<(), Error> {
    let needed = count as f64 * bytes as f64;
    if needed <= SMALL || needed <= physical() {
        return Ok(());
    }
    Err(Error::TooLarge { name, count, needed: needed / 1e9, available: physical() / 1e9 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_fit_is_refused_with_both_sizes() {
        assert!(require_memory("elements", 1000, 24).is_ok());
        let refused = require_memory("elements", usize::MAX, usize::MAX).unwrap_err();
        let Error::TooLarge { name: "elements", count: usize::MAX, needed, available } = refused else {
            panic!("{refused:?}");
        };
        assert!(needed > 1e20 && available > 0.1);
    }

    #[test]
    fn the_systems_line_is_read() {
        assert_eq!(total_of("MemFree: 1 kB\nMemTotal:       2048 kB\n"), Some(2048.0 * 1024.0));
        assert_eq!(total_of("MemTotal: much\n"), None);
    }
}
