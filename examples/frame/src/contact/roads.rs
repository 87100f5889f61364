//! The roads to one discrete solution: table, seconds and memory for accuracy, seconds for digits.

use crate::figures::{Axis, Chart, Series};
use crate::{Cell, Column, Finding, Format, Table};
use experiments::solver_variants::{SolverVariant, VariantRow};

/// Bytes in a megabyte.
const MEGABYTE: f64 = 1e6;

/// Every solution by every road with the most bytes held for it, coarsest mesh first.
pub fn road_table(rows: &[VariantRow], peaks: &[f64]) -> Table {
    let digits = Format::Significant(3);
    let meaning = "|u - u_h| in the H1 seminorm, against the known solution";
    let columns = vec![
        Column::new("n", "n", digits, ""),
        Column::new("road", "road", digits, ""),
        Column::new("error", "error", Format::Scientific(3), meaning),
        Column::new(
            "algebraic",
            "algebraic",
            Format::Scientific(1),
            "energy norm of the difference from elimination, relative",
        ),
        Column::new("estimate", "estimate", Format::Scientific(1), "the same as multigrid estimates it"),
        Column::new(
            "seconds",
            "seconds",
            Format::Scientific(1),
            "mesh, assembly, solution and KKT residuals",
        ),
        Column::new("peak", "MB", digits, "the most memory held for it, in 10^6 bytes"),
        Column::new("iterations", "steps", digits, ""),
        Column::new("kkt", "KKT", Format::Scientific(1), "worst scaled KKT figure"),
    ];
    Table::new(columns).with_rows(rows.iter().zip(peaks).map(|(row, peak)| -> [Cell; 9] {
        let VariantRow { n, road, error, algebraic, estimate, seconds, steps, kkt } = *row;
        let name = road.to_string().into();
        [
            n.into(),
            name,
            error.into(),
            algebraic.into(),
            estimate.into(),
            seconds.into(),
            (peak / MEGABYTE).into(),
            steps.into(),
            kkt.into(),
        ]
    }))
}

/// Steps, seconds and memory of two roads, on the finest mesh where both were taken.
pub fn road_costs(rows: &[VariantRow], peaks: &[f64]) -> Vec<Finding> {
    let on = |road, n| rows.iter().position(|row| row.road == road && row.n == n);
    let pair =
        |[a, b]: [SolverVariant; 2]| rows.iter().rev().find_map(|row| Some([on(a, row.n)?, on(b, row.n)?]));
    let saved = |roads| {
        let [more, less] = pair(roads)?.map(|k| rows[k].steps as f64);
        Some((more - less, 0.0))
    };
    let faster = |roads| {
        let [slow, fast] = pair(roads)?.map(|k| rows[k].seconds);
        Some((slow / fast, 0.5 * slow / fast))
    };
    let held = pair([SolverVariant::Nested, SolverVariant::Multigrid]).map(|both| both.map(|k| peaks[k]));
    let left = pair([SolverVariant::Interior, SolverVariant::Edge])
        .map(|both| both.map(|k| rows[k].algebraic.unwrap_or(f64::NAN)));
    let remark = |key, words, number| Finding::remark(key, words).number_or(number, "a road is missing");
    let equal = "equal seconds; a busy machine halves or doubles them";
    vec![
        remark(
            "nested",
            "a nested start saves {value} steps",
            saved([SolverVariant::Cold, SolverVariant::Nested]),
        )
        .at_least(1.0, "one step")
        .otherwise("a nested start saves no step")
        .told(),
        remark(
            "seconds",
            "the nested active set is {value} times as fast as the interior point",
            faster([SolverVariant::Interior, SolverVariant::Nested]),
        )
        .at_least(1.0, equal),
        remark(
            "seconds.edge",
            "on the edge the interior point is {value} times as fast as on the whole body",
            faster([SolverVariant::Interior, SolverVariant::Edge]),
        )
        .at_least(1.0, equal),
        remark(
            "seconds.beside",
            "on the edge the interior point takes {value} times the seconds of the active set",
            faster([SolverVariant::Edge, SolverVariant::Nested]),
        )
        .at_most(2.0, "twice the seconds"),
        remark(
            "edge.digits",
            "on the edge the interior point leaves {value} of its algebraic error on the whole body",
            left.map(|[whole, edge]| (edge / whole, 0.0)),
        )
        .at_most(0.1, "a tenth: one digit more"),
        remark(
            "seconds.multigrid",
            "multigrid is {value} times as fast as the nested active set",
            faster([SolverVariant::Nested, SolverVariant::Share]),
        )
        .at_least(1.0, equal),
        remark(
            "peak",
            "the nested active set holds {value} times the memory of multigrid",
            held.map(|[more, less]| (more / less, 0.0)),
        )
        .at_least(1.0, "equal memory"),
        remark(
            "digits",
            "ten digits take {value} cycles more than those that are worth something",
            saved([SolverVariant::Multigrid, SolverVariant::Share]),
        )
        .at_least(1.0, "one cycle")
        .otherwise("ten digits cost no cycle more"),
    ]
}

/// True error against seconds.
pub fn road_chart(rows: &[VariantRow]) -> Chart {
    let seconds = rows.iter().map(|row| row.seconds);
    error_chart("Known solution: seconds for accuracy", "seconds", rows, seconds)
}

/// True error against memory.
pub fn memory_chart(rows: &[VariantRow], peaks: &[f64]) -> Chart {
    let megabytes = peaks.iter().map(|peak| peak / MEGABYTE);
    error_chart("Known solution: memory for accuracy", "memory (10⁶ bytes)", rows, megabytes)
}

fn error_chart(
    title: &str,
    cost: &str,
    rows: &[VariantRow],
    costs: impl Iterator<Item = f64> + Clone,
) -> Chart {
    let (x, y) = (Axis::logarithmic(cost), Axis::logarithmic("error in the H¹ seminorm"));
    SolverVariant::ALL.into_iter().fold(Chart::new(title, x, y), |chart, road| {
        let same = rows.iter().zip(costs.clone()).filter(|(row, _)| row.road == road);
        chart.with(Series::line_and_points(
            road.to_string(),
            same.map(|(row, cost)| (cost, row.error)).collect(),
        ))
    })
}

/// Work against the precision of the algebra alone: a row for every mesh and road whose algebraic error is
/// known.
pub fn algebraic_chart(rows: &[VariantRow]) -> Chart {
    let (x, y) = (Axis::logarithmic("seconds"), Axis::logarithmic("true algebraic error, relative"));
    let chart = Chart::new("Known solution: seconds for digits of the discrete solution", x, y);
    [SolverVariant::Interior, SolverVariant::Edge, SolverVariant::Multigrid, SolverVariant::Share]
        .into_iter()
        .fold(chart, |chart, road| {
            let same = rows.iter().filter(|row| row.road == road);
            let points = same.filter_map(|row| Some((row.seconds, row.algebraic.filter(|&e| e > 0.0)?)));
            chart.with(Series::line_and_points(road.to_string(), points.collect()))
        })
}
