//! Dual norms of order ν: exact values, two solvers, and the order between the three norms.

use fractional_sobolev::{DualOf, Function, Load, Mesh, Order, Tolerance};

#[test]
fn dense_and_iterative_solves_agree() {
    let order = Order::new(0.6).unwrap();
    let functional = |partition: &Mesh| -> Vec<f64> {
        partition.nodes().iter().map(|x| (7.0 * x).sin() / partition.len() as f64).collect()
    };
    let small = Mesh::geometric(298, 0.9, 1.0).unwrap();
    let large = Mesh::geometric(300, 0.9, 1.0).unwrap();
    let dual = |mesh: &Mesh, values: &[f64]| {
        Load::new(mesh, values).unwrap().dual_norm(order, 1e-9).unwrap()
    };
    let dense = dual(&small, &functional(&small));
    // Two more elements of length 1e-14 at the end change nothing that can be seen; the solver changes.
    let mut load = functional(&large);
    let scale = large.len() as f64 / small.len() as f64;
    load.iter_mut().for_each(|v| *v *= scale);
    load[0] = 0.0;
    load[1] = 0.0;
    let mut reference = functional(&small);
    reference[0] = 0.0;
    let dense_again = dual(&small, &reference);
    let iterative = dual(&large, &load);
    assert!(dense.work.factorizations == 1 && iterative.work.iterations > 1);
    let error = (iterative.value / dense_again.value - 1.0).abs();
    assert!(error < 1e-4, "{iterative} against {dense_again}: {error:e}");
}

#[test]
fn the_three_norms_are_ordered_and_equivalent() {
    // sign(x − 1/2): mean zero, a jump
    let u = Function::piecewise(&Mesh::uniform(2, 1.0).unwrap(), 0, &[-1.0, 1.0]).unwrap();
    let tolerance = Tolerance::new(1e-5).unwrap();
    let value = |of| u.dual_norm(of, Order::HALF, tolerance).unwrap().value;
    let (slobodeckij, cosines, sines) = (
        value(DualOf::Slobodeckij),
        value(DualOf::Interpolation),
        value(DualOf::InterpolationZero),
    );
    // cosine series of the sign: 8/π² Σ_{odd} k^{-2} (1 + (kπ)²)^{-1/2}
    let exact: f64 = (0..2_000_000)
        .rev()
        .map(|m| {
            let k = 2.0 * f64::from(m) + 1.0;
            8.0 / (std::f64::consts::PI * k).powi(2)
                / (1.0 + (std::f64::consts::PI * k).powi(2)).sqrt()
        })
        .sum::<f64>();
    assert!((cosines / exact.sqrt() - 1.0).abs() < 1e-5, "{cosines} against {}", exact.sqrt());
    assert!(slobodeckij < cosines && cosines < 3.0 * slobodeckij, "{slobodeckij} {cosines}");
    assert!(sines > 0.0 && sines < cosines, "{sines} {cosines}");
}
