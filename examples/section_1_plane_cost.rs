//! Section 1, the plane: seconds against true error for norms of given functions, and what large meshes take.
//!
//! `cargo run --release --example section_1_plane_cost -- --squares 1000 --triangles 10000`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, timed};
use fractional_sobolev::{
    Estimate, Function, Gram, Order, PlanePosition, Tolerance, Triangles, closed_forms,
};
use signorini::rates::order_between;
use std::process::ExitCode;

example_frame::options! {
    /// Seconds, errors and memory of the norms in the plane
    pub struct Options {
        /// Squares in a row of the uniform grid
        #[arg(long, default_value_t = 200, value_parser = clap::value_parser!(u32).range(4..=1000))]
        pub squares: u32,
        /// Triangles of the bent grid, about
        #[arg(long, default_value_t = 1000, value_parser = clap::value_parser!(u32).range(2..=100_000))]
        pub triangles: u32,
        /// Order s in (0, 1)
        #[arg(long, default_value = "0.75")]
        pub s: Order,
    }
}

/// One road at one step: the tolerance asked, or the triangles of an interpolant; seconds, error at most.
pub struct Row(pub &'static str, f64, f64, pub f64);

/// Roads; by what a form on the uniform grid is off, seconds for a product, bytes for a node; seconds of the
/// bent grid, by what it is off and its estimate; a + 1 − s.
pub struct Computed(pub Vec<Row>, pub [f64; 3], pub [f64; 3], pub f64);

/// Roads in the order of the figure.
const ROADS: [&str; 4] = ["x, faces", "x, closure", "corner, closure", "corner, interpolants"];
/// Tolerances asked of the first three (of a corner to 1e-8), cells in a row of the meshes of the last.
const ASKED: [f64; 5] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10];
const CELLS: [usize; 4] = [2, 4, 8, 16];
/// Exponent of the corner singularity, tolerance of products and of large sums.
const POWER: f64 = 2.0 / 3.0;
const LARGE: f64 = 1e-8;

/// Every road to the norms of x₁ and of r^{2/3} cos(2φ/3) on the unit square.
fn roads(s: Order) -> Result<Vec<Row>> {
    let (exact, square) =
        (closed_forms::coordinate_on_square_seminorm_squared(s)?.sqrt()?, Triangles::grid([1, 1], 1.0)?);
    let power = |at: &PlanePosition<'_>| at.radius(0).powf(POWER) * (POWER * at.angle(0)).cos();
    let cut = Function::from_plane_positions(&square.cut_at(0, 0.45)?, &[(0, POWER)], power)?;
    let reference = cut.seminorm(s, Tolerance::new(0.1 * LARGE)?)?;
    let by_faces = Function::on_triangles(&square, 1, &[0.0, 1.0, 0.0, 1.0])?;
    let by_points = Function::from_plane_positions(&square, &[], |at| at.x()[0])?;
    let singular = Function::from_plane_positions(&square, &[(0, POWER)], power)?;
    let mut rows = Vec::new();
    let mut push = |road: usize, step, (seconds, found): (f64, Estimate), exact: Estimate| {
        let off = (found.value / exact.value - 1.0).abs() + exact.relative_error();
        rows.push(Row(ROADS[road], step, seconds, off));
    };
    for asked in ASKED {
        let tolerance = Tolerance::new(asked)?;
        push(0, asked, timed(|| by_faces.seminorm(s, tolerance))?, exact);
        push(1, asked, timed(|| by_points.seminorm(s, tolerance))?, exact);
        if asked >= LARGE {
            push(2, asked, timed(|| singular.seminorm(s, tolerance))?, reference);
        }
    }
    for cells in CELLS {
        let mesh = Triangles::grid([cells; 2], 1.0 / cells as f64)?;
        let value = |p: &[f64; 2]| p[0].hypot(p[1]).powf(POWER) * (POWER * p[1].atan2(p[0])).cos();
        let values: Vec<f64> = mesh.nodes().iter().map(value).collect();
        let w = Function::on_triangles(&mesh, 1, &values)?;
        let found = timed(|| w.seminorm(s, Tolerance::balanced()))?;
        push(3, 2.0 * (cells * cells) as f64, found, reference);
    }
    rows.sort_by_key(|row| ROADS.iter().position(|road| *road == row.0));
    Ok(rows)
}

/// The roads, a product on a uniform grid and a sum over a bent one.
pub fn compute(options: &Options) -> Result<Computed> {
    let (exact, n) =
        (closed_forms::coordinate_on_square_seminorm_squared(options.s)?.value, options.squares as usize);
    let large = Tolerance::new(LARGE)?;
    let operator = Gram::on_grid([n; 2], 1.0 / n as f64, options.s, large)?;
    let x: Vec<f64> = (0..operator.len()).map(|k| (k % (n + 1)) as f64 / n as f64).collect();
    let (product, image) = timed(|| operator.apply(&x))?;
    let form: f64 = x.iter().zip(&image).map(|(x, image)| x * image).sum();
    let grid = [(form / exact - 1.0).abs(), product, operator.bytes()? as f64 / x.len() as f64];
    let n = (0.5 * f64::from(options.triangles)).sqrt().ceil();
    let bent = |[x, y]: [f64; 2]| [x + x * (1.0 - x) * (y - 0.4), y - y * (1.0 - y) * (x - 0.3)];
    let mesh = Triangles::grid([n as usize; 2], 1.0 / n)?.mapped(bent)?;
    let values: Vec<f64> = mesh.nodes().iter().map(|p| p[0]).collect();
    let w = Function::on_triangles(&mesh, 1, &values)?;
    let (seconds, found) = timed(|| w.seminorm(options.s, large))?;
    let bent = [seconds, (found.value / exact.sqrt() - 1.0).abs(), found.relative_error()];
    Ok(Computed(roads(options.s)?, grid, bent, POWER + 1.0 - options.s.value()))
}

/// What decides: errors against tolerances and estimates, an order; seconds and bytes are remarks.
pub fn findings(Computed(rows, grid, bent, order): &Computed) -> Vec<Finding> {
    let ([form, product, bytes], [seconds, off, estimate]) = (grid, bent);
    let (meshes, asked): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.1 > 1.0);
    let share = asked.iter().map(|row| row.3 / row.1).fold(0.0, f64::max);
    let orders = [1, 2].map(|k| order_between((1.0, meshes[k].3), (0.5, meshes[k + 1].3)));
    let closure = asked.iter().filter(|row| row.0 == ROADS[2]).map(|row| row.3).fold(0.0, f64::max);
    let (least, change) = (meshes[CELLS.len() - 1].3, (orders[1] - orders[0]).abs());
    let claim = |key, words: &str, value: f64, error: f64| Finding::claim(key, words).number(value, error);
    let remark = |key, words: &str, value: f64| Finding::remark(key, words).number(value, 0.0);
    vec![
        claim("met", "every tolerance is met, a true error is {percent} % of it at most", share, 0.0)
            .at_most(1.0, "the tolerance")
            .told(),
        claim("large", "the sum over many triangles is off by {value} of its estimate", off / estimate, 1e-4)
            .at_most(1.0, "the estimate"),
        claim("product", "the form of the uniform grid is off by {value}", *form, 1e-13)
            .at_most(10.0 * LARGE, "ten times the tolerance of its entries"),
        claim("rate", "interpolants near the seminorm with the order {value}", orders[1], change)
            .at_least(*order, "a + 1 - s, the order of their own distance"),
        remark("interpolants", "closures leave {value} of their least error", closure / least)
            .at_most(1e-2, "a hundredth"),
        remark("memory", "the product on the uniform grid holds {value} bytes for a node", *bytes)
            .at_most(1600.0, "200 numbers for a node"),
        remark("seconds.product", "a product on the uniform grid takes {value} s", *product)
            .at_most(1.0, "one second"),
        remark("seconds.sum", "the sum over many triangles takes {value} s", *seconds)
            .at_most(10.0, "ten seconds"),
    ]
}

/// Seconds, errors and bytes.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let columns = vec![
        Column::new("road", "road", Format::Plain, ""),
        Column::new("step", "step", Format::Scientific(1), "tolerance asked, or triangles of an interpolant"),
        Column::new("seconds", "seconds", Format::Scientific(1), ""),
        Column::new("error", "error at most", Format::Scientific(1), "relative, by another road"),
    ];
    let cells = |row: &Row| [Cell::from(row.0), row.1.into(), row.2.into(), row.3.into()];
    let table = Table::new(columns).with_rows(computed.0.iter().map(cells));
    let claim = "every tolerance is met, for piecewise linears and for closures";
    let mut headline = Headline::new("Section 1, cost", claim, table, findings(&computed));
    headline.draw(&options.output, "section_1_plane_seconds", || {
        let (x, y) = (Axis::logarithmic("seconds"), Axis::logarithmic("relative error at most"));
        Ok(ROADS.iter().fold(Chart::new("What digits of norms in the plane cost", x, y), |chart, road| {
            let points = computed.0.iter().filter(|row| row.0 == *road);
            let points = points.map(|row| (row.2, row.3.max(f64::EPSILON))).collect();
            chart.with(Series::line_and_points(*road, points))
        }))
    })?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
