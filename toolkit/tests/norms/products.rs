//! Fast products with Gram matrices against the dense matrices.

use crate::common::SplitMix;
use fractional_sobolev::{Gram, Mesh, Order};

/// Asked of the operators.
const ASKED: f64 = 1e-12;
/// Required of the product, relative to its largest entry and, entry by entry, to |A| |x|.
const PRODUCT_TOLERANCE: f64 = 1e-10;

fn check(what: &str, operator: &Gram, is_uniform: bool) {
    let (matrix, n) = (operator.to_dense().unwrap(), operator.len());
    let mut random = SplitMix::new(2012);
    let x: Vec<f64> = (0..n).map(|_| random.between(-0.5, 0.5)).collect();
    let y = operator.apply(&x).unwrap();
    let (mut largest, mut worst, mut worst_entry) = (0.0f64, 0.0f64, 0.0f64);
    for i in 0..n {
        let (mut exact, mut absolute) = (0.0, 0.0);
        for j in 0..n {
            exact += matrix[(i, j)] * x[j];
            absolute += (matrix[(i, j)] * x[j]).abs();
        }
        largest = largest.max(exact.abs());
        worst = worst.max((y[i] - exact).abs());
        worst_entry = worst_entry.max((y[i] - exact).abs() / absolute);
    }
    println!(
        "{what}: {:.1e} of the largest, {worst_entry:.1e} of |A||x| entry by entry",
        worst / largest
    );
    assert!(worst <= PRODUCT_TOLERANCE * largest, "{what}: {worst:e} against {largest:e}");
    if !is_uniform {
        assert!(worst_entry <= PRODUCT_TOLERANCE, "{what}: {worst_entry:e} of |A||x| in one entry");
    }
}

/// Ratio of a geometric mesh of n elements that reaches `smallest`.
fn geometric(n: usize, smallest: f64) -> Mesh {
    Mesh::geometric(n - 1, smallest.powf(1.0 / (n - 1) as f64), 1.0).unwrap()
}

fn meshes(n: usize) -> Vec<(&'static str, Mesh)> {
    let ratio = 1e-30f64.powf(2.0 / n as f64);
    vec![
        ("uniform", Mesh::uniform(n, 1.0).unwrap()),
        ("geometric to 1e-30", geometric(n, 1e-30)),
        ("two-sided to 1e-30", Mesh::graded(&[0.0, 1.0], n / 2, ratio).unwrap()),
        ("strongly graded", Mesh::graded(&[0.0, 0.3, 1.0], 60, 0.2).unwrap()),
        ("geometric to 1e-250", geometric(n / 4, 1e-250)),
    ]
}

#[test]
fn hats_agree_with_the_dense_matrix() {
    for (name, partition) in meshes(2000) {
        for nu in ["0.1", "1/2", "0.9"] {
            let order: Order = nu.parse().unwrap();
            let operator = Gram::new(&partition, order, ASKED).unwrap();
            check(&format!("P1 {name} nu {nu}"), &operator, name == "uniform");
        }
    }
}

#[test]
fn indicators_agree_with_the_dense_matrix() {
    for (name, partition) in meshes(1000) {
        for nu in ["1e-6", "0.25", "0.499999"] {
            let order: Order = nu.parse().unwrap();
            let operator = Gram::constants(&partition, order, ASKED).unwrap();
            check(&format!("P0 {name} nu {nu}"), &operator, name == "uniform");
        }
    }
}

#[test]
fn wrong_vectors_are_errors() {
    let partition = Mesh::uniform(4, 1.0).unwrap();
    let operator = Gram::new(&partition, 0.5, 1e-8).unwrap();
    assert!(operator.apply(&[0.0; 4]).is_err());
    assert!(operator.apply(&[0.0, f64::NAN, 0.0, 0.0, 0.0]).is_err());
}
