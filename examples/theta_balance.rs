//! Section 3, "Globally": θ = h^(2τ−3), at τ = 2 θ = h², balances the bounds of the two cases.
//!
//! On a segment of length h let ν = τ − 3/2, |·|_ν the seminorm of H^ν and ‖·‖_ν its norm. The proof bounds ∫ σ_N I^h u_N by
//!
//! ```text
//! first case    C_q h θ^(1−1/q) ‖σ_N‖_ν ‖u_N'‖_ν,    q = 1/(2 − τ), at τ = 2 q = 2                    (3.9), (3.10)
//! second case   C_I h^(2τ−2) γ_θ |σ_N|_ν |u_N'|_ν,   γ_θ ≤ C_P θ^(τ−2), at τ = 2 C_P ln(1/θ)          (3.14), (3.15)
//! ```
//!
//! C_q: H^ν(0,1) in L^q; C_I: Lemma 6.1; γ_θ, C_P: Lemma 5.2. One rises, the other falls with θ. Expected: the θ at which they
//! are equal is a constant times h^(2τ−3), and both are of order h^(2τ²−5τ+4) there. Refuted if the quotient of both bounds at
//! the printed θ depends on h (at τ = 2, apart from ln(1/h)), if an exponent differs, or if a bound at the crossing is below the
//! true supremum κ h^(2τ−2) of the integral over |σ_N|_ν |u_N'|_ν.
//!
//! The truth is better, and so is another bound. `sharp`: u_N' has mean zero between its two zeros, so that for θ ≤ 1/4
//! the first case has h^(1+ν) C_q (1 + γ²)^(1/2) |u_N'|_ν, γ = γ_(1/2), and half of the loss is regained.
//!
//! `cargo run --release --example theta_balance -- --tau 1.6`

// `at_most(x, b)` holds if x + its ± ≤ b, `near(x, b, t)` if |x − b| + its ± ≤ t; otherwise it fails, or is
// undecided within ±. Of several calls the worst counts. Where `stronger` holds, the statement is loose. `observe`
// decides nothing.
use example_report::prelude::*;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Gram, Mesh, embedding_bound, gamma, interpolation_constant,
};
use nalgebra::{DMatrix, DVector};
use signorini::cone::Cone;
use signorini::proof::{consistency_constant, one_gap_ratio};
use std::ops::RangeInclusive;

example! { quick "Section 3, Globally", "θ = h^(2τ−3), at τ = 2 θ = h², balances the bounds of the two cases";
    /// regularity τ of the solution
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 1.95",
    /// segments of length 1/8, 1/16, .. 2^-finest
    finest: u32 = "12" in "[4, 30]",
}

/// W(a), the supremum of ∫ σ_N I^h u_N / (|σ_N|_ν |u_N'|_ν) on (0, 1) where u_N = 0 on [a, 1] and σ_N = 0 on [0, a]: the
/// integral is ∫ σ_N (1 − x) times u_N(0) = −∫ u_N', so W² is b·A⁻¹b of the one functional times that of the other, for
/// hat functions on (a, 1) and on (0, a); A holds their products in |·|_ν, in closed form. Elements halved towards 0, a, 1.
fn by_definition(nu: Order, a: f64) -> Result<f64> {
    let mesh = Mesh::graded(&[0.0, a, 1.0], 10 + (-a.log2()) as usize, 0.5)?;
    let (x, n) = (mesh.nodes(), mesh.len());
    let gram = Gram::new(&mesh, nu, 1e-10)?.to_dense()?;
    let square = |hats: RangeInclusive<usize>, weight: &dyn Fn(f64) -> f64| -> Result<f64> {
        let (first, size) = (*hats.start(), hats.clone().count());
        let mut b = DVector::<f64>::zeros(size);
        for k in 0..n {
            let (left, right, sixth) = (weight(x[k]), weight(x[k + 1]), (x[k + 1] - x[k]) / 6.0);
            for (node, value) in [(k, 2.0 * left + right), (k + 1, left + 2.0 * right)] {
                if hats.contains(&node) {
                    b[node - first] += sixth * value
                }
            }
        }
        let a = DMatrix::from_fn(size, size, |i, j| gram[(first + i, first + j)]);
        let solved =
            a.cholesky().ok_or_else(|| Error::option("tau", "a Gram matrix lost its sign"))?.solve(&b);
        Ok(b.dot(&solved))
    };
    Ok((square(n / 2 + 1..=n, &|x| 1.0 - x)? * square(0..=n / 2 - 1, &|_| 1.0)?).sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let tau = options.tau;
    let (nu, q) = (Order::new(tau - 1.5)?, if tau < 2.0 { 1.0 / (2.0 - tau) } else { 2.0 });
    let hoelder = 1.0 - 1.0 / q;
    // γ_θ for mean zero on (0, θ) as in Lemma 5.2, its error added; C_P is its largest quotient over θ = 1/2, 1/4, .. 2^-16.
    let poincare = |theta: f64| -> Result<f64> {
        let found = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-5)?.constant;
        Ok(found.value + found.error)
    };
    let law = |theta: f64| if tau < 2.0 { theta.powf(tau - 2.0) } else { -theta.ln() };
    let zones: Vec<f64> = (1..=16).map(|k| 0.5f64.powi(k)).collect();
    let gammas = zones.iter().map(|&theta| poincare(theta)).collect::<Result<Vec<f64>>>()?;
    let c_p = zones.iter().zip(&gammas).fold(0.0, |c: f64, (&theta, gamma)| c.max(gamma / law(theta)));
    let half = gammas[0];
    let c_q = embedding_bound(nu, q)?; // an upper bound of the best constant, by the Hardy-Littlewood-Sobolev inequality
    let c_i = interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, nu, 1e-8)?.constant.value;
    // κ, the largest W(a): both functionals are moments of one-sided functions, found to 1e-9 by polynomials.
    let kappa = consistency_constant(nu, 1e-9)?;
    let (truth, worst) = (Measured::from(kappa.value), 1.0 - kappa.contact);

    let first = |h: f64, theta: f64| c_q * h * theta.powf(hoelder);
    let sharpened = |h: f64, theta: f64| {
        let factor = if theta <= 0.25 { half.hypot(1.0) * h.powf(nu.value()) } else { 1.0 };
        first(h, theta) * factor.min(1.0)
    };
    let second = |h: f64, theta: f64| c_i * h.powf(2.0 * tau - 2.0) * c_p * law(theta);
    // Where a rising and a falling bound are equal: ln θ is halved in.
    let crossing = |rises: &dyn Fn(f64) -> f64, falls: &dyn Fn(f64) -> f64| {
        let (mut low, mut high) = (1e-30f64.ln(), 0.5f64.ln());
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if rises(middle.exp()) > falls(middle.exp()) { high = middle } else { low = middle }
        }
        high.exp()
    };
    out.column("theta", "θ printed", "");
    out.column("bound", "bound", "the larger one at the printed θ");
    out.column("crossing", "θ crossing", "where both bounds are equal");
    out.column("at_crossing", "bound there", "");
    out.column("sharp", "sharp", "sharpened bounds where they are equal");
    out.column("best", "truth", "κ h^(2τ−2)");
    let mut coarsest = None;
    for n in (3..=options.finest).map(|level| 1usize << level) {
        let h = 1.0 / n as f64;
        let theta = h.powf(if tau < 2.0 { 2.0 * tau - 3.0 } else { 2.0 });
        let second = |theta: f64| second(h, theta);
        let at = crossing(&|theta| first(h, theta), &second);
        let at_sharp = crossing(&|theta| sharpened(h, theta), &second);
        let best = truth * h.powf(2.0 * tau - 2.0);
        out.row(cells! { h => theta, bound: first(h, theta).max(second(theta)), crossing: at, at_crossing: second(at),
            sharp: second(at_sharp), best: best.value });
        let logarithm = if tau < 2.0 { 1.0 } else { -h.ln() };
        let quotient = second(theta) / (first(h, theta) * logarithm);
        let reference = *coarsest.get_or_insert(quotient);
        let compared = quotient / reference;
        out.check("second over first bound, printed θ").near(compared, 1.0, 1e-9, "that at h = 1/8");
        out.check("truth over bound, at the crossing").at_most(best / second(at), 1.0, "a bound is no less");
        out.check("truth over bound, sharp").at_most(best / second(at_sharp), 1.0, "a bound is no less");
    }
    let [printed, cross, there, sharp] =
        ["bound", "crossing", "at_crossing", "sharp"].map(|column| out.exponent("h", column));
    if tau < 2.0 {
        let claimed = 2.0 * tau * tau - 5.0 * tau + 4.0;
        out.check("exponent of θ at the crossing").near(cross, 2.0 * tau - 3.0, 1e-9, "2τ − 3, printed θ");
        out.check("exponent of the bound, printed θ").near(printed, claimed, 1e-9, "2τ² − 5τ + 4");
        out.check("exponent of the bound, crossing").near(there, claimed, 1e-9, "2τ² − 5τ + 4");
        let half_loss = (tau - 1.5) * (2.0 - tau);
        out.stronger("exponent gained, sharp").near(sharp - printed, half_loss, 1e-9, "(τ − 3/2)(2 − τ)");
    } else {
        out.observe("exponent of θ at the crossing").near(cross, 2.0, 0.5, "h², up to ln² h");
        out.observe("exponent of the bound, printed θ").near(printed, 2.0, 0.5, "h² ln(1/h)");
    }
    for &theta in &zones[..10] {
        let ratio = Measured::from(one_gap_ratio(Cone::Nodal, nu, theta, 1e-6)?); // W(θ), as κ
        out.check("W(θ)/κ where γ_θ grows").at_most(ratio / truth, 1.0 + 1e-6, "κ is the largest");
    }
    out.note("exponent.printed", printed);
    out.note("exponent.sharp", sharp);
    out.note("worst.gap", worst);
    let compared = truth.recip() * by_definition(nu, worst)?;
    out.check("W by its definition over κ").near(compared, 1.0, 5e-3, "two linear solves");

    let h = 0.5f64.powi(options.finest as i32);
    let thetas: Vec<f64> = (2..=40).map(|k| 0.5f64.powf(0.25 * f64::from(k))).collect();
    let line = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        thetas.iter().map(|&theta| (theta, f(theta))).collect()
    };
    let best = kappa.value.value * h.powf(2.0 * tau - 2.0);
    let printed = h.powf(if tau < 2.0 { 2.0 * tau - 3.0 } else { 2.0 });
    let ratios = |theta: f64| one_gap_ratio(Cone::Nodal, nu, theta, 1e-3).map_or(f64::NAN, |w| w.value);
    let gaps = if out.draws() { line(&|theta| ratios(theta) * h.powf(2.0 * tau - 2.0)) } else { Vec::new() };
    let axes = Axes::LogLog("θ", "∫ σ I^h u over both norms");
    out.plot("theta_balance", &format!("One segment, h = {h:.2e}, τ = {tau}"), axes)
        .line("first case (3.9)", line(&|theta| first(h, theta)))
        .line("second case (3.14)", line(&|theta| second(h, theta)))
        .line("truth, zone θ without pressure", gaps)
        .dashed_line("first case, sharp", line(&|theta| sharpened(h, theta)))
        .dashed_line("printed θ", vec![(printed, 0.3 * best), (printed, first(h, 0.5))]);
    Ok(())
}
