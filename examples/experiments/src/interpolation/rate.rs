//! The exponent of h that a sequence of errors shows, and how far it may be off.

use fractional_sobolev::Estimate;
use fractional_sobolev::{Error, Result};
use std::f64::consts::LN_2;

/// A rate whose own error falls by two ninths or more from one pair of meshes to the next is off by at most
/// three and a half times its last change: beside the leading term one with another factor h^{1/2} and no
/// larger a coefficient, or h^{3/4} and twice the coefficient, from eight elements on.
const CHANGES: f64 = 3.5;

/// The exponents of h = 1/N between each mesh and the one before it; none for the first.
///
/// Meshes are given with their numbers of elements, coarsest first. The error of an exponent is 3.5 times
/// its change from the one before, and what the errors of the norms leave; of the first exponent nothing else
/// is known, and its error is the exponent itself.
///
/// # Errors
/// [`Error::CountOutOfRange`] unless the numbers of elements rise; [`Error::NotFinite`] for errors that
/// vanish.
pub fn observed_rates(meshes: &[(usize, Estimate)]) -> Result<Vec<Option<Estimate>>> {
    let mut rates: Vec<Option<Estimate>> = vec![None; meshes.len().min(1)];
    for pair in meshes.windows(2) {
        let [(coarse, before), (fine, after)] = [pair[0], pair[1]];
        if coarse == 0 || coarse >= fine {
            return Err(Error::CountOutOfRange { name: "elements", value: fine, range: "rising, >= 1" });
        }
        let halvings = (fine as f64 / coarse as f64).log2();
        let rate = (before.value / after.value).log2() / halvings;
        let noise = (before.relative_error() + after.relative_error()) / LN_2 / halvings;
        let last = rates.last().copied().flatten();
        let change = last.map_or(rate.abs(), |last| CHANGES * (rate - last.value).abs());
        rates.push(Some(Estimate::new(rate, change + noise, before.work + after.work)?));
    }
    Ok(rates)
}

/// The exponent between the last two of three meshes.
///
/// ```
/// use experiments::interpolation::{observed_rate, observed_rates};
/// use fractional_sobolev::{Estimate};
/// let norm = |n: usize| Estimate::new((n as f64).powi(-2), 1e-12, Default::default());
/// let meshes = [(8, norm(8)?), (16, norm(16)?), (32, norm(32)?)];
/// assert!((observed_rate(meshes)?.value - 2.0).abs() < 1e-6);
/// assert_eq!(observed_rates(&meshes)?.len(), 3);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`observed_rates`].
#[doc(alias("convergence rate", "order of convergence", "EOC"))]
pub fn observed_rate(meshes: [(usize, Estimate); 3]) -> Result<Estimate> {
    let none = Error::CountOutOfRange { name: "meshes", value: 0, range: "3" };
    observed_rates(&meshes)?.last().copied().flatten().ok_or(none)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fractional_sobolev::Work;

    #[test]
    fn the_rate_of_a_slow_sequence_is_not_claimed_to_be_better_known_than_it_is() {
        let cases =
            [0.5, 0.75, 1.0, 2.0].into_iter().flat_map(|c| [0.5, 0.75, 1.0, 2.0].map(|tail| (c, tail)));
        // 2 h^{1/2} falls by less than assumed at N = 8.
        for (c, tail) in cases.filter(|&case| case != (2.0, 0.5)) {
            let error = |n: usize| {
                let h = 1.0 / n as f64;
                (n, Estimate::new(h.powf(0.7) * (1.0 + c * h.powf(tail)), 0.0, Work::default()).unwrap())
            };
            for n in [8, 64, 512] {
                let rate = observed_rate([error(n), error(2 * n), error(4 * n)]).unwrap();
                assert!((rate.value - 0.7).abs() <= rate.error, "{c} h^{tail} N {n}: {rate}");
            }
            assert!(observed_rate([error(8), error(8), error(16)]).is_err());
            let first = observed_rates(&[error(8), error(16)]).unwrap();
            assert!(first[0].is_none() && first[1].unwrap().relative_error() >= 1.0, "{first:?}");
        }
    }
}
