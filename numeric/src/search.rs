//! Searches in one variable: a sign change by bisection, a minimum by golden-section search.

/// The last point before and the first point after a change of `is_beyond` from false to true in (low, high).
///
/// The interval is bisected until it is at most `width` wide or contains no further number.
pub fn sign_change(
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

/// The minimum point of f on (low, high), accurate to `width`, by golden-section search; f should have a single
/// local minimum there.
pub fn golden_section(low: f64, high: f64, width: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_bracketed_to_the_last_digit() {
        let (low, high) = sign_change(0.0, 2.0, 0.0, |x| x * x >= 2.0);
        assert!(low * low < 2.0 && high * high >= 2.0 && high == low.next_up());
    }

    #[test]
    fn a_minimum_is_found() {
        let f = |x: f64| (x - 0.3).powi(2);
        assert!((golden_section(0.125, 0.375, 1e-7, f) - 0.3).abs() < 1e-7);
    }
}
