//! Section 1, errors: |x^alpha - I_h x^alpha| in H^nu on meshes (i/N)^beta, up to many elements.
//!
//! `cargo run --release --example section_1_field_errors -- --alpha 0.6 --nu 0.25 --grading 1,3`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, timed, within};
use experiments::ErrorExt;
use fractional_sobolev::{Error, Estimate, Function, Mesh, Order, Tolerance};
use signorini::rates::order_between;
use std::f64::consts::PI;
use std::process::ExitCode;

example_frame::options! {
    /// Rates of linear interpolation in a norm of fractional order, equal and graded elements
    pub struct Options {
        /// The function is x^alpha, alpha > nu - 1/2 and not 1
        #[arg(long, default_value_t = 0.75, value_parser = within::<f64>("(0, 10]"))]
        pub alpha: f64,
        /// Order nu in (0, 1)
        #[arg(long, default_value = "0.5")]
        pub nu: Order,
        /// Nodes (i/N)^beta: exponents beta
        #[arg(long, value_delimiter = ',', default_values = ["1", "1.5", "2", "2.67", "4"], value_parser = within::<f64>("[1, 20]"))]
        pub grading: Vec<f64>,
        /// Numbers of elements N, increasing; the last two give the order
        #[arg(long, value_delimiter = ',', default_values = ["100", "1000", "10000", "100000"], value_parser = within::<usize>("[1, 1e6]"))]
        pub elements: Vec<usize>,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-6")]
        pub tolerance: Tolerance,
    }
    check(options) {
        let (alpha, offset) = (options.alpha, options.nu.offset());
        Error::require("alpha", alpha, "above nu - 1/2, and not 1", alpha > offset && alpha != 1.0)?;
        Ok(())
    }
}

/// One mesh: beta, N, |u - I_h u|_nu, seconds.
#[derive(Clone)]
pub struct Row(pub f64, pub usize, pub Estimate, f64);

/// Gradings nearer to the limit beta (alpha - nu + 1/2) = 2 - nu than this share show a logarithm.
const NEAR: f64 = 0.2;
/// Accuracy of orders, and of constants against their limit for N to infinity.
const ORDER: f64 = 0.02;
const CONSTANT: f64 = 2e-3;

/// alpha - nu + 1/2, the order of the first element, and 2 - nu, that of smooth functions.
fn orders(options: &Options) -> [f64; 2] {
    [options.alpha - options.nu.offset(), 1.0 + (1.0 - options.nu.value())]
}

/// lim N^(2-nu) |u - I_h u|_nu for beta above the limit: a chain of parabolas of slowly varying length.
pub fn limit(options: &Options, beta: f64) -> Option<f64> {
    let ([first, smooth], nu, a) = (orders(options), options.nu.value(), options.alpha);
    let kernel = PI / (libm::tgamma(1.0 + 2.0 * nu) * (PI * nu).sin());
    let zeta: f64 = (1..100_000).rev().map(|k| f64::from(k).powf(-2.0 * smooth)).sum();
    let chain = kernel * (2.0 * PI).powf(2.0 * nu) * zeta / PI.powi(4);
    let weight = beta.powf(2.0 * smooth) / (2.0 * (first - smooth / beta));
    (beta * first > smooth * (1.0 + NEAR)).then(|| (chain * weight).sqrt() * (0.5 * a * (a - 1.0)).abs())
}

/// Every grading with every number of elements.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let alpha = options.alpha;
    let u = Function::from_positions(&[0.0, 1.0], |at| at.distance_to(0).powf(alpha))?;
    let meshes = options.grading.iter().flat_map(|&b| options.elements.iter().map(move |&n| (b, n)));
    let row = |(beta, n): (f64, usize)| {
        let mesh = Mesh::algebraic(n, beta, 1.0)?;
        let values: Vec<f64> = mesh.from_left().iter().map(|x| x.powf(alpha)).collect();
        let field = Function::linears(&mesh, &values)?;
        let best = || Estimate::or_best(u.minus(&field)?.seminorm(options.nu, options.tolerance));
        let (seconds, found) = timed(best)?;
        Ok(Row(beta, n, found, seconds))
    };
    meshes.map(row).collect()
}

/// The order between two meshes of one grading.
fn order(coarse: &Row, fine: &Row) -> f64 {
    order_between((1.0 / coarse.1 as f64, coarse.2.value), (1.0 / fine.1 as f64, fine.2.value))
}

/// N^(2-nu) |u - I_h u|_nu over its limit.
fn over_limit(options: &Options, row: &Row) -> Option<f64> {
    let scale = (row.1 as f64).powf(orders(options)[1]);
    Some(scale * row.2.value / limit(options, row.0)?)
}

/// What decides: orders against the prediction, constants against the limit, the best grading, estimates.
pub fn findings(options: &Options, rows: &[Row]) -> Vec<Finding> {
    let [first, smooth] = orders(options);
    let series = || rows.chunks(options.elements.len());
    let off = |s: &[Row]| {
        let [.., a, b, c] = s else { return None };
        let is_clear = (a.0 * first / smooth - 1.0).abs() > NEAR;
        let last = order(b, c);
        is_clear.then(|| ((last - smooth.min(a.0 * first)).abs(), (last - order(a, b)).abs()))
    };
    let constant = |s: &[Row]| {
        let [.., b, c] = s else { return None };
        let (before, last) = (over_limit(options, b)?, over_limit(options, c)?);
        Some(((last - 1.0).abs(), (last - before).abs()))
    };
    let finest = || series().filter_map(|s| s.last()).filter_map(|row| Some((row, limit(options, row.0)?)));
    let best = finest().min_by(|a, b| a.0.2.value.total_cmp(&b.0.2.value)).map(|(row, _)| (row.0, 0.0));
    let least = finest().min_by(|a, b| a.1.total_cmp(&b.1)).map_or(f64::NAN, |(row, _)| row.0);
    let why = "needs three numbers of elements, and gradings on the side in question";
    vec![
        Finding::claim("orders", "measured orders differ from the predicted ones by {value} at most")
            .largest_of(series().filter_map(off), why)
            .at_most(ORDER, "min(beta (alpha - nu + 1/2), 2 - nu)"),
        Finding::claim("constant", "N^(2-nu) times the error is its limit, up to {value}")
            .largest_of(series().filter_map(constant), why)
            .at_most(CONSTANT, "a chain of parabolas, by Fourier series"),
        Finding::claim("best", "of the gradings above the limit the best has beta = {value}")
            .number_or(best, "no grading above the limit")
            .within(0.0, least, "least of the limits"),
        Finding::claim("estimates", "every error is known to a relative {value}")
            .largest_of(rows.iter().map(|row| (row.2.relative_error(), 0.0)), why)
            .at_most(options.tolerance.relative(), "the tolerance asked"),
    ]
}

/// Errors of every grading.
pub fn run(options: &Options) -> Result<Headline> {
    let (rows, [first, smooth]) = (compute(options)?, orders(options));
    let claim = "|u - I_h u|_nu is of order min(beta (alpha - nu + 1/2), 2 - nu) on meshes (i/N)^beta";
    let columns = vec![
        Column::new("beta", "beta", Format::Plain, "nodes (i/N)^beta"),
        Column::new("elements", "N", Format::Plain, "number of elements"),
        Column::new("error", "|u-I_h u|", Format::Significant(7), "of order nu, u = x^alpha"),
        Column::new("order", "order", Format::Fixed(4), "from the row above"),
        Column::new("predicted", "predicted", Format::Fixed(4), "min(beta (alpha-nu+1/2), 2-nu)"),
        Column::new("ratio", "over limit", Format::Fixed(5), "N^(2-nu) |u-I_h u| over its limit"),
        Column::new("seconds", "s", Format::Significant(2), "seconds"),
    ];
    let table = Table::new(columns).with_rows(rows.iter().enumerate().map(|(k, row)| {
        let before = k.checked_sub(1).map(|k| &rows[k]).filter(|before| before.0 == row.0);
        let (beta, n, error) = (row.0.into(), Cell::Integer(row.1 as i64), row.2.value.into());
        let ratio = over_limit(options, row).map_or("none".into(), Cell::Number);
        let order = before.map(|before| order(before, row)).into();
        [beta, n, error, order, smooth.min(row.0 * first).into(), ratio, row.3.into()]
    }));
    let mut headline = Headline::new("Section 1, errors", claim, table, findings(options, &rows));
    headline.draw(&options.output, "section_1_field_errors", || Ok(draw(options, &rows)))?;
    Ok(headline)
}

fn draw(options: &Options, rows: &[Row]) -> Chart {
    let (x, y) = (Axis::logarithmic("elements N"), Axis::logarithmic("error in H^nu"));
    rows.chunks(options.elements.len()).fold(Chart::new("Interpolation of x^alpha", x, y), |chart, series| {
        let points = series.iter().map(|row| (row.1 as f64, row.2.value)).collect();
        chart.with(Series::line_and_points(format!("beta = {}", series[0].0), points))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
