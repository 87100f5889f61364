//! The constant γ_θ(ν) of Lemma 5.2 for every order, zone and condition, with bounds and an extremal function.

use super::constraint::Constraint;
use super::mesh::SHORTEST_RADIUS;
use super::spaces::{Attained, attained};
use super::two_sided::{GammaBounds, two_sided};
use crate::Order;
use crate::constant::Extremal;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};

/// The Poincaré constant γ(ν) = sup ‖u‖₀ / |u|_ν over the functions that satisfy a constraint, with its
/// extremal function and bounds.
///
/// # Method
///
/// γ = sup ‖u‖₀ / |u|_ν over u ∈ H^ν(0,1) with ∫_E u = 0 (or u = 0 on E), E a zone of length θ. γ² is the
/// largest eigenvalue of the pencil (‖·‖₀², |·|_ν²) on functions whose slopes are polynomials on graded
/// cells; the space is conforming, so that every value is a lower bound up to rounding. The error estimate is
/// the difference of the values on two such spaces with different cells and degrees, mostly the error of the
/// coarser one. Cost: a few hundred unknowns for every θ.
///
/// ```
/// use fractional_sobolev::{Constraint, gamma};
/// let whole = gamma(0.5, Constraint::mean_zero(), 1e-8)?.constant;
/// let small = gamma(0.5, Constraint::mean_zero_on(0.0..1e-9), 1e-8)?.constant;
/// assert!((whole.value - 0.291_564_029).abs() < 1e-8 && small.value > 1.5);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// Those of the constraint; [`Error::OutOfRange`] for a condition at a point and ν ≤ 1/2, where point values
/// are not defined; [`Error::ToleranceNotMet`] if rounding exceeds the tolerance (about 2e-13, up to 5e-11
/// for very short zones in the interior; for several intervals far apart, the longest of length ℓ, also 4e-15
/// ℓ^(2ν−1) for ν < 1/2), and for a condition at a point if ν is so close to 1/2 that the constant depends on
/// distances below 1e-290.
#[doc(alias(
    "Poincare constant",
    "Poincaré constant",
    "Poincare inequality",
    "Friedrichs",
    "eigenfunction"
))]
pub fn gamma(
    order: impl Given<Order>,
    constraint: impl Given<Constraint>,
    tolerance: impl Given<Tolerance>,
) -> Result<Gamma> {
    let (order, constraint, tolerance) = (order.given()?, constraint.given()?, tolerance.given()?);
    if constraint.is_point() {
        Error::require("nu", order.value(), "(1/2, 1)", order.offset() > 0.0)?;
        let reached = SHORTEST_RADIUS.powf(2.0 * order.offset());
        if reached > tolerance.relative() {
            let why = "the order is so close to 1/2 that the constant depends on distances below the range of binary64";
            return Err(Error::out_of_reach(
                "Poincare constant",
                tolerance.relative(),
                reached,
                why,
            ));
        }
    }
    let found = attained(order, &constraint, tolerance)?;
    Ok(Gamma { constant: found.constant, order, constraint, tolerance, found })
}

/// A Poincaré constant with the function for which it is attained.
///
/// Returned by [`gamma`].
#[derive(Debug, Clone)]
pub struct Gamma {
    /// The constant γ.
    pub constant: Estimate,
    order: Order,
    constraint: Constraint,
    tolerance: Tolerance,
    found: Attained,
}

impl Gamma {
    /// A function that attains the constant: from the space in which the value was computed or, if the value is
    /// extrapolated from larger orders, extrapolated in the same way.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, Gamma, gamma};
    /// let found: Gamma = gamma(0.5, Constraint::vanishing_on(0.0..0.01), 1e-4)?;
    /// let u = found.extremal();
    /// assert!(u.value(&[0.005]).abs() < 1e-12 && u.value(&[1.0]) > 1.0 && found.constant.value > 0.3);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    #[doc(alias("eigenfunction", "minimiser"))]
    pub fn extremal(&self) -> Extremal {
        Extremal::on_interval(self.found.function.clone())
    }

    /// Two-sided bounds that do not use the eigenvalue: ‖u‖₀² = ‖u − m‖₀² + m² ≤ (γ₁² + N²) |u|_ν², m the mean of u
    /// over (0,1), γ₁ the constant of the whole interval, N the dual norm of u ↦ m. Cost: γ₁, and one linear solve
    /// with the factorized matrices of [`gamma`], which a `Gamma` stores (about a megabyte).
    ///
    /// The upper bound is the smaller of √(γ₁² + N²) and a bound from a 2 × 2 matrix, in which the representer
    /// of m is treated separately. It is a bound up to the errors of γ₁ and N.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, gamma};
    /// let found = gamma(0.3, Constraint::mean_zero_on(0.25..0.26), 1e-4)?;
    /// let bounds = found.bounds()?;
    /// assert!(bounds.lower <= found.constant.value && found.constant.value <= bounds.upper);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`gamma`]; [`Error::OutOfRange`] for a condition at a point, for which there is no such bound.
    pub fn bounds(&self) -> Result<GammaBounds> {
        let order = self.order.value();
        Error::require(
            "nu",
            order,
            "the empty set (no bounds for u = 0 at a point)",
            !self.constraint.is_point(),
        )?;
        two_sided(self.order, &self.constraint, &self.found, self.tolerance)
    }
}
