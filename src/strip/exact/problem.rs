//! Contact problems on the strip with exact solution, and exact energy-norm errors computed from the edge alone.
//!
//! g is the exact edge displacement on a fine grid of N cells; u is either the discrete solution on the fine strip or
//! the continuous harmonic function with the piecewise linear edge data g. For a coarse solution with edge
//! displacement g_h and no volume load,
//!
//! |u − u_h|²_a = ⟨T d, d⟩ + ⟨G g_h, g_h⟩,  d = g − P g_h:
//!
//! the fine energy of the difference on the edge, and the excess energy of the coarse mesh in the interior (modules
//! `defect` and `elastic_defect`). Both are sums of nonnegative terms over modes, without cancellation; the plain
//! difference of energies loses at least six digits at n = 2^18. d is computed by modes (module `difference`): O(N)
//! per error and one transform of the coarse length. In the elastic strip g = (u_x, u_y), T are the fine edge
//! matrices, and as no tangential force acts, u_x follows from u_N.

use super::difference::{Interpolation, rounding};
use crate::cone::Cone;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::Lame;
use crate::numeric::check::require_length;
use crate::strip::edge_data::EdgeData;
use crate::strip::operator::defect::{halving, harmonic_defect, harmonic_symbol};
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::operator::elastic::{EdgeMatrix, edge_matrices};
use crate::strip::operator::elastic_defect::{aliased, halvings};
use crate::strip::operator::scalar::scalar_symbol;
use crate::strip::reduced::Strip;
use crate::strip::sides::LateralCondition;
use crate::strip::solver::solution::EdgeSolution;
use crate::strip::transfer::restrict;
use fractional_sobolev::{Estimate, Work};
use fractional_sobolev_numeric::transforms::Complex;
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;

/// Relative rounding error of the defects and of the sum over modes: in the scalar strip closed forms without
/// cancellation, a few dozen ε; in the elastic strip those of low modes are computed in double-double, the others have
/// eleven correct digits.
const SCALAR_DEFECTS: f64 = 1e-14;
const ELASTIC_DEFECTS: f64 = 1e-11;

/// Relative residual of the discrete solutions.
const SOLVED: f64 = 1e-13;
/// Nested iteration starts on a mesh with at least this many cells.
const COARSEST: usize = 8;

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

/// The reference with which discrete solutions are compared.
///
/// With `Nested` the error is |u_fine − u_h|_a, u_fine the discrete solution on the fine mesh; the error of the fine
/// mesh is not included. With `Harmonic` it is. Both errors depend only on the edge values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// The discrete solution on the strip of the fine grid.
    Nested,
    /// The continuous harmonic function with the fine edge data.
    Harmonic,
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
/// // the discrete solutions on 4, 8 and 16 cells
/// let solutions = problem.solutions(Cone::Nodal, 4, 16)?;
/// let errors = solutions.iter().map(|u| problem.error(u)).collect::<Result<Vec<_>, _>>()?;
/// assert!(errors.windows(2).all(|pair| pair[1].value < pair[0].value));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct StripProblem {
    /// T, in the elastic strip with the tangential component condensed.
    operator: EdgeOperator,
    /// The loads on N, N/2, ..., 2 cells.
    loads: Vec<Vec<f64>>,
    interpolation: Interpolation,
    /// The effect of rounding errors in the modes of g on the error.
    rounding: f64,
    exact: Exact,
}

/// The modes of g, and what T and G need besides.
#[derive(Debug, Clone)]
enum Exact {
    Scalar {
        modes: Vec<Complex<f64>>,
        /// G on N/2, N/4, ..., 2 cells; `None` for the harmonic reference.
        defects: Option<Vec<Vec<f64>>>,
    },
    Elastic {
        /// Modes of u_x and u_y.
        modes: [Vec<Complex<f64>>; 2],
        /// Edge matrices on N, N/2, ... cells.
        matrices: Vec<Vec<EdgeMatrix>>,
        /// G on N/2, N/4, ... cells.
        defects: Vec<Vec<EdgeMatrix>>,
    },
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
    pub fn new(
        kind: StripKind,
        edge_data: &EdgeData,
        reference: Reference,
        coarsest: usize,
    ) -> Result<Self> {
        let (cells, sides) = (edge_data.cells(), edge_data.sides());
        if kind == StripKind::Elastic && reference != Reference::Nested {
            let (what, with) = ("reference solution", "the elastic strip");
            return Err(Error::incompatible(what, "harmonic", with, "nested"));
        }
        if sides != kind.sides() {
            let (with, expected) = match kind {
                StripKind::Scalar => ("the scalar strip", "natural"),
                StripKind::Elastic => ("the elastic strip", "periodic"),
            };
            return Err(Error::incompatible(
                "lateral condition",
                format!("{sides:?}"),
                with,
                expected,
            ));
        }
        let is_power = cells.is_power_of_two() && cells >= 2;
        Error::require_count("cells", cells, "{2, 4, 8, 16, ...}", is_power)?;
        let values = edge_data.values();
        let (operator, rounding, exact) = match kind {
            StripKind::Scalar => {
                let symbol: fn(f64, f64) -> f64 = match reference {
                    Reference::Nested => scalar_symbol,
                    Reference::Harmonic => harmonic_symbol,
                };
                let symbol: Vec<f64> = (0..=cells)
                    .map(|k| symbol(PI * k as f64 / cells as f64, cells as f64))
                    .collect();
                let operator = EdgeOperator::new(cells, sides, &symbol)?;
                let modes = operator.modes(values)?;
                let rounding = rounding(&modes, operator.norm());
                let defects = (reference == Reference::Nested).then(|| nested_defects(cells));
                (operator, rounding, Exact::Scalar { modes, defects })
            }
            StripKind::Elastic => {
                let (matrices, defects) = elastic_levels(cells, Lame::new(1.0, 1.0)?, coarsest);
                let operator = normal_operator(cells, &matrices[0])?;
                let modes = displacement(&operator, &matrices[0], values)?;
                let largest = matrices[0].iter().map(|a| a.xx + a.yy).fold(0.0, f64::max);
                let rounding = modes.iter().map(|component| rounding(component, largest)).sum();
                (operator, rounding, Exact::Elastic { modes, matrices, defects })
            }
        };
        let mut force = operator.apply(values)?;
        force.iter_mut().zip(edge_data.forces()).for_each(|(b, l)| *b += l);
        let interpolation = Interpolation::new(sides.period(cells));
        Ok(Self { operator, loads: pyramid(force, sides), interpolation, rounding, exact })
    }

    /// The discrete solution u_h on `cells` cells, in the given cone: the minimiser of ½ v'A v − b'v with the operator
    /// A and the load b of that mesh.
    ///
    /// The active set method on the edge, to a relative residual of 1e-13; it starts from the solution on half as many
    /// cells, down to about eight. [`EdgeSolution::error`] bounds the algebraic error. Cost: O(n log n).
    ///
    /// ```
    /// use signorini::cone::Cone;
    /// use signorini::problems::StripData;
    /// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
    /// let data = StripData::transition().data(2.0, 64, LateralCondition::Natural)?;
    /// let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 8)?;
    /// // on the grid of the data the discrete solution is u_N itself
    /// let u = problem.solve(64, Cone::Nodal)?;
    /// assert!(problem.error(&u)?.value < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`] for a level that does not exist, [`Error::NotConverged`] with the best
    /// solution.
    pub fn solve(&self, cells: usize, cone: Cone) -> Result<EdgeSolution> {
        let level = self.level(cells, self.levels())?;
        let halvings =
            (level..self.levels()).take_while(|&k| self.operator.cells() >> k >= COARSEST).count();
        let coarsest = cells >> halvings.saturating_sub(1);
        let mut last = self.solve_from(coarsest, cone, None)?;
        let mut n = coarsest;
        while n < cells {
            n *= 2;
            last = self.solve_from(n, cone, Some(&last))?;
        }
        Ok(last)
    }

    /// The discrete solutions on `coarsest`, 2 `coarsest`, 4 `coarsest`, ..., `finest` cells, each computed from the
    /// one before; otherwise as [`StripProblem::solve`].
    ///
    /// ```
    /// use signorini::cone::Cone;
    /// use signorini::problems::StripData;
    /// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
    /// let data = StripData::transition().data(2.0, 64, LateralCondition::Natural)?;
    /// let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 8)?;
    /// let solutions = problem.solutions(Cone::Midpoint, 8, 32)?;
    /// assert_eq!(solutions.iter().map(|u| u.cells).collect::<Vec<_>>(), [8, 16, 32]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`StripProblem::solve`].
    pub fn solutions(
        &self,
        cone: Cone,
        coarsest: usize,
        finest: usize,
    ) -> Result<Vec<EdgeSolution>> {
        let mut found: Vec<EdgeSolution> = Vec::new();
        let mut n = coarsest;
        while n <= finest {
            found.push(self.solve_from(n, cone, found.last())?);
            n *= 2;
        }
        Ok(found)
    }

    fn solve_from(
        &self,
        cells: usize,
        cone: Cone,
        start: Option<&EdgeSolution>,
    ) -> Result<EdgeSolution> {
        self.operator(cells)?.solve_contact(&self.load(cells)?, cone, start, SOLVED)
    }

    /// The edge operator A of the discrete problem on `cells` cells.
    ///
    /// ```
    /// use signorini::problems::StripData;
    /// use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};
    /// let data = StripData::transition().data(2.0, 16, LateralCondition::Natural)?;
    /// let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 4)?;
    /// // constants have the energy 1/H = 1 on every level
    /// assert!((problem.operator(8)?.energy(&[1.0; 9])? - 1.0).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 2 ≤ `cells` ≤ 2^26, in
    /// the elastic strip for a level that does not exist.
    pub fn operator(&self, cells: usize) -> Result<EdgeOperator> {
        match &self.exact {
            Exact::Scalar { .. } => Ok(Strip::scalar(cells, cells)?.operator),
            Exact::Elastic { matrices, .. } => {
                normal_operator(cells, &matrices[self.level(cells, matrices.len())?])
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
        let level = self.level(cells, self.loads.len())?;
        Ok(self.loads[level].clone())
    }

    /// The error |u − u_h|_a of a discrete solution.
    ///
    /// The value is the [`distance`](StripProblem::distance) of the computed edge values; its `error` is that of the
    /// distance plus the algebraic error of the solution, [`EdgeSolution::error`].
    ///
    /// # Errors
    /// As for [`StripProblem::distance`].
    pub fn error(&self, solution: &EdgeSolution) -> Result<Estimate> {
        let found = self.distance(solution.cells, &solution.values)?;
        Ok(Estimate::new(found.value, found.error + solution.error, found.work)?)
    }

    /// The distance |u − v|_a of the discrete harmonic function v with edge values `values` on `cells` cells. There is no
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
    /// let norm = problem.operator(16)?.energy(data.values())?.sqrt();
    /// assert!((problem.distance(8, &[0.0; 9])?.value - norm).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a level that does not exist,
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a wrong number of values.
    pub fn distance(&self, cells: usize, values: &[f64]) -> Result<Estimate> {
        let level = self.level(cells, self.levels())?;
        let sides = self.operator.sides();
        require_length("edge values", values.len(), sides.nodes(cells))?;
        let coarse = EdgeOperator::new(cells, sides, &vec![1.0; sides.period(cells) / 2 + 1])?;
        let (edge, interior, defects, points) = match &self.exact {
            Exact::Scalar { modes, defects } => {
                let discrete = coarse.modes(values)?;
                let interior = match defects {
                    Some(_) if level == 0 => 0.0,
                    Some(defects) => coarse.mode_sum(&discrete, |k| defects[level - 1][k]),
                    None => coarse.mode_sum(&discrete, |k| {
                        harmonic_defect(PI * k as f64 / cells as f64, cells as f64)
                    }),
                };
                let interpolated = self.interpolation.of(discrete);
                let symbol = self.operator.symbol();
                let edge = self
                    .operator
                    .mode_sum_of(|k| symbol[k] * (modes[k] - interpolated.mode(k)).norm_sqr());
                (edge, interior, SCALAR_DEFECTS, self.operator.cells() + 1)
            }
            Exact::Elastic { modes: [exact_x, exact_y], matrices, defects } => {
                let discrete = displacement(&coarse, &matrices[level], values)?;
                let interior = match level {
                    0 => 0.0,
                    _ => coarse.mode_sum_of(|k| {
                        defects[level - 1][k].form(discrete[0][k], discrete[1][k])
                    }),
                };
                let [x, y] = discrete.map(|component| self.interpolation.of(component));
                let edge = self.operator.mode_sum_of(|k| {
                    matrices[0][k].form(exact_x[k] - x.mode(k), exact_y[k] - y.mode(k))
                });
                (edge, interior, ELASTIC_DEFECTS, 2 * self.operator.cells())
            }
        };
        let norm = (edge + interior).sqrt();
        let work = Work { points: points as u64, ..Work::default() };
        Ok(Estimate::new(norm, self.rounding + defects * norm, work)?)
    }

    /// The number of levels: N, N/2, ... cells.
    fn levels(&self) -> usize {
        match &self.exact {
            Exact::Scalar { .. } => self.loads.len(),
            Exact::Elastic { matrices, .. } => matrices.len(),
        }
    }

    /// The number of halvings, less than `levels`, from N to `cells`.
    fn level(&self, cells: usize, levels: usize) -> Result<usize> {
        let range = "{N, N/2, N/4, ...}, N the number of cells of the reference grid";
        let level = (0..levels).find(|&level| self.operator.cells() >> level == cells);
        level.ok_or(Error::count("cells", cells, range))
    }
}

/// The load and its restrictions P'b, P'P'b, ... down to two cells.
pub(crate) fn pyramid(force: Vec<f64>, sides: LateralCondition) -> Vec<Vec<f64>> {
    let smallest = sides.nodes(2);
    let mut loads = vec![force];
    while let Some(last) = loads.last() {
        if last.len() <= smallest {
            break;
        }
        let coarse = restrict(last, sides);
        loads.push(coarse);
    }
    loads
}

/// G on N/2, N/4, ..., 2 cells against the square strip of N cells.
fn nested_defects(cells: usize) -> Vec<Vec<f64>> {
    let mut defects: Vec<Vec<f64>> = Vec::new();
    let mut n = cells / 2;
    while n >= 2 {
        let finer = defects.last();
        let level = (0..=n)
            .map(|k| {
                let theta = PI * k as f64 / n as f64;
                let own = halving(theta, n as f64);
                finer.map_or(own, |g| {
                    let (s, c) = (0.25 * theta).sin_cos();
                    own + 2.0 * (c.powi(4) * g[k] + s.powi(4) * g[2 * n - k])
                })
            })
            .collect();
        defects.push(level);
        n /= 2;
    }
    defects
}

/// The edge matrices on N, N/2, ... cells, not less than `coarsest`, and G on N/2, N/4, ... cells.
fn elastic_levels(
    cells: usize,
    lame: Lame,
    coarsest: usize,
) -> (Vec<Vec<EdgeMatrix>>, Vec<Vec<EdgeMatrix>>) {
    let mut matrices = vec![edge_matrices(cells, cells, lame)];
    let mut defects: Vec<Vec<EdgeMatrix>> = Vec::new();
    let mut n = cells / 2;
    while n >= coarsest.max(2) {
        let own = edge_matrices(n, n, lame);
        let mut defect = halvings(n, n, lame, &own, &matrices[matrices.len() - 1]);
        if let Some(finer) = defects.last() {
            for (k, d) in defect.iter_mut().enumerate() {
                *d = d.combine(1.0, aliased(k, n, finer), 1.0);
            }
        }
        defects.push(defect);
        matrices.push(own);
        n /= 2;
    }
    (matrices, defects)
}

/// The operator of u_N, with the tangential component condensed.
fn normal_operator(cells: usize, matrices: &[EdgeMatrix]) -> Result<EdgeOperator> {
    let symbol: Vec<f64> = matrices.iter().map(|a| a.normal()).collect();
    EdgeOperator::new(cells, LateralCondition::Periodic, &symbol)
}

/// Modes of (u_x, u_y) from u_N = −u_y without tangential force.
fn displacement(
    operator: &EdgeOperator,
    matrices: &[EdgeMatrix],
    normal: &[f64],
) -> Result<[Vec<Complex<f64>>; 2]> {
    let modes = operator.modes(normal)?;
    let mut x: Vec<Complex<f64>> =
        modes.iter().zip(matrices).map(|(u, a)| a.xy * u / a.xx).collect();
    // A real displacement has real zeroth and highest modes.
    if let [first, .., last] = &mut x[..] {
        (first.im, last.im) = (0.0, 0.0);
    }
    Ok([x, modes.iter().map(|v| -v).collect()])
}
