//! The largest mean of a function relative to its seminorm under a constraint: N in γ² ≤ γ₁² + N², γ the
//! constant of Lemma 5.2, γ₁ that of the whole interval.

use super::constraint::Constraint;
use super::discrete::Discrete;
use super::mesh::MeshModel;
use super::rounding::ROUNDING;
use super::spaces::supremum;
use crate::Order;
use crate::error::Result;
use crate::estimate::{Estimate, Tolerance, Work};

/// N = sup |mean of u| / |u|_ν over the same functions as in `gamma`. If the mean over E is zero, it is the
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
