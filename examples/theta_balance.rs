//! The balance of Section 3: both bounds as functions of theta, the printed choice, and the true worst case.
//!
//! `cargo run --release --example theta_balance -- --tau 2`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table};
use experiments::convergence::Levels;
use experiments::proof::{BalanceExponents, BalanceRow, ElementBalance, worst_of_cases};
use std::process::ExitCode;

example_frame::options! {
    /// Compare the bounds of both cases with an optimisation over complementary pairs (u_N, sigma_N) on one
    /// element
    pub struct Options: Quick {
        /// Regularity, in (3/2, 2]
        #[arg(long, default_value_t = 1.75)]
        pub tau: f64,
        /// Exponent q of the embedding at tau = 2
        #[arg(long, default_value_t = 2.0)]
        pub q: f64,
        /// Element lengths h = 2^-COARSEST ... 2^-FINEST
        #[arg(long, default_value = "3-12")]
        pub levels: Levels,
    }
    check(options) {
        Ok(options.levels.require_count(3, "[3, 22]: an exponent takes three meshes")?)
    }
}

/// What is computed: bounds and worst pairs per element length, and their exponents of h.
pub struct Computed {
    balance: ElementBalance,
    /// Per element length, coarsest first.
    pub rows: Vec<BalanceRow>,
    /// Exponents of h over these lengths.
    pub exponents: BalanceExponents,
    /// The largest part of the bound of its case that a worst pair takes.
    pub share: f64,
}

/// Bounds and worst pairs for every element length.
pub fn compute(options: &Options) -> Result<Computed> {
    let balance = ElementBalance::new(options.tau, options.q)?;
    let lengths: Vec<f64> = options.levels.cells().map(|n| 1.0 / n as f64).collect();
    let rows = balance.rows(&lengths)?;
    let (exponents, share) = (BalanceExponents::fit(&rows)?, balance.largest_share(&rows));
    Ok(Computed { balance, rows, exponents, share })
}

/// Contact intervals lie on a grid of powers of 1/2: the supremum exceeds the largest by less than this part.
const GRID: f64 = 0.05;
/// Powers of h without a logarithm: what rounding leaves of a fit over ten lengths.
const ROUNDING: f64 = 1e-9;

/// What decides: no pair passes the bounds, the exponents are the printed ones, and what lies between them
/// and the worst pair.
pub fn findings(options: &Options, computed: &Computed) -> Vec<Finding> {
    let (tau, Computed { exponents: e, share, rows, .. }) = (options.tau, computed);
    let bounds = Finding::claim("bounds", "no worst pair passes the bound of its case, at most {percent} %")
        .number(*share, GRID * share)
        .at_most(1.0, "the bounds (3.9), (3.14) with their constants");
    let lost = Finding::sharpness("loss", "h^{value} against the worst pair of an element")
        .number(e.worst.order - e.printed.order, e.worst.uncertainty + e.printed.uncertainty)
        .at_least(0.0, "equal exponents")
        .told();
    let own = Finding::claim("own.bounds", "and none that with theta_T = r, at most {percent} %")
        .largest_of(rows.iter().map(|row| (row.own_share, 0.0)), "no element length")
        .at_most(1.0, "(3.5) and (3.12) at the same theta");
    let mut findings = vec![bounds, lost, own];
    for (key, own) in [("own", e.own[0]), ("own.midpoint", e.own[1])] {
        let finding = Finding::claim(key, "with theta_T = r on each segment the exponent is {value}");
        let finding = finding.number(own.order, own.uncertainty);
        findings.push(finding.within(0.01, 2.0 * tau - 2.0, "2 tau - 2"));
    }
    // At τ = 2 both bounds carry logarithms, which no exponent over these lengths tells apart.
    if tau < 2.0 {
        let equation = 2.0 * tau * tau - 5.0 * tau + 4.0;
        let choice = Finding::claim("printed", "the printed choice gives one element the exponent {value}");
        let choice = choice.number(e.printed.order, e.printed.uncertainty);
        findings.push(choice.within(ROUNDING, equation, "2 tau^2 - 5 tau + 4").told());
        let way = 2.0 * tau - 2.0 - equation;
        let (gain, bar) =
            (e.sharpened.order - e.printed.order, e.sharpened.uncertainty + e.printed.uncertainty);
        let regained =
            Finding::remark("sharpened", "the sharpened first case regains {percent} % of the loss");
        let regained = regained.number(gain / way, bar / way);
        findings.push(regained.within(ROUNDING, 0.5, "half of (tau - 3/2)(2 - tau)"));
    }
    let growth = |theta: f64| rows.last().map(|row| worst_of_cases(&row.pairs, theta)[1]);
    let growth = growth(1e-3).zip(growth(0.2)).map(|(short, long)| (short / long - 1.0, 0.0));
    findings.push(
        Finding::remark("second.case", "the worst pair of the second case does not grow as theta falls")
            .number_or(growth, "no element length")
            .within(ROUNDING, 0.0, "the same contact set is the worst for theta = 1e-3 and 0.2"),
    );
    findings
}

/// Finds the worst pairs of every contact interval and sets them beside the bounds.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "theta = h^(2 tau - 3), h^2 at tau = 2, balances the bounds of the first and the second case";
    let found = findings(options, &computed);
    let mut headline = Headline::new("Section 3, Globally", claim, table(&computed.rows), found);
    let Computed { balance, exponents: e, rows, .. } = &computed;
    let keys = ["printed", "crossing", "sharpened", "worst", "own"];
    for (key, exponent) in keys.into_iter().zip([e.printed, e.crossing, e.sharpened, e.worst, e.own[0]]) {
        headline.quote_with(&format!("theta.balance.{key}"), exponent.order, exponent.uncertainty);
    }
    if let Some(finest) = rows.last() {
        headline.quote("theta.balance.worst.place", finest.worst.ends[0]);
        headline.draw(&options.output, "theta_balance", || Ok(draw(balance, finest)))?;
    }
    Ok(headline)
}

fn table(rows: &[BalanceRow]) -> Table {
    let number = Format::Scientific(2);
    let columns = vec![
        Column::new("n", "1/h", Format::Plain, "length of the element"),
        Column::new("theta", "theta", number, "printed choice"),
        Column::new("bound", "B", number, "larger of both printed bounds there"),
        Column::new("crossing", "crossing", number, "theta at which the printed bounds agree"),
        Column::new("crossing_bound", "B cross", number, "both bounds there"),
        Column::new("sharp_crossing", "sharp", number, "theta at which the sharpened bounds agree"),
        Column::new("sharp_bound", "B sharp", number, "both bounds there"),
        Column::new("first", "W first", number, "worst pair, contact sets of the first case at theta"),
        Column::new("second", "W second", number, "the same, second case"),
        Column::new("own", "B own", number, "largest bound with theta_T = r on each segment"),
        Column::new("worst", "W", number, "worst pair over all contact sets"),
        Column::new("place", "a", Format::Plain, "the worst contact set begins at a h"),
    ];
    Table::new(columns).with_rows(rows.iter().map(|row| {
        let all =
            [[1.0 / row.h].as_slice(), &row.printed, &row.crossing, &row.sharpened, &row.cases].concat();
        all.into_iter().chain([row.own[0], row.worst.value, row.worst.ends[0]])
    }))
}

/// Bounds and worst cases over θ for one h.
fn draw(balance: &ElementBalance, row: &BalanceRow) -> Chart {
    let (h, tau) = (row.h, balance.constants().tau());
    let thetas: Vec<f64> = (2..=40).map(|k| 0.5f64.powf(0.25 * f64::from(k))).collect();
    let line = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> { thetas.iter().map(|&t| (t, f(t))).collect() };
    let y = Axis::logarithmic("∫σ(I^h u) per norms of σ_N and u_N'");
    let [low, high] = [row.worst.value, balance.first_bound(h, 0.7).max(row.printed[1])];
    Chart::new(format!("One element, h = {h:.3e}, τ = {tau}"), Axis::logarithmic("θ"), y)
        .with(Series::line("first case, printed (3.9)", line(&|t| balance.first_bound(h, t))))
        .with(Series::line("second case, printed (3.14)", line(&|t| balance.second_bound(h, t)[0])))
        .with(Series::dashed("first case, sharpened", line(&|t| balance.sharpened_first_bound(h, t))))
        .with(Series::dashed("second case, corrected law", line(&|t| balance.second_bound(h, t)[1])))
        .with(Series::points("true worst, first case", line(&|t| worst_of_cases(&row.pairs, t)[0])))
        .with(Series::line("true worst, second case", line(&|t| worst_of_cases(&row.pairs, t)[1])))
        .with(Series::dashed("printed θ", vec![(row.printed[0], 0.3 * low), (row.printed[0], high)]))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
