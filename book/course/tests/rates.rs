//! Programs of sheets 7 and 8, and behind them. `cargo course skeleton rates` writes this file with holes.

use course::{check, near};
use signorini::cone::Cone;
use signorini::problems::TransitionPowers;
use signorini::strip::{Reference, StripKind, StripProblem};

/// The exponents at regularity τ: the older one, that of Theorem 3.1, the optimal one.
fn exponents(tau: f64) -> [f64; 3] {
    // solution: the three curves of Figure 3.1
    [tau / 2.0 - 0.25, tau * tau - 2.5 * tau + 2.0, tau - 1.0]
    // end
}

/// The τ in (3/2, 2) at which Theorem 3.1 loses most, by comparing 1001 values.
fn largest_loss() -> f64 {
    // solution: the difference of the last two exponents
    let loss = |tau: f64| exponents(tau)[2] - exponents(tau)[1];
    let all = (0..=1000).map(|k| 1.5 + f64::from(k) / 2000.0);
    all.max_by(|&a, &b| loss(a).total_cmp(&loss(b))).unwrap_or(1.5)
    // end
}

/// The θ at which h θ^(τ − 1) and h^(2τ − 2) θ^(τ − 2) are equal, by bisection of ln θ in (−60, 0).
fn balance(tau: f64, h: f64) -> f64 {
    // solution: the quotient of the two grows with θ
    let (mut low, mut high) = (-60.0, 0.0);
    for _ in 0..100 {
        let middle: f64 = 0.5 * (low + high);
        let theta = middle.exp();
        let quotient =
            h * theta.powf(tau - 1.0) / (h.powf(2.0 * tau - 2.0) * theta.powf(tau - 2.0));
        if quotient < 1.0 { low = middle } else { high = middle }
    }
    low.exp()
    // end
}

/// Errors on the strip with n = 8, 16, .. , 64 segments for one transition of regularity τ: root mean squares over the
/// places 5/12 and 11/24, which exchange their positions in a segment if n is doubled.
fn errors(tau: f64, cone: Cone) -> signorini::Result<Vec<f64>> {
    // solution: StripProblem::new, then solve(n, cone) and error; see the page of Theorem 3.1
    let mut squares = vec![0.0; 4];
    for place in [5.0 / 12.0, 11.0 / 24.0] {
        let data = TransitionPowers::of_regularity(tau).data(place, 1 << 12)?;
        let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 8)?;
        for (k, square) in squares.iter_mut().enumerate() {
            let n = 8 << k;
            let u = problem.solve(n, cone)?;
            *square += 0.5 * problem.error(&u)?.value.powi(2);
        }
    }
    Ok(squares.into_iter().map(f64::sqrt).collect())
    // end
}

/// The place of a kink −(x − a)₊ beside a constant pressure in (0, 1) that makes the nodal term ½ a² (1 − a) largest,
/// by golden sections.
fn worst_kink() -> f64 {
    // solution: keep the part of the interval with the larger value
    let term = |a: f64| 0.5 * a * a * (1.0 - a);
    let (mut low, mut high, part) = (0.0, 1.0, 0.5 * (5_f64.sqrt() - 1.0));
    while high - low > 1e-9 {
        let (left, right) = (high - part * (high - low), low + part * (high - low));
        if term(left) < term(right) { low = left } else { high = right }
    }
    0.5 * (low + high)
    // end
}

/// c(ν) = ν/(2 (4^ν − 1)) without cancellation for small ν; c(0) = 1/(4 ln 2).
fn segment_constant(nu: f64) -> f64 {
    // solution: 4^ν − 1 by exp_m1; the limit at ν = 0
    if nu == 0.0 { 0.25 / 2_f64.ln() } else { 0.5 * nu / (nu * 4_f64.ln()).exp_m1() }
    // end
}

/// The number C with |u − u^h|₁ ≤ C h |u|₂ for the scalar problem, the nodal cone and right isosceles triangles:
/// C² = A² + 2 c π coth π with c = ¼ and A = 1/ω, where ω is the first positive root of ω + tan ω = 0.
fn explicit_constant() -> f64 {
    // solution: bisection of ω cos ω + sin ω in (π/2, π)
    let pi = std::f64::consts::PI;
    let (mut low, mut high) = (0.5 * pi, pi);
    for _ in 0..60 {
        let middle: f64 = 0.5 * (low + high);
        if middle * middle.cos() + middle.sin() > 0.0 { low = middle } else { high = middle }
    }
    (low.powi(-2) + 0.5 * pi / pi.tanh()).sqrt()
    // end
}

#[test]
fn exponents_meet_at_the_ends() {
    for (tau, expected) in [(1.5, [0.5, 0.5, 0.5]), (2.0, [0.75, 1.0, 1.0])] {
        let found = exponents(tau);
        check(
            "exponents",
            &format!("τ = {tau}"),
            found,
            &format!("{expected:?}"),
            found == expected,
        );
    }
}

#[test]
fn largest_loss_in_the_middle() {
    let tau = largest_loss();
    near("largest_loss", "τ", tau, 1.75, 1e-9);
    near(
        "exponents",
        "optimal less printed at that τ",
        exponents(tau)[2] - exponents(tau)[1],
        1.0 / 16.0,
        1e-12,
    );
}

#[test]
fn balance_is_the_choice_of_the_paper() {
    for (tau, h) in [(1.6, 0.1), (1.75, 0.01), (1.9, 0.001)] {
        let expected = f64::powf(h, 2.0 * tau - 3.0);
        near("balance", &format!("τ = {tau}, h = {h}"), balance(tau, h), expected, 1e-9 * expected);
    }
}

#[test]
fn errors_fall_with_the_optimal_order() {
    for cone in [Cone::Nodal, Cone::Midpoint] {
        let found = errors(1.75, cone).unwrap();
        let order = (found[0] / found[3]).log2() / 3.0;
        near("errors", &format!("order for the {cone} cone, errors {found:?}"), order, 0.75, 0.1);
    }
}

#[test]
fn worst_kink_is_at_two_thirds() {
    near("worst_kink", "largest a² (1 − a)/2", worst_kink(), 2.0 / 3.0, 1e-6);
}

#[test]
fn segment_constant_is_accurate_near_zero() {
    near("segment_constant", "ν = 1/2", segment_constant(0.5), 0.25, 1e-15);
    let limit = segment_constant(0.0);
    near("segment_constant", "ν = 1e-12 over ν = 0", segment_constant(1e-12) / limit, 1.0, 1e-11);
    near("segment_constant", "ν = 1e-300 over ν = 0", segment_constant(1e-300) / limit, 1.0, 1e-15);
}

#[test]
fn explicit_constant_has_the_interpolation_constant_of_kikuchi_and_liu() {
    let known = (0.4929124517549f64.powi(2)
        + 0.5 * std::f64::consts::PI / std::f64::consts::PI.tanh())
    .sqrt();
    near(
        "explicit_constant",
        "the scalar problem, right isosceles triangles",
        explicit_constant(),
        known,
        1e-9 * known,
    );
}
