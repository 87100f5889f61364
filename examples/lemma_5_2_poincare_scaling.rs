//! Lemma 5.2: the price of a short zone.
//!
//! For u in H^ν(0, 1), 0 < ν < 1, with mean zero on the zone (0, θ) let γ be the best constant in ‖u‖₀ ≤ γ |u|_ν, where
//! ‖u‖₀ is the norm of L²(0, 1) and |u|²_ν = ∬ (u(x) − u(y))² / |x − y|^(1+2ν) dx dy over (0, 1)². The paper bounds it by
//!
//! ```text
//! C θ^(ν−1/2)   (ν < 1/2)  (5.1),     C ln(1/θ)   (ν = 1/2)  (5.2),     C   (ν > 1/2)  (5.3).
//! ```
//!
//! (5.1) and (5.3) have the true order as θ → 0. At ν = 1/2 the truth is γ² ≈ 3/(2π²) ln(1/θ): a square root less.
//! As θ → 1 (5.2) is false: ln(1/θ) → 0, and γ does not.
//!
//! Refuted if γ passes its bound with explicit constants (γ₁ is γ for mean zero on (0, 1); B and γ₀ are the limits of
//! γ θ^(1/2−ν) and of γ as θ → 0), if it passes the bound that needs no eigenvalue of the zone or differs from
//! `by_definition` by more than 0.5 %, or if its growth between the two shortest zones is off the exponent (for ν = 1/2:
//! off the slope of γ²) by more than 0.01, or than the first correction to the law where that is larger.
//!
//! `cargo run --release --example lemma_5_2_poincare_scaling -- --nu 0.3,1/2 --theta 1e-10,1e-300`

use example_report::figures::{Axis, Chart, PALETTE, Series};
use example_report::prelude::*;
use fractional_sobolev::{Constraint, Gram, Mesh, gamma, law};
use nalgebra::{DMatrix, DVector};
use std::cmp::Ordering::{Equal, Greater, Less};
use std::f64::consts::PI;

example! { quick "Lemma 5.2", "mean zero on (0, θ):  ‖u‖₀ ≤ γ |u|_ν,  γ ≤ C θ^(ν−1/2), C ln(1/θ), C  for ν <, =, > 1/2";
    /// orders ν of the seminorm
    nu: Vec<Order> = "0.25,1/2,0.75" in "(0, 1)" slider "0.02 to 0.98",
    /// lengths θ of the zone
    theta: Vec<f64> = "0.5,1e-1,1e-2,1e-3,1e-4,1e-5,1e-6" in "[1e-300, 1)" slider "1e-6 to 0.9 by factors",
}

/// γ from its definition: √λ for the largest λ of M u = λ A u, where u runs through the continuous piecewise linear
/// functions with mean zero on (0, θ), M holds ∫ φᵢ φⱼ and A the form of |·|²_ν for the hat functions φᵢ, in closed
/// form. (0, θ) and (θ, 1) have elements halved towards both ends; what such functions lack makes γ 0.1 to 0.4 % too small.
fn by_definition(nu: Order, theta: f64) -> Result<f64> {
    let layers = 10 + (-theta.log2()) as usize; // on either half of (0, θ) and of (θ, 1): 4 (layers + 1) elements
    let mesh = Mesh::graded(&[0.0, theta, 1.0], layers, 0.5)?;
    let (h, n) = (mesh.lengths(), mesh.len());
    let mut mass = DMatrix::<f64>::zeros(n + 1, n + 1);
    let mut mean = DVector::<f64>::zeros(n + 1); // ∫ φᵢ over (0, θ), the first half of the elements
    for k in 0..n {
        let element = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]) * (h[k] / 6.0);
        let mut block = mass.view_mut((k, k), (2, 2));
        block += element;
        if k < n / 2 {
            mean[k] += h[k] / 2.0;
            mean[k + 1] += h[k] / 2.0;
        }
    }
    let pivot = mean.imax();
    let mut free = DMatrix::identity(n + 1, n + 1); // columns φᵢ − (meanᵢ / mean_pivot) φ_pivot: a basis of mean zero
    free.set_row(pivot, &(-mean.transpose() / mean[pivot]));
    let free = free.remove_column(pivot);
    let form = free.transpose() * Gram::new(&mesh, nu, 1e-10)?.to_dense()? * &free;
    Ok(largest_eigenvalue(&(free.transpose() * mass * &free), &form)?.sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let mut thetas = options.theta.clone();
    thetas.sort_by(|a, b| b.total_cmp(a));
    out.column("definition", "hats", "γ by `by_definition`");
    out.column("over_printed", "γ/printed", "C of (5.1), (5.2), (5.3) at this θ");
    out.column("over_law", "γ/law", "over the law as θ → 0");
    for &nu in &options.nu {
        let side = nu.offset().total_cmp(&0.0); // the sign of ν − 1/2, exactly
        // θ → 0 at fixed ν: B θ^(ν−1/2) with B an integral of Gamma functions (Mellin transform of the half line);
        // γ² = 3/(2π²) ln(1/θ) + c + .., c from a dual norm; γ₀, the constant for u(0) = 0.
        let limit = law(nu, 0.0, 1e-8)?;
        for &theta in &thetas {
            // Largest eigenvalue again, for polynomials on such a mesh of a degree that grows with the element; the
            // error is the change to a space of another shape.
            let found = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-10)?;
            // ‖u‖₀² = ‖u − m‖₀² + m² for the mean m of u on (0, 1): γ² ≤ γ₁² + N², N the dual norm of u ↦ m − mean
            // on (0, θ), one linear solve; `upper` is that bound, sharpened by a 2 × 2 matrix.
            let bounds = found.bounds()?;
            let gamma = Measured::from(found.constant);
            let definition = if theta < 1e-8 { None } else { Some(by_definition(nu, theta)?) };
            let printed = match side {
                Less => theta.powf(nu.offset()),
                Equal => -theta.ln(),
                Greater => 1.0,
            };
            let law = limit.at(theta).ok().map(Measured::from);
            out.row(cells! { nu, theta => gamma, definition, upper: bounds.upper,
            over_printed: (gamma / printed).value, over_law: law.map(|law| (gamma / law).value) });
            let (whole, factor) = (Measured::from(bounds.whole), limit.factor().ok().map(Measured::from));
            let (words, explicit) = match side {
                Less => ("((γ₁ + B) θ^(ν−1/2))", factor.map(|b| (whole + b) * printed)),
                Equal => ("(γ₁ + √(3/(2π²) ln 1/θ))", Some(whole + (1.5 * printed).sqrt() / PI)),
                Greater => ("γ₀", factor),
            };
            if let Some(explicit) = explicit {
                out.check(format!("ν = {nu}: γ/{words}")).at_most(gamma / explicit, 1.0, "explicit C");
            }
            out.check("no γ passes its upper bound").at_most(
                gamma / bounds.upper,
                1.0 + 1e-9,
                "γ₁, dual norm",
            );
            if let Some(value) = definition {
                let quotient = gamma.recip() * value;
                out.check("γ by its definition, over γ").near(quotient, 1.0, 5e-3, "hat functions");
            }
        }
        if side == Equal {
            let [a, b] = [0.999, 0.9999].map(|theta| gamma_at(nu, theta));
            let growth = (b? / a? * (0.999f64.ln() / 0.9999f64.ln())).ln() / 0.1f64.ln();
            out.as_printed("(5.2), exponent of 1−θ in γ/ln(1/θ)").at_least(growth, 0.0, "for θ ≤ 1/2");
        }
        let [.., longer, _] = thetas.as_slice() else { continue };
        // Growth between the two shortest zones; the first correction to the law has the order of this power.
        let correction = longer.powf((2.0 * nu.value()).min(2.0 * nu.offset().abs())).max(0.01);
        let claim = format!("ν = {nu}: exponent of θ");
        let exponent = out.exponent("theta", "gamma");
        match side {
            Less => out.check(claim).near(exponent, nu.offset(), correction, "ν − 1/2"),
            Greater => out.check(claim).near(exponent, 0.0, correction, "(5.3)"),
            Equal => {
                let slope = out.slope("theta", "gamma", |theta| -theta.ln(), |gamma| gamma * gamma);
                let end = 1.5 / PI.powi(2);
                out.note("slope.end", end);
                out.not_sharp("ν = 1/2: slope of γ² over ln(1/θ)").near(slope, end, 0.01, "3/(2π²), not ∞");
            }
        }
    }
    out.plot(
        "lemma_5_2_gamma",
        "Poincaré constants of Lemma 5.2",
        Axes::LogLog("θ, length of the zone", "γ"),
    )
    .curve_by("nu", "theta", "gamma");
    for &theta in if out.draws() { thetas.as_slice() } else { &[] } {
        out.chart(format!("lemma_5_2_extremal_{theta:e}"), extremal_chart(&options.nu, theta)?);
    }
    Ok(())
}

fn gamma_at(nu: Order, theta: f64) -> Result<Measured> {
    Ok(gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-10)?.constant.into())
}

/// The functions for which ‖u‖₀ / |u|_ν is largest, ‖u‖₀ = 1, with the zone shaded.
fn extremal_chart(orders: &[Order], theta: f64) -> Result<Chart> {
    const NEAREST: f64 = 1e-8;
    let x = Axis::logarithmic("x, distance from the end where the zone is").range(NEAREST, 1.0);
    let title = format!("Extremal functions of Lemma 5.2, zone of length θ = {theta:e}");
    let mut chart = Chart::new(title, x, Axis::linear("u").range(-0.5, 1.5));
    chart = chart.with_bands("zone (0, θ)", vec![(NEAREST, theta)], PALETTE[6]);
    for &nu in orders {
        let found = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-3)?;
        let u = found.extremal();
        let mut points = vec![(NEAREST, u.value(&[NEAREST]))];
        points.extend(u.profile(6).into_iter().filter(|&(x, _)| x > NEAREST));
        chart = chart.with(Series::line(format!("ν = {nu}, γ = {:.4}", found.constant.value), points));
    }
    Ok(chart)
}
