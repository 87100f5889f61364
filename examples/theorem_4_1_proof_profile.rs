//! The proof of Theorem 4.1 line by line: both sides of (4.9)-(4.14) and the ladder from the consistency term to the bound.
//!
//! `cargo run --release --example theorem_4_1_proof_profile -- --scene fat-cantor --lines`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::Result;
use signorini::proof::{ProofCase, Resolution, Section, ThetaRule};
use signorini::report::Headline;
use signorini::scenes::StripScene;
use signorini::strip::Levels;
use std::process::ExitCode;

/// Compute both sides of every inequality of the proof on a manufactured pair (u_N, sigma_N)
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// transition[:POSITION], transitions:COUNT, cantor[:RATIO[:DEPTH]], fat-cantor[:DEPTH] or samples:FILE
    #[arg(long, default_value_t = StripScene::transition())]
    pub scene: StripScene,
    /// Regularity the proof assumes, in (3/2, 5/2)
    #[arg(long, default_value_t = 1.75)]
    pub tau: f64,
    /// Regularity the scene is built with; tau unless given
    #[arg(long)]
    pub scene_tau: Option<f64>,
    /// Exponent q of the embedding at tau = 2
    #[arg(long, default_value_t = 2.0)]
    pub q: f64,
    /// Mesh sizes h = 2^-COARSEST ... 2^-FINEST
    #[arg(long, default_value = "3-11")]
    pub levels: Levels,
    /// segment:K, 2^K fine cells per segment on every mesh, or edge:K, one grid of 2^K cells for all
    #[arg(long, default_value_t = Resolution::Segment(7))]
    pub resolution: Resolution,
    /// A fixed theta in (0, 1) instead of h^(2 tau - 3), h^2 at tau = 2
    #[arg(long)]
    pub theta: Option<f64>,
    /// Over how many positions in its cell a single transition is moved (odd)
    #[arg(long, default_value_t = 9)]
    pub positions: usize,
    /// Print the inequalities instead of the ladder
    #[arg(long)]
    pub lines: bool,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["theorem_4_1_proof_profile"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Profiles the proof on all meshes.
pub fn run(options: &Options) -> Result<Headline> {
    let case = ProofCase {
        section: Section::Four,
        source: options.scene.clone(),
        tau: options.tau,
        scene_tau: options.scene_tau.unwrap_or(options.tau),
        levels: options.levels,
        resolution: options.resolution,
        rule: options.theta.map_or(ThetaRule::Printed { tau: options.tau.min(2.0) }, ThetaRule::Fixed),
        positions: options.positions,
    };
    let profile = case.profile(&case.constants(options.q)?)?;
    profile.headline(options.output.directory()?, "theorem_4_1_proof_profile", options.lines)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
