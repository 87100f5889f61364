//! (6.2): |v(x) − v̄| ≤ h^{1/2} ‖v'‖₀, its best constant at every point.

use fractional_sobolev::{
    Domain, ErrorNorm, Estimate, Result, gauss_legendre, projection_constant,
};

/// Gauss rules integrate the polynomials below exactly.
const ROUNDING: f64 = 1e-14;

/// κ(x), the best constant of (6.2) at x on (0, 1).
fn pointwise(x: f64) -> Result<Estimate> {
    projection_constant(Domain::Interval(1.0), ErrorNorm::At(x), 1.0, 1e-12)
        .map(|found| found.constant)
}

/// |v(x) − v̄| / ‖v'‖₀ at x = node/N for the v with these N slopes: values and mean are summed, κ does not enter.
fn mean_deviation(slopes: &[f64], node: usize) -> f64 {
    let n = slopes.len() as f64;
    let (mut values, mut mean) = (vec![0.0], 0.0);
    for slope in slopes {
        let value = values[values.len() - 1];
        mean += (value + 0.5 * slope / n) / n;
        values.push(value + slope / n);
    }
    (values[node] - mean).abs() / (slopes.iter().map(|s| s * s).sum::<f64>() / n).sqrt()
}

/// The means over the cells of v' = s before x, s − 1 behind it.
fn extremal_slopes(cells: usize, node: usize) -> Vec<f64> {
    (0..cells).map(|i| (i as f64 + 0.5) / cells as f64 - f64::from(i >= node)).collect()
}

#[test]
fn the_extremal_parabolas_attain_the_constant() {
    // v' = s for s < x, s − 1 for s > x on (0, 1): v(x) − v̄ = ∫ k v' with k = v', so the quotient is ‖k‖.
    let rule = gauss_legendre(4).unwrap();
    for x in [0.0, 0.1, 0.5, 0.8, 1.0] {
        let square = x * rule.integrate(|t| (x * t).powi(2))
            + (1.0 - x) * rule.integrate(|t| ((1.0 - x) * t).powi(2));
        let v = |s: f64| {
            if s <= x {
                0.5 * s * s
            } else {
                0.5 * x * x + 0.5 * ((1.0 - s).powi(2) - (1.0 - x).powi(2))
            }
        };
        let mean =
            x * rule.integrate(|t| v(x * t)) + (1.0 - x) * rule.integrate(|t| v(x + (1.0 - x) * t));
        let quotient = (v(x) - mean) / square.sqrt();
        let best = pointwise(x).unwrap().value;
        assert!((quotient - best).abs() < ROUNDING, "{x}: {quotient} {best}");
    }
}

#[test]
fn the_printed_constant_is_loose_by_the_root_of_three_at_least() {
    for k in 0..=100 {
        let best = pointwise(f64::from(k) / 100.0).unwrap().value;
        assert!(best <= 1.0 / 3f64.sqrt() + ROUNDING && best >= 0.5 / 3f64.sqrt() - ROUNDING);
    }
    assert!((pointwise(0.0).unwrap().value - 1.0 / 3f64.sqrt()).abs() < ROUNDING);
    for bad in [-0.1, 1.1, f64::NAN] {
        assert!(pointwise(bad).is_err());
    }
}

#[test]
fn functions_with_many_slopes_come_near_and_none_passes() {
    for cells in [1, 2, 16, 1000] {
        for node in [0, cells / 3, cells / 2, cells] {
            let reached = mean_deviation(&extremal_slopes(cells, node), node);
            let best = pointwise(node as f64 / cells as f64).unwrap();
            let missing =
                best.value.powi(2) - reached * reached - 1.0 / (12.0 * (cells as f64).powi(2));
            assert!(missing.abs() < 1e-13, "{cells} {node}: {missing:e}");
        }
    }
    // v = x on (0, 1): at the ends half, in the middle nothing.
    for (node, expected) in [(0, 0.5), (4, 0.0), (8, 0.5)] {
        let quotient = mean_deviation(&[1.0; 8], node);
        assert!((quotient - expected).abs() < ROUNDING, "{node}: {quotient}");
    }
    let mut state = 7u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 * 2f64.powi(-53)
    };
    let mut largest = 0.0f64;
    for k in 0..4000 {
        let node = (65.0 * random()) as usize;
        let noise = random();
        let slopes: Vec<f64> = extremal_slopes(64, node)
            .iter()
            .map(|best| {
                if k % 2 == 0 {
                    2.0 * random() - 1.0
                } else {
                    best + noise * (2.0 * random() - 1.0)
                }
            })
            .collect();
        largest = largest
            .max(mean_deviation(&slopes, node) / pointwise(node as f64 / 64.0).unwrap().value);
    }
    assert!(largest < 1.0 && largest > 0.9, "{largest}");
}
