//! Lemma 6.1: ‖u − I u‖₀ ≤ h^{1+ν} |u|_{1+ν} and ‖u − I u‖₁ ≤ h^ν |u|_{1+ν} on an interval of length h.
//!
//! Rough functions drawn at random, powers at the edge of H^ν, and the best constants beside them. The second
//! line, with the full H¹ norm, fails with constant 1 on elements longer than h*(ν).

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, progress};
use experiments::EstimateExt;
use experiments::interpolation::{LocalConstants, WorstRatios, worst_ratios};
use fractional_sobolev::{Estimate, Order, Tolerance};
use std::process::ExitCode;

example_frame::options! {
    /// Local interpolation estimate: ratios of rough functions and the best constants
    pub struct Options: Quick {
        /// Orders nu in (0, 1), comma separated
        #[arg(long, value_delimiter = ',', default_values = ["0.01", "0.1", "0.25", "0.5", "0.75", "0.9", "0.99"])]
        pub nu: Vec<Order>,
        /// Random functions per family and order; with 0 only powers are tried
        #[arg(long, default_value_t = 60)]
        pub functions: usize,
        /// Seed of the random functions
        #[arg(long, default_value_t = 1)]
        pub seed: u64,
        /// Relative tolerance of the best constants: fast, balanced, reference or a number
        #[arg(long, default_value = "1e-10")]
        pub tolerance: Tolerance,
    }
}

/// What is computed for one order.
pub struct Row {
    /// Order of the lemma.
    pub nu: f64,
    /// Best constants.
    pub best: LocalConstants,
    /// Largest ratios found.
    pub tried: WorstRatios,
}

/// Rows per order, and the limits of the constants for ν → 0, which bound those of all orders.
pub struct Computed {
    /// Per order.
    pub rows: Vec<Row>,
    /// The limits.
    pub limit: LocalConstants,
}

/// Best constants and what a search by hand finds, for every order.
pub fn compute(options: &Options) -> Result<Computed> {
    let bar = progress(options.nu.len() as u64);
    let mut rows = Vec::new();
    for &order in &options.nu {
        let best = LocalConstants::new(order, options.tolerance)?;
        rows.push(Row {
            nu: order.value(),
            best,
            tried: worst_ratios(order, options.functions, options.seed)?,
        });
        bar.inc(1);
    }
    Ok(Computed { rows, limit: LocalConstants::at_zero()? })
}

/// What decides: best constants against the printed 1, the full norm beside h*, functions against the former.
pub fn findings(_: &Options, Computed { rows, limit }: &Computed) -> Vec<Finding> {
    type Of = fn(&LocalConstants) -> Estimate;
    let constants = |of: Of| rows.iter().map(|row| &row.best).chain([limit]).map(of);
    let shares = |k: usize| rows.iter().filter_map(move |row| Some(row.tried.shares(&row.best).ok()?[k]));
    let one = |finding: Finding, of: Of| finding.largest(constants(of)).at_most(1.0, "printed constant");
    let loose = |norm: &str, words: &str, of: Of| {
        let factors = constants(of).filter_map(|constant| constant.recip().ok());
        let finding = Finding::sharpness(format!("loose.{norm}"), format!("by {{value}} or more {words}"));
        finding.smallest(factors).at_least(1.0, "printed constant").told()
    };
    let tried = |norm: &str, words: &str, k: usize| {
        let words = format!("no function tried takes more than {{percent}} % of the best constant {words}");
        Finding::claim(format!("tried.{norm}"), words).largest(shares(k)).at_most(1.0, "best constant")
    };
    let length = format!("h* is at least {:.2}, its limit for nu -> 0", limit.longest.value);
    let fails = format!("second line, full H1 norm, for h > h*(nu), constant {{value}} just above; {length}");
    let full = Finding::printed("full", "with the full H1 norm it holds for every h").otherwise(fails);
    let claims: [(&str, &str, Of); 4] = [
        ("l2", "the first line holds for every h, best constant up to {value}", |c| c.l2),
        ("derivative", "for the derivative the second line holds for every h, {value}", |c| c.derivative),
        ("full.short", "with the full H1 norm it holds for h <= 1, constant up to {value}", |c| c.full),
        ("full.below", "with the full H1 norm it holds just below h*(nu), {value}", |c| c.below),
    ];
    let others = [
        one(full, |c| c.above),
        Finding::claim("longest", "elements of a mesh of (0, 1) are shorter than h*(nu), at least {value}")
            .smallest(constants(|c| c.longest))
            .at_least(1.0, "length of the interval"),
        tried("l2", "in L2", 0),
        tried("derivative", "for the derivative", 1),
        loose("l2", "in L2, for every nu", |c| c.l2),
        loose("derivative", "for the derivative, for every nu", |c| c.derivative),
    ];
    claims.map(|(key, words, of)| one(Finding::claim(key, words), of)).into_iter().chain(others).collect()
}

/// Tries the lemma on rough functions and compares its printed constant and its best ones.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim =
        "|u - Iu|_0 <= h^(1+nu) |u|_(1+nu), |u - Iu|_1 <= h^nu |u|_(1+nu) on an interval of length h > 0";
    let found = findings(options, &computed);
    let Computed { rows, limit } = &computed;
    let mut headline = Headline::new("Lemma 6.1", claim, table(options, rows), found);
    for Row { nu, best, .. } in rows {
        headline.quote(format!("lemma_6_1.best_l2.nu_{nu}"), best.l2.value);
        headline.quote(format!("lemma_6_1.best_derivative.nu_{nu}"), best.derivative.value);
    }
    headline.quote("lemma_6_1.limit_l2", limit.l2.value);
    headline.quote("lemma_6_1.limit_derivative", limit.derivative.value);
    headline.quote("lemma_6_1.longest_element", limit.longest.value);
    headline.draw(&options.output, "lemma_6_1_local_estimate", || Ok(draw(rows)))?;
    Ok(headline)
}

fn table(options: &Options, rows: &[Row]) -> Table {
    let (ratio, digits, error) = (Format::Fixed(4), Format::Fixed(10), Format::Scientific(0));
    let tried = format!("among powers and {} random functions of each family", options.functions);
    let found = format!("largest |u - Iu|_0 / (h^(1+nu) |u'|_nu) {tried}");
    Table::new(vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("worst_l2", "found L2", ratio, found),
        Column::new("best_l2", "best L2", digits, "best constant in place of 1"),
        Column::new("error_l2", "+- L2", error, "error of the best constant in L2: truncation and rounding"),
        Column::new("worst_derivative", "found deriv.", ratio, "largest |(u - Iu)'|_0 / (h^nu |u'|_nu)"),
        Column::new("best_derivative", "best deriv.", digits, "best constant, gamma_1(nu)"),
        Column::new("error_derivative", "+- deriv.", error, "error of the best constant for the derivative"),
        Column::new("longest", "h*", Format::Fixed(3), "constant 1 serves the full H1 norm for h <= h*"),
    ])
    .with_rows(rows.iter().map(|Row { nu, best, tried }| {
        let of = |tried: Estimate, best: Estimate| [tried.value, best.value, best.error];
        let [l2, derivative] = [of(tried.l2, best.l2), of(tried.derivative, best.derivative)];
        [[*nu].as_slice(), &l2, &derivative, &[best.longest.value]].concat()
    }))
}

fn draw(rows: &[Row]) -> Chart {
    let points = |of: fn(&Row) -> f64| rows.iter().map(|row| (row.nu, of(row))).collect::<Vec<_>>();
    let y = Axis::linear("error over its bound with constant 1");
    Chart::new("Lemma 6.1: the constant 1 and the best ones", Axis::linear("nu, order"), y)
        .with(Series::dashed("printed: 1", points(|_| 1.0)))
        .with(Series::line("best, derivative", points(|row| row.best.derivative.value)))
        .with(Series::points("rough functions, derivative", points(|row| row.tried.derivative.value)))
        .with(Series::line("best, L2", points(|row| row.best.l2.value)))
        .with(Series::points("rough functions, L2", points(|row| row.tried.l2.value)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
