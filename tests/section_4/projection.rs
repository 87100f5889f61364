//! (4.6), (4.7): the L² projection onto piecewise constants, in L² and in the dual norm of H^{1/2}; Remark 4.

use crate::rough_slopes::Numbers;
use fractional_sobolev::{
    Constraint, Domain, Error, ErrorNorm, Estimate, Function, Mesh, Order, Tolerance, gamma,
    projection_constant,
};

/// Required of the measured rates.
const RATE_TOLERANCE: f64 = 0.02;
/// Two codes, each to 1e-8.
const TWO_ROADS: f64 = 2e-8;

/// C(r) on (0, 1).
fn constant(r: f64) -> f64 {
    projection_constant(Domain::Interval(1.0), ErrorNorm::L2, r, Tolerance::balanced())
        .unwrap()
        .constant
        .value
}

/// C*(r) on (0, 1).
fn dual_constant(r: f64) -> f64 {
    projection_constant(Domain::Interval(1.0), ErrorNorm::Dual, r, Tolerance::balanced())
        .unwrap()
        .constant
        .value
}

/// The supremum on equal elements of (0, 1).
fn on_mesh(
    norm: ErrorNorm,
    r: f64,
    elements: usize,
    tolerance: f64,
) -> fractional_sobolev::Result<Estimate> {
    let mesh = Domain::Mesh(Mesh::uniform(elements, 1.0)?);
    projection_constant(mesh, norm, r, tolerance).map(|found| found.constant)
}

#[test]
fn the_best_constant_is_the_poincare_constant_of_the_whole_interval() {
    for r in [0.05, 0.3, 0.5, 0.7, 0.95] {
        let order = Order::new(r).unwrap();
        let whole = gamma(order, Constraint::mean_zero(), Tolerance::balanced()).unwrap().constant;
        let projection = constant(r);
        assert!((projection / whole.value - 1.0).abs() < TWO_ROADS, "{r}: {projection} {whole}");
    }
    // r = 0 and r = 1 carry other norms: φ of mean zero, and cos(πx).
    assert_eq!(constant(0.0), 1.0);
    assert_eq!(constant(1.0), std::f64::consts::FRAC_1_PI);
}

#[test]
fn the_dual_constant_lies_below_the_paper_s_chain_and_meets_it_at_one_half() {
    let half = constant(0.5);
    for r in [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0] {
        let dual = dual_constant(r);
        let chain = constant(r) * half;
        assert!(dual <= chain * (1.0 + 1e-8), "{r}: {dual} above {chain}");
        assert!(dual >= 0.99 * chain, "{r}: {dual} far below {chain}");
        if r == 0.0 || r == 0.5 {
            assert!((dual / chain - 1.0).abs() < 1e-7, "{r}: {dual} {chain}");
        }
    }
}

#[test]
fn one_element_on_a_mesh_is_the_best_constant() {
    for r in [0.2, 0.5, 1.0] {
        let mesh = on_mesh(ErrorNorm::L2, r, 1, 2e-3).unwrap();
        assert!(mesh.value <= constant(r) * (1.0 + 1e-9), "{r}: {mesh}");
        assert!(constant(r) <= mesh.value + mesh.error, "{r}: {mesh}");
    }
}

/// Rough functions linear on cells, minus their means on elements of 1, 2, 3, ... cells: in L² and in the dual norm
/// of H^{1/2}, by the norms of functions and no matrix of the projection.
#[test]
fn both_estimates_hold_for_given_functions() {
    let mut numbers = Numbers(46);
    for r in [0.1, 0.4, 0.6, 0.9] {
        let order = Order::new(r).unwrap();
        for index in 0..12 {
            let (cells, values) =
                if index % 2 == 0 { numbers.rough(order) } else { numbers.waves(order) };
            let phi = Function::linears(&cells, &values).unwrap();
            let lengths = cells.lengths();
            let (mut means, mut h, mut first, mut count) = (Vec::new(), 0.0f64, 0, 1);
            while first < cells.len() {
                let end = (first + count).min(cells.len());
                let length: f64 = lengths[first..end].iter().sum();
                let integral: f64 =
                    (first..end).map(|k| lengths[k] * 0.5 * (values[k] + values[k + 1])).sum();
                means.extend(vec![integral / length; end - first]);
                (h, first, count) = (h.max(length), end, count + 1);
            }
            let projection = Function::piecewise(&cells, 0, &means).unwrap();
            let error = phi.minus(&projection).unwrap();
            let seminorm = phi.seminorm(order, 1e-8).unwrap().value;
            let l2 = error.norm(0.0, 1e-8).unwrap();
            assert!(
                l2.value <= constant(r) * h.powf(r) * seminorm * (1.0 + 1e-7),
                "{r} {index}: {l2}"
            );
            let dual = Estimate::or_best(error.norm(-0.5, 1e-3)).unwrap();
            let bound = dual_constant(r) * h.powf(r + 0.5) * seminorm;
            assert!(dual.value - dual.error <= bound, "{r} {index}: {dual} above {bound}");
        }
    }
}

#[test]
fn inadmissible_orders_are_errors() {
    for r in [-0.1, 1.1, f64::NAN] {
        for norm in [ErrorNorm::L2, ErrorNorm::Dual] {
            let found = projection_constant(Domain::Interval(1.0), norm, r, Tolerance::fast());
            assert!(matches!(found, Err(Error::OutOfRange { .. })), "{norm:?} {r}");
        }
        assert!(on_mesh(ErrorNorm::L2, r, 2, 0.1).is_err());
    }
    for elements in [0, 10_000] {
        assert!(on_mesh(ErrorNorm::L2, 0.5, elements, 0.1).is_err());
    }
    // The norm of the error is one of a projection, a point one at r = 1.
    for norm in [ErrorNorm::H1, ErrorNorm::Derivative, ErrorNorm::At(0.5)] {
        let found = projection_constant(Domain::Interval(1.0), norm, 0.5, Tolerance::fast());
        assert!(matches!(found, Err(Error::Incompatible { .. })), "{norm:?}");
    }
}

/// ‖φ − π^h φ‖₀ of x^a on equal elements, the squares of means taken from that of the function.
#[test]
fn the_projection_saturates_at_h1() {
    let error = |a: f64, n: usize| {
        let h = 1.0 / n as f64;
        let mean = |k: usize| {
            let [x, y] = [k, k + 1].map(|k| (k as f64 * h).powf(a + 1.0));
            (y - x) / ((a + 1.0) * h)
        };
        (1.0 / (2.0 * a + 1.0) - (0..n).map(|k| h * mean(k).powi(2)).sum::<f64>()).sqrt()
    };
    for r in [0.25, 0.5, 0.75, 1.25, 1.5, 2.0, 2.5, 4.0] {
        let a: f64 = r - 0.495;
        let rate = (error(a, 512) / error(a, 2048)).log2() / 2.0;
        assert!((rate - r.min(1.0)).abs() < RATE_TOLERANCE, "r {r}: {rate}");
        if a > 0.5 {
            let limit = a / (2.0 * a - 1.0).sqrt() / 12f64.sqrt() / 2048.0;
            assert!((error(a, 2048) / limit - 1.0).abs() < 1e-2, "r {r}");
        }
    }
}
