//! Table and figures of the alternatives, Figures 3.2 and 4.1.

use crate::figures::{Axis, Chart, PALETTE, Series};
use crate::{Column, Format, Result, Table};
use experiments::proof::{AlternativeRow, AlternativeStudy};
use signorini::problems::NamedProblem;
use signorini::proof::{Alternative, Classification};
use signorini::rates::order_between;

/// Points of a trace that are drawn.
const DRAWN: usize = 2000;

/// Cases with their names and colours.
pub const CASES: [(Alternative, &str, usize); 3] =
    [(Alternative::First, "first", 4), (Alternative::Second, "second", 5), (Alternative::Both, "both", 2)];

/// Counts and consistency terms by case, one row per mesh or θ.
///
/// # Errors
/// None in practice: the lengths agree.
pub fn table(study: &AlternativeStudy) -> Result<Table> {
    let (count, share) = (Format::Significant(3), Format::Scientific(2));
    let columns = vec![
        Column::new("n", "1/h", Format::Plain, "contact segments per unit length"),
        Column::new("theta", "theta", count, "share of a segment that counts as near"),
        Column::new("first", "first", count, "segments in the first case only"),
        Column::new("second", "second", count, "segments in the second case only"),
        Column::new("both", "both", count, "segments in both cases"),
        Column::new("none", "none", count, "segments in neither: would contradict the paper"),
        Column::new("term_first", "term, first", share, "their part of the consistency term"),
        Column::new("term_second", "term, second", share, ""),
        Column::new("term_both", "term, both", share, ""),
        Column::new("order", "order", Format::Fixed(2), "observed order of the whole term in h"),
    ];
    let mut table = Table::new(columns);
    let mut before = None;
    for row in &study.rows {
        let found = &row.classification;
        let point = (1.0 / row.n as f64, found.total());
        let order = before.replace(point).map(|coarse| order_between(coarse, point));
        let order = order.filter(|order| order.is_finite());
        let counts = [Alternative::First, Alternative::Second, Alternative::Both, Alternative::Neither]
            .map(|case| found.count(case) as f64);
        let terms = CASES.map(|(case, ..)| found.term(case));
        let numbers = [[row.n as f64, row.theta].as_slice(), &counts, &terms].concat();
        table.push(numbers.into_iter().map(Into::into).chain([order.into()]).collect());
    }
    Ok(table)
}

/// One row: cases as bands behind u_N and the contact pressure.
pub fn edge_chart(label: &str, study: &AlternativeStudy, row: &AlternativeRow) -> Chart {
    let (trace, source) = (&study.trace, &study.case.source);
    let step = trace.nodes().len().div_ceil(DRAWN);
    let scaled = |values: &[f64]| -> Vec<(f64, f64)> {
        let largest = values.iter().fold(f64::MIN_POSITIVE, |m: f64, v| m.max(v.abs()));
        trace.nodes().iter().zip(values).step_by(step).map(|(&x, v)| (x, v / largest)).collect()
    };
    let unit = match source {
        NamedProblem::Mesh(_) => "side of the square = 1",
        NamedProblem::Strip(_) => "period = 1",
    };
    let x = Axis::linear(format!("x along the contact edge ({unit})"));
    let title = format!("{label} on scene {source}, 1/h = {}, θ = {:.3}", row.n, row.theta);
    let mut chart = Chart::new(title, x, Axis::linear("share of the largest value"))
        .with(Series::line("u_N", scaled(trace.displacement())))
        .with(Series::line("−σ_N, contact pressure", scaled(&trace.pressure())));
    for (case, name, colour) in CASES {
        let intervals = row.classification.intervals(case);
        if !intervals.is_empty() {
            let name =
                if case == Alternative::Both { "both cases".to_owned() } else { format!("{name} case") };
            chart = chart.with_bands(name, intervals, PALETTE[colour]);
        }
    }
    chart
}

/// Shares of the segments (dashed) and of the consistency term by case, over h or over θ.
pub fn shares_chart(label: &str, over_theta: bool, study: &AlternativeStudy) -> Chart {
    let x = Axis::logarithmic(if over_theta { "θ" } else { "h (edge = 1)" });
    let title = format!("{label} on scene {}: what each case carries", study.case.source);
    let mut chart = Chart::new(title, x, Axis::linear("share").range(-0.05, 1.05));
    for (case, name, colour) in CASES {
        let points = |share: &dyn Fn(&Classification) -> f64| -> Vec<(f64, f64)> {
            let at = |r: &AlternativeRow| {
                if over_theta { r.theta } else { 1.0 / r.n as f64 }
            };
            study.rows.iter().map(|r| (at(r), share(&r.classification))).filter(|p| p.1.is_finite()).collect()
        };
        let term = points(&|c| c.term(case) / c.total());
        let count = points(&|c| c.count(case) as f64 / c.segments().len() as f64);
        chart = chart
            .with(Series::line_and_points(format!("{name}: share of the term"), term).colour(PALETTE[colour]))
            .with(Series::dashed(format!("{name}: share of the segments"), count).colour(PALETTE[colour]));
    }
    chart
}
