//! Theorems 3.1 and 4.1 with numbers for an elastic body: the bound is above the error, its norms by second
//! roads, and planted faults.

#[allow(dead_code)]
#[path = "../examples/theorem_3_1_with_numbers_elastic.rs"]
mod example;

use example_frame::Outcome;
use fractional_sobolev::{Function, Order, Tolerance};
use signorini::fem::Lame;
use signorini::problems::{EdgeDatum, KnownSolution};
use signorini::proof::TheoremConstants;
use std::f64::consts::PI;

fn order(s: f64) -> Order {
    Order::new(s).unwrap()
}

#[test]
fn the_bound_is_above_the_error_of_elastic_bodies_for_every_tau_and_both_cones() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
}

/// Quasi-random pairs of points in the half disc, the gradient as it stands in the scene: nothing of the
/// decomposition in rotation, sine and bend.
#[test]
fn the_norm_of_the_gradient_is_that_of_pairs_of_points() {
    const PAIRS: usize = 1_000_000;
    // The positive root of x⁵ = x + 1: steps of an even sequence in four dimensions.
    const ROOT: f64 = 1.167_303_978_261_418_7;
    // Of pairs near each other and near the corner; seen: 2e-3.
    const SAMPLED: f64 = 0.01;
    for (p, s, lame) in [(1.35, 0.3, Lame::new(1.3, 0.7)), (0.85, 0.2, Lame::new(-0.3, 1.0))] {
        let scene = KnownSolution::power(p, Some(lame.unwrap())).unwrap();
        // Of the half disc about the transition 2/5 that holds the square.
        let (radius, mut sum) = (0.6f64.hypot(1.0), 0.0);
        for k in 0..PAIRS {
            let u = [1, 2, 3, 4].map(|j| (0.5 + (k + 1) as f64 * ROOT.powi(-j)).fract());
            let point = |square: f64, turn: f64| {
                let (r, phi) = (radius * square.sqrt(), PI * turn);
                [0.4 - r * phi.cos(), r * phi.sin()]
            };
            let (x, y) = (point(u[0], u[1]), point(u[2], u[3]));
            let (g, h) = (scene.gradient(x), scene.gradient(y));
            let squares = (0..4).map(|i| (g[i / 2][i % 2] - h[i / 2][i % 2]).powi(2)).sum::<f64>();
            sum += squares / (x[0] - y[0]).hypot(x[1] - y[1]).powf(2.0 + 2.0 * s);
        }
        let area = 0.5 * PI * radius * radius;
        let sampled = (area * area * sum / PAIRS as f64).sqrt();
        let norm = scene.body_seminorm(1.0 + s, Tolerance::balanced()).unwrap().value;
        assert!((sampled / norm - 1.0).abs() < SAMPLED, "{p} {s}: {sampled} {norm}");
    }
}

/// (1−s) |∇u|_s² → π/2 ‖D²u‖²: two formulas that share nothing.
#[test]
fn the_norm_has_its_limit_at_tau_two() {
    for (p, lame) in [(1.06, Lame::new(1.0, 1.0)), (1.4, Lame::new(20.0, 0.5))] {
        let scene = KnownSolution::power(p, Some(lame.unwrap())).unwrap();
        let gap = 1e-8;
        let near = scene.body_seminorm(2.0 - gap, Tolerance::fast()).unwrap().value;
        let limit = scene.body_seminorm(2.0, Tolerance::fast()).unwrap().value;
        assert!((gap * near * near / (0.5 * PI * limit * limit) - 1.0).abs() < 1e-6, "{p}");
    }
}

/// Lamé's constants times c: u over c, errors and bounds over √c; β/(2μ) is what stands beside the slope.
#[test]
fn everything_scales_with_the_stiffness() {
    let scene = |factor: f64| {
        let lame = Lame::new(1.3 * factor, 0.7 * factor).unwrap();
        KnownSolution::power(0.81, Some(lame)).unwrap()
    };
    let numbers = TheoremConstants::new(1.75).unwrap();
    let study = |factor| {
        experiments::proof::NumberedStudy::new(numbers, scene(factor), signorini::cone::Cone::Midpoint, 3)
            .unwrap()
    };
    let (soft, stiff) = (study(1.0), study(100.0));
    for (a, b) in soft.rows.iter().zip(&stiff.rows) {
        for (a, b) in [(a.error, b.error), (a.bound, b.bound), (a.near, b.near)] {
            assert!((a / (10.0 * b) - 1.0).abs() < 1e-9, "{a} {b}");
        }
    }
    let slope = |scene: KnownSolution| {
        scene.edge_seminorm(EdgeDatum::Slope, [0.0, 1.0], order(0.2), Tolerance::fast()).unwrap().value
    };
    let lame = scene(1.0).lame().unwrap();
    let ratio = (lame.lambda() + 2.0 * lame.mu()) / (2.0 * lame.mu() * (lame.lambda() + lame.mu()));
    assert!(
        (slope(scene(1.0)) / slope(KnownSolution::power(0.81, None).unwrap()) / ratio - 1.0).abs() < 1e-12
    );
}

#[test]
fn what_is_not_in_the_space_is_an_error() {
    let scene = KnownSolution::power(0.74, Some(Lame::new(1.0, 1.0).unwrap())).unwrap();
    assert!(scene.body_seminorm(1.75, Tolerance::fast()).is_err());
    assert!(scene.body_seminorm(2.0, Tolerance::fast()).is_err());
    assert!(Function::elastic_corner(1.5, 0.0, 1.0).is_err());
    let options = example::Options { mu: -1.0, ..example::Options::default() };
    assert!(example::compute(&options).is_err());
}

#[test]
fn a_bound_without_its_elastic_constants_is_seen() {
    let options = example::Options { tau: vec![1.75, 2.0], finest: 4, ..example::Options::default() };
    let outcome = |studies: &[experiments::proof::NumberedStudy], key: &str| {
        let found = example::findings(studies);
        found.iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    let sound = example::compute(&options).unwrap();
    for key in ["above", "korn", "near", "effectivity"] {
        assert_eq!(outcome(&sound, key), Outcome::Holds, "{key}");
    }
    let mut studies = sound.clone();
    studies[1].rows[2].bound = 0.9 * studies[1].rows[2].error;
    assert_eq!(outcome(&studies, "above"), Outcome::Refuted);
    assert_eq!(outcome(&studies, "korn"), Outcome::Refuted);
    let mut studies = sound.clone();
    studies[0].rows[2].bound = 0.9 * studies[0].rows[2].error;
    assert_eq!(outcome(&studies, "korn"), Outcome::Holds);
    let mut studies = sound.clone();
    studies[1].rows[0].near = 0.5 * studies[1].rows[0].error;
    assert_eq!(outcome(&studies, "near"), Outcome::Refuted);
    let mut studies = sound;
    studies[2].rows[0].bound *= 20.0;
    assert_eq!(outcome(&studies, "effectivity"), Outcome::Refuted);
    assert_eq!(outcome(&studies, "all"), Outcome::Refuted);
}
