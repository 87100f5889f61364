//! Lemma 6.2: ‖u − I^h u‖_{0,Γ} ≤ h^{1+ν} |u|_{1+ν,Γ} and ‖u − I^h u‖_{1,Γ} ≤ h^ν |u|_{1+ν,Γ} on a mesh.
//!
//! Ratios of one function on finer and finer meshes, beside the best constants on a mesh and on one element.
//! With the full H¹ norm the second line needs h ≤ h*(ν); it is tried for h = 2 h* too.

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress, within};
use experiments::EstimateExt;
use experiments::interpolation::{InterpolationError, LocalConstants, MeshRatios, SampleSlope};
use fractional_sobolev::{Estimate, Mesh, Order, Tolerance};
use std::process::ExitCode;

/// Largest number of elements for the best constant on a mesh.
const LARGEST_MESH: usize = 32;

example_frame::options! {
    /// Global interpolation estimate: ratios of one function and the best constants on a mesh
    pub struct Options: Quick {
        /// Orders nu in (0, 1), comma separated
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
        pub nu: Vec<Order>,
        /// Slope u' on (0,1): power:A, step:S, cosine:K or constant
        #[arg(long, default_value = "power:0.3")]
        pub function: SampleSlope,
        /// Numbers of elements, comma separated
        #[arg(long, value_delimiter = ',', default_values = ["1", "2", "4", "8", "16", "1024", "65536"], value_parser = within::<usize>("[1, 1e15]"))]
        pub elements: Vec<usize>,
    }
    check(options) {
        let element = Mesh::uniform(1, 1.0)?;
        for &order in &options.nu {
            InterpolationError::of_sample(options.function, &element, order)?;
        }
        Ok(())
    }
    memory(options) {
        28.0 * options.elements.iter().copied().max().unwrap_or(0) as f64
    }
}

/// One order on one mesh: ratios and constants for the function, its derivative, and the full norm.
pub type Row = MeshRatios;

/// Ratios and constants on every mesh.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let bar = progress((options.nu.len() * options.elements.len()) as u64);
    let mut rows = Vec::new();
    for &order in &options.nu {
        let best = LocalConstants::new(order, Tolerance::balanced())?;
        for &elements in &options.elements {
            rows.push(Row::of_sample(options.function, order, &best, elements, elements <= LARGEST_MESH)?);
            bar.inc(1);
        }
    }
    Ok(rows)
}

/// What decides: constants of one element against the printed 1, ratios against them, long elements.
pub fn findings(options: &Options, rows: &[Row]) -> Vec<Finding> {
    let best = |k: usize| rows.iter().map(move |row| row.element[k]);
    let share = |k: usize| rows.iter().filter_map(move |row| row.function[k].over(row.element[k]).ok());
    let on_mesh = rows.iter().filter_map(|row| row.mesh?[1].over(row.element[1]).ok());
    let factor = |k: usize| best(k).filter_map(|constant| constant.recip().ok());
    let (printed, element) = ("printed constant", "constant of one element");
    let ratio = format!("largest ratio of u' = {} is {{value}}", options.function);
    let long = "second line, full H1 norm, on elements of length 2 h*(nu), there the constant is {value}";
    let falls = "on a mesh the best constant of the derivative falls to {percent} % of that of one element";
    let claim = |key: &str, words: &str, k| Finding::claim(key, words).largest(best(k)).at_most(1.0, printed);
    let loose = |key: &str, words: &str, k| Finding::sharpness(key, words).smallest(factor(k));
    vec![
        claim("l2", "the first line holds, constant at most {value}", 0),
        claim("derivative", "for the derivative the second line holds, constant at most {value}", 1),
        claim("full.short", "with the full H1 norm it holds for h <= 1, constant at most {value}", 2),
        Finding::printed("full", "with the full H1 norm it holds for every h")
            .largest(rows.iter().filter_map(|row| Some(row.mesh?[2])))
            .at_most(1.0, printed)
            .otherwise(long),
        Finding::claim("function", "u takes at most {percent} % of the constant of one element")
            .largest((0..3).flat_map(share))
            .at_most(1.0, element),
        Finding::remark("function.ratio", ratio)
            .largest(rows.iter().flat_map(|row| [row.function[0], row.function[1]]))
            .at_most(1.0, printed)
            .told(),
        Finding::remark("mesh.share", falls).smallest(on_mesh).at_most(1.0, element).told(),
        loose("loose.l2", "by {value} or more in L2", 0).at_least(1.0, printed),
        loose("loose.derivative", "by {value} or more in the derivative", 1).at_least(1.0, printed),
    ]
}

/// Ratios and constants set beside the printed 1.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "|u - I^h u|_0 <= h^(1+nu) |u|_(1+nu), |u - I^h u|_1 <= h^nu |u|_(1+nu) on a mesh";
    let mut headline = Headline::new("Lemma 6.2", claim, table(&rows), findings(options, &rows));
    for (key, name) in [("mesh.share", "mesh_share"), ("function.ratio", "largest_ratio")] {
        headline.quote_found(key, format!("lemma_6_2.{name}"));
    }
    headline.draw(&options.output, "lemma_6_2_global_estimate", || Ok(draw(options, &rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let (ratio, mesh, element) = (Format::Scientific(3), Format::Fixed(5), Format::Fixed(7));
    let (on_mesh, of_one) = ("largest possible on this mesh (from below)", "largest possible on one element");
    Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("elements", "elements", Format::Plain, ""),
        Column::new("ratio_l2", "u, L2", ratio, "|u - Iu|_0 / (h^(1+nu) |u|_(1+nu)) of the given function"),
        Column::new("mesh_l2", "mesh, L2", mesh, on_mesh),
        Column::new("element_l2", "element, L2", element, of_one),
        Column::new("ratio_derivative", "u, deriv.", ratio, "|(u - Iu)'|_0 / (h^nu |u|_(1+nu))"),
        Column::new("mesh_derivative", "mesh, deriv.", mesh, on_mesh),
        Column::new("element_derivative", "element, deriv.", element, of_one),
        Column::new("ratio_full", "u, H1", ratio, "with the full norm of u - Iu, h = 1/elements"),
        Column::new("mesh_long", "mesh, H1", mesh, "the same, largest on elements of length 2 h*(nu)"),
        Column::new("element_full", "element, H1", element, "largest on one element of length 1"),
    ])
    .with_rows(rows.iter().map(|row| {
        let mesh = |k: usize| row.mesh.map(|mesh| mesh[k].value);
        let of = |k: usize| [Some(row.function[k].value), mesh(k), Some(row.element[k].value)];
        [Some(row.nu), Some(row.elements as f64)].into_iter().chain((0..3).flat_map(of).collect::<Vec<_>>())
    }))
}

fn draw(options: &Options, rows: &[Row]) -> Chart {
    let points = |of: &dyn Fn(&Row) -> Option<Estimate>| -> Vec<(f64, f64)> {
        let first = rows.iter().filter(|row| row.nu == rows[0].nu);
        first.filter_map(|row| Some((row.elements as f64, of(row)?.value))).collect()
    };
    let title = format!("Lemma 6.2, nu = {}, u' = {}", options.nu[0], options.function);
    let y = Axis::logarithmic("error over its bound with constant 1");
    let chart = Chart::new(title, Axis::logarithmic("number of elements"), y);
    [(1, "derivative"), (0, "L2")].iter().fold(chart, |chart, &(k, norm)| {
        chart
            .with(Series::dashed(format!("one element, {norm}"), points(&|row| Some(row.element[k]))))
            .with(Series::line_and_points(
                format!("best on the mesh, {norm}"),
                points(&|row| Some(row.mesh?[k])),
            ))
            .with(Series::line_and_points(format!("u, {norm}"), points(&|row| Some(row.function[k]))))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
