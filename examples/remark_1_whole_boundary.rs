//! Remark 1 as printed: −Δu + u = f, u ≤ 0, ∂u/∂n ≤ 0, u ∂u/∂n = 0 on the whole boundary, in both cones.
//!
//! Rates of one transition whose solution is known; `membrane-reaction`, whose load knows nothing of its
//! contact set, by two solvers.
//!
//! `cargo run --release --example remark_1_whole_boundary -- --meshes 9`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::rates::{HALF_WIDTH, RateRow, against_theorem, complete, fit_cells, largest, lowest};
use example_frame::rates::{on_meshes, order_columns};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, progress, within};
use experiments::convergence::{Quantity, TransitionRates};
use signorini::cone::Cone;
use signorini::contact::{ContactSolution, Solver};
use signorini::problems::{TestProblem, TransitionPowers};
use signorini::rates::Bound;
use std::process::ExitCode;

example_frame::options! {
    /// The scalar problem of Remark 1: rates of both cones with contact on all four sides
    pub struct Options: Long {
        /// Number of meshes with 2, 4, 8, ... squares along each side
        #[arg(long, default_value_t = 8, value_parser = within::<usize>("[1, 10]"))]
        pub meshes: usize,
        /// Squares along each side where a second solver is asked
        #[arg(long, default_value_t = 16)]
        pub n: usize,
    }
    memory(options) {
        (2700.0 * (options.n as f64).powi(2)).max(2100.0 * (2.0 * options.meshes as f64).exp2())
    }
}

/// Regularities of the transition; at τ = 2 its slopes are like |ln r|^{−1}, in H².
const TAUS: [f64; 3] = [1.75, 2.0, 2.25];
/// Squares of the coarsest mesh.
const COARSEST: usize = 2;

/// What is computed.
pub struct Computed {
    /// Rates of the transitions, nodal cone first.
    pub rows: Vec<[RateRow; 2]>,
    /// `membrane-reaction` in both cones, by the active set and by the interior point method.
    pub solved: Vec<[ContactSolution; 2]>,
}

/// Solves all scenes on all meshes, and one of them by a second solver.
pub fn compute(options: &Options) -> Result<Computed> {
    let (scene, levels) = (TestProblem::MembraneReaction, options.meshes);
    let problem = scene.problem(options.n)?;
    let mut rows = Vec::new();
    for tau in TAUS {
        let logarithm = if tau == 2.0 { 1.0 } else { 0.0 };
        let powers = TransitionPowers { logarithm, ..TransitionPowers::of_regularity(tau) };
        let (whole_boundary, coarsest) = (true, COARSEST);
        rows.push(on_meshes(&TransitionRates { powers, tau, whole_boundary, coarsest, levels })?);
    }
    let bar = progress(4);
    let solved = Cone::ALL.map(|cone| {
        let by = |solver| {
            bar.inc(1);
            problem.solve(cone, solver)
        };
        Ok::<_, signorini::Error>([by(Solver::ActiveSet)?, by(Solver::InteriorPoint)?])
    });
    bar.finish_and_clear();
    Ok(Computed { rows, solved: solved.into_iter().collect::<signorini::Result<_>>()? })
}

/// Eight digits of J.
const AGREED: f64 = 1e-8;

/// What decides: orders against (3.1), (3.2), (4.2)-(4.4), both solvers, the conditions.
pub fn findings(_: &Options, Computed { rows, solved }: &Computed) -> Vec<Finding> {
    let all = || rows.iter().flatten();
    let mut found = vec![complete(all().map(|row| &row.study))];
    found.extend(all().map(|row| {
        let (cone, key, words) = (row.study.cone, row.key(), row.words());
        against_theorem(format!("{key}.{cone}"), &format!("{words}, {cone} cone"), row)
    }));
    let apart = solved.iter().map(|[a, b]| {
        let rounding = (a.energy_rounding + b.energy_rounding) / b.energy.abs();
        Some(((a.energy / b.energy - 1.0).abs(), rounding))
    });
    let apart = apart.reduce(|a, b| if a >= b { a } else { b }).flatten();
    let differ = solved.iter().map(|[a, b]| (a.contact_set != b.contact_set) as u8 as f64).sum::<f64>();
    let kkt = all().map(|row| row.study.levels.iter().map(|level| level.kkt).fold(0.0, f64::max));
    let off = all().map(|row| row.above(Bound::Optimal).map(|(d, u)| d.abs() / u));
    let below = || rows.iter().flatten().filter(|row| row.study.tau < 2.0);
    found.extend([
        Finding::claim("solvers", "two solvers agree in J in both cones, apart by {value}")
            .number_or(apart, "no solution")
            .at_most(AGREED, "eight digits of J"),
        Finding::remark("sets", "both find the same contact set in both cones")
            .number(differ, 0.0)
            .at_most(0.0, "no cone in which they differ"),
        Finding::claim("conditions", "balance, signs and complementarity hold to {value} on every mesh")
            .number_or(largest(kkt.map(Some)), "no level")
            .at_most(1e-10, "worst scaled Karush-Kuhn-Tucker figure"),
        Finding::sharpness(
            "loss",
            "for tau < 2 the least sure order is {value} +- {uncertainty} above (3.1), (4.2)",
        )
        .number_or(lowest(below().map(|row| row.above(Bound::Paper))), "an order is missing")
        .at_least(0.0, "the exponent of the theorem")
        .told(),
        Finding::remark("bars", "every order is min(tau - 1, 1) within its bar")
            .number_or(largest(off), "no order")
            .at_most(1.0, "the optimal exponent; in units of +-")
            .told(),
    ]);
    found
}

/// Solves the problem of Remark 1 in both cones.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "the theorems hold for -div grad u + u = f with contact on the whole boundary, in both cones";
    let found = findings(options, &computed);
    let mut headline = Headline::new("Remark 1", claim, table(&computed), found);
    for pair in &computed.rows {
        RateRow::quote_pair(&mut headline, &format!("remark.1.{}", pair[0].key()), pair);
    }
    headline.draw(&options.output, "remark_1_whole_boundary", || Ok(draw(&computed)))?;
    Ok(headline)
}

/// Errors of both cones against h.
fn draw(Computed { rows, .. }: &Computed) -> Chart {
    let (x, y) = (Axis::logarithmic("mesh size h"), Axis::logarithmic("error in the energy norm"));
    let mut chart = Chart::new("Remark 1: contact on the whole boundary", x, y);
    for [nodal, midpoint] in rows {
        let points = |row: &RateRow| row.study.points(Quantity::Error);
        let name = format!("{}, midpoint", nodal.words());
        chart = chart.with(Series::line(nodal.words(), points(nodal)));
        chart = chart.with(Series::points(name, points(midpoint)));
    }
    chart
}

fn table(Computed { rows, .. }: &Computed) -> Table {
    let mut columns = vec![
        Column::new("scene", "scene", Format::Plain, "closed transition: u is known"),
        Column::new("tau", "tau", Format::Plain, "u in H^tau (supremum, but at 2)"),
        Column::new("paper", "paper", Format::Fixed(3), "exponent of the theorems"),
    ];
    columns.extend(order_columns(["nodal", "nodal_half"], "nodal", "error, nodal cone", HALF_WIDTH));
    columns.extend(order_columns(["midpoint", "midpoint_half"], "midp.", "error, midpoint cone", ""));
    Table::new(columns).with_rows(rows.iter().map(|pair| {
        let study = &pair[0].study;
        let paper = Bound::Paper.exponent(study.tau).ok();
        let first: [Cell; 3] = [study.subject.name().into(), study.tau.into(), paper.into()];
        first.into_iter().chain(pair.iter().flat_map(|row| fit_cells(row.error))).collect::<Vec<_>>()
    }))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
