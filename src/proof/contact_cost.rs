//! What contact costs: the error beside the one of interpolation and that of the best approximation without
//! constraint.
//!
//! For each u in H^τ(Ω) and each contact set Σ_T |σ_N|²_{ν,T} ≤ ∬_{|x−y|≤h} (σ_N(x)−σ_N(y))²/|x−y|^{1+2ν},
//! which tends to 0, and the same for u_N'; with the constant c of a segment the consistency term is at most
//! c h^{2τ−2} (Σ_T |σ_N|²)^{1/2} (Σ_T |u_N'|²)^{1/2}, hence o(h^{2τ−2}), and for the nodal cone
//! |u − u_h|_a² ≤ |u − I^h u|_a² + o(h^{2τ−2}).
//!
//! On a strip I^h u is continued inside with least energy, and the best approximation is the discrete
//! solution for the forces A g that hold the exact edge: no contact problem. Cost as [`super::falk_terms`].

use super::exponent::Exponent;
use crate::convergence::{Level, StripLevels, StripSolution, solve_levels};
use crate::edge::consistency_terms;
use crate::error::Result;
use crate::scenes::StripCase;
use crate::strip::{StripProblem, restrict};

/// One mesh, mean over the positions of the scene; all squared.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CostRow {
    /// Segments n; h = 1/n.
    pub n: usize,
    /// |u − u_h|².
    pub error: f64,
    /// |u − I^h u|².
    pub interpolation: f64,
    /// |u − v_h|², least over all v_h.
    pub best: f64,
    /// The consistency term of the cone.
    pub consistency: f64,
}

impl CostRow {
    /// |u − u_h| / |u − I^h u|.
    pub fn over_interpolation(&self) -> f64 {
        (self.error / self.interpolation).sqrt()
    }

    /// |u − u_h| over the error of the best approximation: at least 1.
    pub fn over_best(&self) -> f64 {
        (self.error / self.best).sqrt()
    }

    /// The consistency term over h^{2τ−2}.
    pub fn scaled_term(&self, tau: f64) -> f64 {
        self.consistency * (self.n as f64).powf(2.0 * tau - 2.0)
    }
}

/// A quotient on the finest of at least three meshes, and what it changed by over the last two halvings of h.
pub fn cost_limit(rows: &[CostRow], quotient: fn(&CostRow) -> f64) -> Option<(f64, f64)> {
    let last = rows.len().checked_sub(3)?;
    let found: Vec<f64> = rows[last..].iter().map(quotient).collect();
    Some((found[2], (found[2] - found[1]).abs().max((found[2] - found[0]).abs())))
}

/// The order in h of the consistency term over h^{2τ−2}, over the meshes on which it is positive, three at
/// least.
pub fn term_order(rows: &[CostRow], tau: f64) -> Option<Exponent> {
    let points = rows.iter().map(|row| (1.0 / row.n as f64, row.scaled_term(tau)));
    let points: Vec<(f64, f64)> = points.filter(|point| point.1 > 0.0).collect();
    Exponent::fit(&points).ok()
}

/// The rows of a case, coarsest mesh first; `report` is called after each mesh.
///
/// # Errors
/// Those of the scenes and of the contact iteration.
pub fn contact_cost(case: &StripCase, mut report: impl FnMut()) -> Result<Vec<CostRow>> {
    let sources = case.sources()?;
    let share = 1.0 / sources.len() as f64;
    let mut rows: Vec<CostRow> = case.levels.cells().map(|_| CostRow::default()).collect();
    let (sides, coarsest) = (case.kind.sides(), case.levels.coarsest_cells());
    let mut problem: Option<StripProblem> = None;
    for source in &sources {
        let scene = source.data(case.tau, case.levels.reference_cells(), sides)?;
        let problem = match problem.as_mut() {
            Some(known) => {
                known.set_scene(&scene)?;
                known
            }
            None => problem.insert(StripProblem::new(case.kind, &scene, case.reference, coarsest)?),
        };
        let terms = consistency_terms(&scene, case.cone);
        let keep = |k: usize, level: &Level, _: &StripSolution| {
            let n = level.facts.cells;
            let stride = scene.cells() / n;
            let mut contact = scene.forces().to_vec();
            for _ in 0..stride.ilog2() {
                contact = restrict(&contact, sides);
            }
            let force: Vec<f64> = problem.load(n)?.force.iter().zip(contact).map(|(b, l)| b - l).collect();
            let best = problem.operator(n)?.0.solve(&force)?;
            let interpolant: Vec<f64> = scene.values().iter().step_by(stride).copied().collect();
            let square = |values: &[f64]| Ok(problem.error(n, values)?.value.powi(2));
            let row = &mut rows[k];
            row.n = n;
            row.error += share * level.error.value.powi(2);
            row.interpolation += share * square(&interpolant)?;
            row.best += share * square(&best)?;
            row.consistency += share * terms.iter().find(|term| term.0 == n).map_or(0.0, |term| term.1);
            report();
            Ok(())
        };
        solve_levels(&StripLevels::new(problem, case.levels), case.cone, |_| false, keep)?;
    }
    Ok(rows)
}
