//! Figure 3.2, the alternative of Section 3 on a computed contact set: zeros of u_N near both vertices, or no pressure near one.
//!
//! `cargo run --release --example figure_3_2_alternative -- --scene fat-cantor --tau 1.7 --n 256 --meshes 8`
//! `cargo run --release --example figure_3_2_alternative -- --scene fat-cantor --tau 1.7 --n 256 --over-theta`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::Result;
use signorini::proof::Against;
use signorini::proof::{AlternativeCase, Section, ThetaRule};
use signorini::report::Headline;
use signorini::scenes::{MeshScene, Scene};
use std::process::ExitCode;

/// Classify every contact segment of meshes ..., n/2, n and add up the consistency term by case
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// A mesh scene (block, membrane, ...) or a strip scene (transition, transitions:8, cantor:0.3, fat-cantor, ...)
    #[arg(long, default_value_t = Scene::Mesh(MeshScene::Block))]
    pub scene: Scene,
    /// Contact segments of the finest mesh classified
    #[arg(long, default_value_t = 32)]
    pub n: usize,
    /// How many meshes, each with half the segments of the next
    #[arg(long, default_value_t = 3)]
    pub meshes: usize,
    /// Sobolev regularity of a strip scene, and in theta = h^(2 tau - 3), h^2 at tau = 2
    #[arg(long, default_value_t = 1.75)]
    pub tau: f64,
    /// A fixed theta in (0, 1) instead
    #[arg(long)]
    pub theta: Option<f64>,
    /// On whose contact set: reference (the fine solution) or itself (the discrete solution of each mesh)
    #[arg(long, default_value_t = Against::Reference)]
    pub against: Against,
    /// The finest mesh for theta = 1/2, 1/4, ... instead of several meshes
    #[arg(long)]
    pub over_theta: bool,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            scene: Scene::Mesh(MeshScene::Block),
            n: 32,
            meshes: 3,
            tau: 1.75,
            theta: None,
            against: Against::Reference,
            over_theta: false,
            output: Output::default(),
        }
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Classifies the segments and adds up the consistency term int sigma_N (I^h u)_N by case.
pub fn run(options: &Options) -> Result<Headline> {
    let case = AlternativeCase {
        section: Section::Three,
        source: options.scene.clone(),
        n: options.n,
        meshes: if options.over_theta { 1 } else { options.meshes },
        rule: options.theta.map_or(ThetaRule::Printed { tau: options.tau }, ThetaRule::Fixed),
        tau: options.tau,
        against: options.against,
    };
    let study = if options.over_theta { case.over_theta()? } else { case.over_size()? };
    study.headline(options.output.directory()?, "figure_3_2_alternative")
}

fn main() -> ExitCode {
    example_frame::main(run)
}
