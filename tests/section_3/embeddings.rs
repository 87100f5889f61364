//! (3.6), (3.10), (4.12), (E3): embeddings of H^{ν} in L^q and of H^{3/2} in C^{0,α}.

use crate::rough_slopes::Numbers;
use fractional_sobolev::{
    BestConstant, Error, Function, Order, Result, Target, Tolerance, embedding_bound,
    embedding_constant,
};

/// C(q)/√q for q = 2 ... 200 at ν = 1/2.
const GROWTH: [f64; 2] = [0.167, 0.708];

/// C(q) from below.
fn lower(nu: f64, q: f64) -> f64 {
    embedding_constant(nu, q, 1e-8).unwrap().lower.value
}

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

#[test]
fn no_rough_function_exceeds_the_upper_bound() {
    let mut numbers = Numbers(63);
    for nu in [0.1, 0.3, 0.45, 0.5] {
        let nu = order(nu);
        for index in 0..90 {
            let (mesh, values) = if index % 3 == 0 { numbers.waves(nu) } else { numbers.rough(nu) };
            let u = match index % 3 {
                2 if nu.offset() < 0.0 => Function::piecewise(&mesh, 0, &values[1..]).unwrap(),
                _ => Function::linears(&mesh, &values).unwrap(),
            };
            let norm = u.norm(nu, Tolerance::balanced()).unwrap().value;
            for q in [2.0, 3.0, 20.0, 200.0_f64] {
                let q = q.min(-1.0 / (nu.offset() - f64::MIN_POSITIVE));
                let quotient = u.lp(q, Tolerance::balanced()).unwrap().value / norm;
                let bound = upper(embedding_bound(nu, q)).unwrap();
                assert!(quotient <= bound, "{index} nu {nu} q {q}: {quotient} above {bound}");
            }
        }
    }
}

/// The upper bound alone.
fn upper(found: Result<BestConstant>) -> Result<f64> {
    found.map(|found| found.upper.unwrap().value)
}

#[test]
fn constants_are_one_where_the_upper_bound_says_so() {
    for (nu, q) in [(0.5, 2.0), (0.5, 8.0), (0.3, 5.0), (0.1, 2.5), (1e-6, 2.0)] {
        assert_eq!(upper(embedding_bound(nu, q)).unwrap(), 1.0, "{nu} {q}");
    }
    // the constant function loses its place when 2 + 1/γ₁² = 13.76 is passed, here by a global competitor
    assert!((lower(0.5, 12.0) - 1.0).abs() < 1e-10);
    assert!(lower(0.5, 16.0) > 1.005);
    // known there, and only there
    assert_eq!(embedding_constant(0.5, 8.0, 1e-8).unwrap().constant.value, 1.0);
    assert!(embedding_constant(0.5, 16.0, 1e-8).unwrap().constant.relative_error() > 0.1);
}

#[test]
fn growth_is_that_of_a_square_root_between_two_constants() {
    let mut last = f64::INFINITY;
    for q in [2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0_f64] {
        let (lower, upper) =
            (lower(0.5, q) / q.sqrt(), upper(embedding_bound(0.5, q)).unwrap() / q.sqrt());
        assert!(GROWTH[0] <= lower && lower <= upper && upper <= GROWTH[1], "{q}: {lower} {upper}");
        // towards (3/(4π²e))^{1/2} = 0.16721 from above
        assert!(lower < last, "{q}: {lower} after {last}");
        last = lower;
    }
    assert!((last / 0.16721 - 1.0).abs() < 0.04, "{last}");
}

#[test]
fn hoelder_constants_grow_like_the_root_of_one_over_one_minus_alpha() {
    for q in [2.0, 10.0, 50.0, 200.0_f64] {
        let found = embedding_constant(1.5, Target::Hoelder(1.0 - 1.0 / q), 1e-8).unwrap();
        let (lower, upper) = (found.lower.value, found.upper.unwrap().value);
        assert!(lower <= upper && lower / q.sqrt() > 0.167, "{q}: {lower} {upper}");
    }
    for alpha in [0.0, 1.0, -0.5, f64::NAN] {
        assert!(embedding_constant(1.5, Target::Hoelder(alpha), 1e-8).is_err());
    }
    let other = embedding_constant(1.4, Target::Hoelder(0.5), 1e-8);
    assert!(matches!(other, Err(Error::Incompatible { .. })), "{other:?}");
}

#[test]
fn exponents_outside_the_embedding_are_errors() {
    for (nu, q) in
        [(0.6, 3.0), (0.3, 5.1), (0.5, 1.0), (0.5, f64::NAN), (0.5, f64::INFINITY), (0.5, 1e7)]
    {
        assert!(upper(embedding_bound(nu, q)).is_err(), "{nu} {q}");
    }
    let near = Order::half_plus(-1e-9).unwrap();
    let at_half = upper(embedding_bound(0.5, 100.0)).unwrap();
    assert!((upper(embedding_bound(near, 100.0)).unwrap() / at_half - 1.0).abs() < 1e-6);
    assert!(embedding_constant(0.7, 3.0, 1e-8).is_err());
}
