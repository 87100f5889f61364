//! Exact energy-norm errors of the elastic strip, computed from its edge alone.
//!
//! The test problem prescribes u_N and λ on a fine edge of N cells; no tangential force acts, so u_x follows from
//! u_N. As in the scalar case, with v = (u_x, u_y) on the edge,
//!
//! |u − u_h|²_a = ⟨A d, d⟩ + ⟨G v_h, v_h⟩,  d = v − P v_h,
//!
//! A the fine edge matrices, G from `elastic_defect`; both forms are nonnegative mode by mode, and d is computed by
//! modes as well (module `difference`).

use super::difference::{Interpolation, rounding};
use super::grids::{layers_on, level_of, power_of_two, pyramid};
use crate::error::{Error, Result, ToolkitError};
use crate::fem::Lame;
use crate::numeric::check::require_length;
use crate::strip::edge_data::EdgeData;
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::operator::elastic::{EdgeMatrix, edge_matrices};
use crate::strip::operator::elastic_defect::{aliased, halvings};
use crate::strip::sides::LateralCondition;
use fractional_sobolev::{Estimate, Work};
use realfft::num_complex::Complex;

/// Relative rounding errors of the defects: those of low modes are computed in double-double, the others have eleven
/// correct digits.
const DEFECTS: f64 = 1e-11;

/// Exact elastic edge data on a fine grid, the loads on all coarser grids, and errors with respect to the exact data.
#[derive(Debug, Clone)]
pub(super) struct ExactElastic {
    cells: usize,
    height: (usize, usize),
    operator: EdgeOperator,
    /// A on N, N/2, ... cells.
    matrices: Vec<Vec<EdgeMatrix>>,
    /// G on N/2, N/4, ... cells.
    defects: Vec<Vec<EdgeMatrix>>,
    loads: Vec<Vec<f64>>,
    /// Modes of u_x and u_y.
    exact: [Vec<Complex<f64>>; 2],
    /// The effect of their rounding errors on the error.
    rounding: f64,
    interpolation: Interpolation,
}

impl ExactElastic {
    /// The problem on the strip of height `height.0/height.1` whose exact solution has the edge data of
    /// the test problem; periodic sides, frictionless. `coarsest` is the smallest number of cells for which errors are
    /// computed.
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a test problem with natural sides,
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless N and the numbers of layers are
    /// powers of two.
    pub(super) fn new(
        edge_data: &EdgeData,
        height: (usize, usize),
        lame: Lame,
        coarsest: usize,
    ) -> Result<Self> {
        if edge_data.sides() != LateralCondition::Periodic {
            return Err(Error::Toolkit(ToolkitError::Incompatible {
                what: "lateral condition",
                given: format!("{:?}", edge_data.sides()),
                with: "the elastic strip",
                expected: "periodic",
            }));
        }
        let cells = edge_data.cells();
        power_of_two(cells)?;
        let mut matrices: Vec<Vec<EdgeMatrix>> = Vec::new();
        let mut defects: Vec<Vec<EdgeMatrix>> = Vec::new();
        let mut n = cells;
        while n >= coarsest.min(cells).max(2) {
            let layers = layers_on(n, height)?;
            power_of_two(2 * layers)?;
            let own = edge_matrices(n, layers, lame);
            if let Some(fine) = matrices.last() {
                let mut defect = halvings(n, layers, lame, &own, fine);
                if let Some(finer) = defects.last() {
                    for (k, d) in defect.iter_mut().enumerate() {
                        *d = d.combine(1.0, aliased(k, n, finer), 1.0);
                    }
                }
                defects.push(defect);
            }
            matrices.push(own);
            n /= 2;
        }
        let symbol = matrices[0].iter().map(|a| a.normal()).collect::<Vec<_>>();
        let operator = EdgeOperator::new(cells, LateralCondition::Periodic, &symbol)?;
        let mut exact = Self {
            cells,
            height,
            operator,
            matrices,
            defects,
            loads: Vec::new(),
            exact: Default::default(),
            rounding: 0.0,
            interpolation: Interpolation::new(LateralCondition::Periodic.period(cells)),
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
        self.loads = pyramid(force, LateralCondition::Periodic);
        self.exact = displacement(&self.operator, &self.matrices[0], edge_data.values())?;
        let largest = self.matrices[0].iter().map(|a| a.xx + a.yy).fold(0.0, f64::max);
        self.rounding = self.exact.iter().map(|component| rounding(component, largest)).sum();
        Ok(())
    }

    /// Layers of the strip with `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless the height is a whole number of layers.
    pub(super) fn layers(&self, cells: usize) -> Result<usize> {
        layers_on(cells, self.height)
    }

    /// The load on u_N on the edge of `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless `cells` is N divided by a power of two.
    pub(super) fn load(&self, cells: usize) -> Result<Vec<f64>> {
        let level = level_of(self.cells, cells, self.loads.len())?;
        Ok(self.loads[level].clone())
    }

    /// The operator of u_N on the edge of `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a level that does not exist.
    pub(super) fn operator(&self, cells: usize) -> Result<EdgeOperator> {
        let level = level_of(self.cells, cells, self.matrices.len())?;
        let symbol = self.matrices[level].iter().map(|a| a.normal()).collect::<Vec<_>>();
        EdgeOperator::new(cells, LateralCondition::Periodic, &symbol)
    }

    /// |u − u_h|_a for the discrete solution with the given u_N on `cells` cells.
    ///
    /// # Errors
    /// As for [`ExactElastic::load`], also for `cells` below the coarsest grid;
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch).
    pub(super) fn error(&self, cells: usize, values: &[f64]) -> Result<Estimate> {
        let level = level_of(self.cells, cells, self.matrices.len())?;
        require_length("edge values", values.len(), cells)?;
        let coarse = EdgeOperator::new(cells, LateralCondition::Periodic, &vec![1.0; cells / 2 + 1])?;
        let discrete = displacement(&coarse, &self.matrices[level], values)?;
        let interior = match level {
            0 => 0.0,
            _ => {
                let defects = &self.defects[level - 1];
                coarse.mode_sum_of(|k| defects[k].form(discrete[0][k], discrete[1][k]))
            }
        };
        let [x, y] = discrete.map(|component| self.interpolation.of(component));
        let [exact_x, exact_y] = &self.exact;
        let edge = self
            .operator
            .mode_sum_of(|k| self.matrices[0][k].form(exact_x[k] - x.mode(k), exact_y[k] - y.mode(k)));
        let square = edge + interior;
        let work = Work { points: 2 * self.cells as u64, ..Work::default() };
        Ok(Estimate::new(square.sqrt(), self.rounding + DEFECTS * square.sqrt(), work)?)
    }
}

/// Modes of (u_x, u_y) from u_N = −u_y without tangential force.
fn displacement(
    operator: &EdgeOperator,
    matrices: &[EdgeMatrix],
    normal: &[f64],
) -> Result<[Vec<Complex<f64>>; 2]> {
    let modes = operator.modes(normal)?;
    let mut x: Vec<Complex<f64>> = modes.iter().zip(matrices).map(|(u, a)| a.xy * u / a.xx).collect();
    // A real displacement has real zeroth and highest modes.
    if let [first, .., last] = &mut x[..] {
        (first.im, last.im) = (0.0, 0.0);
    }
    Ok([x, modes.iter().map(|v| -v).collect()])
}
