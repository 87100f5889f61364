//! Remark 5: (5.3) fails at ν = 1/2. Truncations of |ln x|^α; the paper takes 0 < α < 1/2.
//!
//! w = 1 − min(|ln x|^α, n)/n vanishes on (0, θ), θ = exp(−n^{1/α}), ‖w‖₀ ≥ 1 − O(1/n) and |w|_{1/2} ≤ C/n.
//! The printed chain of full norms is false, that of seminorms holds. With L = ln(1/θ) the constant of the
//! zone grows like √L, and α = 1, no member of the paper's family, reaches that with the right factor.
//!
//! `cargo run --release --example remark_5_log_counterexample`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Cell, Column, Finding, Format, Headline, Result, Table, increasing, within};
use experiments::growth::last_exponent;
use experiments::trial::{NormChain, TruncatedFamily, truncated_slope};
use fractional_sobolev::{Constraint, Estimate, Order, Tolerance, gamma};
use std::process::ExitCode;

example_frame::options! {
    /// Quotients of the truncated logarithms of Remark 5 beside the Poincare constants of their zones
    pub struct Options {
        /// Exponents alpha in (0, 1]; those of the paper are below 1/2
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.4", "0.45", "0.75", "1"], value_parser = within::<f64>("(0, 1]"))]
        pub alpha: Vec<f64>,
        /// L = ln(1/theta)
        #[arg(long, value_delimiter = ',', default_values = ["4", "16", "64", "256"], value_parser = within::<f64>("[1, 690]"))]
        pub log: Vec<f64>,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value_t = Tolerance::balanced())]
        pub tolerance: Tolerance,
    }
    check(options) {
        increasing("--log", &options.log)
    }
}

/// What is computed.
pub struct Computed {
    /// Quotients and their growth, per exponent.
    pub families: Vec<TruncatedFamily>,
    /// (L, γ).
    pub constants: Vec<(f64, Estimate)>,
    /// The exponent of L in γ between the last two zones.
    pub growth: Option<Estimate>,
}

/// Constants of the zones, and quotients of the functions that vanish on them.
pub fn compute(options: &Options) -> Result<Computed> {
    let mut constants = Vec::new();
    for &log in &options.log {
        let zone = Constraint::vanishing_on(0.0..(-log).exp());
        constants.push((log, gamma(Order::HALF, zone, options.tolerance)?.constant));
    }
    let family = |&alpha| TruncatedFamily::new(alpha, &constants, Tolerance::balanced());
    let families = options.alpha.iter().map(family).collect::<fractional_sobolev::Result<Vec<_>>>()?;
    Ok(Computed { families, growth: last_exponent(&constants)?, constants })
}

/// A quadratic interpolant on layers may raise the seminorm by this part; more, and the mesh is too coarse.
const RESOLUTION: f64 = 1e-3;
/// How near to a power of L the growth has to be, its change from zone to zone included.
const POWER: f64 = 0.02;
/// How near to its limit the slope of the square has to be for alpha = 1, its change included.
const SLOPE: f64 = 1e-3;

/// What decides: every quotient grows, below a constant that grows like √L; which chain of norms holds.
pub fn findings(computed: &Computed) -> Vec<Finding> {
    let families = &computed.families;
    let chain = |part: fn(&NormChain) -> f64| {
        families.iter().flat_map(|family| &family.chain).map(move |norms| (part(norms), 0.0))
    };
    let (above, few) = ("no alpha below 1/2", "fewer than two zones");
    let mut findings = vec![
        Finding::claim("below", "every quotient lies below the constant of its zone, at {percent} % at most")
            .largest(families.iter().flat_map(|family| family.shares.iter().copied()))
            .at_most(1.0, "the constant is a supremum")
            .otherwise("a quotient is {percent} % of the constant of its zone"),
        Finding::printed("chain", "the printed chain of full norms, ||w||_{1/2} = ||v||_{1/2} <= 1/n, holds")
            .largest_of(chain(|norms| norms.printed), above)
            .at_most(1.0, "||w||_{1/2} in units of 1/n")
            .otherwise("||w||_{1/2} <= 1/n is false: it is up to {value} times 1/n"),
        Finding::claim("repaired", "with seminorms it holds: |w| is {percent} % of |u|/n at most")
            .largest_of(chain(|norms| norms.truncation), above)
            .at_most(1.0 + RESOLUTION, "truncation lowers the seminorm, up to interpolation")
            .otherwise("|w| is {percent} % of |u|/n: the mesh near x = 1 does not resolve so small an alpha"),
        Finding::claim("constant", "the constant of the zone grows like L^{value}, L = ln(1/theta)")
            .estimate_or(computed.growth, few)
            .within(POWER, 0.5, "the square root of the law at nu = 1/2")
            .told(),
    ];
    for TruncatedFamily { alpha, growth, slope, .. } in families {
        let of = |key: &str| format!("{key}.alpha{alpha}");
        let grows = Finding::claim(of("grows"), format!("alpha = {alpha}: quotients grow like L^{{value}}"));
        findings
            .push(grows.estimate_or(*growth, few).at_least(0.0, "a bounded quotient, as in (5.3)").told());
        let limit = if *alpha > 0.5 {
            Finding::remark(
                of("slope"),
                format!("alpha = {alpha}: its square grows by {{value}} L, the limit"),
            )
            .estimate_or(*slope, few)
            .within(SLOPE, truncated_slope(*alpha), "(2 alpha - 1)/alpha^2 times 3/(2 pi^2)")
            .otherwise(format!("alpha = {alpha}: its square grows by {{value}} L, not yet the limit"))
        } else {
            Finding::remark(of("power"), format!("alpha = {alpha}: that is L^alpha"))
                .estimate_or(*growth, few)
                .within(POWER, *alpha, "alpha")
                .otherwise(format!("alpha = {alpha}: that is not yet the power L^alpha"))
                .undecided(format!("alpha = {alpha}: too few zones to tell it from L^alpha"))
        };
        findings.push(limit);
    }
    findings
}

/// Follows the family down to very short zones.
pub fn run(options: &Options) -> Result<Headline> {
    let computed = compute(options)?;
    let claim = "no C bounds ||w||_0 / |w|_{1/2} for functions that vanish on an interval of length theta";
    let mut headline = Headline::new("Remark 5", claim, table(&computed), findings(&computed));
    headline.draw(&options.output, "remark_5_log_counterexample", || Ok(draw(&computed)))?;
    Ok(headline)
}

fn table(computed: &Computed) -> Table {
    let columns = vec![
        Column::new("alpha", "alpha", Format::Significant(3), ""),
        Column::new("log", "L", Format::Significant(3), "ln(1/theta)"),
        Column::new("quotient", "q", Format::Significant(6), "||w|| / |w| of the truncated function"),
        Column::new("gamma", "gamma", Format::Significant(8), "constant of the zone (0, theta)"),
        Column::new("used", "share", Format::Significant(4), "quotient / gamma, at most 1"),
        Column::new("square", "q^2/L", Format::Significant(4), "3/(2 pi^2) in the limit for alpha = 1"),
        Column::new("full", "n ||w||", Format::Significant(4), "full norm over 1/n, printed as at most 1"),
        Column::new("bound", "n |w|", Format::Significant(4), "seminorm over 1/n, at most 1"),
    ];
    let rows = computed.families.iter().flat_map(|f| {
        (0..f.quotients.len()).map(|k| {
            let ((log, q), g, share) = (f.quotients[k], computed.constants[k].1, f.shares[k]);
            let norm = |part: fn(&NormChain) -> f64| Cell::from(f.chain.get(k).map(part));
            let norms = [norm(|norms| norms.printed), norm(|norms| norms.repaired)];
            let first = [f.alpha, log, q.value, g.value, share.value, q.value * q.value / log];
            first.map(Cell::from).into_iter().chain(norms)
        })
    });
    Table::new(columns).with_rows(rows)
}

fn draw(computed: &Computed) -> Chart {
    let points = |curve: &[(f64, Estimate)]| curve.iter().map(|(log, number)| (*log, number.value)).collect();
    let (x, y) = ("L = ln(1/θ), logarithm of the zone", "‖w‖ / |w|, quotient of the function");
    let title = "Remark 5: quotients of truncated logarithms";
    let chart = Chart::new(title, Axis::logarithmic(x), Axis::logarithmic(y));
    let lines = computed.families.iter().fold(chart, |chart, family| {
        chart.with(Series::line_and_points(format!("α = {}", family.alpha), points(&family.quotients)))
    });
    lines.with(Series::dashed("γ of the zone", points(&computed.constants)))
}

fn main() -> ExitCode {
    example_frame::main(run)
}
