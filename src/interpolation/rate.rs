//! The exponent of h that a sequence of errors shows, and how far it may be off.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use std::f64::consts::LN_2;

/// A rate whose own error falls by a quarter or more from one pair of meshes to the next is off by at most
/// three times its last change.
const CHANGES: f64 = 3.0;

/// The exponent of h = 1/N between the last two of three meshes, given with their numbers of elements,
/// coarsest first.
///
/// Its error: three times the change from the exponent between the first two, and what the errors of
/// the norms leave.
///
/// # Errors
/// [`Error::CountOutOfRange`] unless the numbers of elements rise; [`Error::NotFinite`] for errors that
/// vanish.
pub fn observed_rate(meshes: [(usize, Estimate); 3]) -> Result<Estimate> {
    if let Some(pair) = meshes.windows(2).find(|pair| pair[0].0 == 0 || pair[0].0 >= pair[1].0) {
        return Err(Error::CountOutOfRange { name: "elements", value: pair[1].0, range: "rising, >= 1" });
    }
    let step = |coarse: (usize, Estimate), fine: (usize, Estimate)| {
        let ratio = (fine.0 as f64 / coarse.0 as f64).log2();
        let noise = (coarse.1.relative_error() + fine.1.relative_error()) / LN_2 / ratio;
        ((coarse.1.value / fine.1.value).log2() / ratio, noise)
    };
    let (before, _) = step(meshes[0], meshes[1]);
    let (rate, noise) = step(meshes[1], meshes[2]);
    let work = meshes.iter().fold(Work::default(), |work, mesh| work + mesh.1.work);
    Estimate::new(rate, CHANGES * (rate - before).abs() + noise, work)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rate_of_a_slow_sequence_is_not_claimed_to_be_better_known_than_it_is() {
        for tail in [0.5, 1.0, 2.0] {
            let error = |n: usize| {
                let h = 1.0 / n as f64;
                (n, Estimate::new(h.powf(0.7) * (1.0 + h.powf(tail)), 0.0, Work::default()).unwrap())
            };
            for n in [8, 64, 512] {
                let rate = observed_rate([error(n), error(2 * n), error(4 * n)]).unwrap();
                assert!((rate.value - 0.7).abs() <= rate.error, "tail {tail} N {n}: {rate}");
            }
            assert!(observed_rate([error(8), error(8), error(16)]).is_err());
        }
    }
}
