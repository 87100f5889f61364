//! Section 3, "Globally": θ = h^(2τ−3), at τ = 2 θ = h², balances the bounds of the two cases.
//!
//! Let 3/2 < τ ≤ 2 and ν = τ − 3/2. On a segment of length h put
//!
//! ```text
//! |v|²_ν = ∬ (v(x) − v(y))² / |x − y|^(1+2ν) dx dy,        ‖v‖²_ν = ‖v‖₀² + |v|²_ν.
//! ```
//!
//! The paper bounds the integral ∫ σ_N I^h u_N over the segment in two cases (Figure 3.2), with a
//! zone of length θh:
//!
//! ```text
//! first case    F(h, θ) = C_q h θ^(1−1/q),             times ‖σ_N‖_ν ‖u_N'‖_ν           (3.9),
//!               q = 1/(2 − τ);  q = 2 at τ = 2                                          (3.10)
//! second case   S(h, θ) = C_I C_P h^(2τ−2) θ^(τ−2),    times |σ_N|_ν |u_N'|_ν          (3.14),
//!               at τ = 2 with ln(1/θ) in place of θ^(τ−2)                              (3.15)
//! ```
//!
//! F rises with θ and S falls. This file computes both with numbers for the constants, finds the θ
//! at which they are equal by bisection, and compares it with the printed θ. The constants, on the
//! interval (0, 1):
//!
//! - C_q is an upper bound in ‖v‖_(L^q) ≤ C_q ‖v‖_ν, from Fourier coefficients c_k of the even
//!   reflection of v: ‖v‖²_ν ≥ Σ w_k c_k², by Beckner's inequality ‖v‖²_(L^q) ≤ Σ m_k c_k², and so
//!
//! ```text
//! C_q² = max m_k/w_k over k ≥ 0,     m_0 = w_0 = 1,     m_k = Π (j − 1/q)/(j − 1 + 1/q), j = 1..k,
//! w_k = 3 − 2 (π/2)^(1+2ν) + π^(1+2ν) (R_k − R_0)/(sin(πν) Γ(1+2ν)),  R_k = Γ(k+½+ν)/Γ(k+½−ν).
//! ```
//!
//!   It is 1 for τ ≤ 7/4 and at τ = 2, and v = 1 attains it there.
//! - C_I is the best constant in ‖v − I v‖₀ ≤ C_I |v'|_ν, where I v is linear with the values of v
//!   at 0 and 1 (Lemma 6.1).
//! - C_P is the largest of γ_θ/θ^(τ−2), at τ = 2 of γ_θ/ln(1/θ), for θ = 2^−1, .. 2^−16, where γ_θ
//!   is the best constant in ‖v‖₀ ≤ γ_θ |v|_ν for mean zero on (0, θ) (Lemma 5.2).
//!
//! The powers make F = S at a constant times θ = h^(2τ−3), where both are of order h^(2τ²−5τ+4).
//!
//! No bound can be below the truth. If the segment is (0, 1), u_N = 0 on [a, 1] and σ_N = 0 on
//! [0, a], the supremum of ∫ σ_N I^h u_N over |σ_N|_ν |u_N'|_ν is a number W(a) (`by_definition`).
//! With κ = max W(a) over 0 < a < 1, on a segment of length h the supremum is κ h^(2τ−2).
//!
//! Refuted, for τ < 2, if S/F at the printed θ depends on h; if the θ where F = S has an exponent
//! of h other than 2τ − 3; or if the bound, at the printed θ or where F = S, has an exponent other
//! than 2τ² − 5τ + 4. An exponent is the slope of logarithms between the finest two h; as F and S
//! are formulas, it has no ± but rounding, and all these comparisons are to 1e-9. At τ = 2 it is
//! refuted if S/(F ln(1/h)) at the printed θ depends on h; the exponents, which ln(1/h) still
//! moves, are shown and decide nothing. Refuted too, for every τ, if κ h^(2τ−2) less the ± of κ is
//! above a bound where F = S; if W(θ) less its ± is above (1 + 1e-6) κ for a zone θ = 2^−1, ..
//! 2^−10, where 1e-6 is the tolerance of W; or if the κ of this file and that of the library differ
//! by 0.5 %. Undecided while a bound lies inside of an error bar.
//!
//! The paper's bound can be improved, so the statement is loose: u_N' has mean zero between its two
//! zeros in the first case, so that for θ ≤ 1/4, with γ = γ_(1/2),
//!
//! ```text
//! first case    F h^ν (1 + γ²)^(1/2), if that is less than F,     times ‖σ_N‖_ν |u_N'|_ν,
//! ```
//!
//! and the exponent where the two bounds are equal (`sharp`) rises by (τ − 3/2)(2 − τ), half of
//! what it is below the truth. This rise is tested to 1e-9 as well; if it failed, the bound could
//! not be called loose, but the paper would not be refuted.
//!
//! Another regularity:
//!
//! `cargo run --release --example theta_balance -- --tau 1.6`

use example_report::prelude::*;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Gram, Mesh, embedding_bound, gamma, interpolation_constant,
};
use nalgebra::DVector;
use signorini::cone::Cone;
use signorini::proof::{consistency_constant, one_gap_ratio};
use std::ops::Range;

example! { quick "Section 3, Globally",
    "θ = h^(2τ−3), at τ = 2 θ = h², balances the bounds of the two cases";
    /// regularity τ of the solution
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 1.95",
    /// segments of length 1/8, 1/16, .. 2^-finest
    finest: u32 = "12" in "[4, 30]",
}

/// W(a) from its definition. σ_N = 0 on [0, a], so only I^h u_N on [a, 1] counts, which is
/// u_N(0) (1 − x); and u_N(0) = −∫ u_N' over (0, a), since u_N = 0 on [a, 1]. The integral is
/// therefore a product of two linear functionals, up to its sign,
///
/// ```text
/// ∫ σ_N (1 − x) dx over (a, 1)     times     ∫ u_N' dx over (0, a),
/// ```
///
/// and W(a)² is b·A⁻¹b of the first times b·A⁻¹b of the second: for hat functions φᵢ that vanish
/// outside (a, 1), or (0, a), b holds ∫ φᵢ (1 − x), or ∫ φᵢ, and A their products in |·|_ν,
///
/// ```text
/// A_ij = ∬ (φᵢ(x) − φᵢ(y)) (φⱼ(x) − φⱼ(y)) / |x − y|^(1+2ν) dx dy over (0, 1)², in closed form.
/// ```
///
/// Elements of (0, a) and (a, 1) are halved towards both ends, 10 − log₂ a times.
fn by_definition(nu: Order, a: f64) -> Result<f64> {
    let mesh = Mesh::graded(&[0.0, a, 1.0], 10 + (-a.log2()) as usize, 0.5)?;
    let (x, n) = (DVector::from(mesh.nodes()), mesh.len()); // x[n/2] = a
    let (mass, gram) = (mass_matrix(&mesh), Gram::new(&mesh, nu, 1e-10)?.to_dense()?);
    let square = |hats: Range<usize>, weight: DVector<f64>| -> Result<f64> {
        let b = (&mass * weight).rows(hats.start, hats.len()).into_owned();
        let a = gram.view((hats.start, hats.start), (hats.len(), hats.len())).into_owned();
        let singular =
            || Error::option("tau", "the Gram matrix is not positive definite in double precision");
        Ok(b.dot(&a.cholesky().ok_or_else(singular)?.solve(&b)))
    };
    let ones = DVector::from_element(n + 1, 1.0);
    Ok((square(n / 2 + 1..n + 1, &ones - x)? * square(0..n / 2, ones)?).sqrt())
}

/// κ = max W(a), and the a where it is attained: the largest of W on 99 places, then three times on
/// 9 places between the neighbours of the best one.
fn largest_by_definition(nu: Order) -> Result<Largest> {
    let mut largest = Largest { a: 0.5, w: 0.0 };
    for round in 0..4 {
        let (step, count) = if round == 0 { (0.01, 49) } else { (0.01 * 0.2f64.powi(round), 4) };
        let middle = largest.a;
        for k in -count..=count {
            let a = middle + step * f64::from(k);
            let w = by_definition(nu, a)?;
            if w > largest.w {
                largest = Largest { a, w };
            }
        }
    }
    Ok(largest)
}

/// A place a and W(a) there.
struct Largest {
    a: f64,
    w: f64,
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let tau = options.tau;
    let (nu, q) = (Order::new(tau - 1.5)?, if tau < 2.0 { 1.0 / (2.0 - tau) } else { 2.0 });
    let hoelder = 1.0 - 1.0 / q;
    // γ_θ with its error added, a largest eigenvalue: functions with mean zero on (0, θ) whose
    // slopes are polynomials in ln r on elements that grow away from 0, θ and 1, r the distance to
    // these.
    let poincare = |&theta: &f64| -> Result<f64> {
        let found = gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-5)?.constant;
        Ok(found.value + found.error)
    };
    let law = |theta: f64| if tau < 2.0 { theta.powf(tau - 2.0) } else { -theta.ln() };
    let zones: Vec<f64> = (1..=16).map(|k| 0.5f64.powi(k)).collect();
    let gammas = zones.iter().map(poincare).collect::<Result<Vec<f64>>>()?;
    let c_p =
        zones.iter().zip(&gammas).fold(0.0, |c: f64, (&theta, gamma)| c.max(gamma / law(theta)));
    let half = gammas[0];
    // The formula of the header.
    let c_q = embedding_bound(nu, q)?.upper.map_or(f64::NAN, |upper| upper.value);
    // A largest eigenvalue too, its error added: v a series of Legendre polynomials.
    let c_i = interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, nu, 1e-8)?.constant;
    let c_i = c_i.value + c_i.error;
    // κ and its place by the library: W(a) to 1e-9, with the space of γ_θ in place of hat
    // functions.
    let found = consistency_constant(nu, 1e-9)?;
    let (kappa, worst) = (Measured::from(found.best.constant), 1.0 - found.contact);
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
        let best = kappa * h.powf(2.0 * tau - 2.0);
        out.row(cells! { h =>
        theta, bound: first(h, theta).max(second(theta)), crossing: at, at_crossing: second(at),
        sharp: second(at_sharp), best: best.value });
        let logarithm = if tau < 2.0 { 1.0 } else { -h.ln() };
        let quotient = second(theta) / (first(h, theta) * logarithm);
        let reference = *coarsest.get_or_insert(quotient);
        let compared = quotient / reference;
        let claim = out.check("printed θ: ratio of bounds/value at h = 1/8");
        claim.differ_by_at_most(compared, 1.0, 1e-9, "independent of h");
        let claim = out.check("supremum/bound at equal bounds");
        claim.whole_error_bars_at_most(best / second(at), 1.0, "upper bound");
        let claim = out.check("supremum/sharpened bound at equal bounds");
        claim.whole_error_bars_at_most(best / second(at_sharp), 1.0, "upper bound");
    }
    let [printed, cross, there, sharp] =
        ["bound", "crossing", "at_crossing", "sharp"].map(|column| out.exponent("h", column));
    if tau < 2.0 {
        let claimed = 2.0 * tau * tau - 5.0 * tau + 4.0;
        let claim = out.check("θ at equal bounds: exponent of h");
        claim.whole_error_bars_differ_by_at_most(cross, 2.0 * tau - 3.0, 1e-9, "2τ − 3, printed θ");
        let claim = out.check("exponent of h in the bound, printed θ");
        claim.whole_error_bars_differ_by_at_most(printed, claimed, 1e-9, "2τ² − 5τ + 4");
        let claim = out.check("exponent of h where both bounds are equal");
        claim.whole_error_bars_differ_by_at_most(there, claimed, 1e-9, "2τ² − 5τ + 4");
        let half_loss = (tau - 1.5) * (2.0 - tau);
        let claim = out.stronger("gain in exponent from the sharpened bound");
        claim.whole_error_bars_differ_by_at_most(
            sharp - printed,
            half_loss,
            1e-9,
            "(τ − 3/2)(2 − τ)",
        );
    } else {
        let claim = out.observe("θ at equal bounds: exponent of h");
        claim.whole_error_bars_differ_by_at_most(cross, 2.0, 0.5, "h², up to ln² h");
        let claim = out.observe("exponent of h in the bound, printed θ");
        claim.whole_error_bars_differ_by_at_most(printed, 2.0, 0.5, "h² ln(1/h)");
    }
    for &theta in &zones[..10] {
        let ratio = Measured::from(one_gap_ratio(Cone::Nodal, nu, theta, 1e-6)?); // W(θ)
        let claim = out.check("W(θ)/κ, θ = 2^(−1), .. 2^(−10)");
        claim.whole_error_bars_at_most(ratio / kappa, 1.0 + 1e-6, "κ = max W");
    }
    out.note("exponent.printed", printed);
    out.note("exponent.sharp", sharp);
    out.note("worst.gap", worst);
    let largest = largest_by_definition(nu)?;
    out.note("worst.gap.definition", largest.a);
    out.check("κ: by_definition/library").whole_error_bars_differ_by_at_most(
        kappa.recip() * largest.w,
        1.0,
        5e-3,
        "max of W(a), hat functions",
    );

    let h = 0.5f64.powi(options.finest as i32);
    let thetas: Vec<f64> = (2..=40).map(|k| 0.5f64.powf(0.25 * f64::from(k))).collect();
    let line = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        thetas.iter().map(|&theta| (theta, f(theta))).collect()
    };
    let best = kappa.value * h.powf(2.0 * tau - 2.0);
    let printed = h.powf(if tau < 2.0 { 2.0 * tau - 3.0 } else { 2.0 });
    let ratios =
        |theta: f64| one_gap_ratio(Cone::Nodal, nu, theta, 1e-3).map_or(f64::NAN, |w| w.value);
    let gaps = if out.draws() {
        line(&|theta| ratios(theta) * h.powf(2.0 * tau - 2.0))
    } else {
        Vec::new()
    };
    let axes = Axes::LogLog("θ", "∫ σ I^h u over both norms");
    out.plot("theta_balance", &format!("One segment, h = {h:.2e}, τ = {tau}"), axes)
        .line("first case (3.9)", line(&|theta| first(h, theta)))
        .line("second case (3.14)", line(&|theta| second(h, theta)))
        .line("truth, zone θ without pressure", gaps)
        .dashed_line("first case, sharpened", line(&|theta| sharpened(h, theta)))
        .dashed_line("printed θ", vec![(printed, 0.3 * best), (printed, first(h, 0.5))]);
    Ok(())
}
