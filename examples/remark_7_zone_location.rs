//! Remark 7: the constants hold wherever the zone lies.
//!
//! The statement: γ for (a, a+θ) is never above γ for (0, θ), hence of the same order. The printed proof cuts
//! the interval inside the zone and uses Lemma 5.2 on both pieces, as if the mean over each part of the zone
//! were zero. With u odd about the middle of a zone in the middle, the mean over the zone is zero whatever u
//! is on the left half:
//! * ν < 1/2: u = sgn(x − 1/2) has no seminorm on either piece, the step reads 1 ≤ 0 with any constant;
//! * ν = 1/2: the odd ramp in ln|x − 1/2| needs a constant that grows as its inner radius shrinks;
//! * ν > 1/2: the step is true with another constant; how much larger than γ_θ at least, an extremal function
//!   says.
//!
//! Repair: with m the mean of u over (0,1), ‖u‖₀² = ‖u − m‖₀² + m² ≤ (γ₁² + N²)|u|_ν², N the dual norm of
//! 1_E/|E| − 1, of order θ^{ν−1/2}, √ln(1/θ), 1 by Hölder and Sobolev for any set E.
//!
//! `cargo run --release --example remark_7_zone_location`

use example_frame::figures::{Axis, Chart, Series};
use example_frame::{Column, Finding, Format, Headline, Result, Table, within};
use experiments::location::Places;
use fractional_sobolev::{Estimate, Order, Tolerance};
use std::process::ExitCode;

example_frame::options! {
    /// Poincare constants of zones at several places, the printed step and its repair
    pub struct Options: Quick {
        /// Orders nu in (0, 1)
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
        pub nu: Vec<Order>,
        /// Length theta of the zone
        #[arg(long, default_value_t = 1e-3)]
        pub theta: f64,
        /// Places a, as fractions of 1 - theta
        #[arg(long, value_delimiter = ',', default_values = ["0", "1e-4", "1e-2", "0.1", "0.25", "0.5"], value_parser = within::<f64>("[0, 1]"))]
        pub at: Vec<f64>,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value_t = Tolerance::balanced())]
        pub tolerance: Tolerance,
    }
}

/// Compares places, then the printed step with its repair.
pub fn compute(options: &Options) -> Result<Vec<Places>> {
    let places = |&order| Ok(Places::new(order, options.theta, &options.at, options.tolerance)?);
    options.nu.iter().map(places).collect()
}

/// A constant larger than this is none.
const NO_CONSTANT: f64 = 1e12;

/// What decides: the end is the worst place, the repair holds, and what the printed step would need.
pub fn findings(options: &Options, places: &[Places]) -> Vec<Finding> {
    let all = || places.iter().flat_map(|places| &places.zones);
    let ratio = Estimate::largest(all().filter(|at| at.start > 0.0).map(|at| at.ratio));
    let repair = Estimate::largest(all().map(|at| at.share));
    let allowed = 1.0 + options.tolerance.relative();
    let step = Estimate::smallest(places.iter().map(|places| places.step));
    let mut findings = vec![
        Finding::claim(
            "end",
            "the end is the worst place in every case computed, inside at most {value} of it",
        )
        .estimate_or(ratio, "no zone inside")
        .at_most(allowed, "the zone at the end, to the tolerance")
        .otherwise("a zone inside has {value} times the constant of that at the end")
        .told(),
        Finding::claim("repair", "gamma stays below the bound without a cut, at most {value} of it")
            .estimate_or(repair, "no zone")
            .at_most(allowed, "(gamma_1^2 + N^2)^(1/2), to the tolerance")
            .otherwise("gamma is {value} times the bound without a cut"),
        Finding::remark("step", "with gamma of Lemma 5.2 itself the printed step is off by {value} at least")
            .estimate_or(step, "no order")
            .at_least(1.0, "the step with the constant gamma of the zone")
            .otherwise("with gamma of Lemma 5.2 itself the printed step holds for some odd function"),
    ];
    for Places { order, sign, ramps, .. } in places {
        let printed = |key: &str, words: &str| Finding::printed(format!("{key}.nu{order}"), words);
        let words = format!("nu = {order}: the printed step holds with some constant");
        findings.extend(sign.as_ref().map(|sides| {
            printed("sign", &words)
                .number(sides.right.value, sides.right.error)
                .at_least(sides.left.value / NO_CONSTANT, "||u|| over a constant of 1e12, u = sgn(x - 1/2)")
                .otherwise(format!(
                    "nu = {order}: the printed step reads 1 <= {{value}} for u = sgn(x - 1/2)"
                ))
        }));
        findings.extend(ramps.map(|exponent| {
            let fails = "the constant of the printed step grows like ln(1/eps)^{value} on odd ramps";
            printed("ramp", &words)
                .estimate(exponent)
                .at_most(0.0, "a constant for every inner radius eps")
                .otherwise(format!("nu = {order}: {fails}"))
        }));
    }
    findings
}

/// Computes the places, and says what the printed proof and its repair give.
pub fn run(options: &Options) -> Result<Headline> {
    let places = compute(options)?;
    let claim = "the constants of Lemma 5.2 are valid wherever the zone of length theta lies";
    let mut headline = Headline::new("Remark 7", claim, table(&places), findings(options, &places));
    let steps = places.iter().map(|places| places.step.value);
    headline.quote("remark.7.printed.step", steps.fold(f64::INFINITY, f64::min));
    headline.draw(&options.output, "remark_7_zone_location", || Ok(draw(&places, options.theta)))?;
    Ok(headline)
}

fn table(places: &[Places]) -> Table {
    let six = Format::Significant(6);
    let step =
        "||u|| / (gamma |I_1|^nu |u|) on (0,1/2) for an odd function; at most 1 if gamma were the constant";
    let columns = vec![
        Column::new("nu", "nu", Format::Plain, ""),
        Column::new("a", "a", Format::Significant(3), "start of the zone"),
        Column::new("gamma", "gamma", Format::Significant(9), "its constant"),
        Column::new("ratio", "/end", six, "over the constant of (0, theta), at most 1"),
        Column::new("repair", "repair", six, "(gamma_1^2 + N^2)^(1/2), at least gamma"),
        Column::new("step", "printed step", Format::Significant(4), step),
    ];
    Table::new(columns).with_rows(places.iter().flat_map(|Places { order, zones, step, .. }| {
        zones.iter().map(move |at| {
            let [gamma, ratio, repair] = [at.gamma, at.ratio, at.repair].map(|number| number.value);
            [order.value(), at.start, gamma, ratio, repair, step.value]
        })
    }))
}

fn draw(places: &[Places], theta: f64) -> Chart {
    let (x, y) = ("a + θ, where the zone (a, a + θ) ends (interval = 1)", "constant over that at the end");
    let chart = Chart::new("Where the zone lies", Axis::logarithmic(x), Axis::linear(y));
    places.iter().fold(chart, |chart, Places { order, zones, .. }| {
        let points = zones.iter().map(|at| (at.start + theta, at.ratio.value)).collect();
        chart.with(Series::line_and_points(format!("ν = {order}"), points))
    })
}

fn main() -> ExitCode {
    example_frame::main(run)
}
