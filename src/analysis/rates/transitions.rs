//! One transition with given powers and logarithms: the scenes at τ = 2, and those outside 3/2 < τ ≤ 2.
//!
//! Contact for x < a, gap beyond, mirrored at x = 1. With δ = (x − a)(b − x)/(b − a), b = 2 − a, and ℓ(r) = 2 + ln(1/r):
//!
//! u_N = −δ^p ℓ(δ)^{−α},  −σ_N = (a − x)^q ℓ(a − x)^{−α}.
//!
//! With p = τ − 1, q = τ − 2, α = 0 both data have regularity τ, not attained. At τ = 2 the slope of u_N and σ_N behave like |ln r|^{−α} on
//! one side of a: they lie in H^{1/2} exactly for α > 1/2, since their Fourier transforms decay like 1/(|ξ| |ln ξ|^α).

use crate::error::{Error, Result};
use crate::strip::{EdgeScene, Sides};

/// The powers of one transition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransitionPowers {
    /// p > 0.
    pub opening: f64,
    /// q > −1.
    pub pressure: f64,
    /// α ≥ 0.
    pub logarithm: f64,
}

impl TransitionPowers {
    /// p = τ − 1, q = τ − 2, no logarithm: regularity τ ∈ (1, 5/2].
    pub fn of_regularity(tau: f64) -> Self {
        Self { opening: tau - 1.0, pressure: tau - 2.0, logarithm: 0.0 }
    }

    /// The scene on an edge of `cells` cells with natural sides, transition at `position` ∈ (0, 1).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for powers or a position outside their ranges; as [`EdgeScene::new`].
    pub fn scene(&self, position: f64, cells: usize) -> Result<EdgeScene> {
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
        for i in (0..cells).take_while(|&i| (i + 1) as f64 * h <= position) {
            let (near, far) = (position - (i + 1) as f64 * h, position - i as f64 * h);
            let power = (far.powf(pressure + 1.0) - near.powf(pressure + 1.0)) / (pressure + 1.0);
            let force = power * weight(0.5 * (near + far));
            forces[i] += 0.5 * force;
            forces[i + 1] += 0.5 * force;
        }
        EdgeScene::new(cells, Sides::Natural, values, forces)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strip::SceneKind;

    #[test]
    fn without_logarithm_it_is_the_transition_of_the_strip() {
        let own = TransitionPowers::of_regularity(1.75).scene(0.4, 64).unwrap();
        let built =
            EdgeScene::build(SceneKind::Transition { position: 0.4 }, 1.75, 64, Sides::Natural).unwrap();
        for (a, b) in own.values().iter().zip(built.values()) {
            assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
        // There the distance to the gap is rounded to nodes: the same total force but for one cell.
        let total = |scene: &EdgeScene| scene.forces().iter().sum::<f64>();
        assert!((total(&own) - total(&built)).abs() < 64f64.powf(-0.75));
        let bad = TransitionPowers { pressure: -1.0, ..TransitionPowers::of_regularity(1.75) };
        assert!(bad.scene(0.4, 64).is_err() && TransitionPowers::of_regularity(1.75).scene(1.0, 64).is_err());
    }
}
