//! The scalar and the elastic strip with an exact solution, under one interface.

use super::elastic::ExactElastic;
use super::reference::Reference;
use super::scalar::ExactEdge;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::Lame;
use crate::strip::edge_data::EdgeData;
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::operator::scalar::ScalarStrip;
use crate::strip::sides::LateralCondition;
use fractional_sobolev::Estimate;
use std::fmt;
use std::str::FromStr;

/// The kind of strip.
///
/// ```
/// use signorini::strip::{LateralCondition, StripKind};
/// assert_eq!("elastic".parse::<StripKind>()?.sides(), LateralCondition::Periodic);
/// assert_eq!(StripKind::Scalar.sides(), LateralCondition::Natural);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StripKind {
    /// The Laplacian, natural sides.
    Scalar,
    /// Plane elasticity, periodic sides.
    Elastic,
}

impl StripKind {
    /// The lateral conditions of this kind of strip.
    pub fn sides(self) -> LateralCondition {
        match self {
            StripKind::Scalar => LateralCondition::Natural,
            StripKind::Elastic => LateralCondition::Periodic,
        }
    }
}

impl fmt::Display for StripKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            StripKind::Scalar => "scalar",
            StripKind::Elastic => "elastic",
        })
    }
}

impl FromStr for StripKind {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "scalar" => Ok(StripKind::Scalar),
            "elastic" => Ok(StripKind::Elastic),
            _ => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "kind of strip problem",
                given: text.to_owned(),
                expected: "scalar or elastic",
            })),
        }
    }
}

/// A contact problem on the strip of height 1 whose exact solution has given complementary edge data.
///
/// The load b = A u_N + λ on the fine grid is restricted to all coarser grids by P', P linear interpolation of edge
/// values to the finer grid, so that every coarse problem is the Galerkin discretisation of the reference
/// problem. The errors |u − u_h|_a depend only on the edge values: for the scalar strip, with v the edge
/// values of u_h and d = u_N − P v, |u − u_h|_a² = ⟨A d, d⟩ + ⟨G v, v⟩, where G ≥ 0 is the excess of the
/// energy of the coarse strip over that of the reference.
///
/// ```
/// use signorini::cone::Cone;
/// use signorini::problems::StripData;
/// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
/// let data = StripData::transition().data(2.0, 64, LateralCondition::Natural)?;
/// let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 4)?;
/// let error = |n| -> signorini::Result<f64> {
///     let u = problem.operator(n)?.0.solve_contact(&problem.load(n)?, Cone::Nodal, None, 1e-12)?;
///     Ok(problem.error(n, &u.values)?.value)
/// };
/// assert!(error(16)? < error(8)? && error(8)? < error(4)?);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct StripProblem(Exact);

#[derive(Debug, Clone)]
enum Exact {
    Scalar(ExactEdge),
    Elastic(ExactElastic),
}

impl StripProblem {
    /// The problem on the strip of height 1; for elasticity λ = μ = 1, and the reference must be the discrete
    /// solution on the grid of the test problem.
    ///
    /// `coarsest` is the smallest number of cells for which errors are computed in the elastic strip; above N, the
    /// number of cells of the data, it counts as N. Cost: O(N log N).
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`] for the lateral conditions of the other kind of strip
    /// and for a continuous elastic reference; [`ToolkitError::CountOutOfRange`] unless the number of cells
    /// is a power of two.
    pub fn new(kind: StripKind, edge_data: &EdgeData, reference: Reference, coarsest: usize) -> Result<Self> {
        Ok(Self(match kind {
            StripKind::Scalar => Exact::Scalar(ExactEdge::scalar(edge_data, (1, 1), reference)?),
            StripKind::Elastic if reference != Reference::Nested => {
                return Err(Error::Toolkit(ToolkitError::Incompatible {
                    what: "reference solution",
                    given: reference.to_string(),
                    with: "the elastic strip",
                    expected: "nested",
                }));
            }
            StripKind::Elastic => {
                Exact::Elastic(ExactElastic::new(edge_data, (1, 1), Lame::new(1.0, 1.0)?, coarsest)?)
            }
        }))
    }

    /// Replaces the edge data by other data on the same grid, at a much lower cost than a new problem.
    ///
    /// The operators A and the excess energies G are kept; the loads and the modes of u_N are recomputed in
    /// O(N log N).
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if the grids differ.
    pub fn set_data(&mut self, edge_data: &EdgeData) -> Result<()> {
        match &mut self.0 {
            Exact::Scalar(exact) => exact.set_data(edge_data),
            Exact::Elastic(exact) => exact.set_data(edge_data),
        }
    }

    /// The edge operator of the discrete problem on `cells` cells and the number of its unknowns in two
    /// dimensions.
    ///
    /// ```
    /// use signorini::problems::StripData;
    /// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
    /// let data = StripData::transition().data(2.0, 16, LateralCondition::Natural)?;
    /// let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 4)?;
    /// // (n + 1) n unknowns of a unit square; constants have the energy 1/H = 1 on every level
    /// let (a, unknowns) = problem.operator(8)?;
    /// assert!(unknowns == 72.0 && (a.energy(&[1.0; 9])? - 1.0).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 2 ≤ `cells` ≤ 2^26, in
    /// the elastic strip for a level that does not exist.
    pub fn operator(&self, cells: usize) -> Result<(EdgeOperator, f64)> {
        match &self.0 {
            Exact::Scalar(exact) => {
                let strip = ScalarStrip::new(cells, exact.layers(cells)?)?;
                let unknowns = strip.virtual_unknowns();
                Ok((strip.into_operator(), unknowns))
            }
            Exact::Elastic(exact) => {
                let unknowns = 2.0 * cells as f64 * exact.layers(cells)? as f64;
                Ok((exact.operator(cells)?, unknowns))
            }
        }
    }

    /// The load b on the edge of `cells` cells, as nodal forces.
    ///
    /// b = P'···P' (A u_N + λ), P linear interpolation to the grid of half the mesh size. There is one entry per edge
    /// node; Σ_i b_i is the same on every level.
    ///
    /// ```
    /// use signorini::problems::StripData;
    /// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
    /// let data = StripData::transition().data(2.0, 32, LateralCondition::Natural)?;
    /// let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 4)?;
    /// let total = |n| -> signorini::Result<f64> { Ok(problem.load(n)?.iter().sum()) };
    /// assert!((total(4)? - total(32)?).abs() < 1e-12 * total(4)?.abs().max(1.0));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a level that does not exist.
    pub fn load(&self, cells: usize) -> Result<Vec<f64>> {
        match &self.0 {
            Exact::Scalar(exact) => exact.load(cells),
            Exact::Elastic(exact) => exact.load(cells),
        }
    }

    /// The error |u − u_h|_a of the discrete solution with edge values `values` on `cells` cells. There is no
    /// tolerance: the energy is a finite sum of nonnegative terms over modes, computed up to rounding.
    ///
    /// The `error` of the estimate includes the rounding error of the modes, which is of size
    /// ε log₂ P (max S)^{1/2} ‖u_N‖₂, S the symbol of A, P the period in cells, ‖·‖₂ the Euclidean norm of
    /// the nodal values over a period. Cost: O(N + n log n), n = `cells`.
    ///
    /// ```
    /// use signorini::problems::StripData;
    /// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
    /// let data = StripData::transition().data(2.0, 16, LateralCondition::Natural)?;
    /// let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 4)?;
    /// // u_h = 0 at the nodes of the coarse grid: the error is the energy norm of u itself
    /// let norm = problem.operator(16)?.0.energy(data.values())?.sqrt();
    /// assert!((problem.error(8, &[0.0; 9])?.value - norm).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a level that does not exist,
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a wrong number of values.
    pub fn error(&self, cells: usize, values: &[f64]) -> Result<Estimate> {
        match &self.0 {
            Exact::Scalar(exact) => exact.error(cells, values),
            Exact::Elastic(exact) => exact.error(cells, values),
        }
    }
}
