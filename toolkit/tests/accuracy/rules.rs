//! Gauss-Jacobi rules of up to 4096 points against points and weights with 40 digits.

use fractional_sobolev::{Rule, gauss_jacobi};

/// The largest relative error of a point, next to 1 of its distance to 0, and of a weight.
const ROUNDING: f64 = 1e-14;

#[test]
fn points_and_weights_have_all_digits_up_to_4096_points() {
    let text = include_str!("../reference/jacobi_reference.json");
    let rows: Vec<[f64; 6]> = serde_json::from_str::<serde_json::Value>(text).unwrap()["rows"]
        .as_array()
        .unwrap()
        .iter()
        .map(|row| std::array::from_fn(|k| row[k].as_str().unwrap().parse().unwrap()))
        .collect();
    let mut last: Option<([f64; 3], Rule)> = None;
    for [n, alpha, beta, index, point, weight] in rows {
        let key = [n, alpha, beta];
        let rule = match last.take() {
            Some((known, rule)) if known == key => rule,
            _ => gauss_jacobi(n as usize, alpha, beta).unwrap(),
        };
        let (t, w) = (rule.points()[index as usize], rule.weights()[index as usize]);
        let case = format!("{n} points, {alpha}, {beta}, point {index}");
        assert!((t / point - 1.0).abs() <= ROUNDING, "{case}: {t}, {point}");
        assert!((w / weight - 1.0).abs() <= ROUNDING, "{case}: weight {w}, {weight}");
        last = Some((key, rule));
    }
}

/// With one exponent 0 the weights sum to 1 over 1 plus the other.
#[test]
fn weights_sum_to_their_integral() {
    for (n, alpha, beta) in
        [(1024, 0.0, -0.9), (1024, -0.999, 0.0), (1024, 0.25, 0.0), (4096, 0.0, 0.0)]
    {
        let rule = gauss_jacobi(n, alpha, beta).unwrap();
        let (sum, exact): (f64, f64) = (rule.weights().iter().sum(), 1.0 / (1.0 + alpha + beta));
        assert!((sum / exact - 1.0).abs() <= ROUNDING, "{n} {alpha} {beta}: {sum}, {exact}");
    }
}

/// The weights sum to B(α + 1, β + 1), here to the last digit. The Gamma function at 40 magnifies the rounding of its argument
/// by 150.
#[test]
fn weights_for_large_exponents_keep_their_digits() {
    for (n, alpha, beta, exact) in [
        (2297, 19.700336266135015, 18.496549696267785, 6.431073925169798e-13),
        (20, 1000.3, -0.7, 0.3765089483071119),
        (300, 37.1, 0.25, 0.009536640766596956),
        (40, 77.7, 77.7, 1.6602979740596694e-48),
    ] {
        let rule = gauss_jacobi(n, alpha, beta).unwrap();
        let sum: f64 = rule.weights().iter().sum();
        assert!((sum / exact - 1.0).abs() <= ROUNDING, "{n} {alpha} {beta}: {sum}, {exact}");
    }
}
