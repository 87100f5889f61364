//! A body from anywhere: its triangulation, its form and its volume load, solved on nested meshes.
//!
//! The load ∫ f·v is integrated on every mesh by a rule exact for degree 7, so all levels belong to one
//! problem up to quadrature: nodal cones are nested and min J falls from mesh to mesh.

use super::levels::{How, LEVELS, Level, SceneRun, StudyProgress, asked, solve_levels, solvers_for};
use super::study::INTERIOR;
use signorini::Result;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, Solver};
use signorini::fem::{Cubature, Field, Form};
use signorini::mesh::{Hierarchy, Triangulation};

/// Points of the rule for loads, along each side of a triangle.
const POINTS: usize = 4;

/// What is given.
#[derive(Debug, Clone, Copy)]
pub struct OwnBody<'a> {
    /// The coarsest mesh.
    pub mesh: &'a Triangulation,
    /// Elasticity, or the scalar form.
    pub form: &'a Form,
    /// Volume load f.
    pub load: Field<'a>,
    /// The cone.
    pub cone: Cone,
    /// One solver; when `None` two, as in [`super::SceneStudy`].
    pub solver: Option<Solver>,
    /// Number of meshes, each the last one with every triangle cut into four.
    pub levels: usize,
    /// The accuracy of multigrid; when `None` twelve digits beside another solver, else a hundredth of the error of
    /// discretisation.
    pub accuracy: Option<Accuracy>,
}

impl OwnBody<'_> {
    /// The problem on a triangulation of the body.
    ///
    /// ```
    /// use signorini::cone::Cone;
    /// use signorini::contact::Solver;
    /// use signorini::fem::{Field, Form, Lame};
    /// use signorini::mesh::{SideParts, unit_square};
    /// use experiments::contact_levels::OwnBody;
    /// let mesh = unit_square(8, SideParts::HANGING)?;
    /// let form = Form::elastic(Lame::plane_strain(2.5, 0.25)?);
    /// let load = Field::Vector(&|[x, _]| [0.0, 1.0 - 3.0 * x]);
    /// let body = OwnBody { mesh: &mesh, form: &form, load, cone: Cone::Nodal, solver: None, levels: 2, accuracy: None };
    /// let runs = body.run(|_| Ok(()))?;
    /// assert_eq!(runs.len(), 4);
    /// assert!(runs[2].solution.energy < runs[0].solution.energy);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`ContactProblem::new`] and [`ContactProblem::add_volume_load`]; a load that is not finite at a
    /// point names it.
    pub fn problem(&self, mesh: Triangulation) -> Result<ContactProblem> {
        let none = vec![0.0; mesh.nodes().len() * self.form.components()];
        let mut problem = ContactProblem::new(mesh, self.form.clone(), &none)?;
        problem.add_volume_load(&self.load, &Self::load_rule()?)?;
        Ok(problem)
    }

    /// The rule that integrates loads.
    ///
    /// # Errors
    /// None for this number of points.
    pub fn load_rule() -> Result<Cubature> {
        Cubature::new(POINTS)
    }

    /// About what the finest level takes, in bytes: elimination, 100 log₂ N for each of N unknowns.
    pub fn bytes(&self) -> f64 {
        let nodes = self.mesh.nodes().len() as f64 * 4f64.powi(self.levels.min(LEVELS) as i32 - 1);
        let unknowns = (nodes * self.form.components() as f64).max(2.0);
        100.0 * unknowns * unknowns.log2()
    }

    /// Solves on every level, coarsest first; [`SceneRun::n`] counts the segments of the contact edge.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) without levels; whatever problems, solvers and `observe` return.
    pub fn run(&self, observe: impl FnMut(&StudyProgress) -> Result<()> + Send) -> Result<Vec<SceneRun>> {
        let mut hierarchy = Hierarchy::new(self.mesh.clone());
        let level = |number: usize| {
            if number > 0 {
                hierarchy.refine()?;
            }
            let problem = self.problem(hierarchy.finest().clone())?;
            let n = problem.edge().segment_lengths().len();
            Ok(Level { n, problem, hierarchy: Some(hierarchy.clone()) })
        };
        let how = How { cone: self.cone, levels: self.levels, asked: asked(self.solver, self.accuracy) };
        solve_levels(how, level, |_, problem| self.solvers(problem), observe)
    }

    /// Two solvers, unless one was given.
    fn solvers(&self, problem: &ContactProblem) -> Vec<Solver> {
        let nodes = problem.mesh().nodes().len();
        let unknowns = nodes * problem.form().components();
        self.solver.map_or_else(
            || solvers_for(nodes <= (INTERIOR + 1) * (INTERIOR + 1), unknowns),
            |solver| vec![solver.for_unknowns(unknowns)],
        )
    }
}
