//! Nested iteration: contact on the coarsest mesh by the direct solver, then on each level starting from the coarser
//! one.

use super::super::condensed;
use super::super::problem::ContactProblem;
use super::super::solution::{Candidate, ContactSolution, Seconds, conclude};
use super::super::solver::Solver;
use super::accuracy::{Accuracy, MultigridLevel, MultigridReport, Progress};
use super::chain::Chain;
use super::coarsest::Coarsest;
use super::cycle::Cycle;
use super::discretisation::Discretisation;
use super::grid_level::GridLevel;
use super::level::Level;
use super::newton::{Goal, Guess, Outcome, STEPS, Stage};
use super::sparse_level::SparseLevel;
use crate::cone::Cone;
use crate::error::{Error, Result};
use crate::fem::Stencils;
use crate::numeric::parallel;
use fractional_sobolev::{Estimate, Tolerance, Work};
use rayon::prelude::*;
use std::time::Instant;

/// Ratio of the algebraic error and the estimated discretisation error on all levels but the last.
const ON_THE_WAY: f64 = 0.02;
/// Ratio of the algebraic error and the initial error if there is no estimate yet.
const AT_FIRST: f64 = 0.02;

/// Largest number of unknowns of a level on which elimination is used if the set of the midpoint cone was not found
/// by signs in this many steps: n = 64, milliseconds, and n = 256, some tenths of a second.
const ELIMINATED: [(usize, usize); 2] = [(10_000, 2), (140_000, 6)];

/// Factor between the largest residual explained by an error and the largest one accepted.
const SPARE: f64 = 10.0;

/// The callback invoked after every step.
pub(super) type Observer<'o> = dyn FnMut(&Progress) -> Result<()> + Send + 'o;

/// Solves the problem on all levels of a nonempty chain.
pub(super) fn solve(
    problem: &ContactProblem,
    chain: &Chain,
    cone: Cone,
    accuracy: Accuracy,
    observe: &mut Observer<'_>,
) -> Result<ContactSolution> {
    let problems: Vec<&ContactProblem> = chain.problems.iter().chain([problem]).collect();
    let stencils: Option<Vec<&Stencils>> =
        problems.iter().map(|problem| problem.stencils()).collect();
    let job = Job { problems: &problems, chain, cone, accuracy };
    match (stencils, problem.form.components()) {
        (Some(stencils), 1) => {
            job.run(&stencils.into_iter().map(GridLevel::<1>::new).collect::<Vec<_>>(), observe)
        }
        (Some(stencils), _) => {
            job.run(&stencils.into_iter().map(GridLevel::<2>::new).collect::<Vec<_>>(), observe)
        }
        (None, 1) => job.run(&job.sparse::<1>(), observe),
        (None, _) => job.run(&job.sparse::<2>(), observe),
    }
}

struct Job<'a> {
    problems: &'a [&'a ContactProblem],
    chain: &'a Chain,
    cone: Cone,
    accuracy: Accuracy,
}

impl<'a> Job<'a> {
    fn sparse<const C: usize>(&self) -> Vec<SparseLevel<'a, C>> {
        let none = [Vec::new()];
        let parents = none.iter().chain(&self.chain.parents);
        self.problems
            .iter()
            .zip(parents)
            .map(|(p, parents)| SparseLevel::new(p.matrix(), parents.clone()))
            .collect()
    }

    fn run<L: Level>(&self, levels: &[L], observe: &mut Observer<'_>) -> Result<ContactSolution> {
        let start = Instant::now();
        let last = levels.len() - 1;
        let mut coarsest = Coarsest::new(self.problems[0])?;
        let condensed = coarsest.condensed_share(self.problems[0]);
        let first = condensed::solve_by_cascade(self.problems[0], self.cone)?;
        let factorization = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let places: Vec<usize> =
            (0..levels[0].unknowns()).map(|unknown| levels[0].place(unknown)).collect();
        let mut x = vec![0.0; places.len()];
        let framed = self.problems[0].to_frame(&first.displacement);
        framed.into_iter().zip(&places).for_each(|(value, &place)| x[place] = value);
        let mut discretisation = Discretisation::new(first.energy);
        let mut reports: Vec<MultigridLevel> = Vec::new();
        let mut outcome = None;
        let (mut set, mut least) = (first.contact_set, 1.0);
        for k in 1..=last {
            let begun = Instant::now();
            let goal = self.goal(k == last, &discretisation);
            let link = &self.chain.links[k - 1];
            let guess =
                link.refined(self.cone, self.problems[k].edge_cone(self.cone).constraints(), &set);
            x = prolonged(&levels[k], self.problems[k], &x);
            let links = &self.chain.links[..k];
            let mut cycle =
                Cycle::new(&levels[..=k], &self.problems[..=k], links, &mut coarsest, &places);
            let unknowns = levels[k].unknowns();
            let mut report = |step: usize, error: f64| {
                observe(&Progress { level: k, levels: last + 1, unknowns, step, error })
            };
            let elimination = ELIMINATED.iter().find(|(most, _)| unknowns <= *most);
            let patience =
                elimination.filter(|_| self.cone == Cone::Midpoint).map(|(_, steps)| *steps);
            let mut stage =
                Stage::new(self.problems[k], &levels[k], &mut cycle, self.cone, (least, condensed));
            stage.guess = Guess::Signs(patience.unwrap_or(STEPS));
            let is_usual = |t: Tolerance| t.relative() >= Tolerance::reference().relative();
            if k == last && matches!(self.accuracy, Accuracy::Relative(t) if is_usual(t)) {
                stage.floor = rounding(self.problems[k], &node_major(&levels[k], &x));
            }
            let mut here = stage.solve(&mut x, guess, goal, &mut report)?;
            if patience.is_some() && !here.status.is_converged() {
                let direct = condensed::solve(self.problems[k], self.cone, here.set)?;
                stage.guess = Guess::Known;
                let next = stage.solve(&mut x, direct.contact_set, goal, &mut report)?;
                let gradient_steps = here.gradient_steps + next.gradient_steps;
                let history = [here.history, next.history].concat();
                here = Outcome { history, gradient_steps, ..next };
            }
            discretisation.add(here.energy);
            reports.push(MultigridLevel {
                unknowns,
                steps: here.history.len(),
                gradient_steps: here.gradient_steps,
                factor: 1.0 - here.least,
                error: here.error,
                discretisation: discretisation.here(),
                seconds: begun.elapsed().as_secs_f64(),
            });
            least = here.least;
            set = here.set.clone();
            outcome = Some(here);
        }
        let Some(outcome) = outcome else {
            return Err(Error::count("levels", levels.len(), "[2, inf)"));
        };
        let unknowns = node_major(&levels[last], &x);
        self.conclude(
            unknowns,
            outcome,
            (first.steps.len(), reports),
            Seconds {
                assembly: self.problems.iter().map(|problem| problem.assembly_seconds()).sum(),
                factorization,
                contact: start.elapsed().as_secs_f64(),
                recovery: 0.0,
            },
        )
    }

    fn conclude(
        &self,
        unknowns: Vec<f64>,
        outcome: Outcome,
        (coarsest_steps, levels): (usize, Vec<MultigridLevel>),
        seconds: Seconds,
    ) -> Result<ContactSolution> {
        let start = Instant::now();
        let problem = self.problems[self.problems.len() - 1];
        let iterations = levels.iter().map(|level| level.gradient_steps as u64).sum();
        let work = Work { iterations, factorizations: 1, ..Work::default() };
        let error = outcome.error + rounding(problem, &unknowns);
        // (K e)_i² ≤ K_ii |e|_a² and |u|_a² ≤ N max|u| max(|K||u| + |F|): an error of this size leaves a residual below √N times
        // this fraction of the terms. A larger residual means that the cycle is not a suitable preconditioner.
        let share = if outcome.norm > 0.0 { error / outcome.norm } else { 0.0 };
        let accepted = SPARE * (unknowns.len() as f64).sqrt() * share.max(f64::EPSILON);
        let solution = conclude(
            problem,
            self.cone,
            Candidate {
                solver: Solver::Multigrid,
                unknowns,
                multiplier: outcome.multiplier,
                contact_set: outcome.set,
                status: outcome.status,
                steps: Vec::new(),
                work,
                accepted,
            },
        )?;
        let error = Estimate::new(outcome.norm, error, work)?;
        let discretisation = levels.last().and_then(|level| level.discretisation);
        let report = MultigridReport {
            error: Some(error),
            discretisation,
            coarsest_steps,
            levels,
            fallback: None,
        };
        let seconds = Seconds { recovery: start.elapsed().as_secs_f64(), ..seconds };
        Ok(ContactSolution { seconds, multigrid: Some(report), ..solution })
    }

    fn goal(&self, is_last: bool, discretisation: &Discretisation) -> Goal {
        match (is_last, self.accuracy, discretisation.next()) {
            (true, Accuracy::Relative(tolerance), _) => Goal::Relative(tolerance.relative()),
            (true, Accuracy::OfDiscretisation(share), Some(error)) => Goal::Absolute(share * error),
            (true, Accuracy::OfDiscretisation(share), None) => Goal::Share(share),
            (false, _, Some(error)) => Goal::Absolute(ON_THE_WAY * error),
            (false, _, None) => Goal::Share(AT_FIRST),
        }
    }
}

/// P x with the prescribed values of the finer level.
fn prolonged<L: Level>(level: &L, problem: &ContactProblem, coarse: &[f64]) -> Vec<f64> {
    let mut fine = vec![0.0; level.unknowns()];
    level.prolong(coarse, &mut fine);
    for (unknown, _) in problem.prescribed.iter().enumerate().filter(|&(_, &held)| held) {
        fine[level.place(unknown)] = problem.values[unknown];
    }
    fine
}

/// Node-major values from the layout of the level.
fn node_major<L: Level>(level: &L, x: &[f64]) -> Vec<f64> {
    parallel::map_together(x.len(), 1 << 14, &|unknown| x[level.place(unknown)])
}

/// An estimate of the rounding error of F − K u in the dual norm: ε times the size of each row, divided by the root
/// of its diagonal entry, with a logarithmic factor for the coarse functions.
fn rounding(problem: &ContactProblem, u: &[f64]) -> f64 {
    let stiff = (0..u.len()).step_by(7).map(|i| problem.diagonal(i)).fold(0.0, f64::max);
    let rows = problem.multiply_absolute(u);
    let root = |(rows, load): (&[f64], &[f64])| {
        rows.iter().zip(load).map(|(size, force)| size + force.abs()).fold(0.0, f64::hypot)
    };
    let pieces: Vec<f64> =
        rows.par_chunks(1 << 14).zip(problem.load.par_chunks(1 << 14)).map(root).collect();
    f64::EPSILON * pieces.into_iter().fold(0.0, f64::hypot) / stiff.sqrt()
}
