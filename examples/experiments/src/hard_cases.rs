//! `section_2_multigrid`: contact problems that are hard for cycles of point smoothers, and any problem by multigrid and by
//! elimination beside each other.
//!
//! Compared are J (relative), the contact sets, the true algebraic error |u − v|_a/|v|_a (v by elimination)
//! and its estimate. Cost: one elimination and one multigrid solution.

use fractional_sobolev::{Given, Tolerance};
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, Fallback, Settings, Solver};
use signorini::fem::{Field, Form, Lame};
use signorini::mesh::{Hierarchy, SideParts, mapped_grid};
use signorini::problems::{Parameters, TestProblem};
use signorini::{Error, Result};
use std::f64::consts::PI;
use std::fmt;

/// Squares along each side of the coarsest mesh of a graded hierarchy.
const COARSEST: usize = 8;
/// λ/μ.
const RATIOS: [f64; 8] = [0.0, 1.0, 10.0, 50.0, 100.0, 200.0, 500.0, 1000.0];
/// Openings in degrees.
const ANGLES: [f64; 3] = [60.0, 120.0, 150.0];
/// Quotients of the legs of a triangle.
const ASPECTS: [f64; 3] = [4.0, 20.0, 100.0];
/// Bisections.
const BISECTED: [usize; 2] = [10, 30];
/// Margins below this leave the contact set to rounding.
const WEAK: f64 = 1e-9;

/// What makes it hard; the mesh has n × n cells, the graded one as many to begin with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HardCase {
    /// A scene with its default setting.
    Scene(TestProblem),
    /// `block` with this λ/μ.
    Compressibility(f64),
    /// `corner`, or `leaning` (elastic), with this opening in degrees.
    Angle {
        /// The opening.
        degrees: f64,
        /// Elastic or scalar.
        is_elastic: bool,
    },
    /// `block` or `membrane` pressed flat: triangles with legs h and h over this.
    Aspect {
        /// The quotient of the legs.
        aspect: f64,
        /// Elastic or scalar.
        is_elastic: bool,
    },
    /// `block` or `membrane`, bisected so many times toward the middle of the contact edge.
    Graded {
        /// Levels of bisection.
        levels: usize,
        /// Elastic or scalar.
        is_elastic: bool,
    },
}

/// A problem by multigrid and by elimination.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AgainstElimination {
    /// Unknowns, prescribed ones included.
    pub unknowns: usize,
    /// |J − J'|/|J'|, J' by elimination; 0 for 0/0.
    pub energies_apart: f64,
    /// Constraints that are active for one solver only; `None` where contact is so weak that rounding decides.
    pub sets_apart: Option<usize>,
    /// True algebraic error in the energy norm, relative.
    pub algebraic: f64,
    /// Its estimate; `None` where elimination took over.
    pub estimate: Option<f64>,
    /// The factor 1 − κ of one cycle alone, as the gradients see it on the finest level.
    pub factor: Option<f64>,
    /// Gradient steps on the finest level.
    pub gradient_steps: Option<usize>,
    /// Most contact sets tried on a level, the coarsest included, with nothing known beforehand; on the mesh
    /// itself where elimination took over.
    pub set_steps: usize,
    /// Contact sets that elimination tries on the mesh itself, from no contact.
    pub cold_steps: usize,
    /// Whether both ended well.
    pub is_converged: bool,
    /// Why elimination took over.
    pub fallback: Option<Fallback>,
}

/// `block` where it is elastic, `membrane` where it is not.
fn plain(is_elastic: bool) -> TestProblem {
    if is_elastic { TestProblem::Block } else { TestProblem::Membrane }
}

impl HardCase {
    /// The scenes; `block` for λ/μ from 0 to 1000; and, scalar and elastic, corners, slivers, graded meshes.
    pub fn all() -> Vec<Self> {
        let mut cases: Vec<Self> = TestProblem::all().into_iter().map(Self::Scene).collect();
        cases.extend(RATIOS.map(Self::Compressibility));
        for is_elastic in [false, true] {
            cases.extend(ANGLES.map(|degrees| Self::Angle { degrees, is_elastic }));
            cases.extend(ASPECTS.map(|aspect| Self::Aspect { aspect, is_elastic }));
            cases.extend(BISECTED.map(|levels| Self::Graded { levels, is_elastic }));
        }
        cases
    }

    /// The problem, and its hierarchy where the mesh is no grid.
    ///
    /// # Errors
    /// Those of meshes and problems.
    pub fn problem(&self, n: usize) -> Result<(ContactProblem, Option<Hierarchy>)> {
        let with = |scene: TestProblem, setting| Ok((scene.problem_with(n, &setting)?, None));
        let setting = Parameters::default();
        match *self {
            Self::Scene(scene) => with(scene, setting),
            Self::Compressibility(ratio) => {
                let form = Form::elastic(Lame::new(ratio, 1.0)?);
                let mesh = TestProblem::Block.mesh(n)?;
                let load = Field::Vector(&|[x, _]| [0.0, -(PI * x).cos()]).sample(mesh.nodes())?;
                Ok((ContactProblem::new(mesh, form, &load)?, None))
            }
            Self::Angle { degrees, is_elastic } => {
                let scene = if is_elastic { TestProblem::Leaning } else { TestProblem::Corner };
                with(scene, Parameters { angle: degrees, ..setting })
            }
            Self::Aspect { aspect, is_elastic } => {
                let mesh = mapped_grid(n, n, SideParts::HANGING, |[x, y]| [x, y / aspect])?;
                Ok((plain(is_elastic).on(mesh)?, None))
            }
            Self::Graded { levels, is_elastic } => {
                let scene = plain(is_elastic);
                let doublings = (n / COARSEST).max(1).ilog2() as usize;
                let mut hierarchy = Hierarchy::refined(scene.mesh(COARSEST)?, doublings)?;
                hierarchy.refine_toward_point([0.5, 0.0], levels)?;
                Ok((scene.on(hierarchy.finest().clone())?, Some(hierarchy)))
            }
        }
    }

    /// Both solvers, multigrid to the given tolerance.
    ///
    /// # Errors
    /// Those of problems and solvers.
    pub fn against_elimination(
        &self,
        n: usize,
        cone: Cone,
        tolerance: impl Given<Tolerance>,
    ) -> Result<AgainstElimination> {
        let tolerance = tolerance.given()?;
        let (problem, hierarchy) = self.problem(n)?;
        AgainstElimination::of(&problem, hierarchy.as_ref(), cone, tolerance)
    }
}

impl AgainstElimination {
    /// Both solvers for a problem, multigrid on the given hierarchy or on every other line of its grid.
    ///
    /// # Errors
    /// Those of solvers.
    pub fn of(
        problem: &ContactProblem,
        hierarchy: Option<&Hierarchy>,
        cone: Cone,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let tolerance = tolerance.given()?;
        let (solver, accuracy) = (Solver::Multigrid, Accuracy::Relative(tolerance));
        let one = problem.solve(cone, Settings { solver, accuracy, hierarchy, ..Settings::default() })?;
        let other = problem.solve(cone, Solver::ActiveSet)?;
        let Some(found) = &one.multigrid else {
            return Err(Error::Solver { reason: "multigrid without a report".to_owned() });
        };
        let share = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { part / whole };
        let difference: Vec<f64> =
            one.displacement.iter().zip(&other.displacement).map(|(a, b)| a - b).collect();
        let norm = problem.energy_norm(&other.displacement)?;
        let levels = if found.fallback.is_none() { &found.levels[..] } else { &[] };
        let last = levels.last();
        let is_weak = other.margins.is_weak(WEAK);
        Ok(Self {
            unknowns: other.displacement.len(),
            energies_apart: share((one.energy - other.energy).abs(), other.energy.abs()),
            sets_apart: (!is_weak).then(|| one.contact_set.distance(&other.contact_set)),
            algebraic: share(problem.energy_norm(&difference)?, norm),
            estimate: found.error.filter(|_| found.fallback.is_none()).map(|error| error.relative_error()),
            factor: last.map(|level| level.factor),
            gradient_steps: last.map(|level| level.gradient_steps),
            set_steps: levels.iter().map(|level| level.steps).fold(found.coarsest_steps, usize::max),
            cold_steps: other.history.len(),
            is_converged: one.status.is_converged() && other.status.is_converged(),
            fallback: found.fallback,
        })
    }
}

impl fmt::Display for HardCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = |is_elastic| if is_elastic { "elastic" } else { "scalar" };
        match *self {
            Self::Scene(scene) => write!(f, "{scene}"),
            Self::Compressibility(ratio) => write!(f, "lambda/mu = {ratio}"),
            Self::Angle { degrees, is_elastic } => write!(f, "corner of {degrees}, {}", kind(is_elastic)),
            Self::Aspect { aspect, is_elastic } => write!(f, "aspect {aspect}, {}", kind(is_elastic)),
            Self::Graded { levels, is_elastic } => write!(f, "bisected {levels} times, {}", kind(is_elastic)),
        }
    }
}
