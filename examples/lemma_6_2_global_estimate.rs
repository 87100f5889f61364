//! Lemma 6.2: ‖u − I^h u‖_{0,Γ} ≤ h^{1+ν} |u|_{1+ν,Γ} and ‖(u − I^h u)'‖_{0,Γ} ≤ h^ν |u|_{1+ν,Γ} on a mesh.
//!
//! Both ratios for one function on finer and finer meshes, beside the best constants on a mesh and on one element.

use clap::Parser;
use example_frame::{HasOutput, Output, progress};
use signorini::figures::{Axis, Chart, Series};
use signorini::interpolation::{
    ErrorNorm, InterpolationError, SampleSlope, element_constant, mesh_constant_on_cells,
};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::sobolev::{FractionalOrder, Partition};
use signorini::{Error, Result, Tolerance};
use std::process::ExitCode;

/// Cells per element and largest number of elements for the best constant on a mesh
const CELLS: usize = 8;
const LARGEST_MESH: usize = 32;

/// Global interpolation estimate: ratios of one function and the best constants on a mesh
#[derive(Debug, Clone, Parser)]
pub struct Options {
    /// Orders nu in (0, 1), comma separated
    #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
    pub nu: Vec<FractionalOrder>,
    /// Slope u' on (0,1): power:A, step:S, cosine:K or constant
    #[arg(long, default_value = "power:0.3")]
    pub function: SampleSlope,
    /// Numbers of elements, comma separated
    #[arg(long, value_delimiter = ',', default_values = ["1", "2", "4", "8", "16", "1024", "65536"])]
    pub elements: Vec<usize>,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self::parse_from(["lemma_6_2_global_estimate"])
    }
}

impl HasOutput for Options {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// Ratios and constants on every mesh.
pub fn run(options: &Options) -> Result<Headline> {
    let mut table = Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("elements", "elements", Format::Significant(7), ""),
        Column::new(
            "ratio_l2",
            "u, L2",
            Format::Scientific(3),
            "|u - Iu|_0 / (h^(1+nu) |u|_(1+nu)) of the given function",
        ),
        Column::new("mesh_l2", "mesh, L2", Format::Fixed(5), "largest possible on this mesh (from below)"),
        Column::new("element_l2", "element, L2", Format::Fixed(7), "largest possible on one element"),
        Column::new("ratio_h1", "u, H1", Format::Scientific(3), "|(u - Iu)'|_0 / (h^nu |u|_(1+nu))"),
        Column::new("mesh_h1", "mesh, H1", Format::Fixed(5), "largest possible on this mesh (from below)"),
        Column::new("element_h1", "element, H1", Format::Fixed(7), "largest possible on one element"),
    ]);
    let bar = progress((options.nu.len() * options.elements.len()) as u64);
    let (mut largest, mut exceeded, mut mesh_share) = (0.0f64, false, 1.0f64);
    for &order in &options.nu {
        let [l2, h1] = [ErrorNorm::L2, ErrorNorm::Derivative]
            .map(|norm| element_constant(norm, order, Tolerance::balanced()));
        let (l2, h1) = (l2?.value, h1?.value);
        for &elements in &options.elements {
            if elements == 0 {
                return Err(Error::CountOutOfRange { name: "elements", value: 0, range: ">= 1" });
            }
            let mesh = Partition::uniform(elements, 1.0)?;
            let error = InterpolationError::of_sample(options.function, &mesh, order)?;
            let (found_l2, found_h1) = (error.l2_ratio()?.value, error.derivative_ratio()?.value);
            let best = |norm| -> Result<Option<f64>> {
                let small = elements <= LARGEST_MESH;
                small
                    .then(|| mesh_constant_on_cells(norm, order, elements, CELLS).map(|c| c.value))
                    .transpose()
            };
            let (mesh_l2, mesh_h1) = (best(ErrorNorm::L2)?, best(ErrorNorm::Derivative)?);
            largest = largest.max(found_l2).max(found_h1);
            exceeded |= found_l2 > l2 || found_h1 > h1;
            if let Some(constant) = mesh_h1.filter(|_| elements > 1) {
                mesh_share = mesh_share.min(constant / h1);
            }
            table.push(vec![
                order.value().into(),
                elements.into(),
                found_l2.into(),
                mesh_l2.into(),
                l2.into(),
                found_h1.into(),
                mesh_h1.into(),
                h1.into(),
            ]);
            bar.inc(1);
        }
    }
    let measured = format!(
        "largest ratio of u' = {} is {largest:.4}; on a mesh the best constants fall to {mesh_share:.3} of those of one element",
        options.function
    );
    let verdict = if exceeded {
        Verdict::NotConfirmed("a ratio exceeds the best constant of one element".into())
    } else {
        Verdict::HoldsLoose(format!("a factor of at least {:.2} for this function", 1.0 / largest))
    };
    let claim = "|u - I^h u|_0 <= h^(1+nu) |u|_(1+nu), |u - I^h u|_1 <= h^nu |u|_(1+nu) on a mesh";
    let mut headline = Headline::new("Lemma 6.2", claim, table, measured, verdict);
    headline.quote("lemma_6_2.mesh_share", mesh_share);
    headline.quote("lemma_6_2.largest_ratio", largest);
    if let Some(directory) = options.output.directory()? {
        let column = |key: &str| -> Vec<(f64, f64)> {
            let row =
                |k: usize| Some((headline.table.number(k, "elements")?, headline.table.number(k, key)?));
            (0..options.elements.len()).filter_map(row).collect()
        };
        let title = format!("Lemma 6.2, nu = {}, u' = {}", options.nu[0], options.function);
        let chart = Chart::new(
            title,
            Axis::logarithmic("number of elements"),
            Axis::logarithmic("error over its bound with constant 1"),
        )
        .with(Series::dashed("one element, derivative", column("element_h1")))
        .with(Series::line_and_points("best on the mesh, derivative", column("mesh_h1")))
        .with(Series::line_and_points("u, derivative", column("ratio_h1")))
        .with(Series::dashed("one element, L2", column("element_l2")))
        .with(Series::line_and_points("best on the mesh, L2", column("mesh_l2")))
        .with(Series::line_and_points("u, L2", column("ratio_l2")));
        headline.figures.push(chart.save(directory, "lemma_6_2_global_estimate")?);
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
