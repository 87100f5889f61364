//! Legendre polynomials by their recurrence, (k+1) P_{k+1} = (2k+1) x P_k − k P_{k−1}, stable for |x| ≤ 1.

/// P_{k+1}(x) from P_k(x) and P_{k−1}(x); the latter does not matter for k = 0.
#[inline]
pub(crate) fn next(k: usize, x: f64, current: f64, previous: f64) -> f64 {
    let k = k as f64;
    ((2.0 * k + 1.0) * x * current - k * previous) / (k + 1.0)
}

/// P_0(x), P_1(x), ... into all places of `values`.
pub(crate) fn fill(values: &mut [f64], x: f64) {
    let (mut previous, mut current) = (0.0, 1.0);
    for (k, value) in values.iter_mut().enumerate() {
        *value = current;
        (previous, current) = (current, next(k, x, current, previous));
    }
}
