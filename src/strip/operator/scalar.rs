//! The scalar strip (0,1) × (0,H): ∫ ∇u·∇v = ℓ(v), u = 0 on top, natural sides, contact at the bottom.
//!
//! P1 on n × m squares of side h = 1/n, each cut from bottom left to top right (the stiffness matrix does
//! not depend on the cut, the mass matrix does). Per cosine mode cos(θ i), θ = kπ/n, s = sin(θ/2), φ = 2
//! asinh s, the interior rows obey −u_{j−1} + (2 + 4s²) u_j − u_{j+1} = F_j; eliminating them leaves the
//! edge with the symbol
//!
//! S(θ) = sinh φ coth(mφ) = 2 s √(1+s²) coth(mφ),  S(0) = 1/m.
//!
//! Volume loads with rows F_j are eliminated from the top downwards, one row at a time, in O(n) memory: the pivots
//! d_j = 2 + 4s² − 1/d_{j+1} are 1 + e_j with e_j = 4s² + e_{j+1}/(1 + e_{j+1}), a sum of positive terms. The result
//! is an edge load b and a constant c = −½ Σ_j y_j²/d_j, so that min J is the minimum of ½ g'A g − b'g + c over the
//! edge. Cost: O(n) for the symbol, O(n m log n) for a volume load.

use super::edge::EdgeOperator;
use super::load::load_rows;
use crate::error::Result;
use crate::numeric::check::require_finite;
use crate::strip::sides::LateralCondition;
use fractional_sobolev_numeric::transforms::Complex;
use std::f64::consts::PI;

/// The edge load and constant of the load ∫ f_h v, f_h the nodal interpolant of f, by the consistent P1 mass matrix.
pub(crate) fn condense(
    operator: &EdgeOperator,
    layers: usize,
    f: impl Fn(f64, f64) -> f64,
) -> Result<(Vec<f64>, f64)> {
    let modes = operator.cells() + 1;
    let mut carried = vec![0.0; modes];
    // 1/d above the top row is 0: the row there is clamped. e is d − 1.
    let mut excess = vec![f64::INFINITY; modes];
    let mut constant = 0.0;
    for (j, [row]) in
        load_rows(operator.cells(), layers, LateralCondition::Natural, |x, y| [f(x, y)])
    {
        require_finite("volume load", &row)?;
        let load = operator.dual_modes(&row)?;
        for k in 0..modes {
            let pull = if excess[k].is_finite() { carried[k] / (1.0 + excess[k]) } else { 0.0 };
            carried[k] = load[k].re + pull;
        }
        if j == 0 {
            break;
        }
        for k in 0..modes {
            let s = (0.5 * PI * k as f64 / operator.cells() as f64).sin();
            let above = if excess[k].is_finite() { excess[k] / (1.0 + excess[k]) } else { 1.0 };
            excess[k] = 4.0 * s * s + above;
        }
        let (carried, excess) = (&carried, &excess);
        constant -= 0.5 * operator.mode_sum_of(|k| carried[k] * carried[k] / (1.0 + excess[k]));
    }
    let modes: Vec<Complex<f64>> = carried.iter().map(|&v| Complex::new(v, 0.0)).collect();
    let mut force = operator.with_modes(&modes)?;
    force.iter_mut().enumerate().for_each(|(i, b)| *b *= operator.weight(i));
    Ok((force, constant))
}

/// The symbol S(θ) of the scalar strip with m layers (m may be fractional: coarse and fine grids have the same mφ).
///
/// S(θ) = sinh φ coth(mφ), sinh(φ/2) = sin(θ/2); S(0) = 1/m.
pub(crate) fn scalar_symbol(theta: f64, layers: f64) -> f64 {
    if theta == 0.0 {
        return 1.0 / layers;
    }
    let s = (0.5 * theta).sin();
    2.0 * s * (1.0 + s * s).sqrt() / (2.0 * layers * s.asinh()).tanh()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pivots and the closed form agree to a few units per elimination step.
    const ELIMINATION: f64 = 1e-13;

    #[test]
    fn symbol_is_the_last_pivot() {
        for (n, m) in [(8usize, 8usize), (16, 5), (4, 1), (64, 256)] {
            for k in 0..=n {
                let theta = PI * k as f64 / n as f64;
                let mu = 4.0 * (0.5 * theta).sin().powi(2);
                let mut pivot = f64::INFINITY;
                for _ in 1..m {
                    pivot = 2.0 + mu - 1.0 / pivot;
                }
                let expected = 1.0 + 0.5 * mu - 1.0 / pivot;
                let got = scalar_symbol(theta, m as f64);
                // The plain pivots lose ε m²; that is what the closed form is for.
                assert!(
                    (got - expected).abs() < ELIMINATION * (m * m) as f64 * expected,
                    "{n} {m} {k}"
                );
            }
        }
    }
}
