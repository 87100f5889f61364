//! Section 1 in the plane: fast products on uniform grids against sums over all pairs of triangles.

use crate::common::SplitMix;
use fractional_sobolev::{Error, Function, Gram, Order, Tolerance, Triangles, closed_forms};

/// Asked of entries, and what a form may be off by.
const ASKED: f64 = 1e-11;
const REACHED: f64 = 1e-10;

#[test]
fn a_product_is_the_derivative_of_the_seminorm() {
    let mut random = SplitMix::new(5);
    let asked = Tolerance::new(ASKED).unwrap();
    for (squares, s) in [([1, 1], 0.3), ([3, 2], 0.5), ([7, 6], 0.8), ([11, 1], 0.95)] {
        let order = Order::new(s).unwrap();
        let operator = Gram::on_grid(squares, 0.5, order, asked).unwrap();
        let mut values = || -> Vec<f64> { (0..operator.len()).map(|_| random.between(-1.0, 1.0)).collect() };
        let (v, w) = (values(), values());
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let form = |a: &[f64], b: &[f64]| dot(&operator.apply(a).unwrap(), b);
        let exact = |values: &[f64]| {
            let w = Function::on_triangles(&Triangles::grid(squares, 0.5).unwrap(), 1, values).unwrap();
            w.seminorm(order, asked).unwrap().value.powi(2)
        };
        let (vv, ww) = (exact(&v), exact(&w));
        assert!((form(&w, &w) / ww - 1.0).abs() < REACHED, "{squares:?} {s}");
        // Polarisation, symmetry, and constants in the kernel.
        let sum: Vec<f64> = v.iter().zip(&w).map(|(v, w)| v + w).collect();
        let mixed = 0.5 * (exact(&sum) - vv - ww);
        assert!((form(&v, &w) - mixed).abs() < REACHED * (vv + ww), "{squares:?} {s}");
        assert!((form(&v, &w) - form(&w, &v)).abs() < 1e-13 * (vv + ww));
        let ones = operator.apply(&vec![1.0; operator.len()]).unwrap();
        let diagonal = operator.apply(&w).unwrap().iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(ones.iter().all(|x| x.abs() < 1e-12 * diagonal), "{squares:?} {s}: {ones:?}");
    }
}

#[test]
fn many_squares_give_the_closed_form() {
    let order = Order::HALF;
    let n = 60;
    let operator = Gram::on_grid([n, n], 1.0 / n as f64, order, Tolerance::new(1e-10).unwrap()).unwrap();
    let x: Vec<f64> = (0..operator.len()).map(|k| (k % (n + 1)) as f64 / n as f64).collect();
    let form: f64 = operator.apply(&x).unwrap().iter().zip(&x).map(|(a, b)| a * b).sum();
    let exact = closed_forms::coordinate_on_square_seminorm_squared(order).unwrap().value;
    assert!((form / exact - 1.0).abs() < 1e-9, "{form} {exact}");
}

#[test]
fn bad_input_is_an_error() {
    let fast = Tolerance::fast();
    assert!(matches!(Gram::on_grid([0, 3], 1.0, Order::HALF, fast), Err(Error::CountOutOfRange { .. })));
    assert!(Gram::on_grid([2, 3], 0.0, Order::HALF, fast).is_err());
    let operator = Gram::on_grid([2, 3], 1.0, Order::HALF, fast).unwrap();
    assert!(matches!(operator.apply(&[1.0]), Err(Error::LengthMismatch { .. })));
    assert!(matches!(operator.apply(&[f64::NAN; 12]), Err(Error::NotFinite { .. })));
}
