//! The induction (5.5)-(5.9) in the proof of Lemma 5.2, every factor beside its bound.
//!
//! From θ to θ²: γ_{θ²} ≤ γ_θ (1 + θ^{ν−1/2}), hence γ at θ₀^{2ⁿ} is at most γ_{θ₀} times a product. (5.7) is
//! followed on the extremal function u of V_{θ²}: |c| ≤ ‖u‖_{0,(0,1)} ≤ γ_θ |u|_{ν,(0,1)} ≤ γ_θ |u|_{ν,I} in
//! the variable x/θ, c its mean over (0,1). The middle one can fail. (5.6) adds up what is left, and the last
//! lines of the proof bound the product in three cases.
//!
//! `cargo run --release --example lemma_5_2_induction`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table};
use experiments::EstimateExt;
use experiments::induction::{InductionStep, induction, scaling_defect};
use fractional_sobolev::{Estimate, Order, Tolerance};
use std::f64::consts::SQRT_2;
use std::process::ExitCode;

example_frame::options! {
    /// Every step of the induction (5.5)-(5.9) beside its bound
    pub struct Options: Quick {
        /// Orders nu in (0, 1)
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
        pub nu: Vec<Order>,
        /// Where the induction starts
        #[arg(long, default_value_t = 0.5)]
        pub theta: f64,
        /// How often theta is squared
        #[arg(long, default_value_t = 5)]
        pub steps: u32,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value_t = Tolerance::balanced())]
        pub tolerance: Tolerance,
    }
}

/// The steps of one order, in order.
pub struct Chain {
    /// ν.
    pub order: Order,
    /// From θ to θ², θ⁴, ...
    pub steps: Vec<InductionStep>,
    /// How far both norms are from (5.5) on the interval stretched by 1/θ.
    pub scaling: Estimate,
}

/// Squares θ step by step, for every order.
pub fn compute(options: &Options) -> Result<Vec<Chain>> {
    let chain = |&order: &Order| -> Result<Chain> {
        let (theta, tolerance) = (options.theta, options.tolerance);
        let steps = induction(order, theta, options.steps, tolerance)?;
        Ok(Chain { order, steps, scaling: scaling_defect(order, theta, tolerance)? })
    };
    options.nu.iter().map(chain).collect()
}

/// How near to sqrt 2 the last step has to be, the change from the step before included.
const SETTLED: f64 = 0.02;
/// What two quadratures may differ by.
const SCALED: f64 = 1e-6;

/// What decides: no factor, no quotient of (5.7) and no product passes its bound; what a step gives away.
pub fn findings(chains: &[Chain]) -> Vec<Finding> {
    let largest = |part: fn(&InductionStep) -> Estimate| {
        Estimate::largest(chains.iter().flat_map(|chain| &chain.steps).map(part))
    };
    let quotient = |key: &str, words: &str, part| {
        Finding::claim(key, words).estimate_or(largest(part), "no order").at_most(1.0, "its bound")
    };
    let mut findings = vec![
        quotient("step", "no step passes (5.8): at most {percent} % of its bound", |s| s.share)
            .otherwise("a step takes {percent} % of 1 + theta^(nu-1/2)")
            .told(),
        quotient("poincare", "(5.7), its middle inequality, holds on the extremal functions", |s| s.poincare),
        Finding::claim("scaling", "norm and seminorm scale as in (5.5), to {value} by quadrature")
            .largest(chains.iter().map(|chain| chain.scaling))
            .at_most(SCALED, "0: a change of variables"),
        quotient("stretched", "(5.6) holds on them, at {percent} % of its right side", |s| s.stretched),
        quotient("product", "no product passes (5.9): at most {percent} % of it", |s| s.product),
        quotient("closing", "the last lines of the proof hold, at {percent} % of them", |s| s.closing),
        Finding::remark("mean", "|c| <= ||u|| by Cauchy-Schwarz").by_proof("lemma_5_2_induction"),
    ];
    for Chain { order, steps, .. } in chains {
        let (Some(last), Some(before)) = (steps.last(), steps.iter().rev().nth(1)) else {
            continue;
        };
        let (value, error) = (1.0 / last.share.value, last.share.error / last.share.value.powi(2));
        let change = (value - 1.0 / before.share.value).abs();
        let gives = format!("nu = {order}: the last step gives away a factor {{value}}");
        findings.push(if order.offset() == 0.0 {
            Finding::sharpness(
                "given.half",
                "by a factor sqrt 2 per step at nu = 1/2, by {value} in the last",
            )
            .number(value, error + change)
            .within(SETTLED, SQRT_2, "2 over sqrt 2, the growth of gamma ~ ln(1/theta)^(1/2)")
            .told()
        } else {
            Finding::remark(format!("given.nu{order}"), format!("{gives}, less than at nu = 1/2"))
                .number(value, error)
                .at_most(SQRT_2, "sqrt 2")
                .otherwise(gives)
        });
    }
    findings
}

/// Computes the steps and sets each beside its bound.
pub fn run(options: &Options) -> Result<Headline> {
    let chains = compute(options)?;
    let claim =
        "gamma at theta^2 <= gamma at theta times (1 + theta^(nu-1/2)), and the product of these factors";
    let mut headline = Headline::new("(5.5)-(5.9)", claim, table(&chains), findings(&chains));
    let quotients = |s: &InductionStep| {
        [s.share, s.product, s.mean, s.poincare, s.restriction, s.stretched, s.closing].map(|e| e.value)
    };
    let worst = chains.iter().flat_map(|chain| &chain.steps).flat_map(quotients).fold(0.0, f64::max);
    headline.quote("lemma.5.2.induction.worst", worst);
    headline.draw(&options.output, "lemma_5_2_induction", || Ok(draw(&chains)))?;
    Ok(headline)
}

fn table(chains: &[Chain]) -> Table {
    let (four, five) = (Format::Significant(4), Format::Significant(5));
    let columns = vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("theta", "theta^2", Format::Scientific(1), "length after the step"),
        Column::new("gamma", "gamma", Format::Significant(8), "its constant"),
        Column::new("factor", "factor", five, "gamma at theta^2 over gamma at theta"),
        Column::new("bound", "(5.8)", five, "1 + theta^(nu-1/2)"),
        Column::new("mean", "(5.7) a", four, "|c| / ||u||_{0,(0,1)}, at most 1"),
        Column::new("poincare", "(5.7) b", four, "||u||_{0,(0,1)} / (gamma_theta |u|_{nu,(0,1)}), at most 1"),
        Column::new("restriction", "(5.7) c", four, "|u|_{nu,(0,1)} / |u|_{nu,I}, at most 1"),
        Column::new("stretched", "(5.6)", four, "left side over right side"),
        Column::new("product", "(5.9)", five, "gamma over its bound by the product"),
        Column::new("closing", "last lines", four, "gamma over the bound that ends the proof"),
    ];
    let rows = chains.iter().flat_map(|chain| {
        chain.steps.iter().map(|s| {
            let quotients = [s.mean, s.poincare, s.restriction, s.stretched, s.product, s.closing];
            let first = [chain.order.value(), s.theta, s.gamma.value, s.factor.value, s.bound];
            first.into_iter().chain(quotients.map(|e| e.value))
        })
    });
    Table::new(columns).with_rows(rows)
}

fn draw(chains: &[Chain]) -> Chart {
    let (x, y) = ("θ, length of the zone (interval = 1)", "constant over its bound");
    let chart = Chart::new("γ over the bound (5.9)", Axis::logarithmic(x), Axis::logarithmic(y));
    chains.iter().fold(chart, |chart, Chain { order, steps, .. }| {
        let points = steps.iter().map(|s| (s.theta, s.product.value)).collect();
        chart.with(Series::line_and_points(format!("ν = {order}"), points))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
