//! The second road: the full sparse quadratic program min ½ u'K u − F'u, B u ≤ g, by the interior point
//! method Clarabel.
//!
//! Nothing is shared with the condensed active set except the assembled matrix. The program is scaled to unit
//! stiffness and load. Clarabel's static regularisation is off (with it, iterations end near 1e-6; K is
//! positive definite, so the factorization needs none) and its refinement is tightened; this reaches 12
//! digits in 11-16 steps.

use super::problem::ContactProblem;
use super::solution::{ACCEPTED, Candidate, ContactSolution, Seconds, conclude, force_scale, gap_of};
use super::solver::Solver;
use crate::cone::{Cone, ContactSet, EdgeCone, Status};
use crate::error::{Error, Result};
use crate::estimate::Work;
use crate::numeric::scale::largest;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, SupportedConeT,
};
use std::time::Instant;

/// Asked of Clarabel for feasibility, relative.
const FEASIBILITY: f64 = 1e-14;

/// Asked of Clarabel for the duality gap, relative; it may stop earlier when it cannot progress, and is
/// judged then.
const DUALITY_GAP: f64 = 1e-13;

/// Not asked: absolute gaps have no scale here, and a problem with a solution is never to be called
/// infeasible.
const NEVER: f64 = 1e-300;

/// Most steps: 11 to 16 are taken, and what has not ended after several times as many does not.
const STEPS: u32 = 60;

/// Asked of the refinement of each linear system, relative and absolute: a few roundings, below what is asked
/// for feasibility.
const REFINED: f64 = 1e-15;

/// Most refinements of a linear system: without regularisation a few reach rounding, the last steps take
/// more.
const REFINEMENTS: u32 = 20;

/// Refinement goes on while it at least halves the residual: less is rounding.
const HALVED: f64 = 2.0;

/// One thread: the order of the sums, hence every digit, is the same on every machine.
const THREADS: u32 = 1;

/// Where nothing is in contact, forces below this multiple of the force scale are what the barrier leaves.
const LEFT: f64 = 100.0 * DUALITY_GAP;

/// Clarabel's answer in the scaling of the problem.
struct Answer {
    unknowns: Vec<f64>,
    multiplier: Vec<f64>,
    status: SolverStatus,
    iterations: u64,
}

pub(super) fn solve(problem: &ContactProblem, cone: Cone) -> Result<ContactSolution> {
    let start = Instant::now();
    let mut answer = run(problem, problem.edge_cone(cone))?;
    let contact = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let edge_cone = problem.edge_cone(cone);
    let normal: Vec<f64> =
        problem.normal_unknowns().into_iter().map(|unknown| answer.unknowns[unknown]).collect();
    let gap = gap_of(problem, edge_cone, &normal);
    let contact_set = dominant(problem, edge_cone, &answer, &gap);
    if contact_set.count() == 0
        && largest(&answer.multiplier) <= LEFT * force_scale(problem, &answer.unknowns)
    {
        // No force beside it for it to be small against; the balance shows it.
        answer.multiplier.iter_mut().for_each(|l| *l = 0.0);
    }
    let status = match answer.status {
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {
            Status::Converged
        }
        SolverStatus::MaxIterations => Status::StepLimit { steps: answer.iterations as usize },
        _ => Status::Stalled { residual: f64::INFINITY },
    };
    let mut solution = conclude(
        problem,
        cone,
        Candidate {
            solver: Solver::InteriorPoint,
            unknowns: answer.unknowns,
            multiplier: answer.multiplier,
            contact_set,
            status,
            history: Vec::new(),
            work: Work {
                iterations: answer.iterations,
                factorizations: answer.iterations,
                ..Work::default()
            },
            seconds: Seconds::default(),
            accepted: ACCEPTED,
        },
    )?;
    if let Status::Stalled { residual } = &mut solution.status {
        *residual = solution.judgement.worst();
    }
    solution.seconds = Seconds {
        assembly: problem.assembly_seconds(),
        contact,
        recovery: start.elapsed().as_secs_f64(),
        factorization: 0.0,
    };
    Ok(solution)
}

/// Active: where the multiplier exceeds the gap times the stiffness at the nodes of the constraint. On the
/// way to the solution one of the two vanishes, so that their quotient is far from 1, whatever the stiffness
/// is to a few digits.
fn dominant(problem: &ContactProblem, cone: EdgeCone, answer: &Answer, gap: &[f64]) -> ContactSet {
    let normals = problem.normal_unknowns();
    let stiff = |i: usize| cone.support(i).map(|node| problem.diagonal(normals[node])).fold(0.0, f64::max);
    ContactSet::new((0..gap.len()).map(|i| answer.multiplier[i] > stiff(i) * gap[i].abs()).collect())
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
    let stiff = free.iter().map(|&i| problem.matrix().diagonal(i)).fold(0.0, f64::max);
    let force = largest(&load).max(stiff * largest(&gap));
    // Nothing to move, or nothing that moves it: no scale of forces for the solver to work in, and nothing to
    // solve.
    if free.is_empty() || largest(&load) == 0.0 && gap.iter().all(|&gap| gap <= 0.0) {
        let multiplier = vec![0.0; cone.constraints()];
        let (unknowns, status) = (problem.values.clone(), SolverStatus::Solved);
        return Ok(Answer { unknowns, multiplier, status, iterations: 0 });
    }
    let upper = upper_triangle(problem, &free, &number, stiff);
    let rows = constraint_matrix(cone, &constraints, &normals, &number, free.len());
    let linear: Vec<f64> = load.iter().map(|f| -f / force).collect();
    let bound: Vec<f64> = constraints.iter().map(|&i| -gap[i] / force * stiff).collect();
    let cones: [SupportedConeT<f64>; 1] = [NonnegativeConeT(constraints.len())];
    let mut solver = DefaultSolver::new(&upper, &linear, &rows, &bound, &cones, settings())
        .map_err(|e| Error::Solver { reason: e.to_string() })?;
    solver.solve();
    let mut unknowns = problem.values.clone();
    for (&unknown, value) in free.iter().zip(&solver.solution.x) {
        unknowns[unknown] += value * (force / stiff);
    }
    let mut multiplier = vec![0.0; cone.constraints()];
    for (&i, value) in constraints.iter().zip(&solver.solution.z) {
        multiplier[i] = value * force;
    }
    Ok(Answer {
        unknowns,
        multiplier,
        status: solver.solution.status,
        iterations: u64::from(solver.solution.iterations),
    })
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

/// B on the free unknowns, by columns.
fn constraint_matrix(
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
