//! Remark 2: the dual norm of the interpolation error of H^{3/2} functions is of order h^{3/2} and no better.

#[allow(dead_code)]
#[path = "../examples/remark_2_dual_norm_counterexample.rs"]
mod example;

use experiments::interpolation::{AliasedWave, all_waves_mean};
use fractional_sobolev::{Domain, ErrorNorm, interpolation_constant};

/// Required of the exponents.
const EXPONENT_TOLERANCE: f64 = 0.02;

#[test]
fn a_wave_per_element_stays_at_three_halves_on_every_mesh() {
    let unit = Domain::Interval(1.0);
    let bound = interpolation_constant(unit, ErrorNorm::L2, 0.5, 1e-8).unwrap().constant.value;
    let quotient = |k: u32| AliasedWave::new(1 << k).unwrap().quotient().unwrap();
    // ‖e‖/‖u‖ → h^{3/2}/(√8 π²)
    let limit = 1.0 / (8f64.sqrt() * std::f64::consts::PI.powi(2));
    for k in 4..40 {
        let (coarse, fine) = (quotient(k), quotient(k + 1));
        let rate = (coarse.value / fine.value).log2();
        assert!((rate - 1.5).abs() < EXPONENT_TOLERANCE, "2^{k}: {rate}");
        let scaled = fine.value * 2f64.powf(1.5 * f64::from(k + 1));
        assert!(scaled <= bound && scaled >= 0.5 * limit, "2^{k}: {scaled}");
    }
    let finest = quotient(40);
    assert!((finest.value * 2f64.powf(60.0) / limit - 1.0).abs() < 1e-5, "{finest}");
}

#[test]
fn one_function_is_no_better_on_all_meshes() {
    // c_j = (1+j)^{-p} tilts the exponent by p/k: below 0.02 from k = 30 on for p = 0.6.
    for (k, l) in [(60, 120), (170, 340)] {
        let (coarse, fine) = (all_waves_mean(k, 0.6).unwrap().value, all_waves_mean(l, 0.6).unwrap().value);
        let rate = (coarse / fine).log2() / (l - k) as f64;
        assert!((rate - 1.5).abs() < EXPONENT_TOLERANCE && rate > 1.5, "{k} {l}: {rate}");
    }
}

#[test]
fn the_example_measures_both_exponents() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{}", headline.verdict());
    let last = headline.table.rows().len() - 1;
    let number = |key| headline.table.number(last, key).unwrap();
    assert!((number("wave_rate") - 1.5).abs() < EXPONENT_TOLERANCE);
    assert!((number("falk") - 0.75).abs() < EXPONENT_TOLERANCE);
    assert!((number("smooth_rate") - 2.0).abs() < EXPONENT_TOLERANCE);
    for bad in [(0, 3), (16, 1), (16, 21), (1000, 3)] {
        let options = example::Options { elements: bad.0, meshes: bad.1, ..example::Options::default() };
        assert!(example::run(&options).is_err(), "{bad:?}");
    }
}

#[test]
fn spoiled_errors_turn_the_verdict_and_two_meshes_decide_nothing() {
    let options = example::Options { meshes: 4, ..example::Options::default() };
    let mut computed = example::compute(&options).unwrap();
    let verdict =
        |computed: &example::Computed| example_frame::Verdict::of(&example::findings(&options, computed));
    assert!(verdict(&computed).is_confirmed());
    let order = &mut computed.wave.rates.last_mut().unwrap().as_mut().unwrap().order;
    let sound = std::mem::replace(order, 1.6);
    assert!(!verdict(&computed).is_confirmed(), "an order better than the remark says");
    computed.wave.rates.last_mut().unwrap().as_mut().unwrap().order = sound;
    computed.wave.errors[0].value = 1.01 * computed.bounds[0].value;
    assert!(!verdict(&computed).is_confirmed(), "a wave above the bound of all functions");
    let two = example::run(&example::Options { meshes: 2, ..example::Options::default() }).unwrap();
    assert!(matches!(two.verdict(), example_frame::Verdict::Undecided(_)), "{}", two.verdict());
}
