//! The default solver: condensation to the contact edge, active set method, recovery, one step of iterative
//! refinement.
//!
//! Refinement repeats recovery for the residual of the full system with the contact set held fixed; the
//! factorization is not repeated. It removes the rounding errors of the elimination from the balance of
//! forces.

use super::active_set::{EdgeOutcome, solve_on_edge};
use super::cascade;
use super::edge_problem::EdgeProblem;
use super::interior_point;
use super::problem::ContactProblem;
use super::solution::{ACCEPTED, Candidate, ContactSolution, Seconds, conclude, gap_of};
use super::solver::Solver;
use crate::cone::{Cone, ContactSet, EdgeCone};
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Condensation, Reduced};
use crate::numeric::scale::careful_dot;
use fractional_sobolev::Work;
use std::time::Instant;

impl ContactProblem {
    /// The function of least energy with the given normal displacement on the contact edge and 0 on Γ_D, Cartesian.
    ///
    /// Cost: a factorization.
    pub(crate) fn extension(&self, normal: &[f64]) -> Result<Vec<f64>> {
        let normals = self.normal_unknowns();
        let condensation =
            Condensation::new(self.matrix(), self.mesh.nodes(), &self.prescribed, &normals)?;
        let values: Vec<f64> = normals
            .iter()
            .zip(normal)
            .map(|(&unknown, &value)| if self.prescribed[unknown] { 0.0 } else { value })
            .collect();
        let none = condensation.reduce(&vec![0.0; self.unknowns()]);
        Ok(self.to_cartesian(&condensation.recover(&none, &values)))
    }

    /// J of Cartesian nodal values.
    pub(crate) fn energy_of(&self, displacement: &[f64]) -> f64 {
        let u = self.to_frame(displacement);
        0.5 * careful_dot(&u, &self.multiply(&u)) - careful_dot(&u, &self.load)
    }
}

/// The iterate and the data for its correction.
struct Condensed<'a> {
    problem: &'a ContactProblem,
    cone: EdgeCone,
    condensation: Condensation,
    normals: Vec<usize>,
    fixed: Vec<bool>,
    unknowns: Vec<f64>,
    multiplier: Vec<f64>,
}

/// Largest relative imbalance of the forces on a body without Dirichlet edge.
const BALANCED: f64 = 1e-8;

/// A body without Dirichlet edge whose floors cannot balance the load.
const NO_EQUILIBRIUM: &str = "a body without Dirichlet edge is not in equilibrium: its load must press it onto its floors, \
                              with a resultant that they can carry without friction";

/// The solution by the active set method from the given initial guess.
pub(super) fn solve(
    problem: &ContactProblem,
    cone: Cone,
    guess: ContactSet,
) -> Result<ContactSolution> {
    let off = || Error::Solver { reason: NO_EQUILIBRIUM.into() };
    let found = by_edge(problem, cone, |edge| match solve_on_edge(edge, guess) {
        // Too few constraints to keep the body in place: start from those of the interior point method.
        Err(Error::Toolkit(ToolkitError::NotPositiveDefinite { .. })) if problem.floats => {
            let set = interior_point::solve(problem, cone)?.contact_set;
            solve_on_edge(edge, set).map_err(|_| off())
        }
        found => found,
    })?;
    // Nearly singular equations of too few constraints show in the resultants.
    if problem.floats && found.balance > BALANCED { Err(off()) } else { Ok(found) }
}

/// The solution by the active set method, with an initial guess from coarser functions on the edge.
pub(super) fn solve_by_cascade(problem: &ContactProblem, cone: Cone) -> Result<ContactSolution> {
    by_edge(problem, cone, |edge| solve_on_edge(edge, cascade::guess(edge)?))
}

/// The solution by elimination, `on_edge` for the condensed problem, recovery, and a step of refinement.
fn by_edge(
    problem: &ContactProblem,
    cone: Cone,
    on_edge: impl FnOnce(&EdgeProblem<'_>) -> Result<EdgeOutcome>,
) -> Result<ContactSolution> {
    problem.matrix();
    let start = Instant::now();
    let mut iterate = Condensed::new(problem, cone)?;
    let factorization = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let (reduced, bound) = iterate.remainder()?;
    let edge = iterate.edge_problem(&reduced, &bound);
    let outcome = on_edge(&edge)?;
    let contact = start.elapsed().as_secs_f64();
    let start = Instant::now();
    iterate.add(&reduced, &outcome.state.displacement, &outcome.state.multiplier);
    let (reduced, bound) = iterate.remainder()?;
    let correction = iterate.edge_problem(&reduced, &bound).solve_with(&outcome.set)?;
    iterate.add(&reduced, &correction.displacement, &correction.multiplier);
    let iterations = outcome.steps.len() as u64;
    let mut solution = conclude(
        problem,
        cone,
        Candidate {
            solver: Solver::ActiveSet,
            unknowns: iterate.unknowns,
            multiplier: iterate.multiplier,
            contact_set: outcome.set,
            status: outcome.status,
            steps: outcome.steps,
            work: Work { iterations, factorizations: 1, ..Work::default() },
            accepted: ACCEPTED,
        },
    )?;
    // The energies of the steps are those of the edge: they differ from J by a constant.
    let interior = solution.energy - solution.steps.last().map_or(0.0, |last| last.energy);
    solution.steps.iter_mut().for_each(|step| step.energy += interior);
    let (assembly, recovery) = (problem.assembly_seconds(), start.elapsed().as_secs_f64());
    solution.seconds = Seconds { assembly, factorization, contact, recovery };
    Ok(solution)
}

impl<'a> Condensed<'a> {
    /// The problem condensed to its edge, before the first step.
    fn new(problem: &'a ContactProblem, cone: Cone) -> Result<Self> {
        let normals = problem.normal_unknowns();
        let cone = problem.edge_cone(cone);
        Ok(Self {
            condensation: Condensation::new(
                problem.matrix(),
                problem.mesh.nodes(),
                &problem.prescribed,
                &normals,
            )?,
            fixed: normals.iter().map(|&unknown| problem.prescribed[unknown]).collect(),
            unknowns: problem.values.clone(),
            multiplier: vec![0.0; cone.constraints()],
            problem,
            cone,
            normals,
        })
    }

    /// The residual F − K u − B'λ of the iterate, condensed to the edge, and the bounds on a correction of B u.
    fn remainder(&self) -> Result<(Reduced, Vec<f64>)> {
        let mut residual = self.problem.multiply(&self.unknowns);
        for (r, f) in residual.iter_mut().zip(&self.problem.load) {
            *r = f - *r;
        }
        let force = self.cone.apply_transposed(&self.multiplier)?;
        for (&unknown, force) in self.normals.iter().zip(force) {
            residual[unknown] -= force;
        }
        let normal: Vec<f64> = self.normals.iter().map(|&unknown| self.unknowns[unknown]).collect();
        let bound = gap_of(self.problem, self.cone, &normal).into_iter().map(|gap| -gap).collect();
        Ok((self.condensation.reduce(&residual), bound))
    }

    fn edge_problem<'b>(&'b self, reduced: &'b Reduced, bound: &'b [f64]) -> EdgeProblem<'b> {
        EdgeProblem {
            stiffness: self.condensation.schur(),
            load: reduced.kept(),
            bound,
            fixed: &self.fixed,
            cone: self.cone.kind(),
            ends: self.cone.ends(),
        }
    }

    fn add(&mut self, reduced: &Reduced, normal: &[f64], multiplier: &[f64]) {
        let change = self.condensation.recover(reduced, normal);
        self.unknowns.iter_mut().zip(change).for_each(|(u, d)| *u += d);
        self.multiplier.iter_mut().zip(multiplier).for_each(|(l, d)| *l += d);
    }
}
