//! What an example of Section 2 solves: a scene of the registry, or a body of the user's own.

use super::csv;
use super::own::{Own, OwnOptions};
use super::picture::{Drawing, draw_coarser, quote_and_draw};
use crate::{Error, Finding, Headline, Output, Result, Table, announce_memory, progress};
use experiments::contact_levels::{OwnBody, SceneRun, SceneStudy, StudyProgress};
use signorini::cone::Cone;
use signorini::contact::{Accuracy, Solver};

/// The packages agree among themselves to 12 digits or more.
const PACKAGES: f64 = 1e-11;

/// A scene, or a body with the way it is solved.
#[derive(Debug, Clone)]
pub enum ContactSubject {
    /// One of the registry.
    Scene(SceneStudy),
    /// The user's own.
    Own {
        /// The body.
        body: Own,
        /// The cone.
        cone: Cone,
        /// One solver, or two.
        solver: Option<Solver>,
        /// Number of meshes.
        levels: usize,
        /// What is asked of multigrid.
        accuracy: Option<Accuracy>,
    },
}

impl ContactSubject {
    /// The scene of the study, or what the options put in its place: another mesh, another load on its own.
    ///
    /// # Errors
    /// As [`OwnOptions::body`]; [`Error::Option`] for a load on a scene whose data belong to its solution;
    /// a directory that cannot be written.
    pub fn new(study: SceneStudy, own: &OwnOptions) -> Result<Self> {
        csv::prepare(own)?;
        if !own.is_own() {
            return Ok(Self::Scene(study));
        }
        let SceneStudy { scene, setting, cone, solver, n, levels, accuracy } = study;
        if own.mesh.is_none() && scene.solution().is_some() {
            return Err(Error::Option(format!(
                "the data of scene {scene} belong to its solution: no --load"
            )));
        }
        let form = if own.mesh.is_some() { scene.usual_form()? } else { scene.bilinear_form(&setting)? };
        let on_scene = || Ok((scene.to_string(), scene.mesh_with(n, &setting)?));
        let body = own.body(on_scene, form, setting.load_scale)?;
        Ok(Self::Own { body, cone, solver, levels, accuracy })
    }

    /// A body solved by two solvers.
    ///
    /// # Errors
    /// A directory for files that cannot be written.
    pub fn own(body: Own, cone: Cone, levels: usize, options: &OwnOptions) -> Result<Self> {
        csv::prepare(options)?;
        Ok(Self::Own { body, cone, solver: None, levels, accuracy: None })
    }

    /// Number of meshes.
    pub fn levels(&self) -> usize {
        match self {
            Self::Scene(study) => study.levels,
            Self::Own { levels, .. } => *levels,
        }
    }

    /// The cone.
    pub fn cone(&self) -> Cone {
        match self {
            Self::Scene(study) => study.cone,
            Self::Own { cone, .. } => *cone,
        }
    }

    /// J of the finest mesh beside that of other packages, where they have found it.
    pub fn packages_agree(&self, runs: &[SceneRun]) -> Option<Finding> {
        let (Self::Scene(study), run) = (self, runs.last()?) else { return None };
        let j = study.known_energy(run.n)?;
        let error = run.solution.energy_rounding + run.error().map_or(0.0, |e| e.error * e.error);
        let found = Finding::claim("packages", "five other packages find the same J = {value}")
            .number(run.solution.energy, error)
            .within(PACKAGES * j.abs(), j, "tests/reference, signorini_square.json");
        Some(found.told())
    }

    /// Solves on every mesh and shows where it is.
    ///
    /// # Errors
    /// Those of the solution; more memory than the machine has.
    pub fn solve(&self) -> Result<Vec<SceneRun>> {
        let bar = progress(2 * self.levels() as u64);
        let observe = |at: &StudyProgress| {
            bar.set_message(at.to_string());
            bar.inc(u64::from(at.multigrid.is_none()));
            Ok(())
        };
        let runs = match self {
            Self::Scene(study) => {
                announce_memory(study.bytes())?;
                study.run_observed(observe)?
            }
            Self::Own { body, cone, solver, levels, accuracy } => body.with_load(|load| {
                let Own { mesh, form, .. } = body;
                let (cone, solver, levels, accuracy) = (*cone, *solver, *levels, *accuracy);
                let own = OwnBody { mesh, form, load, cone, solver, levels, accuracy };
                announce_memory(own.bytes())?;
                Ok::<_, Error>(own.run(observe)?)
            })?,
        };
        bar.finish_and_clear();
        Ok(runs)
    }

    /// The rows.
    pub fn table(&self, runs: &[SceneRun]) -> Table {
        match self {
            Self::Scene(_) => super::table(runs),
            Self::Own { .. } => super::listing::own_table(runs),
        }
    }

    /// Quotes and draws the finest mesh, and writes what `--csv` asks for.
    ///
    /// # Errors
    /// Those of the coarser solutions and of the files.
    pub fn finish(
        &self,
        headline: &mut Headline,
        runs: &[SceneRun],
        own: &OwnOptions,
        output: &Output,
    ) -> Result<()> {
        let drawing = match self {
            Self::Scene(study) => Drawing {
                key: study.scene.to_string(),
                file: study.scene.to_string(),
                title: format!("Scene {}", study.scene),
            },
            Self::Own { body, .. } => Drawing {
                key: "own".to_owned(),
                file: format!("own_{}", body.name),
                title: body.name.replace('_', " "),
            },
        };
        let range = quote_and_draw(headline, &drawing, runs, output)?;
        if let (Self::Scene(study), Some(range)) = (self, range) {
            draw_coarser(headline, study, &drawing, range, output)?;
        }
        csv::write(own, &headline.table, runs)
    }
}
