//! Remark 2: the dual norm of the interpolation error of H^{3/2} functions is of order h^{3/2} and no better.

use fractional_sobolev::{Domain, ErrorNorm, Function, Mesh, Tolerance, interpolation_constant};
use std::f64::consts::PI;

#[allow(dead_code)]
#[path = "../../examples/remark_2_dual_norm_counterexample.rs"]
mod example;

/// Required of the exponents.
const EXPONENT_TOLERANCE: f64 = 0.02;

#[test]
fn a_wave_per_element_stays_at_three_halves_on_every_mesh() {
    let unit = Domain::Interval(1.0);
    let bound = interpolation_constant(unit, ErrorNorm::L2, 0.5, 1e-8).unwrap().constant.value;
    // The dual norm of the error is 1 or more, and at most that of Lemma 5.2's γ₁.
    let quotient = |k: u32| 1.0 / example::norm_of_wave(1 << k).unwrap();
    let limit = 1.0 / (8f64.sqrt() * PI.powi(2));
    for k in 4..16 {
        let (coarse, fine) = (quotient(k), quotient(k + 1));
        let rate = (coarse / fine).log2();
        assert!((rate - 1.5).abs() < EXPONENT_TOLERANCE, "2^{k}: {rate}");
        let scaled = fine * 2f64.powf(1.5 * f64::from(k + 1));
        assert!(scaled <= bound && scaled >= 0.5 * limit, "2^{k}: {scaled}");
    }
    assert!((quotient(16) * 2f64.powf(24.0) / limit - 1.0).abs() < 1e-3, "{}", quotient(16));
}

#[test]
fn one_function_is_no_better_on_all_meshes() {
    // c_j = (1+j)^{-p} tilts the exponent by p/k: below 0.02 from k = 30 on for p = 0.6.
    for (k, l) in [(60, 120), (170, 340)] {
        let [coarse, fine] = [k, l].map(example::mean_of_all_waves);
        let rate = (coarse / fine).log2() / f64::from(l - k);
        assert!((rate - 1.5).abs() < EXPONENT_TOLERANCE && rate > 1.5, "{k} {l}: {rate}");
    }
    // Its mean, on 16 elements, by the function itself: the waves j < 4 have errors of mean zero.
    let mesh = Mesh::uniform(16 * 64, 1.0).unwrap();
    let u = |x: f64| -> f64 {
        let wave = |j: i32| {
            let c = (1.0 + f64::from(j)).powf(-0.6) * (-1.5 * f64::from(j)).exp2();
            c * ((2.0 * PI * f64::from(j).exp2() * x).cos() - 1.0)
        };
        (0..9).map(wave).sum()
    };
    let nodal: Vec<f64> = (0..=16).map(|k| u(f64::from(k) / 16.0)).collect();
    let interpolant = |x: f64| {
        let k = ((x * 16.0) as usize).min(15);
        nodal[k] + (x * 16.0 - k as f64) * (nodal[k + 1] - nodal[k])
    };
    let error = Function::interpolate(&mesh, 4, |x| u(x) - interpolant(x)).unwrap();
    let mean = -error.mean(Tolerance::reference()).unwrap().value;
    let beyond = example::mean_of_all_waves(4) - example::mean_of_all_waves(9);
    assert!((mean / beyond - 1.0).abs() < 1e-3, "{mean} and {beyond}");
}
