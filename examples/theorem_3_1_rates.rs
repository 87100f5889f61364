//! Theorems 3.1 (nodal cone), 4.1 (midpoint cone): errors and consistency terms beside the bounds and
//! h^{τ−1}.
//!
//! `cargo run --release --example theorem_3_1_rates`
//! `cargo run --release --example theorem_3_1_rates -- --scene fat-cantor --tau 1.65 --levels 4-14`
//! `cargo run --release --example theorem_4_1_rates -- --full --out out`

use example_frame::rates::{LevelStore, RatePlan, RateRow, against_theorem, complete, largest, lowest};
use example_frame::rates::{level_table, rate_table, term_above_one, term_remarks, write_and_draw};
use example_frame::{Finding, Headline, Result};
use experiments::convergence::{Levels, Quantity};
use signorini::cone::Cone;
use signorini::problems::NamedProblem;
use signorini::rates::Bound;
use signorini::strip::StripKind;
use std::process::ExitCode;

example_frame::options! {
    /// Errors and consistency terms against h for many regularities; with --scene one scene level by level
    pub struct Options: Long {
        /// One scene, level by level
        #[arg(long, help = format!("One scene, level by level: {}", NamedProblem::names()))]
        pub scene: Option<NamedProblem>,
        /// Regularities in (3/2, 5/2] (default: 1.55 to 1.95, 2, 2.1, 2.25, 2.4)
        #[arg(long, value_delimiter = ',')]
        pub tau: Vec<f64>,
        /// The corners of the study alone, at --levels
        #[arg(long)]
        pub corners: bool,
        /// Strip of --scene: scalar or elastic
        #[arg(long, default_value_t = StripKind::Scalar)]
        pub kind: StripKind,
        /// Levels of --scene or --corners: n = 2^level cells along the edge
        #[arg(long, default_value = "3-12")]
        pub levels: Levels,
        /// Positions of a single transition in its cell over which --scene averages
        #[arg(long, default_value_t = 7)]
        pub positions: usize,
        /// The study of the book: minutes; finished levels are kept in a file under --out, not computed again
        #[arg(long)]
        pub full: bool,
    }
    without_effect(options) {
        "kind" if !matches!(options.scene, Some(NamedProblem::Strip(_))) => "unless --scene is a scene of the strip",
        "levels" if options.scene.is_none() && !options.corners => "without --scene or --corners",
        "corners" if options.scene.is_some() => "beside --scene",
        "positions" if !matches!(&options.scene, Some(NamedProblem::Strip(scene)) if scene.moves()) => "unless --scene is one transition",
        "tau" if matches!(options.scene, Some(NamedProblem::Mesh(_))) => "on meshes: theirs follows from the angle",
        "tau" if options.scene.is_some() && options.tau.len() > 1 => "beyond its first value with --scene",
        "full" if options.scene.is_some() || options.corners => "beside --scene or --corners",
    }
}

/// What is computed: each scene at each τ, with the orders of error and consistency term.
pub struct Computed {
    /// Strips before corners.
    pub rows: Vec<RateRow>,
}

/// The regularity of the study of one scene: the paper's rate is furthest from the optimal one.
const FURTHEST: f64 = 1.75;

/// Solves all levels of all scenes in one cone.
pub fn compute(cone: Cone, options: &Options) -> Result<Computed> {
    let tau = options.tau.first().copied().unwrap_or(FURTHEST);
    let plan = match &options.scene {
        Some(scene) => RatePlan::of_scene(scene, options.kind, options.levels, tau, options.positions)?,
        None if options.corners => RatePlan::corners(options.levels).with_taus(&options.tau)?,
        None if options.full => RatePlan::full()?.with_taus(&options.tau)?,
        None => RatePlan::short()?.with_taus(&options.tau)?,
    };
    let directory = options.output.directory()?;
    let file = format!("{}_levels.jsonl", names(cone)[1]);
    let mut store = LevelStore::within(directory.filter(|_| options.full), &file)?;
    let rows = plan.rows(cone, &mut store)?;
    Ok(Computed { rows })
}

/// What decides: each order against the theorem's exponent; all against τ − 1 (Drouet and Hild 2015).
pub fn findings(_: &Options, Computed { rows, .. }: &Computed) -> Vec<Finding> {
    let mut found = vec![complete(rows.iter().map(|row| &row.study))];
    found.extend(rows.iter().map(|row| against_theorem(format!("{}.theorem", row.key()), &row.words(), row)));
    found.extend(rows.iter().filter(|row| row.study.tau > 2.0).map(term_above_one));
    let below: Vec<&RateRow> = rows.iter().filter(|row| row.study.tau < 2.0).collect();
    if below.is_empty() {
        return found;
    }
    let ratios = || below.iter().map(|row| row.from_optimal()[0]);
    let gains = below.iter().filter(|row| !row.is_fat()).map(|row| row.above(Bound::Paper));
    let nearest = "for tau < 2 the least sure order is {value} +- {uncertainty} above the theorem's";
    let without = "an order is missing";
    found.extend([
        Finding::sharpness("loss", nearest)
            .number_or(lowest(gains), without)
            .at_least(0.0, "the exponent of the theorem")
            .told(),
        Finding::claim("optimal", "for tau < 2 no order stays below tau - 1 by more than its uncertainty")
            .number_or(largest(ratios().map(|ratio| ratio.map(|r| -r))), without)
            .at_most(1.0, "h^(tau-1), Drouet & Hild 2015; in units of +-")
            .otherwise("an order stays below tau - 1 by {value} times its uncertainty"),
        Finding::remark("attained", "for tau < 2 every order is tau - 1 within its uncertainty")
            .number_or(largest(ratios().map(|ratio| ratio.map(f64::abs))), without)
            .at_most(1.0, "tau - 1; in units of +-")
            .otherwise("for tau < 2 an order is {value} times its uncertainty away from tau - 1")
            .told(),
    ]);
    found.extend(term_remarks(&below));
    found
}

/// The number of the theorem, and how its files begin.
fn names(cone: Cone) -> [&'static str; 2] {
    if cone == Cone::Nodal { ["3.1", "theorem_3_1"] } else { ["4.1", "theorem_4_1"] }
}

/// The outcome for one cone.
pub fn outcome(cone: Cone, options: &Options) -> Result<Headline> {
    let computed = compute(cone, options)?;
    let rows = &computed.rows;
    let [number, name] = names(cone);
    let words = "the error is at most C h^(tau^2-5tau/2+2), tau = 2: C h |ln h|^(1/2)";
    let claim = format!("{cone} cone, u in H^tau, 3/2 < tau < 2: {words}");
    let single = rows.first().filter(|_| options.scene.is_some());
    let table = single.map_or_else(|| rate_table(rows), |row| level_table(&row.study))?;
    let mut headline = Headline::new(format!("Theorem {number}"), claim, table, findings(options, &computed));
    for row in rows {
        let key = format!("theorem.{number}.{}", row.key());
        RateRow::quote(&mut headline, &key, row.error);
        headline.quote(format!("{key}.ratio"), row.study.constant(Quantity::Error, Bound::Paper)?);
    }
    if let Some(directory) = options.output.directory()? {
        write_and_draw(&mut headline, rows, directory, name)?;
    }
    Ok(headline)
}

/// Theorem 3.1.
pub fn run(options: &Options) -> Result<Headline> {
    outcome(Cone::Nodal, options)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
