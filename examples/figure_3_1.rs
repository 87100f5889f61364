//! Figure 3.1: the three printed curves over τ, and on them the orders that errors and consistency terms of
//! both cones show.
//!
//! `cargo run --release --example figure_3_1 -- --kind elastic --out out`

use example_frame::rates::{HALF_WIDTH, order_columns, orders_on_curves};
use example_frame::rates::{RateRow, both_cones, complete, fit_cells, highest, largest, lowest};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, within};
use experiments::ErrorExt;
use experiments::convergence::{Levels, StripGroup};
use signorini::problems::StripData;
use signorini::rates::Bound;
use signorini::strip::StripKind;
use std::process::ExitCode;

example_frame::options! {
    /// Exponents over the regularity: printed, and measured with their uncertainty
    pub struct Options {
        /// Regularities tau in (3/2, 2)
        #[arg(long, value_delimiter = ',', default_value = "1.55,1.6,1.65,1.7,1.75,1.8,1.85,1.9,1.95", value_parser = within::<f64>("(1.5, 2)"))]
        pub tau: Vec<f64>,
        /// scalar or elastic
        #[arg(long, default_value_t = StripKind::Scalar)]
        pub kind: StripKind,
        /// A scene on the strip
        #[arg(long, default_value_t = StripData::transition(), help = StripData::names())]
        pub scene: StripData,
        /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 32 times finer
        #[arg(long, default_value = "3-12")]
        pub levels: Levels,
        /// Positions of a single transition in its cell (odd: evenly spread on all levels)
        #[arg(long, default_value_t = 5)]
        pub positions: usize,
    }
    without_effect(options) {
        "positions" if !options.scene.moves() => "unless the scene is one transition",
    }
}

/// What is computed: the same scene at every τ in both cones, nodal first.
pub struct Computed {
    /// One pair per τ.
    pub pairs: Vec<[RateRow; 2]>,
}

/// Solves all levels at every τ in both cones.
pub fn compute(options: &Options) -> Result<Computed> {
    for &tau in &options.tau {
        fractional_sobolev::Error::require("tau", tau, "(3/2, 2)", tau > 1.5 && tau < 2.0)?;
    }
    let reference = (32 * options.levels.finest_cells()).min(1 << 22);
    let group = StripGroup::new(options.kind, options.levels, reference);
    let group = group.with(&options.scene, &options.tau, options.positions)?;
    Ok(Computed { pairs: both_cones(&group)? })
}

/// What decides: every order against the curve of the paper and against the optimal line, with its bar.
pub fn findings(_: &Options, Computed { pairs }: &Computed) -> Vec<Finding> {
    let rows = || pairs.iter().flatten();
    let without = "an order is missing";
    let ratios = |k: usize| rows().map(move |row| row.from_optimal()[k]);
    let distances = rows().map(|row| row.above(Bound::Optimal).map(|(distance, _)| distance.abs()));
    let beside = largest(ratios(0)).map(|_| ratios(0).filter(|r| r.is_some_and(|r| r.abs() > 1.0)).count());
    let terms = ratios(1).filter(Option::is_some).map(|ratio| ratio.map(f64::abs));
    let mut found = vec![
        complete(rows().map(|row| &row.study)),
        Finding::claim(
            "above",
            "no measured order lies below the curve of the paper with its bar: the least sure reaches {value} above it",
        )
        .number_or(lowest(rows().map(|row| row.above(Bound::Paper))).map(highest), without)
        .at_least(0.0, "tau^2 - 5tau/2 + 2, (3.1)")
        .otherwise("an order lies below the curve of the paper, by {value}")
        .told(),
        Finding::claim("optimal", "no order stays below the optimal line by more than its bar")
            .number_or(largest(ratios(0).map(|ratio| ratio.map(|r| -r))), without)
            .at_most(1.0, "tau - 1, Drouet & Hild 2015; in units of the bar")
            .otherwise("an order stays below the optimal line by {value} times its bar"),
        Finding::remark("line", "every bar meets the optimal line")
            .number_or(beside.map(|count| (count as f64, 0.0)), without)
            .at_most(0.0, "tau - 1")
            .otherwise("{value} bars miss the optimal line")
            .told(),
        Finding::remark("distance", "no order is further than {value} from the optimal line")
            .number_or(largest(distances), without)
            .at_most(0.5 * SIXTEENTH, "half of 1/16, the largest gap between the curves")
            .otherwise("an order is {value} away from the optimal line"),
        Finding::remark("terms", "the bars of the consistency terms meet the optimal line as well")
            .number_or(largest(terms), "no term could be fitted")
            .at_most(1.0, "tau - 1; in units of the bar"),
    ];
    found.extend(rows().filter(|row| row.study.tau == 1.75).map(|row| {
        let cone = row.study.cone;
        Finding::remark(format!("sixteenth.{cone}"), format!("at tau = 7/4 the {cone} cone gains {{value}}"))
            .number_or(row.above(Bound::Paper), without)
            .within(0.5 * SIXTEENTH, SIXTEENTH, "3/4 - 11/16, Figure 3.1")
    }));
    found
}

/// (τ − 3/2)(2 − τ) at τ = 7/4.
const SIXTEENTH: f64 = 1.0 / 16.0;

/// Measures the orders and sets them beside the curves.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "the exponent tau^2-5tau/2+2 lies above tau/2-1/4 and below tau-1, furthest from it (1/16) at tau = 7/4";
    let found = findings(options, &computed);
    let mut headline = Headline::new("Figure 3.1", claim, table(&computed.pairs)?, found);
    for row in computed.pairs.iter().flatten() {
        for (what, fit) in [("error", row.error), ("term", row.term)] {
            let key = format!("figure.3.1.{}.{what}.{:.0}", row.study.cone, 100.0 * row.study.tau);
            RateRow::quote(&mut headline, &key, fit);
        }
    }
    headline.draw(&options.output, "figure_3_1", || orders_on_curves(&computed.pairs))?;
    Ok(headline)
}

fn table(pairs: &[[RateRow; 2]]) -> Result<Table> {
    let three = Format::Fixed(3);
    let mut columns = vec![
        Column::new("tau", "tau", Format::Plain, "supremum of the tau with u in H^tau"),
        Column::new("earlier", "(E2)", three, "tau/2 - 1/4"),
        Column::new("paper", "(N1)", three, "tau^2 - 5tau/2 + 2"),
        Column::new("optimal", "tau-1", three, "optimal"),
    ];
    for (keys, title, of, half_width) in [
        (["nodal_error", "nodal_error_half"], "error K", "error, nodal cone", HALF_WIDTH),
        (["nodal_term", "nodal_term_half"], "term K", "root of the consistency term, nodal cone", ""),
        (["midpoint_error", "midpoint_error_half"], "error M", "error, midpoint cone", ""),
        (["midpoint_term", "midpoint_term_half"], "term M", "root of the term, midpoint cone", ""),
    ] {
        columns.extend(order_columns(keys, title, of, half_width));
    }
    columns.push(Column::new("left_out", "out", Format::Plain, "levels left out of the fits"));
    let mut table = Table::new(columns);
    for pair in pairs {
        let tau = pair[0].study.tau;
        let mut row: Vec<Cell> = vec![tau.into()];
        for bound in [Bound::Earlier, Bound::Paper, Bound::Optimal] {
            row.push(bound.exponent(tau)?.into());
        }
        row.extend(pair.iter().flat_map(|row| [row.error, row.term]).flat_map(fit_cells));
        row.push(pair.iter().map(|row| row.study.left_out()).sum::<usize>().into());
        table.push(row);
    }
    Ok(table)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
