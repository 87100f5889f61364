//! The remainder of an integral along a side, from a few values of ℓ beyond the last cell.
//!
//! Where ln ℓ is concave, as for t^p e^{−wt}, p ≥ 0, the integrals over cells decrease faster than
//! geometrically, and the remainder of a geometric series is too large. Where ln ℓ is convex, as for sums
//! of such laws with different w (a slow power hidden by a fast one) or p < 0, it is too small; but then ln
//! ℓ lies below its chords, and
//!
//! ∫ ℓ ≤ Σ (t_{k+1} − t_k) (ℓ_k − ℓ_{k+1}) / ln(ℓ_k/ℓ_{k+1}),
//!
//! for every choice of the t_k, with equality for one exponential. The true remainder lies between zero and
//! the larger of the two. Beyond the last t the last chord is continued: at the end of a side ℓ is
//! negligible or follows its asymptotic law.

use super::level::Density;
use crate::error::{Error, Result};

/// Positions of the values of ℓ beyond the end, denser at the beginning.
const CHORDS: usize = 10;
/// Values of ℓ below this many times their rounding are ignored.
const NOISE: f64 = 4.0;

/// ∫ ℓ beyond `from` by chords of ln ℓ; |ℓ| = `first` there, and values are computed up to `end`.
///
/// Sampling stops at a depth where the function has no value, or where the value is dominated by rounding.
pub(super) fn rest_by_chords(
    from: f64,
    first: f64,
    end: f64,
    mut density: impl FnMut(f64) -> Result<Density>,
) -> Result<f64> {
    let (mut t, mut value, mut sum, mut rate) = (from, first.abs(), 0.0, f64::INFINITY);
    for k in 1..=CHORDS {
        let next = from + (end - from) * (k as f64 / CHORDS as f64).powi(2);
        if next <= t {
            continue;
        }
        let there = match density(next) {
            Ok(there) if there.value.abs() > NOISE * there.rounding => there.value.abs(),
            Ok(there) if there.value == 0.0 => f64::MIN_POSITIVE,
            Ok(_) => break,
            Err(error @ Error::ToleranceNotMet { .. }) => return Err(error),
            Err(_) => break,
        };
        value = value.max(f64::MIN_POSITIVE);
        rate = (value / there).ln() / (next - t);
        sum += chord(next - t, value, there);
        if there <= f64::MIN_POSITIVE {
            return Ok(sum);
        }
        (t, value) = (next, there);
    }
    // A rate that grows, or stands still, leaves the integral to those who judge whether it is finite.
    Ok(if rate > 0.0 { sum + value / rate } else { f64::INFINITY })
}

/// The same from samples (t, ℓ) on all scales, those beyond `from`, up to the last one.
pub(super) fn rest_through(from: f64, first: f64, samples: &[(f64, f64)]) -> f64 {
    let (mut t, mut value, mut sum) = (from, first.abs().max(f64::MIN_POSITIVE), 0.0);
    for &(next, there) in samples.iter().filter(|(next, _)| *next > from) {
        let there = there.abs().max(f64::MIN_POSITIVE);
        sum += chord(next - t, value, there);
        (t, value) = (next, there);
    }
    sum
}

/// The integral of the exponential with these values at the ends of an interval.
fn chord(width: f64, value: f64, there: f64) -> f64 {
    let fall = (value / there).ln();
    if fall.abs() < 1e-6 { width * value.max(there) } else { width * (value - there) / fall }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_of_exponentials_are_bounded_and_one_is_found() {
        let of = |value: f64| Ok(Density { value, rounding: 1e-16 * value });
        let one = rest_by_chords(7.0, (-7.0f64).exp(), 45.0, |t| of((-t).exp())).unwrap();
        assert!((one / (-7.0f64).exp() - 1.0).abs() < 1e-12);
        let law = |t: f64| (-3.0 * t).exp() + 1e-6 * (-0.4 * t).exp();
        let exact = (-21.0f64).exp() / 3.0 + 1e-6 * (-2.8f64).exp() / 0.4;
        let found = rest_by_chords(7.0, law(7.0), 45.0, |t| of(law(t))).unwrap();
        assert!(exact <= found && found < 1.5 * exact, "{found:e} {exact:e}");
        assert_eq!(rest_by_chords(7.0, 1.0, 45.0, |_| of(1.5)).unwrap(), f64::INFINITY);
        assert!(rest_by_chords(7.0, 0.0, 45.0, |_| of(0.0)).unwrap() < 1e-290);
    }
}
