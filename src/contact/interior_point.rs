//! The second method: the full sparse quadratic program min ½ u'K u − F'u, B u ≤ g, by the interior point
//! solver Clarabel.
//!
//! It shares only the assembled matrix with the condensed active set method.

use super::problem::ContactProblem;
use super::program::{Answer, LEFT, Program, constraint_matrix};
use super::solution::{ACCEPTED, Candidate, ContactSolution, Seconds, conclude, force_scale, gap_of};
use super::solver::Solver;
use crate::cone::{Cone, ContactSet, EdgeCone, Status};
use crate::error::Result;
use crate::numeric::scale::largest;
use clarabel::algebra::CscMatrix;
use fractional_sobolev::Work;
use std::time::Instant;

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
        *residual = solution.kkt.worst();
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
    let stiff = |i: usize| cone.support(i).map(|node| problem.diagonal(normals[node])).fold(0.0, f64::max);
    ContactSet::new(
        &(0..gap.len()).map(|i| answer.multiplier[i] > stiff(i) * gap[i].abs()).collect::<Vec<_>>(),
    )
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
    let upper = upper_triangle(problem, &free, &number, stiff);
    let rows = constraint_matrix(cone, &constraints, &normals, &number, free.len());
    let bound = constraints.iter().map(|&i| -gap[i]).collect();
    let answer = Program { upper, stiff, load, rows, bound }.solve()?;
    let mut unknowns = problem.values.clone();
    free.iter().zip(&answer.unknowns).for_each(|(&unknown, value)| unknowns[unknown] += value);
    let mut multiplier = vec![0.0; cone.constraints()];
    constraints.iter().zip(&answer.multiplier).for_each(|(&i, &value)| multiplier[i] = value);
    Ok(Answer { unknowns, multiplier, ..answer })
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
