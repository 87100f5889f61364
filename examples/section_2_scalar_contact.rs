//! Section 2: scalar Signorini problems, by two unrelated solvers, judged by one function.
//!
//! `cargo run --release --example section_2_scalar_contact -- --scene corner --angle 135 --n 8 --levels 5`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::contact::{Cone, Solver};
use signorini::report::Headline;
use signorini::scenes::{MeshScene, SceneStudy, Setting};
use signorini::{Error, Result};
use std::process::ExitCode;

/// Solve a scalar scene in one of the paper's two cones, on one mesh or on nested ones
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// membrane, membrane-reaction, corner or manufactured
    #[arg(long, default_value_t = MeshScene::Membrane)]
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
    /// Opening of the corner at the left end of the contact edge of `corner`, degrees
    #[arg(long, default_value_t = Setting::default().angle)]
    pub angle: f64,
    /// Factor on the load
    #[arg(long, default_value_t = 1.0)]
    pub load_scale: f64,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        let Setting { angle, load_scale, .. } = Setting::default();
        let (cone, solver) = (Cone::Nodal, None);
        let (scene, output) = (MeshScene::Membrane, Output::default());
        Self { scene, n: 32, levels: 1, cone, solver, angle, load_scale, output }
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Solves the scene and says how well the discrete conditions are met.
pub fn run(options: &Options) -> Result<Headline> {
    if options.scene.is_elastic() {
        let given = options.scene.to_string();
        return Err(Error::UnknownName {
            what: "scalar scene",
            given,
            expected: "membrane, membrane-reaction, corner or manufactured",
        });
    }
    let study = SceneStudy {
        scene: options.scene,
        setting: Setting { angle: options.angle, load_scale: options.load_scale, ..Setting::default() },
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
        headline.figures.push(last.solution.save_edge(&last.problem, &title, directory, &name("edge"))?);
        let history = last.solution.save_history(&last.problem, &title, directory, &name("history"))?;
        headline.figures.extend(history);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
