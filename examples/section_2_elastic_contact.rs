//! Section 2: problems on meshes by two independent solvers, with the KKT residuals of each. Scalar: Remark 1.
//!
//! `cargo run --release --example section_2_elastic_contact -- --n 64 --cone midpoint`

use example_frame::{Error, Finding, Headline, Result, contact};
use experiments::contact_levels::{SceneRun, SceneStudy};
use fractional_sobolev::Tolerance;
use signorini::cone::{Cone, KKT_ROUNDING, KktResiduals};
use signorini::contact::{Accuracy, Solver};
use signorini::problems::TestProblem::{Corner, Leaning, Raised, Taper};
use signorini::problems::{Parameters, TestProblem};
use std::process::ExitCode;

example_frame::options! {
    /// Solve a scene in one of the paper's two cones, on one mesh or on nested ones
    pub struct Options: Quick {
        /// The scene
        #[arg(long, help = format!("A scene of {}", TestProblem::names()))]
        pub scene: Option<TestProblem>,
        /// Cells along each side of the coarsest mesh
        #[arg(long, default_value_t = 32)]
        pub n: usize,
        /// Number of meshes n, 2n, 4n, ...
        #[arg(long, default_value_t = 1)]
        pub levels: usize,
        /// Discrete cone: nodal (2.9) or midpoint (4.1)
        #[arg(long, default_value_t = Cone::Nodal)]
        pub cone: Cone,
        /// active-set, interior-point, edge-interior-point, multigrid or auto; unless given two, the second one for a check
        #[arg(long)]
        pub solver: Option<Solver>,
        /// Algebraic error asked of multigrid, energy norm, relative (default: 1/100 of that of the mesh)
        #[arg(long)]
        pub tolerance: Option<Tolerance>,
        /// Poisson's ratio of `incompressible`
        #[arg(long, default_value_t = Parameters::default().poisson)]
        pub poisson: f64,
        /// Opening of the corner at the left end of the contact edge of `corner`, degrees
        #[arg(long, default_value_t = Parameters::default().angle)]
        pub angle: f64,
        /// Factor on the load
        #[arg(long, default_value_t = 1.0)]
        pub load_scale: f64,
        /// A body of one's own
        #[command(flatten)]
        pub own: contact::OwnOptions,
    }
    without_effect(options) {
        "scene" if options.own.mesh.is_some() => "beside --mesh",
        "n" if options.own.mesh.is_some() => "beside --mesh",
        "material" if !options.own.is_own() => "without --mesh or --load",
        "poisson" if !options.own.material.is_empty() => "beside --material",
        "poisson" if options.scene != Some(TestProblem::Incompressible) => "unless the scene is incompressible",
        "angle" if !matches!(options.scene, Some(Corner | Leaning | Raised | Taper)) =>
            "unless the scene is corner, leaning, raised or taper",
        "tolerance" if matches!(options.solver, Some(Solver::ActiveSet | Solver::InteriorPoint)) => "with a direct solver",
    }
}

/// Which problem: (2.1)-(2.7) or Remark 1; each has its scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Problem {
    /// A displacement field.
    Elastic,
    /// One unknown.
    Scalar,
}

/// What is computed: every solution, coarsest mesh first, on each mesh one solver after the other.
pub struct Computed {
    subject: contact::ContactSubject,
    /// All of them.
    pub runs: Vec<SceneRun>,
}

/// Solves the scene on every mesh.
pub fn compute(problem: Problem, options: &Options) -> Result<Computed> {
    let Options { n, levels, cone, solver, poisson, angle, load_scale, tolerance, .. } = *options;
    let (default, other) = match problem {
        Problem::Elastic => (TestProblem::Block, "section_2_scalar_contact"),
        Problem::Scalar => (TestProblem::Membrane, "section_2_elastic_contact"),
    };
    let scene = options.scene.unwrap_or(default);
    if scene.is_elastic() != (problem == Problem::Elastic) {
        return Err(Error::Option(format!("scene {scene} belongs to the example {other}")));
    }
    let setting = Parameters { angle, poisson, load_scale };
    let accuracy = tolerance.map(Accuracy::Relative);
    let study = SceneStudy { scene, setting, cone, solver, n, levels, accuracy };
    let subject = contact::ContactSubject::new(study, &options.own)?;
    Ok(Computed { runs: subject.solve()?, subject })
}

/// A scaled condition may be violated by the error asked for, or by a duality gap of 1e-13 over 1000
/// unknowns.
const KKT_LIMIT: f64 = 1e-10;
/// What a sum over all nodes, or a second solver, must confirm.
const EIGHT_DIGITS: f64 = 1e-8;

/// What decides: every solution meets the four conditions, forces add up, solvers and packages agree.
pub fn findings(_: &Options, computed: &Computed) -> Vec<Finding> {
    let Computed { subject, runs } = computed;
    let kkt: Option<Vec<KktResiduals>> = runs.iter().map(|run| run.kkt().ok()).collect();
    let sum = contact::worst(runs.iter().map(|run| run.solution.balance));
    let force = runs.last().map(|run| run.solution.contact_force).map(|f| (f, sum * f.abs()));
    let asked = runs.iter().filter_map(|run| Some(run.error()?.relative_error())).fold(KKT_LIMIT, f64::max);
    let stalled = runs.iter().filter(|run| !run.solution.status.is_converged()).count();
    let mut found = vec![
        Finding::claim("forces", "loads, reactions and contact force add up to zero")
            .number(sum, KKT_ROUNDING)
            .at_most(asked.max(EIGHT_DIGITS), "eight digits of a sum over all nodes, or the error asked for")
            .otherwise("too few digits: loads, reactions and contact force add up to {value}"),
        Finding::claim("push", "the foundation pushes with {value}")
            .number_or(force, "no solution")
            .at_least(0.0, "sigma_N <= 0")
            .otherwise("the foundation pulls, {value}")
            .told(),
        Finding::claim("converged", "every iteration came to its end")
            .number(stalled as f64, 0.0)
            .at_most(0.0, "no solver stalled or cycled"),
        Finding::claim("unique", "there is one solution").by_proof("section_2_elastic_contact"),
    ];
    for (key, holds, fails, figure) in contact::CONDITIONS {
        let worst = kkt.as_ref().map(|all| (contact::worst(all.iter().map(figure)), KKT_ROUNDING));
        let condition = Finding::claim(key, holds).number_or(worst, "a force or a gap is not a number");
        let bound = "a duality gap of 1e-13 over 1000 unknowns, or the error asked for";
        found.push(condition.at_most(asked, bound).otherwise(fails));
    }
    if runs.len() > subject.levels() {
        found.extend(contact::solvers_agree(runs, EIGHT_DIGITS));
    }
    found.extend(subject.packages_agree(runs));
    found
}

/// Solves an elastic scene and says how well the discrete conditions are met.
pub fn run(options: &Options) -> Result<Headline> {
    show(Problem::Elastic, options)
}

/// Solves a scene of either problem; quoted and drawn is the solution on the finest mesh.
pub fn show(problem: Problem, options: &Options) -> Result<Headline> {
    let computed = compute(problem, options)?;
    let Computed { subject, runs } = &computed;
    let cone = subject.cone();
    let kind = if problem == Problem::Elastic { "elastic" } else { "scalar" };
    let section = if cone == Cone::Nodal { "Section 2, (2.9)" } else { "Section 4, (4.1)" };
    let claim = format!("the {kind} problem in the {cone} cone is solved: one minimum, every condition met");
    let (label, found) = (format!("{section}, {kind}"), findings(options, &computed));
    let mut headline = Headline::new(label, claim, subject.table(runs), found);
    subject.finish(&mut headline, runs, &options.own, &options.output)?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
