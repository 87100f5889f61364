//! The requested accuracy of the multigrid solver, its progress, and its report.

use fractional_sobolev::{Estimate, Tolerance};
use std::fmt;

/// The requested accuracy of a discrete solution.
///
/// It is compared with the error estimate |u_h − ũ|_a ≤ R/2 + (R²/4 + C)^{1/2}, R the dual norm of F − K ũ − B'λ⁺ and
/// C = λ⁺'(g − B ũ) ≥ 0, ũ an approximation in the cone, λ⁺ the positive part of the multipliers.
///
/// ```
/// use signorini::contact::{Accuracy, Settings, Solver};
/// use signorini::{cone::Cone, problems::TestProblem};
/// let problem = TestProblem::Membrane.problem(16)?;
/// let exact = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
/// let accuracy = Accuracy::OfDiscretisation(0.1);
/// let settings = Settings { solver: Solver::Multigrid, accuracy, ..Settings::default() };
/// let found = problem.solve(Cone::Nodal, settings)?;
/// // u_h minimises J over the cone: the energy of an admissible approximation is not smaller
/// assert!(found.energy >= exact.energy - 1e-6 * exact.energy.abs());
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// The algebraic error as a fraction of the discretisation error, which is estimated from the coarser levels;
    /// higher accuracy does not improve the approximation of the continuous solution.
    OfDiscretisation(f64),
    /// The algebraic error relative to the solution, both in the energy norm. Down to 1e-12, an error at the level of
    /// the rounding errors in F − K u is accepted, as for elimination: 4e-12 for n = 1024, 6e-12 for n = 2048. If a
    /// smaller tolerance is not met, the report says so.
    Relative(Tolerance),
}

impl Default for Accuracy {
    /// A relative error of 1e-12.
    fn default() -> Self {
        Accuracy::Relative(Tolerance::reference())
    }
}

/// The progress of the multigrid iteration.
///
/// Levels are counted from the first one above the coarsest; `error` is an estimate of |u − x|_a, x the
/// iterate and u the solution of the linear problem for the current contact set.
///
/// ```
/// use signorini::contact::{Progress, Settings, Solver};
/// use signorini::{cone::Cone, problems::TestProblem};
/// let mut unknowns = Vec::new();
/// let mut observe = |step: &Progress| Ok(unknowns.push(step.unknowns));
/// let settings = Settings { solver: Solver::Multigrid, progress: Some(&mut observe), ..Settings::default() };
/// TestProblem::Membrane.problem(16)?.solve(Cone::Nodal, settings)?;
/// // nested iteration goes from coarse to fine
/// assert!(unknowns.windows(2).all(|pair| pair[0] <= pair[1]));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// The level, from 1.
    pub level: usize,
    /// The number of levels, the coarsest included.
    pub levels: usize,
    /// Number of unknowns of the level.
    pub unknowns: usize,
    /// The step of the contact iteration on that level, starting at 1.
    pub step: usize,
    /// The estimated error in the energy norm.
    pub error: f64,
}

/// The reason for using the direct solver.
///
/// The solution is then that of [`Solver::ActiveSet`](crate::contact::Solver::ActiveSet), with the KKT residuals of
/// that method.
///
/// ```
/// use signorini::{cone::Cone, contact::{Fallback, Solver}, fem::{Form, Lame}};
/// use signorini::{contact::ContactProblem, mesh::{SideParts, unit_square}};
/// // λ/μ = 2ν/(1 − 2ν) = 499 at ν = 0.499
/// let form = Form::elastic(Lame::plane_strain(1.0, 0.499)?);
/// let load: Vec<f64> = (0..162).map(|i| if i % 2 == 1 { -1.0 } else { 0.0 }).collect();
/// let problem = ContactProblem::new(unit_square(8, SideParts::HANGING)?, form, &load)?;
/// let report = problem.solve(Cone::Nodal, Solver::Multigrid)?.multigrid;
/// assert_eq!(report.and_then(|report| report.fallback), Some(Fallback::NearlyIncompressible));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fallback {
    /// The contact edge has several pieces.
    SeveralEdges,
    /// The midpoint cone on a closed edge, for which the V-cycle is not implemented.
    ClosedEdge,
    /// There are no coarser meshes: neither a hierarchy nor a grid that can be coarsened.
    NoLevels,
    /// λ/μ is above 100, where cycles with point smoothers converge very slowly.
    NearlyIncompressible,
    /// Multigrid did not reach the requested accuracy.
    NotReached,
}

pub(super) const MOST_INCOMPRESSIBLE: f64 = 100.0;

impl fmt::Display for Fallback {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Fallback::SeveralEdges => "direct solver: contact edge in several pieces",
            Fallback::ClosedEdge => "direct solver: midpoint cone on a closed edge",
            Fallback::NoLevels => "direct solver: no coarser meshes",
            Fallback::NearlyIncompressible => "direct solver: nearly incompressible material",
            Fallback::NotReached => "direct solver: requested accuracy not reached by multigrid",
        })
    }
}

/// Statistics of one level.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// let found = TestProblem::Membrane.problem(32)?.solve(Cone::Nodal, Solver::Multigrid)?;
/// let levels = found.multigrid.map(|report| report.levels).unwrap_or_default();
/// // about four times as many unknowns from level to level, convergence factors below 1
/// assert!(levels.windows(2).all(|pair| pair[1].unknowns > 3 * pair[0].unknowns));
/// assert!(levels.iter().all(|level| level.factor < 1.0));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultigridLevel {
    /// Number of unknowns, prescribed ones included.
    pub unknowns: usize,
    /// Number of contact sets tried, each with one linear system on this level.
    pub steps: usize,
    /// Number of conjugate gradient steps, each with one V-cycle.
    pub gradient_steps: usize,
    /// The convergence factor 1 − κ of one V-cycle, κ the smallest eigenvalue of the preconditioned matrix, estimated
    /// from the coefficients of the conjugate gradients.
    pub factor: f64,
    /// The estimated algebraic error in the energy norm.
    pub error: f64,
    /// The estimated discretisation error in the energy norm; `None` on the first levels, and if the energy
    /// did not decrease.
    pub discretisation: Option<f64>,
    /// Wall-clock time in seconds.
    pub seconds: f64,
}

/// The report of the multigrid solver.
///
/// ```
/// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
/// let problem = TestProblem::Membrane.problem(32)?;
/// let found = problem.solve(Cone::Nodal, Solver::Multigrid)?;
/// let Some(norm) = found.multigrid.and_then(|report| report.error) else { panic!("no levels") };
/// // the value is |u_h|_a itself
/// assert!((norm.value - problem.energy_norm(&found.displacement)?).abs() < 1e-9 * norm.value);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct MultigridReport {
    /// The energy norm |u_h|_a, with the estimated error of u_h in the same norm; `None` for the direct solver.
    pub error: Option<Estimate>,
    /// The estimated discretisation error on the finest level in the energy norm; `None` without an estimate
    /// or for the direct solver.
    pub discretisation: Option<f64>,
    /// Number of contact sets tried on the coarsest mesh, or on the mesh itself if the direct solver was used, each with
    /// one direct solve. The initial guess comes from the problem with coarser trial functions on the contact edge.
    pub coarsest_steps: usize,
    /// The levels above the coarsest one.
    pub levels: Vec<MultigridLevel>,
    /// The reason for using the direct solver, if it was used.
    pub fallback: Option<Fallback>,
}
