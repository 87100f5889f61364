//! (3.6), (3.10), (4.12), (E3): the constants C(q) of H^ν(0,1) ⊂ L^q(0,1) and C(α) of H^{3/2}(0,1) ⊂ C^{0,α}.
//!
//! Lower bounds by functions found by an ascent, upper bounds by an inequality on the circle; growth like √q
//! and (1−α)^{-1/2}.

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress, within};
use experiments::EstimateExt;
use fractional_sobolev::{Estimate, Order, Target, Tolerance, embedding_constant};
use std::process::ExitCode;

/// C(q)/√q lies between these for q = 2 ... 200: below its limit 0.16719..., above 1/√2 at q = 2.
const GROWTH: [f64; 2] = [0.167, 0.708];
/// lim C(q)/√q for q → ∞ at ν = 1/2: (3/(4π²e))^{1/2}, from the logarithm cut off at ln(1/θ) = q/2.
const LIMIT: f64 = 0.167_198_939_329_408_5;
/// The quotient 1/√8 : 0.1672 of the limits of both bounds over √q, rounded up.
const GAP: f64 = 2.2;
/// To this the quotient of the constant function is known, where that function is the worst.
const ACCURACY: f64 = 1e-7;

example_frame::options! {
    /// Embedding constants: C(q) at nu = 1/2 and at critical exponents, C(alpha)
    pub struct Options {
        /// Exponents q for nu = 1/2, comma separated; alpha = 1 - 1/q beside them
        #[arg(long, value_delimiter = ',', default_values = ["2", "3", "4", "6", "8", "12", "16", "24", "36", "50", "75", "100", "150", "200"], value_parser = within::<f64>("[2, 1000]"))]
        pub q: Vec<f64>,
        /// Orders nu < 1/2, comma separated, taken at the critical exponent q = 2/(1 - 2 nu), at most 1e5
        #[arg(long, value_delimiter = ',', default_values = ["0.1", "0.3", "0.4", "0.45", "0.49"], value_parser = within::<Order>("(0, 0.49999]"))]
        pub nu: Vec<Order>,
    }
}

/// Bounds of C(q) at one order.
pub struct Row {
    /// The order.
    pub nu: f64,
    /// The exponent.
    pub q: f64,
    /// The quotient of a function: C(q) from below.
    pub lower: Estimate,
    /// C(q) from above.
    pub upper: Estimate,
    /// C(1 − 1/q) from below, at ν = 1/2.
    pub hoelder: Option<Estimate>,
}

/// Both bounds for every q and nu.
pub fn compute(options: &Options) -> Result<Vec<Row>> {
    let bar = progress((options.q.len() + options.nu.len()) as u64);
    let mut rows = Vec::new();
    let row = |order: Order, q: f64| -> Result<Row> {
        let found = embedding_constant(order, q, Tolerance::balanced())?;
        let upper = found.upper.unwrap_or(found.constant);
        Ok(Row { nu: order.value(), q, lower: found.lower, upper, hoelder: None })
    };
    for &q in &options.q {
        let hoelder = embedding_constant(1.5, Target::Hoelder(1.0 - 1.0 / q), Tolerance::balanced())?.lower;
        rows.push(Row { hoelder: Some(hoelder), ..row(Order::HALF, q)? });
        bar.inc(1);
    }
    for &order in &options.nu {
        rows.push(row(order, 2.0 / (-2.0 * order.offset()))?);
        bar.inc(1);
    }
    Ok(rows)
}

/// What decides: lower against upper bounds, and both against the root of q.
pub fn findings(_: &Options, rows: &[Row]) -> Vec<Finding> {
    let at_half = || rows.iter().filter(|row| row.hoelder.is_some());
    let growth = |row: &Row, bound: Estimate| bound.times(row.q.sqrt().recip()).ok();
    // Where the upper bound is 1 the constant function attains it, and only rounding could tell the two
    // apart.
    let share = |attained: bool| {
        let rows = rows.iter().filter(move |row| (row.upper.value == 1.0) == attained);
        rows.filter_map(|row| row.lower.over(row.upper).ok())
    };
    vec![
        Finding::claim("growth.lower", "C(q) is at least {value} q^(1/2)")
            .smallest(at_half().filter_map(|row| growth(row, row.lower)))
            .at_least(GROWTH[0], "the limit (3/(4 pi^2 e))^(1/2), rounded down")
            .told(),
        Finding::claim("growth.upper", "C(q) is at most {value} q^(1/2)")
            .largest(at_half().filter_map(|row| growth(row, row.upper)))
            .at_most(GROWTH[1], "its value 1/sqrt(2) at q = 2, rounded up")
            .told(),
        Finding::claim("ordered", "no function passes the upper bound, the best takes {percent} % of it")
            .largest(share(false))
            .at_most(1.0, "upper bound"),
        Finding::claim("attained", "where the upper bound is 1 the constant function attains it")
            .largest(share(true).filter_map(|share| share.off(1.0).ok()))
            .at_most(ACCURACY, "C(q) = 1"),
        Finding::claim("hoelder", "C(alpha) stays below the upper bound of C(q), {percent} % of it at most")
            .largest(at_half().filter_map(|row| row.hoelder?.over(row.upper).ok()))
            .at_most(1.0, "Hoelder's inequality"),
        Finding::claim("hoelder.growth", "C(alpha) is at least {value} (1-alpha)^(-1/2)")
            .smallest(at_half().filter_map(|row| growth(row, row.hoelder?)))
            .at_least(GROWTH[0], "the same limit"),
        Finding::remark("gap", "upper and lower bound of C(q) differ by a factor of {value} at most")
            .largest(rows.iter().filter_map(|row| row.upper.over(row.lower).ok()))
            .at_most(GAP, "quotient of both limits for large q"),
    ]
}

/// Both bounds of the constants and their growth.
pub fn run(options: &Options) -> Result<Headline> {
    let rows = compute(options)?;
    let claim = "H^nu(0,1) embeds in L^q(0,1), q <= 2/(1-2 nu); C(q) grows like sqrt(q) at nu = 1/2";
    let mut headline = Headline::new("Sec. 3, C(q)", claim, table(&rows), findings(options, &rows));
    for Row { q, lower, upper, .. } in rows.iter().filter(|row| row.hoelder.is_some()) {
        headline.quote(format!("section_3_embedding.lower.q_{q}"), lower.value);
        headline.quote(format!("section_3_embedding.upper.q_{q}"), upper.value);
    }
    headline.draw(&options.output, "section_3_embedding_constants", || Ok(draw(&rows)))?;
    Ok(headline)
}

fn table(rows: &[Row]) -> Table {
    let (digits, growth) = (Format::Fixed(6), Format::Fixed(4));
    Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("q", "q", Format::Significant(5), "for nu < 1/2 the critical exponent 2/(1-2 nu)"),
        Column::new("lower", "C(q) >=", digits, "quotient of a function"),
        Column::new("upper", "C(q) <=", digits, "for all functions"),
        Column::new("growth", ">= /sqrt(q)", growth, "the lower bound over sqrt(q)"),
        Column::new("upper_growth", "<= /sqrt(q)", growth, "the upper bound over sqrt(q)"),
        Column::new("alpha", "alpha", Format::Significant(5), "1 - 1/q"),
        Column::new("hoelder", "C(alpha) >=", Format::Fixed(5), "H^(3/2), pairs (0, theta)"),
        Column::new("hoelder_growth", "*(1-alpha)^(1/2)", growth, "C(alpha) q^(-1/2)"),
    ])
    .with_rows(rows.iter().map(|row| {
        let (q, root) = (row.q, row.q.sqrt());
        let (lower, upper) = (row.lower.value, row.upper.value);
        let hoelder = row.hoelder.map_or(vec![], |c| vec![1.0 - 1.0 / q, c.value, c.value / root]);
        [[row.nu, q, lower, upper, lower / root, upper / root].as_slice(), &hoelder].concat()
    }))
}

fn draw(rows: &[Row]) -> Chart {
    let points = |of: fn(&Row) -> f64| -> Vec<(f64, f64)> {
        rows.iter().filter(|row| row.hoelder.is_some()).map(|row| (row.q, of(row))).collect()
    };
    let y = Axis::logarithmic("C(q), embedding constant");
    let hoelder = points(|row| row.hoelder.map_or(f64::NAN, |c| c.value));
    Chart::new("C(q) of H^(1/2)(0,1) in L^q(0,1)", Axis::logarithmic("q, exponent"), y)
        .with(Series::line_and_points("upper bound", points(|row| row.upper.value)))
        .with(Series::line_and_points("lower bound", points(|row| row.lower.value)))
        .with(Series::line_and_points("C(alpha), alpha = 1 - 1/q, lower bound", hoelder))
        .with(Series::dashed("0.1672 sqrt(q)", points(|row| LIMIT * row.q.sqrt())))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
