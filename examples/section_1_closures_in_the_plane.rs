//! Section 1: corner singularities given by closures, their norms up to the limit of finiteness.
//!
//! `cargo run --release --example section_1_closures_in_the_plane -- --gaps 0.3,1e-4 --s 0.8`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, within};
use experiments::EstimateExt;
use fractional_sobolev::{Error, Estimate, Function, Order, Tolerance, Triangles};
use std::f64::consts::{PI, SQRT_2};
use std::process::ExitCode;

example_frame::options! {
    /// Norms of fractional order of corner singularities given by closures
    pub struct Options {
        /// a + 1 - s, what the exponent of r^a is above the limit of finiteness
        #[arg(long, value_delimiter = ',', default_values = ["0.5", "1e-2", "1e-3", "1e-6"], value_parser = within::<f64>("(0, 20]"))]
        pub gaps: Vec<f64>,
        /// Order s in (0, 1)
        #[arg(long, default_value = "0.6")]
        pub s: Order,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-8")]
        pub tolerance: Tolerance,
    }
}

/// Name, corners P_1, ..., P_m of a polygon 0, P_1, ..., P_m, its angle at 0, and the radii of the largest
/// sector inside and of the smallest outside.
type Shape = (&'static str, Vec<[f64; 2]>, f64, [f64; 2]);

/// Shape, a + 1 − s, the norm from triangles at the corner and from cut ones, the norms on both sectors.
pub struct Row(&'static str, f64, pub [Estimate; 2], [Estimate; 2]);

/// a + 1 − s for which there is no norm.
const INFINITE: [f64; 3] = [0.0, -1e-9, -0.2];
/// Distances δ from the corner below which a function is changed; a + 1 − s and the tolerance for that.
const DELTAS: [f64; 3] = [1e-30, 1e-60, 1e-100];
const CHANGED: (f64, f64) = (0.01, 1e-5);

/// Three wedges and the L-shape.
fn shapes() -> [Shape; 4] {
    let wedge = |name, degrees: f64, parts: i32| -> Shape {
        let (angle, part) = (degrees.to_radians(), degrees.to_radians() / f64::from(parts));
        let at = |k: i32| [(part * f64::from(k)).cos(), (part * f64::from(k)).sin()];
        (name, (0..=parts).map(at).collect(), angle, [(0.5 * part).cos(), 1.0])
    };
    let l_shape = vec![[1.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [0.0, -1.0]];
    let l_shape = ("L-shape", l_shape, 1.5 * PI, [1.0, SQRT_2]);
    [wedge("60 degrees", 60.0, 1), wedge("90 degrees", 90.0, 1), wedge("150 degrees", 150.0, 2), l_shape]
}

/// |r^a sin(πφ/ω)|_s, times r²/(r² + δ²), on the polygon, its triangles cut or not.
fn norm(o: &Options, shape: &Shape, gap: f64, cut: bool, delta: f64) -> fractional_sobolev::Result<Estimate> {
    let (a, b, star) = (gap - (1.0 - o.s.value()), PI / shape.2, Triangles::star(&shape.1)?);
    let mesh = if cut { star.cut_at(0, 0.45)? } else { star };
    let w = Function::from_plane_positions(&mesh, &[(0, if delta > 0.0 { a + 2.0 } else { a })], |at| {
        let r = at.radius(0);
        r.powf(a) * (b * at.angle(0)).sin() / (1.0 + (delta / r).powi(2))
    })?;
    w.seminorm(o.s, o.tolerance)
}

/// All rows, how many infinite norms were not seen to be, and |w|² less its changed values.
pub fn compute(options: &Options) -> Result<(Vec<Row>, usize, Vec<Estimate>)> {
    let shapes = shapes();
    let row = |(shape, &gap): (&Shape, &f64)| -> Result<Row> {
        let w =
            |radius| Function::sector_power(gap - (1.0 - options.s.value()), PI / shape.2, shape.2, radius);
        let sector = |radius| w(radius)?.seminorm(options.s, options.tolerance);
        let roads = [norm(options, shape, gap, false, 0.0)?, norm(options, shape, gap, true, 0.0)?];
        Ok(Row(shape.0, gap, roads, [sector(shape.3[0])?, sector(shape.3[1])?]))
    };
    let pairs = shapes.iter().flat_map(|shape| options.gaps.iter().map(move |gap| (shape, gap)));
    let rows = pairs.map(row).collect::<Result<_>>()?;
    let of = |gap: f64| norm(options, &shapes[0], gap, false, 0.0);
    let wrong = INFINITE.iter().filter(|gap| !matches!(of(**gap), Err(Error::InfiniteNorm { .. }))).count();
    let coarse = Options { tolerance: Tolerance::new(CHANGED.1)?, ..options.clone() };
    let of = |delta: f64| norm(&coarse, &shapes[0], CHANGED.0, false, delta);
    let whole = of(0.0)?;
    let change = |&delta: &f64| -> Result<Estimate> {
        let part = of(delta)?;
        let error = 2.0 * (whole.value * whole.error + part.value * part.error);
        Ok(Estimate::new((whole.value - part.value) * (whole.value + part.value), error, part.work)?)
    };
    Ok((rows, wrong, DELTAS.iter().map(change).collect::<Result<_>>()?))
}

/// What decides: both roads, the sectors, where there is no norm, and what happens at 1e-100.
pub fn findings(o: &Options, (rows, wrong, changes): &(Vec<Row>, usize, Vec<Estimate>)) -> Vec<Finding> {
    let largest = |numbers: Vec<(f64, f64)>| numbers.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let roads = rows.iter().map(|row| row.2[0].relative_distance(&row.2[1])).collect();
    let quotient = |a: &Estimate, b: &Estimate| {
        let value = a.value / b.value;
        (value, value * (a.relative_error() + b.relative_error()))
    };
    let inside = |row: &Row| quotient(&row.3[0], &row.2[0]);
    let between = rows.iter().flat_map(|row| [inside(row), quotient(&row.2[0], &row.3[1])]).collect();
    let nearest = rows.iter().map(|row| row.1).fold(1.0, f64::min);
    let at_limit = rows.iter().filter(|row| row.1 == nearest).map(inside);
    let slope = |k: usize| {
        let (value, off) = quotient(&changes[k], &changes[k + 1]);
        let log = 2.0 * CHANGED.0 * (DELTAS[k] / DELTAS[k + 1]).ln();
        ((value.ln() / log - 1.0).abs(), off / value / log)
    };
    vec![
        Finding::claim("roads", "two triangulations of one polygon give one norm, to {value}")
            .number_or(largest(roads), "no row")
            .at_most(o.tolerance.relative(), "the tolerance asked")
            .told(),
        Finding::claim("sectors", "the norms lie between those of the sectors inside and outside")
            .number_or(largest(between), "no row")
            .at_most(1.0, "a part of the domain has a part of the integral"),
        Finding::claim("corner", "nearest to the limit, polygon and sector differ by {value} at most")
            .number_or(largest(at_limit.map(|(value, off)| (1.0 - value, off)).collect()), "no row")
            .at_most(nearest, "sectors scale like R^(a+1-s), and R < e r")
            .told(),
        Finding::claim("infinite", "there is no norm for a <= s - 1, and the error says so")
            .number(*wrong as f64, 0.0)
            .at_most(0.0, "the sums over rings do not decay"),
        Finding::claim("depth", "a change of w at distances down to 1e-100 has its share, to {value}")
            .number_or(largest((1..changes.len()).map(|k| slope(k - 1)).collect()), "no change")
            .at_most(1e-2, "what is changed below delta scales like delta^(2a+2-2s)")
            .told(),
    ]
}

/// Norms by both roads between those of sectors.
pub fn run(options: &Options) -> Result<Headline> {
    let (found, digits) = (compute(options)?, Format::Significant(11));
    let columns = vec![
        Column::new("shape", "polygon", Format::Plain, "angle at its corner"),
        Column::new("gap", "a+1-s", Format::Scientific(0), "what the exponent is above the limit"),
        Column::new("norm", "|w|_s", digits, "r^a sin(pi phi/angle)"),
        Column::new("off", "roads", Format::Scientific(1), "relative distance of both triangulations"),
        Column::new("inside", "inside", digits, "the norm on the largest sector in the polygon"),
    ];
    let table = Table::new(columns).with_rows(found.0.iter().map(|Row(shape, gap, roads, sectors)| {
        let off = roads[0].relative_distance(&roads[1]).0;
        [Cell::from(*shape), (*gap).into(), roads[0].value.into(), off.into(), sectors[0].value.into()]
    }));
    let claim = "closures have their norms up to the limit of finiteness at corners";
    let mut headline = Headline::new("Section 1, corners", claim, table, findings(options, &found));
    headline.draw(&options.output, "section_1_closures_in_the_plane", || draw(options))?;
    Ok(headline)
}

/// (a + 1 − s)|w|² against a + 1 − s.
fn draw(options: &Options) -> Result<Chart> {
    let (x, y) = (Axis::logarithmic("a + 1 - s"), Axis::linear("(a + 1 - s) |w|^2"));
    let fast = Options { tolerance: Tolerance::fast(), ..options.clone() };
    let chart = Chart::new("Squared norms of r^a sin(pi phi/angle) times a + 1 - s", x, y);
    shapes().iter().try_fold(chart, |chart, shape| {
        let gaps = (-16..=0).map(|k| 10f64.powf(0.25 * f64::from(k)));
        let point = |gap: f64| Ok((gap, gap * norm(&fast, shape, gap, false, 0.0)?.value.powi(2)));
        Ok(chart.with(Series::line(shape.0, gaps.map(point).collect::<Result<_>>()?)))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
