//! Singular functions at the corner of a sector.

use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::order::SobolevOrder;
use crate::plane::{ElasticCorner, SectorPower};

/// A corner singularity on a sector, in polar coordinates (r, φ), and its seminorms.
///
/// ```
/// use fractional_sobolev::CornerFunction;
/// // the corner singularity of the L-shape
/// let corner = CornerFunction::power(2.0 / 3.0, 2.0 / 3.0, 1.5 * std::f64::consts::PI, 1.0)?;
/// assert!(corner.seminorm(0.9, 1e-12)?.relative_error() <= 1e-12);
/// assert!(corner.seminorm(1.6, 1e-12)?.relative_error() <= 1e-12); // finite for s < 5/3
/// assert!(corner.seminorm(1.7, 1e-12).is_err());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("corner singularity", "L-shape"))]
#[derive(Debug)]
pub struct CornerFunction(Kind);

#[derive(Debug)]
enum Kind {
    Power(SectorPower),
    Elastic(ElasticCorner),
}

impl CornerFunction {
    /// The function r^a sin(bφ) on the sector 0 < r < R, 0 < φ < ω. Its seminorms are computed for 0 < s < 1 and,
    /// for a = b, where it is harmonic, for 1 < s < 2. They scale like R^{a+1−s}.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless −1 < a ≤ 20, 0 < b ≤ 20, 0 < ω ≤ 7π/4, R > 0.
    pub fn power(exponent: f64, frequency: f64, angle: f64, radius: f64) -> Result<Self> {
        SectorPower::new(exponent, frequency, angle, radius).map(Kind::Power).map(Self)
    }

    /// The elastic displacement v = (α Re z^p − p y Im z^{p−1}, (1+α) Im z^p − p y Re z^{p−1}), z = x + iy,
    /// on the half disc |z| < R, y > 0, with zero shear on y = 0. Its seminorms, of all four derivatives, are
    /// computed for 1 < s < 2. They scale like R^{p+1−s}. α = μ/(λ+μ), λ, μ the Lamé constants; the displacement
    /// of a body is v/(2μ).
    ///
    /// ```
    /// use fractional_sobolev::CornerFunction;
    /// use std::f64::consts::PI;
    /// // p = 2, α = 1: v = (x² − 3y², 2xy), |∇v|²_{1/2} = 8 |x|²_{1/2} + 40 |y|²_{1/2}
    /// let norm = CornerFunction::elastic(2.0, 1.0, 1.0)?.seminorm(1.5, 1e-12)?.value;
    /// let y = CornerFunction::power(1.0, 1.0, PI, 1.0)?.seminorm(0.5, 1e-12)?.value;
    /// let both = CornerFunction::power(2.0, 2.0, PI, 1.0)?.seminorm(1.5, 1e-12)?.value;
    /// assert!((norm / (2.0 * both.powi(2) + 32.0 * y.powi(2)).sqrt() - 1.0).abs() < 1e-12);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < p ≤ 20, α > 0, R > 0.
    #[doc(alias("Westergaard"))]
    pub fn elastic(power: f64, alpha: f64, radius: f64) -> Result<Self> {
        ElasticCorner::new(power, alpha, radius).map(Kind::Elastic).map(Self)
    }

    /// The seminorm |u|_s for 0 < s < 1, |∇u|\_{s−1} for 1 < s < 2, exact to rounding.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`]; [`Error::ToleranceNotMet`] with the best value; [`Error::Incompatible`] for an
    /// order without a method.
    pub fn seminorm(
        &self,
        s: impl Given<SobolevOrder>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        let (s, tolerance) = (s.given()?, tolerance.given()?);
        let found = match (&self.0, s) {
            (Kind::Power(u), SobolevOrder::Fractional(order)) => {
                Some(u.seminorm(order, tolerance)?)
            }
            (Kind::Power(u), SobolevOrder::OnePlus(order)) => {
                u.gradient_seminorm(order, tolerance)?
            }
            (Kind::Elastic(u), SobolevOrder::OnePlus(order)) => {
                Some(u.gradient_seminorm(order, tolerance)?)
            }
            _ => None,
        };
        let (with, expected) = match self.0 {
            Kind::Power(_) => {
                ("a power on a sector", "an order in (0, 1), or in (1, 2) where it is harmonic")
            }
            Kind::Elastic(_) => ("an elastic displacement at a corner", "an order in (1, 2)"),
        };
        found.ok_or_else(|| {
            let given = format!("of order {s:?}");
            Error::Incompatible { what: "the seminorm", given, with, expected }
        })
    }
}
