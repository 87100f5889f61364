//! Programs of sheet 1 and of the contact problem by hand. `cargo course skeleton before` writes this file with holes.

use course::{check, near};

/// The squared seminorm of order `nu` of `v` on (0, 1) by the midpoint rule on `n` by `n` cells, without the
/// cells on the diagonal.
fn seminorm_squared(v: impl Fn(f64) -> f64, nu: f64, n: usize) -> f64 {
    // solution: two loops over cells, skip i = k
    let h = 1.0 / n as f64;
    let mid = |i: usize| (i as f64 + 0.5) * h;
    let mut sum = 0.0;
    for i in 0..n {
        for k in (0..n).filter(|&k| k != i) {
            let (x, y) = (mid(i), mid(k));
            sum += h * h * (v(x) - v(y)).powi(2) / (x - y).abs().powf(1.0 + 2.0 * nu);
        }
    }
    sum
    // end
}

/// The rate of errors `(h, error)`: the slope of the line that fits their logarithms best.
fn rate(errors: &[(f64, f64)]) -> f64 {
    // solution: least squares for log(error) = c + p log(h)
    let n = errors.len() as f64;
    let (x, y) = errors.iter().fold((0.0, 0.0), |(x, y), (h, e)| (x + h.ln() / n, y + e.ln() / n));
    let cross: f64 = errors.iter().map(|(h, e)| (h.ln() - x) * (e.ln() - y)).sum();
    let square: f64 = errors.iter().map(|(h, _)| (h.ln() - x).powi(2)).sum();
    cross / square
    // end
}

/// Displacements v₁, v₂ and force σ of the two springs and the stop under the load (−1, `f2`).
fn springs(f2: f64) -> [f64; 3] {
    // solution: without contact first; if v₂ > 0, set v₂ = 0
    let free = [f2 - 1.0, 2.0 * f2 - 1.0, 0.0];
    if free[1] <= 0.0 { free } else { [-0.5, 0.0, 0.5 - f2] }
    // end
}

/// The term ∫ σ Iu of a segment (0, 1) by the midpoint rule with `n` cells.
fn term(u: impl Fn(f64) -> f64, sigma: impl Fn(f64) -> f64, n: usize) -> f64 {
    // solution: Iu is the line through the values of u at 0 and 1
    let h = 1.0 / n as f64;
    let line = |x: f64| u(0.0) * (1.0 - x) + u(1.0) * x;
    (0..n).map(|i| (i as f64 + 0.5) * h).map(|x| h * sigma(x) * line(x)).sum()
    // end
}

#[test]
fn seminorm_squared_of_the_line() {
    // ∫∫ |x − y|^(1 − 2ν) = 2/((2 − 2ν)(3 − 2ν))
    for nu in [0.1, 0.25, 0.4] {
        let exact = 2.0 / ((2.0 - 2.0 * nu) * (3.0 - 2.0 * nu));
        near(
            "seminorm_squared",
            &format!("v = x, ν = {nu}, 300 cells"),
            seminorm_squared(|x| x, nu, 300),
            exact,
            0.02 * exact,
        );
    }
    // a step: (4^ν − 1)/(ν (1 − 2ν))
    let step = |x: f64| if x < 0.5 { 0.0 } else { 1.0 };
    let exact = (2_f64.sqrt() - 1.0) * 8.0;
    let (coarse, fine) = (seminorm_squared(step, 0.25, 100), seminorm_squared(step, 0.25, 400));
    let case = "step at 1/2, ν = 1/4, 400 cells";
    check(
        "seminorm_squared",
        case,
        fine,
        &format!("nearer to {exact} than {coarse}, that of 100 cells, by 0.6"),
        (fine - exact).abs() < 0.6 * (coarse - exact).abs(),
    );
}

#[test]
fn rate_of_powers() {
    let errors: Vec<(f64, f64)> =
        (2..9).map(|k| 0.5_f64.powi(k)).map(|h| (h, 3.0 * h.powf(0.7))).collect();
    near("rate", "errors 3 h^0.7", rate(&errors), 0.7, 1e-12);
}

#[test]
fn springs_meet_the_contact_condition() {
    for k in 0..20 {
        let f2 = 0.1 * f64::from(k);
        let [v1, v2, sigma] = springs(f2);
        let (case, found) = (format!("f₂ = {f2:.1}; found are v₁, v₂, σ"), [v1, v2, sigma]);
        let meets = v2 <= 0.0 && sigma <= 0.0 && v2 * sigma == 0.0;
        check("springs", &case, found, "v₂ ≤ 0, σ ≤ 0, v₂ σ = 0", meets);
        let balances = (2.0 * v1 - v2 + 1.0).abs() < 1e-12 && (v2 - v1 - f2 - sigma).abs() < 1e-12;
        check("springs", &case, found, "2 v₁ − v₂ = −1, v₂ − v₁ = f₂ + σ", balances);
    }
}

#[test]
fn term_of_a_kink() {
    for (place, exact) in [(0.5, 1.0 / 16.0), (2.0 / 3.0, 2.0 / 27.0)] {
        let u = |x: f64| -(x - place).max(0.0);
        let sigma = |x: f64| if x < place { -1.0 } else { 0.0 };
        near(
            "term",
            &format!("contact on (0, {place}), 3000 cells"),
            term(u, sigma, 3000),
            exact,
            1e-6,
        );
    }
}
