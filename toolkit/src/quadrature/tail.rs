//! Limits of partial integrals S_k = ∫₀^{t_k} ℓ(t) dt of an integrand that decays slowly.
//!
//! - Levin & Sidi's D-transform (Appl. Math. Comput. 9 (1981) 175-215): S_k = S + t_k ℓ(t_k) (c_0 + c_1/t_k +
//!   ...), exact in the limit for algebraic decay t^{-p} with corrections in 1/t, and for a single exponential.
//! - Wynn's ε-algorithm (MTAC 10 (1956) 91-96): exact for sums of exponentials; it is applied to the equally
//!   spaced values at the end of the sequence.
//!
//! Each gives a sequence of approximate limits, whose error is estimated by two consecutive changes and by
//! the amplified rounding of the S_k; the limit with the smallest estimate is returned. Cost O(m) for m
//! values, at most 16 of which enter a table.

/// A limit and its estimated absolute error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Limit {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// Highest order of the D-transform; beyond it the weights amplify rounding faster than they cancel terms.
const MAX_LEVIN_ORDER: usize = 11;

/// Ratio of neighbouring t_k in the D-transform.
const SPACING: f64 = 0.75;

/// The limit of S_k at increasing t_k > 0 with integrand values ℓ(t_k) > 0, where each S_k has the absolute
/// error `noise`.
///
/// `None` for fewer than 5 values.
pub(crate) fn extrapolate(
    t: &[f64],
    partial: &[f64],
    density: &[f64],
    noise: f64,
) -> Option<Limit> {
    if partial.len() < 5 {
        return None;
    }
    let last = partial[partial.len() - 1];
    let previous = partial[partial.len() - 2];
    if last == previous {
        return Some(Limit { value: last, error: noise });
    }
    let candidates = [levin(t, partial, density, noise), wynn(&equidistant(t, partial), noise)];
    candidates
        .into_iter()
        .flatten()
        .filter(|limit| limit.value.is_finite() && limit.error.is_finite())
        .min_by(|a, b| a.error.total_cmp(&b.error))
}

/// The last values of the sequence with equal spacing, at most 16.
fn equidistant(t: &[f64], partial: &[f64]) -> Vec<f64> {
    let last = t.len() - 1;
    let step = t[last] - t[last - 1];
    let steps =
        (1..=last).rev().take_while(|&k| (t[k] - t[k - 1] - step).abs() < 1e-6 * step).count();
    let stride = steps.div_ceil(15).max(1);
    let mut chosen: Vec<f64> = (0..=steps / stride).map(|k| partial[last - k * stride]).collect();
    chosen.reverse();
    chosen
}

/// Transforms of increasing order at points t_k that decrease geometrically from the last one, which limits the
/// amplification of rounding errors.
fn levin(t: &[f64], partial: &[f64], density: &[f64], noise: f64) -> Option<Limit> {
    let mut chosen = vec![t.len() - 1];
    while chosen.len() <= MAX_LEVIN_ORDER {
        let last = chosen[chosen.len() - 1];
        let Some(next) = (0..last).rev().find(|&k| t[k] <= SPACING * t[last]) else {
            break;
        };
        chosen.push(next);
    }
    let pick = |values: &[f64]| -> Vec<f64> { chosen.iter().map(|&k| values[k]).collect() };
    let (t, partial, density) = (pick(t), pick(partial), pick(density));
    let mut limits: Vec<Limit> = Vec::new();
    for order in 1..t.len() {
        limits.push(transform(&t[..=order], &partial[..=order], &density[..=order], noise)?);
    }
    best_settled(&limits)
}

/// The transform through all given values: a quotient of divided differences in 1/t.
fn transform(t: &[f64], partial: &[f64], density: &[f64], noise: f64) -> Option<Limit> {
    let (end, base) = (t[0], partial[0]);
    let (mut numerator, mut denominator, mut absolute) = (0.0, 0.0, 0.0);
    for (j, &tj) in t.iter().enumerate() {
        if density[j] == 0.0 {
            return None;
        }
        // 1 / Π_{i≠j} (1/t_j − 1/t_i), in units of the last t
        let product: f64 = t
            .iter()
            .enumerate()
            .filter(|&(i, _)| i != j)
            .map(|(_, &ti)| end / tj - end / ti)
            .product();
        let weight = 1.0 / (product * tj * density[j]);
        numerator += weight * (partial[j] - base);
        denominator += weight;
        absolute += weight.abs();
    }
    let rest = numerator / denominator;
    // The weights carry the relative rounding of ℓ, some 1e-15; it moves the rest, amplified likewise.
    let amplification = absolute / denominator.abs();
    let error = amplification * (noise + 4e-15 * rest.abs());
    Some(Limit { value: base + rest, error })
}

/// The even columns of the ε-table along the last counter-diagonal.
fn wynn(partial: &[f64], noise: f64) -> Option<Limit> {
    let mut before = vec![0.0; partial.len() + 1];
    let mut current = partial.to_vec();
    let mut limits = Vec::new();
    let mut column = 0;
    while current.len() > 1 {
        let mut next = Vec::with_capacity(current.len() - 1);
        for j in 0..current.len() - 1 {
            let difference = current[j + 1] - current[j];
            if difference == 0.0 {
                return best_settled(&limits);
            }
            next.push(before[j + 1] + 1.0 / difference);
        }
        before = current;
        current = next;
        column += 1;
        if column % 2 == 0 {
            let value = current[current.len() - 1];
            let last = partial[partial.len() - 1];
            let first = (last - partial[partial.len() - 2]).abs();
            // Noise of the differences, amplified as in Aitken's formula.
            let amplification = 1.0 + (value - last).abs() / first;
            let error = noise * amplification * amplification;
            limits.push(Limit { value, error });
        }
    }
    best_settled(&limits)
}

/// The limit at which the changes are smallest; its error is twice the last change, or twice 0.3 of the
/// previous change if that is larger, plus rounding.
fn best_settled(limits: &[Limit]) -> Option<Limit> {
    limits
        .windows(3)
        .map(|w| {
            let (before, after) =
                ((w[1].value - w[0].value).abs(), (w[2].value - w[1].value).abs());
            Limit { value: w[2].value, error: 2.0 * after.max(0.3 * before) + w[2].error }
        })
        .filter(|limit| limit.error.is_finite())
        .min_by(|a, b| a.error.total_cmp(&b.error))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(
        integral: impl Fn(f64) -> f64,
        density: impl Fn(f64) -> f64,
        limit: f64,
        required: f64,
    ) {
        let t: Vec<f64> = (1..=15).map(|k| 45.0 * f64::from(k)).collect();
        let partial: Vec<f64> = t.iter().map(|&t| integral(t)).collect();
        let density: Vec<f64> = t.iter().map(|&t| density(t)).collect();
        let found = extrapolate(&t, &partial, &density, 1e-15 * limit).unwrap();
        let error = (found.value - limit).abs();
        assert!(error <= required * limit, "{found:?} against {limit}: {error:e}");
        assert!(error <= found.error, "{found:?} against {limit}: {error:e}");
    }

    #[test]
    fn slow_decay_is_summed() {
        // ∫₀^t e^{-βs} ds, and two exponentials
        let integral = |b: f64| move |t: f64| -(-b * t).exp_m1() / b;
        check(integral(0.002), |t| (-0.002 * t).exp(), 500.0, 1e-11);
        check(
            |t| integral(0.003)(t) + integral(0.01)(t),
            |t| (-0.003 * t).exp() + (-0.01 * t).exp(),
            1.0 / 0.003 + 100.0,
            1e-8,
        );
        // ∫₀^t (1+s)^{-p} ds
        for p in [1.2, 1.5, 2.0] {
            let integral = |t: f64| (1.0 - (1.0 + t).powf(1.0 - p)) / (p - 1.0);
            check(integral, |t| (1.0 + t).powf(-p), 1.0 / (p - 1.0), 1e-11);
        }
    }
}
