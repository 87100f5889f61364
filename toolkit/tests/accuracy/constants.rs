//! Constants: bounds known by hand.

use crate::hard::{cases, costly_cases, decades, seeded};
use crate::numbers::order;
use fractional_sobolev::{Constraint, Error, Estimate, Order, Tolerance, Zones, gamma, law};

#[test]
fn poincare_constants_between_bounds_known_by_hand() {
    let (mut random, mut answered) = (seeded(5), 0);
    for _ in 0..cases(100) {
        let order = order(&mut random);
        let theta = decades(&mut random, -4.0, 0.0);
        match gamma(order, Constraint::mean_zero_on(0.0..theta), Tolerance::fast())
            .map(|g| g.constant)
        {
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

/// γ of the zone that starts at `start`.
fn constant(order: Order, start: f64, theta: f64) -> Estimate {
    let zone = Zones::from_start_and_length(start, theta).unwrap();
    let found = gamma(order, Constraint::mean_zero_on(zone), 1e-8).map(|found| found.constant);
    Estimate::or_best(found).unwrap()
}

#[test]
fn a_law_states_its_remainder() {
    let half_less = Order::half_plus(-1e-6).unwrap();
    let near = Order::new(0.49).unwrap();
    let cases =
        [(half_less, 0.01), (half_less, 0.2), (half_less, 0.5), (near, 0.1), (near, 1e-300)];
    for (order, theta) in cases {
        let (by_law, found) =
            (law(order, 0.0, 1e-8).unwrap().at(theta).unwrap(), constant(order, 0.0, theta));
        let apart = (by_law.value - found.value).abs();
        assert!(apart <= by_law.error + found.error, "{order:?} {theta}: {by_law:?}, {found:?}");
        assert!(by_law.error < 0.2 * found.value, "{order:?} {theta}: {by_law:?}, {found:?}");
    }
}

/// In the interior the slope of γ² is that of 1/(2π²) ln(1/θ), through ν = 1/2; at the right end the zone is that of the
/// left end, where 1 − θ is rounded.
#[test]
fn laws_inside_pass_through_one_half_and_those_of_both_ends_agree() {
    let theta = 1e-100;
    let at = |order: Order, place: f64| law(order, place, 1e-6).unwrap().at(theta).unwrap();
    let slope = (-f64::ln(theta)).sqrt() / (2f64.sqrt() * std::f64::consts::PI);
    for offset in [-1e-9, 0.0, 1e-9] {
        let found = at(Order::half_plus(offset).unwrap(), 0.5);
        assert!((found.value / slope - 1.0).abs() < 1e-6, "{offset}: {found:?}");
        assert!(found.relative_error() < 0.1, "{offset}: {found:?}");
        let [left, right] = [0.0, 1.0].map(|end| at(Order::half_plus(offset).unwrap(), end));
        assert_eq!(left, right, "{offset}");
    }
}

#[test]
fn a_law_that_has_no_value_says_where_it_has_one() {
    for offset in [-1e-2, -5e-3, -1e-3, -1e-6, 0.0, 1e-9, 1e-6, 1e-3, 3e-3, 5e-3, 7e-3, 1e-2] {
        let at_end = law(Order::half_plus(offset).unwrap(), 0.0, 1e-6).unwrap();
        assert!(at_end.at(0.8).is_ok(), "{offset}");
        for theta in [0.9, 0.95, 0.99] {
            match at_end.at(theta) {
                Ok(_) => {}
                Err(Error::OutOfRange { range, .. }) => assert!(range.starts_with("(0, 0.8]")),
                Err(other) => panic!("{offset} {theta}: {other}"),
            }
        }
    }
    assert!(law(0.5, 1.0, 1e-6).unwrap().at(0.95).is_err());
}

#[test]
fn random_laws_enclose_the_constant_at_every_order_length_and_place() {
    let (mut random, mut answered) = (seeded(6), 0);
    for _ in 0..costly_cases(2000) {
        let order = match random.below(3) {
            0 => Order::half_plus(decades(&mut random, -9.0, -1.0)),
            1 => Order::half_plus(-decades(&mut random, -9.0, -0.4)),
            _ => Order::new(random.between(0.01, 0.99)),
        };
        let order = order.unwrap();
        let theta = if random.below(3) == 0 {
            decades(&mut random, -290.0, -2.0)
        } else {
            random.between(0.0, 0.99)
        };
        let place = match random.below(4) {
            0 => 0.0,
            1 => 1.0,
            2 => decades(&mut random, -6.0, 0.0),
            _ => random.uniform(),
        };
        let by_law = match law(order, place, 1e-6).and_then(|law| law.at(theta)) {
            Ok(by_law) => by_law,
            Err(Error::ToleranceNotMet { .. } | Error::OutOfRange { .. }) => continue,
            Err(other) => panic!("{order:?} {place} {theta}: {other}"),
        };
        answered += 1;
        // any zone whose closure contains the place
        let (low, high) = ((place - theta).max(0.0), f64::min(place, 1.0 - theta));
        let start = (low + (high - low).max(0.0) * random.uniform()).min(1.0 - theta);
        // at the right end by reflection: 1 − θ is rounded
        let start = if place == 1.0 { 0.0 } else { start };
        let found = constant(order, start, theta);
        let apart = (by_law.value - found.value).abs();
        assert!(
            apart <= by_law.error + found.error,
            "{order:?} {place} {theta} {start}: {by_law:?} {found:?}"
        );
    }
    // Refused: zones of more than 0.83 at an end, where the expansion near 1/2 is not positive.
    println!("{answered} answered of {}", costly_cases(2000));
    assert!(20 * answered >= 19 * costly_cases(2000), "{answered} answered");
}
