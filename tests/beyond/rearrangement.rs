//! Remark 7 as a theorem: sorted orders, rearranged functions, and the constants of unions of intervals.

#[allow(dead_code)]
#[path = "../../examples/remark_7_zone_location.rs"]
mod example;

use example::near_differences;
use example_report::Decision;
use fractional_sobolev::{Constraint, Order, Result, Tolerance, Zones, gamma};

/// Mean zero on a zone, and zero there.
const CONDITIONS: [fn(Zones) -> Result<Constraint>; 2] =
    [|zones| Constraint::mean_zero_on(zones), |zones| Constraint::vanishing_on(zones)];

/// The largest quotient, over all orders of the numbers and all reaches, of the sorted sum over the given one.
fn sorted_share_of_orders(values: &[f64]) -> f64 {
    fn share(values: &[f64]) -> f64 {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let quotient = |k| near_differences(&sorted, k) / near_differences(values, k);
        (1..values.len()).map(quotient).filter(|share| !share.is_nan()).fold(0.0, f64::max)
    }
    fn from(values: &mut [f64], fixed: usize) -> f64 {
        if fixed + 1 >= values.len() {
            return share(values);
        }
        let mut worst: f64 = 0.0;
        for other in fixed..values.len() {
            values.swap(fixed, other);
            worst = worst.max(from(values, fixed + 1));
            values.swap(fixed, other);
        }
        worst
    }
    from(&mut values.to_vec(), 0)
}

#[test]
fn no_order_has_less_than_the_sorted_one() {
    // whole numbers: sums and comparisons are exact
    let families: [fn(u32) -> f64; 4] =
        [|k| f64::from(k), |k| f64::from(k * k), |k| f64::from(k % 2), |k| f64::from(1u32 << k)];
    for numbers in families {
        for n in 2..=8 {
            let values: Vec<f64> = (0..n).map(numbers).collect();
            assert_eq!(sorted_share_of_orders(&values), 1.0, "{values:?}");
        }
    }
}

/// That check of the example, at this size.
fn holds(functions: usize, unions: usize, key: &str) {
    let outcome =
        example::outcome(&example::Options { functions, unions, ..Default::default() }).unwrap();
    let check = outcome.check(key).unwrap();
    assert_eq!(check.decision(), Decision::Holds, "{}", check.words());
}

#[test]
fn random_functions_of_each_family_lose_seminorm() {
    holds(if crate::MANY { 10_000 } else { 500 }, 1, "random-v-v-nu-v-nu");
}

#[test]
fn random_unions_are_no_worse_than_the_interval_at_the_end() {
    holds(1, if crate::MANY { 1010 } else { 100 }, "unions-gamma-e-gamma-0-theta");
}

#[test]
fn an_interval_has_less_all_the_way_to_the_middle() {
    // Measured, not proved: the theorem says where the constant is largest only.
    let tolerance = Tolerance::new(1e-4).unwrap();
    for nu in [0.05, 0.3, 0.5, 0.7, 0.95] {
        let order = Order::new(nu).unwrap();
        for theta in [1e-6, 1e-2, 0.3, 0.8] {
            for condition in CONDITIONS {
                let at = |share: f64| {
                    gamma(
                        order,
                        condition(
                            Zones::from_start_and_length(share * (1.0 - theta), theta).unwrap(),
                        ),
                        tolerance,
                    )
                    .unwrap()
                    .constant
                };
                let constants = [0.0, 0.02, 0.1, 0.2, 0.3, 0.4, 0.5].map(at);
                for pair in constants.windows(2) {
                    let words = format!("nu {nu}, theta {theta:e}: {} then {}", pair[0], pair[1]);
                    assert!(
                        pair[1].value - pair[1].error <= pair[0].value + pair[0].error,
                        "{words}"
                    );
                }
                assert!(constants[6].value < constants[0].value, "nu {nu}, theta {theta:e}");
            }
        }
    }
}
