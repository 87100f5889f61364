//! What several tests share: random numbers, and discrete solutions on a strip level by level.

#![allow(dead_code, reason = "each test uses a part")]

#[path = "../../toolkit/tests/common/mod.rs"]
mod random;

#[allow(unused_imports, reason = "each test uses a part")]
pub use random::SplitMix;
use signorini::Result;
use signorini::cone::Cone;
use signorini::strip::{EdgeSolution, StripProblem};

/// Solves with 2^from, ..., 2^to cells, each from the coarser solution, to a residual of 1e-13.
pub fn strip_levels(problem: &StripProblem, (from, to): (u32, u32), cone: Cone) -> Result<Vec<EdgeSolution>> {
    let mut levels: Vec<EdgeSolution> = Vec::new();
    for n in (from..=to).map(|level| 1 << level) {
        let solution = problem.operator(n)?.0.solve_contact(&problem.load(n)?, cone, levels.last(), 1e-13)?;
        levels.push(solution);
    }
    Ok(levels)
}
