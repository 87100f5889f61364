//! Quadratic programs min ½ x'K x − f'x over { B x ≤ g } by the interior point solver Clarabel.
//!
//! The program is scaled to unit stiffness and load. Clarabel's static regularisation is off (with it,
//! iterations stall at a relative accuracy near 1e-6; K is positive definite, so the factorization needs
//! none) and its refinement is tightened; 12 digits are reached in 11 to 16 steps.

use crate::cone::EdgeCone;
use crate::cone::Status;
use crate::error::{Error, Result};
use crate::numeric::scale::largest;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, SupportedConeT,
};

/// Relative feasibility tolerance of Clarabel.
const FEASIBILITY: f64 = 1e-14;

/// Relative duality gap tolerance of Clarabel, which may stop earlier for lack of progress; the result is checked
/// afterwards.
const DUALITY_GAP: f64 = 1e-13;

/// Without contact, forces below this multiple of the force scale are attributed to the barrier.
pub(super) const LEFT: f64 = 100.0 * DUALITY_GAP;

/// Disabled criteria: absolute gaps, which have no scale here, and infeasibility, since the problem has a
/// solution.
const NEVER: f64 = 1e-300;

/// Largest number of steps; 11 to 16 are typical.
const STEPS: u32 = 60;

/// Relative and absolute tolerance of iterative refinement: a small multiple of rounding, below the feasibility
/// tolerance.
const REFINED: f64 = 1e-15;

/// Largest number of refinements of a linear system; without regularisation a few suffice, except in the
/// last steps.
const REFINEMENTS: u32 = 20;

/// Refinement continues while it reduces the residual by this factor.
const HALVED: f64 = 2.0;

/// A single thread: the order of the sums, hence every digit, is the same on every machine.
const THREADS: u32 = 1;

/// A quadratic program; K is given by the upper triangle of its columns, divided by `stiff`, its largest diagonal
/// entry.
pub(super) struct Program {
    pub(super) upper: CscMatrix<f64>,
    pub(super) stiff: f64,
    pub(super) load: Vec<f64>,
    pub(super) rows: CscMatrix<f64>,
    pub(super) bound: Vec<f64>,
}

/// Clarabel's answer in the scaling of the program: x, and λ with K x + B'λ = f.
pub(super) struct Answer {
    pub(super) unknowns: Vec<f64>,
    pub(super) multiplier: Vec<f64>,
    pub(super) status: Status,
    pub(super) iterations: u64,
}

impl Program {
    /// The solution and the termination status, without residuals.
    pub(super) fn solve(&self) -> Result<Answer> {
        let force = largest(&self.load).max(self.stiff * largest(&self.bound));
        // Without unknowns, or without loads and with g ≥ 0, there is no force scale, and the solution is zero.
        if self.load.is_empty() || largest(&self.load) == 0.0 && self.bound.iter().all(|&bound| bound >= 0.0)
        {
            let (unknowns, multiplier) = (vec![0.0; self.load.len()], vec![0.0; self.bound.len()]);
            return Ok(Answer { unknowns, multiplier, status: Status::Converged, iterations: 0 });
        }
        let linear: Vec<f64> = self.load.iter().map(|f| -f / force).collect();
        let bound: Vec<f64> = self.bound.iter().map(|g| g / force * self.stiff).collect();
        let cones: [SupportedConeT<f64>; 1] = [NonnegativeConeT(bound.len())];
        let mut solver = DefaultSolver::new(&self.upper, &linear, &self.rows, &bound, &cones, settings())
            .map_err(|e| Error::Solver { reason: e.to_string() })?;
        solver.solve();
        let iterations = u64::from(solver.solution.iterations);
        let status = match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {
                Status::Converged
            }
            SolverStatus::MaxIterations => Status::StepLimit { steps: iterations as usize },
            _ => Status::Stalled { residual: f64::INFINITY },
        };
        Ok(Answer {
            unknowns: solver.solution.x.iter().map(|x| x * (force / self.stiff)).collect(),
            multiplier: solver.solution.z.iter().map(|z| z * force).collect(),
            status,
            iterations,
        })
    }
}

fn settings() -> DefaultSettings<f64> {
    DefaultSettings {
        verbose: false,
        max_iter: STEPS,
        tol_gap_abs: NEVER,
        tol_gap_rel: DUALITY_GAP,
        tol_feas: FEASIBILITY,
        tol_infeas_abs: NEVER,
        tol_infeas_rel: NEVER,
        static_regularization_enable: false,
        dynamic_regularization_enable: false,
        iterative_refinement_reltol: REFINED,
        iterative_refinement_abstol: REFINED,
        iterative_refinement_max_iter: REFINEMENTS,
        iterative_refinement_stop_ratio: HALVED,
        max_threads: THREADS,
        ..DefaultSettings::default()
    }
}

/// The rows of B of some constraints on the numbered unknowns, by columns; `normals` are the unknowns of the edge's
/// nodes.
pub(super) fn constraint_matrix(
    cone: EdgeCone,
    constraints: &[usize],
    normals: &[usize],
    number: &[Option<usize>],
    columns: usize,
) -> CscMatrix<f64> {
    let mut entries: Vec<(usize, usize)> = Vec::new();
    for (row, &i) in constraints.iter().enumerate() {
        entries.extend(cone.support(i).filter_map(|node| number[normals[node]]).map(|column| (column, row)));
    }
    entries.sort_unstable();
    let mut starts = vec![0; columns + 1];
    entries.iter().for_each(|&(column, _)| starts[column + 1] += 1);
    (0..columns).for_each(|j| starts[j + 1] += starts[j]);
    let rows: Vec<usize> = entries.iter().map(|&(_, row)| row).collect();
    let values = vec![cone.weight(); rows.len()];
    CscMatrix::new(constraints.len(), columns, starts, rows, values)
}
