//! One transition with given powers and logarithms: test problems at τ = 2, and outside 3/2 < τ ≤ 2.
//!
//! Contact for x < a, no contact for x > a, extended by reflection at x = 1. With δ = (x − a)(b − x)/(b − a),
//! b = 2 − a, and ℓ(r) = 2 + ln(1/r):
//!
//! u_N = −δ^p ℓ(δ)^{−α},  −σ_N = (a − x)^q ℓ(a − x)^{−α}.
//!
//! With p = τ − 1, q = τ − 2, α = 0 both data have regularity τ, not attained. At τ = 2 the slope of u_N and
//! σ_N behave like |ln r|^{−α} on one side of a: they lie in H^{1/2} exactly for α > 1/2, since their Fourier
//! transforms decay like 1/(|ξ| |ln ξ|^α).

use crate::error::{Error, Result};
use crate::strip::{EdgeData, LateralCondition};

/// The exponents p, q and α at one transition: to leading order u_N = −r^p ℓ(r)^{−α} on one side of it and
/// σ_N = −r^q ℓ(r)^{−α} on the other, r the distance to it, ℓ(r) = 2 + ln(1/r).
///
/// ```
/// use signorini::problems::TransitionPowers;
/// let data = TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: 0.0 }.data(0.5, 8)?;
/// // λ = 1 on [0, 1/2]: the nodal forces sum to 1/2; u_N(3/4) = −(1/4)(3/4)
/// assert!((data.forces().iter().sum::<f64>() - 0.5).abs() < 1e-15);
/// assert!((data.values()[6] + 0.1875).abs() < 1e-15);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransitionPowers {
    /// The exponent p > 0 of u_N.
    pub opening: f64,
    /// The exponent q > −1 of σ_N.
    pub pressure: f64,
    /// The exponent α ≥ 0 of the factor ℓ^{−α}.
    pub logarithm: f64,
}

impl TransitionPowers {
    /// The powers p = τ − 1, q = τ − 2 without logarithm (α = 0): regularity τ for 1 < τ ≤ 5/2, which is not
    /// checked.
    ///
    /// ```
    /// use signorini::problems::TransitionPowers;
    /// // τ = 5/2 corresponds to the natural r^{3/2}, with σ_N of size r^{1/2}
    /// let powers = TransitionPowers::of_regularity(2.5);
    /// assert_eq!((powers.opening, powers.pressure), (1.5, 0.5));
    /// ```
    pub fn of_regularity(tau: f64) -> Self {
        Self { opening: tau - 1.0, pressure: tau - 2.0, logarithm: 0.0 }
    }

    /// The data of the test problem on an edge of `cells` cells with natural lateral conditions and a
    /// transition at a = `position` ∈ (0, 1).
    ///
    /// u_N is evaluated at the nodes. The forces are integrals of the density over the cells, half of each
    /// assigned to each end of the cell, the one next to a to the last contact node. They are exact for α =
    /// 0, so that Σ_i λ_i = ∫ λ = a^{q+1}/(q + 1); for α > 0 the logarithm is evaluated at the midpoints.
    /// Cost: O(cells).
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for powers or a position outside their ranges;
    /// the errors of [`EdgeData::new`].
    pub fn data(&self, position: f64, cells: usize) -> Result<EdgeData> {
        let Self { opening, pressure, logarithm } = *self;
        Error::require("p", opening, "(0, inf)", opening > 0.0)?;
        Error::require("q", pressure, "(-1, inf)", pressure > -1.0)?;
        Error::require("alpha", logarithm, "[0, inf)", logarithm >= 0.0)?;
        Error::require("position", position, "(0, 1)", position > 0.0 && position < 1.0)?;
        let h = 1.0 / cells as f64;
        let weight = |r: f64| (2.0 - r.ln()).powf(-logarithm);
        let values: Vec<f64> = (0..=cells)
            .map(|i| i as f64 * h - position)
            .map(|left| {
                if left <= 0.0 {
                    return 0.0;
                }
                let right = 2.0 * (1.0 - position) - left;
                let depth = left * right / (left + right);
                -depth.powf(opening) * weight(depth)
            })
            .collect();
        let mut forces = vec![0.0; cells + 1];
        let integral = |near: f64, far: f64| {
            let power = (far.powf(pressure + 1.0) - near.powf(pressure + 1.0)) / (pressure + 1.0);
            power * weight(0.5 * (near + far))
        };
        let mut last = 0;
        for i in (0..cells).take_while(|&i| (i + 1) as f64 * h <= position) {
            let force = integral(position - (i + 1) as f64 * h, position - i as f64 * h);
            forces[i] += 0.5 * force;
            forces[i + 1] += 0.5 * force;
            last = i + 1;
        }
        // The part between the last contact node and a, so that no force is lost.
        let rest = position - last as f64 * h;
        forces[last] += if rest > 0.0 { integral(0.0, rest) } else { 0.0 };
        EdgeData::new(cells, LateralCondition::Natural, &values, &forces)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_those_asked_for() {
        let (position, cells) = (0.4, 1 << 12);
        let edge_data = TransitionPowers::of_regularity(1.75).data(position, cells).unwrap();
        // Half way to the mirror axis δ = d (c − d)/c, c = 1.2, d = 0.3.
        let value = edge_data.values()[(0.7 * cells as f64).round() as usize];
        let depth = 0.3 * 0.9 / 1.2;
        assert!((value + f64::powf(depth, 0.75)).abs() < 1.0 / cells as f64, "{value}");
        // No slope at the side.
        let last = edge_data.values()[cells] - edge_data.values()[cells - 1];
        assert!(last.abs() < (cells as f64).powi(-2), "{last}");
        // ∫ (a − x)^{−1/4} = a^{3/4}/(3/4), a sum of 1600 terms.
        let total: f64 = edge_data.forces().iter().sum();
        let missing = 0.4f64.powf(0.75) / 0.75 - total;
        assert!(missing.abs() < 1e-12, "{missing}");
        let bad = TransitionPowers { pressure: -1.0, ..TransitionPowers::of_regularity(1.75) };
        assert!(
            bad.data(0.4, 64).is_err()
                && TransitionPowers::of_regularity(1.75).data(1.0, 64).is_err()
        );
    }
}
