//! Observed orders of convergence and the bounds they are compared with.

use crate::error::{Error, Result};

/// ln(e_{k−1}/e_k) / ln(h_{k−1}/h_k) between successive levels; `None` for the first, and where an error is not positive.
///
/// # Errors
/// [`Error::LengthMismatch`] unless there is one error per mesh size.
pub fn observed_orders(mesh_sizes: &[f64], errors: &[f64]) -> Result<Vec<Option<f64>>> {
    if mesh_sizes.len() != errors.len() {
        return Err(Error::LengthMismatch {
            name: "errors",
            given: errors.len(),
            expected: mesh_sizes.len(),
        });
    }
    let order = |k: usize| {
        let k0 = k.checked_sub(1)?;
        let order = (errors[k0] / errors[k]).ln() / (mesh_sizes[k0] / mesh_sizes[k]).ln();
        (errors[k0] > 0.0 && errors[k] > 0.0 && order.is_finite()).then_some(order)
    };
    Ok((0..errors.len()).map(order).collect())
}

/// The bounds for the H¹ error that stand side by side: before the paper, the paper, and the optimal one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// h^{τ/2 − 1/4} (E2), at τ = 2 h^{3/4} (E3).
    Earlier,
    /// h^{τ² − 5τ/2 + 2} (3.1), at τ = 2 h |ln h|^{1/2} (3.2).
    Paper,
    /// h^{τ − 1}, shown by Drouet and Hild, SIAM J. Numer. Anal. 53 (2015) 1488-1507.
    Optimal,
}

impl Bound {
    /// The value of the bound, without its constant, for 3/2 < τ ≤ 2 and 0 < h < 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside these ranges.
    pub fn value(self, h: f64, tau: f64) -> Result<f64> {
        Error::require("h", h, "(0, 1)", h > 0.0 && h < 1.0)?;
        let power = h.powf(self.exponent(tau)?);
        let is_logarithmic = self == Bound::Paper && tau == 2.0;
        Ok(if is_logarithmic { power * h.ln().abs().sqrt() } else { power })
    }

    /// The exponent of h, 3/2 < τ ≤ 2; at τ = 2 the paper's bound has a logarithm beside it.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside this range.
    pub fn exponent(self, tau: f64) -> Result<f64> {
        Error::require("tau", tau, "(3/2, 2]", tau > 1.5 && tau <= 2.0)?;
        Ok(match self {
            Bound::Earlier => 0.5 * tau - 0.25,
            Bound::Paper => tau * tau - 2.5 * tau + 2.0,
            Bound::Optimal => tau - 1.0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_of_a_power_law() {
        let h = [0.5, 0.25, 0.125];
        let errors = h.map(|h: f64| 3.0 * h.powf(0.75));
        let orders = observed_orders(&h, &errors).unwrap();
        assert_eq!(orders[0], None);
        assert!(orders[1..].iter().all(|p| p.is_some_and(|p| (p - 0.75).abs() < 1e-14)));
    }

    #[test]
    fn the_paper_is_furthest_from_optimal_at_seven_quarters() {
        let gap = |tau: f64| Bound::Optimal.exponent(tau).unwrap() - Bound::Paper.exponent(tau).unwrap();
        assert_eq!(gap(1.75), 1.0 / 16.0);
        assert!(gap(1.74) < gap(1.75) && gap(1.76) < gap(1.75) && gap(2.0) == 0.0);
        assert!(Bound::Paper.value(0.5, 1.5).is_err());
    }
}
