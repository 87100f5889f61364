//! Remark 3: on a face in three dimensions the nodal consistency term is not bounded by both seminorms.
//!
//! `cargo run --release --example remark_3_face -- --nu 0.1,0.3 --halvings 16`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, within};
use experiments::EstimateExt;
use experiments::proof::FaceGaps;
use fractional_sobolev::{Estimate, Order, Tolerance};
use signorini::rates::order_between;
use std::process::ExitCode;

example_frame::options! {
    /// The consistency term of both cones on one face with small gaps about its corners
    pub struct Options {
        /// Orders nu = tau - 3/2 in (0, 1/2)
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.4"], value_parser = within::<Order>("(0, 0.5)"))]
        pub nu: Vec<Order>,
        /// The gaps have legs from 1/4 down to 2 to the power of minus this minus one
        #[arg(long, default_value_t = 14, value_parser = clap::value_parser!(u32).range(4..=40))]
        pub halvings: u32,
        /// Relative accuracy of the seminorms
        #[arg(long, default_value = "1e-7")]
        pub tolerance: Tolerance,
    }
}

/// One order with its gaps, from the largest to the smallest.
pub struct Rows(pub Order, pub Vec<FaceGaps>);

impl Rows {
    /// Exponents of the nodal quotient over the last halving, and over the one before.
    fn exponents(&self) -> Option<[f64; 2]> {
        let [.., a, b, c] = self.1.as_slice() else { return None };
        let exponent =
            |large: Estimate, small: Estimate| order_between((1.0, large.value), (0.5, small.value));
        Some([exponent(b.nodal, c.nodal), exponent(a.nodal, b.nodal)])
    }
}

/// How far the last exponent may be from its limit.
const LIMIT: f64 = 0.01;

/// Both quotients for every order and every size of the gaps.
pub fn compute(options: &Options) -> Result<Vec<Rows>> {
    let rows = |&order: &Order| -> Result<Rows> {
        let gaps = (1..=options.halvings).map(|k| FaceGaps::new(k, order, options.tolerance));
        Ok(Rows(order, gaps.collect::<signorini::Result<_>>()?))
    };
    options.nu.iter().map(rows).collect()
}

/// What decides: the exponent of the nodal quotient, its growth, and the fall of the quotient of means.
pub fn findings(rows: &[Rows]) -> Vec<Finding> {
    let off = |rows: &Rows| {
        let [last, before] = rows.exponents()?;
        Some(((last - (2.0 * rows.0.value() - 1.0)).abs(), (last - before).abs()))
    };
    let worst = rows.iter().map(off).collect::<Option<Vec<_>>>();
    let worst = worst.and_then(|all| all.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)));
    let quotients = |pick: fn(&FaceGaps) -> Estimate, from_first: bool| {
        let pairs = rows.iter().flat_map(move |rows| {
            rows.1.windows(2).map(move |w| if from_first { (w[1], rows.1[0]) } else { (w[1], w[0]) })
        });
        pairs.filter_map(move |(small, large)| pick(&small).over(pick(&large)).ok()).collect::<Vec<_>>()
    };
    vec![
        Finding::claim("exponent", "the nodal quotient grows like r^(2 nu - 1), to {value} in the exponent")
            .number_or(worst, "too few gaps")
            .at_most(LIMIT, "scaling")
            .told(),
        Finding::claim("nodal", "with every halving of the gaps it grows, by a factor {value} at least")
            .smallest(quotients(|gaps| gaps.nodal, false))
            .at_least(1.0, "no bound by both seminorms"),
        Finding::claim("mean", "the quotient of the cone of means never passes that of the largest gaps")
            .largest(quotients(|gaps| gaps.mean, true))
            .at_most(1.0, "bounded on this family")
            .told(),
    ]
}

/// Both quotients over the size of the gaps.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "on a face, gaps about the corners make the nodal term as large as one likes";
    let mut headline = Headline::new("Remark 3, a face", claim, table(&rows), findings(&rows));
    headline.draw(&options.output, "remark_3_face", || Ok(draw(&rows)))?;
    Ok(headline)
}

fn table(rows: &[Rows]) -> Table {
    let digits = Format::Significant(7);
    let columns = vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("radius", "r", Format::Scientific(2), "legs of the gaps; the face has legs 1"),
        Column::new("nodal", "nodal", digits, "integral of sigma Iu over both seminorms"),
        Column::new("mean", "means", Format::Scientific(3), "integral of sigma times mean of u, over both"),
    ];
    Table::new(columns).with_rows(rows.iter().flat_map(|Rows(order, gaps)| {
        let row = |gaps: &FaceGaps| {
            let FaceGaps { radius, nodal, mean } = *gaps;
            [order.value(), radius, nodal.value, mean.value]
        };
        gaps.iter().map(row).collect::<Vec<_>>()
    }))
}

fn draw(rows: &[Rows]) -> Chart {
    let (x, y) = (Axis::logarithmic("r, legs of the gaps"), Axis::logarithmic("term over both seminorms"));
    rows.iter().fold(Chart::new("One face with gaps about its corners", x, y), |chart, Rows(order, gaps)| {
        let points = |pick: fn(&FaceGaps) -> Estimate| {
            gaps.iter().map(|gaps| (gaps.radius, pick(gaps).value)).collect::<Vec<_>>()
        };
        chart
            .with(Series::line_and_points(format!("nodal, nu = {order}"), points(|gaps| gaps.nodal)))
            .with(Series::dashed(format!("means, nu = {order}"), points(|gaps| gaps.mean)))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
