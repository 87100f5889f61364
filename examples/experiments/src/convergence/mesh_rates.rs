//! Rate studies on nested meshes, against a finer solution.
//!
//! The reference lies on the next uniform refinement, h_r = h/2. It is no exact solution, and need not be: by
//! orthogonality
//! |u_ref − u_h|² ≈ |u − u_h|² − |u − u_ref|², and with the model e² = A h^{2p} + B h² for both the fit takes
//! A (h^{2p} − h_r^{2p}) + B (h² − h_r²) ([`signorini::rates::ConvergenceOrder`]). The volume load is its nodal interpolant on each
//! level, an O(h²) change of the data.

use super::level::RateLevel;
use super::level_loop::{Facts, LevelProblem, solve_levels};
use super::study::{RateReference, RateStudy};
use super::subject::Subject;
use crate::ErrorExt;
use fractional_sobolev::{Estimate, Tolerance, Work};
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, ContactSolution, Settings, Solver};
use signorini::fem::Form;
use signorini::mesh::{Hierarchy, Triangulation};
use signorini::problems::{Parameters, TestProblem, solution_regularity};
use signorini::rates::Bound;
use signorini::{Error, Result, ToolkitError};

/// Uniform refinements between the finest level and the reference.
const REFERENCE_DEPTH: usize = 1;
/// Squares along each side of the largest reference: by multigrid some 9 GB for the 17 million unknowns of a
/// scalar, 15 GB for a body.
const LARGEST_REFERENCE: usize = 4096;
/// Rounding of the energy norm of a difference, relative to the norm of u.
const ROUNDING: f64 = 1e-13;
/// What is asked of multigrid, relative to the norm of u: 1e-6 of the smallest errors that are studied. Of
/// more digits rounding leaves none at 1/4096.
const ALGEBRAIC: f64 = 1e-10;

/// A scene on nested meshes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshRates {
    /// The scene.
    pub scene: TestProblem,
    /// Its parameters.
    pub setting: Parameters,
    /// f = −1 in place of the load of the scene. Where u = 0 is prescribed on the rest of the boundary or
    /// nothing, a constant f < 0 gives u < 0 (maximum principle): the contact edge is free and the corner is
    /// all there is.
    pub constant_load: bool,
    /// Squares along each side of the coarsest mesh.
    pub coarsest: usize,
    /// Number of meshes n, 2n, 4n, ...
    pub levels: usize,
}

impl MeshRates {
    /// Studies the given cones; the reference is solved once, in the nodal cone. Errors are relative to the
    /// norm of u.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) for fewer than two levels, n < 2, or a reference that is too large;
    /// [`ToolkitError::ToleranceNotMet`](signorini::ToolkitError::ToleranceNotMet) when the reference does not converge; whatever the meshes and solvers
    /// return.
    pub fn study(&self, cones: &[Cone]) -> Result<Vec<RateStudy>> {
        self.check()?;
        let hierarchy = Hierarchy::refined(
            self.scene.mesh_with(self.coarsest, &self.setting)?,
            self.levels - 1 + REFERENCE_DEPTH,
        )?;
        let problem = self.problem(hierarchy.finest().clone())?;
        let solution = solve(&problem, &hierarchy, Cone::Nodal)?;
        if !solution.status.is_converged() {
            let why = "the finest mesh stands for the exact solution and its iteration did not end";
            let reached = solution.kkt.worst();
            return Err(ToolkitError::out_of_reach("reference solution", ALGEBRAIC, reached, why).into());
        }
        let tau = match self.constant_load {
            false => self.scene.regularity(&self.setting)?.tau,
            true => solution_regularity(&problem, &solution)?.tau,
        }
        .min(Bound::SMOOTHEST);
        let solution = solution.displacement;
        let norm = problem.energy_norm(&solution)?;
        let reference = Reference { rates: *self, hierarchy, problem, solution, norm };
        let subject = match self.scene {
            TestProblem::Corner => {
                Subject::Corner { angle: self.setting.angle, constant_load: self.constant_load }
            }
            scene => Subject::Mesh(scene),
        };
        let h_r = 1.0 / (self.coarsest << (self.levels - 1 + REFERENCE_DEPTH)) as f64;
        let resolution = self.coarsest << (self.levels - 1 + REFERENCE_DEPTH);
        cones
            .iter()
            .map(|&cone| {
                let solved = solve_levels(&reference, cone, |_| false, |_, _, _| Ok(()))?;
                let judged = |level| RateLevel::of(level, resolution, 1 << REFERENCE_DEPTH);
                let levels: Vec<RateLevel> = solved.iter().flatten().map(judged).collect();
                let (subject, reference) = (subject.clone(), RateReference::Discrete(h_r));
                Ok(RateStudy { subject, tau, cone, norm: None, reference, planned: self.levels, levels })
            })
            .collect()
    }

    fn problem(&self, mesh: Triangulation) -> Result<ContactProblem> {
        if !self.constant_load {
            return self.scene.on_with(mesh, &self.setting);
        }
        if self.scene != TestProblem::Corner {
            return Err(Error::Toolkit(ToolkitError::Incompatible {
                what: "scene",
                given: self.scene.to_string(),
                with: "a constant load",
                expected: "corner",
            }));
        }
        let load = vec![-1.0; mesh.nodes().len()];
        ContactProblem::new(mesh, Form::LAPLACE, &load)
    }

    fn check(&self) -> Result<()> {
        let (coarsest, levels) = (self.coarsest, self.levels);
        if coarsest < 2 {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "coarsest n",
                value: coarsest,
                range: "[2, inf)",
            }));
        }
        let finest = u32::try_from(levels.saturating_add(REFERENCE_DEPTH - 1))
            .ok()
            .and_then(|k| 1usize.checked_shl(k));
        let reference = finest.and_then(|factor| coarsest.checked_mul(factor));
        if levels < 2 || reference.is_none_or(|n| n > LARGEST_REFERENCE) {
            let range = "[2, levels whose reference has at most 4096 squares along each side]";
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "levels",
                value: levels,
                range,
            }));
        }
        Ok(())
    }
}

/// The discrete solution: by elimination on small meshes, by multigrid on large ones.
fn solve(problem: &ContactProblem, hierarchy: &Hierarchy, cone: Cone) -> Result<ContactSolution> {
    let unknowns = problem.mesh().nodes().len() * problem.form().components();
    match Solver::Auto.for_unknowns(unknowns) {
        Solver::Multigrid => {
            let accuracy = Accuracy::Relative(Tolerance::new(ALGEBRAIC)?);
            let hierarchy = Some(hierarchy);
            problem.solve(
                cone,
                Settings { solver: Solver::Multigrid, accuracy, hierarchy, ..Settings::default() },
            )
        }
        solver => problem.solve(cone, solver),
    }
}

/// The finest mesh with its solution, which stands for the exact one.
struct Reference {
    rates: MeshRates,
    hierarchy: Hierarchy,
    problem: ContactProblem,
    solution: Vec<f64>,
    norm: f64,
}

impl LevelProblem for Reference {
    type Solution = (ContactProblem, ContactSolution);

    fn count(&self) -> usize {
        self.rates.levels
    }

    fn solve(&self, level: usize, cone: Cone, _: Option<&Self::Solution>) -> Result<Self::Solution> {
        let problem = self.rates.problem(self.hierarchy.levels()[level].clone())?;
        let solution = solve(&problem, &self.hierarchy.up_to(level), cone)?;
        Ok((problem, solution))
    }

    fn error(&self, level: usize, (_, solution): &Self::Solution) -> Result<Estimate> {
        let finest = self.hierarchy.levels().len() - 1;
        let (coarse, fine) = ((level, &solution.displacement[..]), (finest, &self.solution[..]));
        let error = self.problem.nested_energy_error(&self.hierarchy, coarse, fine)?;
        Ok(Estimate::new(error / self.norm, ROUNDING + 2.0 * ALGEBRAIC, Work::default())?)
    }

    fn facts(&self, level: usize, (problem, solution): &Self::Solution) -> Facts {
        Facts {
            cells: self.rates.coarsest << level,
            unknowns: problem.free_unknowns() as f64,
            contact_runs: solution.contact_set.runs().len(),
            inner_iterations: Vec::new(),
            status: solution.status,
            kkt: solution.kkt.worst(),
        }
    }
}
