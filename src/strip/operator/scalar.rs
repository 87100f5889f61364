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
use super::load::mass_row;
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::check::require_finite;
use crate::strip::sides::{LateralCondition, check_cells};
use realfft::num_complex::Complex;
use std::f64::consts::PI;

/// The scalar strip with n × m cells, reduced to its edge.
#[derive(Debug, Clone)]
pub(crate) struct ScalarStrip {
    operator: EdgeOperator,
    layers: usize,
}

impl ScalarStrip {
    /// The strip with n cells along the edge and m layers; its height is H = m/n.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for n < 2 or m = 0.
    pub(crate) fn new(cells: usize, layers: usize) -> Result<Self> {
        check_cells(cells, LateralCondition::Natural)?;
        check_layers(layers)?;
        let symbol = (0..=cells)
            .map(|k| scalar_symbol(PI * k as f64 / cells as f64, layers as f64))
            .collect::<Vec<_>>();
        let operator = EdgeOperator::new(cells, LateralCondition::Natural, &symbol)?;
        Ok(Self { operator, layers })
    }

    /// The edge operator A.
    pub(crate) fn operator(&self) -> &EdgeOperator {
        &self.operator
    }

    /// The edge operator A; the strip is consumed.
    pub(crate) fn into_operator(self) -> EdgeOperator {
        self.operator
    }

    /// Number of unknowns of the represented two-dimensional problem: (n + 1) m.
    pub(crate) fn virtual_unknowns(&self) -> f64 {
        self.operator.nodes() as f64 * self.layers as f64
    }

    /// The edge load and constant of a volume load given by rows: `row(j, F)` writes the n + 1 dual values F_j of
    /// layer j = 0 ... m − 1 (j = 0 is the contact edge). Rows are evaluated from the top downwards.
    ///
    /// # Errors
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) if a row is not finite.
    fn condense_rows(&self, mut row: impl FnMut(usize, &mut [f64])) -> Result<(Vec<f64>, f64)> {
        let operator = &self.operator;
        let modes = operator.cells() + 1;
        let mut values = vec![0.0; operator.nodes()];
        let mut carried = vec![0.0; modes];
        // 1/d above the top row is 0: the row there is clamped. e is d − 1.
        let mut excess = vec![f64::INFINITY; modes];
        let mut constant = 0.0;
        for j in (0..self.layers).rev() {
            row(j, &mut values);
            require_finite("volume load", &values)?;
            let load = operator.dual_modes(&values)?;
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

    /// The edge load and constant of the load ∫ f_h v, f_h the nodal interpolant of f, by the consistent P1 mass
    /// matrix.
    ///
    /// # Errors
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) if f is not finite at a node.
    pub(crate) fn condense(&self, f: impl Fn(f64, f64) -> f64) -> Result<(Vec<f64>, f64)> {
        let n = self.operator.cells();
        let nodal = |j: usize| -> Vec<f64> {
            let y = j as f64 / n as f64;
            (0..=n).map(|i| f(i as f64 / n as f64, y)).collect()
        };
        let mut above = nodal(self.layers);
        let mut here = nodal(self.layers - 1);
        self.condense_rows(|j, out| {
            let below = if j > 0 { nodal(j - 1) } else { Vec::new() };
            mass_row(n, LateralCondition::Natural, &below, &here, &above, out);
            above = std::mem::replace(&mut here, below);
        })
    }
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

pub(crate) fn check_layers(layers: usize) -> Result<()> {
    if (1..=1 << 26).contains(&layers) {
        Ok(())
    } else {
        Err(Error::Toolkit(ToolkitError::CountOutOfRange {
            name: "layers",
            value: layers,
            range: "[1, 2^26]",
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pivots and the closed form agree to a few units per elimination step.
    const ELIMINATION: f64 = 1e-13;

    #[test]
    fn symbol_is_the_last_pivot() {
        for (n, m) in [(8usize, 8usize), (16, 5), (4, 1), (64, 256)] {
            let strip = ScalarStrip::new(n, m).unwrap();
            for k in 0..=n {
                let mu = 4.0 * (0.5 * PI * k as f64 / n as f64).sin().powi(2);
                let mut pivot = f64::INFINITY;
                for _ in 1..m {
                    pivot = 2.0 + mu - 1.0 / pivot;
                }
                let expected = 1.0 + 0.5 * mu - 1.0 / pivot;
                let got = strip.operator().symbol()[k];
                // The plain pivots lose ε m²; that is what the closed form is for.
                assert!((got - expected).abs() < ELIMINATION * (m * m) as f64 * expected, "{n} {m} {k}");
            }
        }
    }

    #[test]
    fn a_constant_load_presses_with_its_total() {
        // Without contact the edge sinks by the 1D solution of −u'' = 1, u(H) = 0, u'(0) = 0: u(0) = H²/2.
        // (P1 is nodally exact in 1D, but the mass matrix of this cut shifts the corners; test modes k = 0.)
        let strip = ScalarStrip::new(16, 16).unwrap();
        let (force, _) = strip.condense(|_, _| 1.0).unwrap();
        let total: f64 = force.iter().sum();
        let symbol_zero = strip.operator().symbol()[0];
        let mean = total / 16.0 / symbol_zero;
        assert!((mean - 0.5).abs() < 1e-13, "{mean}");
        assert!(strip.condense(|x, _| 1.0 / (x - 0.5)).is_err());
    }
}
