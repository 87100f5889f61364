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
