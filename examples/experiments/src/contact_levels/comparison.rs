//! How far two solutions on the same mesh are apart, and how one meets its conditions.

use super::levels::SceneRun;
use signorini::Result;
use signorini::cone::{KKT_ROUNDING, KktResiduals, KktTerms};
use signorini::contact::ContactSolution;

/// Both force and gap below this, relative to their largest: √(duality gap) of the interior-point method.
const WEAK: f64 = 1e-6;

impl SceneRun {
    /// The KKT residuals of multipliers and gaps as they stand; the balance is that of the
    /// solution.
    ///
    /// # Errors
    /// [`ToolkitError::NotFinite`](signorini::ToolkitError::NotFinite) where a multiplier or a gap is not a number.
    pub fn kkt(&self) -> Result<KktResiduals> {
        let solution = &self.solution;
        let terms = KktTerms {
            residual: &[],
            multiplier: &solution.multiplier,
            gap: &solution.gap,
            force: solution.force_scale,
            displacement: solution.displacement_scale,
        };
        Ok(KktResiduals { balance: solution.kkt.balance, ..terms.residuals()? })
    }

    /// How many constraints are weak: force and gap both below 1e-6 of their largest, so that no solver can
    /// tell contact from none.
    pub fn weak_constraints(&self) -> usize {
        let solution = &self.solution;
        let force = solution.multiplier.iter().fold(0.0, |m: f64, l| m.max(l.abs()));
        let is_weak =
            |(l, g): &(&f64, &f64)| l.abs() <= WEAK * force && g.abs() <= WEAK * solution.displacement_scale;
        solution.multiplier.iter().zip(&solution.gap).filter(is_weak).count()
    }
}

/// Pairs of solutions on the same mesh.
fn pairs(runs: &[SceneRun]) -> impl Iterator<Item = [&SceneRun; 2]> {
    runs.windows(2).filter(|pair| pair[0].n == pair[1].n).map(|pair| [&pair[0], &pair[1]])
}

/// The largest difference in J between two solutions on the same mesh, relative, and what rounding leaves
/// uncertain in it. `None` without two solutions on a mesh; not a number if a J is not.
pub fn energies_apart(runs: &[SceneRun]) -> Option<(f64, f64)> {
    pairs(runs)
        .map(|[a, b]| {
            let difference = (a.solution.energy - b.solution.energy).abs();
            let rounding = a.solution.energy_rounding + b.solution.energy_rounding;
            let scale = energy_scale(&a.solution);
            let share = |part: f64| if part == 0.0 { 0.0 } else { part / scale };
            (share(difference), share(rounding))
        })
        .reduce(|worst, apart| if worst.0 >= apart.0 || worst.0.is_nan() { worst } else { apart })
}

/// The largest number of constraints that are active in one of two solutions on the same mesh only, and how
/// many are weak there. `None` without two solutions on a mesh.
pub fn sets_apart(runs: &[SceneRun]) -> Option<(usize, usize)> {
    pairs(runs)
        .map(|[a, b]| {
            let (one, other) = (a.solution.contact_set.indices(), b.solution.contact_set.indices());
            let common = one.iter().filter(|i| other.binary_search(i).is_ok()).count();
            (one.len() + other.len() - 2 * common, a.weak_constraints().max(b.weak_constraints()))
        })
        .max()
}

/// |J|; where contact prevents every displacement J is rounding, and force times displacement is its scale.
fn energy_scale(solution: &ContactSolution) -> f64 {
    let largest = solution.displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    if largest <= KKT_ROUNDING * solution.displacement_scale {
        solution.force_scale * solution.displacement_scale
    } else {
        solution.energy.abs()
    }
}
