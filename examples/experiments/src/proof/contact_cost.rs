//! What contact costs: the error beside the one of interpolation and that of the best approximation without
//! constraint.
//!
//! For each u in H^τ(Ω) and each contact set Σ_T |σ_N|²_{ν,T} ≤ ∬_{|x−y|≤h} (σ_N(x)−σ_N(y))²/|x−y|^{1+2ν},
//! which tends to 0, and the same for u_N'; with the constant c of a segment the consistency term is at most
//! c h^{2τ−2} (Σ_T |σ_N|²)^{1/2} (Σ_T |u_N'|²)^{1/2}, hence o(h^{2τ−2}), and for the nodal cone
//! |u − u_h|_a² ≤ |u − I^h u|_a² + o(h^{2τ−2}).
//!
//! The order of the term over h^{2τ−2} in a scene of [`StripData`], from the gaps longer than h, h^{−d} of
//! them (this defines d; shorter ones, of length l, count with weight l/h and add no more),
//! [`CostStudy::theory`]:
//!
//! | scene | on one segment: ∫\|σ_N\|, \|u_N\| | sum | over h^{2τ−2} |
//! | --- | --- | --- | --- |
//! | transitions, τ ≤ 2 | h^{τ−1}, h^{τ−1} | h^{2τ−2} | 0 |
//! | transitions, τ = 5/2 | h^{3/2}, h^{3/2} | h³ | 1, over h² |
//! | fat Cantor set, d = 4 − 2τ | h, h | h^{2−d} | 0 |
//! | Cantor set, σ_N = −1 on all of its pieces, of fixed total | h^d, h^{τ−1+d/2} | h^{τ−1+d/2} | 1 − τ + d/2 |
//!
//! Where the order is 0 the regularity τ is a supremum: the sums that have to tend to zero for u ∈ H^τ do
//! not.
//!
//! On a strip I^h u is continued inside with least energy, and the best approximation is the discrete
//! solution for the forces A g that hold the exact edge: no contact problem. Cost as for [`super::falk_terms`].

use crate::convergence::regression;
use crate::convergence::{Level, StripCase, StripLevels, StripSolution, solve_levels};
use signorini::Result;
use signorini::cone::Cone;
use signorini::edge::consistency_terms;
use signorini::problems::StripData;
use signorini::rates::ConvergenceOrder;
use signorini::strip::{LateralCondition, StripProblem};
use std::f64::consts::LN_2;

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

/// A scene on a strip in one cone, mesh after mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct CostStudy {
    /// The scene.
    pub scene: StripData,
    /// Its regularity.
    pub tau: f64,
    /// The cone.
    pub cone: Cone,
    /// Cells of the grid of reference.
    pub reference: usize,
    /// Coarsest mesh first.
    pub rows: Vec<CostRow>,
}

/// Cells of reference in a segment for quotients: what the discrete reference misses of the squared errors is
/// (h_r/h)^{2τ−2}, 1 % for τ = 1.55.
const RESOLVED: usize = 64;

impl CostStudy {
    /// Solves a case; `report` is called after each mesh.
    ///
    /// # Errors
    /// As [`contact_cost`].
    pub fn of(case: &StripCase, report: impl FnMut()) -> Result<Self> {
        let (scene, rows) = (case.source.clone(), contact_cost(case, report)?);
        let reference = case.levels.reference_cells();
        Ok(Self { scene, tau: case.tau, cone: case.cone, reference, rows })
    }

    /// A quotient on the finest of at least three meshes whose segments have 64 cells of reference, and what
    /// it changed by over the last two halvings of h.
    pub fn limit(&self, quotient: fn(&CostRow) -> f64) -> Option<(f64, f64)> {
        let resolved = self.rows.iter().filter(|row| RESOLVED * row.n <= self.reference);
        let found: Vec<f64> = resolved.map(quotient).collect();
        let [.., before, half, last] = found.as_slice() else { return None };
        Some((*last, (last - half).abs().max((last - before).abs())))
    }

    /// The order of the consistency term over h^{2τ−2}, τ at most 2, and its uncertainty.
    pub fn order(&self) -> Option<(f64, f64)> {
        term_order(&self.rows, self.tau.min(2.0)).map(|found| (found.order, found.uncertainty))
    }

    /// How far the order is from the theory, and its uncertainty.
    pub fn off(&self) -> Option<(f64, f64)> {
        let (found, theory) = (self.order()?, self.theory()?);
        Some(((found.0 - theory).abs(), found.1))
    }

    /// The order by the table of the module.
    pub fn theory(&self) -> Option<f64> {
        term_theory(&self.scene, self.tau)
    }
}

/// The order in h of the consistency term over h^{2τ−2}, over the meshes on which it is positive, three at
/// least.
fn term_order(rows: &[CostRow], tau: f64) -> Option<ConvergenceOrder> {
    let points = rows.iter().map(|row| (1.0 / row.n as f64, row.scaled_term(tau)));
    let points: Vec<(f64, f64)> = points.filter(|point| point.1 > 0.0).collect();
    regression(&points)
}

/// The order of the term over h^{2τ−2}, τ at most 2; `None` for samples and for transitions with 2 < τ < 5/2,
/// which no row of the table describes.
fn term_theory(scene: &StripData, tau: f64) -> Option<f64> {
    match scene {
        StripData::Transition { .. } | StripData::Transitions { .. } if tau <= 2.0 => Some(0.0),
        StripData::Transition { .. } | StripData::Transitions { .. } if tau == 2.5 => Some(1.0),
        StripData::FatCantor { .. } => Some(0.0),
        StripData::Cantor { ratio, .. } => Some(1.0 - tau + 0.5 * LN_2 / -ratio.ln()),
        _ => None,
    }
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
                known.set_data(&scene)?;
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
            let force: Vec<f64> = problem.load(n)?.iter().zip(contact).map(|(b, l)| b - l).collect();
            let best = problem.operator(n)?.0.solve(&force)?;
            let interpolant: Vec<f64> = scene.values().iter().step_by(stride).copied().collect();
            let square = |values: &[f64]| -> Result<f64> { Ok(problem.error(n, values)?.value.powi(2)) };
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

/// Nodal forces on the mesh of twice the cell length: P'b, P the interpolation from there.
fn restrict(fine: &[f64], sides: LateralCondition) -> Vec<f64> {
    let cells = match sides {
        LateralCondition::Natural => (fine.len() - 1) / 2,
        LateralCondition::Periodic => fine.len() / 2,
    };
    let last = fine.len() - 1;
    (0..sides.nodes(cells))
        .map(|i| {
            let left = match (i, sides) {
                (0, LateralCondition::Natural) => 0.0,
                (0, LateralCondition::Periodic) => fine[last],
                _ => fine[2 * i - 1],
            };
            let right = fine.get(2 * i + 1).copied().unwrap_or(0.0);
            fine[2 * i] + 0.5 * (left + right)
        })
        .collect()
}
