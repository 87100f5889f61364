//! The introduction: (E1)-(E4), (N1), (N2), each with what a scene of its regularity shows.
//!
//! "Any" contact set: a fat Cantor set (τ < 2), 22 transitions; a natural transition inside an edge is r^{3/2}.
//!
//! `cargo run --release --example introduction_rates -- --levels 3-16 --out out`

use example_frame::rates::{HALF_WIDTH, order_columns, printed_and_measured};
use example_frame::rates::{RateRow, both_cones, complete, fit_cells, largest, lowest};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table};
use signorini::convergence::{Bound, SceneFamily, StripGroup};
use signorini::scenes::{StripScene, TransitionPowers};
use signorini::strip::{Levels, StripKind};
use std::process::ExitCode;

example_frame::options! {
    /// Printed rates and measured orders
    pub struct Options {
        /// Levels COARSEST-FINEST: n = 2^level cells along the edge; the reference is 16 times finer
        #[arg(long, default_value = "4-14")]
        pub levels: Levels,
    }
}

/// What stands for a regularity: one transition, one in H² (slopes like |ln r|^{−1}), 22, a fat Cantor set.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)]
pub enum Shape {
    Transition,
    InH2,
    Many,
    FatCantor,
}

/// Key, label, regularity, scene, "finite" for finitely many transitions only, printed rate, its exponent.
type Printed = (&'static str, &'static str, f64, Shape, &'static str, &'static str, f64);
const PRINTED: [Printed; 11] = [
    ("e1.below", "(E1)", 1.4, Shape::Transition, "", "h^(tau-1)", 0.4),
    ("e1", "(E1)", 1.5, Shape::Transition, "", "h^(tau-1)", 0.5),
    ("e2", "(E2)", 1.75, Shape::FatCantor, "", "h^(tau/2-1/4)", 0.625),
    ("e2.finite", "(E2)", 1.75, Shape::Transition, "finite", "h^(tau-1)", 0.75),
    ("n1.cantor", "(N1)", 1.75, Shape::FatCantor, "", "h^(tau^2-5tau/2+2)", 0.6875),
    ("n1.many", "(N1)", 1.75, Shape::Many, "", "h^(tau^2-5tau/2+2)", 0.6875),
    ("e3", "(E3)", 2.0, Shape::Many, "", "h^(3/4)", 0.75),
    ("e3.finite", "(E3)", 2.0, Shape::InH2, "finite", "h |ln h|^(1/2) ... h", 1.0),
    ("n2", "(N2)", 2.0, Shape::InH2, "", "h |ln h|^(1/2)", 1.0),
    ("e4", "(E4)", 2.25, Shape::Transition, "", "h", 1.0),
    ("e4.natural", "(E4)", 2.5, Shape::Transition, "", "h", 1.0),
];

/// What is computed: each printed rate with its scene in both cones, nodal first.
pub struct Computed {
    /// In the order of the table.
    pub rows: Vec<(Printed, [RateRow; 2])>,
}

/// Solves the scene of each printed rate in both cones; scenes that come twice are solved once.
pub fn compute(options: &Options) -> Result<Computed> {
    let coarsest = options.levels.coarsest_cells();
    let named = |scene: StripScene, tau| SceneFamily::named(&scene, tau, StripKind::Scalar, coarsest, 1);
    let in_h2 = TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: 1.0 };
    let family = |&(_, _, tau, shape, ..): &Printed| match shape {
        Shape::Transition => Ok(SceneFamily::at_thirds(TransitionPowers::of_regularity(tau), tau, coarsest)),
        Shape::InH2 => Ok(SceneFamily::at_thirds(in_h2, tau, coarsest)),
        Shape::Many => named(StripScene::Transitions { gaps: 11 }, tau),
        Shape::FatCantor => named(StripScene::FatCantor { depth: 30 }, tau),
    };
    let reference = (16 * options.levels.finest_cells()).min(1 << 22);
    let mut group = StripGroup::new(StripKind::Scalar, options.levels, reference);
    group.families = PRINTED.iter().map(family).collect::<signorini::Result<_>>()?;
    Ok(Computed { rows: PRINTED.into_iter().zip(both_cones(&group)?).collect() })
}

/// An order read off a finite series may stay this far below the exponent it tends to; |ln h|^{1/2} alone
/// takes 1/(2 |ln h|) = 0.07 from it at h = 2^{−10}.
const SERIES: f64 = 0.1;

/// What decides: each measured order against the printed exponent, and against min(τ − 1, 1).
pub fn findings(_: &Options, computed: &Computed) -> Vec<Finding> {
    let rows = || computed.rows.iter().flat_map(|(_, pair)| pair);
    let without = "an order is missing";
    let mut found = vec![complete(rows().map(|row| &row.study))];
    for (&(key, label, .., exponent), pair) in computed.rows.iter().map(|(printed, pair)| (printed, pair)) {
        for row in pair {
            // A printed rate that is the optimal one is approached, not passed.
            let less = if exponent >= (row.study.tau - 1.0).min(1.0) { SERIES } else { 0.0 };
            let words = format!("reached in the {} cone, {}: order {{value}}", row.study.cone, row.words());
            found.push(
                Finding::claim(format!("{key}.{}", row.study.cone), format!("{label} is {words}"))
                    .number_or(row.order(), "too few levels, or an error that is not a positive number")
                    .at_least(exponent - less, format!("{label}, {exponent}; less {less}: finite series"))
                    .otherwise(format!("{label} is not {words}")),
            );
        }
    }
    let off = || rows().map(|row| row.above(Bound::Optimal));
    let missed = lowest(off()).map(|_| off().flatten().filter(|(d, u)| d.abs() > *u).count() as f64);
    let above = largest(off().map(|number| number.map(|(distance, u)| distance - u)));
    let gains = rows().filter(|row| row.study.tau == 1.75).map(|row| row.above(Bound::Paper));
    found.extend([
        Finding::sharpness("gain", "at tau = 7/4 the nearest order is {value} +- {uncertainty} above (N1)")
            .number_or(lowest(gains), without)
            .at_least(0.0, "11/16, (N1); fat Cantor sets included")
            .told(),
        Finding::remark("bars", "every bar holds min(tau - 1, 1), whatever the contact set")
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
    for (&(_, label, tau, shape, finite, rate, exponent), pair) in rows.iter().map(|(p, pair)| (p, pair)) {
        let scene = match shape {
            Shape::Transition => "transition",
            Shape::InH2 => "transition in H^2",
            Shape::Many => "transitions",
            Shape::FatCantor => "fat-cantor",
        };
        let printed = [label.into(), tau.into(), finite.into(), rate.into(), exponent.into(), scene.into()];
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
