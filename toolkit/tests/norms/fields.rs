//! Fields on many elements: norms by moments against all pairs and closed forms, at every tolerance.

use fractional_sobolev::{Estimate, Function, Mesh, Order, Tolerance, closed_forms};

const TOLERANCES: [f64; 3] = [1e-4, 1e-8, 1e-12];

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

/// Lengths over three decades without a pattern.
fn uneven(count: usize) -> Mesh {
    let length = |k: usize| 10f64.powf(-3.0 * ((k * k) as f64 * 0.618).fract());
    Mesh::from_lengths(&(0..count).map(length).collect::<Vec<_>>()).unwrap()
}

#[test]
fn moments_agree_with_all_pairs_for_every_degree() {
    let wave = |x: f64| (0.3 * x).sin() + 0.1 * (5.0 * x).cos();
    for mesh in [uneven(200), Mesh::algebraic(200, 3.0, 1.0).unwrap()] {
        for degree in [1, 2, 5] {
            let u = Function::interpolate(&mesh, degree, wave).unwrap();
            for nu in [0.05, 0.5, 0.95] {
                // Below 1e-13 nothing but all pairs is accurate enough.
                let exact = u.seminorm(order(nu), Tolerance::new(1e-14).unwrap()).unwrap();
                for tolerance in TOLERANCES {
                    let found = u.seminorm(order(nu), Tolerance::new(tolerance).unwrap()).unwrap();
                    let off = (found.value - exact.value).abs();
                    assert!(
                        off <= found.error + exact.error,
                        "{degree} {nu} {tolerance}: {found} {exact}"
                    );
                    assert!(found.relative_error() <= tolerance);
                }
            }
        }
    }
}

#[test]
fn a_hundred_thousand_nodes_reach_the_last_tolerance() {
    for nu in [0.2, 0.5, 0.9] {
        let mesh = Mesh::algebraic(100_000, 2.0, 1.0).unwrap();
        let values: Vec<f64> = mesh.from_left().iter().map(|x| 1.0 + x).collect();
        let u = Function::linears(&mesh, &values).unwrap();
        // At ν = 0.9 the rounding of the values of neighbours is 2e-12, and the refusal carries the value.
        let found = Estimate::or_best(u.seminorm(order(nu), Tolerance::reference())).unwrap();
        let exact = closed_forms::power_seminorm_squared(1.0, order(nu)).unwrap().sqrt().unwrap();
        let off = (found.value - exact.value).abs();
        assert!(off <= found.error + exact.error, "{nu}: {found} {exact}");
        assert!(found.relative_error() <= if nu < 0.6 { 1e-12 } else { 4e-12 }, "{nu}: {found}");
        // All pairs would take 10^11 kernel values.
        assert!(found.work.total() < 2_000_000_000, "{nu}: {:?}", found.work);
    }
}
