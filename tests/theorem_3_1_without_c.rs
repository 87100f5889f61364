//! Theorems 3.1 and 4.1 at τ = 2 with numbers in the place of C.

#[allow(dead_code)]
#[path = "../examples/theorem_3_1_without_c.rs"]
mod example;

use example_frame::Outcome;
use signorini::cone::Cone;
use signorini::fem::{Form, Lame};
use signorini::proof::{BoundWithoutC, MeshShape, unit_square_korn};
use signorini::quadrature::Rule;
use signorini::scenes::ClosedForm;
use std::f64::consts::PI;

fn options() -> example::Options {
    example::Options { finest: 5, ..example::Options::default() }
}

#[test]
fn the_bound_is_above_the_error_on_every_mesh() {
    let headline = example::run(&options()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    for row in 0..headline.table.rows().len() {
        for (key, whole) in [("c", "c_whole"), ("K", "K_whole"), ("kappa", "kappa_whole")] {
            let [local, whole] = [key, whole].map(|key| headline.table.number(row, key).unwrap());
            assert!(1.0 <= local && local <= whole, "{headline}");
        }
    }
}

#[test]
fn a_constant_that_is_too_small_is_seen() {
    let mut studies = example::compute(&options()).unwrap();
    for study in &mut studies {
        study.bounds[1].approximation *= 0.5;
        study.bounds[1].consistency = 0.0;
        study.bounds[1].projection = 0.0;
    }
    let outcome = |key: &str| {
        let found = example::findings(&studies).unwrap();
        found.into_iter().find(|finding| finding.key() == key).unwrap().outcome()
    };
    assert_eq!(outcome("above.K"), Outcome::Refuted);
    assert_eq!(outcome("above.c"), Outcome::Holds);
}

#[test]
fn constants_of_the_scalar_problem_are_those_computed_by_hand() {
    let shape = MeshShape::right_isosceles();
    assert!((shape.interpolation - 0.4929124517549).abs() < 1e-12, "Kikuchi and Liu: {shape:?}");
    let nodal = BoundWithoutC::new(&Form::LAPLACE, Cone::Nodal, shape, 0.25, 1.0).unwrap();
    let by_hand = (shape.interpolation.powi(2) + 0.5 * PI / PI.tanh()).sqrt();
    assert!((nodal.constant() / by_hand - 1.0).abs() < 1e-12 && (nodal.constant() - 1.35).abs() < 1e-2);
    assert!((nodal.bound(0.5, 3.0, 3.0).unwrap() / (1.5 * by_hand) - 1.0).abs() < 1e-12);
    // μ = 1/2, λ = 0 has the energy of ε alone and σ_N = ∂_n u_n: no factor is left.
    let elastic = Form::elastic(Lame::new(0.0, 0.5).unwrap());
    let elastic = BoundWithoutC::new(&elastic, Cone::Nodal, shape, 0.25, 1.0).unwrap();
    assert!((elastic.constant() / nodal.constant() - 1.0).abs() < 1e-12);
}

/// The best constant of |w|²_{1/2,(0,1)} ≤ C ‖∇w‖² over traces Σ a_k cos kπx, k ≤ 24, least ‖∇w‖² = Σ ½ a_k² kπ tanh
/// kπ: largest eigenvalue by iteration, Gram matrix by a product rule for the smooth difference quotients.
#[test]
fn the_trace_constant_of_the_square_is_nearly_attained() {
    let (modes, rule) = (24, Rule::gauss_legendre(100).unwrap());
    let points: Vec<(f64, f64)> = rule.iter().collect();
    let quotient = |k: usize, x: f64, y: f64| {
        let wave = k as f64 * PI;
        if x == y { -wave * (wave * x).sin() } else { ((wave * x).cos() - (wave * y).cos()) / (x - y) }
    };
    let energy = |k: usize| (0.5 * k as f64 * PI * (k as f64 * PI).tanh()).sqrt();
    let pairs = || points.iter().flat_map(|&p| points.iter().map(move |&q| (p, q)));
    let rows: Vec<Vec<f64>> = pairs()
        .map(|((x, v), (y, w))| (1..=modes).map(|k| (v * w).sqrt() * quotient(k, x, y) / energy(k)).collect())
        .collect();
    let (mut vector, mut value) = (vec![1.0; modes], 0.0);
    for _ in 0..100 {
        let mut next = vec![0.0; modes];
        for row in &rows {
            let product: f64 = row.iter().zip(&vector).map(|(a, b)| a * b).sum();
            next.iter_mut().zip(row).for_each(|(sum, a)| *sum += a * product);
        }
        value = next.iter().map(|v| v * v).sum::<f64>().sqrt();
        vector = next.iter().map(|v| v / value).collect();
    }
    let bound = 2.0 * PI / PI.tanh();
    assert!(value < bound && value > 6.1, "{value} {bound}");
}

#[test]
fn random_quadratics_obey_the_interpolation_constant() {
    // On the triangle (0,0), (1,0), (0,1), u = a x²/2 + b xy + c y²/2: ∇(u − Iu) = (a (x − ½) + b y, b x + c (y − ½)).
    let constant = MeshShape::right_isosceles().interpolation;
    // ∫x = 1/6, ∫x² = 1/12, ∫xy = 1/24: ∫(x−½)² = 1/24, ∫y² = 1/12, ∫(x−½)y = −1/24.
    let square = |a: f64, b: f64| a * a / 24.0 + b * b / 12.0 - a * b / 12.0;
    let mut largest = 0.0f64;
    for i in 0..720 {
        for j in 0..360 {
            let (p, q) = (f64::from(i) * PI / 360.0, f64::from(j) * PI / 360.0);
            let (a, b, c) = (q.sin() * p.cos(), q.cos(), q.sin() * p.sin());
            let seminorm = 0.5 * (a * a + 2.0 * b * b + c * c);
            largest = largest.max(((square(a, b) + square(c, b)) / seminorm).sqrt());
        }
    }
    assert!(largest < constant && largest > 0.9 * constant, "{largest} {constant}");
}

#[test]
fn bad_bounds_are_refused() {
    let shape = MeshShape::right_isosceles();
    let bound = |form: &Form, shape, c| BoundWithoutC::new(form, Cone::Midpoint, shape, c, 1.0);
    assert!(bound(&Form::Scalar { reaction: 1.0 }, shape, 0.25).is_err());
    assert!(bound(&Form::LAPLACE, shape, f64::NAN).is_err());
    assert!(bound(&Form::LAPLACE, MeshShape { height: 0.0, ..shape }, 0.25).is_err());
    let good = bound(&Form::LAPLACE, shape, 0.25).unwrap();
    assert!(good.bound(0.0, 1.0, 1.0).is_err() && good.bound(0.1, 1.0, 2.0).is_err());
    assert!(good.bound(0.1, f64::INFINITY, 1.0).is_err());
    assert!(unit_square_korn(Lame::new(-0.1, 1.0).unwrap()).is_err());
    let scene = ClosedForm { two_transitions: false, lame: None };
    assert!(scene.levels(Cone::Nodal, 1, || ()).is_err());
}
