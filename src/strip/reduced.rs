//! A strip with n × m cells, scalar or elastic: its edge operator, and volume loads condensed to the edge.

use super::operator::edge::EdgeOperator;
use super::operator::elastic::{self, EdgeMatrix, edge_matrices};
use super::operator::scalar::{self, scalar_symbol};
use super::sides::LateralCondition;
use crate::error::{Error, Result};
use crate::fem::Lame;
use std::f64::consts::PI;

/// A strip of height m/n with n × m cells, n along the contact edge, with u = 0 at the top.
///
/// ```
/// use signorini::{cone::Cone, strip::Strip};
/// let strip = Strip::scalar(64, 64)?;
/// let (force, constant) = strip.condense(|x, _| [(6.0 * x).cos() + 0.3, 0.0])?;
/// let solution = strip.operator().solve_contact(&force, Cone::Nodal, None, 1e-13)?;
/// // J(u) < J(0), and the KKT residuals are small
/// assert!(solution.energy + constant < constant && solution.kkt.worst() < 1e-12);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Strip {
    pub(super) operator: EdgeOperator,
    layers: usize,
    /// The material and the edge matrices of all modes; `None` for the Laplace equation.
    elastic: Option<(Lame, Vec<EdgeMatrix>)>,
}

impl Strip {
    /// The strip for the Laplace equation, with natural sides.
    ///
    /// On (0, 1) × (0, m/n): ∫ ∇u·∇v = ℓ(v), u = 0 on top. Symbol S(θ) = 2 s √(1 + s²) coth(m φ), s = sin(θ/2),
    /// φ = 2 asinh s, θ = kπ/n, and S(0) = 1/m. Cost: O(n).
    ///
    /// ```
    /// use signorini::strip::Strip;
    /// // u = 1 on the edge: u is linear in y, and its energy is n (1/m) = 1/H
    /// let strip = Strip::scalar(8, 4)?;
    /// assert!((strip.operator().energy(&[1.0; 9])? - 8.0 / 4.0).abs() < 1e-13);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 2 ≤ n ≤ 2^26 and 1 ≤ m
    /// ≤ 2^26.
    pub fn scalar(cells: usize, layers: usize) -> Result<Self> {
        LateralCondition::Natural.check_cells(cells)?;
        check_layers(layers)?;
        let symbol: Vec<f64> = (0..=cells)
            .map(|k| scalar_symbol(PI * k as f64 / cells as f64, layers as f64))
            .collect();
        let operator = EdgeOperator::new(cells, LateralCondition::Natural, &symbol)?;
        Ok(Self { operator, layers, elastic: None })
    }

    /// The strip of a homogeneous, isotropic elastic material, with periodic sides.
    ///
    /// On (0, 1) × (0, m/n), plane strain, u = 0 on top, no friction. The edge matrix of a mode, Hermitian 2 × 2, is
    /// computed by log₂ m doublings of a layer; its relative accuracy is 1e-13 for λ = μ, 1e-12 for λ = 100 μ. Cost:
    /// O(n log m).
    ///
    /// ```
    /// use signorini::{fem::Lame, strip::Strip};
    /// // u_N = 1: u_y is linear in y, and its energy is (λ + 2μ)/H
    /// let strip = Strip::elastic(8, 4, Lame::new(1.0, 1.0)?)?;
    /// assert!((strip.operator().energy(&[1.0; 8])? - 3.0 / 0.5).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless n is even, m a power of
    /// two, 2 ≤ n ≤ 2^26 and m ≤ 2^26.
    pub fn elastic(cells: usize, layers: usize, lame: Lame) -> Result<Self> {
        LateralCondition::Periodic.check_cells(cells)?;
        check_layers(layers)?;
        Error::require_count("layers", layers, "{1, 2, 4, 8, ...}", layers.is_power_of_two())?;
        let matrices = edge_matrices(cells, layers, lame);
        let symbol: Vec<f64> = matrices.iter().map(|a| a.normal()).collect();
        let operator = EdgeOperator::new(cells, LateralCondition::Periodic, &symbol)?;
        Ok(Self { operator, layers, elastic: Some((lame, matrices)) })
    }

    /// The edge operator A; for elasticity that of the normal displacement, with the tangential one condensed.
    ///
    /// With v = (u_x, u_y) and the matrix A of a mode, S_N = A_yy − |A_xy|²/A_xx acts on u_N = −u_y.
    pub fn operator(&self) -> &EdgeOperator {
        &self.operator
    }

    /// The edge load b and the constant c of J(g) = ½ g'A g − b'g + c for the load ∫ f_h·v, f_h the nodal interpolant
    /// of f (scalar: of its first component), assembled with the consistent P1 mass matrix; c is the minimal energy
    /// for zero edge displacement (g = 0). Cost: O(n m log n).
    ///
    /// Block elimination from the top: with the load F_j and the pivot C_j of row j and the coupling R of adjacent
    /// rows, y_j ← F_j − R C_{j+1}⁻¹ y_{j+1} and c = −½ Σ_j y_j* C_j⁻¹ y_j over the interior rows. In the elastic
    /// strip b acts on u_N; c includes the energy of the eliminated tangential edge displacement.
    ///
    /// ```
    /// use signorini::strip::Strip;
    /// let strip = Strip::scalar(8, 8)?;
    /// let (b, c) = strip.condense(|_, _| [1.0, 0.0])?;
    /// // without contact: J(u) = -½ b'A⁻¹b + c, and ∫ f u = -2 J → 1/3 as h → 0, the value for u = (1 - y²)/2
    /// let w = strip.operator().solve(&b)?;
    /// let energy: f64 = c - 0.5 * b.iter().zip(&w).map(|(b, w)| b * w).sum::<f64>();
    /// assert!((-2.0 * energy - 1.0 / 3.0).abs() < 1.0 / 64.0);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite) if f is not finite at a node.
    pub fn condense(&self, f: impl Fn(f64, f64) -> [f64; 2]) -> Result<(Vec<f64>, f64)> {
        match &self.elastic {
            None => scalar::condense(&self.operator, self.layers, |x, y| f(x, y)[0]),
            Some((lame, matrices)) => {
                elastic::condense(&self.operator, self.layers, (*lame, matrices), f)
            }
        }
    }
}

fn check_layers(layers: usize) -> Result<()> {
    Error::require_count("layers", layers, "[1, 2^26]", (1..=1 << 26).contains(&layers))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_loads_are_checked() {
        let lame = Lame::new(1.0, 1.0).unwrap();
        for (cells, layers) in [(7, 8), (8, 6), (8, 0)] {
            assert!(Strip::elastic(cells, layers, lame).is_err(), "{cells} {layers}");
        }
        assert!(Strip::scalar(16, 16).unwrap().condense(|x, _| [1.0 / (x - 0.5), 0.0]).is_err());
    }
}
