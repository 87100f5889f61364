//! Section 1, boundaries: norms of order nu and -nu on the boundary of a polygon.
//!
//! `cargo run --release --example section_1_polygon_norms -- --polygon l-shape --n 4,8,16,32`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, within};
use experiments::EstimateExt;
use fractional_sobolev::{Curve, Estimate, Function, Mesh, Order, closed_forms};
use std::f64::consts::{LN_2, PI, TAU};
use std::process::ExitCode;

example_frame::options! {
    /// Norms on the boundaries of polygons, and the circle as their limit
    pub struct Options {
        /// Polygons: square, l-shape
        #[arg(long, value_delimiter = ',', default_values = ["square", "l-shape"], value_parser = ["square", "l-shape"])]
        pub polygon: Vec<String>,
        /// Elements on the length 1, even and increasing
        #[arg(long, value_delimiter = ',', default_values = ["4", "8", "16"], value_parser = within::<usize>("[2, 200]"))]
        pub n: Vec<usize>,
        /// Order nu in (0, 1)
        #[arg(long, default_value = "0.5")]
        pub nu: Order,
    }
}

/// A polygon with elements of length 1/n: 2|x|² over the square of the length of the boundary; |φ|² for
/// the basis function of vertex 0; ||n₁|| in the dual space of H^nu; area over ||n₁|| ||x||.
#[derive(Clone)]
pub struct Row(pub String, pub usize, pub [Estimate; 4]);

/// Sides, |cos kφ|² on the regular polygon over that on the circle.
pub type Wave = Vec<(usize, Estimate)>;

/// Frequencies on the circle, sides of the regular polygons in it.
const WAVES: [u32; 3] = [1, 2, 4];
const SIDES: [usize; 4] = [50, 100, 200, 400];
/// Asked of seminorms, and of dual norms; exponent towards corners for these, as n_1 jumps there.
const ASKED: [f64; 2] = [1e-6, 1e-3];
const GRADED: f64 = 3.0;
/// |φ|² for a right angle with endless sides, Catalan's constant in it; accuracy of limits.
const CORNER: f64 = 4.0 + 2.0 * LN_2 + 4.0 * 0.915_965_594_177_219 - PI;
const LIMIT: f64 = 2e-3;

/// Vertices, a right angle at the first, and area.
fn shape(polygon: &str) -> (Vec<[f64; 2]>, f64) {
    match polygon {
        "square" => (vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 1.0),
        _ => (vec![[0.0, 0.0], [0.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]], 3.0),
    }
}

fn square(u: &Function<'_>, options: &Options) -> Result<Estimate> {
    let found = u.seminorm(options.nu, ASKED[0])?;
    Ok(Estimate::new(found.value.powi(2), 2.0 * found.value * found.error, found.work)?)
}

fn row(options: &Options, polygon: &str, n: usize) -> Result<Row> {
    let (points, area) = shape(polygon);
    let side = |k: usize| {
        let ([a, b], [c, d]) = (points[k], points[(k + 1) % points.len()]);
        ((c - a).hypot(d - b), d - b)
    };
    let elements = |k: usize| Mesh::uniform(n * side(k).0.round() as usize, 1.0);
    let meshes: Vec<Mesh> = (0..points.len()).map(elements).collect::<fractional_sobolev::Result<_>>()?;
    let curve = Curve::closed(&points, &meshes)?;
    let x = {
        let values: Vec<f64> = curve.nodes().iter().map(|x| x[0]).collect();
        Function::on_curve(&curve, 1, &values)?
    };
    let coordinate = square(&x, options)?.times(2.0 * curve.length().powi(-2))?;
    let hat: Vec<f64> = (0..curve.len()).map(|k| f64::from(k == 0)).collect();
    let corner = square(&Function::on_curve(&curve, 1, &hat)?, options)?;
    let graded = Curve::algebraic(&points, n, GRADED)?;
    let normal: Vec<f64> =
        (0..graded.len()).map(|e| side(e / n)).map(|(length, rise)| rise / length).collect();
    let dual = Estimate::or_best(Function::on_curve(&graded, 0, &normal)?.norm(-options.nu, ASKED[1]))?;
    let share = dual.recip()?.over(x.norm(options.nu, ASKED[0])?)?.times(area)?;
    Ok(Row(polygon.to_owned(), n, [coordinate, corner, dual, share]))
}

fn circle(options: &Options, k: u32) -> Result<Wave> {
    let one = |&count: &usize| {
        let angles = (0..count).map(|j| TAU * j as f64 / count as f64);
        let points: Vec<[f64; 2]> = angles.clone().map(|t| [t.cos(), t.sin()]).collect();
        let curve = Curve::closed(&points, &vec![Mesh::uniform(1, 1.0)?; count])?;
        let values: Vec<f64> = angles.map(|t| (f64::from(k) * t).cos()).collect();
        let found = square(&Function::on_curve(&curve, 1, &values)?, options)?;
        Ok((count, found.over(closed_forms::cosine_on_circle_seminorm_squared(k, options.nu)?)?))
    };
    SIDES.iter().map(one).collect()
}

/// Polygons, and cosines on regular polygons.
pub fn compute(o: &Options) -> Result<(Vec<Row>, Vec<Wave>)> {
    let rows = o.polygon.iter().flat_map(|p| o.n.iter().map(move |&n| row(o, p, n)));
    Ok((rows.collect::<Result<_>>()?, WAVES.iter().map(|&k| circle(o, k)).collect::<Result<_>>()?))
}

/// By what the limit of v + c/n^order from the last two of a series is off, relative.
fn off(series: &[(usize, Estimate)], order: i32, exact: f64) -> Option<(f64, f64)> {
    let [.., (n, coarse), (m, fine)] = series else { return None };
    let ratio = (*m as f64 / *n as f64).powi(order);
    let limit = fine.value + (fine.value - coarse.value) / (ratio - 1.0);
    Some(((limit / exact - 1.0).abs(), (coarse.error + fine.error) / exact))
}

/// What decides: an identity, a limit at a corner, duality, and the circle.
pub fn findings(options: &Options, (rows, waves): &(Vec<Row>, Vec<Wave>)) -> Vec<Finding> {
    let half = || rows.iter().filter(|_| options.nu == Order::HALF);
    let sums = half().filter_map(|row| row.2[0].off(1.0).ok());
    let corners: Vec<_> = half().map(|row| (row.1, row.2[1])).collect();
    let corners = corners.chunks(options.n.len()).filter_map(|series| off(series, 1, CORNER));
    let why = "needs order 1/2 and two meshes";
    vec![
        Finding::claim("coordinate", "|x|^2 is half of the squared length of the boundary, up to {value}")
            .largest(sums)
            .at_most(ASKED[0], "|x|^2 + |y|^2 = L^2, x and y alike"),
        Finding::claim("corner", "basis functions of right angles tend to one norm, up to {value}")
            .largest_of(corners, why)
            .at_most(LIMIT, "4 + 2 ln 2 + 4 G - pi, by integration"),
        Finding::claim("duality", "area over the norms of n_1 and x is {value} at most")
            .largest(rows.iter().map(|row| row.2[3]))
            .at_most(1.0, "the integral of n_1 x is the area"),
        Finding::claim("circle", "regular polygons tend to the circle, up to {value}")
            .largest_of(waves.iter().filter_map(|wave| off(wave, 2, 1.0)), why)
            .at_most(LIMIT, "closed form on the circle"),
    ]
}

/// Norms on polygons.
pub fn run(options: &Options) -> Result<Headline> {
    let found = compute(options)?;
    let claim = "norms of order nu and -nu on boundaries of polygons agree with closed forms";
    let value = |key, title, what| Column::new(key, title, Format::Significant(7), what);
    let columns = vec![
        Column::words("polygon", "polygon", 8),
        Column::new("n", "n", Format::Plain, "elements on the length 1"),
        value("coordinate", "2|x|^2/L^2", "L the length; 1 at order 1/2"),
        value("corner", "|phi|^2", "basis function of the right angle at vertex 0"),
        value("dual", "||n_1||", "in the dual space, n_1 the normal's first component"),
        value("duality", "duality", "area over ||n_1|| ||x||"),
    ];
    let table = Table::new(columns).with_rows(found.0.iter().map(|Row(polygon, n, v)| {
        let [a, b, c, d] = v.map(|e| Cell::Number(e.value));
        [polygon.clone().into(), Cell::Integer(*n as i64), a, b, c, d]
    }));
    let (x, y) = (Axis::logarithmic("sides"), Axis::logarithmic("relative distance"));
    let chart = Chart::new("Regular polygons", x, y);
    let chart = found.1.iter().zip(WAVES).fold(chart, |chart, (wave, k)| {
        let points = wave.iter().map(|(sides, v)| (*sides as f64, (v.value - 1.0).abs())).collect();
        chart.with(Series::line_and_points(format!("cos {k} phi"), points))
    });
    let findings = findings(options, &found);
    let mut headline = Headline::new("Section 1, boundaries", claim, table, findings);
    headline.draw(&options.output, "section_1_polygon_norms", || Ok(chart))?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
