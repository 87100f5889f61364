//! Programs of sheets 4 and 6, and behind them. `cargo course skeleton zone` writes this file with holes.

use course::{check, near};
use fractional_sobolev::{Constraint, Function, Result, gamma};

/// The exponent of θ in γ_θ between the zones of length 1e-6 and 1e-8.
fn exponent(nu: f64) -> Result<f64> {
    // solution: gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8)?.constant.value
    let at = |theta: f64| Ok(gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8)?.constant.value);
    let quotient: f64 = at(1e-6)? / at(1e-8)?;
    Ok(quotient.ln() / 100_f64.ln())
    // end
}

/// The quotient ‖u‖₀/|u|_½ of the function that is zero on (0, θ) and 1 + ln x / ln(1/θ) on (θ, 1).
fn ramp(theta: f64) -> Result<f64> {
    // solution: Function::from_fn with the breakpoints 0, θ, 1; norm(0.0, ..) is that of L²
    let length = -theta.ln();
    let u =
        Function::from_fn(
            &[0.0, theta, 1.0],
            move |x| if x < theta { 0.0 } else { 1.0 + x.ln() / length },
        )?;
    Ok(u.norm(0.0, 1e-6)?.value / u.seminorm(0.5, 1e-6)?.value)
    // end
}

/// The bound of γ at the zone θ^(2^n) that n steps γ_(θ²) ≤ γ_θ (1 + θ^(ν − ½)) give, from `start` = γ_θ.
fn doubling(start: f64, theta: f64, nu: f64, n: u32) -> f64 {
    // solution: θ is squared in each step
    (0..n)
        .fold((start, theta), |(bound, theta), _| {
            (bound * (1.0 + theta.powf(nu - 0.5)), theta * theta)
        })
        .0
    // end
}

/// Which of the places k/8, k = 0 .. 8, has the smallest constant γ for functions that vanish there, ν = 3/4.
fn best_place() -> Result<usize> {
    // solution: Constraint::vanishing_at(x)
    let at =
        |k: usize| Ok(gamma(0.75, Constraint::vanishing_at(k as f64 / 8.0), 1e-6)?.constant.value);
    let values: Vec<f64> = (0..=8).map(at).collect::<Result<_>>()?;
    Ok((0..=8).min_by(|&i, &k| values[i].total_cmp(&values[k])).unwrap_or(0))
    // end
}

/// The error in L²(0, 1) of the piecewise linear interpolant of `u` on `n` equal cells, by `m` midpoints in a cell.
fn interpolation_error(u: impl Fn(f64) -> f64, n: usize, m: usize) -> f64 {
    // solution: on each cell the difference from the line between the values at its ends
    let h = 1.0 / n as f64;
    let mut sum = 0.0;
    for i in 0..n {
        let (left, right) = (u(i as f64 * h), u((i + 1) as f64 * h));
        for k in 0..m {
            let s = (k as f64 + 0.5) / m as f64;
            sum += h / m as f64 * (u((i as f64 + s) * h) - left - s * (right - left)).powi(2);
        }
    }
    sum.sqrt()
    // end
}

/// The best constant at the place t in |v(t) − mean of v| ≤ κ ‖v'‖₀ on (0, 1), from functions with `n` constant
/// slopes: the norm of the kernel that is s for s < t and s − 1 for s > t, averaged over the cells.
fn deviation(t: f64, n: usize) -> f64 {
    // solution: t lies at a node; on each cell the mean of the kernel is its value at the midpoint
    let h = 1.0 / n as f64;
    let mid = |i: usize| (i as f64 + 0.5) * h;
    let kernel = |s: f64| if s < t { s } else { s - 1.0 };
    (0..n).map(|i| h * kernel(mid(i)).powi(2)).sum::<f64>().sqrt()
    // end
}

/// The squared seminorm of order ν of values on cells of (0, 1), by the midpoint rule, before and after sorting.
fn sorting(values: &[f64], nu: f64) -> [f64; 2] {
    // solution: one function for the double sum, used twice
    let n = values.len();
    let squared = |v: &[f64]| -> f64 {
        let pairs = (0..n).flat_map(|i| (0..n).filter(move |&k| k != i).map(move |k| (i, k)));
        let kernel = |i: usize, k: usize| (i.abs_diff(k) as f64 / n as f64).powf(-1.0 - 2.0 * nu);
        pairs.map(|(i, k)| (v[i] - v[k]).powi(2) * kernel(i, k)).sum::<f64>() / (n * n) as f64
    };
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    [squared(values), squared(&sorted)]
    // end
}

#[test]
fn exponent_on_both_sides_of_one_half() {
    near("exponent", "ν = 1/4", exponent(0.25).unwrap(), -0.25, 0.01);
    near("exponent", "ν = 3/4", exponent(0.75).unwrap(), 0.0, 0.01);
}

#[test]
fn ramp_is_a_lower_bound_that_grows() {
    for theta in [1e-2, 1e-4] {
        let best = gamma(0.5, Constraint::mean_zero_on(0.0..theta), 1e-8).unwrap().constant.value;
        let found = ramp(theta).unwrap();
        let expected = format!("between 0.8 and 1 times {best}");
        check(
            "ramp",
            &format!("θ = {theta}"),
            found,
            &expected,
            0.8 * best < found && found < best,
        );
    }
}

#[test]
fn doubling_is_an_upper_bound() {
    for nu in [0.25, 0.5, 0.75] {
        let at = |theta: f64| {
            gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-8).unwrap().constant.value
        };
        for n in 1..4 {
            let bound = doubling(at(0.25), 0.25, nu, n);
            let gamma = at(0.25_f64.powi(1 << n));
            check(
                "doubling",
                &format!("ν = {nu}, n = {n}"),
                bound,
                &format!("at least {gamma}"),
                gamma <= bound,
            );
        }
    }
    near("doubling", "ν = 1/2, three steps from 1", doubling(1.0, 0.25, 0.5, 3), 8.0, 0.0);
}

#[test]
fn best_place_is_the_centre() {
    let found = best_place().unwrap();
    check("best_place", "number of the best of nine places, from 0", found, "4", found == 4);
}

#[test]
fn interpolation_error_has_its_order() {
    for (power, order) in [(2.0, 2.0), (0.75, 1.25)] {
        let at = |n| interpolation_error(|x: f64| x.powf(power), n, 200);
        let found: f64 = (at(64) / at(128)).log2();
        near("interpolation_error", &format!("order for x^{power}"), found, order, 0.02);
    }
}

#[test]
fn deviation_nears_its_closed_form() {
    for t in [0.0, 0.25, 0.5, 1.0] {
        let exact = ((f64::powi(t, 3) + f64::powi(1.0 - t, 3)) / 3.0).sqrt();
        near("deviation", &format!("t = {t}, 400 cells"), deviation(t, 400), exact, 1e-5 * exact);
    }
}

#[test]
fn sorting_lowers_the_seminorm() {
    for factor in 1..20 {
        let values: Vec<f64> = (0..40).map(|k| f64::from(k * k * factor % 41)).collect();
        let [before, after] = sorting(&values, 0.3);
        check(
            "sorting",
            &format!("factor {factor}"),
            [before, after],
            "not larger after sorting",
            after <= before * (1.0 + 1e-12),
        );
    }
}
