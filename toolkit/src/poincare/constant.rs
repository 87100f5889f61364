//! The constant γ_θ(ν) of Lemma 5.2 for every order, zone and condition, with bounds and an extremal function.

use super::constraint::Constraint;
use super::mesh::SHORTEST_RADIUS;
use super::spaces::attained;
use super::two_sided::{lower_bound, two_sided};
use crate::Order;
use crate::constant::{BestConstant, Extremal};
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use std::sync::Arc;

/// The Poincaré constant γ(s) = sup ‖u‖₀ / |u|_s over the functions that satisfy a constraint, with its
/// extremal function and bounds.
///
/// # Method
///
/// γ = sup ‖u‖₀ / |u|_s over u ∈ H^s(0,1) with ∫_E u = 0 (or u = 0 on E), E a zone of length θ. γ² is the
/// largest eigenvalue of the pencil (‖·‖₀², |·|_s²) on functions whose slopes are polynomials on graded
/// cells; the space is conforming, so that every value is a lower bound up to rounding. The error estimate is
/// the difference of the values on two such spaces with different cells and degrees, mostly the error of the
/// coarser one. Cost: a few hundred unknowns for every θ.
///
/// The extremal function is from the space in which the value was computed or, if the value is extrapolated from
/// larger orders, extrapolated in the same way.
///
/// **Bounds** ([`BestConstant::bounded`]) that do not use the eigenvalue: ‖u‖₀² = ‖u − m‖₀² + m² ≤ (γ₁² + N²) |u|_s²,
/// m the mean of u over (0,1), γ₁ the constant of the whole interval, N that of [`mean_constant`](crate::mean_constant);
/// and max(γ₁, N)² ≤ γ² for the mean-zero condition. `upper` is the smaller of √(γ₁² + N²) and a bound from a 2 × 2
/// matrix, in which the representer of m is treated separately, increased by the errors of γ₁ and N; `lower` is the
/// quotient less its rounding error. For orders so small that γ is extrapolated, `lower` is γ less its error and
/// `upper` at least γ plus its error. Cost: γ₁, and one linear solve with the factorized matrices, which the result
/// stores (about a megabyte). There is none for a condition at a point.
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
/// Those of the constraint; [`Error::OutOfRange`] for a condition at a point and s ≤ 1/2, where point values
/// are not defined; [`Error::ToleranceNotMet`] if rounding exceeds the tolerance (about 2e-13, up to 5e-11
/// for very short zones in the interior; for several intervals far apart, the longest of length ℓ, also 4e-15
/// ℓ^(2s−1) for s < 1/2), and for a condition at a point if s is so close to 1/2 that the constant depends on
/// distances below 1e-290.
#[doc(alias(
    "Poincare constant",
    "Poincaré constant",
    "Poincare inequality",
    "Friedrichs",
    "eigenfunction"
))]
pub fn gamma(
    s: impl Given<Order>,
    constraint: impl Given<Constraint>,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (order, constraint, tolerance) = (s.given()?, constraint.given()?, tolerance.given()?);
    reachable(order, &constraint, tolerance)?;
    let found = Arc::new(attained(order, &constraint, tolerance)?);
    let lower = lower_bound(order, &constraint, &found);
    let lower =
        Estimate::new(found.constant.value, found.constant.value - lower, found.constant.work)?;
    let attained = found.clone();
    Ok(BestConstant::new(found.constant, lower, None)
        .with_extremal_by(move || Ok(Extremal::on_interval(attained.function.clone())))
        .with_bounds_by(move || {
            let range = "the empty set (no bounds for u = 0 at a point)";
            Error::require("nu", order.value(), range, !constraint.is_point())?;
            two_sided(order, &constraint, &found, tolerance)
        }))
}

/// An error for a condition at a point where point values are not defined, or depend on distances below the range of
/// binary64.
pub(super) fn reachable(order: Order, constraint: &Constraint, tolerance: Tolerance) -> Result<()> {
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
    Ok(())
}
