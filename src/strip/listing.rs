//! A level study as a table, and its mean order.

use super::exact::Level;
use crate::estimate::Estimate;
use crate::report::{Column, Format, Table};

/// Least squares slope over the finer half of the levels; `None` for fewer than three levels or an error that vanishes.
pub fn mean_order(levels: &[Level], errors: &[Estimate]) -> Option<f64> {
    let first = levels.len() / 2;
    let points = || (first..levels.len()).map(|i| ((levels[i].cells as f64).log2(), errors[i].value.log2()));
    let count = points().count() as f64;
    let (x, y) = points().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / count, b + y / count));
    let (xy, xx) = points().fold((0.0, 0.0), |(a, b), (u, v)| (a + (u - x) * (v - y), b + (u - x).powi(2)));
    let order = -xy / xx;
    order.is_finite().then_some(order)
}

/// One row per level: n, unknowns, error, order, contact runs, steps, inner iterations, KKT, seconds.
pub fn level_table(levels: &[Level], errors: &[Estimate]) -> Table {
    let mut table = Table::new(vec![
        Column::new("cells", "n", Format::Significant(7), ""),
        Column::hidden("h"),
        Column::new(
            "unknowns",
            "unknowns",
            Format::Scientific(1),
            "of the two-dimensional problem solved exactly",
        ),
        Column::new("error", "error", Format::Scientific(6), "energy norm of u - u_h"),
        Column::hidden("error_bound"),
        Column::new(
            "order",
            "order",
            Format::Fixed(3),
            "log2 of the ratio; it alternates with the place of a transition in its cell",
        ),
        Column::new(
            "contact_runs",
            "runs",
            Format::Significant(6),
            "stretches of consecutive active constraints",
        ),
        Column::new(
            "steps",
            "steps",
            Format::Significant(3),
            "linear problems; start from the coarser level",
        ),
        Column::new("inner", "inner", Format::Significant(3), "most inner iterations in a step"),
        Column::new(
            "kkt",
            "KKT",
            Format::Scientific(0),
            "worst scaled violation of balance, sign, gap and complementarity; 0 is exact",
        ),
        Column::new("seconds", "seconds", Format::Significant(2), "operator, load, contact"),
        Column::hidden("error_seconds"),
    ]);
    for (i, level) in levels.iter().enumerate() {
        let order =
            (i > 0).then(|| (errors[i - 1].value / errors[i].value).log2()).filter(|order| order.is_finite());
        table.push(vec![
            level.cells.into(),
            (1.0 / level.cells as f64).into(),
            level.virtual_unknowns.into(),
            errors[i].value.into(),
            errors[i].error.into(),
            order.into(),
            level.contact_runs.into(),
            level.inner_iterations.len().into(),
            level.inner_iterations.iter().copied().max().unwrap_or(0).into(),
            level.kkt.into(),
            level.seconds.into(),
            level.error_seconds.into(),
        ]);
    }
    table
}
