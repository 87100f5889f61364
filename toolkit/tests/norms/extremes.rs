//! The hardest admissible input gives digits; the inadmissible gives an error. Never a panic, never NaN.

use fractional_sobolev::{Error, Function, Gram, Mesh, Order, Tolerance, closed_forms};

/// Rounding of sums of one sign over at most 1e6 terms.
const DIGITS: f64 = 1e-11;

fn assert_digits(what: &str, value: f64, exact: f64) {
    let error = (value / exact - 1.0).abs();
    assert!(error <= DIGITS, "{what}: {value:e} against {exact:e}, error {error:e}");
}

/// |x|²_ν on (0, 1).
fn identity_squared(order: Order) -> f64 {
    1.0 / ((1.0 - order.value()) * (1.0 + 2.0 * (1.0 - order.value())))
}

#[test]
fn orders_at_the_ends_of_the_interval() {
    for nu in [1e-6, 1.0 - 1e-6, 1e-300, 1.0 - f64::EPSILON] {
        let order = Order::new(nu).unwrap();
        let exact = identity_squared(order);
        assert_digits("closed form", closed_forms::power_seminorm_squared(1.0, order).unwrap().value, exact);
        let u =
            Function::linears(&Mesh::uniform(3, 1.0).unwrap(), &[0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0]).unwrap();
        let value = u.seminorm(order, Tolerance::reference()).unwrap().value;
        assert_digits("piecewise", value, exact.sqrt());
    }
    for nu in [1e-6, 1.0 - 1e-6] {
        let order = Order::new(nu).unwrap();
        let u = Function::from_fn(&[0.0, 1.0], |x: f64| x).unwrap();
        let value = u.seminorm(order, Tolerance::new(1e-9).unwrap()).unwrap().value;
        assert!((value / identity_squared(order).sqrt() - 1.0).abs() < 1e-9, "closure {nu}: {value}");
    }
}

#[test]
fn intervals_of_any_length() {
    for length in [1e-300, 1e-150, 1e150, 1e300] {
        for nu in [1e-6, 0.3, 0.5, 0.9, 1.0 - 1e-6] {
            let order = Order::new(nu).unwrap();
            let partition = Mesh::uniform(4, length).unwrap();
            let u = Function::linears(&partition, &[0.0, 0.25, 0.5, 0.75, 1.0]).unwrap();
            let value = u.seminorm(order, Tolerance::reference()).unwrap().value;
            // The square scales with L^{1−2ν}; the power is taken of the root, where 1 − 2ν is halved.
            let exact = identity_squared(order).sqrt() * length.powf(-order.offset());
            assert_digits(&format!("length {length:e}, nu {nu}"), value, exact);
        }
    }
}

#[test]
fn tiny_elements_beside_long_ones() {
    // The hat of height 1 over two elements of length 1e-300 in the middle of (0, 2).
    let order = Order::HALF;
    let lengths = vec![1.0, 1e-300, 1e-300, 1.0];
    let u = Function::linears(&Mesh::from_lengths(lengths).unwrap(), &[0.0, 0.0, 1.0, 0.0, 0.0]).unwrap();
    let tiny = u.seminorm(order, Tolerance::reference()).unwrap().value;
    // At ν = 1/2 the seminorm does not see scale: the same hat over 1e-20, whose surroundings are as good as
    // infinite.
    let lengths = vec![1.0, 1e-20, 1e-20, 1.0];
    let v = Function::linears(&Mesh::from_lengths(lengths).unwrap(), &[0.0, 0.0, 1.0, 0.0, 0.0]).unwrap();
    assert_digits("tiny hat", tiny, v.seminorm(order, Tolerance::reference()).unwrap().value);
    assert!(matches!(Mesh::from_lengths(vec![1e-300, 1e300]), Err(Error::OutOfRange { .. })));
}

#[test]
fn values_of_any_size() {
    let order = Order::new(0.7).unwrap();
    for size in [1e-150, 1e150] {
        let u = Function::linears(&Mesh::uniform(2, 1.0).unwrap(), &[0.0, 0.5 * size, size]).unwrap();
        let value = u.seminorm(order, Tolerance::reference()).unwrap().value;
        assert_digits("values", value, size * identity_squared(order).sqrt());
        let dual = u.norm(-order, Tolerance::fast()).unwrap().value;
        assert!(dual > 0.1 * size && dual < size, "{dual}");
        let u = Function::from_fn(&[0.0, 1.0], |x: f64| size * x).unwrap();
        let value = u.seminorm(order, Tolerance::balanced()).unwrap().value;
        assert!((value / (size * identity_squared(order).sqrt()) - 1.0).abs() < 1e-8, "{value}");
    }
}

#[test]
fn one_element_and_a_million() {
    let order = Order::new(0.25).unwrap();
    let one = Gram::new(&Mesh::uniform(1, 1.0).unwrap(), order, 1e-8).unwrap().to_dense().unwrap();
    assert_digits("one element", one[(0, 0)], identity_squared(order));
    let n = 1_000_000;
    let partition = Mesh::uniform(n, 1.0).unwrap();
    let operator = Gram::constants(&partition, order, Tolerance::reference()).unwrap();
    let step: Vec<f64> = (0..n).map(|i| if i < n / 2 { 0.0 } else { 1.0 }).collect();
    let image = operator.apply(&step).unwrap();
    let form: f64 = step.iter().zip(&image).map(|(x, y)| x * y).sum();
    let exact = closed_forms::jump_seminorm_squared(0.5, 0.5, order).unwrap().value;
    assert!((form / exact - 1.0).abs() < 1e-9, "{form} against {exact}");
    let zero = operator.apply(&vec![3.0; n]).unwrap();
    let diagonal = operator.diagonal().unwrap();
    assert!(zero.iter().all(|y| y.abs() < 1e-13 * diagonal[0]));
}

#[test]
fn nan_infinite_and_repeated_input_are_errors() {
    assert!(Order::new(f64::NAN).is_err() && Order::new(f64::INFINITY).is_err());
    for nodes in [&[0.0, 0.5, 0.5, 1.0][..], &[0.0, f64::NAN], &[f64::NEG_INFINITY, 0.0], &[1.0, 0.0]] {
        assert!(Mesh::from_nodes(nodes).is_err(), "{nodes:?}");
    }
    let partition = || Mesh::uniform(1, 1.0).unwrap();
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(Function::linears(&partition(), &[0.0, bad]).is_err());
        let u = Function::from_fn(&[0.0, 1.0], move |x: f64| if x > 0.5 { bad } else { x }).unwrap();
        assert!(matches!(u.seminorm(Order::HALF, Tolerance::fast()), Err(Error::NotFinite { .. })));
        assert!(Function::from_fn(&[0.0, bad], |x: f64| x).is_err());
    }
    assert!(Function::from_fn(&[0.0, 0.0, 1.0], |x: f64| x).is_err());
}

#[test]
fn infinite_norms_of_closures_are_recognised() {
    let jump = Function::from_fn(&[0.0, 0.5, 1.0], |x: f64| if x < 0.5 { 0.0 } else { 1.0 }).unwrap();
    let power = Function::from_fn(&[0.0, 1.0], |x: f64| x.powf(-0.3)).unwrap();
    let logarithm = Function::from_positions(&[0.0, 1.0], |at| match at.anchor() {
        0 => (-at.offset().ln()).powf(0.6),
        _ => (-at.offset().ln_1p()).powf(0.6),
    })
    .unwrap();
    for (u, nu) in [(&jump, 0.5), (&jump, 0.8), (&power, 0.3), (&power, 0.95), (&logarithm, 0.5)] {
        let outcome = u.seminorm(Order::new(nu).unwrap(), Tolerance::fast());
        assert!(matches!(outcome, Err(Error::InfiniteNorm { .. })), "nu {nu}: {outcome:?}");
    }
}

#[test]
fn closures_of_any_size_scale_out() {
    let tolerance = Tolerance::balanced();
    for order in [0.25, 0.5, 0.9].map(|nu| Order::new(nu).unwrap()) {
        let seminorm = closed_forms::power_seminorm_squared(1.0, order).unwrap().value.sqrt();
        let norm = (1.0 / 3.0_f64).sqrt().hypot(seminorm);
        for size in [1e-300, 1e-160, 1e-150, 1e150, 1e160, 1e300] {
            let u = Function::from_fn(&[0.0, 1.0], |x: f64| size * x).unwrap();
            for (what, found, exact) in [
                ("seminorm", u.seminorm(order, tolerance), seminorm),
                ("norm", u.norm(order, tolerance), norm),
                ("mean", u.mean(tolerance), 0.5),
                ("L^7 norm", u.lp(7.0, tolerance), 8.0_f64.powf(-1.0 / 7.0)),
                ("L^200 norm", u.lp(200.0, tolerance), 201.0_f64.powf(-1.0 / 200.0)),
            ] {
                let found = found.unwrap();
                let error = (found.value / size / exact - 1.0).abs();
                assert!(error <= tolerance.relative(), "{what} of {size:e} x at {order}: {found}");
            }
        }
    }
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| 1e-2 * x).unwrap();
    let found = u.lp(200.0, tolerance).unwrap().value;
    assert!((found / 9.738_319_515_772_5e-3 - 1.0).abs() <= tolerance.relative(), "{found}");
}

#[test]
fn a_jump_that_is_not_declared_is_not_overlooked() {
    for at in [0.3, 0.37, 0.62] {
        let u = Function::from_fn(&[0.0, 1.0], |x: f64| if x < at { 0.0 } else { 1.0 }).unwrap();
        let found = u.seminorm(Order::new(0.25).unwrap(), Tolerance::new(1e-6).unwrap());
        assert!(matches!(found, Err(Error::ToleranceNotMet { .. })), "jump at {at}: {found:?}");
    }
}
