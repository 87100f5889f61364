//! Three roads to the discrete solutions of the scene with known solution, with seconds and true errors: the
//! active set from no contact, the active set from the contact set of the mesh before, the interior-point
//! method.

use super::manufactured;
use super::mesh::MeshScene;
use crate::cone::Cone;
use crate::contact::{ContactSolution, Solver};
use crate::error::{Error, Result};
use crate::fem::{Cubature, Field, error_norms};
use std::fmt;
use std::time::Instant;

/// Points along each side of a triangle's rule; graded toward the transition.
const POINTS: usize = 4;

/// A way to a discrete solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Road {
    /// The active set from no contact.
    Cold,
    /// The active set from the contact set of the mesh before.
    Nested,
    /// The interior-point method.
    Interior,
}

impl Road {
    /// All roads.
    pub const ALL: [Road; 3] = [Road::Cold, Road::Nested, Road::Interior];
}

impl fmt::Display for Road {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Road::Cold => "active set, cold",
            Road::Nested => "active set, nested",
            Road::Interior => "interior point",
        })
    }
}

/// One discrete solution on n × n squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoadRow {
    /// n.
    pub n: usize,
    /// How it was found.
    pub road: Road,
    /// |u − u_h| in the H¹ seminorm.
    pub error: f64,
    /// For mesh, assembly, solution and judgement.
    pub seconds: f64,
    /// Iterations.
    pub steps: usize,
    /// The worst scaled Karush-Kuhn-Tucker figure.
    pub kkt: f64,
}

/// [`MeshScene::Manufactured`] on n, 2n, ..., 2^{levels − 1} n squares along each side, coarsest first; on
/// the coarsest mesh there is no nested start. `report` is called after each mesh.
///
/// # Errors
/// [`Error::CountOutOfRange`] unless 2 ≤ levels ≤ 8; whatever meshes, problems and solvers return.
pub fn manufactured_by_every_road(
    n: usize,
    levels: usize,
    cone: Cone,
    mut report: impl FnMut(),
) -> Result<Vec<RoadRow>> {
    if !(2..=8).contains(&levels) {
        return Err(Error::CountOutOfRange { name: "levels", value: levels, range: "[2, 8]" });
    }
    let rule = Cubature::new(POINTS)?.singular_at(&[[manufactured::TRANSITION, 0.0]]);
    let exact = Field::Scalar(&manufactured::exact);
    let gradient = |point| [manufactured::gradient(point), [0.0; 2]];
    let (mut rows, mut coarse): (Vec<RoadRow>, Option<ContactSolution>) = (Vec::new(), None);
    for n in (0..levels).map(|level| n.saturating_mul(1 << level)) {
        let mut next = None;
        for road in Road::ALL {
            let start = Instant::now();
            let problem = MeshScene::Manufactured.problem(n)?;
            let solution = match (road, &coarse) {
                (Road::Nested, None) => continue,
                (Road::Nested, Some(coarse)) => problem.solve_after(coarse)?,
                (Road::Cold, _) => problem.solve(cone, Solver::ActiveSet)?,
                (Road::Interior, _) => problem.solve(cone, Solver::InteriorPoint)?,
            };
            let seconds = start.elapsed().as_secs_f64();
            let values = &solution.displacement;
            let error = error_norms(problem.mesh(), problem.form(), values, (&exact, &gradient), &rule)?.h1;
            let (steps, kkt) = (solution.work.iterations as usize, solution.judgement.worst());
            rows.push(RoadRow { n, road, error, seconds, steps, kkt });
            if road != Road::Interior {
                next = Some(solution);
            }
        }
        coarse = next;
        report();
    }
    Ok(rows)
}
