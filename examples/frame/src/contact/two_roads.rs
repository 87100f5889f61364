//! Multigrid beside elimination: table, and steps over λ/μ.

use crate::figures::{Axis, Chart, Series};
use crate::{Cell, Column, Format, Table};
use experiments::hard_cases::{AgainstElimination, HardCase};
use signorini::cone::Cone;
use std::collections::BTreeSet;

/// One problem by both roads.
pub struct RoadsRow {
    /// What it is.
    pub case: HardCase,
    /// In which cone.
    pub cone: Cone,
    /// Cells along each side.
    pub n: usize,
    /// What was found.
    pub found: AgainstElimination,
}

/// A row for every run.
pub fn two_roads_table(rows: &[RoadsRow]) -> Table {
    let (digits, error) = (Format::Significant(3), Format::Scientific(0));
    let columns = vec![
        Column::new("case", "problem", digits, ""),
        Column::new("cone", "cone", digits, ""),
        Column::new("n", "n", digits, ""),
        Column::new("energies", "J", error, "difference in J from elimination, relative"),
        Column::new("sets", "sets", digits, "constraints active for one of the two only; - weak contact"),
        Column::new("algebraic", "error", error, "true algebraic error in the energy norm, relative"),
        Column::new("estimate", "estimate", error, "the same as multigrid estimates it"),
        Column::new("factor", "factor", Format::Fixed(3), "of one cycle alone, as the gradients see it"),
        Column::new("steps", "steps", digits, "gradient steps on the finest level"),
        Column::new("tried", "tried", digits, "most contact sets tried on a level, from nothing known"),
        Column::new("cold", "one mesh", digits, "the same by elimination on the mesh alone, from no contact"),
        Column::new("word", "taken", digits, "which solver was taken, and why"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| -> [Cell; 12] {
        let found = &row.found;
        let word = found.fallback.map_or("multigrid".to_owned(), |why| why.to_string());
        [
            row.case.to_string().into(),
            row.cone.to_string().into(),
            row.n.into(),
            found.energies_apart.into(),
            found.sets_apart.into(),
            found.algebraic.into(),
            found.estimate.into(),
            found.factor.into(),
            found.gradient_steps.into(),
            found.set_steps.into(),
            found.cold_steps.into(),
            word.into(),
        ]
    }))
}

/// Gradient steps over λ/μ, a line for every mesh.
pub fn compressibility_chart(rows: &[RoadsRow]) -> Chart {
    let (x, y) = (Axis::logarithmic("1 + λ/μ"), Axis::logarithmic("gradient steps on the finest level"));
    let chart = Chart::new("Steps for the same digits: materials hard to compress", x, y);
    let meshes: BTreeSet<usize> = rows.iter().map(|row| row.n).collect();
    meshes.into_iter().fold(chart, |chart, n| {
        let point = |row: &RoadsRow| match row.case {
            HardCase::Compressibility(ratio) if row.n == n => {
                Some((1.0 + ratio, row.found.gradient_steps? as f64))
            }
            _ => None,
        };
        chart.with(Series::line_and_points(format!("n = {n}"), rows.iter().filter_map(point).collect()))
    })
}
