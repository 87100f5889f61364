//! `section_2_speed_for_accuracy`: six solver variants on the manufactured solution, with run time, discretisation
//! error and algebraic error: the active set from no contact and from the contact set of the mesh before, the
//! interior-point method on the whole body and on its edge, and multigrid at two accuracies.

use fractional_sobolev::Tolerance;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, ContactSolution, Settings, Solver, Start};
use signorini::problems::KnownSolution;
use signorini::{Error, Result, ToolkitError};
use std::fmt;
use std::time::Instant;

/// Cells along each side up to which the interior-point method takes its turn.
const INTERIOR: usize = 128;
/// Algebraic error over the error of discretisation, for the second variant of multigrid.
const SHARE: f64 = 0.01;
/// Cells along each side up to which elimination takes its turn: some 4 GB at n = 1024 for two components.
const ELIMINATED: usize = 1024;

/// A way to a discrete solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolverVariant {
    /// The active set from no contact.
    Cold,
    /// The active set from the contact set of the mesh before.
    Nested,
    /// The interior-point method.
    Interior,
    /// The interior-point method on the problem condensed to the edge.
    Edge,
    /// Multigrid to the relative tolerance 1e-10.
    Multigrid,
    /// Multigrid to a hundredth of the error of discretisation.
    Share,
}

impl SolverVariant {
    /// All variants.
    pub const ALL: [SolverVariant; 6] = [
        SolverVariant::Cold,
        SolverVariant::Nested,
        SolverVariant::Interior,
        SolverVariant::Edge,
        SolverVariant::Multigrid,
        SolverVariant::Share,
    ];

    /// Whether the variant is run on n × n squares.
    fn is_taken(self, n: usize) -> bool {
        match self {
            SolverVariant::Cold | SolverVariant::Nested | SolverVariant::Edge => n <= ELIMINATED,
            SolverVariant::Interior => n <= INTERIOR,
            SolverVariant::Multigrid | SolverVariant::Share => true,
        }
    }
}

impl fmt::Display for SolverVariant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SolverVariant::Cold => "active set, cold",
            SolverVariant::Nested => "active set, nested",
            SolverVariant::Interior => "interior point",
            SolverVariant::Edge => "interior point, edge",
            SolverVariant::Multigrid => "multigrid, 1e-10",
            SolverVariant::Share => "multigrid, 1/100 of h",
        })
    }
}

/// One discrete solution on n × n squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VariantRow {
    /// n.
    pub n: usize,
    /// How it was found.
    pub road: SolverVariant,
    /// |u − u_h| in the H¹ seminorm.
    pub error: f64,
    /// The true algebraic error: the energy norm of the difference from the active set on the same mesh,
    /// relative; where that is too expensive, from multigrid to 1e-10; `None` for what it is measured from.
    pub algebraic: Option<f64>,
    /// The algebraic error as multigrid estimates it, relative.
    pub estimate: Option<f64>,
    /// For mesh, assembly, solution and KKT residuals.
    pub seconds: f64,
    /// Iterations.
    pub steps: usize,
    /// The worst scaled Karush-Kuhn-Tucker figure.
    pub kkt: f64,
}

/// [`KnownSolution::three_halves`] on n, 2n, ..., 2^{levels − 1} n squares along each side, coarsest first; on
/// the coarsest mesh there is no nested start, and where nothing coarser is left no multigrid; the interior
/// point goes to n = 128, elimination to n = 1024. `report` is called before each solution.
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`] unless 2 ≤ levels ≤ 9; whatever meshes, problems, solvers and `report` return.
pub fn manufactured_by_every_variant(
    n: usize,
    levels: usize,
    cone: Cone,
    mut report: impl FnMut(usize, SolverVariant) -> Result<()>,
) -> Result<Vec<VariantRow>> {
    if !(2..=9).contains(&levels) {
        return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
            name: "levels",
            value: levels,
            range: "[2, 9]",
        }));
    }
    let known = KnownSolution::three_halves();
    let (mut rows, mut coarse): (Vec<VariantRow>, Option<ContactSolution>) = (Vec::new(), None);
    for n in (0..levels).map(|level| n.saturating_mul(1 << level)) {
        let mut here: Option<ContactSolution> = None;
        for road in SolverVariant::ALL.into_iter().filter(|road| road.is_taken(n)) {
            report(n, road)?;
            let start = Instant::now();
            let problem = known.problem(n)?;
            let Some((solution, estimate)) = travel(road, &problem, cone, coarse.as_ref())? else { continue };
            let seconds = start.elapsed().as_secs_f64();
            let values = &solution.displacement;
            let error = known.error_norms(&problem, values)?.h1;
            let algebraic = match &here {
                Some(direct) if road != SolverVariant::Nested => Some(apart(&problem, &solution, direct)?),
                _ => None,
            };
            let (steps, kkt) = (solution.work.iterations as usize, solution.kkt.worst());
            rows.push(VariantRow { n, road, error, algebraic, estimate, seconds, steps, kkt });
            if matches!(road, SolverVariant::Cold | SolverVariant::Nested) || here.is_none() {
                here = Some(solution);
            }
        }
        coarse = here;
    }
    Ok(rows)
}

/// The solution and its estimated algebraic error, relative, where there is one; `None` where the road begins
/// later.
fn travel(
    road: SolverVariant,
    problem: &ContactProblem,
    cone: Cone,
    coarse: Option<&ContactSolution>,
) -> Result<Option<(ContactSolution, Option<f64>)>> {
    let multigrid = |accuracy| {
        let how = Settings { solver: Solver::Multigrid, accuracy, ..Settings::default() };
        let found = problem.solve(cone, how)?;
        let report = found.multigrid.clone().filter(|report| report.fallback.is_none());
        Ok(report.map(|report| (found, report.error.map(|error| error.relative_error()))))
    };
    let solution = match (road, coarse) {
        (SolverVariant::Multigrid, _) => return multigrid(Accuracy::Relative(Tolerance::new(1e-10)?)),
        (SolverVariant::Share, _) => return multigrid(Accuracy::OfDiscretisation(SHARE)),
        (SolverVariant::Nested, None) => return Ok(None),
        (SolverVariant::Nested, Some(coarse)) => {
            problem.solve(cone, Settings { start: Start::Coarse(coarse), ..Settings::default() })?
        }
        (SolverVariant::Cold, _) => problem.solve(cone, Solver::ActiveSet)?,
        (SolverVariant::Interior, _) => problem.solve(cone, Solver::InteriorPoint)?,
        (SolverVariant::Edge, _) => problem.solve(cone, Solver::EdgeInteriorPoint)?,
    };
    Ok(Some((solution, None)))
}

/// |u − v|_a / |v|_a.
fn apart(problem: &ContactProblem, u: &ContactSolution, v: &ContactSolution) -> Result<f64> {
    let difference: Vec<f64> = u.displacement.iter().zip(&v.displacement).map(|(a, b)| a - b).collect();
    Ok(problem.energy_norm(&difference)? / problem.energy_norm(&v.displacement)?)
}
