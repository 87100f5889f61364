//! Speed for accuracy: what a digit costs, for every numerical function of the toolkit.
//!
//! Each function takes a relative tolerance ε and returns a value v with a stated error e. Beside
//! it stands the value v* found another way: a closed form, ball arithmetic of another program
//! (printed digits), or, for the product with a Gram matrix, its dense entries in closed form (its
//! stated error is ε, and it counts no work). Then
//!
//! ```text
//! error = |v − v*| / |v*| ≤ ε,     |v − v*| ≤ e,     and a looser tolerance does no more work.
//! ```
//!
//! Refuted if one error passes its tolerance, or one passes what was stated, v* being exact to
//! 1e-14, or if the count of evaluations, factorizations and iterations grows when ε does.
//!
//! `cargo run --release --example speed_for_accuracy -- --case γ`

use example_report::prelude::*;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Function, Gram, Mesh, Work, closed_forms, gamma,
    interpolation_constant, projection_constant,
};
use std::time::Instant;

example! { seconds "Speed for accuracy",
    "every tolerance is met, no error passes what is stated, and fewer digits cost no more work";
    /// only cases whose name contains this text
    case: String = "",
    /// number of timed runs per case, of which the fastest is reported
    repeat: usize = "3" in "[1, 100]",
}

/// A name, the value found another way, and the function of the tolerance.
type Case = (&'static str, f64, Box<dyn Fn(Tolerance) -> fractional_sobolev::Result<Estimate>>);

/// |x^a|_ν from values of x^a alone, beside the Beta functions of its closed form.
fn power(name: &'static str, a: f64, nu: f64) -> Result<Case> {
    let u = Function::from_fn(&[0.0, 1.0], move |x: f64| x.powf(a))?;
    let exact = closed_forms::power_seminorm_squared(a, nu)?.value.sqrt();
    Ok((name, exact, Box::new(move |tolerance| u.seminorm(nu, tolerance))))
}

/// γ = sup ‖u‖₀/|u|_ν of mean zero on (0, θ), beside ball arithmetic.
fn zone(name: &'static str, nu: f64, theta: f64, exact: f64) -> Case {
    let found =
        move |tolerance| Ok(gamma(nu, Constraint::mean_zero_on(0.0..theta), tolerance)?.constant);
    (name, exact, Box::new(found))
}

/// sup ‖u − I u‖₀ / |u'|_ν and sup ‖(u − I u)'‖₀ / |u'|_ν on (0, 1) (Lemma 6.1), beside ball
/// arithmetic.
fn interpolation(name: &'static str, nu: f64, norm: ErrorNorm, exact: f64) -> Case {
    let found = move |tolerance| {
        interpolation_constant(Domain::Interval(1.0), norm, nu, tolerance)
            .map(|found| found.constant)
    };
    (name, exact, Box::new(found))
}

fn cases() -> Result<Vec<Case>> {
    let hat = Function::linears(&Mesh::uniform(2, 1.0)?, &[0.0, 1.0, 0.0])?;
    let hat_exact = closed_forms::hat_seminorm_squared(0.0, 0.5, 0.5, 0.0, 0.5)?.value.sqrt();
    // A product with the Gram matrix on elements from 1 to 1e-30, beside the dense matrix.
    let graded = Mesh::geometric(1999, 1e-30f64.powf(1.0 / 1999.0), 1.0)?;
    let x: Vec<f64> = (0..=2000).map(|i| f64::from((i * 7919) % 1000) / 1000.0).collect();
    let dense =
        Gram::new(&graded, 0.5, 1e-14)?.to_dense()? * nalgebra::DVector::from_column_slice(&x);
    let product = move |tolerance: Tolerance| {
        let fast = Gram::new(&graded, 0.5, tolerance)?.apply(&x)?;
        let apart = fast.iter().zip(&dense).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        Estimate::new(1.0 + apart / dense.amax(), tolerance.relative(), Work::default())
    };
    let projection = |tolerance| {
        projection_constant(Domain::Interval(1.0), ErrorNorm::Dual, 0.5, tolerance)
            .map(|found| found.constant)
    };
    // γ₁(1/2); its square is the constant of (4.7) at order 1/2
    let whole: f64 = 0.291_564_029_207_657_16;
    Ok(vec![
        power("|x^0.6|, ν 1/4", 0.6, 0.25)?,
        power("|x^0.001|, ν 1/2", 0.001, 0.5)?,
        power("|x^0.51|, ν 0.99", 0.51, 0.99)?,
        ("|hat|, ν 1/2", hat_exact, Box::new(move |tolerance| hat.seminorm(0.5, tolerance))),
        ("Gram product, 2000 elements", 1.0, Box::new(product)),
        interpolation("C of Lemma 6.1 in L², ν 1/2", 0.5, ErrorNorm::L2, 0.092_742_524_652_174_63),
        interpolation(
            "C of Lemma 6.1, slope, ν 0.99",
            0.99,
            ErrorNorm::Derivative,
            0.032_024_593_023_715_79,
        ),
        ("C of (4.7), order 1/2", whole * whole, Box::new(projection)),
        zone("γ, ν 1/4, θ 1e-2", 0.25, 1e-2, 1.656_712_117_564_16),
        zone("γ, ν 0.49, θ 1e-300", 0.49, 1e-300, 2_758.865_095_337_738_5),
        zone("γ, ν 1/2, θ 1e-40", 0.5, 1e-40, 3.738_285_316_256_439),
        zone("γ, ν 0.99, θ 1e-4", 0.99, 1e-4, 0.064_321_434_320_780_88),
    ])
}

/// What the values found another way may be off by, relatively.
const EXACT: f64 = 1e-14;

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let mut curves = Vec::new();
    for (name, exact, compute) in cases()?.into_iter().filter(|case| case.0.contains(&options.case))
    {
        let mut measured = Vec::new();
        let mut work: Option<u64> = None;
        for asked in [1e-3, 1e-7, 1e-11] {
            let mut seconds = f64::INFINITY;
            let mut found = None;
            for _ in 0..options.repeat {
                let start = Instant::now();
                found = Some(compute(Tolerance::new(asked)?)?);
                seconds = seconds.min(start.elapsed().as_secs_f64());
            }
            let Some(found) = found else { continue };
            let distance = Measured::new((found.value - exact).abs(), EXACT * exact);
            let error = distance / exact;
            measured.push((1e3 * seconds, error.value));
            let claim = out.check("relative error/tolerance");
            claim.at_most(error / asked, 1.0, "requested tolerance");
            // A stated error below that of v* is no promise that v* can test.
            let stated = Measured::from(found.error.max(2.0 * EXACT * exact));
            out.check("true error/stated error").at_most(distance / stated, 1.0, "error estimate");
            if let Some(looser) = work {
                let share = looser as f64 / found.work.total().max(1) as f64;
                let claim = out.check("ratio of work, looser to tighter tolerance");
                claim.at_most(share, 1.0, "monotone in the tolerance");
            }
            work = Some(found.work.total());
        }
        let [(ms_3, error_3), (ms_7, error_7), (ms_11, error_11)] = measured[..] else { continue };
        out.row(cells! { function: name => ms_3, error_3, ms_7, error_7, ms_11, error_11 });
        // An error of zero is drawn where binary64 ends.
        let shown = measured.iter().map(|&(ms, error)| (ms, error.max(f64::EPSILON)));
        curves.push((name, shown.collect::<Vec<_>>()));
    }
    out.column("ms_3", "ms, 1e-3", "milliseconds, tolerance asked");
    out.column("error_3", "error", "relative, against the value found another way");
    out.column("ms_7", "ms, 1e-7", "");
    out.column("error_7", "error", "");
    out.column("ms_11", "ms, 1e-11", "");
    out.column("error_11", "error", "");
    let axes = Axes::LogLog("milliseconds", "true relative error");
    let plot = out.plot("speed_for_accuracy_seconds", "What a digit costs", axes);
    for (name, points) in curves {
        plot.line(name, points);
    }
    Ok(())
}
