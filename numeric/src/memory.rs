//! The size of the memory, by which counts that cannot be allocated are refused before any allocation.

use std::sync::OnceLock;

/// Number of bytes up to which no check is made.
const SMALL: f64 = (1u64 << 28) as f64;

/// Memory that is assumed if the system does not report it.
const UNKNOWN: f64 = (8u64 << 30) as f64;

/// The physical memory in bytes: from `/proc/meminfo`, or 8 GiB on systems without it. It is read once.
pub fn physical() -> f64 {
    static BYTES: OnceLock<f64> = OnceLock::new();
    *BYTES.get_or_init(|| {
        let text = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
        total_of(&text).unwrap_or(UNKNOWN)
    })
}

/// The bytes that `count` items of `bytes` bytes each take and the machine's memory, if they exceed it.
pub fn shortage(count: usize, bytes: usize) -> Option<(f64, f64)> {
    let needed = count as f64 * bytes as f64;
    (needed > SMALL && needed > physical()).then(|| (needed, physical()))
}

/// The number of bytes in the line `MemTotal: 16314464 kB`.
fn total_of(text: &str) -> Option<f64> {
    let line = text.lines().find(|line| line.starts_with("MemTotal:"))?;
    Some(1024.0 * line.split_whitespace().nth(1)?.parse::<f64>().ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_fit_is_known_with_both_sizes() {
        assert!(shortage(1000, 24).is_none());
        let (needed, available) = shortage(usize::MAX, usize::MAX).unwrap();
        assert!(needed > 1e38 && available > 1e8);
    }

    #[test]
    fn the_systems_line_is_read() {
        assert_eq!(total_of("MemFree: 1 kB\nMemTotal:       2048 kB\n"), Some(2048.0 * 1024.0));
        assert_eq!(total_of("MemTotal: much\n"), None);
    }
}
