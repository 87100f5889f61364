//! A computed bound beside the true error: the distance to the solution on a mesh of at least 16 times as many
//! triangles, in the energy norm.

#![allow(dead_code, reason = "each test uses a part")]

use signorini::bounds::{Enclosure, Interval};
use signorini::cone::Cone;
use signorini::contact::{Body, Settings, Solver};
use signorini::mesh::{Hierarchy, Triangulation};
use signorini::{Result, fem::Form};

/// What acts on a body, for every mesh of it.
pub type Acting = Box<dyn Fn(Triangulation) -> Body<'static> + Send + Sync>;

/// Rounding of energies, forces and errors relative to their sizes.
const ROUNDED: f64 = 1e-9;

/// A body on a coarse mesh.
pub struct Scene {
    pub name: String,
    pub mesh: Triangulation,
    pub body: Acting,
}

/// The bound on one mesh, and what a mesh of 16 times as many triangles says of it.
#[derive(Debug, Clone)]
pub struct Beside {
    pub found: Enclosure,
    pub fine: Enclosure,
    /// |||u_fine − u^h|||.
    pub distance: f64,
    /// The forces of the contact edges from both meshes.
    pub forces: Vec<[Interval; 2]>,
}

impl Scene {
    pub fn new(
        name: impl Into<String>,
        mesh: Triangulation,
        body: impl Fn(Triangulation) -> Body<'static> + Send + Sync + 'static,
    ) -> Self {
        Self { name: name.into(), mesh, body: Box::new(body) }
    }

    pub fn form(&self) -> Form {
        (self.body)(self.mesh.clone()).form().clone()
    }

    /// The enclosure on the mesh, and on its `times`-th uniform refinement.
    pub fn beside(&self, cone: Cone, times: usize) -> Result<Beside> {
        let meshes = Hierarchy::refined(self.mesh.clone(), times)?;
        let coarse_body = (self.body)(self.mesh.clone());
        let fine_body = (self.body)(meshes.finest().clone());
        let found = coarse_body.enclose(cone)?;
        let fine = fine_body.enclose(cone)?;
        let distance = fine.problem.nested_energy_error(
            &meshes,
            (0, &found.solution.displacement),
            (times, &fine.solution.displacement),
        )?;
        let mut forces = Vec::new();
        for edge in 0..found.problem.edge().pieces().len() {
            let both =
                (coarse_body.contact_force(&found, edge)?, fine_body.contact_force(&fine, edge)?);
            if let (Some(coarse), Some(fine)) = both {
                forces.push([coarse, fine]);
            }
        }
        Ok(Beside { found, fine, distance, forces })
    }
}

impl Beside {
    /// Bound over distance.
    pub fn effectivity(&self) -> f64 {
        self.found.error / self.distance
    }

    /// What contradicts the statements of T11 and T12, if anything.
    pub fn violations(&self, name: &str) -> Vec<String> {
        let Self { found, fine, distance, forces } = self;
        let mut wrong = Vec::new();
        let mut claim = |is_true: bool, what: String| {
            if !is_true {
                wrong.push(format!("{name}: {what}"));
            }
        };
        let size = fine.norm.upper;
        // |||u − u^h||| ≥ |||u_fine − u^h||| − |||u − u_fine|||; almost always the distance alone is below the bound.
        claim(
            found.error >= distance * (1.0 - ROUNDED) - ROUNDED * size,
            format!("bound {:e} below the distance {distance:e} to the fine solution", found.error),
        );
        claim(
            found.error + fine.error >= distance * (1.0 - ROUNDED),
            format!("bound {:e} below {distance:e} − {:e}", found.error, fine.error),
        );
        let room = ROUNDED * size * size;
        let (wide, narrow) = (found.energy, fine.energy);
        claim(
            wide.lower <= narrow.upper + room && narrow.lower <= wide.upper + room,
            format!("energies {wide:?} and {narrow:?}"),
        );
        claim(
            wide.lower <= fine.solution.energy + room || fine.correction > 0.0,
            format!("J of the fine mesh {:e} outside of {wide:?}", fine.solution.energy),
        );
        for [coarse, fine] in forces {
            let room = ROUNDED * (coarse.upper.abs() + coarse.lower.abs());
            claim(
                coarse.lower <= fine.upper + room && fine.lower <= coarse.upper + room,
                format!("forces {coarse:?} and {fine:?}"),
            );
        }
        wrong
    }
}

/// The exponent of the last values as a power of the numbers, by least squares in logarithms.
pub fn exponent(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0.ln()), mean(&|p| p.1.ln()));
    let xy: f64 = points.iter().map(|p| (p.0.ln() - x) * (p.1.ln() - y)).sum();
    let xx: f64 = points.iter().map(|p| (p.0.ln() - x).powi(2)).sum();
    xy / xx
}

/// Solves with the active set method on a refinement.
pub fn solved_on(body: &Body<'_>, mesh: &Triangulation, cone: Cone) -> Result<f64> {
    let settings = Settings { solver: Solver::ActiveSet, ..Settings::default() };
    Ok(body.problem_on(mesh)?.solve(cone, settings)?.energy)
}
