//! The introduction: (E1)-(E4), (N1), (N2), each with what a scene of its regularity shows.
//!
//! "Any" contact set: a fat Cantor set (τ < 2), 22 transitions; a natural transition inside an edge is
//! r^{3/2}. (E1), (E3), (E4) on strips and on meshes of the square.
//!
//! `cargo run --release --example introduction_rates -- --levels 3-16 --out out`

use example_frame::rates::{HALF_WIDTH, order_columns, printed_and_measured, printed_rates};
use example_frame::rates::{Printed, RateRow, complete, fit_cells, highest, largest, lowest};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, within};
use experiments::convergence::Levels;
use signorini::rates::Bound;
use std::process::ExitCode;

example_frame::options! {
    /// Printed rates and measured orders
    pub struct Options: Long {
        /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 16 times finer
        #[arg(long, default_value = "4-14")]
        pub levels: Levels,
        /// Number of meshes with 2, 4, 8, ... squares along each side
        #[arg(long, default_value_t = 7, value_parser = within::<usize>("[1, 10]"))]
        pub meshes: usize,
    }
}

/// What is computed: each printed rate with its scene in both cones, nodal first.
pub struct Computed {
    /// In the order of the table.
    pub rows: Vec<(Printed, [RateRow; 2])>,
}

/// Solves the scene of each printed rate in both cones.
pub fn compute(options: &Options) -> Result<Computed> {
    Ok(Computed { rows: printed_rates(options.levels, options.meshes)? })
}

/// An order read off a finite series may stay this far below the exponent it tends to; |ln h|^{1/2} alone
/// takes 1/(2 |ln h|) = 0.07 from it at h = 2^{−10}.
const SERIES: f64 = 0.1;

/// What decides: each measured order against the printed exponent, and against min(τ − 1, 1).
pub fn findings(_: &Options, computed: &Computed) -> Vec<Finding> {
    let rows = || computed.rows.iter().flat_map(|(_, pair)| pair);
    let without = "an order is missing";
    let mut found = vec![complete(rows().map(|row| &row.study))];
    for (&Printed { key, label, exponent, .. }, pair) in computed.rows.iter().map(|(row, pair)| (row, pair)) {
        for row in pair {
            // A printed rate that is the optimal one is approached, not passed.
            let less = if exponent >= (row.study.tau - 1.0).min(1.0) { SERIES } else { 0.0 };
            let (to, source) = match less > 0.0 {
                true => (" to a tenth of an order", ", less a tenth: finite series"),
                false => ("", ""),
            };
            let words = format!(
                "reached{to} in the {} cone, {}: order {{value}} or less",
                row.study.cone,
                row.words()
            );
            found.push(
                Finding::claim(format!("{key}.{}", row.study.cone), format!("{label} is {words}"))
                    .number_or(
                        row.order().map(highest),
                        "too few levels, or an error that is not a positive number",
                    )
                    .at_least(exponent - less, format!("{label}, {exponent:.4}{source}"))
                    .otherwise(format!("{label} is not {words}")),
            );
        }
    }
    let off = || rows().map(|row| row.above(Bound::Optimal));
    let missed = lowest(off()).map(|_| off().flatten().filter(|(d, u)| d.abs() > *u).count() as f64);
    let above = largest(off().map(|number| number.map(|(distance, u)| distance - u)));
    let gains = rows().filter(|row| row.study.tau == 1.75).map(|row| row.above(Bound::Paper));
    found.extend([
        Finding::sharpness(
            "gain",
            "at tau = 7/4 the least sure order is {value} +- {uncertainty} above (N1)",
        )
        .number_or(lowest(gains), without)
        .at_least(0.0, "11/16, (N1); fat Cantor sets included")
        .told(),
        Finding::remark("bars", "every bar holds min(tau - 1, 1), for every contact set tried")
            .number_or(missed.map(|count| (count, 0.0)), without)
            .at_most(0.0, "the optimal exponent; orders of the scenes in both cones")
            .otherwise("{value} of the bars do not hold min(tau - 1, 1)")
            .told(),
        Finding::remark("ceiling", "no order is above min(tau - 1, 1) by more than its bar")
            .number_or(above, without)
            .at_most(0.0, "piecewise linear functions can do no more"),
    ]);
    found
}

/// Solves a scene for each row in both cones.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "(E1)-(E4) known before, (N1), (N2) new: the printed rates are reached by every scene";
    let mut headline = Headline::new("Introduction", claim, table(&computed), findings(options, &computed));
    for (k, (_, pair)) in computed.rows.iter().enumerate() {
        RateRow::quote_pair(&mut headline, &format!("introduction.{}", k + 1), pair);
    }
    let pairs = || computed.rows.iter().map(|(_, pair)| pair);
    headline.draw(&options.output, "introduction_rates", || printed_and_measured(pairs()))?;
    Ok(headline)
}

fn table(Computed { rows }: &Computed) -> Table {
    let mut columns = vec![
        Column::new("label", "label", Format::Plain, ""),
        Column::new("tau", "tau", Format::Plain, "u in H^tau (supremum, but for \"transition in H^2\")"),
        Column::new("assumption", "set", Format::Plain, "finite: only for finitely many transitions"),
        Column::new("rate", "printed rate", Format::Plain, ""),
        Column::new("exponent", "exp", Format::Fixed(3), "exponent of h in it"),
        Column::new("scene", "scene", Format::Plain, ""),
    ];
    columns.extend(order_columns(["nodal", "nodal_half"], "nodal", "error, nodal cone", HALF_WIDTH));
    columns.extend(order_columns(["midpoint", "midpoint_half"], "midp.", "error, midpoint cone", ""));
    columns.push(Column::new("left_out", "out", Format::Plain, "levels left out"));
    let mut table = Table::new(columns);
    for (printed, pair) in rows {
        let Printed { label, tau, assumption, rate, exponent, .. } = *printed;
        let printed = [
            label.into(),
            tau.into(),
            assumption.into(),
            rate.into(),
            exponent.into(),
            printed.scene().into(),
        ];
        let mut row: Vec<Cell> = printed.to_vec();
        row.extend(pair.iter().flat_map(|row| fit_cells(row.error)));
        row.push(pair.iter().map(|row| row.study.left_out()).sum::<usize>().into());
        table.push(row);
    }
    table
}

fn main() -> ExitCode {
    example_frame::main(run)
}
