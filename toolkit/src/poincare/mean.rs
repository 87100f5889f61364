//! How large the mean of a function may be beside its seminorm: the second part of the constant of Lemma 5.2.

use super::constraint::Constraint;
use super::discrete::Discrete;
use super::mesh::MeshModel;
use super::rounding::ROUNDING;
use super::spaces::{continued, refine_until};
use super::zone::{Condition, Zone};
use crate::Order;
use crate::error::{Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};

/// N = sup |mean of u| / |u|_ν over the same functions as in [`gamma`]. For mean zero on E it is what 1_E/|E| − 1
/// has as a functional in the dual of the seminorm; dual norms to (1.1) are in [`crate::dual`].
///
/// ```
/// use fractional_sobolev::{Constraint, gamma, largest_mean};
/// let zone = Constraint::mean_zero_on(0.0..0.01)?;
/// let (n, g) = (largest_mean(0.5, &zone, 1e-8)?.value, gamma(0.5, &zone, 1e-8)?.constant.value);
/// let whole = gamma(0.5, Constraint::mean_zero(), 1e-8)?.constant.value;
/// assert!(n.max(whole) <= g && g <= n.hypot(whole));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As for [`gamma`].
///
/// [`gamma`]: super::gamma
#[doc(alias("H-1/2", "dual norm"))]
pub fn largest_mean(
    order: impl Given<Order>,
    constraint: impl Given<Constraint>,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, constraint, tolerance) = (order.given()?, constraint.given()?, tolerance.given()?);
    if constraint.is_whole() {
        return Estimate::new(0.0, 0.0, Work::default());
    }
    continued(order, &constraint, tolerance, |order, tolerance| {
        refine_until(order, &constraint, tolerance, |model| {
            let discrete = Discrete::new(order, &constraint, model)?;
            Ok((discrete.dual_norm()?.square.sqrt() * discrete.factor, discrete.work))
        })
    })
}

/// N², ‖r‖₀² and ⟨T²r, r⟩ for a zone (0,θ), r the mean-free representer of the dual norm, T the operator of
/// ‖·‖₀².
pub(crate) struct DualMoments {
    pub(crate) square: Estimate,
    pub(crate) representer: Estimate,
    pub(crate) image: Estimate,
}

pub(crate) fn dual_moments(order: Order, theta: f64, tolerance: Tolerance) -> Result<DualMoments> {
    let constraint = Constraint::on_zones(&Zone::end(theta)?.into(), Condition::MeanZero);
    let moments = |model: &MeshModel| -> Result<([f64; 3], Work)> {
        let discrete = Discrete::new(order, &constraint, model)?;
        let dual = discrete.dual_norm()?;
        let scale = discrete.factor * discrete.factor;
        let square = dual.square * scale;
        Ok(([square, square * dual.rayleigh * scale, square * dual.image * scale * scale], discrete.work))
    };
    let model = MeshModel::new(order, tolerance.relative());
    let both = rayon::join(|| moments(&model), || moments(&model.varied()));
    let ((fine, work), (coarse, more)) = (both.0?, both.1?);
    let estimate = |k: usize| {
        Estimate::new(fine[k], (fine[k] - coarse[k]).abs() + 2.0 * ROUNDING * fine[k], work + more)
    };
    Ok(DualMoments { square: estimate(0)?, representer: estimate(1)?, image: estimate(2)? })
}
