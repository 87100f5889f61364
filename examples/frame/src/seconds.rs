//! How long a computation takes.

use std::time::Instant;

/// Seconds for which short computations are repeated.
const SETTLED: f64 = 0.05;

/// Seconds and what was found: the least of the runs that begin within a twentieth of a second, at least one,
/// as a single run below a millisecond is mostly noise.
///
/// # Errors
/// Those of the computation.
pub fn timed<T, E>(of: impl Fn() -> Result<T, E>) -> Result<(f64, T), E> {
    let (start, mut least) = (Instant::now(), f64::INFINITY);
    loop {
        let before = start.elapsed().as_secs_f64();
        let found = of()?;
        let after = start.elapsed().as_secs_f64();
        least = least.min(after - before);
        if after > SETTLED {
            return Ok((least, found));
        }
    }
}
