//! Constants: bounds known by hand.

use crate::hard::{cases, decades, seeded};
use crate::numbers::order;
use fractional_sobolev::{Constraint, Error, Tolerance, gamma};

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
