//! Theorems 3.1 and 4.1 with numbers: the bound is above the error, its norms by second roads, and planted
//! faults.

#[allow(dead_code)]
#[path = "../examples/theorem_3_1_with_numbers.rs"]
mod example;

use example_frame::Outcome;
use experiments::proof::NumberedStudy;
use fractional_sobolev::{Function, Order, Tolerance, closed_forms};
use signorini::problems::{EdgeDatum, KnownSolution};
use signorini::proof::TheoremConstants;

fn order(s: f64) -> Order {
    Order::new(s).unwrap()
}

#[test]
fn the_bound_is_above_the_error_for_every_tau_and_both_cones() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
}

/// p² |r^{p−1} sin((p−1)φ)|² is the first component; p = 3/2 about φ: both components have the same part of a
/// full turn only together, so the sum is compared with the limit s → 1, π/2 of the integral of |D²|².
#[test]
fn the_norm_of_the_gradient_has_its_components_and_its_limit() {
    let (p, radius) = (1.5, 1.3);
    for s in [0.3, 0.7] {
        let whole = Function::sector_power(p, p, std::f64::consts::PI, radius).unwrap();
        let whole = whole.seminorm(order(s).plus_one(), Tolerance::balanced()).unwrap();
        let sine = Function::sector_power(p - 1.0, p - 1.0, std::f64::consts::PI, radius).unwrap();
        let sine = p * sine.seminorm(order(s), Tolerance::balanced()).unwrap().value;
        // cos(φ/2) is sin(φ/2) seen from the other side of the half disc.
        let exact = 2f64.sqrt() * sine;
        assert!((whole.value / exact - 1.0).abs() < 1e-10, "{s}: {} {exact}", whole.value);
    }
    let s = 1.0 - 1e-8;
    let near = Function::sector_power(p, p, std::f64::consts::PI, radius).unwrap();
    let near = near.seminorm(order(s).plus_one(), Tolerance::fast()).unwrap().value;
    let limit =
        std::f64::consts::FRAC_PI_2 * p * p * (p - 1.0) * std::f64::consts::PI * radius.powf(2.0 * p - 2.0);
    assert!((1e-8 * near * near / limit - 1.0).abs() < 1e-6);
}

/// Between the seminorm on the side where it lives and that with the jump to zero beyond.
#[test]
fn seminorms_of_the_edge_scale_and_hold_those_of_their_side() {
    let scene = KnownSolution::power(0.8, None).unwrap();
    let (nu, fast) = (order(0.15), Tolerance::fast());
    let one = |part| scene.edge_seminorm(EdgeDatum::Slope, part, nu, fast).unwrap().value;
    let side = closed_forms::power_seminorm_squared(-0.2, nu).unwrap().value.sqrt();
    let size = 0.8 * (0.8 * std::f64::consts::PI).sin();
    // (0.4, 1) alone: 0.6^{−0.2 + 1/2 − ν} |t^{−0.2}| on the unit interval.
    assert!(one([0.0, 1.0]) > size * side * 0.6f64.powf(0.15));
    // Both sides in the same proportion: scaling by 1/2 about the transition.
    let ratio = one([0.2, 0.7]) / one([0.0, 1.0]);
    assert!((ratio / 0.5f64.powf(0.15) - 1.0).abs() < 1e-4, "{ratio}");
}

#[test]
fn what_is_not_in_the_space_is_an_error() {
    let numbers = TheoremConstants::new(1.75).unwrap();
    let rough = KnownSolution::power(0.74, None).unwrap();
    assert!(NumberedStudy::new(numbers, rough, signorini::cone::Cone::Nodal, 3).is_err());
    assert!(TheoremConstants::new(1.5).is_err() && TheoremConstants::new(2.1).is_err());
    let options = example::Options { above: 0.0, ..example::Options::default() };
    assert!(example::compute(&options).is_err());
}

#[test]
fn a_bound_without_a_term_is_seen() {
    let options = example::Options { tau: vec![1.75, 2.0], finest: 4, ..example::Options::default() };
    let outcome = |studies: &[NumberedStudy], key: &str| {
        let found = example::findings(studies);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    let sound = example::compute(&options).unwrap();
    for key in ["above", "near", "effectivity"] {
        assert_eq!(outcome(&sound, key), Outcome::Holds, "{key}");
    }
    let mut studies = sound.clone();
    studies[0].rows[1].bound = 0.9 * studies[0].rows[1].error;
    assert_eq!(outcome(&studies, "above"), Outcome::Refuted);
    let mut studies = sound.clone();
    studies[1].rows[0].near = 0.5 * studies[1].rows[0].error;
    assert_eq!(outcome(&studies, "near"), Outcome::Refuted);
    let mut studies = sound;
    studies[2].rows[0].bound *= 20.0;
    assert_eq!(outcome(&studies, "effectivity"), Outcome::Refuted);
}
