//! The second method: the full sparse quadratic program min ½ u'K u − F'u, B u ≤ g, by the interior point solver
//! Clarabel.
//!
//! It shares only the assembled matrix with the condensed active set method. The program is scaled to unit stiffness
//! and load. Clarabel's static regularisation is off (with it, iterations stall at a relative accuracy near 1e-6; K is
//! positive definite, so the factorization needs none) and its refinement is tightened; 12 digits are reached in 11 to
//! 16 steps.

use super::problem::ContactProblem;
use super::solution::{
    ACCEPTED, Candidate, ContactSolution, Seconds, conclude, force_scale, gap_of,
};
use super::solver::Solver;
use crate::cone::{Cone, ContactSet, EdgeCone, Status};
use crate::error::{Error, Result};
use crate::numeric::scale::largest;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, SupportedConeT,
};
use fractional_sobolev::Work;
use std::time::Instant;

/// Relative feasibility tolerance of Clarabel.
const FEASIBILITY: f64 = 1e-14;

/// Relative duality gap tolerance of Clarabel, which may stop earlier for lack of progress; the result is checked
/// afterwards.
const DUALITY_GAP: f64 = 1e-13;

/// Without contact, forces below this multiple of the force scale are attributed to the barrier.
const LEFT: f64 = 100.0 * DUALITY_GAP;

/// Largest relative imbalance of all forces. The KKT residuals are relative to |K||u| + |F|, which for Poisson's ratio
/// near 1/2 is so far above the loads that a residual of 1e-9 may leave nothing of the solution.
const BALANCED: f64 = 1e-3;

/// The same, in standard deviations of a sum of forces due to rounding.
const ROUNDINGS: f64 = 1e3;

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

/// The unknowns, and λ with K u + B'λ = F.
struct Answer {
    unknowns: Vec<f64>,
    multiplier: Vec<f64>,
    status: Status,
    iterations: u64,
}

pub(super) fn solve(problem: &ContactProblem, cone: Cone) -> Result<ContactSolution> {
    let start = Instant::now();
    let edge_cone = problem.edge_cone(cone);
    let mut answer = run(problem, edge_cone)?;
    let contact = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let normal: Vec<f64> =
        problem.normal_unknowns().into_iter().map(|unknown| answer.unknowns[unknown]).collect();
    let gap = gap_of(problem, edge_cone, &normal);
    let contact_set = dominant(problem, edge_cone, &answer, &gap);
    if contact_set.count() == 0
        && largest(&answer.multiplier) <= LEFT * force_scale(problem, &answer.unknowns)
    {
        // Without contact, small multipliers left by the barrier are set to zero; the balance verifies this.
        answer.multiplier.iter_mut().for_each(|l| *l = 0.0);
    }
    let mut solution = conclude(
        problem,
        cone,
        Candidate {
            solver: Solver::InteriorPoint,
            unknowns: answer.unknowns,
            multiplier: answer.multiplier,
            contact_set,
            status: answer.status,
            steps: Vec::new(),
            work: Work {
                iterations: answer.iterations,
                factorizations: answer.iterations,
                ..Work::default()
            },
            accepted: ACCEPTED,
        },
    )?;
    if let Status::Stalled { residual } = &mut solution.status {
        *residual = solution.kkt.worst();
    }
    let loads = problem.load.iter().map(|force| force.abs()).sum::<f64>();
    let forces = [solution.contact_force, solution.reaction[0], solution.reaction[1]];
    let rounding =
        solution.force_rounding / forces.iter().fold(loads, |most, force| most.max(force.abs()));
    if solution.status.is_converged() && solution.balance > BALANCED.max(ROUNDINGS * rounding) {
        solution.status = Status::Stalled { residual: solution.balance };
    }
    solution.seconds = Seconds {
        assembly: problem.assembly_seconds(),
        contact,
        recovery: start.elapsed().as_secs_f64(),
        factorization: 0.0,
    };
    Ok(solution)
}

/// The active constraints: those whose multiplier exceeds the gap times the stiffness at the nodes of the constraint.
/// One of the two tends to zero, so that their ratio is far from 1 and the precise stiffness is irrelevant.
fn dominant(problem: &ContactProblem, cone: EdgeCone, answer: &Answer, gap: &[f64]) -> ContactSet {
    let normals = problem.normal_unknowns();
    let stiff =
        |i: usize| cone.support(i).map(|node| problem.diagonal(normals[node])).fold(0.0, f64::max);
    ContactSet::new(
        &(0..gap.len()).map(|i| answer.multiplier[i] > stiff(i) * gap[i].abs()).collect::<Vec<_>>(),
    )
}

/// The quadratic program on the free unknowns; constraints without a free node are left out.
fn run(problem: &ContactProblem, cone: EdgeCone) -> Result<Answer> {
    let free: Vec<usize> = (0..problem.unknowns()).filter(|&i| !problem.prescribed[i]).collect();
    let mut number = vec![None; problem.unknowns()];
    free.iter().enumerate().for_each(|(k, &unknown)| number[unknown] = Some(k));
    let imposed = problem.multiply(&problem.values);
    let load: Vec<f64> = free.iter().map(|&i| problem.load[i] - imposed[i]).collect();
    let normals = problem.normal_unknowns();
    let constraints: Vec<usize> = (0..cone.constraints())
        .filter(|&i| cone.support(i).any(|node| number[normals[node]].is_some()))
        .collect();
    let fixed_part: Vec<f64> = normals.iter().map(|&unknown| problem.values[unknown]).collect();
    let gap = gap_of(problem, cone, &fixed_part);
    let bound: Vec<f64> = constraints.iter().map(|&i| -gap[i]).collect();
    let mut unknowns = problem.values.clone();
    let mut multiplier = vec![0.0; cone.constraints()];
    // Without unknowns, or without loads and with g ≥ 0, there is no force scale, and the solution is zero.
    if load.is_empty() || largest(&load) == 0.0 && bound.iter().all(|&bound| bound >= 0.0) {
        return Ok(Answer { unknowns, multiplier, status: Status::Converged, iterations: 0 });
    }
    let stiff = free.iter().map(|&i| problem.matrix().diagonal(i)).fold(0.0, f64::max);
    let upper = upper_triangle(problem, &free, &number, stiff);
    let rows = constraint_matrix(cone, &constraints, &normals, &number, free.len());
    let force = largest(&load).max(stiff * largest(&bound));
    let linear: Vec<f64> = load.iter().map(|f| -f / force).collect();
    let bound: Vec<f64> = bound.iter().map(|g| g / force * stiff).collect();
    let cones: [SupportedConeT<f64>; 1] = [NonnegativeConeT(bound.len())];
    let mut solver = DefaultSolver::new(&upper, &linear, &rows, &bound, &cones, settings())
        .map_err(|e| Error::Solver { reason: e.to_string() })?;
    solver.solve();
    let found = &solver.solution;
    free.iter().zip(&found.x).for_each(|(&unknown, x)| unknowns[unknown] += x * (force / stiff));
    constraints.iter().zip(&found.z).for_each(|(&i, z)| multiplier[i] = z * force);
    let status = match found.status {
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {
            Status::Converged
        }
        SolverStatus::MaxIterations => Status::StepLimit { steps: found.iterations as usize },
        _ => Status::Stalled { residual: f64::INFINITY },
    };
    Ok(Answer { unknowns, multiplier, status, iterations: u64::from(found.iterations) })
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

/// The upper triangle of K / `stiff` on the free unknowns, by columns.
fn upper_triangle(
    problem: &ContactProblem,
    free: &[usize],
    number: &[Option<usize>],
    stiff: f64,
) -> CscMatrix<f64> {
    let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for (column, &unknown) in free.iter().enumerate() {
        // K is symmetric: row `unknown` is column `unknown`.
        for (other, value) in problem.matrix().row(unknown) {
            if let Some(row) = number[other].filter(|&row| row <= column) {
                rows.push(row);
                values.push(value / stiff);
            }
        }
        starts.push(rows.len());
    }
    CscMatrix::new(free.len(), free.len(), starts, rows, values)
}

/// The rows of B of some constraints on the numbered unknowns, by columns; `normals` are the unknowns of the edge's
/// nodes.
fn constraint_matrix(
    cone: EdgeCone,
    constraints: &[usize],
    normals: &[usize],
    number: &[Option<usize>],
    columns: usize,
) -> CscMatrix<f64> {
    let mut entries: Vec<(usize, usize)> = Vec::new();
    for (row, &i) in constraints.iter().enumerate() {
        entries.extend(
            cone.support(i).filter_map(|node| number[normals[node]]).map(|column| (column, row)),
        );
    }
    entries.sort_unstable();
    let mut starts = vec![0; columns + 1];
    entries.iter().for_each(|&(column, _)| starts[column + 1] += 1);
    (0..columns).for_each(|j| starts[j + 1] += starts[j]);
    let rows: Vec<usize> = entries.iter().map(|&(_, row)| row).collect();
    let values = vec![cone.weight(); rows.len()];
    CscMatrix::new(constraints.len(), columns, starts, rows, values)
}
