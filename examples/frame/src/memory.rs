//! Physical memory of the machine.

use std::sync::OnceLock;

/// Memory of a machine that does not say how much it has.
const UNKNOWN: f64 = (8u64 << 30) as f64;

/// Bytes of physical memory: what `/proc/meminfo` says, 8 GiB on systems without it. Read once.
pub(crate) fn physical() -> f64 {
    static BYTES: OnceLock<f64> = OnceLock::new();
    *BYTES.get_or_init(|| {
        let text = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
        total_of(&text).unwrap_or(UNKNOWN)
    })
}

/// The line `MemTotal: 16314464 kB`.
fn total_of(text: &str) -> Option<f64> {
    let line = text.lines().find(|line| line.starts_with("MemTotal:"))?;
    Some(1024.0 * line.split_whitespace().nth(1)?.parse::<f64>().ok()?)
}
