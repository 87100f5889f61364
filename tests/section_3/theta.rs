//! Section 3, "Globally": the bounds of both cases over θ against the worst complementary pair of one
//! element.

use example_report::Outcome;
use fractional_sobolev::{Order, Tolerance};
use signorini::cone::Cone;
use signorini::proof::{ProofConstants, consistency_constant, one_gap_ratio};

#[allow(dead_code)]
#[path = "../../examples/theta_balance.rs"]
mod theta_balance;

fn outcome(tau: f64) -> Outcome {
    theta_balance::outcome(&theta_balance::Options { tau, ..theta_balance::Options::default() })
        .unwrap()
}

#[test]
fn the_crossing_is_the_printed_power_times_a_constant() {
    for tau in [1.6, 1.75, 1.9] {
        let (found, constants) = (outcome(tau), ProofConstants::new(tau, 2.0, &[]).unwrap());
        for k in [4, 8, 12] {
            let h = 0.5f64.powi(k);
            let value = |name: &str| {
                let values = found.values();
                let row = values
                    .iter()
                    .filter(|(key, _)| key.starts_with(&format!("{name}.h")))
                    .nth(k as usize - 3);
                row.unwrap().1
            };
            let theta = h.powf(2.0 * tau - 3.0);
            assert!((value("theta") / theta - 1.0).abs() < 1e-12, "tau {tau} h {h}");
            // C(q) h θ^{τ−1} = C_P θ^{τ−2} C_I h^{2τ−2}
            let factor =
                constants.law(theta).printed * theta.powf(2.0 - tau) * constants.interpolation
                    / constants.embedding;
            let crossing = value("crossing");
            assert!(
                (crossing / (factor * theta) - 1.0).abs() < 1e-6,
                "tau {tau} h {h}: {crossing}"
            );
        }
    }
}

#[test]
fn exponents_of_printed_sharpened_and_true() {
    for tau in [1.6, 1.75, 1.9, 1.97, 2.0] {
        let found = outcome(tau);
        assert!(found.status().is_confirmed(), "tau {tau}: {}", found.text(false));
    }
    let found = outcome(1.75);
    let gained = found.check("gain-in-exponent-from-the-sharpened-bound").unwrap().value.value;
    assert!((gained - 1.0 / 16.0).abs() < 1e-9, "{gained}");
}

#[test]
fn the_worst_case_of_the_second_case_does_not_grow_as_theta_shrinks() {
    let order = Order::new(0.25).unwrap();
    let ratio = |gap: f64| one_gap_ratio(Cone::Nodal, order, gap, Tolerance::fast()).unwrap().value;
    let kappa = consistency_constant(order, Tolerance::fast()).unwrap();
    // Every gap of the second case is at least θ: the worst one is the same for θ = 1e-3 and 0.2.
    assert!(1.0 - kappa.contact > 0.2 && ratio(1e-3) < 0.5 * ratio(0.2));
    let constants = ProofConstants::new(1.75, 2.0, &[]).unwrap();
    assert!(constants.law(1e-3).printed > 2.0 * constants.law(0.2).printed, "the bound does grow");
}
