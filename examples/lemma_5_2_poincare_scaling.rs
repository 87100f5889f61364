//! Lemma 5.2: the Poincaré constant γ_θ(ν) against the printed laws and the true ones.
//!
//! (5.1)-(5.3) bound γ_θ by C θ^{ν−1/2}, C ln(1/θ), C. As θ → 0 the first and the third are true orders;
//! at ν = 1/2 that is √(3/(2π²) ln(1/θ)), and as θ → 1 the printed bound tends to zero while γ does not.
//!
//! `cargo run --release --example lemma_5_2_poincare_scaling -- --nu 0.3,1/2 --theta 1e-300 --zone centre`

use example_frame::poincare::{curves_chart, figure_name, frames, scaling_table};
use example_frame::{Finding, Headline, Result, within};
use experiments::growth::{
    END_SLOPE, Scaling, ScalingPoint, growth, growth_limit, looseness_at_half, printed_exponent_near_one,
};
use experiments::zones::{Condition, Place};
use fractional_sobolev::{Estimate, Order, Tolerance};
use std::process::ExitCode;
use std::time::Instant;

example_frame::options! {
    /// The Poincare constant of a zone of length theta in three regimes of nu, beside printed and true law
    pub struct Options: Quick {
        /// Orders nu in (0, 1)
        #[arg(long, value_delimiter = ',', default_values = ["0.25", "0.5", "0.75"])]
        pub nu: Vec<Order>,
        /// Lengths theta of the zone
        #[arg(long, value_delimiter = ',', default_values = ["5e-1", "1e-1", "1e-2", "1e-3", "1e-4", "1e-5", "1e-6"], value_parser = within::<f64>("[1e-300, 1]"))]
        pub theta: Vec<f64>,
        /// Where the zone is: end, centre, or its start a
        #[arg(long, default_value_t = Place::End)]
        pub zone: Place,
        /// What holds on the zone: mean-zero or vanishing
        #[arg(long, default_value_t = Condition::MeanZero)]
        pub condition: Condition,
        /// Relative tolerance: fast, balanced, reference or a number
        #[arg(long, default_value_t = Tolerance::balanced())]
        pub tolerance: Tolerance,
    }
}

/// One order: zones, longest first, with the seconds each took.
pub struct Computed {
    /// The order ν.
    pub order: Order,
    /// Constants with bounds and laws.
    pub points: Vec<(ScalingPoint, f64)>,
    /// Exponent of θ, at ν = 1/2 slope of γ² against ln(1/θ), between the last two zones.
    pub growth: Option<Estimate>,
    /// ν = 1/2: the exponent of 1 − θ in γ / ln(1/θ) as θ → 1, and by which factor (5.2) is loose.
    pub half: Option<(Estimate, Estimate)>,
}

/// Constants with bounds and laws, for every order and zone.
pub fn compute(options: &Options) -> Result<Vec<Computed>> {
    let (mut thetas, tolerance) = (options.theta.clone(), options.tolerance);
    thetas.sort_by(|a, b| b.total_cmp(a));
    thetas.dedup();
    let mut orders = Vec::new();
    for &order in &options.nu {
        let scaling = Scaling::new(order, options.zone, options.condition, tolerance)?;
        let mut points = Vec::new();
        for &theta in &thetas {
            let start = Instant::now();
            points.push((scaling.point(theta)?, start.elapsed().as_secs_f64()));
        }
        let gammas: Vec<(f64, Estimate)> = points.iter().map(|(p, _)| (p.theta, p.found.gamma)).collect();
        let mut half = None;
        if let (0.0, Condition::MeanZero, Some(&(theta, last))) =
            (order.offset(), options.condition, gammas.last())
        {
            // Two digits decide here.
            let loose = looseness_at_half(theta, last, Tolerance::fast())?;
            half = printed_exponent_near_one(Tolerance::fast())?.map(|near_one| (near_one, loose));
        }
        orders.push(Computed { order, growth: growth(order, &gammas)?, half, points });
    }
    Ok(orders)
}

/// How near to their limits growth and constant over its law have to be.
const NEAR: f64 = 0.01;

/// What decides: bounds with explicit constants, an upper bound on another road, (5.2) as θ → 1 and as θ → 0.
pub fn findings(options: &Options, orders: &[Computed]) -> Vec<Finding> {
    // Both sides are known to the tolerance only, and near ν = 1 they agree to many digits.
    let allowed = 1.0 + 4.0 * options.tolerance.relative();
    let sides =
        Estimate::largest(orders.iter().flat_map(|order| order.points.iter().map(|(point, _)| point.side)));
    let mut findings = vec![
        Finding::claim("sides", "no constant passes its upper bound without an eigenproblem, {value} of it")
            .estimate_or(sides, "no zone")
            .at_most(allowed, "the bound from gamma_1 and a dual norm, to the tolerance")
            .otherwise("a constant is {value} times an upper bound"),
    ];
    for Computed { order: nu, points, growth, half } in orders {
        let key = |word: &str| format!("{word}.nu{nu}");
        let power = ["gamma^2 gains {value} per ln(1/theta)", "gamma grows like theta^{value}"];
        let unit = power[usize::from(nu.offset() != 0.0)];
        // No explicit bound is known for functions that vanish on the zone when ν ≤ 1/2.
        if let Some(share) = Estimate::largest(points.iter().filter_map(|(point, _)| point.share)) {
            findings.push(
                Finding::claim(key("bound"), format!("nu = {nu}: gamma stays below {{value}} of its bound"))
                    .estimate(share)
                    .at_most(
                        allowed,
                        "(gamma_1 + B) theta^(nu-1/2), gamma_1 + (A ln(1/theta))^(1/2), gamma_0",
                    )
                    .otherwise(format!("nu = {nu}: gamma is {{value}} times its explicit bound")),
            );
        }
        findings.push(
            Finding::remark(key("growth"), format!("nu = {nu}: {unit}"))
                .estimate_or(*growth, "fewer than two zones")
                .within(NEAR, growth_limit(*nu, options.zone), "the law as theta -> 0 at fixed nu")
                .otherwise(format!("nu = {nu}: {unit}, off its limit {{bound}}"))
                .undecided(format!("nu = {nu}: {unit}, too few zones to tell it from its limit {{bound}}"))
                .told(),
        );
        if let Some((ScalingPoint { theta, over_law: Some(ratio), .. }, _)) = points.last() {
            let words = format!("nu = {nu}: gamma is {{value}} times its limit law at theta = {theta:e}");
            let finding = Finding::remark(key("law"), words.clone()).estimate(*ratio);
            findings.push(finding.within(NEAR, 1.0, "the law as theta -> 0 at fixed nu").otherwise(words));
        }
        if let Some((near_one, loose)) = half {
            let fails = "(5.2) fails as theta -> 1, where gamma / ln(1/theta) grows like (1 - theta)^{value}";
            findings.push(
                Finding::printed(key("near.one"), "(5.2) holds as theta -> 1")
                    .estimate(*near_one)
                    .at_least(0.0, "a constant C for all theta < 1")
                    .otherwise(fails),
            );
            let words = format!("nu = {nu}: (5.2) with C from theta = 1/2 is loose by a factor {{value}}");
            let finding = Finding::sharpness(key("loose"), words).estimate(*loose);
            findings.push(finding.at_least(1.0, "equality at the shortest zone"));
        }
    }
    findings
}

/// Computes the table and compares both laws.
pub fn run(options: &Options) -> Result<Headline> {
    let orders = compute(options)?;
    let claim = "gamma_theta(nu) <= C theta^(nu-1/2), C ln(1/theta), C for nu < 1/2, = 1/2, > 1/2";
    let points: Vec<(ScalingPoint, f64)> = orders.iter().flat_map(|order| order.points.clone()).collect();
    let mut headline = Headline::new("Lemma 5.2", claim, scaling_table(&points), findings(options, &orders));
    for (point, _) in &points {
        let key = format!("lemma.5.2.gamma.nu{}.theta{:e}", point.order, point.theta);
        headline.quote(key, point.found.gamma.value);
    }
    headline.quote("lemma.5.2.slope.end", END_SLOPE);
    headline.draw(&options.output, &figure_name(&options.nu), || Ok(curves_chart(&points)))?;
    if options.nu.len() > 1 {
        frames(&mut headline, &options.output, &options.nu, &options.theta)?;
    }
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
