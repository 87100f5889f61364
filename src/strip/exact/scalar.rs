//! Exact energy-norm errors of the scalar strip, computed from its edge alone.
//!
//! g is the exact edge displacement on a fine grid of N cells; u is either the discrete solution on the fine strip or
//! the continuous harmonic function with the piecewise linear edge data g. For a coarse solution with edge
//! displacement g_h and no volume load,
//!
//! |u − u_h|²_a = ⟨T d, d⟩ + ⟨G g_h, g_h⟩,  d = g − P g_h:
//!
//! the fine energy of the difference on the edge, and the excess energy of the coarse mesh in the interior (module
//! `defect`). Both are sums of nonnegative terms over modes, without cancellation; the plain difference of energies
//! loses at least six digits at n = 2^18. d is computed by modes (module `difference`): O(N) per error and one
//! transform of the coarse length.

use super::difference::{Interpolation, rounding};
use super::grids::{layers_on, level_of, power_of_two, pyramid};
use super::reference::Reference;
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::check::require_length;
use crate::strip::edge_data::EdgeData;
use crate::strip::operator::defect::{halving, harmonic_defect, harmonic_symbol};
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::operator::scalar::scalar_symbol;
use crate::strip::sides::LateralCondition;
use fractional_sobolev::{Estimate, Work};
use realfft::num_complex::Complex;
use std::f64::consts::PI;

/// Relative rounding error of the defects and of the sum over modes: closed forms without cancellation, a few dozen
/// ε.
const DEFECTS: f64 = 1e-14;

/// Exact edge data g, λ on a fine grid, the loads on all coarser grids, and errors with respect to the exact data.
#[derive(Debug, Clone)]
pub(super) struct ExactEdge {
    /// ĝ.
    modes: Vec<Complex<f64>>,
    /// The effect of rounding errors in ĝ on the error.
    rounding: f64,
    interpolation: Interpolation,
    cells: usize,
    layers_per_cell: (usize, usize),
    reference: Reference,
    operator: EdgeOperator,
    /// Loads on N, N/2, N/4, ... cells.
    loads: Vec<Vec<f64>>,
    /// G on N/2, N/4, ... cells (nested reference only).
    defects: Vec<Vec<f64>>,
}

impl ExactEdge {
    /// The problem on the strip of height `height.0/height.1` whose exact solution has the edge data of
    /// the test problem; natural sides.
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a periodic test problem,
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless N is a power of two and the
    /// height gives a whole number of layers on it.
    pub(super) fn scalar(edge_data: &EdgeData, height: (usize, usize), reference: Reference) -> Result<Self> {
        if edge_data.sides() != LateralCondition::Natural {
            return Err(Error::Toolkit(ToolkitError::Incompatible {
                what: "lateral condition",
                given: format!("{:?}", edge_data.sides()),
                with: "the scalar strip",
                expected: "natural",
            }));
        }
        let cells = edge_data.cells();
        power_of_two(cells)?;
        let layers = layers_on(cells, height)? as f64;
        let symbol = (0..=cells)
            .map(|k| {
                let theta = PI * k as f64 / cells as f64;
                match reference {
                    Reference::Nested => scalar_symbol(theta, layers),
                    Reference::Harmonic => harmonic_symbol(theta, layers),
                }
            })
            .collect::<Vec<_>>();
        let operator = EdgeOperator::new(cells, LateralCondition::Natural, &symbol)?;
        let defects = match reference {
            Reference::Nested => nested_defects(cells, layers),
            Reference::Harmonic => Vec::new(),
        };
        let mut exact = Self {
            modes: Vec::new(),
            rounding: 0.0,
            interpolation: Interpolation::new(LateralCondition::Natural.period(cells)),
            cells,
            layers_per_cell: height,
            reference,
            operator,
            loads: Vec::new(),
            defects,
        };
        exact.set_data(edge_data)?;
        Ok(exact)
    }

    /// Replaces the test problem by another one on the same fine grid.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if the grids differ.
    pub(super) fn set_data(&mut self, edge_data: &EdgeData) -> Result<()> {
        let mut force = self.operator.apply(edge_data.values())?;
        force.iter_mut().zip(edge_data.forces()).for_each(|(b, l)| *b += l);
        self.loads = pyramid(force, LateralCondition::Natural);
        self.modes = self.operator.modes(edge_data.values())?;
        self.rounding = rounding(&self.modes, self.operator.norm());
        Ok(())
    }

    /// Layers of the strip with `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless the height is a whole number of layers.
    pub(super) fn layers(&self, cells: usize) -> Result<usize> {
        layers_on(cells, self.layers_per_cell)
    }

    /// The load of the test problem on the edge of `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless `cells` is N divided by a power of two.
    pub(super) fn load(&self, cells: usize) -> Result<Vec<f64>> {
        let level = self.level(cells)?;
        Ok(self.loads[level].clone())
    }

    /// |u − u_h|_a, the energy norm of the error of the discrete solution with edge values `values` on `cells` cells.
    ///
    /// # Errors
    /// As for [`ExactEdge::load`]; [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch).
    pub(super) fn error(&self, cells: usize, values: &[f64]) -> Result<Estimate> {
        let level = self.level(cells)?;
        require_length("edge values", values.len(), cells + 1)?;
        let coarse = EdgeOperator::new(cells, LateralCondition::Natural, &vec![1.0; cells + 1])?;
        let modes = coarse.modes(values)?;
        let interior = self.interior(level, &coarse, &modes)?;
        let interpolated = self.interpolation.of(modes);
        let symbol = self.operator.symbol();
        let edge =
            self.operator.mode_sum_of(|k| symbol[k] * (self.modes[k] - interpolated.mode(k)).norm_sqr());
        let square = edge + interior;
        let work = Work { points: self.cells as u64 + 1, ..Work::default() };
        Ok(Estimate::new(square.sqrt(), self.rounding + DEFECTS * square.sqrt(), work)?)
    }

    /// ⟨G g_h, g_h⟩ from the modes of g_h.
    fn interior(&self, level: usize, coarse: &EdgeOperator, modes: &[Complex<f64>]) -> Result<f64> {
        let cells = coarse.cells();
        let layers = self.layers(cells)? as f64;
        Ok(match self.reference {
            Reference::Nested if level == 0 => 0.0,
            Reference::Nested => coarse.mode_sum(modes, |k| self.defects[level - 1][k]),
            Reference::Harmonic => {
                coarse.mode_sum(modes, |k| harmonic_defect(PI * k as f64 / cells as f64, layers))
            }
        })
    }

    fn level(&self, cells: usize) -> Result<usize> {
        level_of(self.cells, cells, self.loads.len())
    }
}

/// G on N/2, N/4, ..., 2 cells against N cells with `layers` layers.
fn nested_defects(cells: usize, layers: f64) -> Vec<Vec<f64>> {
    let mut defects: Vec<Vec<f64>> = Vec::new();
    let (mut n, mut m) = (cells / 2, 0.5 * layers);
    while n >= 2 {
        let finer = defects.last();
        let level = (0..=n)
            .map(|k| {
                let theta = PI * k as f64 / n as f64;
                let own = halving(theta, m);
                finer.map_or(own, |g| {
                    let (s, c) = (0.25 * theta).sin_cos();
                    own + 2.0 * (c.powi(4) * g[k] + s.powi(4) * g[2 * n - k])
                })
            })
            .collect();
        defects.push(level);
        n /= 2;
        m *= 0.5;
    }
    defects
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_height_that_is_no_number_of_layers_is_refused() {
        let flat = EdgeData::new(8, LateralCondition::Natural, &[0.0; 9], &[0.0; 9]).unwrap();
        let refused = ExactEdge::scalar(&flat, (1, 3), Reference::Nested).unwrap_err();
        assert!(refused.to_string().contains("cells"), "{refused}");
        let exact = ExactEdge::scalar(&flat, (1, 2), Reference::Nested).unwrap();
        assert_eq!(exact.layers(4).unwrap(), 2);
    }
}
