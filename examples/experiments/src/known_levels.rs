//! `theorem_3_1_without_c`, `theorem_3_1_with_numbers`, `theorem_3_1_with_numbers_elastic`, `contact_costs_nothing`:
//! errors of the discrete solutions of a problem with known solution on the meshes with n × n squares, n = 4, 8, ...

use crate::ErrorExt;
use signorini::cone::Cone;
use signorini::contact::{ContactSolution, Settings, Start};
use signorini::problems::KnownSolution;
use signorini::{Error, Result, ToolkitError};

/// n = 2 to this power on the coarsest mesh.
const COARSEST: u32 = 2;

/// One mesh with n × n squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownLevel {
    /// n; h = 1/n.
    pub n: usize,
    /// |u − u_h|_a.
    pub error: f64,
    /// |u − I^h u|_a.
    pub interpolation: f64,
}

impl KnownLevel {
    /// |u − u_h|_a / |u − I^h u|_a on the finest of at least two meshes, and what it changed by from the one
    /// before.
    pub fn limit(levels: &[Self]) -> Option<(f64, f64)> {
        let [.., before, last] = levels else { return None };
        let [before, last] = [before, last].map(|level| level.error / level.interpolation);
        Some((last, (last - before).abs()))
    }
}

/// n = 4, 8, ..., 2^finest, each solved from the contact set of the mesh before; `report` is called after each.
///
/// # Errors
/// [`ToolkitError::CountOutOfRange`] unless 2 ≤ finest ≤ 11; [`ToolkitError::ToleranceNotMet`] for a solution that does
/// not meet its conditions to 1e-8; whatever problems and solvers return.
pub fn known_levels(
    known: &KnownSolution,
    cone: Cone,
    finest: u32,
    mut report: impl FnMut(),
) -> Result<Vec<KnownLevel>> {
    if !(COARSEST..=11).contains(&finest) {
        let (name, value) = ("finest level", finest as usize);
        return Err(Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range: "[2, 11]" }));
    }
    let mut coarse: Option<ContactSolution> = None;
    let mut levels = Vec::new();
    for n in (COARSEST..=finest).map(|level| 1usize << level) {
        let problem = known.problem(n)?;
        let start = coarse.as_ref().map_or(Start::Open, Start::Coarse);
        let solution = problem.solve(cone, Settings { start, ..Settings::default() })?;
        if !solution.status.is_converged() {
            let why = "the active-set iteration did not converge";
            return Err(
                ToolkitError::out_of_reach("contact conditions", 1e-8, solution.kkt.worst(), why).into()
            );
        }
        levels.push(KnownLevel {
            n,
            error: known.error_norms(&problem, &solution.displacement)?.energy,
            interpolation: known.error_norms(&problem, &known.interpolant(&problem)?)?.energy,
        });
        coarse = Some(solution);
        report();
    }
    Ok(levels)
}
