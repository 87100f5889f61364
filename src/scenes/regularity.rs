//! How smooth a scene is: the exponent of the leading corner singularity.
//!
//! Near a corner of opening ω between a clamped and a traction-free side, plane strain with Poisson's ratio
//! ν_P, the displacement behaves like r^λ, λ the smallest root in (0, 1] of
//!
//! sin²(λω) = (4 (1 − ν_P)² − λ² sin²ω) / (3 − 4 ν_P)
//!
//! (M. L. Williams, J. Appl. Mech. 19 (1952) 526-528; P. Grisvard, *Elliptic Problems in Nonsmooth Domains*),
//! so the solution lies in H^τ for every τ < 1 + λ. At ω = π/2, ν_P = 1/4 (the scene `block`): λ = 0.74475,
//! just below the τ = 7/4 where the paper's rate is furthest from the optimal one. For larger openings the
//! roots may be complex; they are not treated here.

use crate::error::{Error, Result};
use crate::numeric::search::sign_change;

/// Steps of the search for the first change of sign in (0, 1]; roots are further apart.
const STEPS: u32 = 1000;
/// Bisection ends here: a few roundings of λ.
const WIDTH: f64 = 1e-15;

/// λ of the clamped/free corner: opening ω in (0, π/2], Poisson's ratio in (0, 1/2), plane strain.
///
/// Bisection to rounding. Where no root lies in (0, 1), for sin²ω < 1 − ν_P, the corner does not limit H²:
/// λ = 1.
///
/// # Errors
/// [`Error::OutOfRange`] outside these ranges.
pub fn clamped_free_exponent(opening: f64, poisson: f64) -> Result<f64> {
    let is_opening = opening > 0.0 && opening <= std::f64::consts::FRAC_PI_2;
    Error::require("opening angle", opening, "(0, pi/2]", is_opening)?;
    Error::require("Poisson's ratio", poisson, "(0, 1/2)", poisson > 0.0 && poisson < 0.5)?;
    let defect = |lambda: f64| {
        let right = 4.0 * (1.0 - poisson).powi(2) - (lambda * opening.sin()).powi(2);
        (lambda * opening).sin().powi(2) - right / (3.0 - 4.0 * poisson)
    };
    // The defect is negative at 0; its first sign change is the root sought.
    let step = 1.0 / f64::from(STEPS);
    let Some(k) = (1..=STEPS).find(|&k| defect(f64::from(k) * step) >= 0.0) else { return Ok(1.0) };
    let ends = (f64::from(k - 1) * step, f64::from(k) * step);
    let (low, high) = sign_change(ends.0, ends.1, WIDTH, |lambda| defect(lambda) >= 0.0);
    Ok(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_corners() {
        // the root at a right angle and ratio 1/4, found by an independent bisection
        let block = clamped_free_exponent(std::f64::consts::FRAC_PI_2, 0.25).unwrap();
        assert!((block - 0.744_749_698_597_720_7).abs() < 1e-14, "{block}");
        // the exponent quoted for a right angle at Poisson's ratio 0.3 is 0.711
        let common = clamped_free_exponent(std::f64::consts::FRAC_PI_2, 0.3).unwrap();
        assert!((common - 0.711).abs() < 5e-4, "{common}");
        assert_eq!(clamped_free_exponent(0.3, 0.25), Ok(1.0));
        assert!(
            clamped_free_exponent(0.0, 0.3).is_err()
                && clamped_free_exponent(3.0, 0.3).is_err()
                && clamped_free_exponent(1.0, 0.5).is_err()
        );
    }
}
