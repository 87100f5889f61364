//! Lemma 5.2: the price of a short zone.
//! For u in H^ν(0, 1), 0 < ν < 1, with mean zero on the zone (0, θ) let γ be the best constant in ‖u‖₀ ≤ γ |u|_ν, with
//! |u|²_ν = ∬ (u(x) − u(y))² / |x − y|^(1+2ν) dx dy over (0, 1)². With some C that depends on ν the paper bounds γ by
//! (5.1) C θ^(ν−1/2) for ν < 1/2, (5.2) C ln(1/θ) for ν = 1/2, (5.3) C for ν > 1/2.
//!
//! Law as θ → 0 (Mellin transform): γ ~ B θ^(ν−1/2), γ² ~ 3/(2π²) ln(1/θ) + const at ν = 1/2, γ ~ γ₀, some B, γ₀. As θ → 1 γ tends to
//! the γ₁ of mean zero on (0, 1), (5.2) to 0. Refuted if between the last two zones the growth is off the law by 0.01 (or its
//! next term), if γ passes √(γ₁² + N²), N the largest mean over (0, θ) of u with mean zero and |u|_ν = 1, or if `by_definition`
//! gives another γ by 0.5 %.
// `at_most(x, b)`: x + its ± ≤ b; `near(x, b, t)`: |x − b| + its ± ≤ t; the worst call counts; `not_sharp`, `as_printed`: status.
use example_report::prelude::*;
use fractional_sobolev::{Constraint, Gram, Mesh, gamma};
use std::f64::consts::PI;

example! { quick "Lemma 5.2", "mean zero on (0, θ):  ‖u‖₀ ≤ γ |u|_ν,  γ ≤ C θ^(ν−1/2), C ln(1/θ), C  for ν <, =, > 1/2";
    /// orders ν of the seminorm
    nu: Vec<Order> = "0.25,1/2,0.75" in "(0, 1)" slider "0.02 to 0.98",
    /// lengths θ of the zone, longest first
    theta: Vec<f64> = "0.5,1e-1,1e-2,1e-3,1e-4,1e-5,1e-6" in "[1e-10, 1)" slider "1e-6 to 0.9 by factors",
}

/// γ = √λ for the largest λ with M u = λ A u among piecewise linear u with mean zero on (0, θ), M and A the matrices of
/// ‖·‖₀² and |·|²_ν (closed form). Elements halve towards 0, both sides of θ, and 1; such u give 0.003 to 0.2 % too little.
fn by_definition(nu: Order, theta: f64) -> Result<f64> {
    let mesh = Mesh::graded(&[0.0, theta, 1.0], 10 + (-theta.log2()) as usize, 0.5)?;
    let free = mean_zero_basis(&mesh, 0.0..theta); // columns span { u : ∫ u = 0 over (0, θ) }
    let [m, a] = [mass_matrix(&mesh), Gram::new(&mesh, nu, 1e-10)?.to_dense()?];
    Ok(largest_eigenvalue(&(free.transpose() * m * &free), &(free.transpose() * a * &free))?.sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &nu in &options.nu {
        let (is_half, power) = (nu.offset() == 0.0, nu.offset().min(0.0));
        for &theta in &options.theta {
            // The same eigenvalue, polynomials of higher degree on larger elements; error: change under refinement.
            let found = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-10)?;
            let (gamma, definition) = (Measured::from(found.constant), by_definition(nu, theta)?);
            let over_printed = (gamma / if is_half { -theta.ln() } else { theta.powf(power) }).value;
            out.row(cells! { nu, theta => gamma, definition, over_printed });
            out.check("γ: by_definition/library").near(gamma.recip() * definition, 1.0, 5e-3, "P1 elements");
            // ‖u‖₀² = ‖u − m‖₀² + m², m the mean of u on (0, 1), |m| ≤ N |u|_ν: the best N by one linear solve.
            let bounds = found.bounds()?;
            let square = Measured::from(bounds.whole).squared() + Measured::from(bounds.dual_norm).squared();
            out.check("γ/√(γ₁² + N²)").at_most(gamma / square.sqrt(), 1.0 + 1e-9, "explicit bound");
            let (name, curve) = (format!("lemma_5_2_extremal_{theta:e}"), found.extremal().profile(6));
            out.plot(&name, "Worst functions", Axes::LogLinear("x", "u")).line(&format!("ν = {nu}"), curve);
        }
        let [.., longer, _] = options.theta[..] else { continue };
        if is_half {
            let slope = out.slope("theta", "gamma", |theta| -theta.ln(), |gamma| gamma * gamma);
            out.not_sharp("slope of γ² against ln(1/θ)").against(0.0).near(
                slope,
                1.5 / PI.powi(2),
                0.01,
                "3/(2π²)",
            );
            let gamma_1 = gamma(nu, Constraint::mean_zero(), 1e-10)?.constant;
            out.as_printed("(5.2): limit γ₁ of γ as θ → 1").at_most(gamma_1, 0.0, "limit of C ln(1/θ)");
        } else {
            let next = longer.powf(2.0 * nu.value().min(nu.offset().abs())); // relative size of the law's next term
            let exponent = out.exponent("theta", "gamma");
            // Undecided where the exponent of the other law, 0 for ν < 1/2 and −|ν − 1/2| for ν > 1/2, would pass too.
            let other = -nu.offset().abs() - power;
            let check = out.check(format!("ν = {nu}: exponent of θ")).against(other);
            check.near(exponent, power, next.max(0.01), "Lemma 5.2");
        }
    }
    out.plot("lemma_5_2_gamma", "Best constants", Axes::LogLog("θ", "γ")).curve_by("nu", "theta", "gamma");
    Ok(())
}
