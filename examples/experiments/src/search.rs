//! Searches in one variable: a sign change by halving, a minimum by golden sections.

/// (last point of the sign of the start, first of the other) around a change of `is_beyond` from false to
/// true in (low, high).
///
/// Halves until the bracket is at most `width` wide or holds no number between its ends.
pub(crate) fn sign_change(
    mut low: f64,
    mut high: f64,
    width: f64,
    mut is_beyond: impl FnMut(f64) -> bool,
) -> (f64, f64) {
    while high - low > width {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if is_beyond(middle) { high = middle } else { low = middle }
    }
    (low, high)
}

/// Where f is smallest on (low, high), to `width`: golden sections; f should have one minimum there.
pub(crate) fn golden_section(low: f64, high: f64, width: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    let (mut a, mut b) = (low, high);
    while b - a > width {
        let (c, d) = (b - ratio * (b - a), a + ratio * (b - a));
        if c >= d {
            break;
        }
        if f(c) < f(d) { b = d } else { a = c }
    }
    0.5 * (a + b)
}

/// The index k of the smallest f at low + k (high − low)/steps, 0 ≤ k ≤ steps, and its neighbours' places: a
/// bracket for
/// [`golden_section`] when k is inside.
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
    fn a_root_is_bracketed_to_the_last_digit() {
        let (low, high) = sign_change(0.0, 2.0, 0.0, |x| x * x >= 2.0);
        assert!(low * low < 2.0 && high * high >= 2.0 && high == low.next_up());
    }

    #[test]
    fn a_minimum_is_found_on_a_grid_and_then_closer() {
        let f = |x: f64| (x - 0.3).powi(2);
        let (k, (a, b)) = smallest_on_grid(0.0, 1.0, 8, f);
        assert_eq!((k, a, b), (2, 0.125, 0.375));
        assert!((golden_section(a, b, 1e-7, f) - 0.3).abs() < 1e-7);
    }
}
