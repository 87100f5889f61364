//! A minimum in one variable by golden sections.

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
