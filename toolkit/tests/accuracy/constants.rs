//! Constants: bounds known by hand, and powers of the length.

use crate::hard::{cases, decades, seeded};
use crate::numbers::order;
use fractional_sobolev::{
    Constraint, Domain, Error, ErrorNorm, Tolerance, gamma, interpolation_constant, projection_constant,
};

#[test]
fn poincare_constants_between_bounds_known_by_hand() {
    let (mut random, mut answered) = (seeded(5), 0);
    for _ in 0..cases(100) {
        let order = order(&mut random);
        let theta = decades(&mut random, -4.0, 0.0);
        match gamma(order, Constraint::mean_zero_on(0.0..theta), Tolerance::fast()).map(|g| g.constant) {
            Ok(found) => {
                answered += 1;
                let [low, high] = [found.value - found.error, found.value + found.error];
                // u = x − θ/2 from below; |x−y| ≤ 1 and u = w − (mean of w over the zone) from above
                let (c, complement) = (0.5 * theta, 1.0 - order.value());
                let seminorm = 1.0 / (complement * (1.0 + 2.0 * complement));
                let line = ((1.0 / 3.0 - c + c * c) / seminorm).sqrt();
                let crude = (0.5 * (1.0 + 1.0 / theta)).sqrt();
                let case = format!("zone {theta:e}, {order:?}: {found}, {line:e} to {crude:e}");
                assert!(high >= line * (1.0 - 1e-14) && low <= crude, "{case}");
            }
            Err(Error::ToleranceNotMet { .. } | Error::OutOfRange { .. }) => {}
            Err(other) => panic!("zone {theta:e}, {order:?}: {other}"),
        }
    }
    assert!(10 * answered >= 9 * cases(100), "{answered} answered");
}

/// On (0, h) the H¹ constant squared is h^{2ν} sup (‖e′‖² + h² ‖e‖²)/|v|²_ν of the unit element: what the function
/// adds to its derivative is of the order h². The dual constant has the power h^{1/2 + ν}.
#[test]
fn constants_on_an_element_have_their_powers_of_the_length() {
    let squared = |h: f64, norm| {
        let found = interpolation_constant(Domain::Interval(h), norm, 0.3, 1e-10).unwrap();
        (found.constant.value / h.powf(0.3)).powi(2)
    };
    let gain = |h: f64| squared(h, ErrorNorm::H1) - squared(h, ErrorNorm::Derivative);
    let quotient = gain(0.2) / gain(0.1);
    assert!((quotient - 4.0).abs() < 0.05, "{quotient}");
    let on = |h: f64| projection_constant(Domain::Interval(h), ErrorNorm::Dual, 0.3, 1e-8).unwrap().constant;
    let quotient = on(2.0).value / on(1.0).value;
    assert!((quotient / 2f64.powf(0.8) - 1.0).abs() < 1e-12, "{quotient}");
}
