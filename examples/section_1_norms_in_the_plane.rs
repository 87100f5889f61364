//! Section 1: norms of fractional order on triangulations, and their limits at one half and at one.
//!
//! `cargo run --release --example section_1_norms_in_the_plane -- --squares 9 --s 0.1,0.3,0.6,0.9`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table};
use experiments::EstimateExt;
use experiments::SplitMix;
use fractional_sobolev::{Error, Estimate, Function, Order, Tolerance, Triangles, closed_forms};
use std::process::ExitCode;

example_frame::options! {
    /// Norms of fractional order of functions of two variables
    pub struct Options {
        /// Squares in a row of the grid that is jittered and cut into triangles
        #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..=40))]
        pub squares: u32,
        /// Orders s in (0, 1)
        #[arg(long, value_delimiter = ',', default_values = ["0.05", "0.25", "0.45", "1/2-1e-8", "0.5", "0.75", "0.95", "0.99999999"])]
        pub s: Vec<Order>,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-10")]
        pub tolerance: Tolerance,
    }
}

/// The norms of one order.
pub struct Row {
    /// s.
    pub order: Order,
    /// |x₁|_s on the unit square, from the triangles.
    pub coordinate: Estimate,
    /// The same in closed form.
    pub exact: Estimate,
    /// |w|_s for w = 1 below the diagonal and 0 above, where it is finite.
    pub step: Option<Estimate>,
}

/// lim (1−2s) |1_A|²_s as s → 1/2: 4 times the length of the boundary of A inside the domain.
///
/// Across a straight edge the kernel integrates to ∫ (t²+z²)^{-3/2} dz = 2/t² at distance t from side to
/// side, and 2 ∫∫ 2 (a+b)^{-1-2s} da db over a, b > 0 near 0 is 4/(1−2s) to leading order.
fn perimeter_limit(length: f64) -> f64 {
    4.0 * length
}

/// lim (1−s) |w|²_s as s → 1: (π/2) ∫ |∇w|² (Bourgain, Brezis & Mironescu 2001; here the mean of cos² over a
/// circle is 1/2, and ∫₀ r^{1−2s} dr = 1/(2−2s) to leading order).
fn gradient_limit(gradient_squared: f64) -> f64 {
    std::f64::consts::FRAC_PI_2 * gradient_squared
}

impl Row {
    /// (1 − s)|x₁|² over its limit at one, with its error.
    fn to_one(&self) -> (f64, f64) {
        let scale = (1.0 - self.order.value()) / gradient_limit(1.0);
        let Estimate { value, error, .. } = self.coordinate;
        (scale * value * value, 2.0 * scale * value * error)
    }

    /// (1 − 2s)|w|² over its limit at one half, with its error.
    fn to_half(&self) -> Option<(f64, f64)> {
        let scale = (-2.0 * self.order.offset()) / perimeter_limit(2f64.sqrt());
        self.step.map(|Estimate { value, error, .. }| (scale * value * value, 2.0 * scale * value * error))
    }
}

/// The unit square cut into triangles whose inner nodes are moved at random.
fn jittered(squares: usize) -> Result<Triangles> {
    let h = 1.0 / squares as f64;
    let mut random = SplitMix::new(2012);
    let is_inner = |x: f64| x > 0.5 * h && x < 1.0 - 0.5 * h;
    let mut by = || random.between(-JITTER * h, JITTER * h);
    let moved = |[x, y]: [f64; 2]| if is_inner(x) && is_inner(y) { [x + by(), y + by()] } else { [x, y] };
    Ok(Triangles::grid([squares, squares], h)?.mapped(moved)?)
}

/// Part of a square by which a node is moved.
const JITTER: f64 = 0.2;
/// Nearer to a limit than this a quotient shows it, to the distance times a logarithm.
const NEAR: f64 = 1e-7;
const LIMIT: f64 = 1e-6;

/// Every norm of every order.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let mesh = jittered(options.squares as usize)?;
    let values: Vec<f64> = mesh.nodes().iter().map(|node| node[0]).collect();
    let coordinate = Function::on_triangles(&mesh, 1, &values)?;
    let step = Function::on_triangles(&Triangles::grid([1, 1], 1.0)?, 0, &[1.0, 0.0])?;
    let row = |&order: &Order| -> Result<Row> {
        let found = match step.seminorm(order, options.tolerance) {
            Err(Error::InfiniteNorm { .. }) => None,
            other => Some(other?),
        };
        let exact = closed_forms::coordinate_on_square_seminorm_squared(order)?.sqrt()?;
        Ok(Row { order, coordinate: coordinate.seminorm(order, options.tolerance)?, exact, step: found })
    };
    options.s.iter().map(row).collect()
}

/// What decides: the closed form, where the step is said to have no norm, and both limits.
pub fn findings(options: &Options, rows: &[Row]) -> Vec<Finding> {
    let largest = |numbers: Vec<(f64, f64)>| numbers.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let errors = rows.iter().map(|row| row.coordinate.relative_distance(&row.exact)).collect();
    let wrong = rows.iter().filter(|row| (row.order.offset() < 0.0) != row.step.is_some()).count();
    let off = |(value, error): (f64, f64)| ((value - 1.0).abs(), error);
    let at_one = rows.iter().filter(|row| (1.0 - row.order.value()) < NEAR).map(|row| off(row.to_one()));
    let is_near = |row: &&Row| (-2.0 * row.order.offset()) < NEAR;
    let at_half = rows.iter().filter(is_near).filter_map(|row| row.to_half().map(off)).collect();
    vec![
        Finding::claim("closed.form", "on every mesh |x| has the norm of its closed form, to {value}")
            .number_or(largest(errors), "no order")
            .at_most(options.tolerance.relative(), "the tolerance asked")
            .told(),
        Finding::claim("infinite", "a step has no norm from s = 1/2 on, and has one below")
            .number(wrong as f64, 0.0)
            .at_most(0.0, "an edge carries 4/(1-2s) times its length")
            .told(),
        Finding::claim("one", "beside s = 1 the norm is that of the gradient, to {value}")
            .number_or(largest(at_one.collect()), "no order beside 1")
            .at_most(LIMIT, "(1-s)|w|^2 -> (pi/2) |grad w|^2")
            .told(),
        Finding::claim("half", "beside s = 1/2 the norm of a step is the length of its edge, to {value}")
            .number_or(largest(at_half), "no order just below 1/2")
            .at_most(LIMIT, "(1-2s)|w|^2 -> 4 length"),
    ]
}

/// Norms beside closed form and limits.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "the norms of order s on triangles have their digits, up to both limits";
    let mut headline = Headline::new("Section 1, the plane", claim, table(&rows), findings(options, &rows));
    headline.draw(&options.output, "section_1_norms_in_the_plane", draw)?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let digits = Format::Significant(13);
    let columns = vec![
        Column::new("s", "s", Format::Significant(10), ""),
        Column::new("coordinate", "|x|_s", digits, "first coordinate on the unit square, jittered triangles"),
        Column::new("true_error", "true error", Format::Scientific(1), "relative, against the closed form"),
        Column::new("to_one", "to one", Format::Significant(8), "(1-s)|x|^2 over pi/2"),
        Column::new("step", "|step|_s", digits, "1 below the diagonal of the square, 0 above"),
        Column::new("to_half", "to half", Format::Significant(8), "(1-2s)|step|^2 over 4 times the length"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let step = row.step.map_or("infinite".into(), |step| Cell::from(step.value));
        let error = row.coordinate.relative_distance(&row.exact).0;
        let half = row.to_half().map(|half| half.0).into();
        let value = row.coordinate.value.into();
        [row.order.value().into(), value, error.into(), row.to_one().0.into(), step, half]
    }))
}

fn draw() -> Result<Chart> {
    let orders: Vec<String> = (1..50).map(|k| format!("{}", 0.02 * f64::from(k))).collect();
    let s = orders.iter().map(|s| s.parse()).collect::<std::result::Result<_, Error>>()?;
    let rows = compute(&Options { squares: 1, s, tolerance: Tolerance::fast(), ..Options::default() })?;
    let (x, y) = (Axis::linear("s, order"), Axis::linear("over its limit"));
    let one = rows.iter().map(|row| (row.order.value(), row.to_one().0)).collect();
    let half = rows.iter().filter_map(|row| Some((row.order.value(), row.to_half()?.0))).collect();
    Ok(Chart::new("Squared norms times what they lack to their limits", x, y)
        .with(Series::line("(1 - s) |x|^2 over pi/2", one))
        .with(Series::line("(1 - 2s) |step|^2 over 4 times the length", half))
        .with(Series::dashed("1", vec![(0.0, 1.0), (1.0, 1.0)])))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
