//! The largest mean of a function relative to its seminorm under a constraint: N in γ² ≤ γ₁² + N², γ the
//! constant of Lemma 5.2, γ₁ that of the whole interval.

use super::constant::reachable;
use super::constraint::Constraint;
use super::discrete::Discrete;
use super::mesh::MeshModel;
use super::rounding::ROUNDING;
use super::spaces::supremum;
use crate::Order;
use crate::constant::BestConstant;
use crate::error::{Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// The best constant N = sup |∫ u| / |u|_s on (0, 1) over the functions that satisfy a constraint.
///
/// If the mean over the zone E is zero, it is the dual norm of the functional 1_E/|E| − 1 with respect to the
/// seminorm, and max(γ₁, N)² ≤ γ² ≤ γ₁² + N² for the constant γ of [`gamma`](crate::gamma), γ₁ that of the whole
/// interval. Method and accuracy as for `gamma`, with one linear solve in place of the eigenvalue.
///
/// ```
/// use fractional_sobolev::{Constraint, gamma, mean_constant};
/// let zone = Constraint::mean_zero_on(0.0..1e-3)?;
/// let [whole, best] = [Constraint::mean_zero(), zone.clone()].map(|of| gamma(0.5, of, 1e-6));
/// let n = mean_constant(0.5, zone, 1e-6)?.constant.value;
/// let (whole, best) = (whole?.constant.value, best?.constant.value);
/// assert!(n.max(whole) <= best && best <= n.hypot(whole));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As for [`gamma`](crate::gamma).
#[doc(alias("dual norm of the mean"))]
pub fn mean_constant(
    s: impl Given<Order>,
    constraint: impl Given<Constraint>,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (order, constraint, tolerance) = (s.given()?, constraint.given()?, tolerance.given()?);
    reachable(order, &constraint, tolerance)?;
    let found = largest_mean(order, &constraint, tolerance)?;
    Ok(BestConstant::new(found, found, None))
}

/// N = sup |mean of u| / |u|_s over the same functions as in `gamma`. If the mean over E is zero, it is the
/// dual norm of the functional 1_E/|E| − 1 with respect to the seminorm; for dual norms with respect to (1.1)
/// see [`crate::dual`].
pub(super) fn largest_mean(
    order: Order,
    constraint: &Constraint,
    tolerance: Tolerance,
) -> Result<Estimate> {
    if constraint.is_whole() {
        return Estimate::new(0.0, 0.0, Work::default());
    }
    supremum(order, constraint, tolerance, |order, model| {
        let discrete = Discrete::new(order, constraint, model)?;
        Ok((discrete.dual_norm()?.square.sqrt() * discrete.factor, discrete.work))
    })
}

/// N², ‖r‖₀² and ⟨T²r, r⟩ for a zone (0,θ), where r is the representer, with mean zero, of the dual norm and T
/// the operator of ‖·‖₀².
pub(super) fn dual_moments(
    order: Order,
    theta: f64,
    tolerance: Tolerance,
) -> Result<[Estimate; 3]> {
    let constraint = Constraint::mean_zero_on(0.0..theta)?;
    let moments = |model: &MeshModel| -> Result<([f64; 3], Work)> {
        let discrete = Discrete::new(order, &constraint, model)?;
        let dual = discrete.dual_norm()?;
        let scale = discrete.factor * discrete.factor;
        let square = dual.square * scale;
        Ok((
            [square, square * dual.rayleigh * scale, square * dual.image * scale * scale],
            discrete.work,
        ))
    };
    let model = MeshModel::new(order, tolerance.relative());
    let both = rayon::join(|| moments(&model), || moments(&model.varied()));
    let ((fine, work), (coarse, more)) = (both.0?, both.1?);
    let estimate = |k: usize| {
        Estimate::new(fine[k], (fine[k] - coarse[k]).abs() + 2.0 * ROUNDING * fine[k], work + more)
    };
    Ok([estimate(0)?, estimate(1)?, estimate(2)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    #[test]
    fn a_refused_dual_norm_carries_its_best_value() {
        let (order, constraint) =
            (Order::new(0.4).unwrap(), Constraint::mean_zero_on(0.0..0.25).unwrap());
        let norm =
            |tolerance: f64| largest_mean(order, &constraint, Tolerance::new(tolerance).unwrap());
        let met = norm(1e-11).unwrap();
        let refused = norm(1e-15).unwrap_err();
        let Error::ToleranceNotMet { asked, reached, best: Some(best), why, .. } = refused else {
            panic!("{refused:?}");
        };
        assert!((best.value - met.value).abs() <= best.error + met.error, "{best} {met}");
        assert!(reached > asked && reached == best.relative_error() && !why.is_empty());
    }
}
