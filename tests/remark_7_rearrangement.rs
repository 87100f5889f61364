//! Remark 7 as a theorem: sorted orders, rearranged functions, and the constants of unions of intervals.

#[allow(dead_code)]
#[path = "../examples/remark_7_rearrangement.rs"]
mod example;

use example_frame::{Outcome, Verdict};
use experiments::arrangement::{ZoneCase, random_zones};
use experiments::interpolation::{RoughFamily, rearranged_shares};
use experiments::sorting::{sorted_share_of_orders, sorted_share_of_random};
use experiments::zones::Condition;
use fractional_sobolev::{Constraint, Given, Order, Tolerance, Zones, gamma};

#[test]
fn the_example_confirms_the_theorem_and_planted_faults_turn_it() {
    let options = example::Options { zones: 40, functions: 200, ..example::Options::default() };
    let headline = example::run(&options).unwrap();
    assert!(headline.verdict().is_confirmed(), "{headline}");
    let computed = || example::compute(&options).unwrap();
    let refuted = |spoiled: &example::Computed, key: &str| {
        let findings = example::findings(&options, spoiled);
        let finding = findings.iter().find(|finding| finding.key() == key).unwrap();
        assert_eq!(finding.outcome(), Outcome::Refuted, "{key}");
        assert!(!Verdict::of(&findings).is_confirmed(), "{key}");
    };
    let mut spoiled = computed();
    spoiled.sorted = 1.0 + 1e-12;
    refuted(&spoiled, "orders");
    spoiled.functions[1].1.value = 1.000_1;
    refuted(&spoiled, "functions");
    spoiled.zones.iter_mut().find_map(|(_, ratio)| ratio.as_mut()).unwrap().value = 1.01;
    refuted(&spoiled, "zones");
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
    assert!(sorted_share_of_random(10_000, 3) <= 1.0);
}

/// Pairs of an A (0) and a C (2) at distance at most `reach`.
fn pairs(word: &[u8], reach: usize) -> usize {
    let near =
        |i: usize| word[i + 1..].iter().take(reach).filter(move |&&b| word[i].abs_diff(b) == 2).count();
    (0..word.len()).map(near).sum()
}

#[test]
fn every_word_has_the_pairs_of_the_induction() {
    for length in 1..=9u32 {
        for code in 0..3u32.pow(length) {
            let word: Vec<u8> = (0..length).map(|k| (code / 3u32.pow(k) % 3) as u8).collect();
            let count = |letter: u8| word.iter().filter(|&&l| l == letter).count();
            let [a, m, c] = [0, 1, 2].map(count);
            for reach in 1..length as usize {
                let least: usize = (1..=a).map(|p| (1..=c).filter(|q| p + q + m <= reach + 1).count()).sum();
                assert!(pairs(&word, reach) >= least, "{word:?} at reach {reach}");
            }
        }
    }
}

#[test]
fn ten_thousand_functions_of_each_family_lose_seminorm() {
    for family in [RoughFamily::Linears, RoughFamily::Steps, RoughFamily::Weierstrass] {
        let (largest, mean) = rearranged_shares(family, 10_000, 11).unwrap();
        assert!(largest.value <= 1.0 + largest.error, "{family:?}: {largest}");
        assert!(mean < 0.95, "{family:?}: the functions are monotone already, {mean}");
    }
}

#[test]
fn a_thousand_unions_are_no_worse_than_the_interval_at_the_end() {
    let cases = random_zones(1010, 19, Tolerance::new(1e-2).unwrap()).unwrap();
    let computed = cases.iter().filter_map(|(case, ratio)| Some((case, (*ratio)?)));
    assert!(computed.clone().count() >= 1000);
    for (case, ratio) in computed {
        let ZoneCase { order, zones, condition } = case;
        assert!(ratio.value <= 1.0 + ratio.error, "nu {order}, {condition}, {zones}: {ratio}");
    }
}

#[test]
fn dual_norms_and_points_have_their_worst_place_at_the_end() {
    let tolerance = Tolerance::new(1e-6).unwrap();
    for nu in [0.2, 0.5, 0.7, 0.9] {
        let order = Order::new(nu).unwrap();
        let zones = Zones::union(&[0.1..0.12, 0.5..0.55]).unwrap();
        for condition in [Condition::MeanZero, Condition::Vanishing] {
            let norm =
                |zone| gamma(order, condition.on(zone), tolerance).unwrap().bounds().unwrap().dual_norm.value;
            let end = norm((0.0..zones.length()).given().unwrap());
            assert!(norm(zones.clone()) < end, "nu {nu}, {condition}");
        }
        if nu > 0.5 {
            let points = [0.0, 0.05, 0.2, 0.5]
                .map(|a| gamma(order, Constraint::vanishing_at(a), tolerance).unwrap().constant.value);
            assert!(points[1..].iter().all(|point| point < &points[0]), "nu {nu}: {points:?}");
        }
    }
}

#[test]
fn an_interval_has_less_all_the_way_to_the_middle() {
    // Measured, not proved: the theorem says where the constant is largest only.
    let tolerance = Tolerance::new(1e-4).unwrap();
    for nu in [0.05, 0.3, 0.5, 0.7, 0.95] {
        let order = Order::new(nu).unwrap();
        for theta in [1e-6, 1e-2, 0.3, 0.8] {
            for condition in [Condition::MeanZero, Condition::Vanishing] {
                let at = |share: f64| {
                    gamma(
                        order,
                        condition.on(Zones::from_start_and_length(share * (1.0 - theta), theta)),
                        tolerance,
                    )
                    .unwrap()
                    .constant
                };
                let constants = [0.0, 0.02, 0.1, 0.2, 0.3, 0.4, 0.5].map(at);
                for pair in constants.windows(2) {
                    let words =
                        format!("nu {nu}, theta {theta:e}, {condition}: {} then {}", pair[0], pair[1]);
                    assert!(pair[1].value - pair[1].error <= pair[0].value + pair[0].error, "{words}");
                }
                assert!(constants[6].value < constants[0].value, "nu {nu}, theta {theta:e}, {condition}");
            }
        }
    }
}
