//! Section 2: elastic Signorini problems, by two unrelated solvers, judged by one function.
//!
//! `cargo run --release --example section_2_elastic_contact -- --n 64 --cone midpoint`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::contact::{Cone, Solver};
use signorini::report::Headline;
use signorini::scenes::{MeshScene, SceneStudy, Setting};
use signorini::{Error, Result};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Solve an elastic scene in one of the paper's two cones, on one mesh or on nested ones
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// block, incompressible, free or closed
    #[arg(long, default_value_t = MeshScene::Block)]
    pub scene: MeshScene,
    /// Cells along each side of the coarsest mesh
    #[arg(long, default_value_t = 32)]
    pub n: usize,
    /// Number of meshes n, 2n, 4n, ...
    #[arg(long, default_value_t = 1)]
    pub levels: usize,
    /// Discrete cone: nodal (2.9) or midpoint (4.1)
    #[arg(long, default_value_t = Cone::Nodal)]
    pub cone: Cone,
    /// active-set or interior-point; both unless given
    #[arg(long)]
    pub solver: Option<Solver>,
    /// Poisson's ratio of `incompressible`
    #[arg(long, default_value_t = Setting::default().poisson)]
    pub poisson: f64,
    /// Factor on the load
    #[arg(long, default_value_t = 1.0)]
    pub load_scale: f64,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        let Setting { poisson, load_scale, .. } = Setting::default();
        let (cone, solver) = (Cone::Nodal, None);
        let (scene, output) = (MeshScene::Block, Output::default());
        Self { scene, n: 32, levels: 1, cone, solver, poisson, load_scale, output }
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Solves the scene and says how well the discrete conditions are met.
pub fn run(options: &Options) -> Result<Headline> {
    if !options.scene.is_elastic() {
        let given = options.scene.to_string();
        return Err(Error::UnknownName {
            what: "elastic scene",
            given,
            expected: "block, incompressible, free or closed",
        });
    }
    let study = SceneStudy {
        scene: options.scene,
        setting: Setting { poisson: options.poisson, load_scale: options.load_scale, ..Setting::default() },
        cone: options.cone,
        solver: options.solver,
        n: options.n,
        levels: options.levels,
    };
    let runs = study.run()?;
    let mut headline = study.headline(&runs)?;
    let finest = runs.iter().map(|run| run.n).max();
    if let (Some(directory), Some(last)) =
        (options.output.directory()?, runs.iter().find(|run| Some(run.n) == finest))
    {
        let title = format!("Scene {}", options.scene);
        let name = |what: &str| format!("section_2_{}_{what}_{}", options.scene, options.cone);
        headline.figures.push(last.solution.save_body(&last.problem, &title, directory, &name("body"))?);
        headline.figures.push(last.solution.save_edge(&last.problem, &title, directory, &name("edge"))?);
        let history = last.solution.save_history(&last.problem, &title, directory, &name("history"))?;
        headline.figures.extend(history);
        headline.figures.extend(coarser(&study, &title, directory)?);
    }
    Ok(headline)
}

/// The body on meshes two, four and eight times coarser, for a picture that moves with h.
fn coarser(study: &SceneStudy, title: &str, directory: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for n in [study.n / 8, study.n / 4, study.n / 2].into_iter().filter(|&n| n >= 2) {
        let runs = SceneStudy { n, levels: 1, solver: Some(Solver::ActiveSet), ..*study }.run()?;
        for run in &runs {
            let name = format!("section_2_{}_body_{}_{n}", study.scene, study.cone);
            files.push(run.solution.save_body(&run.problem, title, directory, &name)?);
        }
    }
    Ok(files)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
