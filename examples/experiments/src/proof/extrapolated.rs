//! The theorem with numbers beside the error of problems whose solution is not known.
//!
//! The solution on the finest of nested meshes stands for u. With errors C h^r, r = min(σ, 2) − 1 for u just
//! in H^σ, and |u − u_{2h}|² = |u − u_h|² + |u_h − u_{2h}|², its own error is δ = ρ (1 − ρ²)^{−1/2}
//! |u_h − u_{2h}|, ρ = 2^{−r}; that of a coarser mesh is (|u_h − u_H|² + δ²)^{1/2}, off by δ at most.
//! Orthogonality does not hold exactly for inequalities: an estimate. Norms: [`FineNorms`].

use super::fine_norms::{FineForms, FineNorms};
use crate::ErrorExt;
use fractional_sobolev::{Estimate, Work};
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Settings, Start};
use signorini::mesh::Hierarchy;
use signorini::problems::{PiecewiseLinearLoad, solution_regularity};
use signorini::proof::TheoremConstants;
use signorini::{Error, Result, ToolkitError};

/// n on the coarsest mesh.
const COARSEST: usize = 4;
/// Meshes from which norms are extrapolated.
const FINE: usize = 3;

/// A body solved on nested meshes.
pub struct SolvedBody {
    /// The body.
    pub body: PiecewiseLinearLoad,
    /// The supremum of the σ with u ∈ H^σ, from the exponents of its corners and transitions.
    pub smoothness: f64,
    hierarchy: Hierarchy,
    /// In the nodal cone, coarsest first.
    solved: Vec<(ContactProblem, ContactSolution)>,
    /// n and |u − u_h|_a on all meshes but the three finest, for each cone of the body.
    errors: Vec<Vec<(usize, Estimate)>>,
}

/// The bound on one mesh, and the extrapolated error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExtrapolatedRow {
    /// n; h = 1/n.
    pub n: usize,
    /// |u − u_h|_a.
    pub error: Estimate,
    /// The bound, from norms rounded up by their errors.
    pub bound: f64,
}

/// One body in one cone for one τ.
#[derive(Debug, Clone, PartialEq)]
pub struct ExtrapolatedStudy {
    /// The body.
    pub body: PiecewiseLinearLoad,
    /// The supremum of the σ with u ∈ H^σ.
    pub smoothness: f64,
    /// The cone.
    pub cone: Cone,
    /// Constants.
    pub numbers: TheoremConstants,
    /// Norms.
    pub norms: FineNorms,
    /// Coarsest mesh first.
    pub rows: Vec<ExtrapolatedRow>,
}

impl SolvedBody {
    /// Meshes of 4 × 4 ... 2^finest × 2^finest squares.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) unless 5 ≤ finest ≤ 10; [`ToolkitError::ToleranceNotMet`](signorini::ToolkitError::ToleranceNotMet) for a solution that does
    /// not meet its conditions; whatever problems and solvers return.
    pub fn new(body: PiecewiseLinearLoad, finest: u32) -> Result<Self> {
        if !(5..=10).contains(&finest) {
            let (name, value) = ("finest level", finest as usize);
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range: "[5, 10]" }));
        }
        let times = finest as usize - COARSEST.ilog2() as usize;
        let hierarchy = Hierarchy::refined(body.mesh(COARSEST)?, times)?;
        let solved = solve(body, &hierarchy, Cone::Nodal, times)?;
        let (problem, solution) = &solved[times];
        let smoothness = solution_regularity(problem, solution)?.tau;
        let mut found = Self { body, smoothness, hierarchy, solved, errors: Vec::new() };
        found.errors = body.cones().iter().map(|&cone| found.errors(cone)).collect::<Result<_>>()?;
        Ok(found)
    }

    /// Squares along each side of the three finest meshes, coarsest first.
    pub fn fine_grids(&self) -> [usize; FINE] {
        [2, 1, 0].map(|back| COARSEST << (self.finest() - back))
    }

    fn finest(&self) -> usize {
        self.solved.len() - 1
    }

    /// Norms for one τ, given the forms on [`SolvedBody::fine_grids`].
    ///
    /// # Errors
    /// As [`FineNorms::extrapolated`].
    pub fn norms(&self, tau: f64, forms: &[FineForms; FINE]) -> Result<FineNorms> {
        let mut squares = [[0.0; 3]; FINE];
        let fine = &self.solved[self.solved.len() - FINE..];
        for ((square, form), (problem, solution)) in squares.iter_mut().zip(forms).zip(fine) {
            *square = form.squares(problem, solution)?;
        }
        FineNorms::extrapolated(tau, self.smoothness, &squares)
    }

    fn errors(&self, cone: Cone) -> Result<Vec<(usize, Estimate)>> {
        let finest = self.finest();
        let other = match cone {
            Cone::Nodal => None,
            Cone::Midpoint => Some(solve(self.body, &self.hierarchy, cone, finest - FINE)?),
        };
        let (reference, fine) = &self.solved[finest];
        let apart = |level: usize, coarse: &ContactSolution| {
            let (coarse, fine) = ((level, &coarse.displacement[..]), (finest, &fine.displacement[..]));
            reference.nested_energy_error(&self.hierarchy, coarse, fine)
        };
        let ratio = (1.0 - self.smoothness.min(2.0)).exp2();
        let rest = apart(finest - 1, &self.solved[finest - 1].1)? * ratio / (1.0 - ratio * ratio).sqrt();
        let one = |level: usize| {
            let found = apart(level, &other.as_ref().unwrap_or(&self.solved)[level].1)?;
            Ok((COARSEST << level, Estimate::new(found.hypot(rest), rest, Work::default())?))
        };
        (0..=finest - FINE).map(one).collect()
    }
}

impl ExtrapolatedStudy {
    /// Bound and error on all meshes; `numbers` are those of the Laplacian.
    ///
    /// # Errors
    /// [`ToolkitError::Incompatible`](signorini::ToolkitError::Incompatible) for the midpoint cone and an elastic body that is not held all around.
    pub fn new(numbers: TheoremConstants, solved: &SolvedBody, cone: Cone, norms: FineNorms) -> Result<Self> {
        let body = solved.body;
        let Some(place) = body.cones().iter().position(|&known| known == cone) else {
            return Err(Error::Toolkit(ToolkitError::Incompatible {
                what: "body",
                given: body.to_string(),
                with: "the midpoint cone",
                expected: "displacements given on all of the boundary but the contact edge",
            }));
        };
        let numbers = body.lame()?.map_or(numbers, |lame| numbers.elastic(lame));
        let up = |estimate: Estimate| estimate.value + estimate.error;
        let [whole, pressure, slope] = [norms.body, norms.pressure, norms.slope].map(up);
        let row = |&(n, error): &(usize, Estimate)| {
            let h = 1.0 / n as f64;
            let smooth = numbers.interpolation * h.powf(numbers.tau - 1.0) * whole;
            ExtrapolatedRow { n, error, bound: numbers.bound(cone, h, smooth, pressure * slope, pressure) }
        };
        let rows = solved.errors[place].iter().map(row).collect();
        Ok(Self { body, smoothness: solved.smoothness, cone, numbers, norms, rows })
    }
}

/// All levels up to one, each from the contact set of the one before.
fn solve(
    body: PiecewiseLinearLoad,
    hierarchy: &Hierarchy,
    cone: Cone,
    last: usize,
) -> Result<Vec<(ContactProblem, ContactSolution)>> {
    let mut solved: Vec<(ContactProblem, ContactSolution)> = Vec::new();
    for mesh in &hierarchy.levels()[..=last] {
        let problem = body.on(mesh.clone())?;
        let start = solved.last().map_or(Start::Open, |(_, coarse)| Start::Coarse(coarse));
        let solution = problem.solve(cone, Settings { start, ..Settings::default() })?;
        if !solution.status.is_converged() {
            let reached = solution.kkt.worst();
            let why = "the active-set iteration did not converge";
            return Err(ToolkitError::out_of_reach("contact conditions", 1e-8, reached, why).into());
        }
        solved.push((problem, solution));
    }
    Ok(solved)
}
