//! Energy-norm errors of one cone on nested meshes against a finer solution (Theorems 3.1 and 4.1).
//!
//! e_h = |u_ref − u_h|_a / |u_ref|_a, u_ref the nodal-cone solution two refinements below the finest level studied
//! (four times finer), where a(·,·)^{1/2} is equivalent to the H¹ norm of the theorems. Against the exact solution a
//! rate of order p shows e_h √(1 − 16^{−p}) on the finest level, so that its observed order is a little too high.
//! The volume load is the nodal interpolant on each level, an O(h²) change of the data.

use super::orders::{Bound, observed_orders};
use super::regularity::clamped_free_exponent;
use crate::contact::{Cone, Solver};
use crate::error::{Error, Result};
use crate::mesh::Hierarchy;
use crate::scenes::{Scene, Setting};
use std::time::Instant;

/// Refinements between the finest level and the reference.
const REFERENCE_DEPTH: usize = 2;
/// Squares along each side of the largest reference: 8.4 million unknowns for a vector, some 16 GiB.
const LARGEST_REFERENCE: usize = 2048;

/// One level of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct RateRow {
    /// Squares along each side.
    pub n: usize,
    /// Length of a contact segment, 1/n; the paper's h is √2 times as long.
    pub mesh_size: f64,
    /// Free unknowns.
    pub unknowns: usize,
    /// Relative energy-norm error.
    pub error: f64,
    /// Observed order against the level before.
    pub order: Option<f64>,
    /// Active constraints.
    pub active: usize,
    /// Worst scaled KKT figure.
    pub judgement: f64,
    /// Seconds to assemble and solve.
    pub seconds: f64,
}

/// Errors on nested meshes and what they are compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct RateStudy {
    /// Sobolev regularity for the bounds: the supremum of the τ ≤ 2 with u in H^τ.
    pub tau: f64,
    /// Levels, coarsest first.
    pub rows: Vec<RateRow>,
}

impl RateStudy {
    /// Studies `levels` meshes with n, 2n, 4n, ... squares along each side.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for fewer than two levels, n < 2, or a reference that is too large; whatever the meshes and solvers return.
    pub fn nested(scene: Scene, cone: Cone, coarsest: usize, levels: usize) -> Result<Self> {
        if coarsest < 2 {
            return Err(Error::CountOutOfRange { name: "coarsest n", value: coarsest, range: "[2, inf)" });
        }
        let finest = u32::try_from(levels.saturating_add(REFERENCE_DEPTH - 1))
            .ok()
            .and_then(|k| 1usize.checked_shl(k));
        let reference = finest.and_then(|factor| coarsest.checked_mul(factor));
        if levels < 2 || reference.is_none_or(|n| n > LARGEST_REFERENCE) {
            let range = "[2, levels whose reference has at most 2048 squares along each side]";
            return Err(Error::CountOutOfRange { name: "levels", value: levels, range });
        }
        let hierarchy = Hierarchy::refined(scene.mesh(coarsest)?, levels - 1 + REFERENCE_DEPTH)?;
        let finest = hierarchy.levels().len() - 1;
        let reference_problem = scene.on(hierarchy.finest().clone())?;
        let reference = reference_problem.solve(Cone::Nodal, Solver::ActiveSet)?.displacement;
        let norm = reference_problem.energy_norm(&reference)?;
        let mut rows = Vec::with_capacity(levels);
        for (level, mesh) in hierarchy.levels().iter().take(levels).enumerate() {
            let started = Instant::now();
            let problem = scene.on(mesh.clone())?;
            let solution = problem.solve(cone, Solver::ActiveSet)?;
            let seconds = started.elapsed().as_secs_f64();
            let coarse = &solution.displacement;
            let error =
                reference_problem.nested_energy_error(&hierarchy, (level, coarse), (finest, &reference))?;
            let n = coarsest << level;
            rows.push(RateRow {
                n,
                mesh_size: 1.0 / n as f64,
                unknowns: problem.free_unknowns(),
                error: error / norm,
                order: None,
                active: solution.contact_set.count(),
                judgement: solution.judgement.worst(),
                seconds,
            });
        }
        let mesh_sizes: Vec<f64> = rows.iter().map(|r| r.mesh_size).collect();
        let errors: Vec<f64> = rows.iter().map(|r| r.error).collect();
        for (row, order) in rows.iter_mut().zip(observed_orders(&mesh_sizes, &errors)?) {
            row.order = order;
        }
        Ok(Self { tau: regularity(scene)?, rows })
    }

    /// Smallest and largest observed order of the last three steps, or of all when there are fewer.
    pub fn order_range(&self) -> Option<(f64, f64)> {
        let orders: Vec<f64> = self.rows.iter().rev().take(3).filter_map(|r| r.order).collect();
        let low = orders.iter().copied().reduce(f64::min)?;
        let high = orders.iter().copied().reduce(f64::max)?;
        Some((low, high))
    }

    /// error / bound(h) on every level.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn ratios(&self, bound: Bound) -> Result<Vec<f64>> {
        self.rows.iter().map(|row| Ok(row.error / bound.value(row.mesh_size, self.tau)?)).collect()
    }
}

/// The supremum of the τ ≤ 2 for which the solution of a scene lies in H^τ.
///
/// Elastic scenes: 1 + λ of their clamped/free right angles; the contact transition r^{3/2} is smoother. `corner`:
/// 1 + π/(2ω). Other scalar scenes: 2, since a right angle between u = 0 and zero flux is harmless.
fn regularity(scene: Scene) -> Result<f64> {
    match scene {
        Scene::Incompressible => {
            Ok(1.0 + clamped_free_exponent(std::f64::consts::FRAC_PI_2, Setting::default().poisson)?)
        }
        // λ = μ = 1 is Poisson's ratio 1/4.
        Scene::Block | Scene::Free | Scene::Closed => {
            Ok(1.0 + clamped_free_exponent(std::f64::consts::FRAC_PI_2, 0.25)?)
        }
        Scene::Corner => Ok((1.0 + 90.0 / Setting::default().angle).min(2.0)),
        Scene::Membrane | Scene::MembraneReaction | Scene::Manufactured => Ok(2.0),
    }
}
