//! The smallest of the values on a grid.

/// The index k of the smallest f at low + k (high − low)/steps, 0 ≤ k ≤ steps, and its neighbours' places: a bracket
/// for [`golden_section`](super::search::golden_section) when k is inside.
pub(crate) fn smallest_on_grid(
    low: f64,
    high: f64,
    steps: usize,
    mut f: impl FnMut(f64) -> f64,
) -> (usize, (f64, f64)) {
    let at = |k: usize| low + (high - low) * k as f64 / steps as f64;
    let mut best = (0, f64::INFINITY);
    for k in 0..=steps {
        let value = f(at(k));
        if value < best.1 {
            best = (k, value);
        }
    }
    (best.0, (at(best.0.saturating_sub(1)), at((best.0 + 1).min(steps))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_minimum_is_found_on_a_grid_with_its_neighbours() {
        let (k, (a, b)) = smallest_on_grid(0.0, 1.0, 8, |x: f64| (x - 0.3).abs());
        assert_eq!((k, a, b), (2, 0.125, 0.375));
    }
}
