//! Legendre polynomials by their recurrence, (k+1) P_{k+1} = (2k+1) x P_k − k P_{k−1}, stable for |x| ≤ 1.

/// P_{k+1}(x) from P_k(x) and P_{k−1}(x); the latter is not used for k = 0.
#[inline]
pub(crate) fn next(k: usize, x: f64, current: f64, previous: f64) -> f64 {
    let k = k as f64;
    ((2.0 * k + 1.0) * x * current - k * previous) / (k + 1.0)
}

/// Fills `values` with P_0(x), P_1(x), ...
pub(crate) fn fill(values: &mut [f64], x: f64) {
    let (mut previous, mut current) = (0.0, 1.0);
    for (k, value) in values.iter_mut().enumerate() {
        *value = current;
        (previous, current) = (current, next(k, x, current, previous));
    }
}

/// The sum Σ c_k P_k(x).
pub(crate) fn series(coefficients: impl IntoIterator<Item = f64>, x: f64) -> f64 {
    let (mut previous, mut current, mut sum) = (0.0, 1.0, 0.0);
    for (k, c) in coefficients.into_iter().enumerate() {
        sum += c * current;
        (previous, current) = (current, next(k, x, current, previous));
    }
    sum
}

/// The sums (Σ c_k P_k(x), Σ c_k P_k'(x)), by P'\_{k+1} = (2k+1) P_k + P'\_{k−1}.
pub(crate) fn series_with_slope(coefficients: impl IntoIterator<Item = f64>, x: f64) -> (f64, f64) {
    let (mut previous, mut current) = (0.0, 1.0);
    let (mut previous_slope, mut slope) = (0.0, 0.0);
    let (mut sum, mut derivative) = (0.0, 0.0);
    for (k, c) in coefficients.into_iter().enumerate() {
        sum += c * current;
        derivative += c * slope;
        let next_slope = (2 * k + 1) as f64 * current + previous_slope;
        (previous_slope, slope) = (slope, next_slope);
        (previous, current) = (current, next(k, x, current, previous));
    }
    (sum, derivative)
}

/// Fills the slices with P_k(a) and (P_k(b) − P_k(a))/(b − a), from the recurrence itself and so without
/// cancellation: (k+1) Q_{k+1} = (2k+1)(b Q_k + P_k(a)) − k Q_{k−1}.
pub(crate) fn fill_with_quotients(values: &mut [f64], quotients: &mut [f64], a: f64, b: f64) {
    let (mut previous, mut quotient) = (0.0, 0.0);
    let (mut before, mut current) = (0.0, 1.0);
    for (k, (value, place)) in values.iter_mut().zip(quotients).enumerate() {
        (*value, *place) = (current, quotient);
        let n = k as f64;
        let following = ((2.0 * n + 1.0) * (b * quotient + current) - n * previous) / (n + 1.0);
        (previous, quotient) = (quotient, following);
        (before, current) = (current, next(k, a, current, before));
    }
}
