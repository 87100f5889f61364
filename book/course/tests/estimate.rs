//! Programs of sheets 3 and 5, and behind them. `cargo course skeleton estimate` writes this file with holes.

use course::{check, near};
use fractional_sobolev::{Function, Result};

/// Both sides of J(v) − J(u) = ½ |v − u|² + σ (v₂ − u₂) for the two springs with the load (−1, 1), whose solution
/// is u = (−½, 0) with σ = −½.
fn excess(v: [f64; 2]) -> [f64; 2] {
    // solution: the energy norm is that of the springs, x² + (y − x)²
    let energy = |v: [f64; 2]| 0.5 * v[0] * v[0] + 0.5 * (v[1] - v[0]).powi(2) + v[0] - v[1];
    let [x, y] = [v[0] + 0.5, v[1]];
    [energy(v) - energy([-0.5, 0.0]), 0.5 * (x * x + (y - x).powi(2)) - 0.5 * v[1]]
    // end
}

/// The norm of order −1/2 of the wave cos(2πx/h) − 1 on (0, 1), h = 1/n.
fn wave(n: usize) -> Result<f64> {
    // solution: Function::from_fn with the nodes as breakpoints, then norm(-0.5, 1e-6)
    let nodes: Vec<f64> = (0..=n).map(|k| k as f64 / n as f64).collect();
    let u = Function::from_fn(&nodes, move |x| {
        (2.0 * std::f64::consts::PI * n as f64 * x).cos() - 1.0
    })?;
    Ok(u.norm(-0.5, 1e-6)?.value)
    // end
}

/// Whether a segment, given by the values of u_N ≤ 0 at equally spaced points from one vertex to the other, has a
/// zero within the part `theta` of its length from both vertices: the first case of Figure 3.2.
fn first_case(values: &[f64], theta: f64) -> bool {
    // solution: look for a zero among the first and among the last points
    let last = values.len() - 1;
    let within = |k: usize| k as f64 <= theta * last as f64;
    let near_start = (0..=last).any(|k| within(k) && values[k] == 0.0);
    let near_end = (0..=last).any(|k| within(k) && values[last - k] == 0.0);
    near_start && near_end
    // end
}

/// The diameter of the contact set of such a segment as a part of its length; zero if there is no contact.
fn diameter(values: &[f64]) -> f64 {
    // solution: last zero less first zero
    let first = values.iter().position(|&u| u == 0.0);
    let last = values.iter().rposition(|&u| u == 0.0);
    first.zip(last).map_or(0.0, |(first, last)| (last - first) as f64 / (values.len() - 1) as f64)
    // end
}

/// The gaps of the fat Cantor set: in generation k = 0, 1, .. each of the 2^k pieces of (0, 1) loses an open gap of
/// length 4^(−k−1) in its middle. Returns the gaps of the first `generations` generations.
fn cantor_gaps(generations: u32) -> Vec<(f64, f64)> {
    // solution: keep a list of pieces; split each of them
    let (mut pieces, mut gaps) = (vec![(0.0, 1.0)], Vec::new());
    for k in 0..generations {
        let half = 0.5 * 0.25_f64.powi(k as i32 + 1);
        let middles: Vec<f64> = pieces.iter().map(|(a, b)| 0.5 * (a + b)).collect();
        gaps.extend(middles.iter().map(|m| (m - half, m + half)));
        let split =
            pieces.iter().zip(&middles).flat_map(|(&(a, b), m)| [(a, m - half), (m + half, b)]);
        pieces = split.collect();
    }
    gaps
    // end
}

#[test]
fn excess_has_two_equal_sides() {
    for v in [[0.3, -0.2], [-1.0, -0.5], [0.7, 0.0], [-0.5, 0.0]] {
        let [left, right] = excess(v);
        let is_right = (left - right).abs() < 1e-14 && left >= 0.0;
        check("excess", &format!("v = {v:?}"), [left, right], "two equal numbers ≥ 0", is_right);
    }
}

#[test]
fn wave_is_not_small_in_the_dual_norm() {
    for n in [2, 4, 8] {
        let found = wave(n).unwrap();
        check("wave", &format!("n = {n}"), found, "between 1 and 1.5", (1.0..1.5).contains(&found));
    }
}

#[test]
fn first_case_needs_both_vertices() {
    let values = [0.0, -1.0, -1.0, -1.0, 0.0, 0.0, -1.0, -2.0, -3.0, -4.0, -5.0];
    let cases: [(&[f64], f64, bool); 4] = [
        (&values, 0.4, false),
        (&values, 0.5, true),
        (&[0.0, 0.0, 0.0], 0.1, true),
        (&[-1.0, -1.0, -1.0], 1.0, false),
    ];
    for (values, theta, expected) in cases {
        let found = first_case(values, theta);
        check(
            "first_case",
            &format!("{values:?}, θ = {theta}"),
            found,
            &expected.to_string(),
            found == expected,
        );
    }
}

#[test]
fn diameter_counts_what_lies_between() {
    near("diameter", "zeros at 1/4 and 3/4", diameter(&[-1.0, 0.0, -1.0, 0.0, -1.0]), 0.5, 0.0);
    near("diameter", "a zero at 1/2", diameter(&[-1.0, 0.0, -1.0]), 0.0, 0.0);
    near("diameter", "zeros at 0, 1/2, 1", diameter(&[0.0, 0.0, 0.0]), 1.0, 0.0);
}

#[test]
fn cantor_gaps_fill_one_half() {
    let gaps = cantor_gaps(12);
    let length: f64 = gaps.iter().map(|(a, b)| b - a).sum();
    check(
        "cantor_gaps",
        "number of gaps, 12 generations",
        gaps.len(),
        "4095",
        gaps.len() == (1 << 12) - 1,
    );
    near("cantor_gaps", "their length together", length, 0.5 * (1.0 - 0.5_f64.powi(12)), 1e-9);
    let outside = gaps.iter().find(|&&(a, b)| !(0.0 < a && a < b && b < 1.0));
    check("cantor_gaps", "a gap (a, b) without 0 < a < b < 1", outside, "none", outside.is_none());
}
