//! Section 2: the elastic Signorini problem `block`, by two unrelated solvers, judged by one function.
//!
//! `cargo run --release --example section_2_elastic_contact -- --n 64 --cone midpoint`

use clap::Parser;
use example_frame::{HasOutput, Output};
use signorini::Result;
use signorini::contact::{Cone, ContactSolution, Solver};
use signorini::report::{Headline, Table, Verdict};
use signorini::scenes::Scene;
use std::process::ExitCode;

/// Solve the scene `block` on n x n squares in one of the paper's two cones
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Squares along each side
    #[arg(long, default_value_t = 32)]
    pub n: usize,
    /// Discrete cone: nodal (2.9) or midpoint (4.1)
    #[arg(long, default_value_t = Cone::Nodal)]
    pub cone: Cone,
    /// active-set or interior-point; both unless given
    #[arg(long)]
    pub solver: Option<Solver>,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self { n: 32, cone: Cone::Nodal, solver: None, output: Output::default() }
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Both solvers must agree in J to this, relative: the interior point method is asked for 1e-10 or better.
const AGREEMENT: f64 = 1e-8;

/// Every scaled KKT figure must be below this.
const JUDGED: f64 = 1e-10;

/// Solves the scene and says how well the discrete conditions are met.
pub fn run(options: &Options) -> Result<Headline> {
    let problem = Scene::Block.problem(options.n)?;
    let solvers =
        options.solver.map_or(vec![Solver::ActiveSet, Solver::InteriorPoint], |solver| vec![solver]);
    let mut table = Table::new(ContactSolution::columns());
    let mut solutions = Vec::new();
    for solver in solvers {
        let solution = problem.solve(options.cone, solver)?;
        table.push(solution.row(options.n, &problem));
        solutions.push(solution);
    }
    let first = &solutions[0];
    let worst = solutions.iter().fold(0.0, |w: f64, s| w.max(s.judgement.worst()));
    let apart = solutions.iter().fold(0.0, |w: f64, s| w.max((s.energy / first.energy - 1.0).abs()));
    let measured = format!(
        "J = {:.12}, {} of {} constraints active, contact force {:.8}, KKT {worst:.0e}",
        first.energy,
        first.contact_set.count(),
        first.contact_set.constraints(),
        first.contact_force,
    );
    let verdict = if worst <= JUDGED && apart <= AGREEMENT {
        Verdict::Holds
    } else {
        Verdict::NotConfirmed(format!("KKT {worst:.1e}, energies apart by {apart:.1e}"))
    };
    let claim =
        format!("the elastic problem in the {} cone has one solution; every solver finds it", options.cone);
    let label = match options.cone {
        Cone::Nodal => "Section 2, (2.9), elastic",
        Cone::Midpoint => "Section 4, (4.1), elastic",
    };
    let mut headline = Headline::new(label, claim, table, measured, verdict);
    for (key, value) in [
        ("energy", first.energy),
        ("force", first.contact_force),
        ("active", first.contact_set.count() as f64),
        ("kkt", worst),
    ] {
        headline.quote(format!("section.2.block.{}.{key}", options.cone), value);
    }
    if let Some(directory) = options.output.directory()? {
        let name = |what: &str| format!("section_2_block_{what}_{}", options.cone);
        headline.figures.push(first.save_body(&problem, "Scene block", directory, &name("body"))?);
        headline.figures.push(first.save_edge(&problem, "Scene block", directory, &name("edge"))?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
