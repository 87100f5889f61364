//! Section 2: multigrid beside elimination on every scene, and on what is hard for its cycles:
//! materials that are nearly incompressible, corners, slivers, graded meshes.
//!
//! `cargo run --release --example section_2_multigrid -- --n 512 --levels 1`

use example_frame::contact::{RoadsRow as Row, compressibility_chart, two_roads_table, worst};
use example_frame::{Finding, Headline, Result, progress, within};
use experiments::hard_cases::HardCase;
use fractional_sobolev::Tolerance;
use signorini::cone::Cone;
use signorini::contact::Fallback;
use signorini::problems::TestProblem;
use std::process::ExitCode;

example_frame::options! {
    /// Multigrid and elimination on every scene and on hard cases
    pub struct Options {
        /// Cells along each side of the coarsest mesh
        #[arg(long, default_value_t = 32, value_parser = within::<usize>("[1, 1e6]"))]
        pub n: usize,
        /// Number of meshes n, 2n, 4n, ...
        #[arg(long, default_value_t = 2, value_parser = within::<usize>("[1, 12]"))]
        pub levels: usize,
        /// What is asked of multigrid on the scenes: algebraic error over the solution, in the energy norm
        #[arg(long, default_value_t = 1e-12)]
        pub tolerance: f64,
    }
    memory(options) {
        // Both roads on the finest mesh, with all that the hardest cases take.
        let unknowns = 2.0 * (options.n as f64 * (options.levels as f64 - 1.0).exp2() + 1.0).powi(2);
        14_500.0 * unknowns
    }
}

/// λ/μ up to which multigrid is used.
const MOST_INCOMPRESSIBLE: f64 = 100.0;
/// Digits asked for in the hard cases: conditions of a million leave no twelve.
const HARD: f64 = 1e-10;

/// Every case on every mesh, scenes in both cones; on a closed edge multigrid leaves means to elimination.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let [asked, hard] = [options.tolerance, options.tolerance.max(HARD)].map(Tolerance::new);
    let (asked, hard) = (asked?, hard?);
    let (cases, mut rows) = (HardCase::all(), Vec::new());
    let bar = progress((options.levels * cases.len()) as u64);
    for case in cases {
        for n in (0..options.levels).map(|level| options.n << level) {
            bar.set_message(format!("{case}, n = {n}"));
            let is_closed = case == HardCase::Scene(TestProblem::MembraneReaction);
            let is_scene = matches!(case, HardCase::Scene(_));
            for cone in Cone::ALL.into_iter().filter(|&c| c == Cone::Nodal || is_scene && !is_closed) {
                let tolerance = if is_scene { asked } else { hard };
                rows.push(Row { case, cone, n, found: case.against_elimination(n, cone, tolerance)? });
            }
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    Ok(rows)
}

/// J of two roads: it differs by the square of the error, and by rounding.
const ENERGIES: f64 = 1e-11;
/// What two solutions in binary64 may differ by in the energy norm, relative.
const ROUNDING: f64 = 1e-13;

/// What decides: both roads end at the same solution, or multigrid says why it did not.
pub fn findings(_: &Options, rows: &[Row]) -> Vec<Finding> {
    let count = |number: usize| (number as f64, 0.0);
    let cycles = || rows.iter().filter(|row| row.found.fallback.is_none());
    let apart = rows.iter().filter_map(|row| row.found.sets_apart).sum();
    let open = rows.iter().filter(|row| !row.found.is_converged).count();
    let promised = cycles().filter_map(|row| Some(row.found.algebraic / (row.found.estimate? + ROUNDING)));
    let beyond = |row: &&Row| matches!(row.case, HardCase::Compressibility(r) if r > MOST_INCOMPRESSIBLE);
    let silent = rows.iter().filter(beyond);
    let silent = silent.filter(|row| row.found.fallback != Some(Fallback::NearlyIncompressible)).count();
    let tried = |cone| cycles().filter(|row| row.cone == cone).map(|row| row.found.set_steps).max();
    let alone = rows.iter().map(|row| row.found.cold_steps).max();
    let is_sliver = |row: &&Row| matches!(row.case, HardCase::Aspect { .. });
    let slow = cycles().filter(is_sliver).filter_map(|row| row.found.factor).reduce(f64::max);
    let given_up = rows.iter().filter(|row| row.found.fallback == Some(Fallback::NotReached)).count();
    let coarser = |row: &&Row| {
        let before =
            cycles().find(|other| (other.case, other.cone, 2 * other.n) == (row.case, row.cone, row.n));
        Some(row.found.gradient_steps? as f64 / before?.found.gradient_steps?.max(1) as f64)
    };
    let growth = cycles()
        .filter(|row| !is_sliver(row))
        .filter_map(|row| coarser(&row))
        .reduce(f64::max)
        .map(|factor| (factor, 0.0));
    vec![
        Finding::claim("energies", "J of multigrid and of elimination differ by {value} at most")
            .number(worst(rows.iter().map(|row| row.found.energies_apart)), 0.0)
            .at_most(ENERGIES, "the square of the tolerance, and rounding")
            .otherwise("J of multigrid and of elimination differ by {value}")
            .told(),
        Finding::claim("sets", "their contact sets differ in {value} constraints, all runs together")
            .number_or(Some(count(apart)), "no run")
            .at_most(0.0, "the same sets")
            .told(),
        Finding::claim("ended", "{value} runs did not end well")
            .number_or(Some(count(open)), "no run")
            .at_most(0.0, "every run has a solution"),
        Finding::claim("promise", "a true algebraic error is {value} of its estimate at most")
            .number(worst(promised), 0.0)
            .at_most(1.0, "the estimate")
            .otherwise("a true algebraic error is {value} of its estimate"),
        Finding::claim(
            "beyond",
            "{value} runs with lambda/mu above a hundred do not say that elimination took over",
        )
        .number_or(Some(count(silent)), "no run")
        .at_most(0.0, "the range of the method"),
        Finding::remark("tried", "in the nodal cone {value} contact sets are tried on a level at most")
            .number_or(tried(Cone::Nodal).map(count), "no level")
            .at_most(3.0, "three linear systems")
            .otherwise("in the nodal cone up to {value} contact sets are tried on a level")
            .told(),
        Finding::remark("tried.midpoint", "in the midpoint cone {value} at most")
            .number_or(tried(Cone::Midpoint).map(count), "no level")
            .at_most(3.0, "three linear systems")
            .otherwise("in the midpoint cone up to {value}")
            .told(),
        Finding::remark("alone", "on one mesh, from no contact, elimination tries up to {value}")
            .number_or(alone.map(count), "no run")
            .at_least(4.0, "more than three")
            .otherwise("on one mesh, from no contact, elimination tries {value} at most"),
        Finding::remark(
            "growth",
            "but for slivers the next mesh takes {value} times as many gradient steps at most",
        )
        .number_or(growth, "a single mesh")
        .at_most(1.25, "five steps for four")
        .otherwise("but for slivers the next mesh takes up to {value} times as many gradient steps"),
        Finding::remark("slivers", "on slivers the factor of a cycle reaches {value}")
            .number_or(slow.map(|factor| (factor, 0.0)), "no run")
            .at_least(0.99, "230 cycles for a digit")
            .otherwise("on slivers the factor of a cycle stays below {value}"),
        Finding::remark(
            "given.up",
            "where cycles do not reach the digits elimination takes over: {value} runs",
        )
        .number_or(Some(count(given_up)), "no run")
        .at_least(1.0, "one run")
        .otherwise("cycles reach the digits wherever they are tried"),
    ]
}

/// A row for every run.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "contact by multigrid: the same solution as by elimination, or a word why not";
    let found = findings(options, &rows);
    let mut headline = Headline::new("Section 2, multigrid", claim, two_roads_table(&rows), found);
    headline.draw(&options.output, "section_2_multigrid_steps", || Ok(compressibility_chart(&rows)))?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
