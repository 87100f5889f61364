//! Speed for accuracy: what a digit costs, for the numerical functions of the toolkit.
//!
//! Each function takes a relative tolerance ε and returns a value v with a stated error e. This
//! file calls twelve of them with ε = 1e-3, 1e-7 and 1e-11, and one of them with every power of
//! ten. Beside v it has a value v* that was found another way. It prints v for ε = 1e-11, and for
//! every ε
//!
//! ```text
//! error = |v − v*| / |v*|        and the milliseconds of the call.
//! ```
//!
//! What is called, with |u|²_ν = ∬ (u(x) − u(y))² / |x − y|^(1+2ν) dx dy over (0, 1)², and how v is
//! found there:
//!
//! - |x^a|_ν, from values of x^a alone: the double integral in t = ln(R/r) and the same of y, where
//!   r is the distance to the nearer end and R = 1/2, by Gauss rules on cells that shrink towards
//!   x = y; more points until two rules agree.
//! - |hat|_ν, hat(1/2) = 1, hat(0) = hat(1) = 0, from its nodes: closed forms for pairs of pieces.
//! - A x for the matrix A of |·|²_(1/2) on hat functions of 2000 elements from 1 to 1e-30: entries
//!   in closed form near the diagonal, and blocks far from it by interpolation of the kernel.
//! - γ = sup ‖u‖₀/|u|_ν for mean zero on (0, θ) (Lemma 5.2): the largest eigenvalue γ² of M u = λ A
//!   u, M of ‖·‖₀², A of |·|²_ν, on functions whose slopes are polynomials in ln r, r the distance
//!   to the nearest of 0, θ and 1, on elements that grow away from these.
//! - sup ‖u − I u‖₀/|u'|_ν and sup ‖(u − I u)'‖₀/|u'|_ν, I u linear with u(0) and u(1) (Lemma 6.1):
//!   largest eigenvalues again, u' a series of Legendre polynomials, which is lengthened.
//! - sup of ‖v − v̄‖ in the dual norm of |·|_(1/2), over |v|_(1/2) (4.7), v̄ the mean of v: that is
//!   γ₁², where γ₁ = sup ‖v‖₀/|v|_(1/2) over the v with mean zero on (0, 1), by Legendre series.
//!
//! And v*: for |x^a|_ν the closed form in Beta functions of
//!
//! ```text
//! |x^a|²_ν = 2/(2a + 1 − 2ν) ∫ (1 − s^a)² (1 − s)^(−1−2ν) ds over (0, 1),
//! ```
//!
//! |hat|²_(1/2) = 8 (1 − ln 2) by integration; for the constants the digits printed by
//! another program in ball arithmetic; for A x the dense matrix (there |v − v*| is the largest
//! difference of two entries over the largest entry, e is ε, and no work is counted).
//!
//! Refuted if an error is above its ε; if |v − v*| less 1e-14 |v*|, to which v* is exact, is above
//! the larger one of the stated e and 2e-14 |v*|; or if a looser tolerance does more work, counted
//! in evaluations, factorizations and iterations. The milliseconds are medians; they are shown and
//! decide nothing. Undecided while a bound lies inside of an error bar.
//!
//! `cargo run --release --example speed_for_accuracy -- --case γ`

use example_report::prelude::*;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Function, Gram, Mesh, Work, closed_forms, gamma,
    interpolation_constant, projection_constant,
};
use nalgebra::DVector;
use std::f64::consts::LN_2;
use std::time::Instant;

example! { seconds "Speed for accuracy",
    "every tolerance is met, no error passes what is stated, and fewer digits cost no more work";
    /// only cases whose name contains this text
    case: String = "",
    /// number of timed runs per case, of which the median is reported
    repeat: usize = "3" in "[1, 100]",
}

/// A function of the tolerance, and its value found another way.
struct Case {
    name: &'static str,
    exact: f64,
    compute: Box<dyn Fn(Tolerance) -> fractional_sobolev::Result<Estimate>>,
}

/// |x^a|_ν from values of x^a alone, and by the Beta functions of its closed form.
fn power(name: &'static str, a: f64, nu: f64) -> Result<Case> {
    let u = Function::from_fn(&[0.0, 1.0], move |x: f64| x.powf(a))?;
    let exact = closed_forms::power_seminorm_squared(a, nu)?.value.sqrt();
    Ok(Case { name, exact, compute: Box::new(move |tolerance| u.seminorm(nu, tolerance)) })
}

/// γ = sup ‖u‖₀/|u|_ν for mean zero on (0, θ), and by ball arithmetic.
fn zone(name: &'static str, nu: f64, theta: f64, exact: f64) -> Case {
    let compute =
        move |tolerance| Ok(gamma(nu, Constraint::mean_zero_on(0.0..theta), tolerance)?.constant);
    Case { name, exact, compute: Box::new(compute) }
}

/// sup ‖u − I u‖₀ / |u'|_ν or sup ‖(u − I u)'‖₀ / |u'|_ν on (0, 1) (Lemma 6.1), and by ball
/// arithmetic.
fn interpolation(name: &'static str, nu: f64, norm: ErrorNorm, exact: f64) -> Case {
    let compute = move |tolerance| {
        let found = interpolation_constant(Domain::Interval(1.0), norm, nu, tolerance)?;
        Ok(found.constant)
    };
    Case { name, exact, compute: Box::new(compute) }
}

fn cases() -> Result<Vec<Case>> {
    let hat = Function::linears(&Mesh::uniform(2, 1.0)?, &[0.0, 1.0, 0.0])?;
    // A x, and by the dense matrix.
    let graded = Mesh::geometric(1999, 1e-30f64.powf(1.0 / 1999.0), 1.0)?;
    let x: Vec<f64> = (0..=2000).map(|i| f64::from((i * 7919) % 1000) / 1000.0).collect();
    let dense = Gram::new(&graded, 0.5, 1e-14)?.to_dense()? * DVector::from_column_slice(&x);
    let product = move |tolerance: Tolerance| {
        let fast = Gram::new(&graded, 0.5, tolerance)?.apply(&x)?;
        let apart = fast.iter().zip(&dense).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        Estimate::new(1.0 + apart / dense.amax(), tolerance.relative(), Work::default())
    };
    let projection = |tolerance| {
        projection_constant(Domain::Interval(1.0), ErrorNorm::Dual, 0.5, tolerance)
            .map(|found| found.constant)
    };
    // γ₁ at ν = 1/2, by ball arithmetic; the constant of (4.7) is its square.
    let whole: f64 = 0.291_564_029_207_657_16;
    Ok(vec![
        power("|x^0.6|, ν 1/4", 0.6, 0.25)?,
        power("|x^0.001|, ν 1/2", 0.001, 0.5)?,
        power("|x^0.51|, ν 0.99", 0.51, 0.99)?,
        Case {
            name: "|hat|, ν 1/2",
            exact: (8.0 * (1.0 - LN_2)).sqrt(),
            compute: Box::new(move |tolerance| hat.seminorm(0.5, tolerance)),
        },
        Case { name: "Gram product, 2000 elements", exact: 1.0, compute: Box::new(product) },
        interpolation("C of Lemma 6.1 in L², ν 1/2", 0.5, ErrorNorm::L2, 0.092_742_524_652_174_63),
        interpolation(
            "C of Lemma 6.1, slope, ν 0.99",
            0.99,
            ErrorNorm::Derivative,
            0.032_024_593_023_715_79,
        ),
        Case { name: "C of (4.7), order 1/2", exact: whole * whole, compute: Box::new(projection) },
        zone("γ, ν 1/4, θ 1e-2", 0.25, 1e-2, 1.656_712_117_564_16),
        zone("γ, ν 0.49, θ 1e-300", 0.49, 1e-300, 2_758.865_095_337_738_5),
        zone("γ, ν 1/2, θ 1e-40", 0.5, 1e-40, 3.738_285_316_256_439),
        zone("γ, ν 0.99, θ 1e-4", 0.99, 1e-4, 0.064_321_434_320_780_88),
    ])
}

/// What the values found another way may be off by, relatively.
const EXACT: f64 = 1e-14;

/// The case that is computed with every tolerance.
const SHOWN: &str = "γ, ν 1/2, θ 1e-40";

/// One call: the value, its true error, and the median time.
struct Call {
    found: Estimate,
    distance: Measured,
    error: Measured,
    ms: f64,
}

/// Calls the function `repeat` times; the value and its error are the same each time.
fn call(case: &Case, asked: f64, repeat: usize) -> Result<Call> {
    let mut times = Vec::new();
    let mut found = (case.compute)(Tolerance::new(asked)?)?; // first use, not timed
    for _ in 0..repeat {
        let start = Instant::now();
        found = (case.compute)(Tolerance::new(asked)?)?;
        times.push(1e3 * start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let distance = Measured::new((found.value - case.exact).abs(), EXACT * case.exact);
    Ok(Call { found, distance, error: distance / case.exact, ms: times[repeat / 2] })
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let mut curves = Vec::new();
    for case in cases()?.into_iter().filter(|case| case.name.contains(&options.case)) {
        let mut calls: Vec<Call> = Vec::new();
        for asked in [1e-3, 1e-7, 1e-11] {
            let new = call(&case, asked, options.repeat)?;
            let claim = out.check("relative error/tolerance");
            claim.whole_error_bars_at_most(new.error / asked, 1.0, "requested tolerance");
            // v* is exact to 1e-14: a smaller stated error cannot be tested by it.
            let stated = new.found.error.max(2.0 * EXACT * case.exact);
            let claim = out.check("true error/stated error");
            claim.whole_error_bars_at_most(new.distance / stated, 1.0, "error estimate");
            if let Some(looser) = calls.last() {
                let work = |call: &Call| call.found.work.total() as f64;
                let share = work(looser) / work(&new).max(1.0);
                let claim = out.check("ratio of work, looser to tighter tolerance");
                claim.at_most(share, 1.0, "monotone in the tolerance");
            }
            calls.push(new);
        }
        let [loose, middle, tight] = &calls[..] else { continue };
        out.row(cells! { function: case.name => v: tight.found.value,
        ms_3: loose.ms, error_3: loose.error.value,
        ms_7: middle.ms, error_7: middle.error.value,
        ms_11: tight.ms, error_11: tight.error.value });

        // An error of zero is drawn where binary64 ends.
        let shown = |call: &Call| (call.ms, call.error.value.max(f64::EPSILON));
        curves.push((case.name, calls.iter().map(shown).collect::<Vec<_>>()));

        if case.name == SHOWN {
            let mut lines = format!("{SHOWN}, every tolerance:");
            for power in 1..=12 {
                let asked = 0.1f64.powi(power);
                let found = call(&case, asked, options.repeat)?;
                let (error, ms) = (found.error.value, found.ms);
                lines += &format!("\nasked {asked:.0e}   got {error:.1e}   {ms:.1} ms");
            }
            out.remark(lines);
        }
    }
    out.column("v", "v", "for the tolerance 1e-11; of the Gram product 1 + |v − v*|/|v*|");
    out.column("ms_3", "ms, 1e-3", "median of the milliseconds, for the tolerance in the title");
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
