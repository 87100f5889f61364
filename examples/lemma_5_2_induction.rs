//! The induction (5.5)-(5.9) in the proof of Lemma 5.2, every step beside its bound.
//!
//! γ(θ) is the best constant in ‖u‖₀ ≤ γ |u|_ν for u with mean zero on (0, θ), as in Lemma 5.2; 0 <
//! ν < 1. The proof stretches (0, 1) by 1/θ to I = (0, 1/θ), so that a zone of length θ² becomes
//! one of length θ: ũ on (0, 1), u(x) = ũ(θx) on I. With |u|²_ν = ∬ (u(x) − u(y))²/|x − y|^(1+2ν)
//! and c the mean of u over (0, 1) it uses
//!
//! ```text
//! ‖u‖₀ on I = θ^(−1/2) ‖ũ‖₀ on (0, 1),   |u|_ν on I = θ^(ν−1/2) |ũ|_ν on (0, 1)                    (5.5)
//! ‖u‖₀ on I ≤ θ^(−1/2) |c| + θ^(−ν) γ(θ) |u|_ν on I                                              (5.6)
//! |c| ≤ ‖u‖₀ on (0, 1) ≤ γ(θ) |u|_ν on (0, 1) ≤ γ(θ) |u|_ν on I                                  (5.7)
//! γ(θ²) ≤ γ(θ) (1 + θ^(ν−1/2))                                                                   (5.8)
//! γ(t^(2ⁿ)) ≤ γ(t) ∏ (1 + t^(2^i (ν−1/2))) over i < n, t the first zone                          (5.9)
//! ```
//!
//! Here t = 1/2 is squared five times; (5.6) and the middle of (5.7) are evaluated for ũ the
//! extremal function of the zone θ²: one function a step. The first ≤ of (5.7) is Cauchy and
//! Schwarz, the last (0, 1) ⊂ I: no number decides them. The last lines of the proof bound the
//! product by C θ^(ν−1/2), 2 ln θ/ln t, C with C an exponential of a series.
//!
//! Refuted if left over right exceeds 1 by more than its ± in any of these lines, or if a quotient
//! of (5.5) is off 1 by 1e-6. Not sharp if at ν = 1/2 the last step gives away √2 to 0.02: γ grows
//! like (ln(1/θ))^(1/2) (page `lemma_5_2_exact_law`), by √2 in a step, where the product doubles; ±
//! is the change since the step before. So (5.2) has ln(1/θ) and not its root.
//!
//! `cargo run --release --example lemma_5_2_induction -- --nu 0.5 --steps 7`

// ± of sums, products and quotients: those of the parts, to first order, added.
use example_report::prelude::*;
use fractional_sobolev::{Constraint, Extremal, Function, gamma};
use std::cmp::Ordering::{Equal, Greater, Less};
use std::f64::consts::SQRT_2;

example! { quick "(5.5)-(5.9)",
    "mean zero on (0, θ²):  γ(θ²) ≤ γ(θ) (1 + θ^(ν−1/2)), and the product of these factors";
    /// orders ν of the seminorm
    nu: Vec<Order> = "0.25,1/2,0.75" in "(0, 1)" slider "0.02 to 0.98",
    /// length t of the first zone
    theta: f64 = "0.5" in "(0, 1)",
    /// number of times the length is squared
    steps: u32 = "5" in "[1, 9]",
}

/// γ and the function that attains it: γ² is the largest eigenvalue λ of M u = λ A u, M and A the
/// matrices of ‖·‖₀² and |·|²_ν on functions with mean zero on the zone whose slopes are
/// polynomials in ln r (degree up to 11), r the distance to the nearest of 0, θ and 1, on elements
/// that grow geometrically away from there. Hat functions, eight elements to a halving of the
/// distance, give up to 0.2 % less. ±: the change to a space of fewer elements and lower degrees.
fn solved(nu: Order, theta: f64) -> Result<(Measured, Extremal)> {
    let found = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8)?;
    Ok((found.constant.into(), found.extremal()))
}

/// Left over right side of (5.7), in the middle and at the end, and of (5.6), for the extremal
/// function of the zone θ². It is interpolated by quadratics, six to an element; their seminorms
/// are closed forms, their norms Gauss rules. (5.5) gives the norms on I. What the mean over the
/// zone misses of zero is part of the error of the Poincaré step.
fn on_stretched_interval(
    nu: Order,
    theta: f64,
    gamma: Measured,
    u: &Extremal,
) -> Result<[Measured; 3]> {
    let all = u.interpolate(2, 6, &[theta * theta, theta])?;
    let nodes = all.mesh()?.nodes();
    let before = |end: f64| nodes.iter().filter(|&&x| x <= end * (1.0 + 1e-12)).count() - 1;
    let (zone, unit) = (all.restrict(0..before(theta * theta))?, all.restrict(0..before(theta))?);
    let norm = |u: &Function<'_>| -> Result<Measured> {
        Ok(Measured::from(u.norm(0.0, 1e-12)?) / theta.sqrt())
    };
    let seminorm = |u: &Function<'_>| -> Result<Measured> {
        Ok(Measured::from(u.seminorm(nu, 1e-5)?) * theta.powf(nu.offset())) // ν − 1/2
    };
    let (c, missed) = (Measured::from(unit.mean(1e-12)?).abs(), zone.mean(1e-12)?.value.abs());
    let poincare = norm(&unit)? / (gamma * seminorm(&unit)?);
    let poincare = Measured::new(
        poincare.value,
        poincare.error + missed / norm(&unit)?.value * poincare.value,
    );
    let right = c / theta.sqrt() + gamma * seminorm(&all)? * theta.powf(-nu.value());
    Ok([poincare, seminorm(&unit)? / seminorm(&all)?, norm(&all)? / right])
}

/// What the last lines of the proof make of the product, for the first zone t and θ ≤ t.
fn last_lines(nu: Order, t: f64, theta: f64) -> f64 {
    // Σ a^(2^i)
    let series = |a: f64| std::iter::successors(Some(a), |a| Some(a * a)).take(64).sum::<f64>();
    match nu.offset().total_cmp(&0.0) {
        Less => theta.powf(nu.offset()) * series(t.powf(-0.5 * nu.offset())).exp(),
        Equal => 2.0 * theta.ln() / t.ln(),
        Greater => series(t.powf(nu.offset())).exp(),
    }
}

/// (5.5) by quadrature: norms of sin x on (0, 1) and of sin θx on (0, 1/θ), the larger deviation of
/// a quotient from 1.
fn scaling(nu: Order, theta: f64) -> Result<Measured> {
    let [unit, long] = [1.0, theta]
        .map(|scale| Function::from_fn(&[0.0, 1.0 / scale], move |x| (scale * x).sin()));
    let (unit, long) = (unit?, long?);
    let norms = Measured::from(long.norm(0.0, 1e-8)?) * theta.sqrt() / unit.norm(0.0, 1e-8)?;
    let seminorms = Measured::from(long.seminorm(nu, 1e-8)?) * theta.powf(-nu.offset())
        / unit.seminorm(nu, 1e-8)?;
    Ok(largest([norms, seminorms].map(|quotient| (quotient - 1.0).abs())).into())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("theta", "θ²", "the zone after the step");
    out.column("step_58", "(5.8)", "γ(θ²)/γ(θ) over 1 + θ^(ν−1/2)");
    out.column("poincare_57", "(5.7)", "‖u‖₀ over γ(θ) |u|_ν on (0, 1)");
    out.column("kept", "kept", "|u|_ν on (0, 1) over that on I");
    out.column("stretched_56", "(5.6)", "left over right");
    out.column("product_59", "(5.9)", "γ over γ(t) and the product");
    out.column("last_lines", "end", "γ over γ(t) and its bound in the last lines");
    for &nu in &options.nu {
        let claim = out.check("(5.5): max |ratio of norms − 1|");
        claim.at_most(scaling(nu, options.theta)?, 1e-6, "u(x) = ũ(θx)");
        let mut theta = options.theta;
        let first = solved(nu, theta)?.0;
        let (mut before, mut product, mut given) = (first, 1.0, Vec::new());
        for step in 1..=options.steps {
            let (gamma, u) = solved(nu, theta * theta)?;
            let bound = 1.0 + theta.powf(nu.offset());
            let step_58 = gamma / before / bound;
            let [poincare_57, kept, stretched_56] = on_stretched_interval(nu, theta, before, &u)?;
            product *= bound;
            theta *= theta;
            let product_59 = gamma / first / product;
            let last_lines = gamma / first / last_lines(nu, options.theta, theta);
            out.row(cells! { nu, step => theta, gamma: gamma.value, step_58: step_58.value,
            poincare_57: poincare_57.value, kept: kept.value, stretched_56: stretched_56.value,
            product_59: product_59.value, last_lines: last_lines.value });
            out.check("(5.6): left/right side").at_most(stretched_56, 1.0, "inequality (5.6)");
            out.check("(5.7): ‖u‖₀/(γ(θ) |u|_ν)").at_most(poincare_57, 1.0, "second inequality");
            out.check("(5.8): left/right side").at_most(step_58, 1.0, "inequality (5.8)");
            out.check("(5.9): left/right side").at_most(product_59, 1.0, "inequality (5.9)");
            let claim = out.check("γ/final bound of the proof");
            claim.at_most(last_lines, 1.0, "bound of the product");
            given.push(step_58.recip());
            before = gamma;
        }
        if let [.., a, b] = given.as_slice() {
            out.note(format!("given.nu{nu}"), *b);
            if nu.offset() == 0.0 {
                let last = Measured::new(b.value, b.error + (b.value - a.value).abs());
                let claim = out.not_sharp("ν = 1/2: 2 γ(θ)/γ(θ²), last step");
                claim.near(last, SQRT_2, 0.02, "γ² ~ ln(1/θ)");
            }
        }
    }
    out.proof("(5.7): first and last inequality", "lemma_5_2_induction");
    let axes = Axes::LogLog("θ, length of the zone (interval = 1)", "constant over its bound");
    out.plot(
        "lemma_5_2_induction",
        "γ over the bound (5.9), as the zone is squared again and again",
        axes,
    )
    .curve_by("nu", "theta", "product_59");
    Ok(())
}
