//! `falk_terms`: the terms of Falk's lemma on the meshes of a problem of the strip.

use crate::convergence::{Level, StripCase, StripLevels, StripSolution, solve_levels};
use signorini::Result;
use signorini::edge::EdgeTrace;
use signorini::proof::FalkTerms;
use signorini::strip::StripProblem;

/// The terms on one mesh, mean over the positions of the transition.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FalkRow {
    /// Segments n; h = 1/n.
    pub n: usize,
    /// The terms.
    pub terms: FalkTerms,
    /// Largest scaled KKT residual of the discrete solutions.
    pub kkt: f64,
}

impl FalkRow {
    fn add(&mut self, n: usize, other: &FalkTerms, kkt: f64, share: f64) {
        self.n = n;
        self.terms.error += share * other.error;
        self.terms.approximation += share * other.approximation;
        self.terms.consistency += share * other.consistency;
        self.terms.second_infimum += share * other.second_infimum;
        self.terms.first_part += share * other.first_part;
        self.terms.second_part += share * other.second_part;
        self.kkt = self.kkt.max(kkt);
    }
}

/// The terms of Falk's lemma for a case of the strip, coarsest mesh first; `report` is called after each
/// mesh.
///
/// # Errors
/// Those of the scenes and of the contact iteration.
pub fn falk_terms(case: &StripCase, mut report: impl FnMut(usize)) -> Result<Vec<FalkRow>> {
    let sources = case.sources()?;
    let share = 1.0 / sources.len() as f64;
    let mut rows: Vec<FalkRow> = case.levels.cells().map(|_| FalkRow::default()).collect();
    let cells = case.levels.reference_cells();
    let mut problem: Option<StripProblem> = None;
    for source in &sources {
        let scene = source.data(case.tau, cells, case.kind.sides())?;
        let trace = EdgeTrace::of_data(&scene)?;
        let problem = match problem.as_mut() {
            Some(known) => {
                known.set_data(&scene)?;
                known
            }
            None => {
                let coarsest = case.levels.coarsest_cells();
                problem.insert(StripProblem::new(case.kind, &scene, case.reference, coarsest)?)
            }
        };
        let keep = |k: usize, level: &Level, solution: &StripSolution| {
            let n = level.facts.cells;
            rows[k].add(n, &FalkTerms::new(problem, &trace, n, &solution.edge)?, level.facts.kkt, share);
            report(n);
            Ok(())
        };
        solve_levels(&StripLevels::new(problem, case.levels), case.cone, |_| false, keep)?;
    }
    Ok(rows)
}
