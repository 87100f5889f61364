//! The rates of (4.6) and (4.7) for the whole space: S(N) = sup ‖φ − π^h φ‖/|φ|_r over φ ∈ H^r(0, 1),
//! h = 1/N.

use crate::ErrorExt;
use crate::EstimateExt;
use fractional_sobolev::{Domain, Error, ErrorNorm, Mesh, Result, projection_constant};
use fractional_sobolev::{Estimate, Work};
use signorini::rates::order_between;
use std::f64::consts::PI;

/// The rate of S(N), from four meshes.
///
/// Returned by [`supremum_rate`].
///
/// ```
/// use experiments::interpolation::{SupremumRate, supremum_rate};
/// use fractional_sobolev::ErrorNorm;
/// let SupremumRate { rate, observed, .. } = supremum_rate(ErrorNorm::L2, 0.25, 16, 0.01)?;
/// // with the constant part taken out the exponent is nearer to r
/// assert!((rate.value - 0.25).abs() < (observed.value - 0.25).abs());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupremumRate {
    /// The exponent with the constant part B taken out. Its error: what the three coarser meshes say
    /// differently, three times over, and what half as many cells per element say differently.
    pub rate: Estimate,
    /// The exponent between the two finest meshes as it stands; its error is what half as many cells say
    /// differently.
    pub observed: Estimate,
    /// S(N) N^r, or S(N) N^{r+1/2} in the dual norm, on the finest mesh, from below.
    pub scaled: Estimate,
}

impl SupremumRate {
    /// What part of a constant that bounds every function is attained by one, on the finest mesh.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a constant of zero.
    pub fn share(&self, constant: Estimate) -> Result<Estimate> {
        // A function is attained: what a larger space would add does not count.
        Estimate::new(self.scaled.value, 0.0, self.scaled.work)?.over(constant)
    }
}

/// An error that falls by a quarter or more with each halving of h is at most three times its last change.
const CHANGES: f64 = 3.0;

/// Growth of S(N)^{-2} from mesh to mesh, relative, below which no constant part can be told from the rest (r
/// = 0).
const GROWTH: f64 = 1e-9;

/// The rate of the supremum over H^r from meshes of N/8, N/4, N/2 and N elements, each supremum to the
/// tolerance.
///
/// # Method
///
/// **Both sides, for every N.** Element by element S(N) ≤ C(r) N^{-r}, or C*(r) N^{-r-1/2} in the dual norm.
/// Below, the wave cos(πNx) has mean zero on every element, so π^h takes nothing from it, and with ω = πN
/// ```text
/// |cos ω·|²_{r,(0,1)} = 4 ω^{2r} ∫₀^ω τ^{-1-2r} sin²(τ/2) (1 − τ/ω + sin τ/ω) dτ ≤ c_r ω^{2r}/2,
/// c_r = 2π/(Γ(1+2r) sin πr),  c_0 = c_1 = 1,
/// ```
/// because sin τ ≤ τ and 8 ∫₀^∞ τ^{-1-2r} sin²(τ/2) dτ = c_r. Hence S(N) ≥ (c_r π^{2r})^{-1/2} N^{-r}; in the
/// dual norm the wave is tested with itself, ‖cos ω·‖²_{1/2} ≤ 1/2 + πω: S(N) ≥ N^{-r-1/2} / (2 ((π² +
/// 1/(2N)) c_r π^{2r}/2)^{1/2}). The rates are therefore r and r + 1/2, no better and no worse.
///
/// **Measured.** On a mesh the double integral lacks the pairs of points outside (0, 1), which takes from
/// |φ|²_r of a function of scale h a part that does not depend on h. So S(N)^{-2} = A N^{2r} − B + ...,
/// in the dual norm N S(N)^{-2} = ... from the second factor |ψ|²_{1/2} ~ N: the observed exponent between N
/// and 2N is off by O(N^{-2r}), by 0.04 at r = 0.1 between 32 and 64 elements. Three meshes N, 2N, 4N give A,
/// B and the exponent itself, which is not put in; the same from N/2, and from half as many cells, gives its
/// uncertainty.
///
/// ```
/// use experiments::interpolation::{supremum_rate, wave_constant};
/// use fractional_sobolev::{Domain, ErrorNorm, projection_constant};
/// let found = supremum_rate(ErrorNorm::L2, 0.5, 16, 0.01)?;
/// assert!((found.rate.value - 0.5).abs() < 0.05);
/// // S(N) N^r lies between the wave and the constant of one element
/// let (below, above) =
///     (wave_constant(ErrorNorm::L2, 0.5, 16)?, projection_constant(Domain::Interval(1.0), ErrorNorm::L2, 0.5, 1e-8)?.constant);
/// assert!(below.value < found.scaled.value && found.share(above)?.value < 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::CountOutOfRange`] unless N is a multiple of 8, and as [`projection_constant`].
pub fn supremum_rate(norm: ErrorNorm, r: f64, elements: usize, tolerance: f64) -> Result<SupremumRate> {
    if elements == 0 || !elements.is_multiple_of(8) {
        return Err(Error::CountOutOfRange { name: "elements", value: elements, range: "multiples of 8" });
    }
    let on = |part: usize| {
        let mesh = Mesh::uniform(elements / part, 1.0)?;
        projection_constant(Domain::Mesh(mesh), norm, r, tolerance).map(|found| found.constant)
    };
    let norms = [on(8)?, on(4)?, on(2)?, on(1)?];
    let work = norms.iter().fold(Work::default(), |work, norm| work + norm.work);
    // Half an order of the dual norm belongs to ψ.
    let half = rate_of(norm, 0.0)?;
    let fine = fit(norms.map(|norm| norm.value), half);
    let fewer_cells = fit(norms.map(|norm| norm.value - norm.error), half);
    let error = CHANGES * (fine.rate - fine.coarse).abs() + (fine.rate - fewer_cells.rate).abs();
    let of_cells = (fine.observed - fewer_cells.observed).abs();
    let power = (elements as f64).powf(rate_of(norm, r)?);
    Ok(SupremumRate {
        rate: Estimate::new(fine.rate, error, work)?,
        observed: Estimate::new(fine.observed, of_cells, work)?,
        scaled: Estimate::new(norms[3].value * power, norms[3].error * power, work)?,
    })
}

/// The exponent of S^{-2} = A N^{2 rate} − B from the three finer and the three coarser meshes, and as it
/// stands.
struct Fit {
    rate: f64,
    coarse: f64,
    observed: f64,
}

fn fit(norms: [f64; 4], half: f64) -> Fit {
    let mut scale = 1.0;
    let squares = norms.map(|norm| {
        let square = (norm.powi(2) * scale).recip();
        scale *= 2f64.powf(2.0 * half);
        square
    });
    let observed = order_between((1.0, norms[2]), (0.5, norms[3]));
    let exponent = |y: &[f64]| {
        let (first, second) = (y[1] - y[0], y[2] - y[1]);
        if first <= GROWTH * y[1] || second <= 0.0 { observed } else { 0.5 * (second / first).log2() + half }
    };
    Fit { rate: exponent(&squares[1..]), coarse: exponent(&squares[..3]), observed }
}

/// The exponent of h in (4.6) or, in the dual norm, (4.7).
///
/// ```
/// use experiments::interpolation::rate_of;
/// assert_eq!(rate_of(fractional_sobolev::ErrorNorm::Dual, 0.5)?, 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::Incompatible`] for another norm.
pub fn rate_of(norm: ErrorNorm, r: f64) -> Result<f64> {
    match norm {
        ErrorNorm::L2 => Ok(r),
        ErrorNorm::Dual => Ok(r + 0.5),
        _ => Err(Error::Incompatible {
            what: "norm of the error",
            given: format!("{norm:?}"),
            with: "a projection",
            expected: "L2 or Dual",
        }),
    }
}

/// What S(N) N^r (or N^{r+1/2}) is at least for every N ≥ `elements`, by the wave of half a period per
/// element.
///
/// # Errors
/// [`Error::OutOfRange`] for r outside [0, 1]; [`Error::CountOutOfRange`] without elements.
pub fn wave_constant(norm: ErrorNorm, r: f64, elements: usize) -> Result<Estimate> {
    Error::require("r", r, "[0, 1]", (0.0..=1.0).contains(&r))?;
    if elements == 0 {
        return Err(Error::CountOutOfRange { name: "elements", value: 0, range: ">= 1" });
    }
    let symbol = if r == 0.0 || r == 1.0 {
        1.0
    } else {
        2.0 * PI / (libm::tgamma(1.0 + 2.0 * r) * (PI * r.min(1.0 - r)).sin())
    };
    let seminorm = symbol * PI.powf(2.0 * r);
    rate_of(norm, r)?;
    let value = match norm {
        ErrorNorm::L2 => seminorm.sqrt().recip(),
        _ => 0.5 / ((PI * PI + 0.5 / elements as f64) * 0.5 * seminorm).sqrt(),
    };
    Estimate::new(value, 16.0 * f64::EPSILON * value, Work::default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpolation::sample::SampleSlope;
    use fractional_sobolev::Order;

    #[test]
    fn the_wave_stays_below_its_bound_and_reaches_it() {
        for r in [0.1, 0.5, 0.9] {
            let order = Order::new(r).unwrap();
            let bound = wave_constant(ErrorNorm::L2, r, 1).unwrap().value;
            let quotient = |n: usize| {
                let seminorm = SampleSlope::Cosine(n).seminorm(order).unwrap().value;
                0.5f64.sqrt() / seminorm * (n as f64).powf(r)
            };
            let quotients: Vec<f64> = [1, 4, 16, 64].iter().map(|&n| quotient(n)).collect();
            assert!(quotients.windows(2).all(|pair| pair[1] < pair[0]), "{r}: {quotients:?}");
            // What is missing of the square behaves like N^{-2r}, at least 1/N: 0.39 at r = 0.1 and 0.002 at
            // r = 0.9 for N = 64.
            let left = |q: f64| 1.0 - (bound / q).powi(2);
            let missing = left(quotients[3]);
            assert!(missing > 0.0 && missing < 1.5 * 64f64.powf(-(2.0 * r).min(1.0)), "{r}: {missing}");
        }
    }

    #[test]
    fn bad_orders_and_meshes_are_errors() {
        assert!(wave_constant(ErrorNorm::L2, 1.5, 4).is_err());
        assert!(wave_constant(ErrorNorm::Dual, 0.5, 0).is_err());
        assert!(supremum_rate(ErrorNorm::L2, 0.5, 12, 0.1).is_err());
        assert!(supremum_rate(ErrorNorm::L2, 0.5, 0, 0.1).is_err());
        assert!(supremum_rate(ErrorNorm::L2, -0.5, 8, 0.1).is_err());
        // r = 0: the quotient is 1 on every mesh
        let still = supremum_rate(ErrorNorm::L2, 0.0, 8, 0.1).unwrap();
        assert!(still.rate.value.abs() < 1e-9 && (still.scaled.value - 1.0).abs() < 1e-9, "{still:?}");
    }
}
