//! The roads to one discrete solution: table, seconds for accuracy, seconds for digits.

use crate::figures::{Axis, Chart, Series};
use crate::{Cell, Column, Format, Table};
use signorini::scenes::{Road, RoadRow};

/// Every solution by every road, coarsest mesh first.
pub fn road_table(rows: &[RoadRow]) -> Table {
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
        Column::new("seconds", "seconds", Format::Scientific(1), "mesh, assembly, solution and judgement"),
        Column::new("iterations", "steps", digits, ""),
        Column::new("kkt", "KKT", Format::Scientific(1), "worst scaled KKT figure"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| -> [Cell; 8] {
        let RoadRow { n, road, error, algebraic, estimate, seconds, steps, kkt } = *row;
        let name = road.to_string().into();
        [
            n.into(),
            name,
            error.into(),
            algebraic.into(),
            estimate.into(),
            seconds.into(),
            steps.into(),
            kkt.into(),
        ]
    }))
}

/// True error against seconds.
pub fn road_chart(rows: &[RoadRow]) -> Chart {
    let (x, y) = (Axis::logarithmic("seconds"), Axis::logarithmic("error in the H¹ seminorm"));
    let chart = Chart::new("Known solution: seconds for accuracy", x, y);
    Road::ALL.into_iter().fold(chart, |chart, road| {
        let same = rows.iter().filter(|row| row.road == road);
        chart.with(Series::line_and_points(
            road.to_string(),
            same.map(|row| (row.seconds, row.error)).collect(),
        ))
    })
}

/// Work against the precision of the algebra alone: a row for every mesh and road whose algebraic error is
/// known.
pub fn algebraic_chart(rows: &[RoadRow]) -> Chart {
    let (x, y) = (Axis::logarithmic("seconds"), Axis::logarithmic("true algebraic error, relative"));
    let chart = Chart::new("Known solution: seconds for digits of the discrete solution", x, y);
    [Road::Interior, Road::Multigrid, Road::Share].into_iter().fold(chart, |chart, road| {
        let same = rows.iter().filter(|row| row.road == road);
        let points = same.filter_map(|row| Some((row.seconds, row.algebraic.filter(|&e| e > 0.0)?)));
        chart.with(Series::line_and_points(road.to_string(), points.collect()))
    })
}
