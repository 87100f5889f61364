//! Section 2: true error against seconds, for both solvers, cold and nested starts, on a scene with known
//! solution.
//!
//! `cargo run --release --example section_2_speed_for_accuracy -- --levels 6`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, contact, progress};
use signorini::cone::{Cone, NOISE};
use signorini::scenes::{Road, RoadRow, manufactured_by_every_road};
use std::process::ExitCode;

example_frame::options! {
    /// Seconds against true error on the scene `manufactured`, u = -Re (z - 2/5)^{3/2}
    pub struct Options {
        /// Squares along each side of the coarsest mesh
        #[arg(long, default_value_t = 8)]
        pub n: usize,
        /// Number of meshes n, 2n, 4n, ...
        #[arg(long, default_value_t = 5)]
        pub levels: usize,
        /// Discrete cone
        #[arg(long, default_value_t = Cone::Nodal)]
        pub cone: Cone,
    }
}

/// What is computed: every mesh by every road; on the coarsest there is nothing to start from.
pub struct Computed {
    /// Coarsest mesh first.
    pub rows: Vec<RoadRow>,
}

/// Solves on every mesh by every road and measures the error against the known solution.
pub fn compute(options: &Options) -> Result<Computed> {
    let bar = progress(options.levels as u64);
    let rows = manufactured_by_every_road(options.n, options.levels, options.cone, || bar.inc(1))?;
    bar.finish_and_clear();
    Ok(Computed { rows })
}

/// What a condition may be violated by: a duality gap of 1e-13 summed over the unknowns of a mesh of n = 32.
const JUDGED: f64 = 1e-10;
/// The order settles from mesh to mesh, as the transition moves in its cell: a tenth.
const SETTLING: f64 = 0.1;
/// Digits of the error that two ways to one discrete solution share: half of those of J.
const SHARED: f64 = 1e-6;

/// The orders between consecutive meshes on the cold road, and the mean one.
fn orders(rows: &[RoadRow]) -> Option<(Vec<f64>, f64)> {
    let errors: Vec<f64> = rows.iter().filter(|row| row.road == Road::Cold).map(|row| row.error).collect();
    let orders: Vec<f64> = errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect();
    let mean = orders.iter().sum::<f64>() / orders.len() as f64;
    (orders.len() >= 2).then_some((orders, mean))
}

/// What decides: the order of the error, the conditions, and whether the roads meet.
pub fn findings(_: &Options, computed: &Computed) -> Vec<Finding> {
    let rows = &computed.rows;
    let order = orders(rows).map(|(all, mean)| (mean, contact::worst(all.iter().map(|o| (o - mean).abs()))));
    let finest = rows.iter().map(|row| row.n).max();
    let on = |road: Road, n: Option<usize>| rows.iter().find(|row| row.road == road && Some(row.n) == n);
    let apart =
        rows.iter().filter_map(|row| Some((row.error / on(Road::Cold, Some(row.n))?.error - 1.0).abs()));
    let [cold, nested, interior] = Road::ALL.map(|road| on(road, finest));
    let saved = cold.zip(nested).map(|(cold, nested)| (cold.steps as f64 - nested.steps as f64, 0.0));
    let faster = interior.zip(nested).map(|(slow, fast)| slow.seconds / fast.seconds);
    vec![
        Finding::claim("order", "the error in the energy norm falls with order {value}")
            .number_or(order, "fewer than three meshes")
            .within(SETTLING, 1.0, "linear elements, u in H^{5/2-eps}")
            .otherwise("order {value} is not that of linear elements, 1")
            .told(),
        Finding::claim("conditions", "every solution meets the discrete conditions")
            .number(contact::worst(rows.iter().map(|row| row.kkt)), NOISE)
            .at_most(JUDGED, "a duality gap of 1e-13 over 1000 unknowns")
            .otherwise("a discrete condition is violated by {value}"),
        Finding::claim("roads", "every road ends at the same error")
            .number(contact::worst(apart), NOISE)
            .at_most(SHARED, "six digits of the error")
            .otherwise("two roads differ by {value} of the error"),
        Finding::remark("nested", "a nested start saves {value} steps on the finest mesh")
            .number_or(saved, "a road is missing")
            .at_least(1.0, "one step")
            .otherwise("a nested start saves no step")
            .told(),
        Finding::remark("seconds", "the nested active set is {value} times as fast as the interior point")
            .number_or(faster.map(|factor| (factor, 0.5 * factor)), "a road is missing")
            .at_least(1.0, "equal seconds; a busy machine halves or doubles them"),
    ]
}

/// Seconds for accuracy by three roads.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "order 1 in the energy norm for u in H^{5/2-eps}, whatever solves the discrete problem";
    let found = findings(options, &computed);
    let table = table(&computed.rows);
    let mut headline = Headline::new("Section 2, speed for accuracy", claim, table, found);
    if let Some((_, order)) = orders(&computed.rows) {
        headline.quote(format!("section.2.speed.{}.order", options.cone), order);
    }
    let name = format!("section_2_seconds_{}", options.cone);
    headline.draw(&options.output, &name, || Ok(draw(&computed.rows)))?;
    Ok(headline)
}

fn table(rows: &[RoadRow]) -> Table {
    let digits = Format::Significant(3);
    let meaning = "|u - u_h| in the H1 seminorm, against the known solution";
    let columns = vec![
        Column::new("n", "n", digits, ""),
        Column::new("road", "road", digits, ""),
        Column::new("error", "error", Format::Scientific(3), meaning),
        Column::new("seconds", "seconds", Format::Scientific(1), "mesh, assembly, solution and judgement"),
        Column::new("iterations", "steps", digits, ""),
        Column::new("kkt", "KKT", Format::Scientific(1), "worst scaled KKT figure"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| -> [Cell; 6] {
        let RoadRow { n, road, error, seconds, steps, kkt } = *row;
        [n.into(), road.to_string().into(), error.into(), seconds.into(), steps.into(), kkt.into()]
    }))
}

fn draw(rows: &[RoadRow]) -> Chart {
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

fn main() -> ExitCode {
    example_frame::main(run)
}
